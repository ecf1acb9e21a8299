#include <fettle/property/storage/game_saves.h>

#include <utility>

#include <fettle/property/snapshot.h>

namespace fettle::property {

GameSaves::GameSaves(Tree& tree, Saves saves, Options options)
    : tree_(tree),
      saves_(std::move(saves)),
      options_(std::move(options)),
      alive_(std::make_shared<GameSaves*>(this)) {}

GameSaves::~GameSaves() {
    *alive_ = nullptr;
    finish({});
}

void GameSaves::save(const std::string& slot) {
    tree_.require_changeable("save the game");
    Saves::check_slot(slot);
    tree_.at_barrier([alive = alive_, slot] {
        if (*alive != nullptr) (*alive)->take(slot);
    });
}

void GameSaves::take(const std::string& slot) {
    std::vector<std::byte> state = tree_.snapshot().to_bytes();
    if (!options_.writes) {
        unwritten_.insert_or_assign(slot, std::move(state));
        return;
    }
    waiting_.push_back({slot, tree_.step(), std::move(state)});
    if (!options_.pictures) finish({});
}

void GameSaves::finish(const Thumbnail& picture) {
    for (const Waiting& each : std::exchange(waiting_, {})) {
        try {
            saves_.save(each.slot, each.step, each.state, picture);
        } catch (const Error& error) {
            if (options_.warn)
                options_.warn("the game was not saved: " + std::string(error.what()));
        }
    }
}

void GameSaves::load(const std::string& slot) {
    tree_.require_changeable("load a game");
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
