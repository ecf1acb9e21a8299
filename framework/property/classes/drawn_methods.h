#pragma once

#include <vector>

#include <fettle/property/class.h>

namespace fettle::property {

/// The methods of all instances that say where they are drawn.
std::vector<Method> drawn_methods();

}  // namespace fettle::property
