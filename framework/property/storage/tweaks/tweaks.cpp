// Tweaks: from edits to entries. An entry is about a property, or about an instance that a person
// created, deleted or moved. Further edits of the same object change its entry.

#include <fettle/property/earlier_writer.h>
#include <fettle/property/exception_text.h>
#include <fettle/property/spelling.h>
#include <fettle/property/storage/tweaks.h>

#include <algorithm>
#include <chrono>
#include <tuple>

#include <files/game_folders.h>
#include <files/temporary_file.h>
#include <tweaks/tweaks_state.h>

namespace fettle::property {

namespace {

/// Makes `files` stay below the folder, and returns it. Must be called before the first file is
/// read.
GameFiles& limit_to_folder(GameFiles& files, const std::filesystem::path& folder) {
    files.stay_below(folder);
    return files;
}

std::int64_t seconds_now() {
    return std::chrono::duration_cast<std::chrono::seconds>(
               std::chrono::system_clock::now().time_since_epoch())
        .count();
}

}  // namespace

// --- Construction

Tweaks::State::State(Tree& its_tree, const std::filesystem::path& game, Journal::Warn its_sink,
                     TweakOptions options)
    : tree(its_tree),
      tree_life(its_tree.lifetime()),
      folder(game_folder(game)),
      sink(std::move(its_sink)),
      not_kept_because(std::move(options.not_kept_because)),
      files(options.files != nullptr ? *options.files : limit_to_folder(own_files, folder)),
      kept(its_tree, files, folder / (game_name(game) + ".tweaks.json"),
           [this](const std::string& text) { warn(text); }) {
    if (options.earlier) {
        std::vector<JournalRow> rows;
        for (const TweakWords& words : *options.earlier) rows.push_back(row_of(words));
        take_earlier(std::move(rows));
    } else {
        journal = std::make_unique<Journal>(journal_folders(game), game_name(game) + ".tweaks",
                                            [this](const std::string& text) { warn(text); });
        take_earlier(journal->earlier());
        remove_leftovers(folder);
    }
    tree.observe_edits(this);
}

/// Takes the valid rows of earlier runs. Invalid rows stay in the journal until they are dropped.
void Tweaks::State::take_earlier(std::vector<JournalRow> rows) {
    std::string first;
    for (JournalRow& row : rows) {
        const std::string problem = problem_of(row);
        if (problem.empty()) {
            earlier.rows.push_back(std::move(row));
            continue;
        }
        if (earlier.invalid.empty()) first = problem;
        earlier.invalid.push_back(std::move(row));
    }
    const std::size_t invalid_count = earlier.invalid.size();
    if (invalid_count == 1)
        warn("1 row that an earlier run has left is not a tweak, and is left aside: " + first +
             "; drop_tweaks(\"**\") removes it");
    else if (invalid_count > 1)
        warn(std::to_string(invalid_count) +
             " rows that earlier runs have left are not tweaks, and are left aside, the first: " +
             first + "; drop_tweaks(\"**\") removes them");
}

void Tweaks::State::give_warnings() {
    while (!untold.empty()) {
        const std::string text = std::move(untold.front());
        untold.erase(untold.begin());
        sink(text);
    }
}

Tweaks::State::~State() {
    if (!tree_life.expired()) tree.observe_edits(nullptr);
}

// --- Edits

std::optional<std::filesystem::path> Tweaks::State::own_file(
    const std::filesystem::path& named) const {
    if (named.empty()) return std::nullopt;
    std::error_code error;
    std::filesystem::path file = std::filesystem::weakly_canonical(named, error);
    const std::filesystem::path inside = file.lexically_relative(folder);
    const bool own = !error && !inside.empty() && *inside.begin() != ".." && files.exists(file);
    return own ? std::optional(std::move(file)) : std::nullopt;
}

bool Tweaks::State::attached(Handle instance) const {
    return instance == tree.root() || tree.is_below(instance, tree.root());
}

bool Tweaks::State::is_fresh(Handle instance) const {
    if (fresh.empty()) return false;
    for (Handle at = instance; at; at = tree.parent(at))
        if (fresh.contains(at)) return true;
    return false;
}

Tweaks::State::Entry* Tweaks::State::created_above(Handle instance) const {
    if (by_instance.created.empty()) return nullptr;
    for (Handle at = instance; at; at = tree.parent(at)) {
        if (const auto found = by_instance.created.find(at.key());
            found != by_instance.created.end())
            return !found->second->gone && found->second->row.state == RowState::open
                       ? found->second
                       : nullptr;
        if (const auto moved = by_instance.moved.find(at.key());
            moved != by_instance.moved.end() && !moved->second->gone)
            return nullptr;  // it existed before
    }
    return nullptr;
}

void Tweaks::State::touch(Entry& entry) {
    if (entry.left != nullptr && !entry.away) entry.left->state = RowState::dropped;
    entry.version = ++last_version;
    entry.row.state = RowState::open;
    entry.row.step = static_cast<std::int64_t>(tree.step());
    entry.row.time = seconds_now();
    index(entry);
    barriers_to_retry = 0;
    add_to_dirty(entry);
}

void Tweaks::State::note_origin(Entry& entry, Handle instance) const {
    const auto origin = origins.find(instance);
    if (!origin) return;
    entry.row.file = origin->file.string();
    entry.row.inside = steps_text(origin->steps);
}

/// Before the present edit.
bool Tweaks::State::is_given_by_script(Handle instance, const Property& property) const {
    const std::uint64_t step = tree.step();
    // A value that derives from others is not simulated any more when a script sets it.
    const bool moves = property.simulated && property.derives_from.empty();
    if (step == 0 || moves || tree.find(instance, property.symbol) == nullptr) return false;
    const Provenance written = last_writer_until(tree, instance, property, step - 1);
    if (!written.known || written.cause.writer != Writer::script) return false;
    if (written.cause.step == 0) return true;
    const auto later = given_later.find(path_below(tree.path(instance), property.name));
    return later != given_later.end() && later->second == written.cause.step;
}

void Tweaks::State::edited(Handle instance, const Property& property, const CellState& before) {
    if (property.transient || !attached(instance)) return;
    settle();
    if (is_fresh(instance)) return update_restored_values(instance, property);
    if (!by_instance.deleted.empty()) undelete_above(instance);
    if (Entry* creation = created_above(instance)) {
        creation->inside.emplace_back(instance, property.symbol);
        return touch(*creation);
    }
    bool begins = false;
    Entry& its = entry(Kind::value, tree.path(instance), property.name, instance, &begins);
    if (begins) {
        its.was = its.in_file ? *its.in_file : image_of(tree, property, before);
        if (!its.in_file) name_deleted(its.was, before.value);
        its.given.reset();
        if (!its.in_file && its.was.kind == Image::Kind::value &&
            is_given_by_script(instance, property))
            its.given = its.was;
        note_origin(its, instance);
    }
    if (its.row.state == RowState::kept) its.was = its.now;  // the file contains that value
    its.property = property.symbol;
    its.now = image_now(tree, instance, property.symbol, false);
    its.gone = false;
    touch(its);
}

/// After an undo of a deletion, the values edited before it are current again.
void Tweaks::State::update_restored_values(Handle instance, const Property& property) {
    if (tree.cause().writer != Writer::undo) return;
    for (const auto& each : entries)
        if (each->row.kind == Kind::value && each->handle == instance &&
            each->property == property.symbol && each->deletion != nullptr) {
            each->now = image_now(tree, instance, property.symbol, false);
            index(*each);
        }
}

/// An edited instance cannot be deleted: the game went back in time or loaded a save. So its
/// deletion is undone.
void Tweaks::State::undelete_above(Handle instance) {
    withdraw_left_deletions(instance);
    for (Handle at = instance; at; at = tree.parent(at)) {
        const auto found = by_instance.deleted.find(at.key());
        if (found == by_instance.deleted.end() || found->second->gone) continue;
        // A kept deletion stays until what is back is kept. Its text must not be taken again here,
        // in the middle of an edit.
        const auto back = by_instance.restored.find(at.key());
        if (back != by_instance.restored.end() && !back->second->gone &&
            back->second->row.state == RowState::open)
            continue;
        (void)undelete(*found->second);
    }
}

/// Stores a reference to a deleted instance. The reference is valid again when the instance is
/// back.
void Tweaks::State::name_deleted(Image& image, const Value& value) const {
    if (!value.is(Type::reference) || !value.reference() || tree.alive(value.reference())) return;
    const auto found = by_instance.deleted.find(value.reference().key());
    if (found == by_instance.deleted.end()) return;
    std::string text = "{\"reference\": ";
    append_quoted(text, path_of_deleted(value.reference()));
    image.value = text + "}";
}

void Tweaks::State::instance_created(Handle instance) {
    settle();
    if (attached(instance)) rename_mentions(path_of_deleted(instance), tree.path(instance));
    withdraw_left_deletions(instance);
    fresh.add(instance);
    barriers_to_retry = 0;
}

void Tweaks::State::instance_deleting(Handle instance) {
    settle();
    if (attached(instance)) rename_mentions(tree.path(instance), path_of_deleted(instance));
    // An instance that was created since the last barrier leaves no entry.
    if (fresh.remove(instance) && !by_instance.created.contains(instance.key())) return;
    if (is_fresh(instance) && !by_instance.created.contains(instance.key())) return;
    // A new instance below it comes back with it, and is deleted when its creation is undone.
    bool holds_new = false;
    if (!fresh.empty())
        tree.each_below(instance,
                        [&](Handle each) { holds_new = holds_new || fresh.contains(each); });
    if (holds_new) make_fresh_entries();
    if (attached(instance)) note_deletion(instance, tree.parent(instance), tree.path(instance));
}

/// Makes the tweaks of a deleted instance void until the deletion is undone.
void Tweaks::State::note_deletion(Handle instance, Handle parent, const std::string& path) {
    if (const auto made = by_instance.created.find(instance.key());
        made != by_instance.created.end() && (made->second->row.state == RowState::open ||
                                              made->second->kept_version == 0)) {  // no file has it
        make_void(path, {}, *made->second);
        made->second->gone = true;
        made->second->deletion = nullptr;  // it does not come back with another one
        return touch(*made->second);
    }
    if (taken_out_of_creation(instance, parent)) return;
    const auto moved_before = by_instance.moved.find(instance.key());
    const std::string home = moved_before != by_instance.moved.end() && !moved_before->second->gone
                                 ? home_of(instance)
                                 : path_below(home_of(parent), split_path(path).second);
    if (const auto again = by_instance.restored.find(instance.key());
        again != by_instance.restored.end() && again->second->row.state == RowState::open &&
        !again->second->gone) {  // the file still contains the deletion
        make_void(path, home, *by_instance.deleted.at(instance.key()));
        again->second->gone = true;
        return touch(*again->second);
    }
    Entry& deletion = add_deletion(instance, path, home);
    make_void(path, home, deletion);
}

Tweaks::State::Entry& Tweaks::State::add_deletion(Handle instance, const std::string& path,
                                                  const std::string& home) {
    // A new instance may replace one that a script makes, and the deletion of that one is a
    // separate entry.
    const auto known = by_instance.deleted.find(instance.key());
    Entry& deletion = known != by_instance.deleted.end() ? *known->second
                      : by_instance.created.contains(instance.key())
                          ? add_entry(Kind::deleted, home, instance)
                          : entry(Kind::deleted, home, {}, instance);
    const bool in_file = deletion.away && deletion.kept_version > 0;
    deletion.row.instance = home;
    deletion.row.now = path;
    deletion.row.was_text = with_article(tree.class_of(instance).name());
    deletion.row.now_text = "deleted";
    deletion.gone = deletion.away = false;
    deletion.deletion = deletion.with = nullptr;
    by_instance.deleted[instance.key()] = &deletion;
    note_origin(deletion, instance);
    touch(deletion);
    if (in_file) {  // it was kept before the game went back
        deletion.row.state = RowState::kept;
        deletion.kept_version = deletion.version;
    }
    return deletion;
}

/// Removes an instance from the scene of the new instance that it was made with. False if that does
/// not have it, because a script made it.
bool Tweaks::State::taken_out_of_creation(Handle instance, Handle parent) {
    Entry* above = created_above(parent);
    if (above == nullptr || !above->values.has(instance)) return false;
    above->values.forget(tree, instance);
    touch(*above);
    return true;
}

/// Makes the tweaks at `path` and below it void. `home`: home path of the instance; "" if no file
/// describes it.
void Tweaks::State::make_void(const std::string& path, const std::string& home, Entry& deletion) {
    std::vector<Entry*> affected = at_or_below(path);
    if (!by_instance.restored.empty()) {
        const InstanceMoves all = moves();
        for (const auto& [of, restoration] : by_instance.restored)
            if (is_at_or_below(all.now(restoration->row.instance), path))
                affected.push_back(restoration);
        affected = in_order(std::move(affected));
    }
    for (Entry* const each : affected) {
        Entry& its = *each;
        if (&its == &deletion || its.row.state != RowState::open || its.gone) continue;
        // Its home is not below the deleted one in the files, so it needs a separate deletion.
        const bool elsewhere = home.empty() || !is_at_or_below(its.row.instance, home);
        const bool in_its_place = its.row.now == path;  // a different instance, deleted before
        if (its.row.kind == Kind::deleted && (elsewhere || in_its_place)) continue;
        its.gone = true;
        its.deletion = &deletion;
        deletion.voided.push_back(&its);
        touch(its);
        if (its.row.kind == Kind::moved && elsewhere && tree.alive(its.handle)) {
            Entry& other = add_deletion(its.handle, its.row.now, its.row.instance);
            other.with = &deletion;
            deletion.voided.push_back(&other);
        }
    }
    // An instance whose home is below another deleted one needs no separate deletion.
    const std::vector<Entry*> voided = in_order(deletion.voided);
    for (Entry* each : voided)
        if (each->with == &deletion && !each->gone)
            each->gone = std::ranges::any_of(voided, [&](const Entry* other) {
                return other != each && other->with == &deletion && !other->gone &&
                       is_at_or_below(each->row.instance, other->row.instance);
            });
}

void Tweaks::State::revive(Entry& deletion) {
    deletion.saved = nullptr;
    for (Entry* const each : in_order(deletion.voided)) {
        Entry& its = *each;
        if (its.gone && its.deletion == &deletion) {
            its.gone = false;
            its.deletion = nullptr;
            refresh_path(its);
            touch(its);
        }
        if (!its.gone && its.with == &deletion) {
            its.with = nullptr;
            (void)undelete(its);
        }
    }
    std::erase_if(deletion.voided, [&](const Entry* each) {
        return each->deletion != &deletion && each->with != &deletion;
    });
}

// --- Reports

std::vector<Tweak> Tweaks::list() const {
    state_->settle();
    std::vector<Tweak> all;
    const auto add = [&all](const JournalRow& row, bool is_earlier, bool committed) {
        const bool named = row.kind == JournalRow::Kind::moved;  // a kept one has its new name
        all.push_back({.path = named ? row.was_text : path_of(row),
                       .there = named ? row.now : path_of(row),
                       .was = row.was_text,
                       .now = row.now_text,
                       .step = static_cast<std::uint64_t>(row.step),
                       .time = row.time,
                       .value = row.kind == JournalRow::Kind::value,
                       .earlier = is_earlier,
                       .committed = committed,
                       .kept = row.state == JournalRow::State::kept,
                       .kept_in = row.kept_in});
    };
    for (const JournalRow& row : state_->earlier.rows)
        if (row.state == JournalRow::State::open) add(row, true, true);
    for (const JournalRow& row : state_->earlier.rows)
        if (row.state == JournalRow::State::kept && row.run == JournalRow::left_behind)
            add(row, false, true);
    for (const auto& entry : state_->entries)
        if (state_->visible(*entry)) {
            add(entry->row, false, entry->committed && !entry->dirty);
            if (!all.back().value) continue;
            std::tie(all.back().was, all.back().now) = change_text(entry->was, entry->now);
        }
    return all;
}

std::size_t Tweaks::open_earlier() const {
    return static_cast<std::size_t>(
        std::count_if(state_->earlier.rows.begin(), state_->earlier.rows.end(),
                      [](const JournalRow& row) { return row.state == JournalRow::State::open; }));
}

std::vector<TweakWords> Tweaks::earlier_in_words() const {
    std::vector<TweakWords> all;
    for (const JournalRow& row : state_->earlier.rows)
        if (row.state == JournalRow::State::open) all.push_back(words_of(row));
    return all;
}

// --- Public functions

Tweaks::Tweaks(Tree& tree, const std::filesystem::path& game,
               std::function<void(const std::string&)> warn, TweakOptions options)
    : state_(std::make_unique<State>(tree, game, std::move(warn), std::move(options))) {
    state_->give_warnings();
}
Tweaks::~Tweaks() {
    if (state_->tree_life.expired()) return;  // the paths of edited instances are unknown
    state_->barriers_to_retry = 0;
    if (state_->journal) state_->journal->wait_longer();
    barrier();
    state_->report_lost();
    state_->give_warnings();
}

Tweaks::State& Tweaks::usable() const {
    if (state_->tree_life.expired())
        throw Error(ErrorKind::deleted, "the tree of these tweaks was destroyed");
    return *state_;
}

bool Tweaks::are_of(const Tree& tree) const {
    return !state_->tree_life.expired() && &state_->tree == &tree;
}

void Tweaks::barrier() {
    if (state_->tree_life.expired()) return;
    try {
        state_->kept.retry_waiting();
        state_->barrier();
    } catch (const std::exception& error) {
        state_->warn("tweaks cannot be journaled: " + exception_text(error));
    }
    state_->give_warnings();
}
TweakReport Tweaks::reapply(std::string_view pattern) {
    return state_->with_warnings(usable().reapply(pattern));
}
TweakReport Tweaks::drop(std::string_view pattern) {
    return state_->with_warnings(usable().drop(pattern));
}
void Tweaks::scene_loaded(const std::filesystem::path& file,
                          const std::vector<SceneInstance>& instances, bool named_by_script) {
    State& state = usable();
    state.origins.loaded(state.tree, file, instances, named_by_script);
    // When a script is loaded again, the parts are those that have their new places already.
    for (const SceneInstance& each : instances)
        if (state.kept.moves_any() && state.tree.alive(each.instance) &&
            state.kept.moves_to(state.home_of(each.instance)))
            state.origins.forget_part(state.tree, each.instance);
}
void Tweaks::placed(Handle instance) {
    usable().kept.apply_values(instance);
    state_->give_warnings();
}
void Tweaks::game_loaded() {
    State& state = usable();
    for (const Handle moved : state.kept.apply_all()) state.origins.forget_part(state.tree, moved);
    state.give_warnings();
}
std::filesystem::path Tweaks::journal() const {
    return state_->journal ? state_->journal->file() : std::filesystem::path();
}

}  // namespace fettle::property
