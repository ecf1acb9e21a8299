#pragma once

#include <constraints/joint_ends.h>
#include <constraints/stiffness.h>
#include <state/step_scratch.h>
#include <state/world_state.h>
#include <threads/pool.h>
#include <wide/kernels.h>

// The three solvers: from prepared constraints to the motion of the bodies and to impulses.

namespace fettle::physics::detail {

/// What a solver reads and changes.
struct SolverInput {
    const WorldDef& settings;
    ObjectState& objects;  ///< it writes the manifolds of wide contacts
    const ActiveLists& active;
    const Strips& strips;
    BodyScratch& bodies;
    JointScratch& joints;
    ContactScratch& contacts;
    ScheduleScratch& schedule;
    ThreadPool* threads;
};

/// Solves with the solver of the settings.
void solve(const SolverInput& input, const JointStep& joint_step, const ContactStiffness& stiffness,
           const WideKernels& kernels, StepStatistics& statistics);

void solve_softly(const SolverInput& input, const JointStep& joint_step,
                  const ContactStiffness& stiffness, const WideKernels& kernels);
void solve_sequentially(const SolverInput& input, const JointStep& joint_step);
/// Counts in `statistics` how many problems were solved and how many were not.
void solve_directly(const SolverInput& input, const JointStep& joint_step,
                    StepStatistics& statistics);

// Parts of a sub-step that the solvers share.

/// How the solvers without warm starting begin a sub-step.
void apply_forces(const SolverInput& input, float h);
/// Takes from the bodies with a locked axis what velocity they have along it.
void zero_locked(const SolverInput& input);
/// Writes direction, levers and gap of curved contacts for where the bodies are now.
void follow_curved_contacts(const SolverInput& input);

}  // namespace fettle::physics::detail
