#pragma once
// The receiver of the press of a key or button also gets its release, even if the focus has
// changed. So a game does not keep running when the console opens while an arrow key is held.

#include <set>
#include <string>

namespace fettle::console {

class HeldKeys {
  public:
    enum class Owner { none, game, console };

    void press(const std::string& name, Owner owner) {
        (owner == Owner::game ? game_ : console_).insert(name);
    }
    bool held_by_game(const std::string& name) const { return game_.contains(name); }
    /// The receiver of the release.
    Owner release(const std::string& name) {
        if (game_.erase(name) > 0) return Owner::game;
        if (console_.erase(name) > 0) return Owner::console;
        return Owner::none;
    }
    bool any_of_game() const { return !game_.empty(); }
    bool any_of_console() const { return !console_.empty(); }
    void clear() {
        game_.clear();
        console_.clear();
    }

  private:
    std::set<std::string> game_, console_;
};

}  // namespace fettle::console
