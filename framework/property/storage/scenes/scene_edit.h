#pragma once
// Edits of a scene file that leave the rest of its text unchanged.

#include <string>
#include <vector>

#include <fettle/property/tree.h>

#include <json/json_edit.h>
#include <scenes/image.h>
#include <scenes/scene_origins.h>
#include <values/instance_paths.h>

namespace fettle::property {

class SceneEdit {
  public:
    /// Throws SceneError for a text that is not a scene.
    SceneEdit(const Tree& tree, std::string text, std::string file_name);
    const std::string& text() const { return json_.text(); }
    const Document& document() const { return json_.document(); }

    struct NamingValue {
        SceneSteps steps;
        const Document::Node *section, *node;  // `node` is the value
        std::string forgotten;                 // the value with its references replaced by null
    };
    /// Every value in which `path` changes a reference.
    std::vector<NamingValue> naming_values(const NewPath& path) const;

    /// Replaces references to the instances (paths as in the file), and to those below them, by
    /// null. Returns the old values as the elements of a list for `put_references_back`.
    std::string forget_references(const std::vector<std::string>& paths);
    /// Restores the references that are still null; `list` is a list of `document`.
    void put_references_back(const Document& document, const Document::Node& list);

    // Each function throws Error if the file does not contain the instance.

    /// `written`: replaces paths that begin at the root; none: all paths stay.
    void set(const SceneSteps& steps, const std::string& property, const Image& image,
             const NewPath& written = {});
    /// `scene`: the text of the new child as a scene of its own.
    void add_child(const SceneSteps& steps, const std::string& scene);
    /// Returns the removed text for `put_back`. `home`: the path from the root, which references in
    /// the file may use.
    std::string remove(const SceneSteps& steps, const std::string& home = {});
    void put_back(const SceneSteps& steps, const std::string& taken_out);
    /// Sets the references of the instance and of those below it to those of another scene.
    void name_as_in(const SceneSteps& steps, const SceneEdit& other, const SceneSteps& other_steps);
    /// The text of a value; "null" if the file has none.
    std::string value(const SceneSteps& steps, const std::string& property) const;
    void rename(const SceneSteps& steps, const std::string& name);

  private:
    using Node = Document::Node;
    /// Null if the text has no value there.
    const Node* value_node(const SceneSteps& steps, const std::string& property) const;
    const Node* find_or_none(const SceneSteps& steps) const;
    const Node& find(const SceneSteps& steps) const;
    const Node* child(const Node& instance, const SceneStep& step) const;
    void put_reference_back(const Document& before, const Node& reference);
    void add_first_child(const Node& parent, std::string text);
    void require_names_beside(const Node& instance, const Node& children) const;
    void require_not_given(const std::string& name, const Node& instance,
                           const Node& children) const;
    [[noreturn]] void refuse_without_name(const Node& node) const;
    void set_member(const SceneSteps& steps, const Property* declared, const std::string& property,
                    const std::string& value);
    const Node* member_before(const Node& section, const Class& of, const Property& property) const;
    void remove_member(const SceneSteps& steps, const std::string& section,
                       const std::string& property);

    const Tree* tree_;
    JsonEdit json_;
};

}  // namespace fettle::property
