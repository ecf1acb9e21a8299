#pragma once

#include <fettle/property/class.h>
#include <fettle/property/painter.h>

namespace fettle::physics_module {

// As in property::Lifecycle; the context of a shape is its ShapeKind, else the Hosting.
void draw_shape(void* context, const property::Tree& tree, property::Handle self, property::Row row,
                property::Painter& painter, double alpha);
/// Draws the capsule of a mover; the context is the Hosting.
void draw_mover(void* context, const property::Tree& tree, property::Handle self, property::Row row,
                property::Painter& painter, double alpha);
void draw_world_overlays(void* context, const property::Tree& tree, property::Handle self,
                         property::Row row, property::Painter& painter, double alpha);

}  // namespace fettle::physics_module
