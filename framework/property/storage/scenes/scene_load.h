#pragma once
// Loading of a scene whose references may lead to instances that are made later.

#include <string>
#include <string_view>
#include <vector>

#include <fettle/property/tree.h>

#include <json/document.h>

namespace fettle::property {

/// A property whose value in a scene contains a reference that leads nowhere yet.
struct OpenReference {
    Handle instance;
    std::string property;
    const Document::Node* node;  // the complete value
};

/// Like `load_scene_text`, but such a property is not set and is added to `open`.
Handle load_scene_document(Tree& tree, const Document& document, Handle parent,
                           std::string_view name, std::vector<OpenReference>& open);

/// The same as an edit by the current writer, so that it can be undone.
Handle make_scene(Tree& tree, const Document& document, Handle parent, std::string_view name,
                  std::vector<OpenReference>& open);

}  // namespace fettle::property
