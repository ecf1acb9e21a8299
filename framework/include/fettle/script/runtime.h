#pragma once
// A Lua runtime over a property tree: loads a game, calls its callbacks, runs its timers, evaluates
// console commands. Every object of a script is a handle into the tree; this header does not depend
// on Lua.

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

namespace fettle::script {
struct Machine;  // not exported
}

FETTLE_SCRIPT_BEGIN

namespace fettle::property {
class GameFiles;
class GameSaves;
class Media;
class Store;
class Tweaks;
}  // namespace fettle::property

namespace fettle::script {

struct ConsoleFunctions;
struct Observed;

/// Limits for a game that is not trusted. 0: no limit. A script that passes one is stopped; the
/// error names the place. Time limits: `Options::call_seconds`.
struct GameLimits {
    std::uint64_t instructions = 0;  // Lua instructions of one call into the scripts
    /// Bytes of Lua and of what the scripts add to the tree, physics included (estimated).
    std::size_t memory = 0;
    std::size_t text = 0;       // bytes of one text of Lua
    std::size_t instances = 0;  // in the tree, also those that scripts did not make
    std::size_t handlers = 0;   // watchers included
    std::size_t timers = 0;     // that wait
    std::size_t output = 0;     // bytes that print() may write during a run
    /// Bytes of what the scripts add to the tree, physics included (estimated), without Lua. Unlike
    /// `memory`, it makes no call slower.
    std::size_t tree = 0;
    std::string tree_setting{};  ///< what raises that limit, for messages; "": nothing
};

/// How a runtime is set up.
struct Options {
    std::uint64_t seed = 0;                             ///< of random()
    std::size_t memory_limit = std::size_t{512} << 20;  // bytes, whole Lua state
    /// Bytes that one console command may add, in Lua and in the tree; at least 65536. For a chunk
    /// of `run`: memory_limit.
    std::size_t console_memory = std::size_t{128} << 20;
    std::uint64_t console_budget = 50'000'000;  // Lua instructions of one console command
    GameLimits limits{};                        ///< for games that are not trusted
    /// Seconds that a call into the scripts may take; then it is stopped, as by an error. 0: no
    /// limit. `limit_calls` can change it.
    double call_seconds = 10;
    std::filesystem::path assets;          // folder for files that the game's folder does not have
    property::GameSaves* saves = nullptr;  ///< saved games; not owned
    property::Tweaks* tweaks = nullptr;    ///< edits of people; not owned
    property::Store* store = nullptr;      ///< lasting values of the game; not owned
    property::GameFiles* files = nullptr;  // null: the files on the disk
    property::Media* media = nullptr;      // null: `pen` has no images and cannot measure text
    /// Name of the recording that this run replays; "" in a normal run. A replay does not write the
    /// game's files again: functions that would write them report this and continue.
    std::string replay{};
};

/// An error of a script, for the error screen and stderr.
struct ScriptError {
    std::string message;      // "main.lua:12: world.bal: no such name (did you mean \"ball\"?)"
    std::string file;         // "main.lua", "console"; "" when unknown
    int line = 0;             // from 1; 0 when unknown
    std::string source_line;  // its text, "" when unknown
    std::string traceback;    // one line for each frame
    std::string locals;       // local variables of the failed frame: lines `name = value`
    std::string context;      // "update", "timer", "watcher of world.ball.mass", "load", "console"
    int column = 0;           // from 1, position of the caret below the source line; 0 when unknown
};

/// The error as lines for a console: message, then the source line and a caret under the error.
std::vector<std::string> error_lines(const ScriptError& error);

/// Result of `Runtime::reload`.
struct Reloaded {
    bool done = false;                   ///< whether the new scripts run now
    std::optional<ScriptError> error{};  // if it was not done: nothing has changed
    std::vector<std::string> notes{};    // values that could not be applied
};

/// A call into the game's scripts that takes too long.
struct LongCall {
    ScriptError where;   // current place; without a message
    double seconds = 0;  // s since its start
};

/// Lines of an answer that are the rows of a table.
struct TableLines {
    std::size_t first = 0;                        ///< the line of the first row
    bool head = true;                             ///< whether the first row names the columns
    std::vector<std::vector<std::size_t>> cells;  ///< of each row, the bytes where its cells begin
};

/// Lines that another line of an answer stands for: "… 77 more (107 instances)".
struct FoldedLines {
    std::size_t line = 0;                           ///< the line that stands for them
    std::vector<std::string> lines;                 ///< a thousand at most
    std::vector<std::vector<std::size_t>> cells{};  ///< if they go on a table that ends above it
};

/// Result of one console command.
struct Evaluation {
    bool ok = false;                 ///< whether it ran to its end
    bool incomplete = false;         // the chunk needs more lines; nothing has run
    std::vector<std::string> lines;  // printed text, results and old and new values of assignments,
                                     // in order
    std::vector<TableLines> tables{};    ///< which of the lines are tables
    std::vector<FoldedLines> folded{};   ///< what some of the lines stand for, in order
    std::vector<std::size_t> printed{};  ///< which of the lines are texts of `print`, in order
    std::optional<ScriptError> error;    ///< none if it is ok
    property::Value result;              // the last result; nil if it is not a value of the tree
};

/// A candidate of a completion.
struct Completion {
    std::string text;              // replaces the input from `replace_from` to the cursor
    std::string label;             // as listed: "friction"
    std::string detail;            // "0.6 · number · 0 to inf · default 0.6"
    std::string doc;               ///< what it is
    std::size_t replace_from = 0;  // byte offset
};

/// A function of the host that scripts can call. Its exceptions become errors of the script.
using HostFunction = std::function<property::Value(std::span<const property::Value> arguments)>;

/// Lua over a tree: scripts, their callbacks, and the commands of the console.
///
/// Lifetimes: a tree has one runtime at a time: a second throws Error(bad_structure); after the
/// first is destroyed, another may be made. Watchers, timers and handlers of the scripts end with
/// the runtime; formulas that they defined are in error from then on. The runtime may outlive the
/// tree: functions that would run a script then throw Error(deleted). Functions given to
/// `on_error`, `on_print` and the others may destroy the runtime that calls them; the running call
/// goes on to its end without it. Only the function given to `on_command` may destroy the tree; if
/// that of `on_print` or a method that a script calls does, the program ends with a message. They
/// should not throw: an exception leaves the call (`run`, `step`) that called them.
class Runtime {
  public:
    /// Makes Lua's state, and puts the functions of the library into it.
    Runtime(property::Tree& tree, Options options);
    ~Runtime();
    Runtime(const Runtime&) = delete;
    Runtime& operator=(const Runtime&) = delete;

