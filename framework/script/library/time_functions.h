#pragma once
// The global functions `snapshot`, `restore` and `rewind`.

#include <cstddef>

#include <lua/lua_api.h>

namespace fettle::script {

/// The snapshots that scripts hold, and the pending restores and rewinds.
struct HeldSnapshots {
    std::size_t count = 0;
    std::size_t bytes = 0;      // of these snapshots
    std::size_t last_size = 0;  // size of the last snapshot, bytes
    std::size_t travels = 0;    // restores and rewinds that are pending until the next barrier
};

/// Adds the functions to the table of globals at the top of the stack.
void open_time(lua_State* L);

}  // namespace fettle::script
