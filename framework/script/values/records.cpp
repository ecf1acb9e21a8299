#include <fettle/property/spelling.h>

#include <lua/exception_guard.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <other_languages/synonyms.h>
#include <reference/language.h>
#include <text/words.h>
#include <values/records.h>
#include <values/short_text.h>
#include <values/values.h>

namespace fettle::script {

using property::Record;
using property::Result;

namespace {

/// Names of the fields with a value in the record at 1.
std::vector<std::string> field_names(lua_State* L) {
    std::vector<std::string> names;
    for (lua_pushnil(L); lua_next(L, 1) != 0; lua_pop(L, 1))
        if (lua_type(L, -2) == LUA_TSTRING) names.emplace_back(string_at(L, -2));
    return names;
}

/// `other_alive` is whether the instance in the field `other` is alive; the same for every field
/// with an instance. False, and nothing is pushed, for other names.
bool push_alive(lua_State* L, std::string_view name) {
    constexpr std::string_view ending = "_alive";
    if (!name.ends_with(ending)) return false;
    push_text(L, name.substr(0, name.size() - ending.size()));
    lua_rawget(L, 1);
    const InstanceBox* const box = instance_at(L, -1);
    lua_pop(L, 1);  // the record keeps it
    if (box == nullptr) return false;
    lua_pushboolean(L, machine_of(L).tree.alive(box->handle));
    return true;
}

/// What is said where a name is a property, a method or an event of the instance in the field
/// `instance` of the record at 1; "" if it is not.
std::string hint_at_instance(lua_State* L, const std::string& name) {
    push_text(L, "instance");
    lua_rawget(L, 1);
    const InstanceBox* const box = instance_at(L, -1);
    lua_pop(L, 1);  // the record keeps it
    const property::Tree& tree = machine_of(L).tree;
    if (box == nullptr || !tree.alive(box->handle)) return "";
    const property::Class& of = tree.class_of(box->handle);
    if (of.property(name) == nullptr && of.method(name) == nullptr && !among(generic_names(), name))
        return "";
    return "; this is the record of the event, and its `instance` has " + name;
}

int read_record(lua_State* L) {
    if (lua_type(L, 2) == LUA_TSTRING) {
        const std::vector<std::string> names = field_names(L);
        const std::string name = string_at(L, 2);
        if (push_alive(L, name)) return 1;
        push_registry(L, machine_of(L).boxes.record);
        lua_getfield(L, -1, "nil_fields");
        lua_pushvalue(L, 2);
        if (lua_rawget(L, -2) != LUA_TNIL) {
            lua_pushnil(L);
            return 1;
        }
        const std::string hint = hint_at_instance(L, name);
        throw Error(ErrorKind::unknown_name,
                    name + ": no such field" +
                        (hint.empty() ? hint_at(property_synonyms(name), name, names) : hint));
    }
    lua_pushnil(L);
    return 1;
}

/// A script may add fields to a record, but not one with a name that is almost equal to a field's,
/// nor one that its instance has.
int write_record(lua_State* L) {
    if (lua_type(L, 2) == LUA_TSTRING) {
        const std::string name = string_at(L, 2);
        const std::vector<std::string> names = field_names(L);
        if (const std::string hint = hint_at_instance(L, name); !hint.empty())
            throw Error(ErrorKind::unknown_name, name + ": no such field" + hint);
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
    push_text(L, text);
    return 1;
}

}  // namespace

void seal_record(lua_State* L, Machine& machine) {
    push_registry(L, machine.boxes.record);
    lua_setmetatable(L, -2);
}

bool is_record(lua_State* L, int index) {
    if (lua_type(L, index) != LUA_TTABLE || lua_getmetatable(L, index) == 0) return false;
    push_registry(L, machine_of(L).boxes.record);
    const bool same = lua_rawequal(L, -1, -2) != 0;
    lua_pop(L, 2);
    return same;
}

void push_record(lua_State* L, const Record& record) {
    Machine& machine = machine_of(L);
    luaL_checkstack(L, 8, "record");
    const std::size_t count = record.fields ? record.fields->size() : 0;
    lua_createtable(L, 0, static_cast<int>(count));
    for (std::size_t i = 0; i < count; ++i) {
        const std::string& name = (*record.fields)[i].name;
        push_text(L, name);
        const bool given = i < record.values.size();
        const bool is_empty =
            given && record.values[i].is(Type::reference) && !record.values[i].reference();
        if (!given || is_empty || record.values[i].is_nil()) {
            // Fields in this table read as nil and do not raise an error.
            push_registry(L, machine.boxes.record);
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
    machine.boxes.record = luaL_ref(L, LUA_REGISTRYINDEX);
}

}  // namespace fettle::script
