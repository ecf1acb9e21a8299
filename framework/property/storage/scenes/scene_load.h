#pragma once
// A scene that names instances which may come later than the scene itself.

#include <string>
#include <string_view>
#include <vector>

#include <fettle/property/tree.h>

#include <json/document.h>

namespace fettle::property {

/// A property that a scene gives a value with a reference that leads nowhere yet.
struct OpenReference {
    Handle instance;
    std::string property;
    const Document::Node* node;  // the whole value
};

/// As `load_scene_text`, but such a property is left as it is, and told in `open`.
Handle load_scene_document(Tree& tree, const Document& document, Handle parent,
                           std::string_view name, std::vector<OpenReference>& open);

/// The same as an edit of the writer of this moment, so that it can be undone.
Handle make_scene(Tree& tree, const Document& document, Handle parent, std::string_view name,
                  std::vector<OpenReference>& open);

}  // namespace fettle::property
