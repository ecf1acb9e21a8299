// The energy does not increase without a cause; collisions keep the total momentum.

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "report/table.h"
#include "wild/checks/check.h"
#include "wild/checks/facts.h"
#include "wild/checks/gaps.h"

namespace fettle::bench::wild {
namespace {

bool moves_freely(const BodyNow& body) {
    return body.exists && body.type == BodyType::dynamic_body && std::isfinite(body.mass);
}

/// A body without shapes has no moment of inertia, so nothing stops its rotation: like a motor, it
/// may give any energy to what it is joined to.
bool turns_for_ever(const BodyNow& body) {
    const bool has_inertia = std::isfinite(body.inertia) && body.inertia > 0;
    return moves_freely(body) && !has_inertia && body.angular_velocity != 0;
}

double kinetic(const BodyNow& body) {
    const double spin = std::isfinite(body.inertia)
                            ? double(body.inertia) * body.angular_velocity * body.angular_velocity
                            : 0;
    return 0.5 * (double(body.mass) * body.velocity.length_squared() + spin);
}

/// The energy, kinetic and of height, is never larger than at the last edit, but for
/// - 5 % of the largest kinetic energy: bounces are exact to 1 %, and a body may bounce several
///   times before it loses energy;
/// - 2 cm of height for each body: contacts may sink in by that and spring back;
/// - the energy of joints that are apart at the edit, which act as springs (`Moment::joint_hertz`);
/// - what pushes overlapping bodies apart: 3 m/s between two bodies, which the library allows for
///   it. A body that was deeper than 1 cm in others is pushed by each of them, and pushes what lies
///   on it or is joined to it. In a row of such bodies that begins at something fixed, these speeds
///   add up from one body to the next.
class Energy : public Check {
  public:
    std::optional<std::string> violation(const Moment& moment) override {
        if (moment.step == 0) driven_ = is_driven(moment.plan) || bounces_singly(moment.plan);
        driven_ = driven_ || std::ranges::any_of(moment.before, turns_for_ever);
        if (driven_) return {};
        if (moment.edited || moment.step == 0) begin(moment);
        const double now = energy(moment.after, moment.plan.def.gravity);
        const float gravity = moment.plan.def.gravity.length();
        double moving = 0, allowed = 0;
        overlapped_.resize(moment.after.size(), false);
        pushes_.resize(moment.after.size(), 1);
        // A push moves what is joined to its body in the same step.
        for (std::size_t i = 0; i < moment.after.size(); ++i)
            if (std::max(moment.after[i].deepest, moment.before[i].deepest) > 0.01f)
                overlapped_[i] = true;
        for (const JointPlan& joint : moment.plan.joints)
            for (const auto& [from, to] : {std::pair(joint.a, joint.b), {joint.b, joint.a}})
                if (from != the_world && to != the_world && overlapped_[std::size_t(from)])
                    overlapped_[std::size_t(to)] = true;
        const std::vector<std::size_t> places = places_in_rows(moment.after);
        for (std::size_t i = 0; i < moment.after.size(); ++i) {
            const BodyNow& body = moment.after[i];
            if (!moves_freely(body)) continue;
            moving += kinetic(body);
            allowed += body.mass * gravity * std::abs(body.gravity_scale) * 0.02;
            for (const int other : body.touched)
                if (other != the_world && overlapped_[std::size_t(other)]) overlapped_[i] = true;
            pushes_[i] = std::max({pushes_[i], body.touched.size(), places[i]});
            if (overlapped_[i]) allowed += 0.5 * body.mass * std::pow(3.0 * double(pushes_[i]), 2);
        }
        most_moving_ = std::max(most_moving_, moving);
        allowed += 0.05 * most_moving_ + stored_ + 1e-6;
        if (now - first_ <= allowed) return {};
        return "energy grows by " + figure(now - first_) + " J, of which " + figure(allowed) +
               " J are explained; the kinetic energy is " + figure(moving) + " J";
    }

  private:
    void begin(const Moment& moment) {
        first_ = energy(moment.before, moment.plan.def.gravity);
        most_moving_ = 0;
        stored_ = stored(moment);
        for (const BodyNow& body : moment.before)
            if (moves_freely(body)) most_moving_ += kinetic(body);
        overlapped_.assign(moment.after.size(), false);
        pushes_.assign(moment.after.size(), 1);
    }

