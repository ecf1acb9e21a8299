#pragma once

#include <geometry/vector.h>

#include <span>

namespace fettle::physics::detail {

/// A motion d is allowed if normal·d >= least.
struct Bound {
    Vec2 normal;
    float least = 0.0f;
};

/// The motion nearest to `wanted` that all bounds allow; if there is none, one that violates them
/// evenly.
Vec2 allowed_motion(Vec2 wanted, std::span<const Bound> bounds);

}  // namespace fettle::physics::detail
