#include <solver/joints/obstructed_joints.h>
#include <state/joint_kind.h>

#include <algorithm>
#include <vector>

namespace fettle::physics::detail {
namespace {

/// Contacts yield by this distance to a motor that presses bodies against an obstacle, m.
constexpr float obstructed_depth = 0.02f;
/// Obstacles bear at least this part of the push.
constexpr float least_borne = 0.5f;
/// A body passes a push on to another one if it gives it at least this part.
constexpr float least_passed = 0.125f;
/// The search for an obstacle ends here.
constexpr size_t most_pressed = 32;

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
    PressedBodies(const JointSource& source, const JointRecord& joint, const JointPush& push,
                  float h)
        : source_(source), joint_(joint), push_(push), h_(h) {}

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
    /// The greatest push of a motor in the next step.
    float greatest_push() const {
        const float now = push_.impulse, driving = now - weight_;
        if (!(borne_ > max(least_borne * driving, 0.0f))) return infinity;
        // What neither obstacles nor weights bear is another load, but it may also be on its way:
        // rows of bodies pass a push on slowly. Half of it counts, so that nothing sways.
        return max(allowed() + weight_ + 0.5f * max(driving - borne_, 0.0f), 0.0f);
    }

  private:
    /// As much of the push as makes contacts yield by `obstructed_depth`.
    float allowed() const {
        // Contacts between two moving bodies have a quarter of the rate of sub-steps.
        constexpr float turn = two_pi<float> * ContactStiffness::greatest_share;  // h·ω
        const float lever = impulses_ > 0.0f ? borne_ / impulses_ : 1.0f;
        return lightest_ > 0.0f ? lever * obstructed_depth * turn * turn / (h_ * lightest_)
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
            against -= point.normal_impulse * dot(c.manifold.normal, push_.velocity_at(place));
            impulse += point.normal_impulse;
        }
        bear(is_b ? against : -against, impulse, {objects().other_body(contact, from.body), true});
    }
    /// Other joints pass a push on. They bear it like an obstacle only where it comes through a
    /// contact: what they bear of a lever between joints is its load.
    void visit_joint(uint32_t slot, uint32_t at, const Pressed& from) {
        const JointRecord& joint = objects().joints[slot];
        if (&joint == &joint_ || !objects().may_act(joint)) return;
        const JointPlace place = place_of(source_.columns, joint);
        const Vec2 velocity = push_.velocity_at(at == 0 ? place.anchor_a : place.anchor_b);
        const float against = -h_ * (dot(joint.force, velocity) + joint.torque * push_.turn);
        bear(at == 1 ? against : -against, h_ * length(joint.force),
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
    float h_;
    float sign_ = 1.0f;
    uint32_t far_ = 0;  ///< the body at the other side of the joint
    float borne_ = 0.0f, impulses_ = 0.0f;
    float weight_ = 0.0f;    ///< of what is pushed, N s or N m s
    float lightest_ = 0.0f;  ///< the greatest inverse mass
    std::vector<Pressed> bodies_;
};

/// True if a body that is pushed overlaps an obstacle by more than `overlap`, and the way out is
/// against the push. The impulse of that contact may be missing, since a body that was thrown keeps
/// none. `velocity`: of the push.
bool is_in_obstacle(const ObjectState& objects, uint32_t body, Vec2 velocity, float overlap) {
    constexpr float against = -0.7f;  // cosine
    return objects.any_contact(objects.bodies[body].lists.first_contact, none, [&](uint32_t slot) {
        const ContactRecord& c = objects.contacts[slot];
        const Mobility other = objects.bodies[objects.other_body(slot, body)].mobility;
        if (!c.acts() || other == Mobility::dynamic) return false;
        const Vec2 out = c.body_b == body ? c.manifold.normal : -c.manifold.normal;
        return dot(out, velocity) < against &&
               std::any_of(c.manifold.points, c.manifold.points + c.manifold.count,
                           [=](const ManifoldPoint& p) { return p.separation < -overlap; });
    });
}

/// A joint pulls for a small gap only if an obstacle bears the pull on one of its bodies.
void limit_gap(const JointSource& source, const JointRecord& joint, float h, JointEnds& ends) {
    const float pull = length(joint.force);
    if (!(pull > 0.0f)) return;
    const JointPush push = {h * pull, (1.0f / pull) * joint.force, 0.0f, {}};
    PressedBodies pressed(source, joint, push, h);
    for (const size_t side : {0u, 1u}) {
        if (source.objects.bodies[joint.bodies[side]].mobility != Mobility::dynamic) continue;
        pressed.follow(side);
        if (pressed.borne() > least_borne * push.impulse ||
            is_in_obstacle(source.objects, joint.bodies[side], side == 0 ? -push.along : push.along,
                           obstructed_gap))
            ends.greatest_error = obstructed_gap;
    }
}

/// A rope that is too long pulls a body along an obstacle in jerks: in the last sub-step there may
/// have been no force, and the next one would pull for the whole gap. So touching is enough.
void limit_gap_of_rope(const JointSource& source, const JointRecord& joint, JointEnds& ends) {
    constexpr float touching = -0.001f;                                    // m of overlap
    const Vec2 along = normalized(place_of(source.columns, joint).gap());  // from a to b
    for (const size_t side : {0u, 1u}) {
        const uint32_t body = joint.bodies[side];
        if (source.objects.bodies[body].mobility != Mobility::dynamic) continue;
        if (is_in_obstacle(source.objects, body, side == 0 ? along : -along, touching))
            ends.greatest_error = obstructed_gap;
    }
}

/// A motor yields only if both of its bodies are held: a jack lifts what is not. What obstacles do
/// not bear is a load, as that of a lift, and the motor goes on bearing it. Under `soft_step` only:
/// the contacts of the other solvers do not yield.
void limit_motor(const JointSource& source, const JointRecord& joint, const Drive& drive, float h) {
    const float impulse = std::abs(drive.impulse), sign = drive.impulse > 0.0f ? 1.0f : -1.0f;
    const JointPush push = {impulse, sign * drive.along, drive.turns ? sign : 0.0f,
                            place_of(source.columns, joint).anchor_b};
    PressedBodies pressed(source, joint, push, h);
    float greatest = *drive.greatest;
    for (const size_t side : {0u, 1u}) {
        if (source.objects.bodies[joint.bodies[side]].mobility != Mobility::dynamic) continue;
        pressed.follow(side);
        const float allowed = pressed.greatest_push();
        if (allowed == infinity) return;
        greatest = min(greatest, allowed);
    }
    *drive.greatest = greatest;
}

}  // namespace

void yield_to_obstacles(const JointSource& source, const JointStep& step, JointScratch& joints,
                        Solver solver) {
    if (source.objects.contact_slots.count == 0) return;
    const std::vector<SolverBody>& bodies = source.bodies.solver_bodies;
    for_each_acting_joint(joints, [&](const JointKind& kind, JointArray& array, size_t k) {
        const JointRecord& joint = source.objects.joints[array.joints[k]];
        JointEnds& ends = kind.ends(array, k);
        const SolverBody &a = bodies[ends.a], &b = bodies[ends.b];
        if (may_be_obstructed(joint.force, a, b, step.h)) limit_gap(source, joint, step.h, ends);
        if (kind.is_too_long != nullptr && kind.is_too_long(array, k))
            limit_gap_of_rope(source, joint, ends);
        if (solver != Solver::soft_step || kind.drive == nullptr) return;
        const Drive drive = kind.drive(array, k);
        if (drive.greatest != nullptr && may_press(drive, a, b))
            limit_motor(source, joint, drive, step.h);
    });
}

}  // namespace fettle::physics::detail
