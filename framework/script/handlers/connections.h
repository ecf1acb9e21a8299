#pragma once
// Connections of scripts to watchers, handlers and timers: `connection:stop()`,
// `connection:active()`.

#include <cstdint>
#include <unordered_map>

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
    /// Stores a connection that no script can stop.
    void keep(property::Connection connection);
    void stop(std::uint64_t id);
    bool active(std::uint64_t id) const;
    /// The number of the next connection.
    std::uint64_t next_number() const { return next_id_; }
    /// Ends all connections, before a game is loaded.
    void clear();

  private:
    std::uint64_t insert(property::Connection connection);

    std::unordered_map<std::uint64_t, property::Connection> connections_;
    std::uint64_t next_id_ = 1;
    std::size_t prune_at_ = 256;
};

/// Pushes a connection for a timer.
void push_timer_connection(lua_State* L, std::uint64_t timer);
void open_connections(lua_State* L, Machine& machine);

}  // namespace fettle::script
