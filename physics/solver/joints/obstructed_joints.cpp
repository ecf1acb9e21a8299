#include <geometry/motion.h>
#include <solver/joints/obstructed_joints.h>
#include <state/joint_kind.h>
#include <state/limits.h>

#include <algorithm>
#include <vector>

namespace fettle::physics::detail {
namespace {

/// Contacts yield by this distance to a motor that presses bodies against an obstacle, m.
constexpr float obstructed_depth = 0.02f;
/// A push goes into an obstacle if the cosine to its normal is greater than this.
constexpr float steep = 0.7f;
/// Obstacles bear at least this part of the push.
constexpr float least_borne = 0.5f;
/// A body passes a push on to another one if it gives it at least this part.
constexpr float least_passed = 0.125f;
/// The search for an obstacle ends here.
constexpr size_t most_pressed = 32;
/// What ropes pull with besides their load, as an acceleration, m/s².
constexpr float ten_weights = 100.0f;

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

/// How directly a body is pushed into an obstacle.
struct Encounter {
    float into = 0.0f;  ///< the cosine, 0 if there is no obstacle
    Vec2 out;           ///< the normal of the obstacle
};

/// The obstacle that a body is pushed into most directly, of those that it overlaps by more than
/// `overlap`, or is nearer to than minus that. The impulse of that contact may be missing, since a
/// body that was thrown keeps none. `velocity`: of the push. `is_meant(obstacle)` says which
/// obstacles count.
template <typename IsMeant>
Encounter encounter_of(const ObjectState& objects, uint32_t body, Vec2 velocity, float overlap,
                       IsMeant&& is_meant) {
    Encounter most;
    objects.for_each_contact(body, [&](uint32_t slot) {
        const ContactRecord& c = objects.contacts[slot];
        const uint32_t other = objects.other_body(slot, body);
        if (!c.acts() || !is_meant(other)) return;
        const Vec2 out = c.body_b == body ? c.manifold.normal : -c.manifold.normal;
        if (std::any_of(c.manifold.points, c.manifold.points + c.manifold.count,
                        [=](const ManifoldPoint& p) { return p.separation < -overlap; }))
            if (-dot(out, velocity) > most.into) most = {-dot(out, velocity), out};
    });
    return most;
}
bool is_in_obstacle(const ObjectState& objects, uint32_t body, Vec2 velocity, float overlap) {
    const auto is_fixed = [&](uint32_t other) {
        return objects.bodies[other].mobility != Mobility::dynamic;
    };
    return encounter_of(objects, body, velocity, overlap, is_fixed).into > steep;
}

/// True if a push goes into an obstacle, and along it into another one: the two hold the body in a
/// narrow gap.
template <typename IsMeant>
bool is_wedged(const ObjectState& objects, uint32_t body, Vec2 velocity, const Encounter& first,
               IsMeant&& is_meant) {
    constexpr float least = 0.05f;  // a cosine
    if (!(first.into > least)) return false;
    const Vec2 along = velocity + first.into * first.out;
    return encounter_of(objects, body, along, -speculative_margin, is_meant).into >
           least * length(along);
}

/// A rope, a rod or a pulley pulls bodies that obstacles hold with no more than its load and some
/// weights. If it pulled like a spring over the gap, its force would do work on what it draws along
/// an obstacle, and throw what slips round it. Where only one of two bodies is held, the pull moves
/// the other one: the passes are too few to find that out, and what a rope drew into a narrow gap
/// went through it, with no great force. Under `soft_step` only.
void limit_pull(const JointSource& source, const JointRecord& joint, const Pull& pull,
                const JointStep& step, JointEnds& ends, std::vector<uint32_t>& strained) {
    bool moves[2], held[2];
    float load[2], inverse_mass = 0.0f;
    for (const size_t side : {0u, 1u}) {
        const uint32_t slot = joint.bodies[side];
        const BodyRecord& body = source.objects.bodies[slot];
        moves[side] = body.mobility == Mobility::dynamic;
        held[side] = !moves[side];
        load[side] = infinity;
        if (!moves[side]) continue;
        const Vec2 towards = pull.towards[side];
        const JointPush push = {
            step.h * length(joint.force), side == 0 ? -towards : towards, 0.0f, {}};
        PressedBodies pressed(source, joint, push, step, true);
        pressed.follow(side);
        // What rolls or tips on another body bears nothing for a moment.
        const auto is_meant = [&](uint32_t other) {
            return other != joint.bodies[1 - side] &&
                   (pull.is_strained || source.objects.bodies[other].mobility != Mobility::dynamic);
        };
        held[side] =
            pressed.is_borne() ||
            encounter_of(source.objects, slot, towards, -speculative_margin, is_meant).into > steep;
        load[side] = pressed.load();
        inverse_mass += body.inverse_mass;
    }
    if (held[0] != held[1]) {
        const size_t side = held[0] ? 0 : 1;
        const uint32_t slot = joint.bodies[side];
        if (!moves[side] || !pull.only_pulls ||
            length_squared(source.columns.states[slot].velocity) > 1.0f)
            return;
        ends.held = int(side);
        ends.greatest_pull =
            2.0f * step.h * length(joint.force) +
            ten_weights * step.h * source.objects.bodies[joint.bodies[1 - side]].mass;
    } else if (held[0]) {
        // Weights on the way may help to pull.
        ends.greatest_pull =
            max(min(load[0], load[1]), 0.0f) + ten_weights * step.h * inverse_or_zero(inverse_mass);
    } else {
        return;
    }
    for (const size_t side : {0u, 1u})
        if (moves[side]) strained.push_back(joint.bodies[side]);
}

/// A rope that is too long pulls with at most twice its force, and some weights. What it draws to
/// another body holds that one and is held by it, until one rolls away or tips over. If all of the
/// pull for the open gap then acted at once, it would throw the body. A rod that is between bodies
/// is limited in the same way.
void limit_growth(const JointSource& source, const JointRecord& joint, const Pull& pull,
                  const JointStep& step, JointEnds& ends) {
    float inverse_mass = 0.0f;
    bool limits = pull.only_pulls;
    for (const size_t side : {0u, 1u}) {
        const BodyRecord& body = source.objects.bodies[joint.bodies[side]];
        if (body.mobility != Mobility::dynamic) continue;
        inverse_mass += body.inverse_mass;
        const auto moves = [&](uint32_t other) {
            return source.objects.bodies[other].mobility == Mobility::dynamic;
        };
        const Encounter encounter = encounter_of(source.objects, joint.bodies[side],
                                                 pull.towards[side], -speculative_margin, moves);
        limits = limits || encounter.into > 0.0f;
    }
    if (limits)
        ends.greatest_pull =
            step.h * (2.0f * length(joint.force) + ten_weights * inverse_or_zero(inverse_mass));
}

/// A joint pulls for a small gap only if an obstacle bears the pull on one of its bodies.
/// `yielding`: see `PressedBodies`.
void limit_gap(const JointSource& source, const JointRecord& joint, const JointStep& step,
               bool yielding, JointEnds& ends) {
    const float pull = length(joint.force);
    if (!(pull > 0.0f)) return;
    const JointPush push = {step.h * pull, (1.0f / pull) * joint.force, 0.0f, {}};
    PressedBodies pressed(source, joint, push, step, yielding);
    for (const size_t side : {0u, 1u}) {
        if (source.objects.bodies[joint.bodies[side]].mobility != Mobility::dynamic) continue;
        pressed.follow(side);
        if (pressed.borne() > least_borne * push.impulse ||
            is_in_obstacle(source.objects, joint.bodies[side], side == 0 ? -push.along : push.along,
                           obstructed_gap))
            ends.greatest_error = obstructed_gap;
    }
}

/// True for a kinematic body that is not at rest.
bool moves_by_itself(const JointSource& source, uint32_t body) {
    return source.objects.bodies[body].mobility == Mobility::kinematic &&
           !stands_still(source.columns.states[body]);
}

/// A rope that is too long pulls a body along an obstacle in jerks: in the last sub-step there may
/// have been no force, and the next one would pull for the whole gap. So being near is enough. Of
/// one that is not too long yet, the obstacle or what it is tied to must move by itself. The more
/// the rope pulls along the obstacle, the faster the gap may close: contacts of `direct` hold a
/// pull that is not steep.
void limit_gap_of_rope(const JointSource& source, const JointRecord& joint, const Pull& pull,
                       Solver solver, JointEnds& ends) {
    const float least_into = solver == Solver::direct ? steep : 0.05f;  // a cosine
    for (const size_t side : {0u, 1u}) {
        const uint32_t body = joint.bodies[side];
        if (source.objects.bodies[body].mobility != Mobility::dynamic) continue;
        // An impact makes a rod shorter, too.
        constexpr float slow = 2.0f;  // m/s
        if (pull.pushes && length_squared(source.columns.states[body].velocity) > slow * slow)
            continue;
        const bool any = pull.is_strained || moves_by_itself(source, joint.bodies[1 - side]);
        const auto is_meant = [&](uint32_t obstacle) {
            return source.objects.bodies[obstacle].mobility != Mobility::dynamic &&
                   (any || moves_by_itself(source, obstacle));
        };
        const Vec2 towards = pull.towards[side];
        const Encounter first =
            encounter_of(source.objects, body, towards, -speculative_margin, is_meant);
        if (!(first.into > least_into) &&
            !is_wedged(source.objects, body, towards, first, is_meant))
            continue;
        const float gap = solver == Solver::direct ? obstructed_gap : obstructed_gap / first.into;
        ends.greatest_error = min(ends.greatest_error, gap);
    }
}

/// A motor yields only if both of its bodies are held: a jack lifts what is not. What obstacles do
/// not bear is a load, as that of a lift, and the motor goes on bearing it. Under `soft_step` only:
/// the contacts of the other solvers do not yield.
void limit_motor(const JointSource& source, const JointRecord& joint, const Drive& drive,
                 const JointStep& step) {
    const float impulse = std::abs(drive.impulse), sign = drive.impulse > 0.0f ? 1.0f : -1.0f;
    const JointPush push = {impulse, sign * drive.along, drive.turns ? sign : 0.0f,
                            place_of(source.columns, joint).anchor_b};
    PressedBodies pressed(source, joint, push, step, true);
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
                        Solver solver, std::vector<uint32_t>& strained) {
    if (source.objects.contact_slots.count == 0) return;
    const std::vector<SolverBody>& bodies = source.bodies.solver_bodies;
    const bool by_movers = may_have_no_solution(source.bodies, solver);
    for_each_acting_joint(joints, [&](const JointKind& kind, JointArray& array, size_t k) {
        const JointRecord& joint = source.objects.joints[array.joints[k]];
        JointEnds& ends = kind.ends(array, k);
        const SolverBody &a = bodies[ends.a], &b = bodies[ends.b];
        const Pull pull = kind.pull != nullptr ? kind.pull(array, k) : Pull{};
        // What limited a pull from something fixed made it weak. That must not free it again.
        const bool yields = solver == Solver::soft_step && kind.pull != nullptr;
        const bool held = a.inverse_mass == 0.0f || b.inverse_mass == 0.0f;
        if ((yields && held && pull.is_strained) || may_be_obstructed(joint.force, a, b, step.h))
            limit_gap(source, joint, step, yields, ends);
        if (pull.is_strained || (by_movers && kind.pull != nullptr))
            limit_gap_of_rope(source, joint, pull, solver, ends);
        if (yields && pull.is_strained) limit_growth(source, joint, pull, step, ends);
        if (yields &&
            (ends.greatest_error < infinity || may_be_held(source.objects, joint, pull, a, b)))
            limit_pull(source, joint, pull, step, ends, strained);
        if (solver != Solver::soft_step || kind.drive == nullptr) return;
        const Drive drive = kind.drive(array, k);
        if (drive.greatest != nullptr && may_press(drive, a, b))
            limit_motor(source, joint, drive, step);
    });
}

}  // namespace fettle::physics::detail
