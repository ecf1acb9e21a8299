#pragma once

#include <constraints/joint_ends.h>
#include <constraints/stiffness.h>
#include <solver/motion.h>
#include <state/step_scratch.h>
#include <state/velocity_sums.h>
#include <state/world_state.h>
#include <threads/pool.h>
#include <wide/kernels.h>

// The three solvers: from prepared constraints to the motion of the bodies and to impulses.

namespace fettle::physics::detail {

/// Data that a solver reads and changes.
struct SolverInput {
    const WorldDef& settings;
    ObjectState& objects;  ///< a solver writes the manifolds of wide contacts
    const ActiveLists& active;
    const Strips& strips;
    BodyScratch& bodies;
    JointScratch& joints;
    ContactScratch& contacts;
    ScheduleScratch& schedule;
    ThreadPool* threads;
    std::span<VelocitySums> sums;  ///< of the bodies whose changes of velocity are added up
};

/// Solves with the solver of the settings.
void solve(const SolverInput& input, const JointStep& joint_step, const ContactStiffness& stiffness,
           const WideKernels& kernels, StepStatistics& statistics);

/// Must be called after the contacts were solved with soft constraints. Limits the speeds of bodies
/// in a crowd that is pushed apart.
void limit_pushes(const SolverInput& input, const Columns& columns);
/// Limits in the same way the bodies of deep contacts between bodies that joints hold at something
/// fixed. Puts the contacts of which a body was too fast to the front, and returns their number.
size_t find_jammed(const SolverInput& input, const Columns& columns, std::span<uint32_t> pressed);
/// Must be called after the constraints were solved. Limits the speeds of bodies that are squeezed
/// between bodies that do not yield.
void limit_squeezed(const SolverInput& input, const Columns& columns, float dt);

/// Limits the kinetic energy of groups of bodies that joints and contacts connect, if some of them
/// are pressed together by the contacts `pressed`, or the step lists them: joints press them
/// against obstacles, or they bounced at the same time; or if one of them has joints and has become
/// much faster. `h`: length of a sub-step, s.
void limit_strained(const SolverInput& input, const Columns& columns,
                    std::span<const uint32_t> pressed, float h);

void solve_softly(const SolverInput& input, const JointStep& joint_step,
                  const ContactStiffness& stiffness, const WideKernels& kernels);
void solve_sequentially(const SolverInput& input, const JointStep& joint_step);
/// Counts the solved and the unsolved problems in `statistics`.
void solve_directly(const SolverInput& input, const JointStep& joint_step,
                    StepStatistics& statistics);

// Parts of a sub-step that several solvers use.

/// Begins a sub-step of length `h` for the bodies listed in `which`, as `integrate_velocities`.
void begin_substep(BodyScratch& bodies, std::span<const uint32_t> which, float h,
                   const SubstepLimits& limits, bool again);
/// Begins a sub-step of a solver without warm starting.
void apply_forces(const SolverInput& input, float h);
/// Keeps the velocities of bodies within their locked axes and their maximum speeds.
void zero_locked(const SolverInput& input);
/// Writes direction, levers and gap of curved contacts for the current poses of the bodies.
void follow_curved_contacts(const SolverInput& input);

}  // namespace fettle::physics::detail
