// state("score", 0): a variable of a script that is a property of `game`, so that snapshots, saved
// games, watchers and the inspector include it.

#include <fettle/property/path.h>

#include <library/globals.h>
#include <library/library.h>
#include <lua/environment.h>
#include <lua/exception_guard.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <objects/hints.h>
#include <objects/variable_hints.h>
#include <reference/language.h>
#include <text/words.h>
#include <values/values.h>
#include <writes/writes.h>

namespace fettle::script {

namespace {

/// Throws if a script cannot have a variable of that name in the tree.
void check_variable(lua_State* L, Machine& machine, const std::string& name) {
    const auto refuse = [&](const std::string& why) {
        throw Error(ErrorKind::bad_name, "state: \"" + name + "\" " + why);
    };
    if (!property::is_identifier(name) || name == "_ENV") refuse("is not a name for a variable");
    if (name == "it" || name == "_") refuse("has a meaning of its own in the console");
    if (among(callback_names(), name)) refuse("is the name of a callback");
    const property::Tree& tree = machine.tree;
    if (tree.child(tree.root(), name)) refuse("is a child of game");
    if (tree.find_class(name) != nullptr) refuse("is a class");
    if (tree.class_of(tree.root()).property(name) != nullptr ||
        tree.class_of(tree.root()).method(name) != nullptr || among(generic_names(), name))
        refuse("is part of every game");
    push_registry(L, machine.globals.table);
    push_text(L, name);
    const bool taken = lua_rawget(L, -2) != LUA_TNIL;
    lua_pop(L, 2);
    if (taken && !among(machine.globals.assigned, name)) refuse("is a function of Fettle");
    if (taken) refuse("is a variable already; declare it before it is assigned");
}

int state(lua_State* L) {
    Machine& machine = machine_of(L);
    lua_settop(L, 2);
    const std::string name = check_text(L, 1, "state: needs a name, as in state(\"score\", 0)");
    check_variable(L, machine, name);
    if (lua_isnil(L, 2))
        throw Error(ErrorKind::wrong_type, "state: \"" + name +
                                               "\" needs a value to begin with, as in state(\"" +
                                               name + "\", 0)");
    if (has_local(L, name))
        machine.hints.stated(name, "state(\"" + name +
                                       "\", ...): a local variable of the same "
                                       "name hides it; remove the local one");
    const Handle game = machine.tree.root();
    const Value first = to_value(L, 2, [&] { return "state: " + name; });
    machine.globals.stated[name] = first;
    // After a reload or in a loaded game, the value that is there stays.
    if (machine.tree.find(game, name) == nullptr) {
        machine.tree.set_or_add(game, name, first);
        note_added(machine, game, name);
    } else {
        for (const std::string& problem : stated_problems(machine, name))
            machine.hints.stated(name, problem);
    }
    push_instance(L, game);
    lua_getfield(L, -1, name.c_str());
    return 1;
}

}  // namespace

void open_stated(lua_State* L) {
    add_function<state>(L, "state");
}

std::vector<std::string> stated_problems(const Machine& machine, std::string_view only) {
    std::vector<std::string> problems;
    const property::Tree& tree = machine.tree;
    for (const auto& [name, first] : machine.globals.stated) {
        const property::Property* const of = tree.find(tree.root(), name);
        if (of == nullptr || (!only.empty() && name != only)) continue;
        const Value now = tree.peek(tree.root(), *of);
        const bool numbers = now.is_numeric() && first.is_numeric();
        if (now.type() == first.type() || numbers || now.is_nil() || first.is_nil()) continue;
        const auto described = [&](const Value& value) {
            return tree.text(value) + " (" + std::string(property::type_name(value.type())) + ")";
        };
        problems.push_back("game." + name + " is " + described(now) + " from before, and state(\"" +
                           name + "\", ...) begins it as " + described(first) +
                           " now: the old value stays until the game assigns another one");
    }
    return problems;
}

bool read_stated(lua_State* L, Machine& machine, std::string_view name) {
    if (!machine.globals.stated.contains(name)) return false;
    push_instance(L, machine.tree.root());
    push_text(L, name);
    lua_gettable(L, -2);
    return true;
}

bool write_stated(lua_State* L, Machine& machine, std::string_view name, int value) {
    if (!machine.globals.stated.contains(name)) return false;
    if (lua_isnil(L, value))
        throw Error(ErrorKind::wrong_type,
                    std::string(name) + ": is declared with state(...) and cannot be nil");
    push_instance(L, machine.tree.root());
    push_text(L, name);
    lua_pushvalue(L, value);
    lua_settable(L, -3);
    lua_pop(L, 1);
    return true;
}

}  // namespace fettle::script
