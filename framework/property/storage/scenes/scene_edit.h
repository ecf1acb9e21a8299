#pragma once
// Changes of a scene file that leave the rest of it as somebody wrote it.

#include <string>
#include <vector>

#include <fettle/property/tree.h>

#include <json/json_edit.h>
#include <scenes/image.h>
#include <scenes/instance_paths.h>
#include <scenes/scene_origins.h>

namespace fettle::property {

class SceneEdit {
  public:
    /// Throws SceneError for a text that is no scene.
    SceneEdit(const Tree& tree, std::string text, std::string file_name);
    const std::string& text() const { return json_.text(); }
    const Document& document() const { return json_.document(); }

    struct NamingValue {
        SceneSteps steps;
        const Document::Node *section, *node;  // of the value
        std::string forgotten;  // the value with nothing in the place of what it names
    };
    /// Every value in which `path` changes the name of an instance.
    std::vector<NamingValue> naming_values(const NewPath& path) const;

    /// What names one of the instances (paths as in the file), or what is below it, names nothing.
    /// Gives what it was, the elements of a list for `put_references_back`.
    std::string forget_references(const std::vector<std::string>& paths);
    /// What still names nothing; `list` is a list of `document`.
    void put_references_back(const Document& document, const Document::Node& list);

    // Each throws Error when the file has no such instance (any more).

    /// `written`: the path to write in the place of one from the root of the tree; none: all as
    /// they are.
    void set(const SceneSteps& steps, const std::string& property, const Image& image,
             const NewPath& written = {});
    /// `scene`: the text of the new child as a scene of its own.
    void add_child(const SceneSteps& steps, const std::string& scene);
    /// What it was in the file, for `put_back`. `home`: its path from the root, by which the file
    /// may name it as well.
    std::string remove(const SceneSteps& steps, const std::string& home = {});
    void put_back(const SceneSteps& steps, const std::string& taken_out);
    /// What the instance and those below it name is what they name in another scene.
    void name_as_in(const SceneSteps& steps, const SceneEdit& other, const SceneSteps& other_steps);
    /// The text of a value; "null" where it says none.
    std::string value(const SceneSteps& steps, const std::string& property) const;
    void rename(const SceneSteps& steps, const std::string& name);

  private:
    using Node = Document::Node;
    /// Null where the text says no value.
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
