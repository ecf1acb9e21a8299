#pragma once
// A Lua runtime over a property tree: loads a game, calls its callbacks, runs its timers, evaluates
// what is typed into a console. Every object a script sees is a handle into the tree; nothing of
// Lua appears in this header.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fettle/property/tree.h>
#include <fettle/script/export.h>

FETTLE_SCRIPT_BEGIN

namespace fettle::property {
class GameFiles;
class GameSaves;
class Tweaks;
}  // namespace fettle::property

namespace fettle::script {

struct FETTLE_SCRIPT_PRIVATE Machine;

struct Options {
    std::uint64_t seed = 0;
    std::size_t memory_limit = std::size_t{512} << 20;  // bytes, whole Lua state
    // Bytes one console command may add: in Lua and in the tree. A chunk of `run`: memory_limit.
    std::size_t console_memory = std::size_t{128} << 20;
    std::uint64_t console_budget = 50'000'000;  // Lua instructions of one console command
    /// Seconds that a call into the scripts may take; then it is stopped, as by an error. 0: as
    /// long as it likes. `limit_calls` says more, and can change it.
    double call_seconds = 10;
    std::filesystem::path assets;  // where files are looked for that the game's folder lacks
    // Not owned; a game has none of what is missing.
    property::GameSaves* saves = nullptr;
    property::Tweaks* tweaks = nullptr;
    property::GameFiles* files = nullptr;  // none: what is on the disk
    /// Name of the recording whose run this one makes again; "" when it makes none. What was
    /// written to the game's files then is not written again: functions that would say so and go
    /// on.
    std::string replay{};
};

/// A script went wrong: what the error screen and stderr show.
struct ScriptError {
    std::string message;      // "main.lua:12: world.bal: no such name (did you mean \"ball\"?)"
    std::string file;         // "main.lua", "console"; "" when unknown
    int line = 0;             // from 1; 0 when unknown
    std::string source_line;  // its text, "" when unknown
    std::string traceback;    // one frame a line
    std::string locals;       // `name = value` a line: local variables of the frame that failed
    std::string context;      // "update", "timer", "watcher of world.ball.mass", "load", "console"
    int column = 0;           // from 1, where a caret belongs under the source line; 0 when unknown
};

/// The error as a console shows it: message, then the source line and a caret under what is wrong.
std::vector<std::string> error_lines(const ScriptError& error);

/// A call into the game's scripts that does not come back.
struct LongCall {
    ScriptError where;   // it has no message
    double seconds = 0;  // that it has lasted
};

/// What came of one console command.
struct Evaluation {
    bool ok = false;
    bool incomplete = false;         // the chunk needs more lines; nothing was run
    std::vector<std::string> lines;  // printed text, results and echoes of assignments, in order
    std::optional<ScriptError> error;
    property::Value result;  // the last result, nil when it has none that is a value
};

struct Completion {
    std::string text;    // replaces the input from `replace_from` to the cursor
    std::string label;   // as listed: "friction"
    std::string detail;  // "0.6 · number · 0 to inf · default 0.6"
    std::string doc;
    std::size_t replace_from = 0;  // byte offset
};

/// **Lifetimes.** A tree has one runtime at a time: a second throws Error(bad_structure); when the
/// first is destroyed, another may follow. Watchers, timers and handlers of the scripts end with
/// the runtime; formulas that they defined are in error from then on. The runtime may outlive the
/// tree: whatever would run a script throws Error(deleted) then. Functions given to `on_error`,
/// `on_print` and the others may destroy the runtime that calls them; what runs goes on to its end
/// without it. None may destroy the tree but that of `on_command`; that of `on_print` ends the
/// program then, with a message. They should not throw: what they throw leaves the call (`run`,
/// `step`) that told them.
class Runtime {
  public:
    Runtime(property::Tree& tree, Options options);
    ~Runtime();
    Runtime(const Runtime&) = delete;
    Runtime& operator=(const Runtime&) = delete;

    /// For objects that hold a reference to the runtime and may outlive it: expired from the
    /// beginning of its destruction on.
    std::weak_ptr<const void> lifetime() const;

