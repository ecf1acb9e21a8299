#pragma once

#include <solver/solvers.h>

// The motion with which the limits of the speed of a body are computed.

namespace fettle::physics::detail {

/// The velocity that a body would have after the step without contacts and joints.
struct FreeMotion {
    Vec2 velocity;
    float turn = 0.0f;

    explicit FreeMotion(const BodyState& state)
        : velocity(state.velocity), turn(state.angular_velocity) {}
    FreeMotion(const BodyState& state, const SolverForce& force, float substeps)
        : velocity(state.velocity + substeps * force.change),
          turn(state.angular_velocity + substeps * force.turn_change) {}

    static FreeMotion of(const SolverInput& input, const Columns& columns, uint32_t body) {
        const uint32_t index = input.objects.bodies[body].solver_index;
        if (index == 0) return FreeMotion(columns.states[body]);
        return {columns.states[body], input.bodies.solver_forces[index],
                float(input.settings.substeps)};
    }
    /// Of a point with this lever arm from the center of mass.
    Vec2 at(Vec2 arm) const { return velocity + turn * Vec2{-arm.y, arm.x}; }
};

}  // namespace fettle::physics::detail
