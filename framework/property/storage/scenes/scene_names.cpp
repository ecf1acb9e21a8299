#include <scenes/scene_names.h>

#include <utility>
#include <vector>

#include <json/json_edit.h>
#include <scenes/scene_plan.h>
#include <values/scene_value.h>

namespace fettle::property {

namespace {

using Node = Document::Node;

/// New texts of references, by node.
class Replacements {
  public:
    explicit Replacements(const NewPath& path)
        : visit_([this, &path](const std::string& old, const Node& node) {
              if (const auto now = path(old)) {
                  std::string quoted;
                  if (now->empty())
                      list_.emplace_back(&node, "null");
                  else if (append_quoted(quoted, *now))
                      list_.emplace_back(&node, std::move(quoted));
              }
              return Handle{};
          }) {}

    void collect(const Document& document, const Node& node, Type type, Type element) const {
        const FormulaText formula = formula_text(document, node);
        const Node* value = formula ? formula.value : &node;
        if (value != nullptr) (void)read_value(document, *value, type, element, visit_);
    }
    void apply(JsonEdit& edit) const {
        if (!list_.empty()) edit.replace(list_);
    }

  private:
    std::vector<std::pair<const Node*, std::string>> list_{};
    ReferenceResolver visit_;
};

}  // namespace

std::string scene_with_paths(const Tree& tree, const std::string& scene, const NewPath& path) {
    JsonEdit edit(scene, "its scene");
    const Document& document = edit.document();
    Replacements replacements(path);
    const ScenePlan plan(tree, document, {}, {});
    for (const ScenePlan::Instance& each : plan.instances)
        for (const Node* section : {each.properties, each.ad_hoc})
            for (const Node* node = section != nullptr ? document.first(*section) : nullptr; node;
                 node = document.next(*node)) {
                const Property* property = each.instance_class->property(document.key(*node));
                if (property == nullptr && section == each.properties) continue;
                if (property == nullptr)
                    replacements.collect(document, *node, Type::nil, Type::nil);
                else
                    replacements.collect(document, *node, declared_type(*property),
                                         property->element);
            }
    replacements.apply(edit);
    return edit.text();
}

std::string value_with_paths(const std::string& value, const NewPath& path, Type type,
                             Type element) {
    if (value.empty()) return value;
    JsonEdit edit(value, "its value");
    Replacements replacements(path);
    replacements.collect(edit.document(), edit.document().root(), type, element);
    replacements.apply(edit);
    return edit.text();
}

}  // namespace fettle::property
