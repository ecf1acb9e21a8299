#pragma once
// Descriptions of the events of worlds, bodies and shapes.

#include <string_view>
#include <vector>

#include <fettle/property/class.h>

namespace fettle::physics_module {

std::vector<property::Event> contact_events(std::string_view of);  // "body" or "shape"
std::vector<property::Event> world_events();

}  // namespace fettle::physics_module
