#pragma once
// The global functions `snapshot`, `restore` and `rewind`.

#include <cstddef>
#include <cstdint>

#include <lua/lua_api.h>

namespace fettle::script {

struct Machine;

/// The snapshots that scripts hold, and the pending restores and rewinds.
struct HeldSnapshots {
    std::size_t count = 0;
    std::size_t bytes = 0;      // of these snapshots
    std::size_t last_size = 0;  // size of the last snapshot, bytes
    std::size_t travels = 0;    // restores and rewinds that are pending until the next barrier
    // To notice a game that goes back for ever, see `require_no_circle`.
    std::uint64_t restored = 0;  // how often the state was replaced by another
    std::uint64_t asked_at = 0;  // `restored` when a handler of it last asked for another
    std::size_t asked_in_a_row = 0;
};

/// To be called by `what`, which replaces the state of the game at the next barrier. Throws if the
/// handlers of the event `restored` call it each time that it causes this event.
void require_no_circle(Machine& machine, const char* what);

/// Adds the functions to the table of globals at the top of the stack.
void open_time(lua_State* L);

}  // namespace fettle::script
