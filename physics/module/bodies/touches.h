#pragma once
// The touches of a body as state: lists that can be watched, and one record for each touch.

#include <vector>

#include <fettle/property/class.h>

namespace fettle::physics_module {

class Hosting;

std::vector<property::Property> touch_properties(Hosting& hosting);
property::Method touches_method(Hosting& hosting);

}  // namespace fettle::physics_module
