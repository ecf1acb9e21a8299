// Kept tweaks of instances that are deleted, and of those that return by undo.

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <unordered_set>

#include <scenes/scene_edit.h>
#include <tweaks_file/kept_tweaks.h>

namespace fettle::property {

/// Deeper paths are removed first, so the result for an instance does not contain theirs.
std::vector<std::string> KeptTweaks::deepest_first(const std::vector<std::string>& paths,
                                                   const Remove& remove) {
    std::map<std::size_t, std::vector<std::size_t>, std::greater<>> by_depth;
    for (std::size_t i = 0; i < paths.size(); ++i)
        by_depth[parse_path(paths[i]).size()].push_back(i);
    std::vector<std::string> before(paths.size());
    for (const auto& [depth, places] : by_depth) {
        std::vector<std::string> of_depth;
        of_depth.reserve(places.size());
        for (const std::size_t i : places) of_depth.push_back(paths[i]);
        std::vector<std::string> removed = remove(of_depth);
        for (std::size_t i = 0; i < places.size(); ++i) before[places[i]] = std::move(removed[i]);
    }
    return before;
}

std::vector<std::string> KeptTweaks::remove(const std::vector<std::string>& all) {
    return deepest_first(all, [this](const std::vector<std::string>& paths) {
        const std::unordered_set<std::string> created = created_;
        std::vector<std::string> before = forget_beside(paths);
        fold();
        for (const std::string& path : paths)
            if (!created.contains(path) && !remove_part(path)) put_deleted(path);
        return before;
    });
}

std::vector<std::string> KeptTweaks::forget_below(const std::vector<std::string>& all) {
    return deepest_first(
        all, [this](const std::vector<std::string>& paths) { return forget_beside(paths); });
}

bool KeptTweaks::deletes(const std::string& path) const {
    return std::ranges::find(contents_.deleted, path) != contents_.deleted.end();
}

/// Removes an instance from the scene of an instance that the file makes. Returns false if it is in
/// no such scene.
bool KeptTweaks::remove_part(const std::string& path) {
    const std::string made = made_above(path);
    if (made.empty()) return false;
    const Node& node = *member("created", made);
    try {
        SceneEdit edit(tree_, std::string(document_->raw(node)), "its scene");
        (void)edit.remove(steps_between(made, path));
        put("created", made, without_indent(edit.text(), *document_, node));
        fold();
        return true;
    } catch (const Error&) {  // a script makes it
        return false;
    }
}

/// `paths` must not contain a path below another one of them.
std::vector<std::string> KeptTweaks::forget_beside(const std::vector<std::string>& paths) {
    fold();
    const PathSet set(paths);
    std::vector<std::string> before = about(set, paths);
    for (const auto& [section, key] : all_keys())
        if (!set.above(section == "values" ? split_path(key).first : key).empty())
            drop(section, key);
    for (const std::string& path : contents_.deleted)
        for (const std::size_t each : set.above(path))
            if (paths[each] != path) drop("deleted", path);
    delete_moved_into(set, paths);
    fold();
    rename_in_references([&](const std::string& named) -> std::optional<std::string> {
        if (!set.above(named).empty()) return std::string();
        return std::nullopt;
    });
    return before;
}

/// What the file moves below one of the paths is deleted with it: without a move, in its own place.
void KeptTweaks::delete_moved_into(const PathSet& set, const std::vector<std::string>& paths) {
    InstanceMoves others;
    std::vector<std::pair<const Moved*, std::string>> below;  // with the path of what is deleted
    for (const Moved& each : contents_.moved) {
        const std::vector<std::size_t> above = set.above(each.now);
        if (above.empty() || paths[above.front()] == each.now)
            others.add(each.home, each.now);
        else
            below.emplace_back(&each, paths[above.front()]);
    }
    for (const auto& [each, path] : below) {
        drop("moved", each->key);
        const std::string at = others.now(each->home);
        const bool with_it =
            (!makes(path) && is_at_or_below(each->home, contents_.moves.home(path)));
        if (!with_it && std::ranges::none_of(contents_.deleted, [&](const std::string& deleted) {
                return is_at_or_below(at, deleted);
            }))
            put_deleted(at);
    }
}

/// For each path, the entries of the file about the instance, about instances below it, and with
/// references to these.
std::vector<std::string> KeptTweaks::about(const PathSet& set,
                                           const std::vector<std::string>& paths) const {
    // values, created, deleted, moved
    std::vector<std::array<std::string, 4>> lists(paths.size());
    const auto append = [&](std::string& list, const std::string& section, const std::string& key) {
        list += list.empty() ? "" : ", ";
        append_quoted(list, key);
        list += ": " + text_of(section, key);
    };
    for (std::size_t i = 0; i < paths.size(); ++i)
        if (const std::string made = made_above(paths[i]); !made.empty() && made != paths[i])
            append(lists[i][1], "created", made);
    for (const auto& [section, key] : all_keys()) {
        const bool value = section == "values";
        std::unordered_set<std::size_t> meant;
        const auto note = [&, &all = meant](const std::string& path) {
            for (const std::size_t each : set.above(path)) all.insert(each);
        };
        note(value ? split_path(key).first : key);
        // An entry that is removed itself is reported for its own path only.
        if (meant.empty())
            (void)with_paths(section, key, [&](const std::string& named) {
                note(named);
                return std::optional<std::string>();
            });
        for (const std::size_t each : meant)
            if (value || made_above(paths[each]) != key || key == paths[each])
                append(lists[each][value ? 0 : 1], section, key);
    }
    for (const std::string& path : contents_.deleted)
        for (const std::size_t each : set.above(path)) {
            std::string& list = lists[each][2];
            list += list.empty() ? "" : ", ";
            append_quoted(list, path);
        }
    for (const Moved& each : contents_.moved)
        for (const std::size_t above : set.above(each.now))
            if (paths[above] != each.now) append(lists[above][3], "moved", each.key);
    std::vector<std::string> texts;
    texts.reserve(lists.size());
    for (const auto& [values, created, deleted, moved] : lists)
        texts.push_back("{\"values\": {" + values + "}, \"created\": {" + created +
                        "}, \"deleted\": [" + deleted + "]" +
                        (moved.empty() ? "" : ", \"moved\": {" + moved + "}") + "}");
    return texts;
}

void KeptTweaks::put_back(const std::string& path, const std::string& taken_out,
                          const std::string& scene) {
    drop("deleted", path);
    if (taken_out.empty()) return;
    const Document document(taken_out, "journal");
    if (const Node* all = document.member(document.root(), "deleted"))
        for (const Node* node = document.first(*all); node; node = document.next(*node))
            put("deleted", document.text(*node), std::string(document.raw(*node)));
    if (const Node* all = document.member(document.root(), "moved"))
        for (const Node* node = document.first(*all); node; node = document.next(*node)) {
            drop("deleted", contents_.moves.now(document.key(*node)));
            put("moved", document.key(*node), std::string(document.raw(*node)));
        }
    for (const char* section : {"values", "created"})
        if (const Node* all = document.member(document.root(), section))
            for (const Node* node = document.first(*all); node; node = document.next(*node)) {
                const std::string& key = document.key(*node);
                const std::string about =
                    section == std::string_view("values") ? split_path(key).first : key;
                // The instance of this entry may have been deleted as well.
                if (is_at_or_below(about, path) || instance(about))
                    put(section, key, std::string(document.raw(*node)));
            }
    fold();
    name_as_in(path, scene);
}

/// Sets the references of tweaks at `path` and below it to those of `scene`.
void KeptTweaks::name_as_in(const std::string& path, const std::string& scene) {
    const NewPath none = [](const std::string&) { return std::optional(std::string()); };
    const SceneEdit now(tree_, scene, "its scene");
    for (const auto& [section, key] : all_keys()) {
        const std::string about = section == "values" ? split_path(key).first : key;
        const bool below = is_at_or_below(about, path);
        const bool above = section == "created" && is_at_or_below(path, about);
        if ((!below && !above) || !with_paths(section, key, none)) continue;
        const SceneSteps there = below ? steps_between(path, about) : SceneSteps();
        if (section == "values") {
            put(section, key, now.value(there, split_path(key).second));
        } else {
            SceneEdit edit(tree_, text_of(section, key), "its scene");
            edit.name_as_in(below ? SceneSteps() : steps_between(about, path), now, there);
            put(section, key, edit.text());
        }
    }
}

}  // namespace fettle::property
