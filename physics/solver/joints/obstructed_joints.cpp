#include <solver/joints/encounters.h>
#include <solver/joints/obstructed_joints.h>
#include <solver/joints/obstructed_ropes.h>
#include <solver/joints/pressed_bodies.h>

#include <vector>

namespace fettle::physics::detail {
namespace {

/// A joint pulls for a small gap only if an obstacle bears the pull on one of its bodies.
/// `yielding`: see `PressedBodies`.
void limit_gap(const JointSource& source, const JointRecord& joint, const JointStep& step,
               bool yielding, JointEnds& ends) {
    const float pull = length(joint.force);
    if (!(pull > 0.0f)) return;
    const JointPush push = {step.h * pull, (1.0f / pull) * joint.force, 0.0f, {}};
    PressedBodies pressed(source, joint, push, step, yielding);
    for (const size_t side : {0u, 1u}) {
        if (!is_dynamic(source.objects, joint.bodies[side])) continue;
        pressed.follow(side);
        if (pressed.borne() > least_borne * push.impulse ||
            is_in_obstacle(source.objects, joint.bodies[side], side == 0 ? -push.along : push.along,
                           obstructed_gap))
            ends.greatest_error = obstructed_gap;
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
        if (!is_dynamic(source.objects, joint.bodies[side])) continue;
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
