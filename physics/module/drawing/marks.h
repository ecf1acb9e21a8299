#pragma once
// Overlays that explain the solver: islands, impulses of contacts, limits of joints.

#include <fettle/physics/world.h>
#include <fettle/property/painter.h>

#include <hosting/hosting.h>

namespace fettle::physics_module {

/// Tints the bodies of each island with a color of its own; sleeping ones are paler and have a "z".
void draw_islands(HostedWorld& in, property::Painter& painter, double alpha);
/// Draws the impulse of each contact point in the last step of `dt` seconds as an arrow: the
/// impulse on body b if that is dynamic, otherwise that on body a. The arrow of the weight of the
/// heaviest dynamic body is about as long as a twelfth of the height of the picture. A scale is
/// drawn below.
void draw_impulses(physics::World& world, double dt, property::Painter& painter);
/// Draws the range of each joint with limits, and its present value.
void draw_limits(HostedWorld& in, property::Painter& painter, double alpha);

}  // namespace fettle::physics_module
