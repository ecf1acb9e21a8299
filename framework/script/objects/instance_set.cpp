#include <string>

#include <fettle/property/condition.h>
#include <fettle/property/path.h>
#include <fettle/property/spelling.h>

#include <classes/script_classes.h>
#include <limits/limiters.h>
#include <lua/exception_guard.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <objects/generic_methods.h>
#include <objects/instance_set.h>
#include <text/words.h>
#include <values/short_text.h>
#include <values/values.h>
#include <writes/declarations.h>
#include <writes/writes.h>

namespace fettle::script {

void push_set(lua_State* L, const std::vector<Handle>& instances) {
    luaL_checkstack(L, 4, "set");
    lua_createtable(L, static_cast<int>(instances.size()), 0);
    lua_Integer n = 0;
    for (const Handle handle : instances) {
        push_instance(L, handle);
        lua_rawseti(L, -2, ++n);
    }
    push_registry(L, machine_of(L).boxes.set);
    lua_setmetatable(L, -2);
}

bool is_set(lua_State* L, int index) {
    if (lua_type(L, index) != LUA_TTABLE || !lua_getmetatable(L, index)) return false;
    push_registry(L, machine_of(L).boxes.set);
    const bool same = lua_rawequal(L, -1, -2) != 0;
    lua_pop(L, 2);
    return same;
}

namespace {

std::vector<Handle> members(lua_State* L, const char* what) {
    if (!is_set(L, 1)) refuse_argument(L, 1, what, "a set");
    std::vector<Handle> handles;
    const auto length = static_cast<lua_Integer>(lua_rawlen(L, 1));
    handles.reserve(static_cast<std::size_t>(length));
    for (lua_Integer i = 1; i <= length; ++i) {
        lua_rawgeti(L, 1, i);
        handles.push_back(check_instance(L, -1, what));
        lua_pop(L, 1);
    }
    machine_of(L).limiters.budget.charge(L, static_cast<std::uint64_t>(length));
    return handles;
}

std::string property_name(lua_State* L, const char* what) {
    return check_text(L, 2, std::string(what) + ": needs the name of a property");
}

int set_all(lua_State* L) {
    Machine& machine = machine_of(L);
    const std::vector<Handle> all = members(L, "set");
    const std::string name = property_name(L, "set");
    const Value value = to_value(L, 3);
    for (const Handle handle : all) {
        const Property& property = machine.tree.property(handle, name);
        if (machine.declarations.defers(handle)) continue;
        if (value.is_nil())
            clear_property(machine, handle, property);
        else
            write_property(machine, handle, property, value);
    }
    lua_settop(L, 1);
    return 1;
}

Value sum(const Value& a, const Value& b, const std::string& where) {
    if (a.is(Type::integer) && b.is(Type::integer)) {
        std::int64_t result = 0;
        if (!__builtin_add_overflow(a.integer(), b.integer(), &result)) return result;
        throw Error(ErrorKind::out_of_range, where + ": the sum is beyond 64 bits");
    }
    if (a.is_numeric() && b.is_numeric()) return a.as_double() + b.as_double();
    if (a.is(Type::vec2) && b.is(Type::vec2)) return Vec2(a.vec2() + b.vec2());
    throw Error(ErrorKind::wrong_type,
                where + ": " + property::with_article(property::type_name(b.type())) +
                    " cannot be added to " + property::with_article(property::type_name(a.type())));
}

int add_all(lua_State* L) {
    Machine& machine = machine_of(L);
    const std::vector<Handle> all = members(L, "add");
    const std::string name = property_name(L, "add");
    const Value value = to_value(L, 3);
    for (const Handle handle : all) {
        const Property& property = machine.tree.property(handle, name);
        if (machine.declarations.defers(handle)) continue;
        write_property(
            machine, handle, property,
            sum(machine.tree.get(handle, property), value, machine.tree.path(handle, property)));
    }
    lua_settop(L, 1);
    return 1;
}

int each_of(lua_State* L) {
    Machine& machine = machine_of(L);
    lua_settop(L, 2);
    const std::vector<Handle> all = members(L, "each");
    check_function(L, 2, "each");
    for (const Handle handle : all) {
        if (!machine.tree.alive(handle)) continue;
        lua_pushvalue(L, 2);
        push_instance(L, handle);
        lua_call(L, 1, 0);
    }
    lua_settop(L, 1);
    return 1;
}

int delete_all(lua_State* L) {
    Machine& machine = machine_of(L);
    if (!is_set(L, 1)) refuse_argument(L, 1, "delete", "a set");
    std::vector<Handle> handles;
    const auto length = static_cast<lua_Integer>(lua_rawlen(L, 1));
    for (lua_Integer i = 1; i <= length; ++i) {
        lua_rawgeti(L, 1, i);
        if (const auto* box = instance_at(L, -1)) handles.push_back(box->handle);
        lua_pop(L, 1);
    }
    // An instance may be gone already, because its parent was deleted first.
    for (const Handle handle : handles)
        if (machine.tree.alive(handle)) destroy(machine, handle);
    return 0;
}

/// What is written for the name at 2 that the instances of the set have and the set has not; "" if
/// they do not have it either.
std::string way_for_each(lua_State* L, Machine& machine, const std::string& name) {
    lua_rawgeti(L, 1, 1);
    const auto* const box = instance_at(L, -1);
    const Handle first = box != nullptr ? box->handle : Handle{};
    lua_pop(L, 1);
    if (!machine.tree.alive(first)) return {};
    const Class& of = machine.tree.class_of(first);
    if (of.method(name) != nullptr || generic_reference(L, machine, name) != LUA_NOREF ||
        machine.classes.has_function(of, name))
        return ":each(function(one) one:" + name + "(...) end) for all of them";
    if (machine.tree.find(first, name) != nullptr)
        return "one." + name + " in a loop: for _, one in ipairs(set) do ... end";
    return {};
}

int set_index(lua_State* L) {
    if (lua_type(L, 2) != LUA_TSTRING) {
        lua_pushnil(L);  // no more elements
        return 1;
    }
    Machine& machine = machine_of(L);
    luaL_getmetafield(L, 1, "methods");
    lua_pushvalue(L, 2);
    if (lua_rawget(L, -2) != LUA_TNIL) return 1;
    lua_pop(L, 2);
    const std::string name = key_in_message(L, 2);
    if (const std::string way = way_for_each(L, machine, name); !way.empty())
        throw Error(ErrorKind::unknown_name,
                    "a set of instances has no " + name + hint_to_write(way));
    try {
        return push_method(L, "a set of instances");
    } catch (const Error& error) {
        const std::string_view reason = error.what();
        if (reason.find("did you mean") != std::string_view::npos) throw;
        throw Error(error.kind(),
                    std::string(reason) + "; it has add, delete, each and set, and ipairs");
    }
}

/// A name would be written into the list, and reach no instance.
int set_newindex(lua_State* L) {
    if (lua_type(L, 2) == LUA_TSTRING) {
        const std::string name = key_in_message(L, 2);
        throw Error(ErrorKind::unknown_name,
                    "a set of instances has no " + name +
                        hint_to_write(":set(\"" + name + "\", value) for all of them"));
    }
    lua_rawset(L, 1);
    return 0;
}

/// Whether the text is the name of a class, and not of something at the top of the tree.
bool is_class(const property::Tree& tree, std::string_view text) {
    return tree.find_class(text) != nullptr && !tree.child(tree.root(), text);
}

int query(lua_State* L) {
    if (lua_type(L, 1) != LUA_TSTRING)
        refuse_type(L, 1, "query: needs a pattern such as \"world.*.mass\"");
    Machine& machine = machine_of(L);
    if (property::Condition::is_meant(string_at(L, 1)) || is_class(machine.tree, string_at(L, 1))) {
        push_set(L, instances_matching(L, string_at(L, 1)));
        return 1;
    }
    const property::Pattern pattern(string_at(L, 1));
    std::vector<Handle> instances;
    std::vector<std::pair<Handle, const Property*>> properties;
    machine.tree.each_below(machine.tree.root(), [&](Handle handle) {
        if (pattern.matches(machine.tree, handle)) instances.push_back(handle);
        for (const Property* property : machine.tree.properties(handle))
            if (pattern.may_match(property->symbol) &&
                pattern.matches(machine.tree, handle, *property))
                properties.emplace_back(handle, property);
    });
    machine.limiters.budget.charge(L, machine.tree.size() + properties.size());
    if (properties.empty()) {
        if (instances.empty() && machine.recording.active)
            machine.recording.nothing = pattern.text();
        push_set(L, instances);
        return 1;
    }
    // The table has values by path; `pairs` visits them in order.
    lua_createtable(L, 0, static_cast<int>(properties.size()));
    for (const auto& [handle, property] : properties) {
        if (const auto* formula = machine.tree.formula(handle, *property);
            formula != nullptr && !machine.tree.problem(handle, *property).empty())
            continue;
        const std::string path = machine.tree.path(handle, *property);
        push_text(L, path);
        push_value(L, machine.tree.get(handle, *property));
        lua_rawset(L, -3);
    }
    return 1;
}

}  // namespace

std::vector<Handle> instances_matching(lua_State* L, const std::string& text) {
    Machine& machine = machine_of(L);
    property::Condition condition(text);
    std::vector<Handle> found;
    machine.tree.each_below(machine.tree.root(), [&](Handle handle) {
        if (condition.holds(machine.tree, handle)) found.push_back(handle);
    });
    machine.limiters.budget.charge(L, machine.tree.size() * (1 + condition.weight()));
    if (const std::string problem = condition.problem(machine.tree); !problem.empty())
        throw Error(ErrorKind::unknown_name, "\"" + text + "\": " + problem);
    return found;
}

namespace {

int set_tostring(lua_State* L) {
    if (!is_set(L, 1)) refuse_type(L, 1, "tostring: needs a set");
    push_text(L, short_text(L, 1));
    return 1;
}

}  // namespace

void open_sets(lua_State* L, Machine& machine) {
    lua_newtable(L);
    add_pure<set_index>(L, "__index");
    add_pure<set_newindex>(L, "__newindex");
    add_pure<set_tostring>(L, "__tostring");
    lua_newtable(L);
    add_function<set_all>(L, "set");
    add_function<add_all>(L, "add");
    add_pure<each_of>(L, "each");
    add_function<delete_all>(L, "delete");
    lua_setfield(L, -2, "methods");
    name_metatable(L, "instances");
    machine.boxes.set = luaL_ref(L, LUA_REGISTRYINDEX);
}

void open_query(lua_State* L) {
    add_pure<query>(L, "query");
}

}  // namespace fettle::script
