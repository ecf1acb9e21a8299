// Global names: variables of the game, children of the root, and classes. Any other name is an
// error.

#include <algorithm>

#include <fettle/property/spelling.h>

#include <classes/reflection.h>
#include <classes/script_classes.h>
#include <library/globals.h>
#include <library/library.h>
#include <lua/environment.h>
#include <lua/exception_guard.h>
#include <lua/interpreter.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <objects/hints.h>
#include <objects/variable_hints.h>
#include <other_languages/foreign_classes.h>
#include <other_languages/other_languages.h>
#include <reference/language.h>
#include <sandbox/sandbox.h>
#include <sources/sources.h>
#include <text/bare_words.h>
#include <text/words.h>
#include <values/recording.h>
#include <values/values.h>
#include <writes/declarations.h>
#include <writes/writes.h>

namespace fettle::script {

void each_global_name(Machine& machine, const GlobalName& use) {
    const property::Tree& tree = machine.tree;
    use("game", true);
    for (Handle child = tree.first_child(tree.root()); child; child = tree.next_sibling(child))
        use(tree.name(child), true);
    for (const char* name : {"classes", "store"}) use(name, false);
    for (const Class* of : tree.classes()) use(of->name(), false);
    for (const auto& [name, first] : machine.globals.stated) use(name, false);
    lua_State* L = machine.lua.main;
    push_registry(L, machine.globals.table);
    for (lua_pushnil(L); lua_next(L, -2) != 0; lua_pop(L, 1)) {
        std::size_t size = 0;
        if (lua_type(L, -2) != LUA_TSTRING) continue;
        const char* name = lua_tolstring(L, -2, &size);
        use({name, size}, false);
    }
    lua_pop(L, 1);
}

std::vector<std::string> global_names(Machine& machine) {
    std::vector<std::string> names;
    each_global_name(machine, [&](std::string_view name, bool) { names.emplace_back(name); });
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

void push_last_result(lua_State* L, Machine& machine) {
    push_registry(L, machine.globals.last_result);
    lua_rawgeti(L, -1, 1);
    lua_remove(L, -2);
}

bool push_known_global(lua_State* L, Machine& machine, std::string_view name) {
    if (name == "game") {
        push_instance(L, machine.tree.root());
        return true;
    }
    if (name == "store") {
        push_registry(L, machine.globals.store);
        return true;
    }
    if (const Handle child = child_of(machine, machine.tree.root(), name)) {
        push_instance(L, child);
        return true;
    }
    if (const Class* of = machine.tree.find_class(name)) {
        machine.classes.push(L, *of);
        return true;
    }
    if (name == "classes") {
        push_classes(L, machine);
        return true;
    }
    if (name == "it" && machine.tree.alive(machine.globals.it)) {
        push_instance(L, machine.globals.it);
        return true;
    }
    if (name == "_" && machine.recording.active) {
        push_last_result(L, machine);
        return true;
    }
    return false;
}

namespace {

// Suggests the nearest name. Among equally near names, one with the same case of the first letter
// is preferred.
std::string suggest(Machine& machine, std::string_view name) {
    std::vector<std::string> names = global_names(machine);
    const auto capital = [](const std::string& text) {
        return !text.empty() && text[0] >= 'A' && text[0] <= 'Z';
    };
    const bool wanted = capital(std::string(name));
    std::stable_partition(names.begin(), names.end(),
                          [&](const std::string& each) { return capital(each) == wanted; });
    return property::suggestion(name, names);
}

/// What became of a child that game had at first, such as `world`; "" if there was none of that
/// name.
std::string former_child_text(const Machine& machine, std::string_view name) {
    const property::Tree& tree = machine.tree;
    for (const auto& [was, child] : machine.globals.first_children) {
        if (was != name) continue;
        if (tree.alive(child))
            return tree.parent(child) ? "its path is \"" + tree.path(child) + "\" now"
                                      : "it was taken out of the tree";
        const auto remains = tree.deleted_info(child);
        return "it was deleted" +
               (remains ? "; game." + was + " = " + remains->of.name() + " {} makes another one"
                        : "");
    }
    return {};
}

/// A reload runs code such as world:delete() again, when the game has no `world` any more.
Handle stand_in_for_deleted(Machine& machine, std::string_view name) {
    const property::Tree& tree = machine.tree;
    if (!machine.declarations.reloading()) return {};
    for (const auto& [was, child] : machine.globals.first_children)
        if (const auto remains = tree.deleted_info(child);
            was == name && !tree.alive(child) && remains && remains->of.creatable())
            return machine.declarations.stand_in(remains->of, name);
    return {};
}

/// The line of the script that reads a name.
std::string reading_line(lua_State* L) {
    lua_Debug frame;
    if (lua_getstack(L, 1, &frame) == 0) return {};
    lua_getinfo(L, "Sl", &frame);
    return machine_of(L).sources.line(frame.short_src, frame.currentline);
}

/// What a name that nothing has may mean.
std::string hint_for(lua_State* L, Machine& machine, std::string_view name) {
    if (machine.recording.active && machine.sources.commands.was_local(name))
        return "; the local variable ended with its command" +
               hint_to_write(std::string(name) + " = ... without local");
    if (std::string hint = machine.hints.of_command(name);
        !hint.empty() && machine.hints.path_of_instance(name).empty())
        return hint;
    if (std::string hint = hint_of_unfinished_class(machine.classes, name); !hint.empty())
        return hint;
    if (std::string hint = hint_of_self(L, machine, name); !hint.empty()) return hint;
    const std::string line = reading_line(L);
    if (std::string hint = bare_word_hint(machine.tree, line, name); !hint.empty()) return hint;
    if (std::string hint = hint_for_color(line, find_word(line, name)); !hint.empty()) return hint;
    if (std::string hint = hint_of_later_line(L, machine, name); !hint.empty()) return hint;
    if (std::string hint = hint_for_name(name); !hint.empty()) return hint;
    if (std::string hint = hint_for_class(name); !hint.empty()) return hint;
    // At the console, where people write what they see on the screen.
    if (machine.recording.active)
        for (const std::string& path :
             {machine.hints.path_of_instance(name), machine.hints.path_of_member(name)})
            if (!path.empty()) return " (did you mean \"" + path + "\"?)";
    // counter = counter or 0
    const std::string word(name);
    if (line.find(word + " or ") != std::string::npos)
        return hint_to_write("rawget(_G, \"" + word + "\") for a name that may be missing");
    return suggest(machine, name);
}

int read_global(lua_State* L) {
    Machine& machine = machine_of(L);
    if (lua_type(L, 2) != LUA_TSTRING) {
        lua_pushnil(L);
        return 1;
    }
    const std::string_view name = view_at(L, 2);
    if (push_known_global(L, machine, name)) return 1;
    if (read_stated(L, machine, name)) return 1;
    push_registry(L, machine.globals.declared);
    lua_pushvalue(L, 2);
    if (lua_rawget(L, -2) != LUA_TNIL) {
        lua_pushnil(L);
        return 1;
    }
    if (name == "it") throw Error(ErrorKind::unknown_name, "it: nothing is selected");
    // A missing callback is nil and not an error, because a game may test for it.
    if (among(callback_names(), name)) {
        if (machine.recording.active) machine.recording.missing = name;
        lua_pushnil(L);
        return 1;
    }
    if (const Handle stand_in = stand_in_for_deleted(machine, name)) {
        push_instance(L, stand_in);
        return 1;
    }
    const std::string former = former_child_text(machine, name);
    throw Error(ErrorKind::unknown_name,
                std::string(name) + ": no such name" +
                    (former.empty() ? hint_for(L, machine, name) : " any more: " + former));
}

// Names that a game cannot give another meaning.
void refuse_fixed(const Machine& machine, std::string_view name) {
    const auto refuse = [&](const std::string& why) {
        throw Error(ErrorKind::bad_name, std::string(name) + ": " + why);
    };
    if (name == "game") refuse("is part of the tree; it cannot be replaced");
    if (name == "store")
        refuse(
            "contains what outlives the run; assign its values (store.best = 10), empty it with "
            "store:clear(), or use another name");
    const Handle child = machine.tree.child(machine.tree.root(), name);
    if (!child) return;
    const Class& of = machine.tree.class_of(child);
    if (!of.creatable())
        refuse("is the " + of.name() +
               " of the framework and cannot be replaced; use another name");
    refuse("game has a child of this name, which is a global; assign game." + std::string(name) +
           " to replace it, or use another name");
}

int write_global(lua_State* L) {
    Machine& machine = machine_of(L);
    if (lua_type(L, 2) == LUA_TSTRING) {
        const std::string_view name = view_at(L, 2);
        refuse_fixed(machine, name);
        if (machine.recording.active && name == "it") return assign_it(L, 3), 0;
        if (machine.recording.active && name == "_") return 0;  // `_, y = f()` drops a result
        if (write_stated(L, machine, name, 3)) return 0;
        // Fettle would never call a function with a misspelled name such as `keypressed`.
        if (lua_type(L, 3) == LUA_TFUNCTION && name.size() >= 8) {
            if (!among(callback_names(), name))
                for (const std::string& callback : callback_names())
                    if (property::near_miss(name, callback))
                        throw Error(ErrorKind::near_miss,
                                    std::string(name) + ": would never be called (did you mean \"" +
                                        callback + "\"?)");
        }
        push_registry(L, machine.globals.declared);
        lua_pushvalue(L, 2);
        if (lua_rawget(L, 4) == LUA_TNIL) {
            machine.globals.assigned.emplace_back(name);
            if (const std::string hint = hint_of_self(L, machine, name, true); !hint.empty())
                machine.hints.variable_hides_property(name, hint);
            else if (const int of = lua_type(L, 3); of == LUA_TNUMBER || of == LUA_TSTRING)
                machine.hints.variable_added(name, to_value(L, 3));
            // gravity = 0: nothing that is seen changes.
            if (machine.hints.begins_command(name))
                if (const std::string path = machine.hints.path_of_member(name);
                    !path.empty() && !path.ends_with(')'))
                    print_line(machine, std::string(name) + " is a new variable (did you mean " +
                                            path + "?)");
        }
        lua_pushvalue(L, 2);
        lua_pushboolean(L, 1);
        lua_rawset(L, 4);
        lua_settop(L, 3);
    }
    lua_rawset(L, 1);
    return 0;
}

}  // namespace

void open_globals(lua_State* L, Machine& machine) {
    lua_newtable(L);
    machine.globals.declared = luaL_ref(L, LUA_REGISTRYINDEX);
    lua_newtable(L);
    add_pure<read_global>(L, "__index");
    add_pure<write_global>(L, "__newindex");
    name_metatable(L, "globals");
    lua_setmetatable(L, -2);
    lua_pushvalue(L, -1);
    machine.globals.table = luaL_ref(L, LUA_REGISTRYINDEX);
}

}  // namespace fettle::script
