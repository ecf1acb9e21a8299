// The plane solver. In the plane, the nearest allowed motion is the wanted one, its projection on
// one bound, or the corner of two: all of these are tried, which is exact.

#include <fettle/physics/mover.h>
#include <mover/planes.h>

#include <cmath>
#include <optional>

namespace fettle::physics {
namespace detail {
namespace {

constexpr float tolerance = 1e-5f;

bool allows(std::span<const Bound> bounds, Vec2 motion) {
    for (const Bound& bound : bounds)
        if (dot(bound.normal, motion) < bound.least - tolerance) return false;
    return true;
}

/// The point on both bounds; none if they are parallel.
std::optional<Vec2> corner(const Bound& a, const Bound& b) {
    const float k = cross(a.normal, b.normal);
    if (std::fabs(k) < 1e-4f) return std::nullopt;
    return (1.0f / k) * Vec2{a.least * b.normal.y - b.least * a.normal.y,
                             b.least * a.normal.x - a.least * b.normal.x};
}

/// Distributes the error over all bounds: each round moves by a part of the sum of their errors.
Vec2 between(std::span<const Bound> bounds) {
    Vec2 motion;
    const float part = 1.0f / max(2.0f, float(bounds.size()));
    for (int round = 0; round < 64; ++round) {
        Vec2 sum;
        for (const Bound& bound : bounds)
            sum = sum + max(0.0f, bound.least - dot(bound.normal, motion)) * bound.normal;
        motion = motion + part * sum;
    }
    return motion;
}

}  // namespace

Vec2 allowed_motion(Vec2 wanted, std::span<const Bound> bounds, float evasion) {
    if (allows(bounds, wanted)) return wanted;
    float error = 0.0f;
    for (const Bound& bound : bounds) error = max(error, bound.least - dot(bound.normal, wanted));
    std::optional<Vec2> best;
    float least = evasion * evasion * error * error;
    const auto consider = [&](Vec2 motion) {
        const float far = length_squared(motion - wanted);
        if (far >= least || !allows(bounds, motion)) return;
        best = motion;
        least = far;
    };
    for (size_t i = 0; i < bounds.size(); ++i) {
        const Bound& a = bounds[i];
        consider(wanted + (a.least - dot(a.normal, wanted)) * a.normal);
        for (size_t k = i + 1; k < bounds.size(); ++k)
            if (const auto both = corner(a, bounds[k])) consider(*both);
    }
    return best ? *best : bounded(between(bounds), evasion * error);
}

}  // namespace detail

using namespace detail;

Vec2 solve_planes(const Vec2& motion, std::span<const MoverPlane> planes, float distance) {
    std::vector<Bound> bounds;
    for (const MoverPlane& plane : planes)
        bounds.push_back({plane.normal, distance - plane.separation});
    return allowed_motion(motion, bounds);
}

Vec2 clip_velocity(const Vec2& velocity, std::span<const MoverPlane> planes) {
    std::vector<Bound> bounds;
    for (const MoverPlane& plane : planes) bounds.push_back({plane.normal, 0.0f});
    return allowed_motion(velocity, bounds);
}

}  // namespace fettle::physics
