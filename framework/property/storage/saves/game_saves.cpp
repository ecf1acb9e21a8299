// Saving and loading a running game at barriers.

#include <fettle/property/storage/game_saves.h>

#include <ctime>
#include <filesystem>
#include <utility>

#include <fettle/property/exception_text.h>
#include <fettle/property/snapshot.h>
#include <fettle/property/snapshot_remarks.h>
#include <fettle/property/spelling.h>

#include <files/temporary_file.h>

namespace fettle::property {

namespace {

/// Bytes of all files in the folder but `replaced`.
std::uintmax_t used_space(const std::filesystem::path& folder,
                          const std::filesystem::path& replaced) {
    std::uintmax_t sum = 0;
    std::error_code error;
    for (std::filesystem::directory_iterator it(folder, error), end; !error && it != end;
         it.increment(error))
        if (it->path() != replaced)
            if (const std::uintmax_t size = it->file_size(error); !error) sum += size;
    return sum;
}

}  // namespace

GameSaves::GameSaves(Tree& tree, Saves saves, Options options)
    : tree_(tree),
      life_(tree.lifetime()),
      saves_(std::move(saves)),
      options_(std::move(options)),
      alive_(std::make_shared<GameSaves*>(this)) {
    if (options_.writes) remove_leftovers(saves_.folder());
}

Tree& GameSaves::tree() const {
    if (life_.expired())
        throw Error(ErrorKind::deleted, "the tree of these saved games was destroyed");
    return tree_;
}

GameSaves::~GameSaves() {
    *alive_ = nullptr;
    finish({});
}

void GameSaves::save(const std::string& slot) {
    tree().require_changeable("save the game");
    Saves::check_slot(slot);
    // Each save copies the state of the whole game, so their number is limited.
    const std::size_t most = options_.space == 0 ? max_requests : max_limited_requests;
    if (requests_ == most)
        throw Error(ErrorKind::rejected,
                    "the game is asked to be saved more than " + std::to_string(most) +
                        " times at one barrier, the last time as \"" + slot + "\"");
    // The request is queued in order with the other work of the barrier: a game that is loaded in
    // between is a different one.
    const std::size_t request = requested_[slot] = ++requests_;
    tree().at_barrier([alive = alive_, slot, request] {
        if (*alive != nullptr) (*alive)->save_at_barrier(slot, request);
    });
}

void GameSaves::save_at_barrier(const std::string& slot, std::size_t request) {
    const auto last = requested_.find(slot);
    const bool is_last = last != requested_.end() && last->second == request;
    if (is_last) requested_.erase(last);
    if (loaded_.erase(request) == 0 && !is_last) return;
    if (requested_.empty() && loaded_.empty()) requests_ = 0;
    std::vector<std::byte> state = tree().snapshot().to_bytes();
    // A state that cannot be loaded must not replace a save. The tree itself makes no such state,
    // but a module might leave something out.
    try {
        tree().check(Snapshot::from_bytes(state));
    } catch (const Error& error) {
        return warn("the game was not saved: " + exception_text(error));
    }
    for (const std::string& formula : unsaved_formulas(tree()))
        warn_once(formula + ": saved games hold its last value, and no formula");
    if (!options_.writes) {
        unwritten_.insert_or_assign(slot, Unwritten{.step = tree().step(),
                                                    .time = std::time(nullptr),
                                                    .state = std::move(state)});
        return;
    }
    std::erase_if(waiting_, [&](const Waiting& each) { return each.slot == slot; });
    // Several slots at one barrier usually have the same state.
    const bool same = !waiting_.empty() && *waiting_.back().state == state;
    auto kept = same ? waiting_.back().state
                     : std::make_shared<const std::vector<std::byte>>(std::move(state));
    waiting_.push_back({slot, tree().step(), std::move(kept)});
    if (!options_.pictures) finish({});
}

void GameSaves::finish(const Thumbnail& picture) {
    for (const Waiting& each : std::exchange(waiting_, {})) {
        try {
            if (options_.space > 0 &&
                used_space(saves_.folder(), saves_.file(each.slot)) + each.state->size() >
                    options_.space)
                throw Error(ErrorKind::rejected,
                            "this game has used the space on the disk that it may use");
            saves_.save(each.slot, each.step, *each.state, picture);
            if (options_.changed) options_.changed(each.slot);
        } catch (const std::exception& error) {
            warn("the game was not saved: " + exception_text(error));
        }
    }
}

Snapshot GameSaves::saved(const std::string& slot) const {
    const auto unwritten = unwritten_.find(slot);
    if (unwritten != unwritten_.end()) return Snapshot::from_bytes(unwritten->second.state);
    if (!options_.writes) refuse_unknown(slot);
    for (const Waiting& each : waiting_)
        if (each.slot == slot) return Snapshot::from_bytes(*each.state);
    return Snapshot::from_bytes(saves_.load(slot).state);
}

void GameSaves::load(const std::string& slot) {
    tree().require_changeable("load a game");
    Saves::check_slot(slot);
    const auto requested = requested_.find(slot);
    const bool is_requested = requested != requested_.end();
    if (is_requested) loaded_[requested->second] = slot;
    const Snapshot found = is_requested ? Snapshot() : saved(slot);
    if (!found.empty()) try {
            tree().check(found);
        } catch (const Error& error) {
            throw Error(error.kind(),
                        "the saved game \"" + slot + "\" cannot be loaded: " + error.what());
        }
    tree().at_barrier([alive = alive_, slot, found] {
        if (*alive == nullptr) return;
        GameSaves& self = **alive;
        try {
            self.tree().restore(found.empty() ? self.saved(slot) : found);
            // `warn` may restore another game, or end this object.
            const std::vector<std::string> remarks = restore_remarks(self.tree());
            for (const std::string& remark : remarks)
                if (*alive != nullptr) self.warn("the saved game \"" + slot + "\": " + remark);
        } catch (const Error& error) {
            self.warn("the saved game \"" + slot + "\" was not loaded: " + error.what());
        }
    });
}

void GameSaves::remove(const std::string& slot) {
    Saves::check_slot(slot);
    const bool known = discard(slot);
    if (!options_.writes) {
        if (!known) refuse_unknown(slot);
    } else if (!known || saves_.exists(slot)) {
        saves_.remove(slot);
    }
    if (options_.changed) options_.changed(slot);
}

bool GameSaves::discard(const std::string& slot) {
    std::size_t found = requested_.erase(slot) + unwritten_.erase(slot);
    found += std::erase_if(loaded_, [&](const auto& each) { return each.second == slot; });
    found += std::erase_if(waiting_, [&](const Waiting& each) { return each.slot == slot; });
    return found > 0;
}

void GameSaves::refuse_unknown(const std::string& slot) const {
    std::vector<std::string> slots;
    for (const auto& [known, save] : unwritten_) slots.push_back(known);
    throw Error(ErrorKind::unknown_name,
                "there is no saved game \"" + slot + "\"" + suggestion(slot, slots));
}

Thumbnail GameSaves::picture(const std::string& slot) const {
    if (!options_.writes) return {};
    try {
        return saves_.load(slot).thumbnail;
    } catch (const std::exception&) {  // `list` gives the reason
        return {};
    }
}

std::string GameSaves::problem_of(const std::vector<std::byte>& state) const {
    try {
        tree().check(Snapshot::from_bytes(state));
    } catch (const Error& error) {
        return error.what();
    }
    return {};
}

std::vector<SaveInfo> GameSaves::list_unwritten() const {
    std::vector<SaveInfo> all;
    for (const auto& [slot, save] : unwritten_)
        all.push_back({.slot = slot,
                       .step = save.step,
                       .time = save.time,
                       .program = {},
                       .bytes = save.state.size(),
                       .problem = problem_of(save.state)});
    return all;
}

std::vector<SaveInfo> GameSaves::list() const {
    if (!options_.writes) return list_unwritten();
    return saves_.list([this](const SavedGame& save) { return problem_of(save.state); });
}

void GameSaves::warn(const std::string& what) const {
    if (options_.warn) options_.warn(what);
}

/// For formulas: a game that saves every minute gets the warning once.
void GameSaves::warn_once(const std::string& what) {
    if (reported_.insert(what).second) warn(what);
}

}  // namespace fettle::property
