// Joints hold the bodies together that they connect.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "report/table.h"
#include "wild/checks/check.h"
#include "wild/checks/facts.h"
#include "wild/checks/gaps.h"
#include "wild/checks/groups.h"
#include "wild/checks/passages.h"

namespace fettle::bench::wild {
namespace {

/// A joint is a soft constraint of 60 Hz: a gap that an impact leaves closes within some periods,
/// so only a gap that lasts for a quarter of a second is a failure of the joint.
constexpr double settling_time = 0.25;  // s

/// The library limits the speed at which a gap closes (2 m/s, more under heavy loads). So a wide
/// gap, made by an edit or by a kinematic body, needs time in proportion to its width.
constexpr double closing_speed = 3;  // m/s

/// A chain of 30 links may stretch by 2 % under 100 times its weight. One joint may not stretch by
/// more: by 2 % of the size of its bodies and 1 cm of slack; 0.05 rad are 1 cm at 20 cm.
constexpr float slack = 0.01f;          // m
constexpr float share = 0.02f;          // of the size of the bodies
constexpr float angular_slack = 0.05f;  // rad

/// The factor by which a load stretches a joint further than at 60 Hz. The stiffness is at most a
/// quarter of the rate of the sub-steps, so with sub-steps longer than 1/240 s it is below 60 Hz; a
/// load stretches a joint in proportion to 1 / stiffness².
float yielding_of(const Moment& moment) {
    return std::pow(std::max(240 * moment.substep(), 1.0f), 2.0f);
}

class Joints : public Check {
  public:
    std::optional<std::string> violation(const Moment& moment) override {
        const WorldPlan& plan = moment.plan;
        if (moment.step == 0) reset(plan);
        if (is_windy_) return {};
        // If the lengths of steps vary, the stretch that a long step left is still there
        // afterwards.
        yielding_ = std::max(yielding_, yielding_of(moment));
        const std::vector<bool> squeezed = pressed(moment), wedged = joined_at_wedge(moment);
        const std::vector<float> loads = loads_of_joined(moment);
        const auto is_squeezed = [&](int body) {
            return body != the_world && (squeezed[std::size_t(body)] || wedged[std::size_t(body)]);
        };
        for (std::size_t i = 0; i < plan.joints.size(); ++i) {
            const JointPlan& joint = plan.joints[i];
            if (joint.born > moment.step) continue;
            leave_out_infeasible(moment, i);
            if (left_out_[i]) continue;
            const auto gap = gap_of(joint, moment.after);
            if (!gap) continue;
            if (joint.born == moment.step) leave_out_unless_held(moment, i);
            const float size = size_of(plan, joint);
            // A joint responds in the next step to a motion that it gets in this one.
            const Anchors at = anchors_of(joint, moment.after);
            const float speed =
                (velocity(moment, joint.b, at.b) - velocity(moment, joint.a, at.a)).length();
            const float spin = std::abs(rate(moment, joint.b) - rate(moment, joint.a));
            // While a contact pushes the two bodies apart, the gap is not a failure, since the
            // force of a kinematic body has no bound.
            const bool pushed = is_pushed(moment, joint.a) || is_pushed(moment, joint.b) ||
                                is_squeezed(joint.a) || is_squeezed(joint.b) ||
                                is_obstructed(moment, joint, at);
            const float arc = beside_arc(moment, joint.a, at.a) + beside_arc(moment, joint.b, at.b);
            const Gap sag = sag_of(moment, joint, loads, size);
            const bool bad =
                !pushed && (gap->length > yielding_ * (slack + share * size) + sag.length +
                                              speed * moment.dt + arc ||
                            gap->angle > yielding_ * angular_slack + sag.angle + spin * moment.dt);
            if (bad && since_[i] == 0) opened_[i] = gap->length;
            since_[i] = bad ? since_[i] + moment.dt : 0;
            if (since_[i] > settling_time + opened_[i] / closing_speed)
                return "joint " + std::to_string(i) + " is " + figure(1000 * gap->length) +
                       " mm and " + figure(gap->angle) + " rad from what it holds";
        }
        return {};
    }

  private:
    void reset(const WorldPlan& plan) {
        since_.assign(plan.joints.size(), 0);
        opened_.assign(plan.joints.size(), 0);
        left_out_.assign(plan.joints.size(), false);
        // Wind accelerates thin plates by a hundred times as much as gravity, which stretches
        // joints.
        for (const FieldDef& field : plan.fields)
            is_windy_ = is_windy_ || std::holds_alternative<WindField>(field.force);
        leave_out_taut(plan);
        for (std::size_t i = 0; i < plan.joints.size(); ++i)
            for (const Edit& edit : plan.edits)
                if (edit.target == Target::joint && edit.object == int(i) &&
                    (edit.setting.setter == "destroy" || edit.setting.setter == "set_enabled" ||
                     edit.setting.setter == "set_break_force"))
                    left_out_[i] = true;
    }

