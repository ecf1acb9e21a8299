#include "methods.h"

#include <array>
#include <optional>
#include <unordered_map>

#include <fettle/property/acceptance.h>
#include <fettle/property/error.h>
#include <fettle/property/spelling.h>

#include "format.h"
#include "guard.h"
#include "machine.h"

namespace fettle::script {

using property::Error;
using property::ErrorKind;
using property::Method;
using property::Record;
using property::Result;
using property::Value;

std::string signature(const Method& method) {
    std::string text = method.name + "(";
    for (std::size_t i = 0; i < method.parameters.size(); ++i) {
        const bool optional = i >= method.required;
        if (optional)
            text += i ? " [, " : "[";
        else if (i)
            text += ", ";
        text += method.parameters[i].name;
        if (optional) text += "]";
    }
    return text + ")";
}

namespace {

constexpr std::size_t most_parameters = 8;

/// A function is meant for `accept`, wherever it stands.
void check_no_function(lua_State* L, int index, const std::string& path, const Method& method) {
    if (lua_type(L, index) != LUA_TFUNCTION) return;
    for (std::size_t i = 0; i < method.parameters.size(); ++i)
        if (method.parameters[i].name == property::Acceptance::parameter)
            throw Error(ErrorKind::wrong_type,
                        path + ":" + method.name + ": argument " + std::to_string(index - 1) +
                            " is a function; the function is argument " + std::to_string(i + 1) +
                            ", " + method.parameters[i].name + ": " + signature(method));
}

// Upvalue 1: the method.
int call_method(lua_State* L) {
    const auto& method = *static_cast<const Method*>(lua_touserdata(L, lua_upvalueindex(1)));
    Machine& machine = machine_of(L);
    const auto* self = instance_at(L, 1);
    if (!self)
        throw Error(ErrorKind::wrong_type,
                    method.name + ": call it with a colon, as in ball:" + method.name + "(...)");
    const property::Class& of = machine.tree.class_of(self->handle);
    if (of.method(method.symbol) != &method)
        throw Error(ErrorKind::wrong_type, machine.tree.path(self->handle) + ": a " + of.name() +
                                               " has no " + method.name);
    if (method.effect != property::Effect::nothing && !machine.tree.changeable())
        machine.tree.require_changeable("call " + method.name);
    std::array<Value, most_parameters> values;
    const int given = lua_gettop(L) - 1;
    if (given > static_cast<int>(std::min(most_parameters, method.parameters.size())))
        throw Error(ErrorKind::wrong_type, machine.tree.path(self->handle) + ":" + method.name +
                                               ": takes " +
                                               std::to_string(method.parameters.size()) +
                                               " arguments: " + signature(method));
    std::optional<property::Acceptance> acceptance;
    for (int i = 0; i < given; ++i) {
        const int index = i + 2;
        const bool accepts =
            method.parameters[static_cast<std::size_t>(i)].name == property::Acceptance::parameter;
        if (accepts && !lua_isnil(L, index) && lua_type(L, index) != LUA_TFUNCTION)
            throw Error(ErrorKind::wrong_type, machine.tree.path(self->handle) + ":" + method.name +
                                                   ": accept: expected a function, got " +
                                                   describe_type(L, index) + ": " +
                                                   signature(method));
        if (accepts && lua_type(L, index) == LUA_TFUNCTION) {
            values[static_cast<std::size_t>(i)] = true;
            acceptance.emplace(machine.tree, method.name, [L, index](property::Handle instance) {
                lua_pushvalue(L, index);
                push_instance(L, instance);
                lua_call(L, 1, 1);
                const bool accepted = lua_toboolean(L, -1) != 0;
                lua_pop(L, 1);
                return accepted;
            });
            continue;
        }
        check_no_function(L, index, machine.tree.path(self->handle), method);
        try {
            values[static_cast<std::size_t>(i)] = to_value(L, i + 2);
        } catch (const Error& error) {
            throw Error(error.kind(), machine.tree.path(self->handle) + ":" + method.name + ": " +
                                          method.parameters[static_cast<std::size_t>(i)].name +
                                          ": " + error.what());
        }
    }
    const Result result = machine.tree.call(
        self->handle, method, std::span(values.data(), static_cast<std::size_t>(given)));
    if (acceptance) acceptance->finish();
    push_result(L, result);
    return 1;
}

/// Of the fields of the record at 1 that have a value.
std::vector<std::string> field_names(lua_State* L) {
    std::vector<std::string> names;
    for (lua_pushnil(L); lua_next(L, 1) != 0; lua_pop(L, 1))
        if (lua_type(L, -2) == LUA_TSTRING) names.emplace_back(string_at(L, -2));
    return names;
}

int read_record(lua_State* L) {
    if (lua_type(L, 2) == LUA_TSTRING) {
        const std::vector<std::string> names = field_names(L);
        const std::string name = string_at(L, 2);
        push_registry(L, machine_of(L).record_meta);
        lua_getfield(L, -1, "nil_fields");
        lua_pushvalue(L, 2);
        if (lua_rawget(L, -2) != LUA_TNIL) {
            lua_pushnil(L);
            return 1;
        }
        throw Error(ErrorKind::unknown_name,
                    name + ": no such field" + property::suggestion(name, names));
    }
    lua_pushnil(L);
    return 1;
}

/// A field that the record does not have is a note of the script's own, but for a slip of the pen.
int write_record(lua_State* L) {
    if (lua_type(L, 2) == LUA_TSTRING) {
        const std::string name = string_at(L, 2);
        const std::vector<std::string> names = field_names(L);
        for (const std::string& field : names)
            if (property::near_miss(name, field))
                throw Error(ErrorKind::near_miss,
                            name + ": no such field" + property::suggestion(name, names));
    }
    lua_rawset(L, 1);
    return 0;
}

int record_text(lua_State* L) {
    const std::string text = short_text(L, 1);
    lua_pushlstring(L, text.data(), text.size());
    return 1;
}

std::unordered_map<const Method*, int>& references(lua_State* L) {
    return machine_of(L).method_references;
}

}  // namespace

int method_reference(lua_State* L, Machine& machine, const Method& method) {
    auto& known = machine.method_references;
    if (const auto found = known.find(&method); found != known.end()) return found->second;
    lua_pushlightuserdata(L, const_cast<Method*>(&method));
    lua_pushcclosure(L, guarded<call_method>, 1);
    const int reference = luaL_ref(L, LUA_REGISTRYINDEX);
    known.emplace(&method, reference);
    return reference;
}

const Method* method_of(lua_State* L, int index) {
    if (lua_tocfunction(L, index) != static_cast<lua_CFunction>(guarded<call_method>))
        return nullptr;
    index = lua_absindex(L, index);
    for (const auto& [method, reference] : references(L)) {
        push_registry(L, reference);
        const bool same = lua_rawequal(L, -1, index) != 0;
        lua_pop(L, 1);
        if (same) return method;
    }
    return nullptr;
}

void seal_record(lua_State* L, Machine& machine) {
    push_registry(L, machine.record_meta);
    lua_setmetatable(L, -2);
}

void push_record(lua_State* L, const Record& record) {
    Machine& machine = machine_of(L);
    luaL_checkstack(L, 8, "record");
    const std::size_t count = record.fields ? record.fields->size() : 0;
    lua_createtable(L, 0, static_cast<int>(count));
    for (std::size_t i = 0; i < count; ++i) {
        const std::string& name = (*record.fields)[i].name;
        lua_pushlstring(L, name.data(), name.size());
        const bool given = i < record.values.size();
        const bool nobody = given && record.values[i].is(property::Type::reference) &&
                            !record.values[i].reference();
        if (!given || nobody || record.values[i].is_nil()) {
            // A field without a value reads as nil, without an error.
            push_registry(L, machine.record_meta);
            lua_getfield(L, -1, "nil_fields");
            lua_pushvalue(L, -3);
            lua_pushboolean(L, 1);
            lua_rawset(L, -3);
            lua_pop(L, 3);
            continue;
        }
        push_value(L, record.values[i]);
        lua_rawset(L, -3);
    }
    seal_record(L, machine);
}

void push_result(lua_State* L, const Result& result) {
    if (const auto* value = std::get_if<Value>(&result)) {
        push_value(L, *value);
    } else if (const auto* record = std::get_if<Record>(&result)) {
        if (record->fields)
            push_record(L, *record);
        else
            lua_pushnil(L);
    } else {
        const auto& records = std::get<std::vector<Record>>(result);
        luaL_checkstack(L, 4, "records");
        lua_createtable(L, static_cast<int>(records.size()), 0);
        lua_Integer n = 0;
        for (const Record& each : records) {
            push_record(L, each);
            lua_rawseti(L, -2, ++n);
        }
    }
}

void open_records(lua_State* L, Machine& machine) {
    lua_newtable(L);
    add_pure<read_record>(L, "__index");
    add_pure<write_record>(L, "__newindex");
    add_pure<record_text>(L, "__tostring");
    lua_newtable(L);
    lua_setfield(L, -2, "nil_fields");
    name_metatable(L, "record");
    machine.record_meta = luaL_ref(L, LUA_REGISTRYINDEX);
}

}  // namespace fettle::script
