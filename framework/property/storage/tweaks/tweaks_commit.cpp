// Tweaks: from entries to rows of the journal, once per barrier.

#include <algorithm>
#include <tuple>
#include <utility>

#include <fettle/property/exception_text.h>
#include <fettle/property/path.h>

#include <json/document.h>
#include <scenes/scene_names.h>
#include <scenes/scene_text.h>
#include <tweaks/tweaks_state.h>

namespace fettle::property {

namespace {

// Number of barriers after a failed commit (full disk) before the next attempt. A new edit tries at
// once.
constexpr int barriers_before_retry = 60;
// Maximum bytes of the texts for people, such as the text of a formula.
constexpr std::size_t longest_shown = 5000;
// Occurs in every JSON text with a reference to a deleted instance.
constexpr std::string_view mention_of_deleted = "\"game[\\\"\\\\000";

/// A row that a later run could not read.
bool is_too_large(const JournalRow& row) {
    return std::max(row.was.size(), row.now.size()) > Document::size_limit;
}

}  // namespace

bool Tweaks::State::visible(const Entry& entry) const {
    if (entry.gone || entry.row.state == RowState::dropped) return false;
    return entry.row.kind == Kind::value ? !(entry.was == entry.now) : !entry.away;
}

void Tweaks::State::barrier() {
    settle();
    if (fresh.empty() && dirty.empty() && earlier.changed.empty() && earlier.renamed.empty() &&
        earlier.removed.empty())
        return;
    if (barriers_to_retry > 0) {
        --barriers_to_retry;
        return;
    }
    make_fresh_entries();
    reopen_undone_rows();
    for (Entry* entry : dirty) {
        refresh(*entry);
        index(*entry);
    }
    commit();
}

// --- Created instances ---------------------------------------------------------------------------

/// Makes tweaks of the instances created since the last call. `moving`: an instance that was just
/// moved below another parent, and existed before the new ones.
void Tweaks::State::make_fresh_entries(Handle moving) {
    const FreshInstances made = std::exchange(fresh, {});
    std::unordered_set<std::uint64_t> seen;  // restored instances are in the list twice
    for (const Handle instance : made.in_order()) {
        if (!tree.alive(instance) || !attached(instance)) continue;
        if (!seen.insert(instance.key()).second) continue;
        // An instance below a new one is part of the tweak of the new one.
        bool inside = false;
        for (Handle at = tree.parent(instance); at && at != moving && !inside; at = tree.parent(at))
            inside = made.contains(at);
        const bool was_there = by_instance.deleted.contains(instance.key()) ||
                               by_instance.created.contains(instance.key());
        if (!inside || was_there) make_fresh_entry(instance);
    }
}

void Tweaks::State::make_fresh_entry(Handle instance) {
    const std::string path = tree.path(instance);
    if (undelete_if_deleted(instance)) return;
    const auto known = by_instance.created.find(instance.key());
    // The deletion or creation was undone. Instances made below it since then have their own tweaks
    // again and are not part of its scene.
    if (known != by_instance.created.end()) revive(*known->second);
    Entry fresh_one;
    fresh_one.handle = instance;
    std::vector<std::string> warnings;
    try {
        note_values(fresh_one, &warnings);
    } catch (const Error& error) {
        return warn(path + " is new, but cannot be journaled: " + error.what());
    }
    for (const std::string& warning : warnings) warn(warning);
    // Made again by redo: the game has changed its values meanwhile, a person has not.
    if (known != by_instance.created.end()) fresh_one.values.take_from(known->second->values);
    Entry& its = known != by_instance.created.end() ? *known->second
                                                    : add_entry(Kind::created, path, instance);
    for (JournalRow& row : earlier.rows)  // it takes the place of one that was left behind
        if (row.run == JournalRow::left_behind && row.kind == Kind::created && row.instance == path)
            row.state = RowState::dropped;
    its.row.instance = path;
    its.scene = std::move(fresh_one.scene);
    its.values = std::move(fresh_one.values);
    its.row.was_text = "nothing";
    its.row.now_text = "new " + tree.class_of(instance).name();
    its.gone = its.away = false;
    its.inside.clear();
    by_instance.created[instance.key()] = &its;
    its.row.file.clear();
    its.row.inside.clear();
    origins.forget(tree, instance);  // its own tweak describes it completely
    note_origin(its, tree.parent(instance));
    touch(its);
}

/// Takes the scene of a new instance from the tree, without instances below it that have their own
/// tweaks.
void Tweaks::State::note_values(Entry& made, std::vector<std::string>* warnings) {
    const auto has_own = [&](Handle instance) {
        if (instance == made.handle) return false;
        for (const auto* const known : {&by_instance.created, &by_instance.moved})
            if (const auto its = known->find(instance.key());
                its != known->end() && !its->second->gone)
                return true;
        return false;
    };
    made.values.clear();
    made.scene = scene_text_with_full_paths(tree, made.handle, warnings, has_own, &made.values);
}

/// Whether the deletion of the instance was undone, so that no new entry is needed.
bool Tweaks::State::undelete_if_deleted(Handle instance) {
    const auto found = by_instance.deleted.find(instance.key());
    if (found == by_instance.deleted.end() || found->second->gone) return false;
    return undelete(*found->second);
}

/// False if the instance needs an entry as a new instance.
bool Tweaks::State::undelete(Entry& deletion) {
    const bool in_file = deletion.row.state == RowState::kept;
    revive(deletion);
    if (in_file && !by_instance.created.contains(deletion.handle.key())) {
        if (!is_home_of_another(deletion.row.instance, deletion.handle)) {
            restored(deletion.handle, deletion);
            return true;
        }
        if (const auto moved = by_instance.moved.find(deletion.handle.key());
            moved != by_instance.moved.end()) {
            moved->second->gone = true;
            touch(*moved->second);
        }
    }
    deletion.gone = true;
    touch(deletion);
    return !in_file;
}

/// The deletion was kept before it was undone, so the file has to get its former content back.
void Tweaks::State::restored(Handle instance, Entry& deletion) {
    Entry& its = entry(Kind::restored, deletion.row.instance, {}, instance);
    try {
        its.scene = scene_text_with_full_paths(tree, instance, nullptr);
    } catch (const Error& error) {
        return warn(tree.path(instance) + " is back, but cannot be journaled: " + error.what());
    }
    its.row.was = deletion.taken_out;
    its.row.was_text = "deleted";
    its.row.now_text = "deleted no longer";
    its.row.file = deletion.row.file;
    its.row.inside = deletion.row.inside;
    its.gone = false;
    by_instance.restored[instance.key()] = &its;
    touch(its);
}

/// Takes values edited since from the tree.
void Tweaks::State::refresh_values(Entry& entry) {
    for (const auto& [instance, property] : std::exchange(entry.inside, {})) {
        if (!tree.alive(instance) || created_above(instance) != &entry) continue;
        // A script has added the instance: now the scene has all that is there.
        if (!entry.values.has(instance)) return note_values(entry, nullptr);
        const Property* its = tree.find(instance, property);
        const Image image = image_now(tree, instance, property, true);
        if (its == nullptr || image.kind == Image::Kind::absent ||
            image.kind == Image::Kind::by_default) {
            entry.values.remove(instance, property.text());
            continue;
        }
        const Property* declared = tree.class_of(instance).property(property.text());
        entry.values.set(instance, *its, image_in_file(tree, declared, image, {}));
    }
}

/// Writes the scene anew: however many edits were made inside it, once.
void Tweaks::State::refresh_created(Entry& entry) {
    if (!tree.alive(entry.handle) || !attached(entry.handle)) return;
    try {
        refresh_values(entry);
        entry.scene = scene_text_with_values(tree, entry.handle, entry.values);
    } catch (const Error& error) {
        warn(tree.path(entry.handle) + " cannot be journaled: " + error.what());
    }
}

// --- Rows ----------------------------------------------------------------------------------------

/// Replaces references to deleted instances by null. The entry itself keeps their paths, because
/// undo may bring them back.
template <class WithPaths>
std::string Tweaks::State::without_deleted(const std::string& text, WithPaths with_paths) const {
    if (text.find(mention_of_deleted) == std::string::npos) return text;
    try {
        return with_paths([](const std::string& path) -> std::optional<std::string> {
            if (is_of_deleted(path)) return std::string();
            return std::nullopt;
        });
    } catch (const Error&) {  // errors are reported on keeping
        return text;
    }
}

void Tweaks::State::refresh(Entry& entry) {
    if (entry.row.kind == Kind::created || entry.row.kind == Kind::restored) {
        if (entry.row.kind == Kind::created) refresh_created(entry);
        entry.row.now = without_deleted(entry.scene, [&](const NewPath& path) {
            return scene_with_paths(tree, entry.scene, path);
        });
        return;
    }
    if (entry.row.kind != Kind::value) return;
    // A formula is settled now. Any other value is kept as the person entered it, also if something
    // changed it later.
    if (entry.now.kind == Image::Kind::formula && tree.alive(entry.handle))
        entry.now = image_now(tree, entry.handle, entry.property, true);
    entry.row.was = image_json(entry.was);
    Image now = entry.now;
    now.value = without_deleted(
        now.value, [&](const NewPath& path) { return value_with_paths(now.value, path); });
    entry.row.now = image_json(now);
    std::tie(entry.row.was_text, entry.row.now_text) = change_text(entry.was, entry.now);
}

void Tweaks::State::commit() {
    if (journal && journal->vanished()) {
        for (const auto& each : entries) {
            each->committed = false;
            if ((visible(*each) || is_left_behind(*each)) && !each->dirty) {
                each->dirty = true;
                dirty.push_back(each.get());
            }
        }
    }
    Journal::Changes changes;
    const auto belongs_in_journal = [this](const Entry& entry) {
        return (visible(entry) || is_left_behind(entry)) && !is_too_large(entry.row);
    };
    for (Entry* entry : dirty) {
        for (const auto text : {&JournalRow::was_text, &JournalRow::now_text})
            entry->row.*text = shortened(entry->row.*text, longest_shown);
        if (belongs_in_journal(*entry))
            changes.put.push_back(&entry->row);
        else if (entry->committed)
            changes.withdrawn.push_back(entry->row.number);
    }
    changes.settled.assign(earlier.changed.begin(), earlier.changed.end());
    changes.renamed.assign(earlier.renamed.begin(), earlier.renamed.end());
    for (const JournalRow& row : earlier.removed) changes.removed.push_back(&row);
    try {
        const bool nothing = changes.put.empty() && changes.withdrawn.empty() &&
                             changes.settled.empty() && changes.renamed.empty() &&
                             changes.removed.empty();
        if (journal && !nothing && !journal->commit(changes))
            return;  // another run is writing; the next barrier tries again
    } catch (const std::exception& error) {
        barriers_to_retry = barriers_before_retry;
        const std::string reason = exception_text(error);
        if (last_failure == reason) return;
        last_failure = reason;
        return warn("tweaks cannot be journaled: " + last_failure + "; those that wait (" +
                    std::to_string(changes.put.size()) + ") are lost if the game ends before");
    }
    for (Entry* entry : dirty) {
        entry->dirty = false;
        entry->committed = belongs_in_journal(*entry);
        if (visible(*entry) && !entry->committed)
            warn("the tweak of " + entry->row.instance +
                 (entry->row.property.empty() ? "" : path_suffix(entry->row.property)) +
                 " is larger than " + std::to_string(Document::size_limit >> 20) +
                 " MB, so it cannot be journaled; it is lost when the game ends");
    }
    dirty.clear();
    earlier.changed.clear();
    earlier.renamed.clear();
    earlier.removed.clear();
    if (!std::exchange(last_failure, {}).empty()) warn("tweaks are journaled again");
}

/// Called at the end of the run: there is no next barrier.
void Tweaks::State::report_lost() {
    if (!journal) return;
    const auto lost = std::count_if(dirty.begin(), dirty.end(),
                                    [this](const Entry* entry) { return visible(*entry); });
    if (lost > 0)
        warn(std::to_string(lost) +
             (lost == 1 ? " tweak is lost, since it" : " tweaks are lost, since they") +
             " could not be journaled: " +
             (last_failure.empty() ? "another run of the game is writing" : last_failure));
}

}  // namespace fettle::property
