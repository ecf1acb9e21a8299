#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include <fettle/property/acceptance.h>
#include <fettle/property/pinned.h>
#include <fettle/property/spelling.h>

#include <lua/exception_guard.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <objects/methods.h>
#include <reference/reference_facts.h>
#include <values/members.h>
#include <values/records.h>
#include <values/values.h>
#include <writes/change_notes.h>
#include <writes/declarations.h>

namespace fettle::script {

using property::Method;
using property::Result;

namespace {

constexpr std::size_t max_parameters = 8;

/// Throws for the function at `index`, if the method has a parameter `accept` elsewhere.
void refuse_misplaced_function(int index, const std::string& path, const Method& method) {
    for (std::size_t i = 0; i < method.parameters.size(); ++i)
        if (method.parameters[i].name == property::Acceptance::parameter_name)
            throw Error(ErrorKind::wrong_type,
                        path + ":" + method.name + ": argument " + std::to_string(index - 1) +
                            " is a function; the function is argument " + std::to_string(i + 1) +
                            ", " + method.parameters[i].name + ": " + signature(method));
}

/// True if the only argument is a table of arguments by name, as in sound:play { volume = 0.5 }.
bool are_named(lua_State* L, const Method& method) {
    if (lua_gettop(L) != 2 || !lua_istable(L, 2) || method.parameters.empty()) return false;
    lua_pushnil(L);
    if (lua_next(L, 2) == 0) return method.parameters.front().type != Type::list;
    const bool named = lua_type(L, -2) == LUA_TSTRING;
    lua_pop(L, 2);
    return named;
}

/// Replaces that table by its values, in the order of the parameters.
void put_in_order(lua_State* L, const std::string& path, const Method& method) {
    std::vector<std::string> names;
    for (const property::Field& parameter : method.parameters) names.push_back(parameter.name);
    for (const std::string& key : sorted_keys(L, 2, path + ":" + method.name))
        if (std::ranges::find(names, key) == names.end())
            throw Error(ErrorKind::unknown_name,
                        path + ":" + method.name + ": there is no argument \"" + key + "\"" +
                            property::suggestion(key, names) + ": " + signature(method));
    for (const std::string& name : names) {
        push_text(L, name);
        lua_rawget(L, 2);
    }
    lua_remove(L, 2);
    while (lua_gettop(L) > 1 && lua_isnil(L, -1)) lua_pop(L, 1);
}

/// The arguments of a call.
struct Arguments {
    std::array<Value, max_parameters> values;
    std::size_t count = 0;
    std::optional<property::Acceptance> acceptance{};  // calls the function in place of `accept`

    std::span<const Value> all() const { return {values.data(), count}; }
};

/// Reads the argument at `index` for the parameter `accept`. Returns false if it is nil; throws if
/// it is neither nil nor a function.
bool read_accept(lua_State* L, int index, const Machine& machine, const Method& method,
                 const std::string& path, std::optional<property::Acceptance>& acceptance) {
    if (lua_isnil(L, index)) return false;
    if (lua_type(L, index) != LUA_TFUNCTION)
        throw Error(ErrorKind::wrong_type, path + ":" + method.name +
                                               ": accept: expected a function, got " +
                                               describe_type(L, index) + ": " + signature(method));
    acceptance.emplace(machine.tree, method.name, [L, index](Handle instance) {
        lua_pushvalue(L, index);
        push_instance(L, instance);
        lua_call(L, 1, 1);
        const bool accepted = lua_toboolean(L, -1) != 0;
        lua_pop(L, 1);
        return accepted;
    });
    return true;
}

void read_arguments(lua_State* L, Machine& machine, const Method& method, Handle self,
                    Arguments& arguments) {
    const auto path = [&] { return machine.tree.path(self); };
    if (are_named(L, method)) put_in_order(L, path(), method);
    arguments.count = static_cast<std::size_t>(lua_gettop(L) - 1);
    const std::size_t most = method.parameters.size();
    if (arguments.count > std::min(max_parameters, most)) {
        const bool loose = most > 0 && method.parameters.front().type == Type::vec2 &&
                           lua_type(L, 2) == LUA_TNUMBER && lua_type(L, 3) == LUA_TNUMBER;
        throw Error(ErrorKind::wrong_type,
                    path() + ":" + method.name + ": takes " + std::to_string(most) +
                        (most == 1 ? " argument: " : " arguments: ") + signature(method) +
                        (loose ? " (write vec(x, y))" : ""));
    }
    for (std::size_t i = 0; i < arguments.count; ++i) {
        const int index = static_cast<int>(i) + 2;
        const std::string& parameter = method.parameters[i].name;
        if (parameter == property::Acceptance::parameter_name &&
            read_accept(L, index, machine, method, path(), arguments.acceptance)) {
            arguments.values[i] = true;
            continue;
        }
        if (lua_type(L, index) == LUA_TFUNCTION) refuse_misplaced_function(index, path(), method);
        arguments.values[i] =
            to_value(L, index, [&] { return path() + ":" + method.name + ": " + parameter; });
    }
}

// Upvalue 1: the method.
int call_method(lua_State* L) {
    const auto& method = *static_cast<const Method*>(lua_touserdata(L, lua_upvalueindex(1)));
    Machine& machine = machine_of(L);
    const auto* self = instance_at(L, 1);
    if (!self) refuse_argument(L, 1, method.name, "an instance");
    const Class& of = machine.tree.class_of(self->handle);
    if (of.method(method.symbol) != &method)
        throw Error(ErrorKind::wrong_type, machine.tree.path(self->handle) + ": " +
                                               property::with_article(of.name()) + " has no " +
                                               method.name);
    if (method.effect != property::Effect::nothing && !machine.tree.changeable())
        machine.tree.require_changeable("call " + method.name);
    if (method.effect != property::Effect::nothing) note_change(machine, self->handle, method.name);
    Arguments arguments;
    read_arguments(L, machine, method, self->handle, arguments);
    // During a reload, the existing instances already have the effect of such a call. It is made
    // later, only for new instances, when they have their place.
    if (machine.declarations.reloading() && method.effect != property::Effect::nothing &&
        method.returns.empty()) {
        machine.declarations.calls.push_back(
            {.instance = self->handle,
             .method = &method,
             .arguments = {arguments.all().begin(), arguments.all().end()}});
        return 0;
    }
    const Result result = [&] {
        const property::Pinned pinned(machine.tree, "a method that a script calls");
        return machine.tree.call(self->handle, method, arguments.all());
    }();
    if (arguments.acceptance) arguments.acceptance->finish();
    // The console would print nil for a call that returns nothing.
    const auto* const value = std::get_if<Value>(&result);
    if (method.returns.empty() && value != nullptr && value->is_nil()) return 0;
    push_result(L, result);
    return 1;
}

}  // namespace

int method_reference(lua_State* L, Machine& machine, const Method& method) {
    auto& known = machine.members.methods;
    if (const auto found = known.find(&method); found != known.end()) return found->second;
    lua_pushlightuserdata(L, const_cast<Method*>(&method));
    lua_pushcclosure(L, guarded<call_method>, 1);
    const int reference = luaL_ref(L, LUA_REGISTRYINDEX);
    known.emplace(&method, reference);
    return reference;
}

}  // namespace fettle::script
