#pragma once
// References in scene files: paths from the top of the scene (`.ball.circle`) or from the root.

#include <string>

#include <fettle/property/tree.h>

#include <json/document.h>

namespace fettle::property {

/// The scene that contains a reference. Its topmost instance may be detached: an absolute path may
/// lead to its future place, below `parent` with the name `name`.
struct SceneBeingLoaded {
    const Tree& tree;
    const Document& document;
    Handle top;
    Handle parent;
    std::string name;
};

/// Throws SceneError at `node` if the text is not a path or leads nowhere.
Handle find_reference(const SceneBeingLoaded& scene, const std::string& path,
                      const Document::Node& node);

}  // namespace fettle::property
