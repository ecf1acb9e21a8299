#pragma once
// Text of scenes that become a part of another scene.

#include <functional>
#include <string>
#include <vector>

#include <fettle/property/tree.h>

namespace fettle::property {

/// Like `scene_text`, but all references are paths from the root. So they stay valid wherever the
/// text is placed in a file. `left_out`: whether an instance below `node` is not written, nor what
/// is below it.
std::string scene_text_with_full_paths(const Tree& tree, Handle node,
                                       std::vector<std::string>* warnings,
                                       const std::function<bool(Handle)>& left_out = {});

}  // namespace fettle::property
