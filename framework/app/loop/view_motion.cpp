// The view follows an instance, keeps to its limits, and shakes.

#include <loop/view_motion.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fettle/app/view.h>
#include <fettle/property/pose.h>

namespace fettle::app {

using property::Handle;
using property::Property;
using property::Tree;
using property::Type;
using property::Value;
using property::Vec2;

void require_view_height(double height) {
    if (height < view_heights.min || height > view_heights.max)
        throw std::invalid_argument("the height seen would be " + property::number_text(height) +
                                    " m, not between 0.001 and 1e+06 m");
}

std::vector<Property> following_properties() {
    return {
        {.name = "follow",
         .type = Type::reference,
         .doc = "It moves with this instance, from step to step."},
        {.name = "follow_damping",
         .type = Type::number,
         .unit = "s",
         .range = {0, 1e3},
         .doc = "The time in which it makes two thirds of the way to what it follows; 0: it is "
                "always there."},
        {.name = "dead_zone",
         .type = Type::vec2,
         .unit = "m",
         .range = {0, 1e9},
         .doc = "Width and height of the box round the center: while the followed instance is in "
                "this box, the picture does not move."},
        {.name = "limits",
         .type = Type::list,
         .unit = "m",
         .doc = "The lower and the upper corner of the part of the world that may be seen; empty: "
                "all of it. If that part is smaller than what is seen, it is in the middle.",
         .element = Type::vec2},
        {.name = "shake_amount",
         .type = Type::number,
         .unit = "m",
         .range = {0, 1e6},
         .doc = "How far the picture is moved at the beginning of a shake.",
         .hidden = true},
        {.name = "shake_length",
         .type = Type::number,
         .unit = "s",
         .range = {0, 1e6},
         .doc = "How long the last shake lasts.",
         .hidden = true},
        {.name = "shake_left",
         .type = Type::number,
         .unit = "s",
         .range = {0, 1e6},
         .doc = "How long the picture will be shaken; `shake` begins it.",
         .hidden = true}};
}

property::Method shake_method() {
    return {.name = "shake",
            .parameters = {{.name = "amount",
                            .type = Type::number,
                            .unit = "m",
                            .doc = "How far the picture is moved at the beginning.",
                            .range = {0, 1e6}},
                           {.name = "seconds",
                            .type = Type::number,
                            .unit = "s",
                            .doc = "How long it takes to come to rest; 0.5 if it is left out.",
                            .range = {0, 1e6}}},
            .required = 1,
            .doc =
                "Shakes the picture, for an explosion or a blow. Only what is drawn moves; a "
                "weaker shake does not end a stronger one.",
            .call = [](void*, Tree& tree, Handle self, property::Row,
                       std::span<const Value> arguments) -> property::Result {
                const double amount = arguments[0].number();
                const double seconds = arguments[1].is_nil() ? 0.5 : arguments[1].number();
                if (!(amount >= 0 && amount <= 1e6 && seconds >= 0 && seconds <= 1e6))
                    throw std::invalid_argument("expected an amount and a time from 0 to 1e+06");
                const auto now = [&](const char* name) { return tree.get(self, name).number(); };
                const double length = now("shake_length");
                if (length > 0 && amount < now("shake_amount") * now("shake_left") / length)
                    return Value();
                tree.set(self, "shake_amount", Value(amount));
                tree.set(self, "shake_length", Value(seconds));
                tree.set(self, "shake_left", Value(seconds));
                return Value();
            },
            .effect = property::Effect::tree};
}

Vec2 world_position(const Tree& tree, Handle instance) {
    return property::place_below(tree, instance, false, 1).value_or(property::Transform()).origin;
}

void View::advance(const Tree& tree, double dt) {
    if (follow && tree.alive(follow)) {
        const Vec2 way = world_position(tree, follow) - center;
        // Only the part of the way outside of the dead zone counts.
        const Vec2 half = 0.5 * dead_zone;
        const Vec2 beyond = way - way.max(-half).min(half);
        const double share = follow_damping > 0 ? 1 - std::exp(-dt / follow_damping) : 1;
        const Vec2 next = center + share * beyond;
        if (next.is_finite()) center = next;
    }
    keep_to_limits();
    center = center.max({-1e9, -1e9}).min({1e9, 1e9});
    shake_left = std::max(0.0, shake_left - dt);
    step_length = dt;
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

bool View::follows_without_delay(const Tree& tree) const {
    return follow && tree.alive(follow) && follow_damping == 0 && dead_zone == Vec2(0, 0);
}

View View::drawn(const Tree& tree, double alpha) const {
    View seen = *this;
    const property::Placement at = track.drawn(placement(), alpha, far());
    seen.center = at.position;
    seen.angle = at.angle;
    seen.height = at.scale;
    // What it follows stays in its middle, unless the game has put the center elsewhere since.
    if (track.is_left_at(center) && follows_without_delay(tree))
        if (const auto place = property::place_below(tree, follow, false, alpha)) {
            seen.center = place->origin;
            seen.keep_to_limits();
        }
    if (shake_left > 0 && shake_length > 0) {
        const double left = std::min(shake_left + (1 - alpha) * step_length, shake_length);
        const double size = shake_amount * left / shake_length, since = shake_length - left;
        // Two vibrations without a common period, so that the motion does not repeat.
        seen.center += size * Vec2(std::sin(71 * since), std::sin(97 * since + 1));
    }
    return seen;
}

}  // namespace fettle::app
