// A body between a presser and something that does not yield, or between two pressers, cannot
// satisfy both contacts. Each pass adds to the impulses of both, and the next sub-step begins with
// them. While they balance they move nothing; when the body slips or a normal turns, what is left
// is a hundred times the impulse of the presser, and the body shot out with up to 190 m/s. So a
// squeezed body gets no faster than in one impact with what it touches, and than the push speed:
// neither a rigid wedge nor an impulse that was stored throws it. Its impulses act on what it
// touches too, so the same holds for the bodies that it threw. Momentum is not kept there; the
// presser has none to lose.

#include <solver/contacts/contacts_of_bodies.h>
#include <solver/free_motion.h>
#include <state/joint_kind.h>
#include <state/limits.h>

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

namespace fettle::physics::detail {
namespace {

/// An overlap of more than this, m, is a squeeze, even if only one contact is left of it.
float deep_overlap(float thickness) {
    return min(0.25f * thickness, 0.05f * thickness + 0.01f);
}
/// A contact with a body that yields counts from this part of the thickness on. No load of a stack
/// presses bodies together that much.
constexpr float least_yielding = 0.1f;
/// By this much a body may get faster in a step without being limited, since a motor may drive it:
/// the first as a part of the push speed, the second as a factor of the square of its own speed.
constexpr float little_push = 0.1f, little_more = 1.02f;
/// A joint is held open if its gap is wider than this, m, and than this part of the thickness of
/// one of its bodies. Under a load it is narrower.
constexpr float least_gap = 0.02f, gap_share = 0.5f;
/// A body that does not move along is thrown only if it spins faster than this, rad/s.
constexpr float slow_turn = 10.0f;
/// A presser that is slower than this, m/s, counts as being at rest.
constexpr float standing_speed = 0.001f;

/// A contact with a body that does not yield, relative to the squeezed body.
struct Press {
    Vec2 normal;  ///< towards the body
    float depth = 0.0f, speed = 0.0f;
};

class Squeezes {
  public:
    Squeezes(const SolverInput& input, const Columns& columns, float dt)
        : input_(input),
          columns_(columns),
          dt_(dt),
          inverse_dt2_(1.0f / (dt * dt)),
          least_unyielding_(input.settings.solver == Solver::direct ? -touch_distance : 0.0f) {}

    /// True if the body is fast, and faster than without contacts. `index`: in the solver.
    bool may_be_thrown(uint32_t index) const {
        if (index == 0 || index > input_.active.awake_bodies.size()) return false;
        const SolverBody& b = input_.bodies.solver_bodies[index];
        const float push2 = squared(input_.settings.push_speed);
        // The sequential solver moves bodies out of each other without a velocity.
        const float speed2 =
            max(length_squared(b.velocity), length_squared(b.shift) * inverse_dt2_);
        const float turn = std::fabs(b.angular_velocity);
        if (!(speed2 > push2) && !(turn > slow_turn)) return false;
        const FreeMotion own = own_motion(index);
        return speed2 > little_more * length_squared(own.velocity) + squared(little_push) * push2 ||
               turn > little_more * std::fabs(own.turn);
    }

    /// Limits the body if it is squeezed and thrown, then all that its impulses may have thrown:
    /// they go through slow bodies too, as through a seesaw to what lies on it.
    void limit_squeezed(uint32_t index) {
        if (!is_squeezed(body_at(index))) return;
        pressing_ = pressing_speed(index);
        if (!limit(index)) return;
        through_joints_ = false;
        reach(index, true);
        follow();
    }
    /// Limits what a presser throws that touches the body: the pressure goes through deep contacts
    /// and through joints, and a body that is squeezed somewhere there may stay where it is.
    void limit_pressed(uint32_t index) {
        if (index > input_.active.awake_bodies.size() || is_reached(index)) return;
        pressed_.clear();
        through_joints_ = true;
        pressing_ = 0.0f;
        bool any_squeezed = false, any_open = false;
        const auto add = [&](uint32_t next) {
            if (!is_followed(next)) return;
            reached_.resize(input_.bodies.solver_bodies.size());
            reached_[next] = 1;
            pressed_.push_back(next);
        };
        add(index);
        for (size_t i = 0; i < pressed_.size(); ++i) {
            const uint32_t body = body_at(pressed_[i]);
            any_squeezed = any_squeezed || is_squeezed(body);
            any_open = any_open || holds_open_joint(body);
            pressing_ = max(pressing_, pressing_speed(pressed_[i]));
            for_each_neighbor(pressed_[i], [&](uint32_t next, auto&& is_pressed) {
                if (is_pressed()) add(next);
            });
        }
        // A presser that stands still holds nothing open for long.
        if (!any_squeezed && !(any_open && pressing_ > standing_speed)) return;
        for (const uint32_t next : pressed_) {
            const bool thrown = may_be_thrown(next) && limit(next);
            waiting_.push_back({next, thrown});
        }
        follow();
    }

