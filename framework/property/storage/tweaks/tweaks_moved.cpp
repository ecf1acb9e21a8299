// Tweaks of instances that get another name or parent.

#include <algorithm>
#include <utility>

#include <fettle/property/path.h>

#include <scenes/scene_edit.h>
#include <scenes/scene_names.h>
#include <scenes/scene_text.h>
#include <tweaks/removed_text.h>
#include <tweaks/tweaks_state.h>

namespace fettle::property {

void Tweaks::State::moved(Handle instance, Handle old_parent, const std::string& old_name) {
    settle();
    const bool was = old_parent && tree.alive(old_parent) && attached(old_parent);
    const bool is = attached(instance);
    const std::string old_path = was ? path_below(tree.path(old_parent), old_name) : std::string();
    if (was) rename_mentions(old_path, is ? tree.path(instance) : path_of_deleted(instance));
    if (fresh.contains(instance)) return;
    // An instance inside a new one is part of its tweak, unless it has tweaks of its own.
    const bool known =
        by_instance.created.contains(instance.key()) || by_instance.moved.contains(instance.key());
    const bool into_new = is_fresh(instance), out_of_new = old_parent && is_fresh(old_parent);
    if (out_of_new && !known) return;
    if (into_new || out_of_new) make_fresh_entries(instance);
    if (!was && is) return instance_created(instance);
    if (!was) return;
    if (!is) return note_deletion(instance, old_parent, old_path);
    if (moved_with_creation(instance, old_parent, old_path)) return;
    Entry*& its = by_instance.moved[instance.key()];
    const bool first = its == nullptr;
    if (first) its = &add_entry(Kind::moved, old_path, instance);
    Entry& move = *its;
    move.away = false;
    if (first) move.gone = true;                      // until its home path is set
    if (first || move.row.state == RowState::kept) {  // the files contain its home path
        move.row.instance = path_below(home_of(old_parent), old_name);
        move.row.now = old_path;
        note_origin(move, instance);
    }
    repath(instance, old_path);
    move.row.now = tree.path(instance);
    move.row.was_text = move.row.instance;
    move.row.now_text = "moved to " + move.row.now;
    touch(move);
    move.gone = is_home(move);
    if (Entry* above = into_new ? created_above(tree.parent(instance)) : nullptr)
        above->values.forget(tree, instance), index(*above);  // it has a tweak of its own
}

bool Tweaks::State::is_home(const Entry& move) const {
    return path_below(home_of(tree.parent(move.handle)), tree.name(move.handle)) ==
           move.row.instance;
}

bool Tweaks::State::deleted_by_path(const std::string& home) const {
    return kept.deletes(home) ||
           std::any_of(by_instance.deleted.begin(), by_instance.deleted.end(),
                       [&](const auto& each) {
                           const Entry& its = *each.second;
                           return !its.gone && its.row.state == RowState::open &&
                                  its.row.file.empty() && its.row.instance == home;
                       });
}

/// Called when a deletion is undone: the instance may have another path now.
void Tweaks::State::refresh_path(Entry& its) {
    if (!tree.alive(its.handle) || !attached(its.handle)) return;
    const std::string path = tree.path(its.handle);
    if (its.row.kind == Kind::moved) {
        its.row.now = path;
        its.row.now_text = "moved to " + path;
        its.gone = is_home(its);
    } else if (its.row.kind == Kind::value || its.row.kind == Kind::created) {
        its.row.instance = path;
        if (its.row.kind == Kind::value) by_key[key_of(Kind::value, path, its.row.property)] = &its;
    }
}

/// The home path of an instance.
std::string Tweaks::State::home_of(Handle instance) const {
    std::vector<std::string> names;
    std::string home = "game";
    for (Handle at = instance; at && at != tree.root(); at = tree.parent(at)) {
        const auto found = by_instance.moved.find(at.key());
        if (found != by_instance.moved.end() && !found->second->gone &&
            found->second->row.state != RowState::kept) {
            home = found->second->row.instance;
            break;
        }
        names.push_back(tree.name(at));
    }
    for (auto name = names.rbegin(); name != names.rend(); ++name) home = path_below(home, *name);
    return home;
}

/// Whether the files give that path to another instance now.
bool Tweaks::State::is_home_of_another(const std::string& home, Handle instance) const {
    for (const auto& each : entries)
        if (each->row.kind == Kind::moved && each->row.state == RowState::open && !each->gone &&
            each->row.instance == home && each->handle != instance)
            return true;
    const Handle there = instance_or_none(tree, home);
    return there && there != instance && !created_above(there) && home_of(there) == home;
}

InstanceMoves Tweaks::State::moves() const {
    InstanceMoves all;
    for (const auto& each : entries)
        if (each->row.kind == Kind::moved && !each->gone && each->row.state != RowState::kept)
            all.add(each->row.instance, each->row.now);
    return all;
}

/// Whether the row is about an instance that is in no file because its deletion was kept.
bool Tweaks::State::is_removed(const JournalRow& row) {
    return (row.kind == Kind::deleted && row.state == RowState::kept) ||
           (row.kind == Kind::restored && row.state == RowState::open);
}

void Tweaks::State::homes_changed(const NewPath& now_at) {
    for (const auto& each : entries)
        each->taken_out = with_new_homes(tree, each->taken_out, each->row.instance, now_at);
    rename_in_entries([this, now_at](Entry& its) {
        JournalRow& row = its.row;
        if (row.kind == Kind::value || row.kind == Kind::created) return;
        const bool in_no_file = is_removed(row) && !its.gone;
        bool renamed = false;
        if (row.kind == Kind::restored) {
            const std::string was = with_new_homes(tree, row.was, row.instance, now_at);
            renamed = std::exchange(row.was, was) != was;
        }
        const std::string now = in_no_file ? home_of_removed(row.instance, now_at)
                                           : now_at(row.instance).value_or(row.instance);
        if (now != row.instance) {
            renamed = true;
            if (row.kind != Kind::moved) rekey(its, now);
            row.instance = now;
            // The list shows a kept one as it was made.
            if (row.kind == Kind::moved && row.state != RowState::kept) row.was_text = row.instance;
        }
        index(its);
        if (renamed && row.state == RowState::open && !its.gone) add_to_dirty(its);
    });
    for (JournalRow& row : earlier.rows) {
        if (row.kind != Kind::restored) continue;
        row.was = with_new_homes(tree, row.was, row.instance, now_at);
        renamed_earlier(row);
    }
}

void Tweaks::State::renamed_earlier(JournalRow& row) {
    if (row.state == RowState::open && row.run > 0) earlier.renamed.push_back(&row);
}

void Tweaks::State::steps_renamed(const std::filesystem::path& file,
                                  const SceneOrigins::Names& names) {
    const auto rename = [file, names](JournalRow& row, std::string* taken_out, bool gone) {
        const bool here = row.file == file.string() && !row.inside.empty();
        const SceneSteps steps = here ? read_steps(row.inside) : SceneSteps();
        for (std::string* text : {taken_out, row.kind == Kind::restored ? &row.was : nullptr})
            if (text != nullptr)
                *text = with_new_steps(*text, here ? &steps : nullptr, file, names);
        if (!here) return;
        row.inside = steps_text(is_removed(row) && !gone ? steps_of_removed(steps, names)
                                                         : renamed_steps(steps, names));
    };
    for (const auto& each : entries) {
        JournalRow copy = each->row;
        rename(copy, &each->taken_out, each->gone);
    }
    rename_in_entries([this, rename](Entry& its) {
        const std::string before = its.row.inside;
        rename(its.row, nullptr, its.gone);
        index(its);
        if (its.row.inside != before && its.row.state == RowState::open && !its.gone)
            add_to_dirty(its);
    });
    for (JournalRow& row : earlier.rows) {
        const std::string before = row.inside;
        rename(row, nullptr, false);
        if (row.inside != before) renamed_earlier(row);
    }
}

void Tweaks::State::part_moved(const JournalRow& move, Handle part) {
    if (move.file.empty() || move.inside.empty()) return;
    const auto forget = [](JournalRow& row) {
        row.file.clear();
        row.inside.clear();
    };
    // Rows of earlier runs are found by their places.
    const std::string file = move.file;
    const SceneSteps steps = read_steps(move.inside);
    const std::string top = steps_text(steps);
    for (JournalRow& row : earlier.rows) {
        if (row.file != file || row.state != RowState::open) continue;
        SceneSteps its = read_steps(row.inside);
        its.resize(std::min(its.size(), steps.size()));
        if (steps_text(its) != top || !is_at_or_below(row.instance, move.instance)) continue;
        forget(row);
        renamed_earlier(row);
    }
    rename_in_entries([this, forget, part](Entry& its) {
        const bool about = tree.alive(its.handle) && tree.alive(part) &&
                           (its.handle == part || tree.is_below(its.handle, part));
        if (!about || its.row.file.empty() || its.row.kind == Kind::deleted) return;
        forget(its.row);
        if (its.row.state == RowState::open && !its.gone) add_to_dirty(its);
    });
    origins.forget_part(tree, part);
}

void Tweaks::State::set_former_value(const JournalRow& row) {
    const auto found = by_key.find(key_of(Kind::value, row.instance, row.property));
    if (found == by_key.end()) return;
    Image& was = found->second->was;
    const std::string& unit = found->second->now.unit;
    was = read_image(row.now);
    was.text = row.now_text;  // with its unit
    if (!unit.empty() && was.text.ends_with(unit)) {
        was.text.resize(was.text.size() - unit.size());
        was.unit = unit;
    }
    found->second->in_file = was;
    index(*found->second);
}

/// Changes the key by which the entry is found.
void Tweaks::State::rekey(Entry& its, const std::string& path) {
    const auto found = by_key.find(key_of(its.row.kind, its.row.instance, its.row.property));
    if (found == by_key.end() || found->second != &its) return;
    by_key.erase(found);
    by_key[key_of(its.row.kind, path, its.row.property)] = &its;
}

/// A move of a new instance changes its creation, which is one tweak with the current name and
/// parent. False if there is no open tweak that created the instance.
bool Tweaks::State::moved_with_creation(Handle instance, Handle old_parent,
                                        const std::string& old_path) {
    const auto known = by_instance.created.find(instance.key());
    if (known != by_instance.created.end()) {
        Entry& made = *known->second;
        if (made.gone || made.row.state != RowState::open) return false;
        std::string quoted;
        if (!append_quoted(quoted, tree.name(instance)))
            return false;  // no file can have that name
        repath(instance, old_path);
        made.row.file.clear();
        made.row.inside.clear();
        note_origin(made, tree.parent(instance));
        touch(made);
        return true;
    }
    Entry* above = created_above(old_parent);
    if (above == nullptr) return false;
    if (created_above(tree.parent(instance)) != above) {
        if (!taken_out_of_creation(instance, old_parent)) return false;
        instance_created(instance);  // it has its own tweak from now on
        return true;
    }
    repath(instance, old_path);
    touch(*above);
    return true;
}

/// Updates the paths of tweaks about the instance, and about instances below it.
void Tweaks::State::repath(Handle instance, const std::string& old_path) {
    const NewPath now_at = moved_path(old_path, tree.path(instance));
    for (const auto& each : entries) {
        Entry& its = *each;
        if (its.row.state == RowState::kept && its.row.kind != Kind::value) continue;
        if (its.row.kind == Kind::restored) continue;  // it contains the home path
        const bool open = its.row.state == RowState::open && !its.gone;
        if (its.row.kind == Kind::moved || its.row.kind == Kind::deleted) {
            if (const auto now = now_at(its.row.now)) {
                its.row.now = *now;
                if (open)
                    touch(its);
                else
                    index(its);
            }
            continue;
        }
        const bool about = tree.alive(its.handle) &&
                           (its.handle == instance || tree.is_below(its.handle, instance));
        if (const auto now = now_at(its.row.instance); now && about) {
            rekey(its, *now);
            its.row.instance = *now;
            if (open)
                touch(its);
            else
                index(its);
        }
    }
}

void Tweaks::State::rename_mentions(const std::string& from, const std::string& to) {
    const NewPath now_at = moved_path(from, to);
    const std::string quoted = mention_of(from);
    std::vector<std::pair<Entry*, std::string>> values_named_again;
    for (Entry* const each : in_order({naming.begin(), naming.end()})) {
        Entry& its = *each;
        const bool open = its.row.state == RowState::open && !its.gone;
        bool renamed = false;
        const auto rename_in = [&](std::string& text, auto with_paths) {
            if (text.find(quoted) == std::string::npos) return;
            text = with_paths(text);
            renamed = true;
        };
        try {
            if (its.row.kind == Kind::value) {
                for (Image* image : {&its.was, &its.now, its.in_file ? &*its.in_file : nullptr})
                    if (image != nullptr)
                        rename_in(image->value, [&](const std::string& value) {
                            return value_with_paths(value, now_at);
                        });
            } else if (its.row.kind == Kind::created)
                renamed = its.values.rename(tree, quoted, now_at);
            else
                rename_in(its.scene, [&](const std::string& scene) {
                    return scene_with_paths(tree, scene, now_at);
                });
        } catch (const Error&) {  // errors are reported on keeping
        }
        if (renamed && open)
            touch(its);
        else if (renamed)
            index(its);
        // It was kept as null while the target of the reference was deleted.
        if (!renamed || its.row.state != RowState::kept || its.gone || !is_of_deleted(from))
            continue;
        if (its.row.kind == Kind::value) {
            its.was.value = "null";
            its.in_file = its.was;
            touch(its);
        } else if (its.row.kind == Kind::created && tree.alive(its.handle)) {
            values_named_again.emplace_back(&its, to);
        }
    }
    for (const auto& [its, path] : values_named_again) add_reference_tweaks(*its, path);
}

/// Adds tweaks for references to a restored instance: new instances were kept with null in their
/// places.
void Tweaks::State::add_reference_tweaks(Entry& made, const std::string& path) {
    const NewPath none = [&](const std::string& named) -> std::optional<std::string> {
        if (is_at_or_below(named, path)) return std::string();
        return std::nullopt;
    };
    refresh_created(made);
    index(made);
    const SceneEdit scene(tree, made.scene, "journal");
    for (const SceneEdit::NamingValue& each : scene.naming_values(none)) {
        Handle instance = made.handle;
        for (const SceneStep& step : each.steps)
            if (instance) instance = tree.child(instance, step.name);
        const Property* property =
            instance ? tree.find(instance, scene.document().key(*each.node)) : nullptr;
        if (property == nullptr) continue;
        bool begins = false;
        Entry& its = entry(Kind::value, tree.path(instance), property->name, instance, &begins);
        if (begins) {
            its.was.kind = Image::Kind::by_default;
            note_origin(its, instance);
        }
        its.property = property->symbol;
        its.now = image_now(tree, instance, property->symbol, false);
        its.gone = false;
        touch(its);
    }
}

}  // namespace fettle::property
