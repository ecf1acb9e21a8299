#pragma once

#include <state/joint_kind.h>

#include <cstdint>
#include <vector>

// Light bodies between joints that bear a heavy load.
//
// A body that a joint pulls at the lever r with the force F turns back like a pendulum when it
// turns aside: its geometric stiffness is k = r·F, and it swings with ω = √(k/I). The sub-steps
// cannot follow a light link under a heavy load: from h·ω = 2 on, each swing is wider than the one
// before, until the chain flies apart. Such a body turns as if its moment of inertia were h²·k/½,
// that is with h·ω = 0.7 at most. The motion of the load hardly changes, because its mass is a
// large multiple of that of the link. (S. Andrews, M. Teichmann, J. Kövecses, "Geometric Stiffness
// for Real-time Constrained Multibody Dynamics", 2017.)

namespace fettle::physics::detail {

/// The geometric stiffness of each solver body, N·m/rad.
class GeometricStiffness {
  public:
    /// Begins again, for a number of bodies.
    void reset(size_t bodies) { stiffness_.assign(bodies, 0.0f); }

    /// Adds the part of a joint that pulls body b with `force`, N, and body a with its opposite.
    void add(const JointEnds& ends, Vec2 force) {
        stiffness_[ends.a] -= dot(ends.lever_a, force);
        stiffness_[ends.b] += dot(ends.lever_b, force);
    }

    /// The inverse moment of inertia with which a body of the inverse moment `inverse` turns in
    /// sub-steps of `h`, s.
    float inverse_inertia(uint32_t body, float inverse, float h) const {
        const float least = h * h * stiffness_[body];
        return least * inverse > greatest_square ? greatest_square / least : inverse;
    }

    /// True if the pull of a joint is so strong that the inertia of one of its bodies may be too
    /// small for the joints of that body together.
    static bool may_be_too_great(const JointEnds& ends, Vec2 force, const SolverBody& a,
                                 const SolverBody& b, float h) {
        const float of_a = -dot(ends.lever_a, force) * a.inverse_inertia;
        const float of_b = dot(ends.lever_b, force) * b.inverse_inertia;
        return h * h * max(of_a, of_b) > greatest_square / most_joints;
    }

  private:
    static constexpr float greatest_square = 0.5f;  ///< of h·ω
    static constexpr float most_joints = 4.0f;      ///< that pull a light body alike

    std::vector<float> stiffness_;
};

/// Raises the moments of inertia of the solver's bodies for the forces with which the joints ended
/// the step before, and if `far` for long levers (long_levers.h). Prepares the joints of these
/// bodies again.
void raise_inertia(const JointSource& source, const JointStep& step, JointScratch& joints,
                   BodyScratch& bodies, bool far);

}  // namespace fettle::physics::detail
