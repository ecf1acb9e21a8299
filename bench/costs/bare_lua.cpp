#include "costs/bare_lua.h"

#include <lauxlib.h>
#include <lua.h>
#include <lualib.h>
#include <stdexcept>

namespace fettle::bench {
namespace {

struct Ball {
    double mass = 1;
};

int index_of_ball(lua_State* lua) {
    lua_pushnumber(lua, static_cast<const Ball*>(lua_touserdata(lua, 1))->mass);
    return 1;
}

int newindex_of_ball(lua_State* lua) {
    static_cast<Ball*>(lua_touserdata(lua, 1))->mass = lua_tonumber(lua, 3);
    return 0;
}

}  // namespace

BareLua::BareLua(const std::string& script) : lua_(luaL_newstate()) {
    if (!lua_) throw std::bad_alloc();
    luaL_openlibs(lua_);
    new (lua_newuserdatauv(lua_, sizeof(Ball), 0)) Ball;
    // Large, like the table of our runtime: in a full table, keys may collide.
    lua_createtable(lua_, 0, 256);
    lua_pushcfunction(lua_, index_of_ball);
    lua_setfield(lua_, -2, "__index");
    lua_pushcfunction(lua_, newindex_of_ball);
    lua_setfield(lua_, -2, "__newindex");
    lua_setmetatable(lua_, -2);
    lua_setglobal(lua_, "ball");
    if (luaL_dostring(lua_, script.c_str()) != LUA_OK) fail();
}

BareLua::~BareLua() {
    lua_close(lua_);
}

void BareLua::call(const char* function, long long argument) {
    lua_getglobal(lua_, function);
    lua_pushinteger(lua_, argument);
    if (lua_pcall(lua_, 1, 0, 0) != LUA_OK) fail();
}

void BareLua::fail() {
    throw std::runtime_error(lua_tostring(lua_, -1));
}

}  // namespace fettle::bench
