#pragma once

#include <geometry/vector.h>

#include <cmath>

// Slow bodies that a force draws, as gravity does on a slope or on a lever. Their velocity changes
// in one direction all the time: they come to a halt and turn back, or tip over, and are fast soon.
// A body that trembles, creeps or settles has no such direction.

namespace fettle::physics::detail {

/// True if a force draws a body. `first`, `second`: the mean velocities of its center in two times
/// of `half` seconds, one after the other, m/s; `last`: the velocity at their end. `slow`: its
/// speed of rest, m/s. `drawn_time`: s for which it was slow and drawn before; what is still slow
/// when a drawn body would be fast rocks in place.
inline bool is_drawn(float slow, float half, Vec2 first, Vec2 second, Vec2 last, float drawn_time) {
    // A smaller change is none: parts of the speed of rest. What trembles turns back, too.
    constexpr float noticeable = 0.05f, noticeable_back = 0.15f;
    // The change from the second mean velocity to the last velocity is half of that between the
    // means at a steady acceleration, less in a body that settles, more in one that tips over.
    constexpr float least = 0.45f, most = 2.0f, most_across = 0.3f;
    // From the speed of rest to a halt and back to it, a steady acceleration takes 2.
    constexpr float most_time = 3.0f;

    const Vec2 change = second - first, later = last - second;
    const float square = length_squared(change);
    const float least_change = slow * (dot(first, change) < 0.0f ? noticeable_back : noticeable);
    if (square < least_change * least_change) return false;
    const float along = dot(later, change);
    const float across = length_squared(later) * square - along * along;
    return along > least * square && along < most * square &&
           across < most_across * most_across * square * square &&
           drawn_time * std::sqrt(square) < most_time * slow * half;
}

}  // namespace fettle::physics::detail
