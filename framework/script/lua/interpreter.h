#pragma once
// A state of Lua and its threads.

#include <memory>
#include <string>
#include <unordered_map>

#include <lua/lua_api.h>

namespace fettle::script {

/// Per cent: a collection begins when Lua has so much of the memory that the last one left.
inline constexpr int collector_pause = 400;

struct Interpreter {
    lua_State* main = nullptr;
    lua_State* running = nullptr;       // thread that runs now; exact, since we make every switch
    std::shared_ptr<lua_State*> alive;  // what outlives Lua looks here: nullptr once it is closed
    int killed = 0;                     // weak table in the registry: coroutines stopped for good
    std::unordered_map<lua_CFunction, std::string> function_names;  // for errors
};

}  // namespace fettle::script
