#pragma once

#include <vector>

#include <fettle/property/class.h>

namespace fettle::physics_module {

class Hosting;

void define_step_statistics(Hosting& hosting);  // before World
void define_world(Hosting& hosting);
std::vector<property::Method> world_methods(Hosting& hosting);
property::Method ghosts_method(Hosting& hosting);

}  // namespace fettle::physics_module
