#pragma once

#include <solver/constraint.h>

#include <vector>

namespace fettle::physics::detail {

/// A mouse joint during a step: pulls one point of a body towards a target, softly, and brakes its
/// turning a little.
struct MouseConstraint {
    uint32_t body = 0;   ///< solver body
    uint32_t joint = 0;  ///< record to store into
    V2 lever;            ///< from the center of mass to the anchor, world axes
    V2 gap;              ///< anchor minus target at the start of the step
    V2 impulse;
    float greatest_impulse = 0.0f;
    Softness softness;
    float mass_xx = 0.0f, mass_xy = 0.0f, mass_yy = 0.0f;  ///< inverse of the effective mass matrix

    void prepare(const SolverBody& body);
    void warm_start(SolverBody& body) const;
    void solve(SolverBody& body);

  private:
    void apply(SolverBody& body, V2 p) const;
};

}  // namespace fettle::physics::detail
