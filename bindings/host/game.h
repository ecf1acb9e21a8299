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

/// A property of an instance, or a component of one, to which the caller has a handle
/// (fettle_property_id).
struct PropertyHandle {
    property::Handle instance;
    const property::Property* property = nullptr;  // null: released
    std::uint32_t generation = 1;
    /// Which component of the value it is, for fast reads: 0 and 1 are x and y of a vec2; -1: the
    /// whole value; -2: another part.
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
    bool open = false;  // false, while the game is made or destroyed: `note` only stores texts in
                        // the next member
    std::vector<std::string> early_notes;   // notes from before the caller set a function for them
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
    std::vector<PropertyHandle> held;
    std::vector<std::uint32_t> released;  // places in `held`
    std::unordered_map<fettle_connection, property::Connection> connections;
    fettle_connection last_connection = 0;

    ReturnedData given;
    std::vector<std::byte> snapshot;

    /// Throws Failure(FETTLE_LOCKED) in a callback.
    void require_outside(const char* what) const;
    /// Calls a function of the caller. Throws Failure(FETTLE_LOCKED) instead if too many such calls
    /// are nested.
    template <class Call>
    void call_out(Call call) {
        const CallbackScope inside(*this);
        call();
    }
    /// Calls `act`, which may run scripts. Throws Failure afterwards, with the message of the first
    /// error of these scripts, if there was one.
    template <class Act>
    void run_scripts(Act act) {
        std::optional<std::string> before = std::move(first_problem_);
        first_problem_.reset();
        act();
        std::optional<std::string> found = std::exchange(first_problem_, std::move(before));
        if (found) throw Failure{FETTLE_FAILED, std::move(*found)};
    }
    void report(const script::ScriptError& error);
    /// Passes a message about files to the console and to the caller; it is not an error of the
    /// running call.
    void note(const std::string& text);
    /// Writes notes about the parts of the last restored state that did not fit the game.
    void note_remarks(const std::string& state);
    /// Passes the early notes to the function of the caller.
    void deliver_early_notes();
    console::Console& needed_console();

  private:
    /// Counts a call of a function of the caller while it runs.
    class CallbackScope {
      public:
        explicit CallbackScope(Game& game);
        ~CallbackScope() { --game_.callbacks_; }
        CallbackScope(const CallbackScope&) = delete;

      private:
        Game& game_;
    };

    void connect_callbacks();
    void make_console(const fettle_hosted_def& def);
    void report_to_caller(const script::ScriptError& error);
    void note_to_caller(const std::string& text);

    int callbacks_ = 0;  // calls of functions of the caller that have not returned
    bool stepped_ = false;
    std::optional<std::string> first_problem_;
};

}  // namespace fettle::host

struct fettle_hosted {
    std::unique_ptr<fettle::host::Game> game;  ///< null: destroyed
};
