#pragma once
// Names of the instances on a path.

#include <cstddef>
#include <string>
#include <vector>

#include <fettle/property/tree.h>

namespace fettle::property {

/// Of a path or a pattern. A tree has 1000 levels, so longer ones lead nowhere and only take
/// memory.
inline constexpr std::size_t most_names = 2000;

/// The names from below the root down to the instance; empty if the instance is detached.
std::vector<std::string> names_above(const Tree& tree, Handle instance);

}  // namespace fettle::property
