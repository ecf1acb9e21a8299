#pragma once
// The classes that the module registers; each is described in a file of its own.

#include <fettle/property/class.h>

namespace fettle::physics_module {

class Hosting;
struct ShapeKind;

void define_step_statistics(Hosting& hosting);  // before World
void define_world(Hosting& hosting);
void define_body(Hosting& hosting);
void define_shape(Hosting& hosting);
void define_shapes(Hosting& hosting);  // Shape and all classes that derive from it
void define_joints(Hosting& hosting);  // Joint and all classes that derive from it
void define_fields(Hosting& hosting);  // Field and all classes that derive from it

property::Lifecycle shape_lifecycle(ShapeKind& kind);
std::vector<property::Method> world_methods(Hosting& hosting);
std::vector<property::Event> world_events();
std::vector<property::Method> body_methods(Hosting& hosting);
std::vector<property::Event> contact_events(std::string_view of);  // "body" or "shape"

// As in property::Lifecycle; the context of a shape is its ShapeKind, else the Hosting.
void draw_shape(void* context, const property::Tree& tree, property::Handle self, property::Row row,
                property::Painter& painter, double alpha);
void draw_world_overlays(void* context, const property::Tree& tree, property::Handle self,
                         property::Row row, property::Painter& painter, double alpha);

}  // namespace fettle::physics_module
