#pragma once

#include <geometry/vector.h>

#include <span>

namespace fettle::physics::detail {

/// A motion d is allowed if normal·d >= least.
struct Bound {
    Vec2 normal;
    float least = 0.0f;
};

/// No motion differs from the wanted one by more than this, as a multiple of the greatest error of
/// the wanted one. Between two obstacles that press from nearly opposite sides, the nearest motion
/// that both allow may lead out of the end of their wedge, hundreds of meters away.
constexpr float most_evasion = 10.0f;
/// The same between bodies that give way, and for velocities: what closes on a mover like a wedge
/// does not throw it up.
constexpr float least_evasion = 2.0f;

/// The motion nearest to `wanted` that all bounds allow; if there is none, one that violates them
/// evenly.
Vec2 allowed_motion(Vec2 wanted, std::span<const Bound> bounds, float evasion = most_evasion);

}  // namespace fettle::physics::detail
