// Checks of motion: states are finite, a body with a speed moves, and no body is much faster than
// the motion that drives it.

#include <algorithm>
#include <cmath>

#include "report/table.h"
#include "wild/checks/check.h"
#include "wild/checks/facts.h"
#include "wild/checks/groups.h"
#include "wild/checks/passages.h"

namespace fettle::bench::wild {
namespace {

class Finite : public Check {
  public:
    std::optional<std::string> violation(const Moment& moment) override {
        for (std::size_t i = 0; i < moment.after.size(); ++i) {
            const BodyNow& body = moment.after[i];
            if (body.exists && !(body.position.is_finite() && body.velocity.is_finite() &&
                                 std::isfinite(body.angle) && std::isfinite(body.angular_velocity)))
                return "body " + std::to_string(i) + " has a state that is not a number";
        }
        return {};
    }
};

/// No awake body with a speed of over 1 m/s keeps its place for three steps without a contact. A
/// body counts as in contact if joints connect it with one that overlaps others deeply: a chain
/// that was made through a wall can neither move on nor hold, and the joints and contacts of each
/// step give it the same speeds and take its motion back.
class Frozen : public Check {
  public:
    std::optional<std::string> violation(const Moment& moment) override {
        still_.resize(moment.after.size(), 0);
        std::optional<std::vector<bool>> held;
        for (std::size_t i = 0; i < moment.after.size(); ++i) {
            bool still = stands_still(moment, i);
            if (still && !held) held = held_in_overlap(moment);
            if (still && (*held)[i]) still = false;
            still_[i] = still ? still_[i] + 1 : 0;
            if (still_[i] >= 3)
                return "body " + std::to_string(i) + " keeps its place at a speed of " +
                       figure(moment.after[i].velocity.length()) + " m/s";
        }
        return {};
    }

  private:
    static bool stands_still(const Moment& moment, std::size_t i) {
        const BodyNow &before = moment.before[i], &after = moment.after[i];
        const float speed = after.velocity.length();
        if (!after.exists || !after.awake || after.touching() || speed <= 1) return false;
        if (after.type != BodyType::dynamic_body || moment.edited_bodies[i]) return false;
        // Position and angle changed by less than 1 % of what the speeds give. A body that was put
        // back to the place of an impact still turns.
        return (after.position - before.position).length() < 0.01f * speed * moment.dt &&
               std::abs(after.angle - before.angle) <=
                   0.01f * std::abs(after.angular_velocity) * moment.dt;
    }
    std::vector<int> still_;
};

/// After an impact, a light body may have twice the speed of the heavy body, and a whip multiplies
/// it further. Four times the speed is rare in games, and an explosion is far beyond it. 20 m/s are
/// added for bodies that begin in overlap: many bodies at once may push them out.
///
/// Nothing bounds the speed of a body that bounces between a kinematic wall and something fixed:
/// each impact of the wall adds twice the speed of the wall, and the impacts follow faster and
/// faster as the gap closes. Such a body, and what it may hit afterwards, is not judged.
class Speed : public Check {
  public:
    std::optional<std::string> violation(const Moment& moment) override {
        if (moment.step == 0) bounces_ = bounces_between_walls(moment.plan);
        if (!judged_) return {};
        time_ += moment.dt;
        // An edit may stop a motor; what the motor has thrown flies on.
        fastest_ = std::max(fastest_, plausible_speed(moment.plan, time_));
        const float bound = 20 + 4 * fastest_;
        for (std::size_t i = 0; i < moment.after.size(); ++i) {
            const BodyNow& body = moment.after[i];
            if (!body.exists || body.velocity.length() <= 0.25f * bound) continue;
            if (bounces_ && is_between_fixed(moment, int(i))) judged_ = false;
            if (!judged_ || body.velocity.length() <= bound) continue;
            return "body " + std::to_string(i) + " has " + figure(body.velocity.length()) +
                   " m/s; nothing in this world explains more than " + figure(bound) + " m/s";
        }
        return {};
    }

  private:
    static bool bounces_between_walls(const WorldPlan& plan) {
        const auto& bodies = plan.bodies;
        const bool moves = std::ranges::any_of(
            bodies, [](const BodyPlan& body) { return body.def.type == BodyType::kinematic_body; });
        const bool bounces = std::ranges::any_of(bodies, [](const BodyPlan& body) {
            return std::ranges::any_of(
                body.shapes, [](const ShapePlan& shape) { return shape.def.restitution > 0; });
        });
        return moves && (bounces || plan.def.bounds_restitution > 0);
    }
    /// True if the body is near at least two bodies that are not dynamic.
    static bool is_between_fixed(const Moment& moment, int body) {
        for (std::size_t other = 0; other < moment.after.size(); ++other)
            if (moment.after[other].exists && moment.after[other].type != BodyType::dynamic_body &&
                !is_near_other_fixed(moment, body, int(other)))
                return false;
        return true;
    }
    float time_ = 0, fastest_ = 0;
    bool bounces_ = false, judged_ = true;
};

}  // namespace

std::unique_ptr<Check> check_finite(const WorldPlan&) {
    return std::make_unique<Finite>();
}
std::unique_ptr<Check> check_frozen(const WorldPlan&) {
    return std::make_unique<Frozen>();
}
std::unique_ptr<Check> check_speed(const WorldPlan&) {
    return std::make_unique<Speed>();
}

}  // namespace fettle::bench::wild
