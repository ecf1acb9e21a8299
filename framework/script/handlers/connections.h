#pragma once
// Connections of scripts to watchers, handlers and timers: `connection:stop()`,
// `connection:active()`.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <vector>

#include <fettle/property/tree.h>

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;
class FunctionRef;

/// A function of a script, and how it becomes the handler of an instance; the instance does not
/// matter for the handler of a class or of a pattern.
struct Subscription {
    using Function = std::shared_ptr<FunctionRef>;
    using Connect = std::function<property::Connection(property::Handle instance, const Function&)>;
    Function function;
    Connect connect;
};

/// The handlers are part of snapshots, as timers are: after a rewind, those that were connected at
/// that step are connected again. A handler that a person connects in the console is in no
/// snapshot.
class Connections {
  public:
    explicit Connections(Machine& machine) : machine_(machine) {}
    ~Connections();

    /// Connects and pushes a script object for it. While a game is loaded again, the instance may
    /// be a placeholder for another one: see `reconnect`. It ends with the scene whose `enter`
    /// runs.
    void push(lua_State* L, property::Handle instance, Subscription subscription);
    /// Stores a connection that no script can stop and that is in no snapshot.
    void keep(property::Connection connection);
    void stop(std::uint64_t id);
    bool active(std::uint64_t id) const;
    /// Ends those that `enter` of deleted scenes made.
    void end_with_scenes();
    /// Ends all connections, before a game is loaded.
    void clear();

    // Notes the connections that the top level of a game makes: a reload ends them.
    void begin_noting() { noting_ = true; }
    struct Noted {
        std::uint64_t id = 0;
        property::Handle instance;  // null: of a class, or of a pattern
    };
    std::vector<Noted> end_noting();
    /// Moves a connection to another instance; its number stays.
    void reconnect(const Noted& noted, property::Handle instance);
    /// Ends a connection of code that was replaced by a reload: no rewind connects it again.
    void retire(std::uint64_t id);

    // Snapshots.
    struct Made {
        std::uint64_t id = 0;
        property::Handle instance{}, scene{};
        Subscription::Function function{};
        std::shared_ptr<const Subscription::Connect> connect{};
    };
    using Image = std::vector<Made>;  // in the order in which they were made
    struct Change {
        std::uint64_t id = 0;
        std::optional<Made> added{};  // nullopt: removed
    };
    /// As `Timers::Changes`.
    struct Changes {
        bool all = false;
        Image image{};
        std::vector<Change> list{};
    };
    /// Whether changes are recorded, so that functions may be kept longer than the game keeps them.
    bool recorded() const { return recording_; }
    Image image() const;
    void restore(const Image& image);
    Changes take_changes();
    void redo(const Changes& changes);
    /// Estimated bytes, without the functions; these are counted where they were added.
    static std::size_t bytes_of(const Image& image);
    static std::size_t bytes_of(const Changes& changes);
    /// The instances with handlers that are in snapshots, in the order of `before`, each once.
    std::vector<property::Handle> instances() const;
    /// Whether this note about the pattern of a watcher has not been given before. From now on it
    /// counts as given.
    bool notes(const std::string& note) { return reported_mistakes_.insert(note).second; }
    static bool before(property::Handle a, property::Handle b) {
        return a.index != b.index ? a.index < b.index : a.generation < b.generation;
    }

  private:
    /// The tree owns the function, so that it ends with the instance.
    struct Entry {
        property::Connection connection{};
        property::Handle instance{}, scene{};
        std::weak_ptr<FunctionRef> function{};
        std::shared_ptr<const Subscription::Connect> connect{};  // null: in no snapshot
        bool always = false;  // made by the top level, so it exists from the beginning of the game
    };
    std::uint64_t insert(Entry entry);
    void connect(const Made& made);
    bool can_connect(const Made& made) const;
    void note(Change change);
    static Made made_of(std::uint64_t id, const Entry& entry);

    Machine& machine_;
    std::unordered_map<std::uint64_t, Entry> connections_;
    std::uint64_t next_id_ = 1;
    bool noting_ = false;
    std::vector<Noted> noted_;
    std::size_t prune_at_ = 256;
    bool recording_ = false;
    Changes changes_;
    std::unordered_set<std::uint64_t> retired_;
    std::unordered_set<std::string> reported_mistakes_;
};

/// Pushes a connection for a timer.
void push_timer_connection(lua_State* L, std::uint64_t timer);
void open_connections(lua_State* L, Machine& machine);

}  // namespace fettle::script
