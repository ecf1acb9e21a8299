#pragma once

#include <vector>

#include <fettle/property/class.h>

namespace fettle::physics_module {

class Hosting;
struct ShapeKind;

void define_shapes(Hosting& hosting);  // Shape and all classes that derive from it
void define_shape(Hosting& hosting);
property::Property orientation_mark(Hosting& hosting);                   // of round shapes
std::vector<property::Property> surfaces_of_segments(Hosting& hosting);  // of chains
property::Lifecycle shape_lifecycle(ShapeKind& kind);

}  // namespace fettle::physics_module
