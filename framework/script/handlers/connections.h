#pragma once
// Connections of scripts to watchers, handlers and timers: `connection:stop()`,
// `connection:active()`.

#include <cstdint>
#include <functional>
#include <unordered_map>
#include <utility>
#include <vector>

#include <fettle/property/tree.h>

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

class Connections {
  public:
    Connections() = default;
    ~Connections();

    /// Stores the connection and pushes a script object for it.
    void push(lua_State* L, property::Connection connection);
    /// Connects and does the same. While a game is loaded again, the instance may only stand for
    /// another one: see `connect_again`.
    void push(lua_State* L, property::Handle instance,
              const std::function<property::Connection(property::Handle)>& connect);
    /// Stores a connection that no script can stop.
    void keep(property::Connection connection);
    void stop(std::uint64_t id);
    bool active(std::uint64_t id) const;
    /// The number of the next connection.
    std::uint64_t next_number() const { return next_id_; }
    /// Ends all connections, before a game is loaded.
    void clear();

    // Those that the top level of a game makes: a reload ends them.
    void begin_noting() { noting_ = true; }
    struct Noted {
        std::uint64_t id = 0;
        property::Handle instance;  // null: of a class, or of a pattern
        std::function<property::Connection(property::Handle)> connect{};
    };
    std::vector<Noted> end_noting();
    /// Moves a connection to another instance; its number stays.
    void connect_again(const Noted& noted, property::Handle instance);

  private:
    std::uint64_t insert(property::Connection connection);
    void note(Noted noted) {
        if (noting_) noted_.push_back(std::move(noted));
    }

    std::unordered_map<std::uint64_t, property::Connection> connections_;
    std::uint64_t next_id_ = 1;
    bool noting_ = false;
    std::vector<Noted> noted_;
    std::size_t prune_at_ = 256;
};

/// Pushes a connection for a timer.
void push_timer_connection(lua_State* L, std::uint64_t timer);
void open_connections(lua_State* L, Machine& machine);

}  // namespace fettle::script
