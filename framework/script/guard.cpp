#include "guard.h"

#include <fettle/property/exception_text.h>

#include "machine.h"

namespace fettle::script {

std::string position(lua_State* L) {
    lua_Debug frame;
    for (int level = 0; lua_getstack(L, level, &frame); ++level) {
        lua_getinfo(L, "Sl", &frame);
        if (frame.currentline > 0)
            return std::string(frame.short_src) + ":" + std::to_string(frame.currentline) + ": ";
    }
    return {};
}

void raise(lua_State* L, const std::string& message) {
    raise_text(L, message.c_str());
}

void raise_exception(lua_State* L, const std::exception& error) {
    luaL_checkstack(L, 4, "error message");
    {
        const std::string text = position(L) + property::exception_text(error);
        lua_pushlstring(L, text.data(), text.size());
    }
    lua_error(L);
    std::terminate();  // not reached
}

void raise_text(lua_State* L, const char* message) {
    luaL_checkstack(L, 4, "error message");
    {
        const std::string text = position(L) + message;
        lua_pushlstring(L, text.data(), text.size());
    }
    lua_error(L);
    std::terminate();  // not reached
}

namespace {

// Looks for the function at the top of the stack among the fields of the table below it.
std::string field_of(lua_State* L) {
    const int table = lua_gettop(L) - 1;
    std::string name;
    for (lua_pushnil(L); lua_next(L, table) != 0; lua_pop(L, 1)) {
        if (lua_type(L, -2) != LUA_TSTRING || lua_rawequal(L, -1, table + 1) == 0) continue;
        name = string_at(L, -2);
        lua_pop(L, 2);
        break;
    }
    return name;
}

// What the running function is called among the globals and in their libraries, whatever a script
// calls it; else what the script calls it.
std::string running_function(lua_State* L) {
    lua_Debug frame;
    if (lua_getstack(L, 0, &frame) == 0) return "this";
    luaL_checkstack(L, 8, "name of a function");
    const int top = lua_gettop(L);
    lua_getinfo(L, "nf", &frame);
    push_registry(L, machine_of(L).environment);
    lua_pushvalue(L, -2);
    std::string name = field_of(L);
    lua_pop(L, 1);
    for (lua_pushnil(L); name.empty() && lua_next(L, top + 2) != 0; lua_pop(L, 1)) {
        if (lua_type(L, -2) != LUA_TSTRING || !lua_istable(L, -1)) continue;
        const std::string library = string_at(L, -2);
        lua_pushvalue(L, top + 1);
        const std::string field = field_of(L);
        lua_pop(L, 1);
        if (!field.empty() && library != "_G") name = library + "." + field;
    }
    lua_settop(L, top);
    if (name.empty() && frame.name != nullptr) name = frame.name;
    return name.empty() ? "this" : name;
}

}  // namespace

void require_changeable(lua_State* L) {
    const property::Tree& tree = machine_of(L).tree;
    if (!tree.changeable()) tree.require_changeable("call " + running_function(L));
}

void require_no_formula(lua_State* L) {
    if (machine_of(L).tree.in_formula()) require_changeable(L);
}

}  // namespace fettle::script