    /// For each body the number of overlapping bodies, itself included, in the shortest row from it
    /// to something fixed; 0 without such a row.
    std::vector<std::size_t> places_in_rows(const std::vector<BodyNow>& bodies) const {
        std::vector<std::size_t> places(bodies.size(), 0), row;
        const auto begins_row = [&](int other) {
            return other == the_world || !moves_freely(bodies[std::size_t(other)]);
        };
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            if (!overlapped_[i] || !moves_freely(bodies[i])) continue;
            if (!std::ranges::any_of(bodies[i].touched, begins_row)) continue;
            places[i] = 1;
            row.push_back(i);
        }
        for (std::size_t k = 0; k < row.size(); ++k)
            for (const int other : bodies[row[k]].touched) {
                if (begins_row(other) || places[std::size_t(other)] != 0) continue;
                places[std::size_t(other)] = places[row[k]] + 1;
                if (overlapped_[std::size_t(other)]) row.push_back(std::size_t(other));
            }
        return places;
    }

    static double stored(const Moment& moment) {
        const auto mass_of = [&](int body) {
            return body != the_world && moves_freely(moment.before[std::size_t(body)])
                       ? double(moment.before[std::size_t(body)].mass)
                       : std::numeric_limits<double>::infinity();
        };
        const auto inertia_of = [&](int body) {
            return std::isinf(mass_of(body)) ? std::numeric_limits<double>::infinity()
                                             : double(moment.before[std::size_t(body)].inertia);
        };
        constexpr double widest = 0.3;  // rad; the rest of an angle is closed without a velocity
        const double hertz = moment.joint_hertz();
        double sum = 0;
        for (const JointPlan& joint : moment.plan.joints) {
            const double mass = std::min(mass_of(joint.a), mass_of(joint.b));
            const double inertia = std::min(inertia_of(joint.a), inertia_of(joint.b));
            const auto gap = gap_of(joint, moment.before);
            if (!gap || std::isinf(mass)) continue;
            const double rate = 2 * std::numbers::pi * hertz;
            sum += 0.5 * mass * std::pow(rate * double(gap->length), 2);
            if (std::isfinite(inertia))
                sum += 0.5 * inertia * std::pow(rate * std::min(double(gap->angle), widest), 2);
        }
        return sum;
    }

    static double energy(const std::vector<BodyNow>& bodies, const Vec2& gravity) {
        double sum = 0;
        for (const BodyNow& body : bodies) {
            if (!moves_freely(body)) continue;
            const double height =
                -(double(gravity.x) * body.center.x + double(gravity.y) * body.center.y);
            sum += kinetic(body) + body.mass * body.gravity_scale * height;
        }
        return sum;
    }

    bool driven_ = false;
    double first_ = 0, most_moving_ = 0, stored_ = 0;
    std::vector<bool> overlapped_;
    std::vector<std::size_t> pushes_;  // greatest number of other bodies that push each body
};

/// Impulses act on two bodies with opposite signs, so their sum changes by rounding alone: a part
/// in 10⁷ for each of some hundred impulses a step, which add up like a random walk.
class Momentum : public Check {
  public:
    std::optional<std::string> violation(const Moment& moment) override {
        if (moment.step == 0) isolated_ = is_isolated(moment.plan);
        if (!isolated_) return {};
        // A body that falls asleep loses the little energy that it has.
        for (const BodyNow& body : moment.after)
            if (body.exists && !body.awake) isolated_ = false;
        if (!isolated_) return {};
        if (moment.edited || moment.step == 0) begin(moment);
        double x = 0, y = 0, all = 0;
        sum(moment.after, x, y, all);
        most_ = std::max(most_, all);
        const double lost = std::hypot(x - x_, y - y_);
        if (lost <= 1e-3 * most_ + 1e-6) return {};
        return "momentum changes by " + figure(lost) + " of " + figure(most_) + " kg m/s";
    }

  private:
    void begin(const Moment& moment) {
        most_ = x_ = y_ = 0;
        sum(moment.before, x_, y_, most_);
    }
    static void sum(const std::vector<BodyNow>& bodies, double& x, double& y, double& all) {
        for (const BodyNow& body : bodies) {
            if (!moves_freely(body)) continue;
            x += double(body.mass) * body.velocity.x;
            y += double(body.mass) * body.velocity.y;
            all += double(body.mass) * body.velocity.length();
        }
    }
    bool isolated_ = false;
    double x_ = 0, y_ = 0, most_ = 0;
};

}  // namespace

std::unique_ptr<Check> check_energy(const WorldPlan&) {
    return std::make_unique<Energy>();
}
std::unique_ptr<Check> check_momentum(const WorldPlan&) {
    return std::make_unique<Momentum>();
}

}  // namespace fettle::bench::wild
