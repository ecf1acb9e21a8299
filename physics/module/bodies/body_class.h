#pragma once

#include <vector>

#include <fettle/property/class.h>

namespace fettle::physics_module {

class Hosting;

void define_body(Hosting& hosting);
std::vector<property::Method> body_methods(Hosting& hosting);
/// As in property::Lifecycle; the context is the Hosting.
property::Transform drawn_pose(void* context, const property::Tree& tree, property::Handle self,
                               property::Row row, double alpha);

}  // namespace fettle::physics_module
