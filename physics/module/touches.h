#pragma once
// What a body touches, as state: lists that can be watched, and one record a touch.

#include <vector>

#include <fettle/property/class.h>

namespace fettle::physics_module {

class Hosting;

std::vector<property::Property> touch_properties(Hosting& hosting);
property::Method touches_method(Hosting& hosting);

}  // namespace fettle::physics_module
