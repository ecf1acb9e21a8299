#pragma once

#include <solver/solvers.h>

#include <span>

// Sums of impulses for the few bodies whose changes of velocity the user asked for. The passes of
// the solver are the same with and without them: after each sub-step, the impulses of the
// constraints on these bodies are added. A step without such bodies does none of this.

namespace fettle::physics::detail {

/// Begins the sums of a step, after the forces were gathered. `h`: sub-step, s.
void begin_sums(const SolverInput& input, const Columns& columns, uint64_t steps, float h);
/// Adds an impulse of a joint on a body that belongs to no sub-step. `on`: the impulses along x and
/// y, and the angular impulse, of an impulse of 1.
void add_to_joint(std::span<VelocitySums> all, uint32_t joint, uint32_t solver_body,
                  const double (&on)[3], double impulse);
/// To be called before the first sub-step of a block, after its bounces.
void begin_substeps(const SolverInput& input, const SolverBlock& block);
/// To be called after the biased pass of a sub-step of the first block: the levers of joints and of
/// curved contacts change then.
void add_biased(const SolverInput& input);
/// To be called after each sub-step of a block. `wide` has the wide contacts of the block.
void add_substep(const SolverInput& input, const SolverBlock& block, WideBlock& wide);
/// Ends the sums after the solver, while all contacts of the step still exist.
void end_sums(const SolverInput& input, const Columns& columns);
/// To be called when the bodies are finished.
void store_velocities_after(std::span<VelocitySums> all, const Columns& columns);

}  // namespace fettle::physics::detail
