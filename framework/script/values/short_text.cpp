#include <algorithm>

#include <fettle/property/natural_order.h>
#include <fettle/property/path.h>

#include <lua/machine.h>
#include <lua/stack.h>
#include <reference/reference_facts.h>
#include <text/columns.h>
#include <values/description.h>
#include <values/members.h>
#include <values/short_text.h>
#include <values/store_type.h>
#include <values/values.h>

namespace fettle::script {

// --- One line

namespace {

constexpr int deepest = 3;

std::string quoted_text(std::string_view text) {
    if (text.size() > 400) text = text.substr(0, 400);
    return cut(property::value_text(Value(text)), line_width);
}

std::string brief(lua_State* L, int index, int depth);

// Elements first, then named entries in order of name.
std::string table_text(lua_State* L, int index, int depth) {
    if (depth >= deepest) return "{…}";
    luaL_checkstack(L, 6, "table");
    index = lua_absindex(L, index);
    std::string text = "{";
    const auto length = static_cast<lua_Integer>(lua_rawlen(L, index));
    bool first = true;
    const auto add = [&](const std::string& part) {
        text += first ? part : ", " + part;
        first = false;
    };
    for (lua_Integer i = 1; i <= length && text.size() < line_width; ++i) {
        lua_rawgeti(L, index, i);
        add(brief(L, -1, depth + 1));
        lua_pop(L, 1);
    }
    std::vector<std::string> named;
    for (lua_pushnil(L); lua_next(L, index) != 0; lua_pop(L, 1)) {
        if (lua_isinteger(L, -2) && lua_tointeger(L, -2) >= 1 && lua_tointeger(L, -2) <= length)
            continue;
        if (named.size() >= 1000) continue;
        named.push_back(key_text(L, -2) + " = " + brief(L, -1, depth + 1));
    }
    std::sort(named.begin(), named.end(), property::NaturalOrder{});
    for (const std::string& part : named) {
        if (text.size() >= line_width) break;
        add(part);
    }
    return cut(text, line_width) + "}";
}

std::string function_text(lua_State* L, int index) {
    if (const property::Method* method = machine_of(L).members.method_of(L, index))
        return signature(*method);
    lua_pushvalue(L, index);
    lua_Debug info;
    lua_getinfo(L, ">S", &info);
    if (info.what[0] == 'C') return "function";
    return "function at " + std::string(info.short_src) + ":" + std::to_string(info.linedefined);
}

std::string instance_text(const property::Tree& tree, Handle handle) {
    try {
        tree.require(handle);
        return tree.path(handle);
    } catch (const Error& error) {
        return std::string("(") + error.what() + ")";
    }
}

// The text of a description: a list by its elements, a record by its name.
std::string description_text(lua_State* L, int index, const DescriptionKind& kind) {
    push_described(L, index);
    std::string text;
    if (is_description_list(kind)) {
        const lua_Unsigned length = lua_rawlen(L, -1);
        for (lua_Unsigned i = 1; i <= length && text.size() < line_width; ++i) {
            lua_rawgeti(L, -1, static_cast<lua_Integer>(i));
            text += (i > 1 ? ", " : "") + brief(L, -1, deepest);
            lua_pop(L, 1);
        }
        text = "{" + cut(text, line_width) + "}";
    } else {
        lua_getfield(L, -1, "name");
        text = lua_type(L, -1) == LUA_TSTRING ? string_at(L, -1) : "description";
        lua_pop(L, 1);
    }
    lua_pop(L, 1);
    return text;
}

std::string brief(lua_State* L, int index, int depth) {
    Machine& machine = machine_of(L);
    if (const DescriptionKind* kind = description_kind(L, index))
        return description_text(L, index, *kind);
    if (const auto* box = instance_at(L, index)) return instance_text(machine.tree, box->handle);
    if (const Class* of = class_object_at(L, index)) return of->name();
    switch (lua_type(L, index)) {
        case LUA_TNIL:
        case LUA_TNONE:
            return "nil";
        case LUA_TBOOLEAN:
            return lua_toboolean(L, index) ? "true" : "false";
        case LUA_TNUMBER:
            if (lua_isinteger(L, index)) return std::to_string(lua_tointeger(L, index));
            return property::number_text(lua_tonumber(L, index),
                                         property::shortest_precision(lua_tonumber(L, index)));
        case LUA_TSTRING:
            return quoted_text(view_at(L, index));
        case LUA_TTABLE:
            return table_text(L, index, depth);
        case LUA_TFUNCTION:
            return function_text(L, index);
        case LUA_TTHREAD:
            return "coroutine";
        default:
            break;
    }
    if (vec_at(L, index) || color_at(L, index) || list_at(L, index)) {
        try {
            const Value value = to_value(L, index);
            if (value.is(Type::vec2))
                return machine.tree.text(value, property::shortest_precision(value.vec2()));
            return cut(machine.tree.text(value), line_width);
        } catch (const Error& error) {
            return std::string("(") + error.what() + ")";
        }
    }
    if (const auto* box = store_at(L, index)) return cut(stored_text(machine, *box), line_width);
    if (luaL_getmetafield(L, index, "__name") == LUA_TSTRING) {
        std::string name = string_at(L, -1);
        lua_pop(L, 1);
        return name;
    }
    return describe_type(L, index).substr(2);
}

}  // namespace

std::string key_text(lua_State* L, int index) {
    if (lua_type(L, index) == LUA_TSTRING) {
        const std::string key = string_at(L, index);
        return property::is_identifier(key) ? key : "[" + quoted_text(key) + "]";
    }
    return "[" + short_text(L, index) + "]";
}

std::string key_in_message(lua_State* L, int index) {
    return lua_type(L, index) == LUA_TSTRING ? cut(string_at(L, index), line_width)
                                             : short_text(L, index);
}

std::string short_text(lua_State* L, int index) {
    return brief(L, index, 0);
}

}  // namespace fettle::script
