// Kept tweaks of instances that get another name or parent: the file says what they are called now.

#include <algorithm>

#include <fettle/property/path.h>

#include "kept_tweaks.h"
#include "scene_edit.h"
#include "scene_names.h"
#include "scene_value.h"

namespace fettle::property {

namespace {

/// A text of several lines as if it began in column 1, as one that is added must be.
std::string without_indent(std::string text, const Document& document, const Document::Node& at) {
    const std::string& all = document.source();
    const std::size_t line = all.rfind('\n', at.begin) + 1;  // 0 where it is the first
    const std::size_t indent = all.find_first_not_of(' ', line) - line;
    for (std::size_t i = text.find('\n'); i != std::string::npos; i = text.find('\n', i + 1)) {
        const std::size_t spaces = text.find_first_not_of(' ', i + 1) - i - 1;
        text.erase(i + 1, std::min(spaces, indent));
    }
    return text;
}

}  // namespace

bool KeptTweaks::move(const std::string& path, const std::string& to) {
    if (problem_.empty()) fold();  // what it is called in the file by now
    const std::vector<Segment> from = parse_path(path), into = parse_path(to);
    for (std::size_t count = from.size(); count > 0; --count) {
        const std::string made = joined_path(from, count);
        const Node* node =
            document_ != nullptr && problem_.empty() ? member("created", made) : nullptr;
        if (node == nullptr) continue;
        const bool whole = count == from.size();
        if (!whole && joined_path(from, from.size() - 1) != joined_path(into, into.size() - 1))
            throw Error(ErrorKind::rejected, "it is a part of " + made +
                                                 ", and another parent of a part cannot be kept");
        SceneEdit edit(tree_, std::string(document_->raw(*node)), "its scene");
        SceneSteps steps;
        for (std::size_t i = count; i < from.size(); ++i)
            steps.push_back({std::get<std::string>(from[i].key), SIZE_MAX});
        edit.rename(steps, std::get<std::string>(into.back().key));
        if (whole) drop("created", made);
        put("created", whole ? to : made, without_indent(edit.text(), *document_, *node));
        for (const std::string& other : contents_.created)  // what was made below it later
            if (other != path && is_at_or_below(other, path)) {
                const Node& its = *member("created", other);
                drop("created", other);
                put("created", to + other.substr(path.size()),
                    without_indent(std::string(document_->raw(its)), *document_, its));
            }
        move_values(path, to);
        fold();
        rename_in_references(path, to);
        return true;
    }
    return false;
}

void KeptTweaks::move_values(const std::string& path, const std::string& to) {
    if (document_ == nullptr || !problem_.empty()) return;
    each_value_below(path, [&](const std::string& instance, const Kept& kept) {
        drop("values", kept.key);
        put("values", to + instance.substr(path.size()) + path_suffix(kept.property),
            std::string(document_->raw(*member("values", kept.key))));
    });
}

void KeptTweaks::rename_in_references(const std::string& path, const std::string& to) {
    const NewPath now_at = moved_path(path, to);
    const std::string quoted = mention_of(path);
    const auto names_it = [&](const Node& node) {
        return document_->raw(node).find(quoted) != std::string_view::npos;
    };
    for (const std::string& key : contents_.created) {
        const Node& node = *member("created", key);
        if (!names_it(node)) continue;
        const std::string scene =
            without_indent(std::string(document_->raw(node)), *document_, node);
        put("created", key, scene_with_paths(tree_, scene, now_at));
    }
    for (const auto& [instance, values] : contents_.values)
        for (const Kept& kept : values) {
            const Node& node = *member("values", kept.key);
            if (!names_it(node)) continue;
            Type type = Type::nil, element = Type::nil;
            try {
                const Handle handle = resolve(tree_, instance).instance;
                if (const Property* declared = tree_.class_of(handle).property(kept.property))
                    type = declared_type(*declared), element = declared->element;
            } catch (const Error&) {  // not there now: the value says its own type
            }
            put("values", kept.key,
                value_with_paths(std::string(document_->raw(node)), now_at, type, element));
        }
}

}  // namespace fettle::property
