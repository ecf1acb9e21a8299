#pragma once

#include <vector>

#include <fettle/property/class.h>

namespace fettle::physics_module {

class Hosting;

void define_body(Hosting& hosting);
std::vector<property::Method> body_methods(Hosting& hosting);

}  // namespace fettle::physics_module