    /// Leaves out joints of a group that is held at two places, or that forms a ring. Such joints
    /// may be unable to hold: the smallest weight stretches a straight bridge between two posts.
    void leave_out_taut(const WorldPlan& plan) {
        std::vector<int> group(plan.bodies.size());
        std::iota(group.begin(), group.end(), 0);
        std::vector<bool> held(plan.bodies.size()), taut(plan.bodies.size());
        for (std::size_t i = 0; i < plan.bodies.size(); ++i) held[i] = is_fixed(plan.bodies[i]);
        for (const JointPlan& joint : plan.joints) {
            const auto group_of = [&](int body) {
                return body == the_world ? the_world : group[std::size_t(body)];
            };
            const int a = group_of(joint.a), b = group_of(joint.b);
            if (a == the_world && b == the_world) continue;
            const bool holds_a = a == the_world || held[std::size_t(a)];
            const bool holds_b = b == the_world || held[std::size_t(b)];
            const auto one = std::size_t(a == the_world ? b : a);
            taut[one] = taut[one] || a == b || (holds_a && holds_b);
            held[one] = holds_a || holds_b;
            if (a == the_world || b == the_world || a == b) continue;
            taut[one] = taut[one] || taut[std::size_t(b)];
            for (int& of : group)
                if (of == b) of = a;
        }
        for (std::size_t i = 0; i < plan.joints.size(); ++i)
            for (const int end : {plan.joints[i].a, plan.joints[i].b})
                if (end != the_world && taut[std::size_t(group[std::size_t(end)])])
                    left_out_[i] = true;
    }

    /// Leaves out a joint that has a gap when it is made, since the gap may never close.
    void leave_out_unless_held(const Moment& moment, std::size_t i) {
        const auto gap = gap_of(moment.plan.joints[i], moment.before);
        if (!gap || gap->length > slack || gap->angle > angular_slack) left_out_[i] = true;
    }

    /// Leaves out a joint when one of its bodies is edited, or when an obstacle and one of its
    /// bodies are made inside of each other, and then the other joints of these bodies: both ends
    /// may be held in places that are too far apart.
    void leave_out_infeasible(const Moment& moment, std::size_t i) {
        const JointPlan& joint = moment.plan.joints[i];
        for (const int end : {joint.a, joint.b})
            if (end != the_world && (moment.edited_bodies[std::size_t(end)] ||
                                     (moment.edited && is_pushed(moment, end))))
                left_out_[i] = true;
        if (!left_out_[i]) return;
        // The other joints of its bodies are left out too, and so on through the group.
        for (std::size_t k = 0; k < moment.plan.joints.size(); ++k) {
            const JointPlan& other = moment.plan.joints[k];
            for (const int end : {joint.a, joint.b})
                if (end != the_world && (other.a == end || other.b == end)) left_out_[k] = true;
        }
    }

    /// What a load on the joined bodies makes of a soft joint. The forces of contacts count twice
    /// in `loads`, where the load arrives and where it leaves, but for half of them the joint need
    /// not be between the two.
    static Gap sag_of(const Moment& moment, const JointPlan& joint, const std::vector<float>& loads,
                      float size) {
        const Anchors at = anchors_of(joint, moment.after);
        double mobility = 0, inverse_inertia = 0;
        float load = 0;
        for (const auto& [end, anchor] : {std::pair(joint.a, at.a), std::pair(joint.b, at.b)}) {
            if (end == the_world) continue;
            const BodyNow& body = moment.after[std::size_t(end)];
            if (body.type != BodyType::dynamic_body) continue;
            mobility += 1 / double(body.mass) +
                        (anchor - body.center).length_squared() / double(body.inertia);
            inverse_inertia += 1 / double(body.inertia);
            load = loads[std::size_t(end)];
        }
        const double compliance = std::pow(2 * std::numbers::pi * moment.joint_hertz(), -2);
        return {float(load * mobility * compliance),
                float(load * 0.5 * size * inverse_inertia * compliance)};
    }

    static bool is_pushed(const Moment& moment, int body) {
        return body != the_world && moment.after[std::size_t(body)].deepest > 2 * slack;
    }
    /// True if something fixed or kinematic is in the way of a body that a rod, a rope or the end
    /// of a slide pulls: such joints yield to obstacles.
    static bool is_obstructed(const Moment& moment, const JointPlan& joint, const Anchors& at) {
        if (joint.type == JointType::revolute || joint.type == JointType::weld) return false;
        constexpr float least = 0.3f;            // of the normal along the pull
        Vec2 pull = (at.a - at.b).normalized();  // on b
        // A rod that is too short pushes.
        if (joint.type == JointType::distance &&
            (at.a - at.b).length() < joint.number("set_length", 1))
            pull = -pull;
        const auto holds = [&](int body, const Vec2& way) {
            return body != the_world && std::ranges::any_of(moment.after[std::size_t(body)].held_by,
                                                            [&](const Vec2& normal) {
                                                                return normal.dot(way) < -least;
                                                            });
        };
        return holds(joint.b, pull) || holds(joint.a, -pull);
    }
    static float size_of(const WorldPlan& plan, const JointPlan& joint) {
        float size = 0;
        for (const int end : {joint.a, joint.b})
            if (end != the_world) size += 2 * reach_of(plan.bodies[std::size_t(end)]);
        return size;
    }
    static Vec2 velocity(const Moment& moment, int body, const Vec2& at) {
        return body == the_world ? Vec2(0, 0) : moment.after[std::size_t(body)].velocity_at(at);
    }
    /// How far a sub-step moves an anchor off its circle, since it moves it along a tangent, m.
    static float beside_arc(const Moment& moment, int body, const Vec2& at) {
        if (body == the_world) return 0;
        const BodyNow& now = moment.after[std::size_t(body)];
        const float turn = now.angular_velocity * moment.substep();
        return (at - now.center).length() * turn * turn;
    }
    static float rate(const Moment& moment, int body) {
        return body == the_world ? 0 : moment.after[std::size_t(body)].angular_velocity;
    }

    float yielding_ = 1;
    bool is_windy_ = false;
    std::vector<double> since_;
    std::vector<double> opened_;  // length of the gap when it was first seen, m
    std::vector<bool> left_out_;
};

}  // namespace

std::unique_ptr<Check> check_joints(const WorldPlan&) {
    return std::make_unique<Joints>();
}

}  // namespace fettle::bench::wild
