// Kept tweaks of instances that are deleted, and that come back when that is undone.

#include <array>
#include <unordered_set>

#include "kept_tweaks.h"

namespace fettle::property {

std::vector<std::string> KeptTweaks::remove(const std::vector<std::string>& paths) {
    const std::unordered_set<std::string> created = created_;
    std::vector<std::string> before = forget_below(paths);
    for (const std::string& path : paths) {
        if (created.contains(path)) continue;
        std::string quoted;
        append_quoted(quoted, path);
        put("deleted", path, quoted);
    }
    return before;
}

std::vector<std::string> KeptTweaks::forget_below(const std::vector<std::string>& paths) {
    fold();
    const PathSet set(paths);
    std::vector<std::string> before = about(set);
    before.resize(paths.size());
    for (const auto& [section, key] : all_keys())
        if (!set.above(section == "values" ? split_path(key).first : key).empty())
            drop(section, key);
    fold();
    rename_in_references([&](const std::string& named) -> std::optional<std::string> {
        if (!set.above(named).empty()) return std::string();
        return std::nullopt;
    });
    return before;
}

/// For each path what the file says of the instance and of what is below it, and what names these.
std::vector<std::string> KeptTweaks::about(const PathSet& paths) const {
    std::vector<std::array<std::string, 2>> lists(paths.size());  // values, created
    for (const auto& [section, key] : all_keys()) {
        const bool value = section == "values";
        std::unordered_set<std::size_t> meant;
        const auto note = [&, &all = meant](const std::string& path) {
            for (const std::size_t each : paths.above(path)) all.insert(each);
        };
        note(value ? split_path(key).first : key);
        (void)with_paths(section, key, [&](const std::string& named) {
            note(named);
            return std::optional<std::string>();
        });
        for (const std::size_t each : meant) {
            const Node& node = *member(section, key);
            std::string& list = lists[each][value ? 0 : 1];
            list += list.empty() ? "" : ", ";
            append_quoted(list, key);
            list += ": " + without_indent(std::string(document_->raw(node)), *document_, node);
        }
    }
    std::vector<std::string> texts;
    for (const auto& [values, created] : lists)
        texts.push_back("{\"values\": {" + values + "}, \"created\": {" + created + "}}");
    return texts;
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

}  // namespace fettle::property
