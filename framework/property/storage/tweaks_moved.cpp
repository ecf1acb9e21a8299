// Tweaks: instances that get another name or another parent.

#include <fettle/property/path.h>

#include "scene_edit.h"
#include "scene_names.h"
#include "scene_text.h"
#include "tweaks_state.h"

namespace fettle::property {

void Tweaks::State::moved(Handle instance, Handle old_parent, const std::string& old_name) {
    if (is_fresh(instance)) return;
    const bool was = old_parent && tree.alive(old_parent) && attached(old_parent);
    const bool is = attached(instance);
    if (!was && is) return born(instance);
    if (!was) return;
    const std::string suffix = path_suffix(old_name);
    const std::string old_path = old_parent != tree.root() ? tree.path(old_parent) + suffix
                                 : suffix.starts_with('.') ? suffix.substr(1)
                                                           : "game" + suffix;
    if (!is) return bury(instance, old_path);
    const std::string path = tree.path(instance);
    if (moved_with_creation(instance, old_parent, old_name, old_path)) return;
    Entry* last = entries.empty() ? nullptr : entries.back().get();
    const bool again = last != nullptr && last->row.kind == Kind::moved &&
                       last->handle == instance && last->row.now == old_path;
    Entry& move =
        again ? *last : entry(Kind::moved, old_path, std::to_string(last_number + 1), instance);
    if (!again) tell_origin(move, instance);
    move.row.property.clear();
    move.row.now = path;
    move.row.was_text = move.row.instance;
    move.row.now_text = "moved to " + path;
    move.gone = path == move.row.instance;
    touch(move);
}

/// What an edit has made is one tweak: it is made under the name and the parent that it has now.
/// False where no edit has made it that can still be changed.
bool Tweaks::State::moved_with_creation(Handle instance, Handle old_parent,
                                        const std::string& old_name, const std::string& old_path) {
    const auto known = created.find(key(instance));
    if (known != created.end()) {
        Entry& made = *known->second;
        if (made.gone || made.row.state != RowState::open) return false;
        try {
            SceneEdit edit(tree, made.row.now, "journal");
            edit.rename({}, tree.name(instance));
            made.row.now = edit.text();
        } catch (const Error&) {  // a name that no file can hold: told when it is kept
            return false;
        }
        repath(instance, old_path);
        made.row.file.clear();
        made.row.inside.clear();
        tell_origin(made, tree.parent(instance));
        touch(made);
        return true;
    }
    Entry* above = created_above(old_parent);
    if (above == nullptr || created_above(tree.parent(instance)) != above) return false;
    refresh_created(*above);  // what was edited so far has the old names
    try {
        if (tree.parent(instance) != old_parent)
            throw Error(ErrorKind::bad_structure, "it has another shape now");
        SceneSteps steps{{old_name, SIZE_MAX}};
        for (Handle at = old_parent; at != above->handle; at = tree.parent(at))
            steps.insert(steps.begin(), SceneStep{tree.name(at), SIZE_MAX});
        SceneEdit edit(tree, above->row.now, "journal");
        edit.rename(steps, tree.name(instance));
        above->row.now = edit.text();
    } catch (const Error&) {
        try {
            above->row.now = scene_text_with_full_paths(tree, above->handle, nullptr);
        } catch (const Error& error) {
            warn(tree.path(above->handle) + " cannot be journaled: " + error.what());
        }
    }
    repath(instance, old_path);
    touch(*above);
    return true;
}

/// Tweaks of what is at the instance or below it, and those that name it, say where it is now.
void Tweaks::State::repath(Handle instance, const std::string& old_path) {
    const NewPath now_at = moved_path(old_path, tree.path(instance));
    const std::string quoted = mention_of(old_path);
    for (const auto& each : entries) {
        Entry& its = *each;
        if (its.gone || its.row.state != RowState::open) continue;
        if (its.row.kind == Kind::moved) {
            if (const auto now = now_at(its.row.now)) its.row.now = *now, touch(its);
            continue;
        }
        const bool about = its.row.kind == Kind::deleted ||
                           (tree.alive(its.handle) &&
                            (its.handle == instance || tree.is_below(its.handle, instance)));
        if (const auto now = now_at(its.row.instance); now && about) {
            const std::string start = std::to_string(static_cast<int>(its.row.kind));
            const std::string end = '\n' + its.row.property;
            if (const auto found = by_key.find(start + its.row.instance + end);
                found != by_key.end() && found->second == &its)
                by_key.erase(found);
            by_key[start + *now + end] = &its;
            its.row.instance = *now;
            touch(its);
        }
        try {
            if (its.row.kind == Kind::value && its.now.value.find(quoted) != std::string::npos) {
                its.now.value = value_with_paths(its.now.value, now_at);
                touch(its);
            } else if (its.row.kind == Kind::created &&
                       its.row.now.find(quoted) != std::string::npos) {
                its.row.now = scene_with_paths(tree, its.row.now, now_at);
                touch(its);
            }
        } catch (const Error&) {  // what is wrong with it is told when it is kept
        }
    }
}

}  // namespace fettle::property
