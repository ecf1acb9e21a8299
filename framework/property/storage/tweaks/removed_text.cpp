#include <tweaks/removed_text.h>

#include <utility>
#include <vector>

#include <json/json_edit.h>
#include <scenes/scene_names.h>
#include <tweaks_file/instance_moves.h>
#include <values/scene_value.h>

namespace fettle::property {

namespace {

using Node = Document::Node;

/// The object with other texts of its members: `change(key, node)` changes the key and returns the
/// text of the value.
template <class Change>
std::string object_with(const Document& document, const Node& object, Change change) {
    std::string text = "{";
    for (const Node* node = document.first(object); node; node = document.next(*node)) {
        std::string key = document.key(*node);  // NOLINT: `change` may change it
        const std::string value = change(key, *node);
        text += text.size() > 1 ? ", " : "";
        append_quoted(text, key);
        text += ": " + value;
    }
    return text + "}";
}

template <class Change>
std::string list_with(const Document& document, const Node& list, Change change) {
    std::string text = "[";
    for (const Node* node = document.first(list); node; node = document.next(*node))
        text += (text.size() > 1 ? ", " : "") + change(*node);
    return text + "]";
}

std::string quoted(const std::string& text) {
    std::string out;
    append_quoted(out, text);
    return out;
}

/// A value that names an instance, with other paths. The text does not contain its type: paths
/// stand alone only if the property is declared as a reference or as a list of references.
std::string value_with(const std::string& raw, const NewPath& path) {
    const Document document(raw, "journal");
    const FormulaText formula = formula_text(document, document.root());
    const Node* value = formula ? formula.value : &document.root();
    if (value == nullptr) return raw;
    if (value->kind == Document::Kind::text) return value_with_paths(raw, path, Type::reference);
    bool paths = value->kind == Document::Kind::array;
    for (const Node* each = paths ? document.first(*value) : nullptr; each != nullptr;
         each = document.next(*each))
        paths = paths && (each->kind == Document::Kind::text || each->kind == Document::Kind::null);
    return paths ? value_with_paths(raw, path, Type::list, Type::reference)
                 : value_with_paths(raw, path);
}

/// The references that `forget_references` returned: steps, section, key and value of each.
std::string references_with(const Document& document, const Node& list, const NewPath& path,
                            const SceneOrigins::Names& names) {
    return list_with(document, list, [&](const Node& reference) {
        int part = 0;
        return list_with(document, reference, [&](const Node& node) {
            std::string raw(document.raw(node));
            switch (part++) {
                case 0: {
                    const std::string steps = steps_text(renamed_steps(read_steps(raw), names));
                    return steps.empty() ? std::string("[]") : steps;
                }
                case 3:
                    return value_with(raw, path);
                default:
                    return raw;
            }
        });
    });
}

/// Replaces the references of each other scene file by `change(file, list)`.
template <class Change>
std::string change_references_elsewhere(const Document& document, const Node& all, Change change) {
    return list_with(document, all, [&](const Node& each) {
        const Node* file = document.member(each, "file");
        return object_with(document, each, [&](const std::string& key, const Node& node) {
            return key == "references" && file != nullptr && file->kind == Document::Kind::text
                       ? change(document.text(*file), node)
                       : std::string(document.raw(node));
        });
    });
}

/// The names of the parts of a new instance, and its references.
std::string scene_with_homes(const Tree& tree, const std::string& scene, const std::string& home,
                             const NewPath& now_at) {
    JsonEdit edit(scene, "its scene");
    const Document& document = edit.document();
    std::vector<std::pair<const Node*, std::string>> names;
    const auto look = [&](const auto& self, const Node& node, const std::string& path) -> void {
        const Node* name = document.member(node, "name");
        const auto now = now_at(path);
        if (now && *now != path && name != nullptr)
            names.emplace_back(name, quoted(split_path(*now).second));
        const Node* children = document.member(node, "children");
        for (const Node* child = children ? document.first(*children) : nullptr; child;
             child = document.next(*child))
            if (const Node* its = document.member(*child, "name"))
                self(self, *child, path_below(path, document.text(*its)));
    };
    look(look, document.root(), home);
    edit.replace(names);
    return scene_with_paths(tree, edit.text(), now_at);
}

/// The paths of instances from the top of the scene file, after the file got other names.
NewPath paths_from_top(const SceneSteps* removed, const SceneOrigins::Names& names) {
    const auto path = [](const SceneSteps& steps) {
        std::string text;
        for (const SceneStep& step : steps) text += path_suffix(step.name);
        return text;
    };
    InstanceMoves moves;
    for (const auto& [steps, name] : names)
        if (!steps.empty()) moves.add(path(steps), path(renamed_steps(steps, names)));
    const std::string gone = removed != nullptr ? path(*removed) : std::string();
    const std::string gone_now =
        removed != nullptr ? path(steps_of_removed(*removed, names)) : std::string();
    return [=](const std::string& old) -> std::optional<std::string> {
        if (!is_from_top(old)) return std::nullopt;
        if (!gone.empty() && is_at_or_below(old, gone)) return gone_now + old.substr(gone.size());
        return moves.now(old);
    };
}

template <class Change>
std::string changed(const std::string& text, Change change) {
    if (text.empty()) return text;
    try {
        const Document document(text, "journal");
        return object_with(document, document.root(), [&](std::string& key, const Node& node) {
            return change(document, key, node);
        });
    } catch (const Error&) {  // reported when it is put back
        return text;
    }
}

}  // namespace

std::string home_of_removed(const std::string& home, const NewPath& now_at) {
    const auto [parent, name] = split_path(home);
    return path_below(now_at(parent).value_or(parent), name);
}

SceneSteps steps_of_removed(const SceneSteps& steps, const SceneOrigins::Names& names) {
    if (steps.empty()) return steps;
    SceneSteps now = steps;
    now.pop_back();
    now = renamed_steps(now, names);
    now.push_back(steps.back());
    return now;
}

std::string with_new_homes(const Tree& tree, const std::string& text, const std::string& removed,
                           const NewPath& now_at) {
    const std::string removed_now = home_of_removed(removed, now_at);
    const NewPath now = [&](const std::string& path) -> std::optional<std::string> {
        if (path.empty() || is_from_top(path)) return std::nullopt;
        if (is_at_or_below(path, removed)) return removed_now + path.substr(removed.size());
        return now_at(path);
    };
    const auto renamed = [&](const std::string& path) { return now(path).value_or(path); };
    return changed(
        text,
        [&](const Document& document, const std::string& section, const Node& all) -> std::string {
            if (section == "values")
                return object_with(document, all, [&](std::string& key, const Node& node) {
                    const auto [instance, property] = split_path(key);
                    key = renamed(instance) + path_suffix(property);
                    const std::string raw(document.raw(node));
                    // References of the removed instances themselves are set when the instances are
                    // put back.
                    return is_at_or_below(instance, removed) ? raw : value_with(raw, now);
                });
            if (section == "created")
                return object_with(document, all, [&](std::string& key, const Node& node) {
                    const std::string home = std::exchange(key, renamed(key));
                    return scene_with_homes(
                        tree, without_indent(std::string(document.raw(node)), document, node), home,
                        now);
                });
            if (section == "deleted")
                return list_with(document, all, [&](const Node& node) {
                    return quoted(renamed(document.text(node)));
                });
            if (section == "references") return references_with(document, all, now, {});
            if (section == "elsewhere")
                return change_references_elsewhere(
                    document, all, [&](const std::string&, const Node& list) {
                        return references_with(document, list, now, {});
                    });
            return std::string(document.raw(all));
        });
}

std::string with_new_steps(const std::string& text, const SceneSteps* removed,
                           const std::filesystem::path& file, const SceneOrigins::Names& names) {
    const NewPath path = paths_from_top(removed, names);
    return changed(
        text,
        [&](const Document& document, const std::string& section, const Node& all) -> std::string {
            if (section == "behind" && removed != nullptr && all.kind == Document::Kind::text) {
                for (const auto& [steps, name] : names) {
                    if (steps.empty()) continue;
                    SceneSteps sibling = *removed;
                    sibling.back() = steps.back();
                    if (steps.back().name == document.text(all) &&
                        steps_text(steps) == steps_text(sibling))
                        return quoted(name);
                }
            } else if (section == "references" && removed != nullptr) {
                return references_with(document, all, path, names);
            } else if (section == "elsewhere") {
                return change_references_elsewhere(
                    document, all, [&](const std::string& other, const Node& list) {
                        return other == file.string() ? references_with(document, list, path, names)
                                                      : std::string(document.raw(list));
                    });
            }
            return std::string(document.raw(all));
        });
}

}  // namespace fettle::property
