// The tweaks at the moment of the game: they follow it when it goes back in time, to another branch
// or to a snapshot. An edit of a value that is not in that moment stays as it was: going
// back loses no edit of a value. Files do not go back: what was kept is in them at every moment,
// and what was dropped stays dropped.

#include <algorithm>
#include <utility>

#include <tweaks/tweaks_state.h>

namespace fettle::property {

namespace {

using Kind = JournalRow::Kind;
using RowState = JournalRow::State;

}  // namespace

EditMoment Tweaks::State::moment() {
    settle();
    make_fresh_entries();
    if (moments.last != nullptr) return {moments.last, 0};
    auto now = std::make_shared<Moment>();
    now->of = moments.mark;
    std::size_t bytes = sizeof(Moment) + entries.size() * sizeof(now->entries[0]);
    now->entries.reserve(entries.size());
    for (const auto& each : entries) {
        Entry& its = *each;
        if (its.away) continue;
        if (its.saved == nullptr) {
            const EntryState& state = its;
            its.saved =
                std::make_shared<const SavedEntry>(SavedEntry{state, moments.renames.size()});
            bytes += sizeof(SavedEntry) + its.values.bytes() + its.scene.size() +
                     2 * (its.row.now.size() + its.row.was.size() + its.row.inside.size() +
                          its.row.instance.size() + its.row.file.size());
        }
        now->entries.push_back(its.saved);
    }
    moments.last = std::move(now);
    return {moments.last, bytes};
}

/// A state of a file or of another tree does not say which edits hold: all stay.
void Tweaks::State::went_to(const std::shared_ptr<const void>& state) {
    auto to = std::static_pointer_cast<const Moment>(state);
    if (to != nullptr && to->of == moments.mark) moments.pending = std::move(to);
}

void Tweaks::State::settle() {
    const std::shared_ptr<const Moment> to = std::exchange(moments.pending, nullptr);
    if (to == nullptr || to == moments.last || tree_life.expired()) return;
    fresh.clear();
    std::vector<bool> holds(entries.size());
    for (const auto& saved : to->entries) {
        const auto index_of = static_cast<std::size_t>(saved->state.row.number) - 1;
        holds[index_of] = true;
        put(*entries[index_of], saved);
    }
    for (std::size_t i = 0; i < entries.size(); ++i)
        if (!holds[i]) leave(*entries[i]);
    refresh_paths_of_later_values();
    withdraw_replaced_creations();
    // Several entries may have had one path; that of the instance which is there now comes last.
    std::vector<Entry*> all;
    for (const auto& each : entries)
        if (each->row.kind != Kind::created && each->row.kind != Kind::moved)
            all.push_back(each.get());
    const auto rank = [this](const Entry* its) {
        const bool there =
            !its->away && tree.alive(its->handle) && tree.path(its->handle) == its->row.instance;
        return there ? 2 : its->away ? 0 : 1;
    };
    std::ranges::stable_sort(all, {}, rank);
    by_key.clear();
    for (Entry* its : all)
        by_key[key_of(its->row.kind, its->row.instance, its->row.property)] = its;
    moments.last = nullptr;
    barriers_to_retry = 0;
}

void Tweaks::State::put(Entry& its, const std::shared_ptr<const SavedEntry>& saved) {
    if (its.saved == saved && !its.away) return;
    its.away = false;
    if (its.left != nullptr) its.left->state = RowState::dropped;
    std::string kept_in = std::move(its.row.kept_in);
    static_cast<EntryState&>(its) = saved->state;
    its.row.kept_in = std::move(kept_in);
    for (std::size_t i = saved->renames; i < moments.renames.size(); ++i) moments.renames[i](its);
    its.row.state = state_now(its);
    if (its.row.state != RowState::kept && its.in_file) its.was = *its.in_file;
    index(its);
    add_to_dirty(its);
}

/// An instance that is made, deleted or moved later is listed as one of an earlier run is: the edit
/// can be kept, or made again at this moment. A kept one stays listed as kept: the file has it.
void Tweaks::State::leave_behind(Entry& its) {
    if (its.dirty && its.row.state == RowState::open) refresh(its);
    JournalRow row = its.row;
    row.run = JournalRow::left_behind;
    if (its.left != nullptr)
        *its.left = std::move(row);
    else
        its.left = &earlier.rows.emplace_back(std::move(row));
}

/// A person edits the instance, or adds to it: it is wanted at this moment, so deleting it or what
/// it is in, at a later moment that was left, is not listed any more.
void Tweaks::State::withdraw_left_deletions(Handle instance) {
    if (by_instance.deleted.empty()) return;
    for (Handle at = instance; at; at = tree.parent(at)) {
        const auto found = by_instance.deleted.find(at.key());
        if (found == by_instance.deleted.end() || found->second->left == nullptr) continue;
        const bool journaled = is_left_behind(*found->second);
        found->second->left->state = RowState::dropped;
        if (journaled) add_to_dirty(*found->second);
    }
}

/// What was made at another moment is not listed while something is there that a person made with
/// the same path.
void Tweaks::State::withdraw_replaced_creations() {
    for (JournalRow& row : earlier.rows) {
        if (row.run != JournalRow::left_behind || row.state != RowState::open ||
            row.kind != Kind::created)
            continue;
        const bool replaced =
            std::ranges::any_of(at_or_below(row.instance), [&](const Entry* each) {
                return each->row.kind == Kind::created && each->row.instance == row.instance &&
                       visible(*each);
            });
        if (!replaced) continue;
        row.state = RowState::dropped;
        add_to_dirty(entry_of(row));
    }
}

/// The edit does not hold at this moment. An edited value stays in the list, so that it can be kept
/// after going back. What a file contains is still true of the instance.
void Tweaks::State::leave(Entry& its) {
    if (its.away) return;
    const bool of_instance = its.row.kind == Kind::created || its.row.kind == Kind::deleted ||
                             its.row.kind == Kind::moved;
    if (of_instance && visible(its)) leave_behind(its);
    its.away = true;
    // Also if its instance is made later: it has the path that it had then.
    if (its.row.kind == Kind::value) return;
    const bool in_file = its.kept_version > 0 && tree.alive(its.handle) && attached(its.handle);
    if (its.row.kind == Kind::moved && in_file) {  // the file has the later name
        its.row.state = RowState::open;
        its.row.now = tree.path(its.handle);
        its.gone = is_home(its);
    } else if (its.row.kind != Kind::deleted || !in_file ||
               by_instance.created.contains(its.handle.key())) {
        its.gone = true;
    }
    index(its);
    add_to_dirty(its);
}

/// Values that are edited later stay listed. Their instances may have other paths at this moment.
void Tweaks::State::refresh_paths_of_later_values() {
    for (const auto& each : entries) {
        Entry& its = *each;
        if (!its.away || its.row.kind != Kind::value || !tree.alive(its.handle) ||
            !attached(its.handle) || tree.path(its.handle) == its.row.instance)
            continue;
        refresh_path(its);
        index(its);
        add_to_dirty(its);
    }
}

Tweaks::State::RowState Tweaks::State::state_now(const Entry& its) {
    const bool by_version = its.row.kind == Kind::value || its.row.kind == Kind::moved;
    if (its.kept_version > 0 && (!by_version || its.kept_version == its.version))
        return RowState::kept;
    return its.version <= its.dropped_version ? RowState::dropped : RowState::open;
}

void Tweaks::State::add_to_dirty(Entry& its) {
    if (std::exchange(its.dirty, true)) return;
    dirty.push_back(&its);
}

void Tweaks::State::rename_in_entries(std::function<void(Entry&)> rename) {
    for (const auto& each : entries) rename(*each);
    moments.renames.push_back(std::move(rename));
}

}  // namespace fettle::property
