#include <fettle/property/error.h>
#include <fettle/property/exception_text.h>
#include <fettle/property/spelling.h>
#include <fettle/property/utf8.h>

#include <lua/exception_guard.h>
#include <lua/interpreter.h>
#include <lua/library_chunks.h>
#include <lua/machine.h>
#include <lua/stack.h>

namespace fettle::script {

std::string position(lua_State* L) {
    lua_Debug frame;
    for (int level = 0; lua_getstack(L, level, &frame); ++level) {
        lua_getinfo(L, "Sl", &frame);
        if (frame.currentline > 0 && !is_library(frame))
            return std::string(frame.short_src) + ":" + std::to_string(frame.currentline) + ": ";
    }
    return {};
}

std::string definition(lua_State* L) {
    lua_pushvalue(L, -1);
    lua_Debug frame;
    lua_getinfo(L, ">S", &frame);
    return std::string(frame.short_src) + ":" + std::to_string(frame.linedefined) + ": ";
}

namespace {

constexpr std::size_t max_message = 4096;  // bytes

/// A message may quote a name or text of any length: the middle of a long message is left out.
std::string limited(const std::string& message) {
    if (message.size() <= max_message) return message;
    const std::size_t begin = property::code_point_boundary(message, max_message / 2);
    const std::size_t end =
        property::next_code_point(message, message.size() - max_message / 2 - 1);
    return message.substr(0, begin) + " ... (" + std::to_string(end - begin) +
           " bytes left out) ... " + message.substr(end);
}

/// Stores the message of an error about an instance that a restore has removed.
void note_gone(lua_State* L, const std::exception& error, const std::string& message) {
    const auto* known = dynamic_cast<const property::Error*>(&error);
    if (known != nullptr && known->kind() == property::ErrorKind::deleted &&
        message.ends_with(" by restore"))
        machine_of(L).lua.gone = message;
}

}  // namespace

void raise(lua_State* L, const std::string& message) {
    raise_text(L, message.c_str());
}

void raise_exception(lua_State* L, const std::exception& error) {
    luaL_checkstack(L, 4, "error message");
    {
        const std::string message = limited(property::exception_text(error));
        note_gone(L, error, message);
        const std::string text = position(L) + message;
        push_text(L, text);
    }
    lua_error(L);
    std::terminate();  // not reached
}

void raise_text(lua_State* L, const char* message) {
    luaL_checkstack(L, 4, "error message");
    {
        const std::string text = position(L) + limited(message);
        push_text(L, text);
    }
    lua_error(L);
    std::terminate();  // not reached
}

namespace {

/// What the running function does, after "cannot": "call undo", "assign to a store".
std::string running_action(lua_State* L) {
    lua_Debug frame;
    if (lua_getstack(L, 0, &frame) == 0) return "call this";
    luaL_checkstack(L, 4, "name of a function");
    lua_getinfo(L, "nf", &frame);
    const lua_CFunction function = lua_tocfunction(L, -1);
    lua_pop(L, 1);
    const auto& names = machine_of(L).lua.function_names;
    if (const auto noted = names.find(function); noted != names.end())
        return "call " + noted->second;
    if (frame.name == nullptr) return "call this";
    const std::string_view name = frame.name;
    if (std::string_view(frame.namewhat) != "metamethod") return "call " + std::string(name);
    std::string object = "this";
    if (luaL_getmetafield(L, 1, "__name") == LUA_TSTRING) {
        object = property::with_article(view_at(L, -1));
        lua_pop(L, 1);
    }
    return (name == "newindex" ? "assign to " : "read ") + object;
}

void note_names_of(lua_State* L, const std::string& library) {
    for (lua_pushnil(L); lua_next(L, -2) != 0; lua_pop(L, 1)) {
        if (lua_type(L, -2) != LUA_TSTRING) continue;
        const std::string name = string_at(L, -2);
        if (const lua_CFunction function = lua_tocfunction(L, -1))
            machine_of(L).lua.function_names.insert_or_assign(function, library + name);
        else if (lua_istable(L, -1) && library.empty() && name != "_G")
            note_names_of(L, name + ".");
    }
}

}  // namespace

void note_name(lua_State* L, lua_CFunction function, const std::string& name) {
    machine_of(L).lua.function_names.emplace(function, name);
}

void note_names(lua_State* L) {
    note_names_of(L, {});
}

void require_changeable(lua_State* L) {
    const property::Tree& tree = machine_of(L).tree;
    if (!tree.changeable()) tree.require_changeable(running_action(L));
}

void require_no_formula(lua_State* L) {
    if (machine_of(L).tree.in_formula()) require_changeable(L);
}

}  // namespace fettle::script