    /// Runs main.lua of a folder, or one .lua file; then its `start()`. False when it raised; the
    /// error goes to the sink. The folder is where the game's files are, and none of them lies
    /// elsewhere: links that lead out of it are not followed. Throws property::FileError when the
    /// file cannot be read, and Error(bad_structure) while a script of this runtime runs.
    bool load(const std::filesystem::path& game);
    /// Runs a chunk as part of the game (`--eval`). It may add `Options::memory_limit` bytes, in
    /// Lua and in the tree, and like every call take `Options::call_seconds`: then it is stopped.
    /// False when it raised or was stopped; the error goes to the sink.
    bool run(std::string_view chunk, const std::string& name);

    /// Calls a global function of the game if it has one ("update", "key_pressed" ...). False when
    /// it raised.
    bool call(std::string_view callback, std::span<const property::Value> arguments);
    bool call(std::string_view callback, std::initializer_list<property::Value> arguments) {
        return call(callback, std::span(arguments.begin(), arguments.size()));
    }
    /// `draw(pen)` of the game and of its classes.
    bool draw(property::Painter& painter);
    /// One fixed step of the scripts: timers and waiting coroutines that are due, then `step(dt)`.
    /// `now`: simulation time in seconds at the end of the step.
    bool step(double now, double dt);

    // --- Console
    // ----------------------------------------------------------------------------------------------------

    /// Runs a command: an expression prints its value, an assignment echoes old and new, `path?`
    /// prints help.
    Evaluation evaluate(std::string_view command);
    /// Candidates for what stands before `cursor` (byte offset), best first.
    std::vector<Completion> complete(std::string_view input, std::size_t cursor);
    /// What `it` means in the console.
    void set_it(property::Handle instance);
    property::Handle it() const;

    // --- Calls that do not come back
    // --------------------------------------------------------------------------------

    /// A call into the game's scripts (main.lua, a chunk, a callback, a timer, a handler, drawing)
    /// that takes longer than `seconds` is asked about, ten times a second from then on: `go_on`
    /// says whether it may; it may look at events, draw, and evaluate commands meanwhile. Without
    /// it, and when it has destroyed the runtime whatever it says, the call is stopped, as by an
    /// error: so it is after `Options::call_seconds` until this is
    /// called. 0: calls last as long as they like. A runtime whose calls are limited has a thread
    /// of its own from its first call on, and uses the signal SIGURG, whose handler it sets.
    void limit_calls(double seconds, std::function<bool(const LongCall&)> go_on);

    // --- Towards the host
    // -------------------------------------------------------------------------------------------

    void on_error(std::function<void(const ScriptError&)> sink);
    /// print() outside console commands.
    void on_print(std::function<void(std::string_view)> sink);
    /// What is no error and has surely another effect than its author thinks: a property added
    /// under the name that another engine has for a declared one, a function that nothing calls and
    /// that is nearly called like a callback. Each is told once.
    void on_note(std::function<void(std::string_view)> sink);
    /// What rewind(seconds) does, at a barrier between steps. Without it rewind is refused.
    void on_rewind(std::function<void(double seconds)> rewind);
    /// Asked before every console command how many bytes it may add, in Lua and in the tree
    /// together, instead of what the options say. `property` is named by the error of a command
    /// that needs more. Empty: the options again.
    void on_command_memory(std::function<std::size_t()> bytes, std::string property);
    /// Told of every console command before it runs.
    void on_command(std::function<void(std::string_view)> sink);
    /// Stops the script that runs, wherever it is, and every other one until `go_on`; each tells
    /// its error as usual. A signal handler of the thread that runs scripts may call this, and
    /// nothing else of a runtime.
    void interrupt() noexcept;
    /// Scripts run again. Between calls into the runtime.
    void go_on();
    bool interrupted() const;
    /// Status given to quit(), once it was called.
    std::optional<int> quit_status() const;
    /// Whether the game defines a global function of that name.
    bool defines(std::string_view callback) const;

    /// Bytes held by Lua.
    std::size_t memory() const;

  private:
    struct FETTLE_SCRIPT_PRIVATE State;
    Machine& live() const;

    std::unique_ptr<State> state_;
};

}  // namespace fettle::script

FETTLE_SCRIPT_END