  private:
    static float squared(float value) { return value * value; }

    /// What impulses may make of a body at most.
    struct Most {
        float speed;  ///< m/s
        float turn;   ///< rad/s
    };

    /// False if the body is not faster than what it touches can make it.
    bool limit(uint32_t index) {
        const uint32_t body = body_at(index);
        SolverBody& b = input_.bodies.solver_bodies[index];
        const FreeMotion own = own_motion(index);
        const float speed = max(length(b.velocity), length(b.shift) / dt_);
        const float turn = max(std::fabs(b.angular_velocity), std::fabs(b.turn) / dt_);
        const float extent = max(input_.objects.bodies[body].extent, 1e-6f);
        const auto is_slow = [&](const Most& most) {
            return !(speed > most.speed) && !(turn > most.turn);
        };
        // What it touches can only make it faster, and is looked at only if that matters.
        const float least = max(length(own.velocity), input_.settings.push_speed);
        Most most = {least, max(least / extent, std::fabs(own.turn))};
        if (is_slow(most)) return false;
        add_touched(index, own, extent, most);
        if (is_slow(most)) return false;
        const auto scale = [](float value, float limit) {
            return value > limit ? limit / value : 1.0f;
        };
        const SolverBody before = b;
        b.velocity = scale(length(b.velocity), most.speed) * b.velocity;
        b.shift = scale(length(b.shift), dt_ * most.speed) * b.shift;
        b.angular_velocity *= scale(std::fabs(b.angular_velocity), most.turn);
        b.turn *= scale(std::fabs(b.turn), dt_ * most.turn);
        keep_ahead(index, before);
        input_.bodies.limited.push_back(body);
        return true;
    }

    /// What presses a body from one side carries it along, and the limit takes none of that: a ball
    /// that slides on a lift is faster than the lift, and with the speed of the lift alone it would
    /// sink in.
    void keep_ahead(uint32_t index, const SolverBody& before) {
        const uint32_t body = body_at(index);
        std::array<const ContactRecord*, most_presses> pressing;
        size_t count = 0;
        for (const ContactsOfBodies::Contact contact : contacts_of(index)) {
            const ContactRecord& c = input_.objects.contacts[contact.slot];
            const uint32_t other = input_.objects.other_body(contact.slot, body);
            if (yields(other) || !(depth_of(c) > least_unyielding_)) continue;
            const Vec2 n = normal_from(other, c);
            const bool between = std::any_of(
                pressing.begin(), pressing.begin() + count, [&](const ContactRecord* p) {
                    return dot(n, normal_from(body == p->body_a ? p->body_b : p->body_a, *p)) <
                           0.0f;
                });
            if (between) return;
            if (count < most_presses) pressing[count++] = &c;
        }
        for (size_t i = 0; i < count; ++i)
            keep_ahead(*pressing[i], body, before, input_.bodies.solver_bodies[index]);
    }
    /// Keeps the speed away from the presser at each point, up to that of the presser.
    void keep_ahead(const ContactRecord& c, uint32_t body, const SolverBody& before,
                    SolverBody& b) const {
        const bool is_a = body == c.body_a;
        const SolverBody& presser = solver_body(is_a ? c.body_b : c.body_a);
        const Vec2 n = is_a ? -c.manifold.normal : c.manifold.normal;
        for (int k = 0; k < c.manifold.count; ++k) {
            const ManifoldPoint& p = c.manifold.points[k];
            const Vec2 arm = is_a ? p.anchor_a : p.anchor_b;
            const Vec2 far_arm = is_a ? p.anchor_b : p.anchor_a;
            const auto along = [n](Vec2 linear, float turn, Vec2 at) {
                return dot(n, linear + cross(turn, at));
            };
            const float speed = min(along(before.velocity, before.angular_velocity, arm),
                                    along(presser.velocity, presser.angular_velocity, far_arm));
            const float way = min(along(before.shift, before.turn, arm),
                                  along(presser.shift, presser.turn, far_arm));
            b.velocity =
                b.velocity + max(speed - along(b.velocity, b.angular_velocity, arm), 0.0f) * n;
            b.shift = b.shift + max(way - along(b.shift, b.turn, arm), 0.0f) * n;
        }
    }

