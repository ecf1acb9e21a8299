#include <sources/call_form.h>

#include <string_view>

#include <lua/library_chunks.h>
#include <lua/machine.h>
#include <sources/sources.h>

namespace fettle::script {

namespace {

bool in_name(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
}

/// The place before the bracket that the one at `end - 1` closes; `end` if there is none.
std::size_t before_bracket(std::string_view line, std::size_t end) {
    int open = 0;
    for (std::size_t at = end; at > 0; --at) {
        const char c = line[at - 1];
        if (c == ')' || c == ']') ++open;
        if (c == '(' || c == '[') --open;
        if (open == 0) return at - 1;
    }
    return end;
}

/// The expression that ends at `end`: names, calls and indices, joined by dots and colons.
std::string_view object_before(std::string_view line, std::size_t end) {
    std::size_t begin = end;
    while (begin > 0) {
        while (begin > 0 && (line[begin - 1] == ')' || line[begin - 1] == ']')) {
            const std::size_t opened = before_bracket(line, begin);
            if (opened == begin) return {};
            begin = opened;
        }
        while (begin > 0 && in_name(line[begin - 1])) --begin;
        if (begin == 0 || (line[begin - 1] != '.' && line[begin - 1] != ':')) break;
        --begin;
    }
    return line.substr(begin, end - begin);
}

/// What is called in the line as `object.name` (or another sign); "" if that is not clear.
std::string object_in(std::string_view line, char sign, std::string_view name) {
    std::string_view found;
    for (std::size_t at = line.find(name); at != std::string_view::npos;
         at = line.find(name, at + 1)) {
        std::size_t after = at + name.size();
        if (at == 0 || line[at - 1] != sign || (after < line.size() && in_name(line[after])))
            continue;
        while (after < line.size() && line[after] == ' ') ++after;
        if (after == line.size() || std::string_view("({\"'[").find(line[after]) == line.npos)
            continue;
        const std::string_view object = object_before(line, at - 1);
        if (object.empty() || (!found.empty() && object != found)) return {};
        found = object;
    }
    return std::string(found);
}

/// The line of a script in which the function at `level` is called.
std::string calling_line(lua_State* L, int level) {
    lua_Debug frame;
    for (++level; lua_getstack(L, level, &frame); ++level) {
        lua_getinfo(L, "Sl", &frame);
        if (frame.currentline > 0 && !is_library(frame))
            return machine_of(L).sources.line(frame.short_src, frame.currentline);
    }
    return {};
}

}  // namespace

std::string colon_hint(lua_State* L, int level) {
    lua_Debug frame;
    if (lua_getstack(L, level, &frame) == 0) return {};
    lua_getinfo(L, "n", &frame);
    if (std::string_view(frame.namewhat) != "field") return {};
    const std::string object = object_in(calling_line(L, level), '.', frame.name);
    return "; call it with a colon" + (object.empty() ? ", as in ball" : ": " + object) + ":" +
           frame.name + "(...)";
}

std::string dot_hint(lua_State* L, int level) {
    lua_Debug frame;
    if (lua_getstack(L, level, &frame) == 0) return {};
    lua_getinfo(L, "n", &frame);
    if (std::string_view(frame.namewhat) != "method" || lua_getlocal(L, &frame, 1) == nullptr)
        return {};
    // Sets of instances are tables, too, but have their methods in a metatable.
    bool in_table = lua_type(L, -1) == LUA_TTABLE;
    if (in_table) {
        lua_pushstring(L, frame.name);
        in_table = lua_rawget(L, -2) == LUA_TFUNCTION;
        lua_pop(L, 1);
    }
    lua_pop(L, 1);
    const std::string object =
        in_table ? object_in(calling_line(L, level), ':', frame.name) : std::string();
    if (object.empty()) return {};
    return "; call it with a dot: " + object + "." + frame.name + "(...)";
}

}  // namespace fettle::script
