#pragma once

#include <geometry/motion.h>
#include <solver/joints/joint_passes.h>
#include <state/joint_kind.h>
#include <state/limits.h>

#include <algorithm>
#include <vector>

namespace fettle::physics::detail {

/// Contacts yield by this distance to a motor that presses bodies against an obstacle, m.
inline constexpr float obstructed_depth = 0.02f;
/// Obstacles bear at least this part of the push.
inline constexpr float least_borne = 0.5f;
/// A body passes a push on to another one if it gives it at least this part.
inline constexpr float least_passed = 0.125f;
/// The search for an obstacle ends here.
inline constexpr size_t most_pressed = 32;

/// The impulse with which a joint pushes body b in a sub-step; it pushes body a back.
struct JointPush {
    float impulse = 0.0f;  ///< N s, or N m s
    Vec2 along;            ///< the velocity of what it pushes, for each unit of the impulse
    float turn = 0.0f;     ///< and the angular velocity about the pivot
    Position pivot;

    Vec2 velocity_at(const Position& point) const {
        return turn != 0.0f ? along + cross(turn, point - pivot) : along;
    }
};

/// What a body of a joint pushes, from one to the next, until something that does not yield.
class PressedBodies {
  public:
    /// `yielding`: contacts yield to the push in proportion to it.
    PressedBodies(const JointSource& source, const JointRecord& joint, const JointPush& push,
                  const JointStep& step, bool yielding)
        : source_(source),
          joint_(joint),
          push_(push),
          step_(step),
          turn_(yielding ? two_pi<float> * step.contact_hertz * step.h : 0.0f) {}

    /// Follows the push of one side of the joint through contacts and other joints.
    void follow(size_t side) {
        sign_ = side == 0 ? -1.0f : 1.0f;
        far_ = joint_.bodies[1 - side];
        borne_ = impulses_ = weight_ = lightest_ = 0.0f;
        bodies_.assign(1, {joint_.bodies[side], false});
        for (size_t i = 0; i < bodies_.size(); ++i) {
            const Pressed from = bodies_[i];
            add_weight(from.body);
            objects().for_each_contact(from.body,
                                       [&](uint32_t contact) { visit_contact(contact, from); });
            objects().for_each_joint(
                from.body, [&](uint32_t joint, uint32_t at) { visit_joint(joint, at, from); });
        }
    }
    /// The part of the push that obstacles bear, N s or N m s.
    float borne() const { return borne_; }
    /// True if obstacles bear most of the push that weights do not bear.
    bool is_borne() const { return borne_ > max(least_borne * (push_.impulse - weight_), 0.0f); }
    /// What the push needs for its load, N s or N m s. What neither obstacles nor weights bear is
    /// another load, but it may also be on its way: rows of bodies pass a push on slowly. Half of
    /// it counts, so that nothing sways.
    float load() const { return weight_ + 0.5f * max(push_.impulse - weight_ - borne_, 0.0f); }
    /// The greatest push of a motor in the next step. Weights that press as well count, but not all
    /// of what contacts bear: they may be those of heavy bodies below a light one.
    float greatest_push() const {
        return is_borne() ? max(allowed() + load(), 0.25f * allowed()) : infinity;
    }

  private:
    /// As much of the push as makes contacts yield by `obstructed_depth`.
    float allowed() const {
        const float lever = impulses_ > 0.0f ? borne_ / impulses_ : 1.0f;
        return lightest_ > 0.0f ? lever * obstructed_depth * turn_ * turn_ / (step_.h * lightest_)
                                : infinity;
    }
    struct Pressed {
        uint32_t body;
        bool by_contact;  ///< the push comes through a contact
    };

    const ObjectState& objects() const { return source_.objects; }

