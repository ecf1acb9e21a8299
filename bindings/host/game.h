#pragma once

#include <fettle/app/loop.h>
#include <fettle/app/services.h>
#include <fettle/console/console.h>
#include <fettle/physics_module/physics_module.h>
#include <fettle/property/path.h>
#include <fettle/script/runtime.h>

#include <memory>
#include <optional>
#include <unordered_map>

#include "one_thread.h"
#include "player_files.h"
#include "surface.h"
#include "values.h"

namespace fettle::host {

/// A property of an instance, or a component of one, that a caller holds by number.
struct HeldProperty {
    property::Handle instance;
    const property::Property* property = nullptr;  // null: released
    std::uint32_t generation = 1;
    /// Of `part`, for fast reads: 0 and 1 are x and y of a vec2; -1: the whole value; -2: another.
    std::int8_t component = -1;
    std::vector<property::Segment> part{};
};

/// A function in C and the pointer that it gets.
template <class Function>
struct Callback {
    Function function = nullptr;
    void* user = nullptr;
};

/// The functions of the caller.
struct Callbacks {
    Callback<fettle_print_callback> print;
    Callback<fettle_problem_callback> problem;
    Callback<fettle_clipboard_read> read_clipboard;
    Callback<fettle_clipboard_write> write_clipboard;
};

class Game;

/// A method of a class that the caller has defined.
struct BoundMethod {
    Game* game = nullptr;
    fettle_method_callback call = nullptr;
    void* user = nullptr;
};

/// The parts of a game, put together as the program `fettle` does.
class Game {
  public:
    explicit Game(const fettle_hosted_def& def);
    ~Game();
    Game(const Game&) = delete;

    OneThread thread;
    bool open = false;                      // false: `note` can use the next member only
    std::vector<std::string> early_notes;   // from before a function could get them
    physics_module::PhysicsModule physics;  // before the tree, which uses its memory
    std::deque<BoundMethod> methods;
    property::Tree tree;
    app::Services services;
    PlayerFiles files;
    script::Runtime lua;
    app::Loop loop;
    std::unique_ptr<app::Clipboard> clipboard;
    std::unique_ptr<console::Console> console;  // null: the game has none
    TriangleSurface surface;
    std::optional<property::Transform> view;  // world to pixels; none: the view of the game

    Callbacks callbacks;
    std::vector<HeldProperty> held;
    std::vector<std::uint32_t> released;  // places in `held`
    std::unordered_map<fettle_connection, property::Connection> connections;
    fettle_connection last_connection = 0;

    Given given;
    std::vector<std::byte> snapshot;

    /// Throws Failure(FETTLE_LOCKED) in a callback.
    void require_outside(const char* what) const;
    /// Calls a function of the caller. Throws Failure(FETTLE_LOCKED) instead if too many such calls
    /// are nested.
    template <class Call>
    void call_out(Call call) {
        const Inside inside(*this);
        call();
    }
    /// Runs what may run scripts; then throws Failure with the message of the first error that they
    /// had.
    template <class Act>
    void run_scripts(Act act) {
        std::optional<std::string> before = std::move(first_problem_);
        first_problem_.reset();
        act();
        std::optional<std::string> found = std::exchange(first_problem_, std::move(before));
        if (found) throw Failure{FETTLE_FAILED, std::move(*found)};
    }
    void report(const script::ScriptError& error);
    /// A message about files, for the console and the caller; the call that is running goes on.
    void note(const std::string& text);
    /// Notes which parts of the last restored state did not fit the game.
    void note_remarks(const std::string& state);
    /// Gives the caller the notes from before it set a function for them.
    void tell_early_notes();
    console::Console& needed_console();

  private:
    /// A call of a function of the caller.
    class Inside {
      public:
        explicit Inside(Game& game);
        ~Inside() { --game_.callbacks_; }
        Inside(const Inside&) = delete;

      private:
        Game& game_;
    };

    void listen();
    void make_console(const fettle_hosted_def& def);
    void tell_problem(const script::ScriptError& error);
    void tell_note(const std::string& text);

    int callbacks_ = 0;  // calls of functions of the caller that have not returned
    bool stepped_ = false;
    std::optional<std::string> first_problem_;
};

}  // namespace fettle::host

struct fettle_hosted {
    std::unique_ptr<fettle::host::Game> game;  ///< null: destroyed
};
