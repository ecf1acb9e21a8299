#pragma once
// What scripts hold of watchers, handlers and timers: `connection:stop()`, `connection:active()`.

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

    /// Keeps the connection and pushes what a script holds of it.
    void push(lua_State* L, property::Connection connection);
    /// Keeps the connection; no script can stop it.
    void keep(property::Connection connection);
    void stop(std::uint64_t id);
    bool active(std::uint64_t id) const;
    /// Ends all of them: the game is loaded anew.
    void clear();

  private:
    std::uint64_t insert(property::Connection connection);

    std::unordered_map<std::uint64_t, property::Connection> connections_;
    std::uint64_t next_id_ = 1;
    std::size_t prune_at_ = 256;
};

/// Pushes a connection that stands for a timer.
void push_timer_connection(lua_State* L, std::uint64_t timer);
void open_connections(lua_State* L, Machine& machine);

}  // namespace fettle::script
