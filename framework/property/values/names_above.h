#pragma once
// Names of the instances that a path goes through.

#include <string>
#include <vector>

#include <fettle/property/tree.h>

namespace fettle::property {

/// The names of a path, the root's left out; none where an instance is detached.
std::vector<std::string> names_above(const Tree& tree, Handle instance);

}  // namespace fettle::property
