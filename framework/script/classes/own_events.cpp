#include <utility>

#include <fettle/property/coercion.h>
#include <fettle/property/redefinition.h>
#include <fettle/property/spelling.h>

#include <classes/own_events.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <reference/language.h>
#include <text/words.h>
#include <values/values.h>

namespace fettle::script {

namespace {

using OwnEvent = ScriptClasses::OwnEvent;

constexpr std::size_t max_events = 100;  // of a class
constexpr std::size_t max_fields = 32;   // of an event

std::string named(const OwnEvent& event) {
    return "\"" + event.name + "\"";
}

void check_event_name(const std::string& where, const std::string& name) {
    if (among(generic_names(), name) || name == "created" || name == "deleted" || name == "ready" ||
        name == "step" || name == "draw")
        throw Error(ErrorKind::bad_name, where +
                                             ": every instance has that; an event needs "
                                             "another name");
}

/// The table of fields is at the top of the stack.
std::vector<Property> fields_at_top(lua_State* L, const std::string& where) {
    std::vector<Property> fields;
    for (const std::string& key : sorted_keys(L, lua_gettop(L), where)) {
        if (fields.size() == max_fields)
            throw Error(ErrorKind::rejected,
                        where + ": an event has at most " + std::to_string(max_fields) + " fields");
        if (key == "instance" || key == "step")
            throw Error(ErrorKind::bad_name, where + "." + key + ": every event has that");
        push_text(L, key);
        if (lua_rawget(L, -2) == LUA_TFUNCTION)
            throw Error(ErrorKind::wrong_type,
                        where + "." + key + ": expected a value, got a function");
        fields.push_back(declared_property(L, where, key));
        lua_pop(L, 1);
    }
    return fields;
}

}  // namespace

bool declares_events(lua_State* L, int index) {
    index = lua_absindex(L, index);
    if (!lua_istable(L, index)) return false;
    bool any = false;
    for (lua_pushnil(L); lua_next(L, index) != 0; lua_pop(L, 1)) {
        const bool name = lua_type(L, -2) == LUA_TNUMBER && lua_type(L, -1) == LUA_TSTRING;
        const bool fields = lua_type(L, -2) == LUA_TSTRING && lua_istable(L, -1);
        if (!name && !fields) {
            lua_pop(L, 2);
            return false;
        }
        any = true;
    }
    return any;
}

std::vector<OwnEvent> events_at_top(lua_State* L, const std::string& class_name) {
    const int table = lua_gettop(L);
    std::vector<OwnEvent> events;
    const auto add = [&](std::string name) -> OwnEvent& {
        const std::string where = class_name + ".events: " + name;
        check_event_name(where, name);
        for (const OwnEvent& each : events)
            if (each.name == name) throw Error(ErrorKind::bad_name, where + ": is there twice");
        if (events.size() == max_events)
            throw Error(ErrorKind::rejected, class_name + ".events: a class declares at most " +
                                                 std::to_string(max_events) + " events");
        return events.emplace_back(OwnEvent{std::move(name), {}, {}});
    };
    std::vector<std::string> names;
    for (lua_Integer i = 1; lua_rawgeti(L, table, i) == LUA_TSTRING; ++i) {
        add(string_at(L, -1));
        lua_pop(L, 1);
    }
    lua_pop(L, 1);
    for (lua_pushnil(L); lua_next(L, table) != 0; lua_pop(L, 1))
        if (lua_type(L, -2) == LUA_TSTRING) {
            lua_pushvalue(L, -2);
            names.push_back(string_at(L, -1));
            lua_pop(L, 1);
        }
    std::sort(names.begin(), names.end());
    for (const std::string& name : names) {
        OwnEvent& event = add(name);
        push_text(L, name);
        lua_rawget(L, table);
        event.fields = fields_at_top(L, class_name + ".events." + name);
        lua_pop(L, 1);
    }
    return events;
}

std::string difference(const std::vector<OwnEvent>& first, const std::vector<OwnEvent>& second) {
    const auto missing = [](const std::vector<OwnEvent>& among_these, const OwnEvent& wanted) {
        for (const OwnEvent& each : among_these) {
            if (each.name != wanted.name) continue;
            bool same = each.fields.size() == wanted.fields.size();
            for (std::size_t i = 0; same && i < each.fields.size(); ++i)
                same = each.fields[i].name == wanted.fields[i].name &&
                       each.fields[i].type == wanted.fields[i].type;
            return !same;
        }
        return true;
    };
    for (const OwnEvent& each : second)
        if (missing(first, each)) return "the first has no " + named(each) + " with these fields";
    for (const OwnEvent& each : first)
        if (missing(second, each)) return "the second has no " + named(each) + " with these fields";
    return {};
}

void ScriptClasses::declare_events(const Class& of, std::vector<OwnEvent> events) {
    if (events.empty() && info(of).events.empty()) return;
    std::vector<property::Event> declared;
    for (const OwnEvent& each : events) {
        property::Event& event = declared.emplace_back();
        event.name = each.name;
        event.doc = each.doc;
        for (const Property& field : each.fields)
            event.fields.push_back({.name = field.name,
                                    .type = field.type,
                                    .doc = field.doc,
                                    .reference_class = field.reference_class,
                                    .nullable = field.nullable});
    }
    property::declare_events(machine_.tree, of, std::move(declared));
    info(of).events = std::move(events);
}

const OwnEvent* ScriptClasses::own_event(const property::Event& event) const {
    const auto found = infos_.find(event.owner);
    if (found == infos_.end()) return nullptr;
    for (const OwnEvent& each : found->second.events)
        if (each.name == event.name) return &each;
    return nullptr;
}

namespace {

/// Throws the reason for which the class has no such event to send.
[[noreturn]] void refuse_event(const Machine& machine, const Class& of, const std::string& where,
                               const std::string& name) {
    std::vector<std::string> known;
    for (const property::Event* each : of.events())
        if (machine.classes.own_event(*each) != nullptr) known.push_back(each->name);
    if (of.event(name) != nullptr || name == "deleted" || name == "created")
        throw Error(ErrorKind::rejected, where + ": only the framework sends \"" + name + "\"");
    std::string hint = property::suggestion(name, known);
    if (hint.empty() && !known.empty()) {
        hint = "; it has ";
        for (const std::string& each : known) hint += (&each == known.data() ? "" : ", ") + each;
    } else if (hint.empty()) {
        hint = machine.classes.scripted(of)
                   ? "; declare it in the class: " + of.name() + " = class(\"" + of.name() +
                         "\", " + of.base()->name() + ") { events = { \"" + name + "\" } }"
                   : "; a class of the game declares events: class(\"Foe\", " + of.name() +
                         ") { events = { \"" + name + "\" } }";
    }
    throw Error(ErrorKind::unknown_name,
                where + ": " + of.name() + " declares no event \"" + name + "\"" + hint);
}

/// About the memory that an event takes until it is delivered.
std::int64_t weight_of_event(const std::vector<Value>& values) {
    std::size_t bytes = 200 + values.size() * sizeof(Value);
    for (const Value& value : values) {
        if (value.is(Type::text)) bytes += value.text().size();
        if (value.is(Type::list)) bytes += value.list().size() * sizeof(Value);
    }
    return static_cast<std::int64_t>(bytes);
}

}  // namespace

void ScriptClasses::weigh_sent(const std::vector<Value>& values) {
    property::Tree& tree = machine_.tree;
    if (*sent_ == 0)
        tree.at_barrier([&tree, sent = sent_] { tree.add_weight(-std::exchange(*sent, 0)); });
    const std::int64_t bytes = weight_of_event(values);
    *sent_ += bytes;
    tree.add_weight(bytes);
}

int send_event(lua_State* L) {
    Machine& machine = machine_of(L);
    lua_settop(L, 3);
    const Handle self = check_instance(L, 1, "send");
    const std::string name = check_text(L, 2, "send: needs the name of an event");
    const property::Tree& tree = machine.tree;
    const Class& of = tree.class_of(self);
    const std::string where = tree.path(self) + ":send";
    const property::Event* const event = of.event(name);
    const OwnEvent* const own = event == nullptr ? nullptr : machine.classes.own_event(*event);
    if (own == nullptr) refuse_event(machine, of, where, name);
    if (!lua_isnil(L, 3) && !lua_istable(L, 3))
        throw Error(ErrorKind::wrong_type, where + ": expected a table with the values of \"" +
                                               name + "\", got " + describe_type(L, 3));
    std::vector<std::string> known;
    for (const Property& field : own->fields) known.push_back(field.name);
    if (lua_istable(L, 3))
        for (const std::string& key : sorted_keys(L, 3, where))
            if (!among(known, key))
                throw Error(ErrorKind::unknown_name, where + ": the event \"" + name +
                                                         "\" has no \"" + key + "\"" +
                                                         property::suggestion(key, known));
    std::vector<Value> values;
    for (const Property& field : own->fields) {
        Value value = field.default_value;
        if (lua_istable(L, 3)) {
            std::string path = where + ": " + name + "." + field.name;
            push_text(L, field.name);
            if (lua_rawget(L, 3) != LUA_TNIL)
                value = property::coerced(tree, field, to_value(L, -1, [&] { return path; }), path);
            lua_pop(L, 1);
        }
        values.push_back(std::move(value));
    }
    machine.classes.weigh_sent(values);
    machine.tree.emit(self, *event, std::move(values));
    return 0;
}

}  // namespace fettle::script
