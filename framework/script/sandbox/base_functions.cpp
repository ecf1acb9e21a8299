// Replacements of basic functions of Lua with which a script could leave the sandbox, hang, or
// make runs differ.

#include <algorithm>
#include <cstring>

#include <fettle/property/pinned.h>
#include <fettle/script/runtime.h>

#include <calls/errors.h>
#include <limits/limiters.h>
#include <lua/exception_guard.h>
#include <lua/host.h>
#include <lua/interpreter.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <sandbox/sandbox.h>
#include <sources/sources.h>
#include <text/columns.h>
#include <values/recording.h>
#include <values/records.h>
#include <values/short_text.h>
#include <values/values.h>

namespace fettle::script {

// --- tostring, print

void push_tostring(lua_State* L, int index) {
    index = lua_absindex(L, index);
    luaL_checkstack(L, 4, "text");
    if (luaL_getmetafield(L, index, "__tostring") != LUA_TNIL) {
        lua_pushvalue(L, index);
        lua_call(L, 1, 1);
        if (lua_type(L, -1) != LUA_TSTRING)
            throw Error(ErrorKind::wrong_type, "__tostring must return a text");
        return;
    }
    switch (lua_type(L, index)) {
        case LUA_TSTRING:
            lua_pushvalue(L, index);
            return;
        case LUA_TNUMBER:
            if (lua_isinteger(L, index)) {
                lua_pushvalue(L, index);
                lua_tolstring(L, -1, nullptr);
            } else {
                const std::string text = number_for_people(lua_tonumber(L, index));
                push_text(L, text);
            }
            return;
        case LUA_TBOOLEAN:
            lua_pushstring(L, lua_toboolean(L, index) ? "true" : "false");
            return;
        case LUA_TNIL:
            lua_pushstring(L, "nil");
            return;
        case LUA_TTABLE:
            if (luaL_getmetafield(L, index, "__name") == LUA_TSTRING) return;
            push_text(L, short_text(L, index));
            return;
        default:
            if (luaL_getmetafield(L, index, "__name") == LUA_TSTRING) return;
            lua_pushstring(L, luaL_typename(L, index));
            return;
    }
}

void print_line(Machine& machine, std::string text) {
    constexpr std::size_t max_lines = 2000;
    if (!machine.recording.active) {
        const std::size_t limit = machine.options.limits.output;
        machine.host.printed += text.size() + 1;
        if (limit > 0 && machine.host.printed > limit) {
            machine.limiters.budget.stop(
                machine.lua.running, "stopped: it has printed more than " + std::to_string(limit) +
                                         " bytes, as much as this game may");
            return;
        }
        const property::Pinned pinned(machine.tree, "the function given to on_print");
        // A copy, because the call may replace it.
        if (const auto sink = machine.host.on_print) sink(text);
        return;
    }
    // In the console, each line of the text is one line.
    std::size_t start = 0;
    do {
        const std::size_t end = text.find('\n', start);
        if (machine.recording.lines.size() >= max_lines) {
            ++machine.recording.dropped_lines;
        } else {
            machine.recording.lines.push_back(
                cut(std::string_view(text).substr(
                        start, end == std::string::npos ? std::string::npos : end - start),
                    4000));
        }
        start = end == std::string::npos ? end : end + 1;
    } while (start != std::string::npos);
}

void print_folded(Machine& machine, std::vector<std::string> lines, FoldedLines folded) {
    Recording& recording = machine.recording;
    folded.line += recording.lines.size();
    for (std::string& line : lines) print_line(machine, std::move(line));
    if (recording.active && !folded.lines.empty() && folded.line < recording.lines.size())
        recording.folded.push_back(std::move(folded));
}

namespace {

int to_text(lua_State* L) {
    luaL_checkany(L, 1);
    push_tostring(L, 1);
    return 1;
}

int print(lua_State* L) {
    std::string line;
    const int given = lua_gettop(L);
    for (int i = 1; i <= given; ++i) {
        push_tostring(L, i);
        if (i > 1) line += '\t';
        line += view_at(L, -1);
        lua_pop(L, 1);
    }
    Machine& machine = machine_of(L);
    machine.limiters.budget.charge(L, 100 + line.size() / 8);
    Recording& recording = machine.recording;
    const std::size_t first = recording.lines.size();
    print_line(machine, std::move(line));
    for (std::size_t i = first; i < recording.lines.size(); ++i) recording.texts.push_back(i);
    return 0;
}

// --- pairs

// Upvalues: table, sorted keys, position. Keys that were removed meanwhile are skipped.
int next_sorted(lua_State* L) {
    for (;;) {
        const lua_Integer position = lua_tointeger(L, lua_upvalueindex(3)) + 1;
        lua_pushinteger(L, position);
        lua_copy(L, -1, lua_upvalueindex(3));
        lua_pop(L, 1);
        if (lua_rawgeti(L, lua_upvalueindex(2), position) == LUA_TNIL) return 1;
        lua_pushvalue(L, -1);
        if (lua_rawget(L, lua_upvalueindex(1)) != LUA_TNIL) return 2;
        lua_pop(L, 2);
    }
}

struct Key {
    enum Kind : int { number, text, instance, other } kind = other;
    double order = 0;  // of a number
    // An integer, for which a double is too coarse; the handle of an instance.
    std::int64_t integer = 0;
    const char* chars = nullptr;
    std::size_t length = 0;
    lua_Integer place = 0;  // index in the table of keys
};

bool before(const Key& a, const Key& b) {
    if (a.kind != b.kind) return a.kind < b.kind;
    if (a.kind == Key::number || a.kind == Key::instance)
        return a.order != b.order ? a.order < b.order : a.integer < b.integer;
    if (a.kind == Key::text) {
        const int order = std::memcmp(a.chars, b.chars, std::min(a.length, b.length));
        return order != 0 ? order < 0 : a.length < b.length;
    }
    return false;  // other keys keep Lua's order
}

int sorted_pairs(lua_State* L) {
    luaL_checkany(L, 1);
    lua_settop(L, 1);  // the stack indices below require exactly one argument
    if (luaL_getmetafield(L, 1, "__pairs") != LUA_TNIL) {
        lua_pushvalue(L, 1);
        lua_call(L, 1, 3);
        return 3;
    }
    if (lua_type(L, 1) != LUA_TTABLE) refuse_type(L, 1, "pairs: needs a table");
    lua_newtable(L);  // index 2: the keys in Lua's order; this also keeps the texts alive
    std::vector<Key> keys;
    for (lua_pushnil(L); lua_next(L, 1) != 0;) {
        lua_pop(L, 1);
        Key key;
        key.place = static_cast<lua_Integer>(keys.size()) + 1;
        if (lua_type(L, -1) == LUA_TNUMBER) {
            key.kind = Key::number;
            key.order = lua_tonumber(L, -1);
            key.integer = lua_tointeger(L, -1);
        } else if (lua_type(L, -1) == LUA_TSTRING) {
            key.kind = Key::text;
            key.chars = lua_tolstring(L, -1, &key.length);
        } else if (const InstanceBox* box = instance_at(L, -1)) {
            // Lua orders them by address, which differs between runs.
            key.kind = Key::instance;
            key.integer = std::int64_t{box->handle.index} << 32 | box->handle.generation;
        }
        keys.push_back(key);
        lua_pushvalue(L, -1);
        lua_rawseti(L, 2, key.place);
    }
    machine_of(L).limiters.budget.charge(L, keys.size());
    std::stable_sort(keys.begin(), keys.end(), before);
    lua_pushvalue(L, 1);
    lua_createtable(L, static_cast<int>(keys.size()), 0);
    lua_Integer n = 0;
    for (const Key& key : keys) {
        lua_rawgeti(L, 2, key.place);
        lua_rawseti(L, -2, ++n);
    }
    lua_pushinteger(L, 0);
    lua_pushcclosure(L, guarded<next_sorted>, 3);
    lua_pushvalue(L, 1);
    lua_pushnil(L);
    return 3;
}

// Lua's own function (upvalue 1) accepts values without elements and raises a confusing error
// later.
int ipairs(lua_State* L) {
    luaL_checkany(L, 1);
    const int type = lua_type(L, 1);
    if (type != LUA_TTABLE &&
        (type == LUA_TSTRING || luaL_getmetafield(L, 1, "__index") == LUA_TNIL))
        refuse_type(L, 1,
                    type == LUA_TFUNCTION
                        ? "ipairs: needs a list (write brackets after a function, "
                          "as in world:children())"
                        : "ipairs: needs a list");
    lua_settop(L, 1);
    return call_original(L);
}

// --- Metatables

int set_metatable(lua_State* L) {
    if (lua_type(L, 1) != LUA_TTABLE) refuse_type(L, 1, "setmetatable: needs a table");
    if (!lua_isnoneornil(L, 2) && lua_type(L, 2) != LUA_TTABLE)
        refuse_type(L, 2, "setmetatable: the second argument is a table or nil");
    lua_settop(L, 2);
    if (luaL_getmetafield(L, 1, "__metatable") != LUA_TNIL)
        throw Error(ErrorKind::rejected, "cannot change a protected metatable");
    if (lua_istable(L, 2)) {
        lua_pushliteral(L, "__gc");
        // A budget cannot stop a finalizer, and it is not deterministic when the collector runs it.
        if (lua_rawget(L, 2) != LUA_TNIL)
            throw Error(ErrorKind::rejected,
                        "setmetatable: finalizers (__gc) are not available; use <close> variables");
        lua_pop(L, 1);
    }
    lua_settop(L, 2);
    lua_setmetatable(L, 1);
    return 1;
}

int get_metatable(lua_State* L) {
    luaL_checkany(L, 1);
    if (!lua_getmetatable(L, 1)) {
        lua_pushnil(L);
        return 1;
    }
    lua_pushliteral(L, "__metatable");
    if (lua_rawget(L, -2) == LUA_TNIL) lua_pop(L, 1);
    return 1;
}

// --- Chunks

// Reads from the function at index 1. What is left of its latest text is at `data`, and the text at
// index 5, which keeps it alive.
const char* read_piece(lua_State* L, void* data, std::size_t* size) {
    auto& left = *static_cast<std::string_view*>(data);
    if (!left.empty()) return next_piece(L, left, size);
    luaL_checkstack(L, 2, "too many nested functions");
    lua_pushvalue(L, 1);
    lua_call(L, 0, 1);
    if (lua_isnil(L, -1)) {
        lua_pop(L, 1);
        *size = 0;
        return nullptr;
    }
    if (lua_type(L, -1) != LUA_TSTRING) luaL_error(L, "reader function must return a string");
    lua_replace(L, 5);
    left = view_at(L, 5);
    return next_piece(L, left, size);
}

// load(chunk [, name [, mode [, env]]]). Accepts only source text, whatever the mode.
int load_chunk(lua_State* L) {
    const bool own_environment = lua_gettop(L) >= 4;
    const bool text = lua_type(L, 1) == LUA_TSTRING;
    if (!text && lua_type(L, 1) != LUA_TFUNCTION)
        refuse_type(L, 1, "load: needs a text or a function");
    const std::string name = lua_type(L, 2) == LUA_TSTRING ? string_at(L, 2) : "=(load)";
    if (lua_type(L, 3) == LUA_TSTRING && view_at(L, 3).find('t') == std::string_view::npos) {
        lua_pushnil(L);
        push_text(L, "attempt to load a text chunk (mode is '" + string_at(L, 3) + "')");
        return 2;
    }
    lua_settop(L, 4);
    lua_pushnil(L);  // index 5, for the pieces
    int status;
    if (text) {
        status = load_text(L, view_at(L, 1), name.c_str());
    } else {
        std::string_view left;
        status = lua_load(L, read_piece, &left, name.c_str(), "t");
    }
    machine_of(L).limiters.budget.check(L);
    if (status != LUA_OK) {
        lua_pushnil(L);
        lua_insert(L, -2);
        return 2;
    }
    if (own_environment) {
        lua_pushvalue(L, 4);
        if (!lua_setupvalue(L, -2, 1)) lua_pop(L, 1);
    }
    return 1;
}

// --- pcall, xpcall

// Upvalue: the script's handler. It is not called while a command is being stopped.
int call_handler(lua_State* L) {
    Machine& machine = machine_of(L);
    if (machine.limiters.budget.stopping()) return 1;
    lua_settop(L, 1);
    complete_message(L, L, 1);
    lua_pushvalue(L, lua_upvalueindex(1));
    lua_insert(L, 1);
    lua_call(L, 1, 1);
    return 1;
}

// Raising an error costs about as much as this number of instructions.
constexpr std::uint64_t cost_of_error = 300;

// Lua's error at the top of the stack contains neither the place nor the limit. Replaces it by a
// better one.
void replace_memory_error(lua_State* L, int status) {
    if (status != LUA_ERRMEM) return;
    if (const std::string refusal = machine_of(L).limiters.budget.take_refusal();
        !refusal.empty()) {
        lua_pop(L, 1);
        push_text(L, refusal);
    }
}

int finish_pcall(lua_State* L, int status, lua_KContext) {
    if (status == LUA_OK || status == LUA_YIELD)
        return lua_gettop(L) - 1;  // all except the handler
    machine_of(L).limiters.budget.charge(L, cost_of_error);
    replace_memory_error(L, status);
    lua_pushboolean(L, 0);
    lua_insert(L, -2);
    return 2;
}

int protected_call(lua_State* L) {
    luaL_checkany(L, 1);
    lua_pushcfunction(L, placing_handler);
    lua_pushboolean(L, 1);  // first result on success
    lua_rotate(L, 1, 2);
    const int status = lua_pcallk(L, lua_gettop(L) - 3, LUA_MULTRET, 1, 0, finish_pcall);
    return finish_pcall(L, status, 0);
}

int finish_xpcall(lua_State* L, int status, lua_KContext) {
    const bool failed = status != LUA_OK && status != LUA_YIELD;
    replace_memory_error(L, status);
    lua_pushboolean(L, !failed);
    if (failed) {
        machine_of(L).limiters.budget.charge(L, cost_of_error);
        lua_insert(L, -2);
        return 2;
    }
    lua_replace(L, 1);  // replaces the handler; the results follow
    return lua_gettop(L);
}

int protected_call_with_handler(lua_State* L) {
    if (lua_type(L, 2) != LUA_TFUNCTION)
        refuse_type(L, 2, "xpcall: the second argument is a function");
    const int arguments = lua_gettop(L) - 2;
    lua_pushvalue(L, 2);
    lua_pushcclosure(L, guarded<call_handler>, 1);  // handler
    lua_pushvalue(L, 1);                            // function
    lua_rotate(L, 1, 2);  // order: handler, function, then both originals and the arguments
    lua_remove(L, 3);
    lua_remove(L, 3);
    const int status = lua_pcallk(L, arguments, LUA_MULTRET, 1, 0, finish_xpcall);
    return finish_xpcall(L, status, 0);
}

// --- The collector

int collect_garbage(lua_State* L) {
    const char* option = luaL_optstring(L, 1, "collect");
    Machine& machine = machine_of(L);
    const std::string_view what = option;
    if (what == "count") {
        lua_pushnumber(L, static_cast<double>(machine.limiters.arena.bytes()) / 1024.0);
    } else if (what == "collect" || what == "step") {
        machine.limiters.budget.charge(L, 1000 + machine.limiters.arena.bytes() / 16);
        lua_gc(L, LUA_GCCOLLECT);
        lua_pushinteger(L, 0);
    } else {
        throw Error(ErrorKind::rejected, std::string("collectgarbage: \"") + option +
                                             "\" is not available, only \"collect\", \"step\" and "
                                             "\"count\"");
    }
    return 1;
}

int quit(lua_State* L) {
    std::int64_t status = 0;
    if (lua_isboolean(L, 1)) {
        status = lua_toboolean(L, 1) ? 0 : 1;
    } else if (!lua_isnoneornil(L, 1) && !is_record(L, 1)) {  // Button { pressed = quit }
        int whole = 0;
        status = lua_tointegerx(L, 1, &whole);
        if (!whole || status < 0 || status > 255)
            throw Error(ErrorKind::out_of_range,
                        "quit: a status is a whole number from 0 to 255, not " + short_text(L, 1));
    }
    machine_of(L).host.quit_status = static_cast<int>(status);
    return 0;
}

int degrees(lua_State* L) {
    lua_pushnumber(L, check_number(L, 1, "deg") * (3.14159265358979323846 / 180.0));
    return 1;
}

}  // namespace

void open_base(lua_State* L) {
    add_pure<to_text>(L, "tostring");
    add_pure<print>(L, "print");
    add_pure<sorted_pairs>(L, "pairs");
    wrap_pure<ipairs>(L, "_G", "ipairs");
    add_pure<set_metatable>(L, "setmetatable");
    add_pure<get_metatable>(L, "getmetatable");
    add_pure<load_chunk>(L, "load");
    add_pure<protected_call>(L, "pcall");
    add_pure<protected_call_with_handler>(L, "xpcall");
    add_pure<collect_garbage>(L, "collectgarbage");
    add_function<quit>(L, "quit");
    add_pure<degrees>(L, "deg");
}

}  // namespace fettle::script
