#pragma once
// Description of a scene file after reading and checking its structure: the instances, their
// classes, and their positions in the file. Nothing is made yet.

#include <cstdint>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fettle/property/tree.h>

#include <json/document.h>
#include <json/unknown_keys.h>

namespace fettle::property {

/// Whether an instance of the class may get this name when the file gives it none: `ball`,
/// `ball_2`.
bool may_be_given(std::string_view name, const Class& its);

class ScenePlan {
  public:
    static constexpr std::size_t none = SIZE_MAX;

    struct Instance {
        const Document::Node* node;
        std::size_t parent;  // `none` for the topmost instance
        const Class* instance_class;
        const Document::Node* name = nullptr;
        const Document::Node* properties = nullptr;
        const Document::Node* ad_hoc = nullptr;
        std::size_t place = 0;  // index among the children of its parent
        UnknownKeys unknown{};
        std::string called{};  // the final name of an instance without a name in the file; "" until
                               // it is known
    };

    /// The scene will be a child of `parent` (null: detached) with the name `name` ("": the name in
    /// the file). Throws SceneError.
    ScenePlan(const Tree& tree, const Document& document, Handle parent, std::string_view name);

    /// Parents before children.
    std::vector<Instance> instances;
    /// Indices of the instances: children before parents, siblings in order.
    std::vector<std::size_t> children_first() const;
    /// One line for each key that is probably a mistake.
    std::vector<std::string> warnings;

    /// The future path of the instance in the tree.
    std::string path(std::size_t index) const;
    std::string top_path() const { return future_path(top_name()); }
    std::string top_name() const;
    /// Whether the file has a child of that instance with that name.
    bool names_child(std::size_t parent, const std::string& name) const {
        return names_.contains({parent, name});
    }
    /// Adds a warning with its position: "level.json:3:5: ...".
    void warn(std::size_t offset, const std::string& text);

  private:
    using Node = Document::Node;
    void check_version() const;
    void read(const Node& node, std::size_t parent);
    void read_children(const Node& children, std::size_t parent);
    const Class& class_of(const Node& node, std::size_t parent) const;
    const Node& of_kind(const Node& member, Document::Kind kind) const;
    void other_key(std::size_t index, const Node& member);
    void check_nesting(std::size_t index, const Node* section) const;
    void warn_of_unknown_properties(std::size_t index);
    std::string future_path(const std::string& name) const;

    const Tree& tree_;
    const Document& document_;
    Handle parent_;
    std::string name_;
    std::set<std::pair<std::size_t, std::string>> names_;  // names in the file, by parent
};

}  // namespace fettle::property
