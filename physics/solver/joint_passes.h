#pragma once

#include <state/step_scratch.h>
#include <state/world_state.h>
#include <threads/pool.h>

// A step writes the joints that act into constraints, by type and in the order of the nodes they
// belong to, solves those of some nodes at a time, and reads their impulses back.

namespace fettle::physics::detail {

JointStep prepare_joints(ObjectState& objects, const Columns& columns, const ActiveLists& active,
                         const BodyScratch& bodies, JointScratch& joints, float h,
                         float impulse_ratio, ThreadPool* threads);
/// Which bodies have joints, for `JointShare`.
void find_jointed(JointScratch& joints, const Strips& strips);

// Passes over the joints of some nodes.
void warm_start_joints(JointScratch& joints, std::span<SolverBody> bodies, const StripNodes& nodes);
void solve_joints(JointScratch& joints, std::span<SolverBody> bodies, const JointStep& step,
                  const StripNodes& nodes);
void relax_joints(JointScratch& joints, std::span<SolverBody> bodies, const JointStep& step,
                  const StripNodes& nodes);

/// After each sub-step: adds up what the joints that can break bore.
void strain_joints(const ObjectState& objects, JointScratch& joints);
void store_joints(ObjectState& objects, const JointScratch& joints, const JointStep& step,
                  ThreadPool* threads);

}  // namespace fettle::physics::detail
