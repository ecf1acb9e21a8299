#pragma once
// A Lua state and its threads.

#include <memory>
#include <string>
#include <unordered_map>

#include <lua/lua_api.h>

namespace fettle::script {

/// Percent: a collection begins when Lua's memory reaches this share of its memory after the last
/// collection.
inline constexpr int collector_pause = 400;

/// The values that `held_memory` has counted already.
struct CountedMemory {
    int set = 0;                 // weak table in the registry: tables and functions; 0: none yet
    const void* text = nullptr;  // the last counted text
};

struct Interpreter {
    lua_State* main = nullptr;
    lua_State* running = nullptr;       // running thread; all switches go through our functions
    std::shared_ptr<lua_State*> alive;  // contains nullptr once Lua is closed
    int killed = 0;                     // weak table in the registry: coroutines stopped for good
    std::unordered_map<lua_CFunction, std::string> function_names;  // for error messages
    // Message of the last error about an instance that a restore has removed; "" if there was none.
    std::string gone;
    CountedMemory counted{};
};

}  // namespace fettle::script
