// The view follows an instance, keeps to its limits, and shakes.

#include <fettle/app/view.h>

#include <algorithm>
#include <cmath>

#include <fettle/property/pose.h>

namespace fettle::app {

using property::Handle;
using property::Tree;
using property::Vec2;

Vec2 world_position(const Tree& tree, Handle instance) {
    return property::place_below(tree, instance, false, 1).value_or(property::Transform()).origin;
}

void View::advance(const Tree& tree, double dt) {
    center_before_ = center;
    if (follow && tree.alive(follow)) {
        const Vec2 way = world_position(tree, follow) - center;
        // As far as it is outside of the dead zone.
        const Vec2 half = 0.5 * dead_zone;
        const Vec2 beyond = way - way.max(-half).min(half);
        const double share = follow_damping > 0 ? 1 - std::exp(-dt / follow_damping) : 1;
        const Vec2 next = center + share * beyond;
        if (next.is_finite()) center = next.max({-1e9, -1e9}).min({1e9, 1e9});
    }
    keep_to_limits();
    center_after_ = center;
    shake_left = std::max(0.0, shake_left - dt);
}

void View::keep_to_limits() {
    if (limits.size() != 2) return;
    const Vec2 half = reach();
    for (int axis = 0; axis < 2; ++axis) {
        const double lowest = limits[0][axis] + half[axis], highest = limits[1][axis] - half[axis];
        center[axis] =
            lowest > highest ? 0.5 * (lowest + highest) : std::clamp(center[axis], lowest, highest);
    }
}

View View::drawn(double alpha, double now) const {
    View seen = *this;
    // Unless the game has put the center elsewhere since the step.
    if (center == center_after_)
        seen.center = center_before_ + alpha * (center_after_ - center_before_);
    if (shake_left > 0 && shake_length > 0) {
        const double size = shake_amount * std::min(1.0, shake_left / shake_length);
        // Two vibrations whose periods do not fit together.
        seen.center += size * Vec2(std::sin(71 * now), std::sin(97 * now + 1));
    }
    return seen;
}

}  // namespace fettle::app
