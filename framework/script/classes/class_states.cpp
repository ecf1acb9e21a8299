// States of classes: class("Enemy", Body) { states = { walk = { enter = ..., step = ..., leave =
// ... } } }.
//
// The state is the property `current_state`. A second, hidden property has the state whose `enter`
// was called last, so a state that was assigned (by a script, the console, an undo) is entered at
// the next step, and one that a snapshot restored is not entered again.

#include <algorithm>

#include <fettle/property/last_value.h>
#include <fettle/property/path.h>
#include <fettle/property/spelling.h>

#include <calls/protected.h>
#include <classes/script_classes.h>
#include <limits/limiters.h>
#include <lua/exception_guard.h>
#include <lua/interpreter.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <text/words.h>
#include <values/values.h>

namespace fettle::script {

namespace {

constexpr const char* current_name = "current_state";
constexpr const char* entered_name = "entered_state";
constexpr int most_nested = 40;  // changes of states in `enter` and `leave`; Lua allows some 60
const std::vector<std::string> functions_of_state = {"enter", "leave", "step"};

/// Throws unless the table at the top of the stack describes a state.
void check_state(lua_State* L, const std::string& where) {
    if (!lua_istable(L, -1))
        throw Error(ErrorKind::wrong_type, where +
                                               ": expected a table with enter, step and leave, "
                                               "got " +
                                               describe_type(L, -1));
    const int table = lua_gettop(L);
    for (const std::string& key : sorted_keys(L, table, where)) {
        if (!among(functions_of_state, key))
            throw Error(ErrorKind::unknown_name, where + "." + key +
                                                     ": a state has enter, step and leave" +
                                                     property::suggestion(key, functions_of_state));
        push_text(L, key);
        lua_rawget(L, table);
        if (lua_type(L, -1) != LUA_TFUNCTION)
            throw Error(ErrorKind::wrong_type,
                        where + "." + key + ": expected a function, got " + describe_type(L, -1));
        lua_pop(L, 1);
    }
}

int state_function(lua_State* L) {
    Machine& machine = machine_of(L);
    const Handle self = check_instance(L, 1, "state");
    const Class& of = machine.tree.class_of(self);
    if (!machine.classes.has_states(of))
        throw Error(ErrorKind::bad_structure,
                    machine.tree.path(self) + ": " + of.name() + " declares no states");
    if (lua_gettop(L) > 1) {
        const std::string name = check_text(L, 2, "state: needs the name of a state");
        machine.classes.change_state(L, self, name);
        if (!machine.tree.alive(self)) return 0;  // its functions may have deleted it
    }
    const Value now = last_value(machine.tree, self, current_name);
    push_text(L, now.text());
    return 1;
}

}  // namespace

std::vector<Property> state_properties() {
    return {{.name = current_name,
             .type = Type::text,
             .default_value = "",
             .doc = "The state that it is in; empty: none. A state that is assigned is entered at "
                    "the next step; :state(name) enters it at once."},
            {.name = entered_name,
             .type = Type::text,
             .default_value = "",
             .doc = "The state whose `enter` was called last.",
             .hidden = true}};
}

std::string current_state(const property::Tree& tree, Handle instance) {
    return last_value(tree, instance, current_name).text();
}

bool ScriptClasses::has_states(const Class& of) const {
    if (!any_states_) return false;
    for (const Class* c = &of; c != nullptr; c = c->base())
        if (const auto found = infos_.find(c);
            found != infos_.end() && found->second.states != LUA_NOREF)
            return of.property(entered_name) != nullptr;
    return false;
}

std::vector<std::string> ScriptClasses::states_of(const Class& of) const {
    lua_State* L = machine_.lua.running;
    luaL_checkstack(L, 4, "states");
    std::vector<std::string> names;
    for (const Class* c = &of; c != nullptr; c = c->base()) {
        if (!push_states(L, *c)) continue;
        for (lua_pushnil(L); lua_next(L, -2) != 0; lua_pop(L, 1))
            if (lua_type(L, -2) == LUA_TSTRING) names.push_back(string_at(L, -2));
        lua_pop(L, 1);
    }
    std::ranges::sort(names);
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

void ScriptClasses::set_states(lua_State* L, const Class& of) {
    const std::string where = of.name() + ".states";
    if (of.property(entered_name) == nullptr)
        throw Error(ErrorKind::bad_structure, where +
                                                  ": the class declares no states; write class(\"" +
                                                  of.name() + "\", ...) { states = { ... } }");
    if (!lua_istable(L, -1)) refuse_type(L, -1, where + ": needs a table of states by name");
    const int table = lua_gettop(L);
    for (const std::string& name : sorted_keys(L, table, where)) {
        if (!property::is_identifier(name))
            throw Error(ErrorKind::bad_name,
                        where + ": \"" + name + "\" is not a name for a state");
        push_text(L, name);
        lua_rawget(L, table);
        check_state(L, property::path_suffix(name).insert(0, where));
        lua_pop(L, 1);
    }
    Info& own = info(of);
    luaL_unref(L, LUA_REGISTRYINDEX, own.states);
    own.states = luaL_ref(L, LUA_REGISTRYINDEX);
    any_states_ = true;
    lua_pushcfunction(L, guarded<effect<state_function>>);
    note_name(L, guarded<effect<state_function>>, "state");
    set_function(L, of, "state");
    lua_pop(L, 1);
}

bool ScriptClasses::push_states(lua_State* L, const Class& of) const {
    const auto found = infos_.find(&of);
    if (found == infos_.end() || found->second.states == LUA_NOREF) return false;
    push_registry(L, found->second.states);
    return true;
}

/// Pushes the function of a state from the nearest class that has it. False if there is none.
bool ScriptClasses::push_state_function(lua_State* L, const Class& of, std::string_view state,
                                        const char* name) const {
    for (const Class* c = &of; c != nullptr; c = c->base()) {
        if (!push_states(L, *c)) continue;
        push_text(L, state);
        if (lua_rawget(L, -2) == LUA_TTABLE) {
            lua_pushstring(L, name);
            if (lua_rawget(L, -2) == LUA_TFUNCTION) {
                lua_replace(L, -3);
                lua_pop(L, 1);
                return true;
            }
            lua_pop(L, 1);
        }
        lua_pop(L, 2);
    }
    return false;
}

void ScriptClasses::require_state(const Class& of, const std::string& where,
                                  const std::string& name) const {
    const std::vector<std::string> known = states_of(of);
    if (!name.empty() && !among(known, name))
        throw Error(ErrorKind::unknown_name, where + ": " + of.name() + " has no state \"" + name +
                                                 "\"" + property::suggestion(name, known));
    lua_State* L = machine_.lua.running;
    for (const Class* c = &of; c != nullptr; c = c->base()) {
        if (!push_states(L, *c)) continue;
        push_text(L, name);
        if (lua_rawget(L, -2) != LUA_TNIL)
            check_state(L, c->name() + ".states" + property::path_suffix(name));
        lua_pop(L, 2);
    }
}

void ScriptClasses::require_known_state(Handle self, const Property& property,
                                        const Value& value) const {
    if (!any_states_ || property.name != current_name || !value.is(Type::text)) return;
    const Class& of = machine_.tree.class_of(self);
    if (has_states(of)) require_state(of, machine_.tree.path(self, property), value.text());
}

/// Calls `leave` of the state that was entered, then `enter` of the current one.
void ScriptClasses::enter_state(lua_State* L, Handle self) {
    property::Tree& tree = machine_.tree;
    const Class& of = tree.class_of(self);
    const std::string from = last_value(tree, self, entered_name).text();
    const std::string to = last_value(tree, self, current_name).text();
    if (from == to) return;
    tree.set(self, entered_name, to);
    if (push_state_function(L, of, from, "leave")) {
        push_instance(L, self);
        push_text(L, to);
        lua_call(L, 2, 0);
        // The function may have deleted the instance, or changed the state again.
        if (!tree.alive(self) || last_value(tree, self, entered_name).text() != to) return;
    }
    if (push_state_function(L, of, to, "enter")) {
        push_instance(L, self);
        push_text(L, from);
        lua_call(L, 2, 0);
    }
}

void ScriptClasses::change_state(lua_State* L, Handle self, const std::string& name) {
    struct Nested {
        int& depth;
        explicit Nested(int& d) : depth(d) { ++depth; }
        ~Nested() { --depth; }
    } nested(changing_states_);
    if (changing_states_ > most_nested)
        throw Error(ErrorKind::bad_structure, machine_.tree.path(self) + ": more than " +
                                                  std::to_string(most_nested) +
                                                  " states were entered by each other, the last "
                                                  "is \"" +
                                                  name + "\"");
    require_state(machine_.tree.class_of(self), machine_.tree.path(self), name);
    machine_.tree.set(self, current_name, name);
    enter_state(L, self);
}

/// Enters a state that was assigned. An unknown one is an error, and the state stays.
bool ScriptClasses::enter_assigned_state(Handle self) {
    property::Tree& tree = machine_.tree;
    const Value current = last_value(tree, self, current_name),
                entered = last_value(tree, self, entered_name);
    if (current == entered) return true;
    const Class& of = tree.class_of(self);
    return protected_run(machine_, Context(of.name() + ".states", self), [&](lua_State* L) {
        try {
            require_state(of, tree.path(self, *of.property(current_name)), current.text());
        } catch (const Error&) {
            tree.set(self, current_name, entered);
            throw;
        }
        enter_state(L, self);
    });
}

bool ScriptClasses::step_states(double dt) {
    if (!any_states_) return true;
    property::Tree& tree = machine_.tree;
    std::vector<Handle> stepped;
    for (const Handle member : members_)
        if (tree.alive(member) && has_states(tree.class_of(member))) stepped.push_back(member);
    bool ok = true;
    for (const Handle self : stepped) {
        if (!tree.alive(self) || !tree.is_below(self, tree.root())) continue;
        ok &= enter_assigned_state(self);
        if (machine_.limiters.watchdog.stopped()) return ok;
        if (!tree.alive(self)) continue;
        const Class& of = tree.class_of(self);
        const std::string state = last_value(tree, self, current_name).text();
        if (state.empty()) continue;
        ok &= protected_run(machine_, Context(of.name() + ".states." + state + ".step", self),
                            [&](lua_State* L) {
                                if (!push_state_function(L, of, state, "step")) return;
                                push_instance(L, self);
                                lua_pushnumber(L, dt);
                                lua_call(L, 2, 0);
                            });
        if (machine_.limiters.watchdog.stopped()) return ok;
    }
    return ok;
}

}  // namespace fettle::script
