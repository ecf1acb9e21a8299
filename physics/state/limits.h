#pragma once

#include <cstddef>

namespace fettle::physics::detail {

/// Gap up to which contacts are made before shapes meet, m.
inline constexpr float speculative_margin = 0.02f;
/// Shapes this close count as touching, m.
inline constexpr float touch_distance = 0.005f;
/// Coordinates and speeds beyond these are cut off: far from where a float resolves a millimetre,
/// near enough that no square of them overflows.
inline constexpr float greatest_coordinate = 1e8f;
inline constexpr float greatest_speed = 1e4f;
/// Friction, and lever of rolling resistance (m), of a contact.
inline constexpr float greatest_grip = 1e6f;
/// Turning in one sub-step, rad.
inline constexpr float greatest_turn = 3.0f;

/// Prefetch distances in loops over awake contacts and bodies, whose records are in no order in
/// memory.
inline constexpr std::size_t contacts_ahead = 12, bodies_ahead = 6;

}  // namespace fettle::physics::detail
