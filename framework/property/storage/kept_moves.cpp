// Kept tweaks of instances that get another name or parent: the file says what they are called now.

#include <algorithm>

#include <fettle/property/path.h>

#include "kept_tweaks.h"
#include "scene_edit.h"
#include "scene_names.h"
#include "scene_value.h"

namespace fettle::property {

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
        const NewPath now_at = moved_path(path, to);
        rename_values(now_at);
        fold();
        rename_in_references(now_at);
        return true;
    }
    return false;
}

bool KeptTweaks::makes(const std::string& path) const {
    const std::vector<Segment> names = parse_path(path);
    for (std::size_t count = names.size(); count > 0 && document_ != nullptr; --count)
        if (problem_.empty() && member("created", joined_path(names, count)) != nullptr)
            return true;
    return false;
}

void KeptTweaks::rename(const NewPath& now_at) {
    if (document_ == nullptr || !problem_.empty()) return;
    rename_values(now_at);
    for (const std::string& key : contents_.created)
        if (const auto now = now_at(key)) {
            const Node& node = *member("created", key);
            drop("created", key);
            put("created", *now,
                without_indent(std::string(document_->raw(node)), *document_, node));
        }
    for (const std::string& path : contents_.deleted) {
        const auto [parent, name] = split_path(path);
        if (const auto above = now_at(parent)) {
            std::string quoted;
            append_quoted(quoted, path_below(*above, name));
            drop("deleted", path);
            put("deleted", path_below(*above, name), quoted);
        }
    }
    fold();
    rename_in_references(now_at);
}

void KeptTweaks::rename_values(const NewPath& now_at) {
    std::vector<std::pair<std::string, std::string>> renamed;  // where two change places
    for (const auto& [instance, values] : contents_.values)
        if (const auto now = now_at(instance))
            for (const Kept& kept : values) {
                drop("values", kept.key);
                const Node& node = *member("values", kept.key);
                renamed.emplace_back(
                    *now + path_suffix(kept.property),
                    without_indent(std::string(document_->raw(node)), *document_, node));
            }
    for (const auto& [key, value] : renamed) put("values", key, value);
}

/// What the file says of an instance and of what is below it, and what names these.
std::string KeptTweaks::about(const std::string& path) const {
    std::string values, created;
    for (const auto& [section, key] : all_keys()) {
        const std::string instance = section == "values" ? split_path(key).first : key;
        bool names_it = false;
        (void)with_paths(section, key, [&](const std::string& named) {
            names_it = names_it || is_at_or_below(named, path);
            return std::optional<std::string>();
        });
        if (!names_it && !is_at_or_below(instance, path)) continue;
        const Node& node = *member(section, key);
        std::string& list = section == "values" ? values : created;
        list += list.empty() ? "" : ", ";
        append_quoted(list, key);
        list += ": " + without_indent(std::string(document_->raw(node)), *document_, node);
    }
    return "{\"values\": {" + values + "}, \"created\": {" + created + "}}";
}

void KeptTweaks::put_back(const std::string& path, const std::string& taken_out) {
    drop("deleted", path);
    if (taken_out.empty()) return;
    const Document document(taken_out, "journal");
    for (const char* section : {"values", "created"})
        if (const Node* all = document.member(document.root(), section))
            for (const Node* node = document.first(*all); node; node = document.next(*node))
                put(section, document.key(*node), std::string(document.raw(*node)));
}

std::vector<std::pair<std::string, std::string>> KeptTweaks::all_keys() const {
    std::vector<std::pair<std::string, std::string>> all;
    for (const std::string& key : contents_.created) all.emplace_back("created", key);
    for (const auto& [instance, values] : contents_.values)
        for (const Kept& kept : values) all.emplace_back("values", kept.key);
    return all;
}

std::optional<std::string> KeptTweaks::with_paths(const std::string& section,
                                                  const std::string& key,
                                                  const NewPath& now_at) const {
    const Node& node = *member(section, key);
    const std::string text = without_indent(std::string(document_->raw(node)), *document_, node);
    std::string now;
    try {
        if (section == "created") {
            now = scene_with_paths(tree_, text, now_at);
        } else {
            const auto [instance, property] = split_path(key);
            Type type = Type::nil, element = Type::nil;
            try {
                const Handle handle = resolve(tree_, instance).instance;
                if (const Property* declared = tree_.class_of(handle).property(property))
                    type = declared_type(*declared), element = declared->element;
            } catch (const Error&) {  // not there now: the value says its own type
            }
            now = value_with_paths(text, now_at, type, element);
        }
    } catch (const Error&) {  // what is wrong with it is told when the game starts
        return std::nullopt;
    }
    return now == text ? std::nullopt : std::optional(now);
}

void KeptTweaks::rename_in_references(const NewPath& now_at) {
    for (const auto& [section, key] : all_keys())
        if (const auto now = with_paths(section, key, now_at)) put(section, key, *now);
}

}  // namespace fettle::property
