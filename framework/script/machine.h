#pragma once
// The whole of a runtime, as its parts see it.

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include <fettle/property/storage/game_files.h>
#include <fettle/property/tree.h>
#include <fettle/script/runtime.h>

#include "arena.h"
#include "budget.h"
#include "dispatch.h"
#include "hints.h"
#include "lua_api.h"
#include "random.h"
#include "runtime_part.h"
#include "timers.h"
#include "values.h"
#include "watchdog.h"

namespace fettle::script {

class ScriptClasses;
class Subscriptions;

/// What one console command did to the tree, for its echoes.
struct Recording {
    struct Edit {
        property::Handle instance;
        property::Symbol symbol;
        std::string path;
        std::string unit;
        property::Precision precision{};
        property::Value before;
        property::Value after;
        bool replaced = false;  // there was a formula
        std::string note;       // instead of values: "new Body", "deleted"
    };
    bool active = false;
    std::vector<Edit> edits;
    const property::Property* last_read = nullptr;  // property read last, for its unit
    std::vector<std::string> lines;                 // printed
    std::size_t dropped = 0;                        // lines beyond the limit
};

/// Per cent: a collection begins when Lua has so much of the memory that the last one left.
inline constexpr int collector_pause = 400;

struct Machine {
    Machine(property::Tree& property_tree, Options runtime_options);
    ~Machine();
    Machine(const Machine&) = delete;

    property::Tree& tree;
    std::weak_ptr<const property::Tree*> tree_life;
    Options options;
    property::GameFiles files_on_disk;
    property::GameFiles& files;
    Arena arena;
    lua_State* main = nullptr;
    std::shared_ptr<lua_State*> alive;  // what outlives Lua asks here; nullptr inside once closed
    lua_State* running = nullptr;       // thread that runs now; exact, since we make every switch
    Budget budget{*this};
    Watchdog watchdog{*this};
    std::vector<std::unique_ptr<DispatchTable>> dispatch;  // by the number of the class
    std::size_t dynamic_names = 0;  // in them, of things that no class declares
    Random random;
    Timers timers{*this};
    std::unique_ptr<Subscriptions> subscriptions;
    std::unique_ptr<ScriptClasses> classes;
    RuntimePart part{*this};
    Hints hints{*this};
    std::function<void(std::string_view)> command_sink;
    std::function<std::size_t()> command_memory;  // bytes; empty: as the options say
    std::string memory_property;                  // that says so, for messages
    std::function<void(double)> rewind;           // by seconds; empty: there is no timeline
    std::size_t travels = 0;                      // that wait for the next barrier
    std::size_t snapshots = 0;                    // that scripts hold
    std::size_t snapshot_bytes = 0;               // these take
    std::size_t snapshot_size = 0;                // of the last one
    Recording recording;

    std::unordered_map<const property::Method*, int> method_references;
    std::unordered_map<std::string, int> generic_references;

    // References into Lua's registry.
    int vec_meta = 0, color_meta = 0, instance_meta = 0, list_meta = 0, set_meta = 0;
    int record_meta = 0, connection_meta = 0, class_meta = 0, snapshot_meta = 0;
    int description_meta = 0;
    int proxies = 0;      // weak: handle -> proxy
    int environment = 0;  // globals of game and console
    int declared = 0;     // names of globals ever assigned
    int anchors = 0;      // names in the dispatch tables
    int generic = 0;      // methods every instance has
    int loaded = 0;       // modules by name
    int last_result = 0;  // `_` is element 1: a reference itself must never be nil
    int killed = 0;       // weak: coroutines stopped for good
    int pen = 0;
    int counted = 0;                     // weak: what functions of the past hold; 0: not made yet
    const void* counted_text = nullptr;  // the text counted last

    std::filesystem::path folder;                          // of the game
    std::unordered_map<std::string, std::string> sources;  // text by chunk name
    std::function<void(const ScriptError&)> error_sink;
    int reports = 0;  // calls of the sink that have not returned
    std::function<void(std::string_view)> print_sink;
    std::function<void(std::string_view)> note_sink;
    std::optional<int> quit_status;
    std::vector<std::string> assigned;  // globals that game and console made
    property::Handle it;
    property::Painter* painter = nullptr;  // while drawing
    double now = 0;                        // simulation time, seconds

    // Functions whose errors are as the script wants them: `error`, `assert`, those of wrapped
    // coroutines.
    std::vector<lua_CFunction> raise_as_told;
    std::unordered_map<lua_CFunction, std::string> function_names;  // for errors
    std::optional<ScriptError> caught;        // described where it was raised, not yet reported
    std::optional<ScriptError> thread_error;  // raised in a coroutine, on its way out of it
    property::Writer writer = property::Writer::script;  // who writes when a script runs

    /// Instances a script made and has not placed yet.
    std::vector<property::Handle> unplaced;
    std::size_t unplaced_limit = 64;

    /// What a console command may use.
    Limits command_limits() const;
    DispatchTable& dispatch_of(const property::Class& of);
    /// Ends what the scripts have in the tree, and leaves it, if there still is one.
    void leave();
    /// The same, and closes Lua.
    void end();

    /// While it lives, scripts run, and what they call may destroy the runtime: all of it stays as
    /// long.
    class Use {
      public:
        explicit Use(Machine& machine) : machine_(machine) { ++machine_.uses; }
        ~Use() {
            if (--machine_.uses == 0) const std::shared_ptr<void> dead = std::move(machine_.orphan);
        }
        Use(const Use&) = delete;

      private:
        Machine& machine_;
    };
    int uses = 0;
    std::shared_ptr<void> orphan;  // itself, once its runtime was destroyed
    bool in_tree = true;
    /// Whether what happens from now on is noted in `recording`. What is noted is read and written
    /// the long way.
    void record(bool whether);
};

inline Machine& machine_of(lua_State* L) {
    return **static_cast<Machine**>(lua_getextraspace(L));
}

inline void push_registry(lua_State* L, int reference) {
    lua_rawgeti(L, LUA_REGISTRYINDEX, reference);
}

/// Tells the tree who writes while the host has called into Lua; the place is found only when asked
/// for.
class ScriptCause {
  public:
    ScriptCause(Machine& machine, property::Writer writer);

  private:
    std::function<std::string()> locate_;
    property::Tree::CauseScope scope_;
};

}  // namespace fettle::script
