#include <fettle/property/storage/game_saves.h>

#include <utility>

#include <fettle/property/exception_text.h>
#include <fettle/property/snapshot.h>

#include "temporary_file.h"

namespace fettle::property {

GameSaves::GameSaves(Tree& tree, Saves saves, Options options)
    : tree_(tree),
      saves_(std::move(saves)),
      options_(std::move(options)),
      alive_(std::make_shared<GameSaves*>(this)) {
    if (options_.writes) remove_leftovers(saves_.folder());
}

GameSaves::~GameSaves() {
    *alive_ = nullptr;
    finish({});
}

void GameSaves::save(const std::string& slot) {
    Saves::check_slot(slot);
    if (requests_ == most_requests)
        throw Error(ErrorKind::rejected,
                    "the game is asked to be saved more than " + std::to_string(most_requests) +
                        " times at one barrier, the last time as \"" + slot + "\"");
    // In its place among what else the barrier does: a game that is loaded in between is another
    // one.
    const std::size_t request = requested_[slot] = ++requests_;
    tree_.at_barrier([alive = alive_, slot, request] {
        if (*alive != nullptr) (*alive)->take(slot, request);
    });
}

void GameSaves::take(const std::string& slot, std::size_t request) {
    const auto last = requested_.find(slot);
    if (last == requested_.end() || last->second != request) return;
    requested_.erase(last);
    if (requested_.empty()) requests_ = 0;
    std::vector<std::byte> state = tree_.snapshot().to_bytes();
    if (!options_.writes) {
        unwritten_.insert_or_assign(slot, std::move(state));
        return;
    }
    std::erase_if(waiting_, [&](const Waiting& each) { return each.slot == slot; });
    // Several slots at one barrier are mostly one state.
    const bool same = !waiting_.empty() && *waiting_.back().state == state;
    auto kept = same ? waiting_.back().state
                     : std::make_shared<const std::vector<std::byte>>(std::move(state));
    waiting_.push_back({slot, tree_.step(), std::move(kept)});
    if (!options_.pictures) finish({});
}

void GameSaves::finish(const Thumbnail& picture) {
    for (const Waiting& each : std::exchange(waiting_, {})) {
        try {
            saves_.save(each.slot, each.step, *each.state, picture);
        } catch (const std::exception& error) {
            if (options_.warn) options_.warn("the game was not saved: " + exception_text(error));
        }
    }
}

void GameSaves::load(const std::string& slot) {
    const auto unwritten = unwritten_.find(slot);
    const Snapshot state = Snapshot::from_bytes(
        unwritten != unwritten_.end() ? unwritten->second : saves_.load(slot).state);
    tree_.at_barrier([alive = alive_, slot, state] {
        if (*alive == nullptr) return;
        GameSaves& self = **alive;
        try {
            self.tree_.restore(state);
        } catch (const Error& error) {
            if (self.options_.warn)
                self.options_.warn("the saved game \"" + slot +
                                   "\" was not loaded: " + error.what());
        }
    });
}

}  // namespace fettle::property
