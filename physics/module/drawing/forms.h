#pragma once
// Drawing of shapes.

#include <fettle/physics/world.h>
#include <fettle/property/painter.h>

#include <drawing/drawn_pose.h>

namespace fettle::physics_module {

/// A box in the world, in double precision.
struct Extent {
    property::Vec2 lower, upper;
};

/// The box around a shape in this frame.
Extent extent_of(const physics::Shape& shape, const Frame& frame);

/// Whether the shape has no inside: it is drawn as lines with the color of the fill.
bool is_line(const physics::Shape& shape);

/// Draws a shape of any geometry.
void draw_form(const physics::Shape& shape, const Frame& frame, const property::Paint& paint,
               property::Painter& painter);

/// Draws the mark that shows the rotation of a round shape.
void draw_mark(const physics::Shape& shape, const Frame& frame, const property::Paint& paint,
               property::Painter& painter);

}  // namespace fettle::physics_module