    /// For objects that refer to the runtime and may outlive it: expired as soon as its destruction
    /// begins.
    std::weak_ptr<const void> lifetime() const;

    /// Runs main.lua of a folder, or one .lua file; then its `start()`. Returns false if it raised
    /// an error, which is given to `on_error`. The game's own files are in this folder only: links
    /// out of it are not followed. Throws property::FileError if the file cannot be read, and
    /// Error(bad_structure) while a script of this runtime runs.
    bool load(const std::filesystem::path& game);
    /// Runs the top level of the loaded game again, because its files have changed, and calls its
    /// `reloaded(files)`. The tree stays. The declarations of the top level (instances that it
    /// makes, and values that it gives) are compared with the earlier ones, and only the
    /// differences are applied. Classes get their new functions, properties and defaults. Handlers
    /// and timers of the old top level end. Variables of Lua begin again; those that only callbacks
    /// have assigned stay. After an error everything is as it was. `files`: names for `reloaded`.
    /// Throws property::FileError if main.lua cannot be read, and Error(bad_structure) if no game
    /// is loaded or a script of this runtime runs.
    Reloaded reload(const std::vector<std::string>& files);
    /// Runs a chunk as part of the game (`--eval`). It is stopped if it adds more than
    /// `Options::memory_limit` bytes, in Lua and in the tree, or, like every call, takes longer
    /// than `Options::call_seconds` or needs more instructions than `Options::limits` allows.
    /// Returns false if it raised an error or was stopped; the error is given to `on_error`.
    bool run(std::string_view chunk, const std::string& name);

    /// Adds functions that a part above gives to scripts: the chunk runs now, and again before each
    /// game that is loaded, because loading forgets what the last game defined. It may only add
    /// functions to classes.
    void add_library(const std::string& name, std::string_view chunk);
    /// The next of the game's random numbers, at least 0 and less than 1.
    double random();