    /// A body that was reached, and whether the impulses on it are known to be too large.
    struct Reached {
        uint32_t index;
        bool thrown;
    };

    bool is_reached(uint32_t index) const { return !reached_.empty() && reached_[index] != 0; }
    void reach(uint32_t index, bool thrown) {
        reached_.resize(input_.bodies.solver_bodies.size());
        if (!std::exchange(reached_[index], 1)) waiting_.push_back({index, thrown});
    }
    void follow() {
        while (!waiting_.empty()) {
            const Reached from = waiting_.back();
            waiting_.pop_back();
            for_each_neighbor(from.index, [&](uint32_t index, auto&& is_pressed) {
                if (!is_followed(index)) return;
                const bool limited = may_be_thrown(index) && limit(index);
                const bool thrown = from.thrown || limited;
                if (thrown || is_pressed()) reach(index, thrown);
            });
        }
    }
    /// Calls `visit(index of the other body, function that returns whether pressure goes to it)`.
    void for_each_neighbor(uint32_t index, auto&& visit) {
        const ObjectState& objects = input_.objects;
        for (const ContactsOfBodies::Contact contact : contacts_of(index)) {
            visit(contact.other, [&] {
                const ContactRecord& c = objects.contacts[contact.slot];
                const float width =
                    min(objects.bodies[c.body_a].thickness, objects.bodies[c.body_b].thickness);
                return depth_of(c) > least_yielding * width;
            });
        }
        if (!through_joints_) return;
        objects.for_each_joint(body_at(index), [&](uint32_t joint, uint32_t side) {
            if (!objects.joints[joint].moves()) return;
            const uint32_t other = objects.joints[joint].bodies[side ^ 1];
            visit(objects.bodies[other].solver_index, [] { return true; });
        });
    }
    std::span<const ContactsOfBodies::Contact> contacts_of(uint32_t index) {
        if (!contacts_) contacts_.emplace(input_.contacts, input_.bodies.solver_bodies.size());
        return contacts_->of(index);
    }
    uint32_t body_at(uint32_t index) const { return input_.active.awake_bodies[index - 1]; }
    /// True if the body is awake and yields, and was not reached yet.
    bool is_followed(uint32_t index) const {
        return index != 0 && index <= input_.active.awake_bodies.size() && !is_reached(index) &&
               yields(body_at(index));
    }

    FreeMotion own_motion(uint32_t index) const {
        return {columns_.states[body_at(index)], input_.bodies.solver_forces[index],
                float(input_.settings.substeps)};
    }

    /// Maximum number of contacts of a body that are compared with its other contacts.
    static constexpr size_t most_presses = 8;

    bool yields(uint32_t body) const {
        return input_.objects.bodies[body].mobility == Mobility::dynamic;
    }

