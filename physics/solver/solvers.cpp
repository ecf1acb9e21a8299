// Selection of the solver, and parts of a sub-step that several solvers use.

#include <solver/motion.h>
#include <solver/solvers.h>
#include <state/limits.h>

namespace fettle::physics::detail {

namespace {

void solve_constraints(const SolverInput& input, const JointStep& joint_step,
                       const ContactStiffness& stiffness, const WideKernels& kernels,
                       StepStatistics& statistics) {
    statistics.direct_solves = statistics.direct_failures = 0;
    switch (input.settings.solver) {
        case Solver::soft_step:
            return solve_softly(input, joint_step, stiffness, kernels);
        case Solver::sequential:
            return solve_sequentially(input, joint_step);
        case Solver::direct:
            return solve_directly(input, joint_step, statistics);
    }
}

}  // namespace

void solve(const SolverInput& input, const JointStep& joint_step, const ContactStiffness& stiffness,
           const WideKernels& kernels, StepStatistics& statistics) {
    solve_constraints(input, joint_step, stiffness, kernels, statistics);
    input.bodies.attractions.finish(input.bodies.solver_forces, input.settings.substeps);
}

void begin_substep(BodyScratch& bodies, std::span<const uint32_t> which, float h,
                   const SubstepLimits& limits, bool again) {
    if (!bodies.attractions.empty())
        bodies.attractions.follow(which, bodies.solver_bodies, bodies.solver_forces, h,
                                  greatest_speed);
    integrate_velocities(which, bodies.solver_bodies, bodies.solver_forces, limits, again);
}

void apply_forces(const SolverInput& input, float h) {
    BodyScratch& bodies = input.bodies;
    const SolverBlocks& blocks = input.schedule.blocks;
    begin_substep(bodies, blocks.bodies_of(blocks[0]), h,
                  {input.settings.max_speed, greatest_turn / h}, false);
    zero_locked(input);
    bodies.solver_bodies[0] = {};
}

void zero_locked(const SolverInput& input) {
    for (const uint32_t i : input.bodies.locked) {
        const BodyRecord& record = input.objects.bodies[input.active.awake_bodies[i - 1]];
        input.objects.limit_velocity(record, input.bodies.solver_bodies[i]);
    }
}

void follow_curved_contacts(const SolverInput& input) {
    SingleContacts& contacts = input.contacts.serial;
    if (contacts.rolling_contacts.empty()) return;
    const std::vector<SolverBody>& bodies = input.bodies.solver_bodies;
    for (ContactConstraint& c : contacts.constraints) {
        const uint32_t rolling = c.extra != 0 ? contacts.extras[c.extra - 1].rolling : 0;
        if (rolling != 0)
            contacts.rolling_contacts[rolling - 1].follow(c, bodies[c.a], bodies[c.b]);
    }
}

}  // namespace fettle::physics::detail
