#pragma once
// Scenes that are to become part of another one.

#include <string>
#include <vector>

#include <fettle/property/tree.h>

namespace fettle::property {

/// As `scene_text`, but references to what is inside are paths from the root as well, so that they
/// hold wherever the text stands in a file.
std::string scene_text_with_full_paths(const Tree& tree, Handle node,
                                       std::vector<std::string>* warnings);

}  // namespace fettle::property