    /// The forces on a body, as far as they work against the push.
    void add_weight(uint32_t slot) {
        const BodyRecord& body = objects().bodies[slot];
        lightest_ = max(lightest_, body.inverse_mass);
        const SolverForce& force = source_.bodies.solver_forces[body.solver_index];
        weight_ -= sign_ * (body.mass * dot(force.change, push_.velocity_at(body.center)) +
                            body.inertia * force.turn_change * push_.turn);
    }
    void visit_contact(uint32_t contact, const Pressed& from) {
        const ContactRecord& c = objects().contacts[contact];
        if (!c.acts()) return;
        const bool is_b = c.body_b == from.body;
        const Position center = objects().bodies[from.body].center;
        float against = 0.0f, impulse = 0.0f;
        for (int k = 0; k < c.manifold.count; ++k) {
            const ManifoldPoint& point = c.manifold.points[k];
            const Position place = center + (is_b ? point.anchor_b : point.anchor_a);
            const float of_point = max(point.normal_impulse, impulse_of_overlap(c, point));
            against -= of_point * dot(c.manifold.normal, push_.velocity_at(place));
            impulse += of_point;
        }
        bear(is_b ? against : -against, impulse, {objects().other_body(contact, from.body), true});
    }
    /// The impulse of a contact at rest that yields by the overlap of the point. While a heavy body
    /// bounces back from a light one, the contact bears nothing in some steps, and the motor would
    /// hit with all of its force again and again. 0 where contacts do not yield.
    float impulse_of_overlap(const ContactRecord& c, const ManifoldPoint& point) const {
        const BodyRecord &a = objects().bodies[c.body_a], &b = objects().bodies[c.body_b];
        const bool fixed = !(a.inverse_mass > 0.0f && b.inverse_mass > 0.0f);
        const float turn = (fixed ? 2.0f : 1.0f) * turn_;
        const float mass = inverse_or_zero(a.inverse_mass + b.inverse_mass);
        return max(-point.separation, 0.0f) * mass * turn * turn /
               (step_.h * float(c.manifold.count));
    }
    /// Other joints pass a push on. They bear it like an obstacle only where it comes through a
    /// contact: what they bear of a lever between joints is its load.
    void visit_joint(uint32_t slot, uint32_t at, const Pressed& from) {
        const JointRecord& joint = objects().joints[slot];
        if (&joint == &joint_ || !objects().may_act(joint)) return;
        const JointPlace place = place_of(source_.columns, joint);
        const Vec2 velocity = push_.velocity_at(at == 0 ? place.anchor_a : place.anchor_b);
        const float against = -step_.h * (dot(joint.force, velocity) + joint.torque * push_.turn);
        bear(at == 1 ? against : -against, step_.h * length(joint.force),
             {joint.bodies[1 - at], from.by_contact});
    }
    /// `against`: what a contact or a joint takes of the push; `impulse`: its impulse.
    void bear(float against, float impulse, const Pressed& next) {
        against *= sign_;
        if (!(against > 0.0f)) return;
        if (objects().bodies[next.body].mobility != Mobility::dynamic || next.body == far_) {
            if (!next.by_contact) return;
            borne_ += against;
            impulses_ += impulse;
        } else if (against > least_passed * push_.impulse && bodies_.size() < most_pressed &&
                   std::none_of(bodies_.begin(), bodies_.end(),
                                [&](const Pressed& p) { return p.body == next.body; })) {
            bodies_.push_back(next);
        }
    }

    const JointSource& source_;
    const JointRecord& joint_;
    const JointPush& push_;
    const JointStep& step_;
    float turn_;  ///< h·ω of contacts that yield
    float sign_ = 1.0f;
    uint32_t far_ = 0;  ///< the body at the other side of the joint
    float borne_ = 0.0f, impulses_ = 0.0f;
    float weight_ = 0.0f;    ///< of what is pushed, N s or N m s
    float lightest_ = 0.0f;  ///< the greatest inverse mass
    std::vector<Pressed> bodies_;
};

}  // namespace fettle::physics::detail
