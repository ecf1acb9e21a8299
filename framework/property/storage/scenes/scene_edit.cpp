#include <scenes/scene_edit.h>

#include <fettle/property/path.h>

#include <json/unknown_keys.h>
#include <scenes/scene_names.h>
#include <scenes/scene_plan.h>
#include <values/scene_value.h>

namespace fettle::property {

SceneEdit::SceneEdit(const Tree& tree, std::string text, std::string file_name)
    : tree_(&tree), json_(std::move(text), std::move(file_name)) {
    if (document().member(document().root(), version_key) == nullptr)
        document().fail(ErrorKind::bad_structure, 0, "not a scene");
}

// Finds a child by its name; a child without a name in the file is found by its place.
const SceneEdit::Node* SceneEdit::child(const Node& instance, const SceneStep& step) const {
    const Node* children = document().member(instance, "children");
    if (children == nullptr || children->kind != Document::Kind::array) return nullptr;
    const Node* at_place = nullptr;
    std::size_t place = 0;
    for (const Node* node = document().first(*children); node; node = document().next(*node)) {
        const Node* name = document().member(*node, "name");
        if (name != nullptr && name->kind == Document::Kind::text &&
            document().text(*name) == step.name)
            return node;
        if (place++ == step.place && name == nullptr) at_place = node;
    }
    return at_place;
}

const SceneEdit::Node* SceneEdit::find_or_none(const SceneSteps& steps) const {
    const Node* at = &document().root();
    for (const SceneStep& step : steps)
        if (at = child(*at, step); at == nullptr) return nullptr;
    return at;
}

const SceneEdit::Node& SceneEdit::find(const SceneSteps& steps) const {
    if (const Node* found = find_or_none(steps)) return *found;
    std::string path;
    SceneSteps above;
    for (const SceneStep& step : steps) {
        above.push_back(step);
        path += path_suffix(step.name);
        if (find_or_none(above) == nullptr) break;
    }
    throw Error(ErrorKind::unknown_name,
                document().file_name() + ": it has no instance " + path + " any more");
}

void SceneEdit::set(const SceneSteps& steps, const std::string& property, const Image& image,
                    const NewPath& written) {
    const Node& instance = find(steps);
    const Node* class_name = document().member(instance, "class");
    if (class_name == nullptr || class_name->kind != Document::Kind::text)
        document().fail(ErrorKind::bad_structure, instance.begin, "not an instance with a class");
    const Property* declared = tree_->class_named(document().text(*class_name)).property(property);
    if (image.kind == Image::Kind::absent || image.kind == Image::Kind::by_default) {
        remove_member(steps, "properties", property);
        remove_member(steps, "ad_hoc", property);
    } else {
        set_member(steps, declared, property, image_in_file(*tree_, declared, image, written));
    }
}

/// The last member that the class declares before the property; members of a file keep that order.
const SceneEdit::Node* SceneEdit::member_before(const Node& section, const Class& of,
                                                const Property& property) const {
    const Node* before = &section;  // as the first
    for (const Property* each : of.properties()) {
        if (each == &property) break;
        if (const Node* node = document().member(section, each->name);
            node != nullptr && (before == &section || node->begin > before->begin))
            before = node;
    }
    return before;
}

void SceneEdit::set_member(const SceneSteps& steps, const Property* declared,
                           const std::string& property, const std::string& value) {
    const Node& instance = find(steps);
    const std::string_view key = declared != nullptr ? "properties" : "ad_hoc";
    const Node* section = document().member(instance, key);
    if (section == nullptr) {
        std::string item = "{\n  ";
        append_quoted(item, property);
        item += ": " + value + "\n}";
        const Node* after = nullptr;
        for (const std::string_view earlier : {"properties", "name", "class"})
            if (after == nullptr && earlier != key) after = document().member(instance, earlier);
        return json_.add_member(instance, key, item, after);
    }
    if (const Node* member = document().member(*section, property))
        return json_.replace(*member, value);
    const Node* after =
        declared != nullptr && declared->owner != nullptr
            ? member_before(
                  *section,
                  *tree_->find_class(document().text(*document().member(instance, "class"))),
                  *declared)
            : nullptr;
    json_.add_member(*section, property, value, after);
}

void SceneEdit::remove_member(const SceneSteps& steps, const std::string& section,
                              const std::string& property) {
    const Node& instance = find(steps);
    const Node* object = document().member(instance, section);
    const Node* member = object != nullptr ? document().member(*object, property) : nullptr;
    if (member == nullptr) return;
    if (document().count(*object) == 1)
        json_.remove(instance, *object);
    else
        json_.remove(*object, *member);
}

void SceneEdit::add_child(const SceneSteps& steps, const std::string& scene) {
    JsonEdit child(scene, document().file_name());
    if (const Node* version = child.document().member(child.document().root(), version_key))
        child.remove(child.document().root(), *version);
    std::string text = child.text();
    while (text.ends_with('\n')) text.pop_back();
    const Node& instance = find(steps);
    if (const Node* children = document().member(instance, "children"))
        return json_.add_element(*children, text);
    add_first_child(instance, text);
}

void SceneEdit::add_first_child(const Node& parent, std::string text) {
    for (std::size_t at = text.find('\n'); at != std::string::npos; at = text.find('\n', at + 3))
        text.replace(at, 1, "\n  ");
    json_.add_member(parent, "children", "[\n  " + text + "\n]");
}

std::string SceneEdit::remove(const SceneSteps& steps, const std::string& home) {
    const Node& instance = find(steps);
    SceneSteps above = steps;
    above.pop_back();
    const Node& parent = find(above);
    const Node& children = *document().member(parent, "children");
    require_names_beside(instance, children);
    std::string taken_out = "{";
    for (const Node* node = document().first(children); node; node = document().next(*node)) {
        if (document().next(*node) != &instance) continue;
        taken_out += "\"behind\": ";
        append_quoted(taken_out, document().text(*document().member(*node, "name")));
        taken_out += ", ";
    }
    taken_out +=
        "\"child\": " + without_indent(std::string(document().raw(instance)), document(), instance);
    std::string path;
    for (const SceneStep& step : steps) path += path_suffix(step.name);
    if (document().count(children) == 1)
        json_.remove(parent, children);
    else
        json_.remove(children, instance);
    std::vector<std::string> paths{path};
    if (!home.empty()) paths.push_back(home);
    return taken_out + ", \"references\": [" + forget_references(paths) + "]}";
}

std::vector<SceneEdit::NamingValue> SceneEdit::naming_values(const NewPath& path) const {
    std::vector<NamingValue> found;
    const ScenePlan plan(*tree_, document(), {}, {});
    const auto steps_to = [&](std::size_t index) {
        SceneSteps steps;
        for (std::size_t i = index; i != 0; i = plan.instances[i].parent) {
            const Node* name = plan.instances[i].name;
            steps.insert(steps.begin(), {name != nullptr ? document().text(*name) : std::string(),
                                         plan.instances[i].place});
        }
        return steps;
    };
    for (std::size_t i = 0; i < plan.instances.size(); ++i)
        for (const Node* section : {plan.instances[i].properties, plan.instances[i].ad_hoc})
            for (const Node* node = section != nullptr ? document().first(*section) : nullptr; node;
                 node = document().next(*node)) {
                const Property* property =
                    plan.instances[i].instance_class->property(document().key(*node));
                if (property == nullptr && section == plan.instances[i].properties) continue;
                const std::string raw(document().raw(*node));
                std::string now =
                    property == nullptr
                        ? value_with_paths(raw, path)
                        : value_with_paths(raw, path, declared_type(*property), property->element);
                if (now != raw) found.push_back({steps_to(i), section, node, std::move(now)});
            }
    return found;
}

/// Returns one element per reference: the steps to its instance, section, key and text.
std::string SceneEdit::forget_references(const std::vector<std::string>& paths) {
    const PathSet set(paths);
    std::string before;
    std::vector<std::pair<const Node*, std::string>> replaced;
    for (NamingValue& each :
         naming_values([&](const std::string& named) -> std::optional<std::string> {
             if (!set.above(named).empty()) return std::string();
             return std::nullopt;
         })) {
        const std::string steps = steps_text(each.steps);
        before += before.empty() ? "[" : ", [";
        before += steps.empty() ? "[]" : steps;
        before += ", ";
        append_quoted(before, document().key(*each.section));
        before += ", ";
        append_quoted(before, document().key(*each.node));
        before += ", " + std::string(document().raw(*each.node)) + "]";
        replaced.emplace_back(each.node, std::move(each.forgotten));
    }
    json_.replace(replaced);
    return before;
}

void SceneEdit::name_as_in(const SceneSteps& steps, const SceneEdit& other,
                           const SceneSteps& other_steps) {
    const NewPath any = [](const std::string&) { return std::optional(std::string()); };
    const auto same_below = [](const NamingValue& each, const SceneSteps& from,
                               const SceneSteps& to) {
        SceneSteps there = to;
        there.insert(there.end(), each.steps.begin() + static_cast<std::ptrdiff_t>(from.size()),
                     each.steps.end());
        return there;
    };
    const Node &top = find(steps), &other_top = other.find(other_steps);
    std::vector<std::pair<const Node*, std::string>> replaced;
    for (const NamingValue& each : naming_values(any))
        if (each.node->begin >= top.begin && each.node->begin < top.end) {
            replaced.emplace_back(each.node, other.value(same_below(each, steps, other_steps),
                                                         document().key(*each.node)));
        }
    // References that are empty in this file and name an instance in the other one.
    for (const NamingValue& each : other.naming_values(any))
        if (each.node->begin >= other_top.begin && each.node->begin < other_top.end) {
            const Node* here =
                value_node(same_below(each, other_steps, steps), other.document().key(*each.node));
            if (here != nullptr && document().raw(*here) == "null")
                replaced.emplace_back(here, other.document().raw(*each.node));
        }
    json_.replace(replaced);
}

std::string SceneEdit::value(const SceneSteps& steps, const std::string& property) const {
    const Node* node = value_node(steps, property);
    return node == nullptr ? "null" : std::string(document().raw(*node));
}

const Document::Node* SceneEdit::value_node(const SceneSteps& steps,
                                            const std::string& property) const {
    const Node* instance = find_or_none(steps);
    for (const std::string_view section : {"properties", "ad_hoc"})
        if (const Node* its = instance ? document().member(*instance, section) : nullptr)
            if (const Node* value = document().member(*its, property)) return value;
    return nullptr;
}

/// Puts the child after the sibling that was in front of it.
void SceneEdit::put_back(const SceneSteps& steps, const std::string& taken_out) {
    SceneSteps above = steps;
    above.pop_back();
    const Node& parent = find(above);
    const Document before(taken_out, "journal");
    const Node* child_then = before.member(before.root(), "child");
    const Node* behind = before.member(before.root(), "behind");
    if (child_then == nullptr) before.fail(ErrorKind::bad_structure, 0, "not a deletion");
    const std::string text(before.raw(*child_then));
    const Node* children = document().member(parent, "children");
    const Node* after = behind == nullptr ? children : nullptr;
    if (behind != nullptr && behind->kind == Document::Kind::text)
        after = child(parent, {before.text(*behind), no_place});
    if (children == nullptr)
        add_first_child(parent, text);
    else
        json_.add_element(*children, text, after);
    if (const Node* references = before.member(before.root(), "references"))
        put_references_back(before, *references);
}

void SceneEdit::put_references_back(const Document& before, const Node& list) {
    for (const Node* each = before.first(list); each; each = before.next(*each))
        put_reference_back(before, *each);
}

void SceneEdit::put_reference_back(const Document& before, const Node& reference) {
    std::vector<const Node*> parts;  // as written by `forget_references`
    for (const Node* part = before.first(reference); part; part = before.next(*part))
        parts.push_back(part);
    if (parts.size() != 4) before.fail(ErrorKind::bad_structure, reference.begin, "not a deletion");
    const Node& instance = find(read_steps(std::string(before.raw(*parts[0]))));
    const Node* section = document().member(instance, before.text(*parts[1]));
    const Node* now =
        section != nullptr ? document().member(*section, before.text(*parts[2])) : nullptr;
    if (now != nullptr && document().raw(*now).find("null") != std::string_view::npos)
        json_.replace(*now, before.raw(*parts[3]));
}

/// Throws if a sibling has no name in the file. Such siblings are found by their places and named
/// in their order, and a new name would change both.
void SceneEdit::require_names_beside(const Node& instance, const Node& children) const {
    for (const Node* node = document().first(children); node; node = document().next(*node))
        if (node != &instance && document().member(*node, "name") == nullptr)
            refuse_without_name(*node);
}

void SceneEdit::refuse_without_name(const Node& node) const {
    throw Error(ErrorKind::bad_structure,
                document().file_name() + ":" + std::to_string(document().line(node.begin)) +
                    ": an instance beside it has no name in the file; give it one first");
}

/// An instance that has no name in the file gets the first free one: `ball`, `ball_2`.
void SceneEdit::require_not_given(const std::string& name, const Node& instance,
                                  const Node& children) const {
    for (const Node* node = document().first(children); node; node = document().next(*node)) {
        if (node == &instance || document().member(*node, "name") != nullptr) continue;
        const Node* called = document().member(*node, "class");
        const Class* its = called ? tree_->find_class(document().text(*called)) : nullptr;
        if (its == nullptr || may_be_given(name, *its)) refuse_without_name(*node);
    }
}

void SceneEdit::rename(const SceneSteps& steps, const std::string& name) {
    std::string quoted;
    if (!append_quoted(quoted, name))
        throw Error(ErrorKind::bad_name, "a file cannot hold a name that is not UTF-8");
    const Node& instance = find(steps);
    const Node* old = document().member(instance, "name");
    if (!steps.empty()) {
        const SceneSteps above(steps.begin(), steps.end() - 1);
        const Node& children = *document().member(find(above), "children");
        if (old == nullptr)
            require_names_beside(instance, children);
        else
            for (const std::string& either : {document().text(*old), name})
                require_not_given(either, instance, children);
    }
    if (old != nullptr) return json_.replace(*old, quoted);
    json_.add_member(instance, "name", quoted, document().member(instance, "class"));
}

}  // namespace fettle::property
