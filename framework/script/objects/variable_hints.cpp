#include <algorithm>

#include <classes/script_classes.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <objects/variable_hints.h>
#include <other_languages/synonyms.h>
#include <sources/sources.h>
#include <text/words.h>
#include <values/values.h>

namespace fettle::script {

namespace {

/// The function of a script that reads or writes a global name; level 0 is the C function that Lua
/// calls for this.
bool reader(lua_State* L, lua_Debug& frame) {
    return lua_getstack(L, 1, &frame) != 0 && lua_getinfo(L, "Slf", &frame) != 0;
}

/// The instance in the variable `self` of the function on top of the stack: a local one, or that
/// of a function around it.
Handle self_of(lua_State* L, const lua_Debug& frame) {
    Handle found{};
    const auto take = [&](const char* name) {
        if (std::string_view(name) == "self")
            if (const auto* box = instance_at(L, -1)) found = box->handle;
        lua_pop(L, 1);
    };
    const int function = lua_gettop(L);
    for (int i = 1; const char* name = lua_getupvalue(L, function, i); ++i) take(name);
    for (int i = 1; const char* name = lua_getlocal(L, &frame, i); ++i) take(name);
    return found;
}

/// Whether the line makes the name: `local boom`, `function boom`, `boom = ...`.
bool makes(std::string_view line, std::string_view name) {
    const std::size_t at = find_word(line, name);
    if (at == std::string_view::npos) return false;
    const std::string_view before = trimmed(line.substr(0, at));
    const std::string_view after = trimmed(line.substr(at + name.size()));
    if (before == "function" || before == "local function") return after.starts_with('(');
    const bool assigned = after.starts_with('=') && !after.starts_with("==");
    return before == "local" || (before.empty() && assigned);
}

}  // namespace

std::string hint_of_self(lua_State* L, Machine& machine, std::string_view name,
                         bool properties_only) {
    lua_Debug frame;
    if (!lua_checkstack(L, 4) || !reader(L, frame)) return {};
    const Handle self = self_of(L, frame);
    lua_pop(L, 1);
    const property::Tree& tree = machine.tree;
    if (!self || !tree.alive(self)) return {};
    const Class& of = tree.class_of(self);
    const bool property = of.property(name) != nullptr;
    if (property || (!properties_only && tree.child(self, name)))
        return hint_of("self." + std::string(name));
    if (properties_only) return {};
    bool method = of.method(name) != nullptr;
    for (const Class* each = &of; each != nullptr && !method; each = each->base())
        method = among(machine.classes.own_functions(*each), name);
    return method ? hint_of("self:" + std::string(name) + "(...)") : std::string();
}

std::string hint_of_later_line(lua_State* L, const Machine& machine, std::string_view name) {
    lua_Debug frame;
    if (!lua_checkstack(L, 4) || !reader(L, frame)) return {};
    lua_pop(L, 1);
    const auto file = machine.sources.texts.find(frame.short_src);
    if (file == machine.sources.texts.end() || frame.currentline < 1) return {};
    std::string_view text = file->second;
    for (int line = 1; !text.empty(); ++line) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        if (line > frame.currentline && makes(text.substr(0, end), name))
            return "; line " + std::to_string(line) +
                   " makes it: put that line before the function or the line that uses it";
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return {};
}

bool has_local(lua_State* L, std::string_view name) {
    lua_Debug frame;
    bool found = false;
    if (!lua_checkstack(L, 4) || lua_getstack(L, 1, &frame) == 0) return false;
    for (int i = 1; const char* each = lua_getlocal(L, &frame, i); ++i) {
        found = found || each == name;
        lua_pop(L, 1);
    }
    return found;
}

}  // namespace fettle::script