    bool is_squeezed(uint32_t body) const {
        const ObjectState& objects = input_.objects;
        const float thickness = objects.bodies[body].thickness, deep = deep_overlap(thickness);
        const uint32_t first = objects.bodies[body].lists.first_contact;
        std::array<Press, most_presses> presses;
        size_t count = 0;
        const auto any_opposing = [&](Vec2 normal, auto&& is_enough) {
            return std::any_of(presses.begin(), presses.begin() + count, [&](const Press& press) {
                return dot(press.normal, normal) < 0.0f && is_enough(press);
            });
        };
        const bool between = objects.any_contact(first, none, [&](uint32_t i) {
            const ContactRecord& c = objects.contacts[i];
            const uint32_t other = c.body_a == body ? c.body_b : c.body_a;
            if (yields(other) || !c.acts()) return false;
            const Press press = {normal_from(other, c), depth_of(c), speed_of(other, c)};
            if (!(press.depth > least_unyielding_)) return false;
            // A piston between two walls is not squeezed.
            if (press.depth > deep || any_opposing(press.normal, [&](const Press& opposing) {
                    return press.speed + opposing.speed > standing_speed ||
                           press.depth + opposing.depth > 0.5f * deep;
                }))
                return true;
            if (count < most_presses) presses[count++] = press;
            return false;
        });
        if (between || count == 0) return between;
        return objects.any_contact(first, none, [&](uint32_t i) {
            const ContactRecord& c = objects.contacts[i];
            const uint32_t other = c.body_a == body ? c.body_b : c.body_a;
            return c.acts() && yields(other) && depth_of(c) > least_yielding * thickness &&
                   any_opposing(normal_from(other, c), [](const Press&) { return true; });
        });
    }
    /// True if the pressure holds a joint of the body open.
    bool holds_open_joint(uint32_t body) const {
        const float least = max(least_gap, gap_share * input_.objects.bodies[body].thickness);
        bool open = false;
        input_.objects.for_each_joint(body, [&](uint32_t slot, uint32_t) {
            const JointRecord& joint = input_.objects.joints[slot];
            const auto separation = joint_kind(joint.type).separation;
            if (open || separation == nullptr || !input_.objects.may_act(joint)) return;
            open = separation(joint, place_of(columns_, joint)) > least;
        });
        return open;
    }
    static Vec2 normal_from(uint32_t body, const ContactRecord& c) {
        return body == c.body_a ? c.manifold.normal : -c.manifold.normal;
    }
    /// The greater one of the overlaps before and after the step, m.
    float depth_of(const ContactRecord& c) const {
        const SolverBody &a = solver_body(c.body_a), &b = solver_body(c.body_b);
        const Vec2 n = c.manifold.normal;
        float depth = -infinity;
        for (int k = 0; k < c.manifold.count; ++k) {
            const ManifoldPoint& p = c.manifold.points[k];
            const float parted = dot(n, b.shift - a.shift) + cross(p.anchor_b, n) * b.turn -
                                 cross(p.anchor_a, n) * a.turn;
            depth = max(depth, -(p.separation + min(parted, 0.0f)));
        }
        return depth;
    }
    /// Of a body at a contact, along its normal, m/s.
    float speed_of(uint32_t body, const ContactRecord& c) const {
        const FreeMotion motion = FreeMotion::of(input_, columns_, body);
        float speed = 0.0f;
        for (int k = 0; k < c.manifold.count; ++k) {
            const ManifoldPoint& p = c.manifold.points[k];
            const Vec2 arm = body == c.body_a ? p.anchor_a : p.anchor_b;
            speed = max(speed, std::fabs(dot(c.manifold.normal, motion.at(arm))));
        }
        return speed;
    }
    /// The greatest speed of what touches the body and does not yield, m/s.
    float pressing_speed(uint32_t index) {
        float most = 0.0f;
        for (const ContactsOfBodies::Contact contact : contacts_of(index)) {
            const ContactRecord& c = input_.objects.contacts[contact.slot];
            if (!yields(input_.objects.other_body(contact.slot, body_at(index))))
                most = max(most, speed_of_other(c, body_at(index)) + std::fabs(c.surface_speed));
        }
        return most;
    }
    const SolverBody& solver_body(uint32_t body) const {
        return input_.bodies.solver_bodies[input_.objects.bodies[body].solver_index];
    }

