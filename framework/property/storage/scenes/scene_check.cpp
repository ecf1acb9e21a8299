#include <scenes/scene_check.h>

#include <fettle/property/coercion.h>
#include <fettle/property/path.h>
#include <fettle/property/spelling.h>
#include <fettle/property/storage/scene.h>

#include <json/unknown_keys.h>
#include <scenes/scene_plan.h>
#include <values/instance_paths.h>
#include <values/scene_value.h>

namespace fettle::property {

namespace {

using Node = Document::Node;

class SceneCheck {
  public:
    SceneCheck(const Tree& tree, const Document& document, Handle parent, std::string_view name)
        : tree_(tree),
          document_(document),
          parent_(parent),
          plan_(tree, document, parent, name),
          resolve_([this](const std::string& path, const Node& node) {
              require_target(path, node);
              return Handle{};  // the instance does not exist yet
          }) {}

    void run() {
        for (std::size_t i = 0; i < plan_.instances.size(); ++i) check(i);
    }

    const std::vector<std::string>& warnings() const { return plan_.warnings; }

  private:
    void check(std::size_t index) {
        const ScenePlan::Instance& planned = plan_.instances[index];
        const Class& of = *planned.instance_class;
        const std::size_t offset =
            planned.name != nullptr ? planned.name->begin : planned.node->begin;
        if (planned.parent == ScenePlan::none && !of.creatable())
            document_.fail(
                ErrorKind::bad_structure, offset,
                plan_.path(index) + ": " + with_article(of.name()) + " cannot be created");
        if (planned.parent != ScenePlan::none && planned.name != nullptr)
            check_name(index, document_.text(*planned.name), offset);
        for (const Node* section : {planned.properties, planned.ad_hoc})
            for (const Node* node = section != nullptr ? document_.first(*section) : nullptr; node;
                 node = document_.next(*node)) {
                const Property* const property = of.property(document_.key(*node));
                // Loading keeps the text of unknown properties, so their values are not checked.
                if (property != nullptr || section == planned.ad_hoc)
                    check_value(index, property, *node);
            }
    }

    void check_name(std::size_t index, const std::string& name, std::size_t offset) const {
        const ScenePlan::Instance& above = plan_.instances[plan_.instances[index].parent];
        const Class& of = *above.instance_class;
        const bool taken = of.property(name) != nullptr || of.method(name) != nullptr ||
                           (above.ad_hoc != nullptr && document_.member(*above.ad_hoc, name));
        if (taken)
            document_.fail(ErrorKind::bad_name, offset,
                           plan_.path(index) + ": the name is one of a property or method there");
    }

    void check_value(std::size_t index, const Property* property, const Node& node) const {
        const std::string path = plan_.path(index) + path_suffix(document_.key(node));
        const Type type = property != nullptr ? declared_type(*property) : Type::nil;
        const Type element = property != nullptr ? property->element : Type::nil;
        try {
            if (property != nullptr) {
                require_settable_in_scene(*property);
                if (property->read_only)
                    throw Error(ErrorKind::read_only, path + ": it is read-only");
            }
            const FormulaText formula = formula_text(document_, node);
            const Node* const given = formula ? formula.value : &node;
            Value value;
            if (given != nullptr) value = read_value(document_, *given, type, element, resolve_);
            const bool resets = given != nullptr && given->kind == Document::Kind::null;
            if (property != nullptr && given != nullptr && !resets)
                value = coerced(tree_, *property, value, path);
            if (formula) (void)made_formula(tree_, document_, formula, value);
        } catch (const SceneError& error) {
            throw error.about(path);
        } catch (const Error& error) {
            document_.fail(error.kind(), node.begin, error.what());
        }
    }

    // --- References

    void require_target(const std::string& path, const Node& node) const {
        if (path == "." || exists(path)) return;
        document_.fail(ErrorKind::unknown_name, node.begin,
                       "refers to " + value_text(Value(path)) + ", which does not exist");
    }

    /// Whether the path may lead to an instance. The parent may be unknown, so paths outside the
    /// scene are assumed to exist.
    bool exists(const std::string& path) const {
        const bool relative = is_from_top(path);
        std::vector<Segment> segments;
        try {
            segments = parse_path(relative ? "scene" + path : path);
        } catch (const Error&) {
            return false;
        }
        if (relative) return is_planned(segments, 1);
        if (!parent_) return true;
        Handle at = tree_.root();
        for (std::size_t i = 0; i < segments.size(); ++i) {
            if (segments[i].is_index()) return false;
            const std::string& name = std::get<std::string>(segments[i].key);
            if (at == parent_ && name == plan_.top_name()) return is_planned(segments, i + 1);
            at = tree_.child(at, name);
            if (!at) return false;
        }
        return true;
    }

    /// Whether the names from `first` on lead to an instance of the scene.
    bool is_planned(const std::vector<Segment>& segments, std::size_t first) const {
        std::size_t at = 0;
        for (std::size_t i = first; i < segments.size(); ++i) {
            if (segments[i].is_index()) return false;
            const std::string& name = std::get<std::string>(segments[i].key);
            std::size_t found = ScenePlan::none;
            bool nameless = false;
            for (std::size_t child = at + 1; child < plan_.instances.size(); ++child) {
                const ScenePlan::Instance& planned = plan_.instances[child];
                if (planned.parent != at) continue;
                if (planned.name == nullptr)
                    nameless = nameless || may_be_given(name, *planned.instance_class);
                else if (document_.text(*planned.name) == name)
                    found = child;
            }
            // The class may make children itself.
            if (found == ScenePlan::none)
                return nameless ||
                       plan_.instances[at].instance_class->lifecycle().create != nullptr;
            at = found;
        }
        return true;
    }

    const Tree& tree_;
    const Document& document_;
    Handle parent_;
    ScenePlan plan_;
    ReferenceResolver resolve_;
};

}  // namespace

std::vector<std::string> check_scene(const Tree& tree, const Document& document, Handle parent,
                                     std::string_view name) {
    SceneCheck check(tree, document, parent, name);
    check.run();
    return check.warnings();
}

bool check_scene_text(const Tree& tree, std::string_view text, std::string_view file_name,
                      std::vector<std::string>* warnings) {
    const Document document{std::string(text), std::string(file_name)};
    const Document::Node& root = document.root();
    if (root.kind != Document::Kind::object || document.member(root, version_key) == nullptr)
        return false;
    const std::vector<std::string> found = check_scene(tree, document);
    if (warnings != nullptr) warnings->insert(warnings->end(), found.begin(), found.end());
    return true;
}

}  // namespace fettle::property
