#pragma once

#include <cstddef>

namespace fettle::physics::detail {

/// Contacts are created if the gap between two shapes is smaller than this, m.
inline constexpr float speculative_margin = 0.02f;
/// Shapes closer than this count as touching, m.
inline constexpr float touch_distance = 0.005f;
/// Coordinates and speeds are limited to this: larger than the range in which a float resolves a
/// millimeter, and so small that no square overflows.
inline constexpr float greatest_coordinate = 1e8f;
inline constexpr float greatest_speed = 1e4f;
/// Upper bound of the friction of a contact, and of the lever arm of its rolling resistance (m).
inline constexpr float greatest_grip = 1e6f;
/// Maximum rotation in one sub-step, rad.
inline constexpr float greatest_turn = 3.0f;

/// Prefetch distances in loops over awake contacts and bodies, whose records are in random order in
/// memory.
inline constexpr std::size_t contacts_ahead = 12, bodies_ahead = 6;

}  // namespace fettle::physics::detail