    /// The greatest speed of what a body touches at a contact, m/s.
    float speed_of_other(const ContactRecord& c, uint32_t body) const {
        const uint32_t other = c.body_a == body ? c.body_b : c.body_a;
        const FreeMotion motion = FreeMotion::of(input_, columns_, other);
        float most = 0.0f;
        for (int k = 0; k < c.manifold.count; ++k) {
            const ManifoldPoint& p = c.manifold.points[k];
            const Vec2 arm = other == c.body_a ? p.anchor_a : p.anchor_b;
            most = max(most, yields(other) ? max(length(motion.velocity),
                                                 std::fabs(motion.turn) * length(arm))
                                           : length(motion.at(arm)));
        }
        return most;
    }
    /// Adds what the body can get from what it touches, also in one impact with restitution, and
    /// from joints.
    void add_touched(uint32_t index, const FreeMotion& own, float extent, Most& most) {
        const ObjectState& objects = input_.objects;
        const uint32_t body = body_at(index);
        const float v = length(own.velocity), w = std::fabs(own.turn);
        const float arm = min(std::sqrt(gyration_of(input_.bodies.solver_bodies[index])), extent);
        float carried = max(most.speed, pressing_);
        for (const ContactsOfBodies::Contact contact : contacts_of(index)) {
            const ContactRecord& c = objects.contacts[contact.slot];
            const float other = speed_of_other(c, body), belt = std::fabs(c.surface_speed);
            carried = max(carried, other + belt);
            const float e = c.restitution;
            if (!(e > 0.0f)) continue;
            // With the lever arm r and the radius of gyration k, an impact changes the velocity of
            // the center by (1 + e)·k²/(k² + r²) of the approach, and k·ω by (1 + e)·k·r/(k² + r²)
            // of it. The second factor is at most a half of 1 + e.
            const float gained = (1.0f + e) * (other + 0.5f * arm * w);
            most.speed =
                max(most.speed, std::sqrt(v * v + 2.0f * e * v * gained + gained * gained) + belt);
            most.turn = max(most.turn, w + 0.5f * (1.0f + e) * (v + other) / arm);
        }
        objects.for_each_joint(body, [&](uint32_t joint, uint32_t side) {
            const JointRecord& record = objects.joints[joint];
            const FreeMotion motion = FreeMotion::of(input_, columns_, record.bodies[side ^ 1]);
            const BodyRecord& other = objects.bodies[record.bodies[side ^ 1]];
            carried =
                max(carried, max(length(motion.velocity), std::fabs(motion.turn) * other.extent));
        });
        most.speed = max(most.speed, carried);
        most.turn = max(most.turn, carried / extent);
    }

    const SolverInput& input_;
    const Columns& columns_;
    float dt_, inverse_dt2_;
    float least_unyielding_;  ///< depth, m; the direct solver throws a body out before it overlaps
    std::optional<ContactsOfBodies> contacts_;  ///< made when the first body is limited
    // Bodies that a squeezed one may have thrown, as indices in the solver.
    std::vector<Reached> waiting_;
    std::vector<uint32_t> pressed_;
    /// What presses moves all of them with this speed, m/s, also those that it does not touch.
    float pressing_ = 0.0f;
    /// Only behind a presser: an impact on something fixed has an end, and what joints make of it
    /// is physics.
    bool through_joints_ = false;
    std::vector<uint8_t> reached_;  ///< by solver body: 1 if it was or is in `waiting_`
};

}  // namespace

void limit_squeezed(const SolverInput& input, const Columns& columns, float dt) {
    if (!(dt > 1e-12f)) return;
    Squeezes squeezes(input, columns, dt);
    const auto for_each_mover = [&](auto&& visit) {
        for (const ActingPiece& piece : input.contacts.acting_pieces) {
            for (uint32_t i = piece.begin; i < piece.end(); ++i) {
                const ActingContact& c = input.contacts.acting[i];
                if (c.moves_a() != c.moves_b()) visit(c.mover(), c.moves_a() ? c.b() : c.a());
            }
        }
    };
    if (input.bodies.driven)
        for_each_mover([&](uint32_t mover, uint32_t other) {
            if (other != 0) squeezes.limit_pressed(mover);  // the other one is kinematic
        });
    // A body that touches nothing that does not yield is not squeezed.
    for_each_mover([&](uint32_t mover, uint32_t) {
        if (squeezes.may_be_thrown(mover)) squeezes.limit_squeezed(mover);
    });
}

}  // namespace fettle::physics::detail
