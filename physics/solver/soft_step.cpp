#include <solver/contact_solver.h>
#include <world/world_data.h>

#include <tuple>

// The soft step (E. Catto, "Solver2D", 2024) over all blocks: per sub-step velocities, warm start,
// biased solve, positions, relax; at the end restitution; joints before contacts, what is solved
// one at a time before what is solved sixteen at a time.

namespace fettle::physics::detail {

/// What holds for all blocks during a step.
struct WorldData::BlockStep {
    const WideKernels& kernels;
    PrepareStep prepare;
    float h;
    SubstepLimits limits;
};

WideStep WorldData::wide_step(const SolverBlock& block, const BlockStep& step) {
    return {solver_bodies.data(), wide_contacts.data() + block.first_group,
            block.group_end - block.first_group, 1.0f / step.h, settings.push_speed};
}

/// A block of nothing but wide contacts, through all sub-steps.
void WorldData::solve_block(const SolverBlock& block, const BlockStep& step) {
    const WideKernels& kernels = step.kernels;
    const WideStep wide = wide_step(block, step);
    const std::span groups = std::span(contact_lanes).subspan(block.first_group, wide.count);
    const std::span which = blocks.bodies_of(block);
    kernels.prepare(step.prepare, groups, wide.contacts);
    for (int substep = 0; substep < settings.substeps; ++substep) {
        integrate_velocities(which, solver_bodies, solver_forces, step.limits, substep > 0);
        if (substep == 0) kernels.warm_start(wide);
        kernels.solve_biased(wide);
        integrate_positions(which, solver_bodies, step.h);
        kernels.relax(wide);
    }
    kernels.store(wide.contacts, groups, touch_distance);
}

/// Whether sub-steps after the first repeat what the contacts gave the bodies, rather than warm
/// start them one by one. What many joints do besides takes longer to tell apart than that saves.
bool WorldData::repeats_pushes(const SolverBlock& block) {
    joint_share.clear();
    if (!rolling_contacts.empty()) return false;  // what they gave had another direction
    size_t ends = 0;
    std::apply([&](const auto&... list) { ((ends += 2 * list.size()), ...); }, joint_constraints);
    const size_t groups = block.group_end - block.first_group;
    if (ends > (groups * lanes + constraints.size()) / 4) return false;
    const auto add = [&](const auto& list) {
        for (const auto& c : list) joint_share.add(c.ends.a), joint_share.add(c.ends.b);
    };
    std::apply([&](const auto&... list) { (add(list), ...); }, joint_constraints);
    joint_share.unite();
    return true;
}

/// The first block, with all that the others do not have.
void WorldData::solve_first_block(const BlockStep& step, const JointStep& joint_step) {
    const WideKernels& kernels = step.kernels;
    const WideStep wide = wide_step(blocks[0], step);
    const std::span groups = std::span(contact_lanes).first(wide.count);
    const std::span which = blocks.bodies_of(blocks[0]);
    ContactSolver serial;
    serial.bodies = solver_bodies;
    serial.constraints = constraints;
    serial.extras = extras;
    serial.rolling = rolling_contacts;
    serial.inverse_h = wide.inverse_h;
    serial.push_speed = wide.push_speed;
    serial.restitution_threshold = settings.restitution_threshold;

    const bool repeats = repeats_pushes(blocks[0]);
    const auto around_joints = [&](auto&& pass) {
        if (repeats)
            joint_share.around(solver_bodies, solver_forces, pass);
        else
            pass();
    };
    kernels.prepare(step.prepare, groups, wide.contacts);
    serial.bounce(step.h * float(settings.substeps));
    zero_locked();
    for (int substep = 0; substep < settings.substeps; ++substep) {
        const bool again = repeats && substep > 0;
        integrate_velocities(which, solver_bodies, solver_forces, step.limits, again);
        zero_locked();
        solver_bodies[0] = {};  // joints write it back unmoved; whatever happens, it stays so
        around_joints([&] { warm_start_joints(); });
        if (!again) {
            serial.warm_start();
            kernels.warm_start(wide);
        }
        around_joints([&] { solve_joints(joint_step); });
        serial.solve_biased();
        kernels.solve_biased(wide);
        zero_locked();
        integrate_positions(which, solver_bodies, step.h);
        around_joints([&] { relax_joints(joint_step); });
        serial.relax();
        kernels.relax(wide);
        zero_locked();
        strain_joints();
    }
    serial.restitute();
    zero_locked();
    kernels.store(wide.contacts, groups, touch_distance);
}

void WorldData::solve_softly(const JointStep& joint_step, const ContactStiffness& stiffness) {
    const float h = joint_step.h;
    const BlockStep step = {wide_kernels(most_lanes),
                            {solver_bodies.data(), &stiffness, joint_step.impulse_ratio},
                            h,
                            {greatest_speed, greatest_turn / h}};
    solve_first_block(step, joint_step);
    for (size_t block = 1; block < blocks.size(); ++block) solve_block(blocks[block], step);
}

}  // namespace fettle::physics::detail
