#include <fettle/property/spelling.h>

#include <classes/reflection.h>
#include <classes/script_classes.h>
#include <limits/limiters.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <reference/reference_facts.h>
#include <values/description.h>
#include <values/values.h>

namespace fettle::script {

using property::Field;

namespace {

const DescriptionKind property_kind{
    "a description of a property",
    {"name", "type", "unit", "doc", "default", "min", "max", "clamp", "inf", "enumerators",
     "read_only", "transient", "simulated", "nullable", "owner", "element", "class",
     "derives_from"}};
const DescriptionKind field_kind{
    "a description of a field",
    {"name", "type", "unit", "doc", "element", "class", "nullable", "optional"}};
const DescriptionKind method_kind{
    "a description of a method",
    {"name", "doc", "signature", "parameters", "returns", "many", "pure", "owner"}};
const DescriptionKind event_kind{"a description of an event", {"name", "doc", "fields", "owner"}};

// --- Fields of the table at the top of the stack

void put_class(lua_State* L, Machine& machine, const char* field, const Class* of) {
    if (of == nullptr) return;
    machine.classes.push(L, *of);
    lua_setfield(L, -2, field);
}

void put_words(lua_State* L, Machine& machine, const char* field,
               const std::vector<std::string>& words) {
    lua_createtable(L, static_cast<int>(words.size()), 0);
    lua_Integer n = 0;
    for (const std::string& word : words) {
        push_text(L, word);
        lua_rawseti(L, -2, ++n);
    }
    seal_list(L, machine);
    lua_setfield(L, -2, field);
}

// Pushes a list with the result of `push` for each element, by number and by name.
template <class Elements, class Push>
void push_list(lua_State* L, Machine& machine, const Elements& elements, Push push) {
    luaL_checkstack(L, 8, "descriptions");
    lua_createtable(L, static_cast<int>(elements.size()), static_cast<int>(elements.size()));
    lua_Integer n = 0;
    for (const auto& each : elements) {
        const std::string& name = push(each);
        lua_pushvalue(L, -1);
        lua_rawseti(L, -3, ++n);
        lua_setfield(L, -2, name.c_str());
    }
    machine.limiters.budget.charge(L, 100 * elements.size());
    seal_list(L, machine);
}

// --- Descriptions

// Adds the facts on a type that properties, parameters and results have in common.
template <class Described>
void put_type(lua_State* L, Machine& machine, const Described& described) {
    put(L, "name", described.name);
    put(L, "unit", described.unit);
    put(L, "doc", described.doc);
    put(L, "nullable", described.nullable);
    if (described.element != Type::nil) put(L, "element", property::type_name(described.element));
    if (!described.reference_class.empty())
        put_class(L, machine, "class", machine.tree.find_class(described.reference_class));
}

const std::string& push_property(lua_State* L, Machine& machine, const Property& property) {
    lua_createtable(L, 0, 16);
    put_type(L, machine, property);
    put(L, "type", property.any_type ? "any" : property::type_name(property.type));
    put(L, "clamp", property.clamp);
    put(L, "inf", property.infinity);
    put(L, "read_only", property.read_only);
    put(L, "transient", property.transient);
    put(L, "simulated", property.simulated);
    put_class(L, machine, "owner", property.owner);
    put_words(L, machine, "enumerators", property.enumerators);
    put_words(L, machine, "derives_from", property.derives_from);
    if (!is_computed(property) && !property.default_value.is_nil()) {
        push_value(L, property.default_value);
        lua_setfield(L, -2, "default");
    }
    if (has_range(property)) {
        lua_pushnumber(L, property.range.min);
        lua_setfield(L, -2, "min");
        lua_pushnumber(L, property.range.max);
        lua_setfield(L, -2, "max");
    }
    seal_description(L, machine, property_kind);
    return property.name;
}

void put_fields(lua_State* L, Machine& machine, const char* name, const std::vector<Field>& fields,
                std::size_t required) {
    std::size_t n = 0;
    push_list(L, machine, fields, [&](const Field& field) -> const std::string& {
        lua_createtable(L, 0, 8);
        put_type(L, machine, field);
        put(L, "type", property::type_name(field.type));
        put(L, "optional", n++ >= required);
        seal_description(L, machine, field_kind);
        return field.name;
    });
    lua_setfield(L, -2, name);
}

const std::string& push_method(lua_State* L, Machine& machine, const property::Method& method) {
    lua_createtable(L, 0, 8);
    put(L, "name", method.name);
    put(L, "doc", method.doc);
    put(L, "signature", signature(method));
    put(L, "many", method.many);
    put_class(L, machine, "owner", method.owner);
    put(L, "pure", method.effect == property::Effect::nothing);
    put_fields(L, machine, "parameters", method.parameters, method.required);
    put_fields(L, machine, "returns", method.returns, method.returns.size());
    seal_description(L, machine, method_kind);
    return method.name;
}

const std::string& push_event(lua_State* L, Machine& machine, const property::Event& event) {
    lua_createtable(L, 0, 4);
    put(L, "name", event.name);
    put(L, "doc", event.doc);
    put_class(L, machine, "owner", event.owner);
    put_fields(L, machine, "fields", event.fields, event.fields.size());
    seal_description(L, machine, event_kind);
    return event.name;
}

const std::string& push_class(lua_State* L, Machine& machine, const Class& of) {
    machine.classes.push(L, of);
    return of.name();
}

std::vector<const Property*> shown(std::vector<const Property*> properties) {
    std::erase_if(properties, [](const Property* property) { return property->hidden; });
    return properties;
}

void push_properties(lua_State* L, Machine& machine, std::vector<const Property*> properties) {
    push_list(L, machine, shown(std::move(properties)),
              [&](const Property* each) -> const std::string& {
                  return push_property(L, machine, *each);
              });
}

void push_derived(lua_State* L, Machine& machine, const Class& of) {
    std::vector<const Class*> derived = machine.tree.classes();
    std::erase_if(derived, [&](const Class* each) { return each->base() != &of; });
    push_list(L, machine, derived, [&](const Class* each) -> const std::string& {
        return push_class(L, machine, *each);
    });
}

}  // namespace

void push_classes(lua_State* L, Machine& machine) {
    push_list(L, machine, machine.tree.classes(), [&](const Class* each) -> const std::string& {
        return push_class(L, machine, *each);
    });
}

const std::vector<std::string>& class_fields() {
    static const std::vector<std::string> names = {"base",       "creatable", "derived", "doc",
                                                   "events",     "methods",   "name",    "on",
                                                   "properties", "watch"};
    return names;
}

bool push_class_field(lua_State* L, Machine& machine, const Class& of, std::string_view name) {
    if (name == "name") {
        lua_pushstring(L, of.name().c_str());
    } else if (name == "doc") {
        lua_pushstring(L, of.doc().c_str());
    } else if (name == "base") {
        if (of.base())
            machine.classes.push(L, *of.base());
        else
            lua_pushnil(L);
    } else if (name == "creatable") {
        lua_pushboolean(L, of.creatable() ? 1 : 0);
    } else if (name == "derived") {
        push_derived(L, machine, of);
    } else if (name == "properties") {
        push_properties(L, machine, of.properties());
    } else if (name == "methods") {
        push_list(L, machine, of.methods(),
                  [&](const property::Method* each) -> const std::string& {
                      return push_method(L, machine, *each);
                  });
    } else if (name == "events") {
        push_list(L, machine, of.events(), [&](const property::Event* each) -> const std::string& {
            return push_event(L, machine, *each);
        });
    } else {
        return false;
    }
    return true;
}

int describe_instance(lua_State* L) {
    const Handle self = check_instance(L, 1, "describe");
    Machine& machine = machine_of(L);
    if (lua_isnoneornil(L, 2)) {
        push_properties(L, machine, machine.tree.properties(self));
        return 1;
    }
    const std::string name =
        check_text(L, 2, "describe: needs the name of a property, method or event");
    const Class& of = machine.tree.class_of(self);
    if (const Property* property = machine.tree.find(self, name)) {
        push_property(L, machine, *property);
    } else if (const property::Method* method = of.method(name)) {
        push_method(L, machine, *method);
    } else if (const property::Event* event = of.event(name)) {
        push_event(L, machine, *event);
    } else {
        std::vector<std::string> names = of.member_names();
        for (const Property* added : machine.tree.ad_hoc(self)) names.push_back(added->name);
        for (const property::Event* each : of.events()) names.push_back(each->name);
        throw Error(ErrorKind::unknown_name, machine.tree.path(self) +
                                                 ": no property, method or event is called \"" +
                                                 name + "\"" + property::suggestion(name, names));
    }
    return 1;
}

}  // namespace fettle::script
