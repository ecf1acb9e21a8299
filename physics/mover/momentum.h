#pragma once

#include <mover/moving.h>

// The impulses and forces by which a mover and the dynamic bodies around it exchange momentum.

namespace fettle::physics::detail {

/// A dynamic body on which a mover stands, and where; `none`: on no such body.
struct Footing {
    uint32_t body = none;
    Position point;
};

/// Velocity of the surface of a conveyor belt, along its surface, m/s. `part`: the segment, if the
/// shape is a chain.
Vec2 belt_velocity(const WorldData& data, uint32_t shape, uint32_t part, Vec2 normal);

/// Pushes a dynamic body: the impulse of a collision with a mover of this velocity (m/s), limited
/// by its `push_force`. The ground of the mover gets the opposite impulse.
void push_body(World& world, const MoverDef& def, const Push& push, const Footing& footing,
               Vec2 velocity, float dt);

/// Gives a dynamic body the impulse of a mover that lands on it with this velocity (m/s): that of
/// an inelastic collision. `normal`: of the ground.
void land_on(World& world, const MoverDef& def, const Footing& footing, Vec2 normal, Vec2 velocity);

/// Gives a dynamic body the inertia of the mover that stands on it. It does nothing on other
/// ground. `dt`: of the step, s.
void hold_ground(World& world, const MoverDef& def, const MoverState& state, float dt);

/// Gives the weight of the mover to the body on which it stands. `own`: the body of the
/// mover, or `none`.
void press_on_ground(World& world, const MoverDef& def, const Footing& footing, uint32_t own);

}  // namespace fettle::physics::detail