    /// Calls a global function of the game, if it is defined ("update", "key_pressed" ...). Returns
    /// false if it raised an error.
    bool call(std::string_view callback, std::span<const property::Value> arguments);
    bool call(std::string_view callback, std::initializer_list<property::Value> arguments) {
        return call(callback, std::span(arguments.begin(), arguments.size()));
    }
    /// Draws the game: calls `draw_behind(pen)`, draws all instances in the order of their `z`,
    /// those of scripts' classes with their `draw(pen)`, and calls `draw(pen)` of the game. A host
    /// that calls it does not call `Tree::draw`. Returns false if a script raised an error; what a
    /// module throws reaches the caller.
    bool draw(property::Painter& painter);
    /// Whether scripts draw by themselves: in `draw`, in `draw_behind`, or in the `draw` of a
    /// class.
    bool draws() const;
    /// Whether scripts have defined the class.
    bool has_defined(const property::Class& of) const;
    /// A frame, `seconds` of real time after the last one: a transition of go_to_scene goes on, and
    /// tweens and timers in real time do. The scene is replaced at the barrier that follows.
    void advance(double seconds);
    /// Makes one fixed step: runs timers and coroutines that are due, then calls `step(dt)`.
    /// `now`: simulation time in seconds at the end of the step.
    bool step(double now, double dt);

    // --- Console

    /// Runs a command: an expression prints its value, an assignment echoes old and new, `path?`
    /// prints help.
    Evaluation evaluate(std::string_view command);
    /// Completions for the text before `cursor` (byte offset), best first, `most` of them at most.
    std::vector<Completion> complete(std::string_view input, std::size_t cursor,
                                     std::size_t most = 200);
    /// Whether a call into the scripts, or a console command, has not returned yet.
    bool running() const;
    /// Carries out `pin`, `plot`, `break_when` and the other functions that need a console
    /// (observed.h). Without it they are refused, in a replay they do nothing.
    void serve_console(ConsoleFunctions functions);
    /// A path or an expression as a value to observe; `it` in it is the instance that is selected
    /// now. Throws Error for a text that does not compile.
    Observed observe(std::string_view expression);
    /// Sets the value of `it` in the console.
    void set_selected(property::Handle instance);
    property::Handle selected() const;  ///< the instance that is selected; null if none is

    // --- Calls that do not return

    /// Calls `go_on` ten times a second during a call into the game's scripts (main.lua, a chunk, a
    /// callback, a timer, a handler, drawing) that takes longer than `seconds`; its result says
    /// whether the call may go on. It may read events, draw, and evaluate commands. If it is empty,
    /// or has destroyed the runtime, the call is stopped, as by an error; before the first call of
    /// `limit_calls`, calls are stopped so after `Options::call_seconds`. 0: no limit. A runtime
    /// with a limit has its own thread from its first call on, and uses the signal SIGURG, whose
    /// handler it sets.
    void limit_calls(double seconds, std::function<bool(const LongCall&)> go_on);

    /// Gives scripts a function of the host as the global `name`, in place of anything that has the
    /// name. It cannot be called in a formula. It must not destroy the runtime or the tree.
    void add_function(const std::string& name, HostFunction function);

    // --- Callbacks of the host

    /// Receives the errors of scripts.
    void on_error(std::function<void(const ScriptError&)> sink);
    /// Receives the output of print() outside console commands.
    void on_print(std::function<void(std::string_view)> sink);
    /// Receives notes on code that is not an error but probably has another effect than intended: a
    /// new property with the name that another engine uses for a declared one, or a function that
    /// is never called and whose name is almost that of a callback. Each note is given once.
    void on_note(std::function<void(std::string_view)> sink);
    /// Implements rewind(seconds), called at a barrier between steps. Without it rewind is refused.
    void on_rewind(std::function<void(double seconds)> rewind);
    /// `bytes` is called before every console command and returns how many bytes the command may
    /// add, in Lua and in the tree together. If it is empty, the number in the options is used. The
    /// error of a command that needs more names `property`.
    void on_command_memory(std::function<std::size_t()> bytes, std::string property);
    /// Called for every console command before it runs.
    void on_command(std::function<void(std::string_view)> sink);
    /// Stops the running script, anywhere, and every other script until `go_on`; each reports its
    /// error as usual. A signal handler of the thread that runs scripts may call this, and nothing
    /// else of a runtime.
    void interrupt() noexcept;
    /// Scripts may run again. Call it between calls into the runtime.
    void go_on();
    bool interrupted() const;  ///< from `interrupt` to `go_on`
    /// Status that a script gave to quit(); none if quit() was not called.
    std::optional<int> quit_status() const;
    /// True if the game defines a global function of that name.
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
