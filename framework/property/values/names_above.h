#pragma once
// Names of the instances on a path.

#include <string>
#include <vector>

#include <fettle/property/tree.h>

namespace fettle::property {

/// The names from below the root down to the instance; empty if the instance is detached.
std::vector<std::string> names_above(const Tree& tree, Handle instance);

}  // namespace fettle::property
