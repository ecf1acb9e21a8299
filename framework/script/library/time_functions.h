#pragma once
// `snapshot restore rewind`: time as scripts and the console travel it.

#include <cstddef>

#include <lua/lua_api.h>

namespace fettle::script {

/// What scripts hold of the past, and how often they go back to it.
struct HeldSnapshots {
    std::size_t count = 0;
    std::size_t bytes = 0;      // these take
    std::size_t last_size = 0;  // of the last one
    std::size_t travels = 0;    // restores and rewinds that wait for the next barrier
};

/// Into the table of globals on top.
void open_time(lua_State* L);

}  // namespace fettle::script
