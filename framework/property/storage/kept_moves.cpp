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
    for (const std::string& path : contents_.deleted)
        if (const auto now = now_at(path)) {
            std::string quoted;
            append_quoted(quoted, *now);
            drop("deleted", path);
            put("deleted", *now, quoted);
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

/// The values too that it has now: a tweak that is undone later is to be in the file as before.
std::string KeptTweaks::taken_out(const std::string& path) const {
    if (document_ == nullptr || !problem_.empty()) return {};
    std::string out = "{";
    const auto append = [&](const std::string& section, const std::vector<std::string>& keys) {
        if (keys.empty()) return;
        out += out.size() > 1 ? ", \"" : "\"";
        out += section + "\": {";
        for (const std::string& key : keys) {
            const Node& node = *member(section, key);
            if (&key != &keys.front()) out += ", ";
            append_quoted(out, key);
            out += ": " + without_indent(std::string(document_->raw(node)), *document_, node);
        }
        out += "}";
    };
    std::vector<std::string> values, created;
    each_value_below(path,
                     [&](const std::string&, const Kept& kept) { values.push_back(kept.key); });
    for (const std::string& key : contents_.created)
        if (is_at_or_below(key, path)) created.push_back(key);
    append("values", values);
    append("created", created);
    return out + "}";
}

void KeptTweaks::put_back(const std::string& path, const std::string& taken_out) {
    drop("deleted", path);
    if (taken_out.empty()) return;
    const Document document(taken_out, "journal");
    for (const Node* section = document.first(document.root()); section;
         section = document.next(*section))
        for (const Node* node = document.first(*section); node; node = document.next(*node))
            put(document.key(*section), document.key(*node), std::string(document.raw(*node)));
}

void KeptTweaks::rename_in_references(const NewPath& now_at) {
    const auto put_renamed = [&](const std::string& section, const std::string& key, auto rename) {
        const Node& node = *member(section, key);
        const std::string text =
            without_indent(std::string(document_->raw(node)), *document_, node);
        try {
            if (const std::string now = rename(text); now != text) put(section, key, now);
        } catch (const Error&) {  // what is wrong with it is told when the game starts
        }
    };
    for (const std::string& key : contents_.created)
        put_renamed("created", key, [&](const std::string& scene) {
            return scene_with_paths(tree_, scene, now_at);
        });
    for (const auto& [instance, values] : contents_.values)
        for (const Kept& kept : values) {
            Type type = Type::nil, element = Type::nil;
            try {
                const Handle handle = resolve(tree_, instance).instance;
                if (const Property* declared = tree_.class_of(handle).property(kept.property))
                    type = declared_type(*declared), element = declared->element;
            } catch (const Error&) {  // not there now: the value says its own type
            }
            put_renamed("values", kept.key, [&](const std::string& value) {
                return value_with_paths(value, now_at, type, element);
            });
        }
}

}  // namespace fettle::property
