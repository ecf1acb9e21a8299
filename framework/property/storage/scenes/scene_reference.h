#pragma once
// References in scene files: paths from the top of the scene (`.ball.circle`) or from the root.

#include <string>

#include <fettle/property/tree.h>

#include <json/document.h>

namespace fettle::property {

/// The scene a reference stands in. Its topmost instance may hang nowhere yet: an absolute path may
/// lead to where it is about to be, below `parent` under `name`.
struct SceneBeingLoaded {
    const Tree& tree;
    const Document& document;
    Handle top;
    Handle parent;
    std::string name;
};

/// Throws SceneError at `node` for what is no path, or leads nowhere.
Handle find_reference(const SceneBeingLoaded& scene, const std::string& path,
                      const Document::Node& node);

}  // namespace fettle::property
