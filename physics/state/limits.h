#pragma once

#include <cstddef>

namespace fettle::physics::detail {

/// Contacts are made when the gap between two shapes is below this, m.
inline constexpr float speculative_margin = 0.02f;
/// Shapes closer than this count as touching, m.
inline constexpr float touch_distance = 0.005f;
/// Coordinates and speeds are clamped to this: beyond the range in which a float resolves a
/// millimetre, and small enough that no square of them overflows.
inline constexpr float greatest_coordinate = 1e8f;
inline constexpr float greatest_speed = 1e4f;
/// Upper bound of the friction of a contact, and of the lever arm of its rolling resistance (m).
inline constexpr float greatest_grip = 1e6f;
/// Maximum rotation in one sub-step, rad.
inline constexpr float greatest_turn = 3.0f;

/// Prefetch distances in loops over awake contacts and bodies, whose records are in no order in
/// memory.
inline constexpr std::size_t contacts_ahead = 12, bodies_ahead = 6;

}  // namespace fettle::physics::detail
