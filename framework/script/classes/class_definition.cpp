// Defines classes: `Ball = class("Ball", Body) { ... }`.

#include <utility>

#include <fettle/property/path.h>
#include <fettle/property/spelling.h>

#include <classes/class_definition.h>
#include <classes/own_events.h>
#include <classes/script_classes.h>
#include <handlers/formulas.h>
#include <lua/exception_guard.h>
#include <lua/host.h>
#include <lua/interpreter.h>
#include <lua/machine.h>
#include <lua/stack.h>
#include <other_languages/foreign_classes.h>
#include <reference/language.h>
#include <text/words.h>
#include <values/short_text.h>
#include <values/values.h>

namespace fettle::script {

namespace {

constexpr std::size_t max_kinds = 8;         // number of kinds that a message lists
constexpr std::size_t max_entries = 10'000;  // number of properties and functions of one class

// The default from `name = value` in a class; the value is at the top of the stack.
Value default_of(lua_State* L, const std::string& class_name, const std::string& name) {
    if (is_formula(L, -1))
        throw Error(
            ErrorKind::wrong_type,
            class_name + "." + name +
                ": a formula is not a default, since each instance has formulas of its own; "
                "give a plain value here and the formula to the instance, in function " +
                class_name + ":ready() or in the constructor");
    return to_value(L, -1, [&] { return class_name + "." + name; });
}

std::vector<std::pair<std::string, std::string>> documentation(lua_State* L, int table,
                                                               std::string& class_doc) {
    std::vector<std::pair<std::string, std::string>> docs;
    lua_pushstring(L, "doc");
    lua_rawget(L, table);
    if (lua_type(L, -1) == LUA_TSTRING) {
        class_doc = string_at(L, -1);
    } else if (!lua_isnil(L, -1) && !lua_istable(L, -1)) {
        throw Error(ErrorKind::wrong_type,
                    "doc: expected a text, or a table of texts by the names of properties, got " +
                        describe_type(L, -1));
    }
    if (lua_istable(L, -1)) {
        const int doc = lua_gettop(L);
        for (const std::string& key : sorted_keys(L, doc, "doc")) {
            push_text(L, key);
            if (lua_rawget(L, doc) != LUA_TSTRING)
                throw Error(ErrorKind::wrong_type,
                            "doc." + key + ": expected a text, got " + describe_type(L, -1));
            docs.emplace_back(key, string_at(L, -1));
            lua_pop(L, 1);
        }
        if (lua_rawgeti(L, doc, 1) == LUA_TSTRING) class_doc = string_at(L, -1);
        lua_pop(L, 1);
    }
    lua_pop(L, 1);
    return docs;
}

// Refuses names that are almost equal to a declared name of the framework. Names that the game
// itself declares may be similar.
void refuse_near_misses(const ScriptClasses& classes, const Class& base,
                        const std::string& class_name, const std::string& name, Type given) {
    if (base.method(name))
        throw Error(ErrorKind::bad_name,
                    class_name + "." + name + ": is a method of " + base.name());
    if (among(generic_names(), name))
        throw Error(ErrorKind::bad_name, class_name + "." + name +
                                             ": is a method of every instance; a property needs " +
                                             "another name");
    const auto refuse = [&](const std::string& known) {
        throw Error(ErrorKind::near_miss, class_name + "." + name + ": " + base.name() +
                                              " has no such property (did you mean \"" + known +
                                              "\"?)");
    };
    for (const Property* declared : base.properties())
        if (!classes.scripted(*declared->owner) &&
            property::misspells(name, given, declared->name, declared->type))
            refuse(declared->name);
    for (const property::Method* method : base.methods())
        if (property::near_miss(name, method->name)) refuse(method->name);
}

// Refuses entries without a name: a class table has no children, unlike that of a constructor. Also
// refuses too many entries: the memory of what is made of them is counted only afterwards.
void check_entries(lua_State* L, const std::string& class_name) {
    std::size_t count = 0;
    for (lua_pushnil(L); lua_next(L, 1) != 0; lua_pop(L, 1)) {
        if (++count > max_entries)
            throw Error(ErrorKind::rejected,
                        class_name + ": a class declares at most " + std::to_string(max_entries) +
                            " properties and functions; a list of values is one property");
        if (lua_type(L, -2) != LUA_TSTRING)
            throw Error(ErrorKind::bad_name,
                        class_name + ": [" + short_text(L, -2) + "] has no name; a class has " +
                            "properties and functions, and its children are made in " + class_name +
                            ":ready()");
    }
}

void check_documented(const ScriptClasses::Definition& definition,
                      const std::vector<std::pair<std::string, std::string>>& docs) {
    std::vector<std::string> names;
    for (const Property& property : definition.properties) names.push_back(property.name);
    for (const ScriptClasses::OwnEvent& event : definition.events) names.push_back(event.name);
    for (const auto& [name, doc] : docs)
        if (!among(names, name))
            throw Error(ErrorKind::unknown_name,
                        definition.name + ".doc: the class declares no property \"" + name + "\"" +
                            property::suggestion(name, names));
}

/// True if the table at `index` is not empty and all its keys are texts: then it is a table of
/// states. Otherwise it is the default of a property called `states`.
bool has_texts_as_keys(lua_State* L, int index) {
    bool any = false;
    index = lua_absindex(L, index);
    for (lua_pushnil(L); lua_next(L, index) != 0; lua_pop(L, 1)) {
        if (lua_type(L, -2) != LUA_TSTRING) {
            lua_pop(L, 2);
            return false;
        }
        any = true;
    }
    return any;
}

const Property* among_declared(const std::vector<Property>& properties, const std::string& name) {
    for (const Property& property : properties)
        if (property.name == name) return &property;
    return nullptr;
}

/// Adds the properties of a class with states that neither it nor its base declares.
void add_state_properties(ScriptClasses::Definition& definition) {
    for (Property& property : state_properties()) {
        if (definition.base->property(property.name) != nullptr) continue;
        const Property* given = among_declared(definition.properties, property.name);
        if (given == nullptr) {
            definition.properties.push_back(std::move(property));
        } else if (given->type != property.type) {
            throw Error(ErrorKind::wrong_type,
                        definition.name + "." + property.name +
                            ": a class with states has the name of a state there, not " +
                            property::with_article(property::type_name(given->type)));
        }
    }
}

/// The default of `current_state`.
std::string first_state_of(const ScriptClasses::Definition& definition) {
    const Property* given = among_declared(definition.properties, "current_state");
    return given != nullptr && given->default_value.is(Type::text) ? given->default_value.text()
                                                                   : std::string();
}

void check_first_state(const ScriptClasses& classes, const Class& of, const std::string& first) {
    const std::vector<std::string> known = classes.states_of(of);
    if (!first.empty() && !among(known, first))
        throw Error(ErrorKind::unknown_name, of.name() + ".current_state: there is no state \"" +
                                                 first + "\"" + property::suggestion(first, known));
}

// Upvalue: name.
int not_defined_yet(lua_State* L) {
    const std::string name = string_at(L, lua_upvalueindex(1));
    throw Error(ErrorKind::bad_structure, name +
                                              ": is not a class yet; braces with its properties "
                                              "are missing, as in " +
                                              name + " = class(\"" + name + "\", Body) { }");
}

// Upvalues: name, base.
int define_class(lua_State* L) {
    Machine& machine = machine_of(L);
    lua_remove(L, 1);  // the object that class(...) returned
    ScriptClasses::Definition definition;
    definition.name = string_at(L, lua_upvalueindex(1));
    definition.base = class_object_at(L, lua_upvalueindex(2));
    lua_settop(L, 1);
    if (!lua_istable(L, 1))
        throw Error(ErrorKind::wrong_type, "class: needs a table of properties, as in class(\"" +
                                               definition.name + "\", Body) { lives = 3 }");
    check_entries(L, definition.name);
    const auto docs = documentation(L, 1, definition.doc);
    std::vector<std::string> functions;
    const bool states = lua_getfield(L, 1, "states") == LUA_TTABLE && has_texts_as_keys(L, -1);
    lua_getfield(L, 1, "events");
    const bool events = declares_events(L, -1);
    if (events) definition.events = events_at_top(L, definition.name);
    lua_pop(L, 2);
    for (ScriptClasses::OwnEvent& event : definition.events)
        for (const auto& [name, doc] : docs)
            if (name == event.name) event.doc = doc;
    for (const std::string& key : sorted_keys(L, 1, definition.name)) {
        if (key == "doc" || (states && key == "states") || (events && key == "events")) continue;
        push_text(L, key);
        if (lua_rawget(L, 1) == LUA_TFUNCTION) {
            functions.push_back(key);
        } else if (const Property* inherited = definition.base->property(key)) {
            // An inherited property gets another default; everything else stays the same.
            Property again;
            again.name = key;
            again.type = inherited->type;
            again.default_value = default_of(L, definition.name, key);
            for (const auto& [name, doc] : docs)
                if (name == key) again.doc = doc;
            definition.properties.push_back(std::move(again));
        } else {
            Property property = declared_property(L, definition.name, key);
            refuse_near_misses(machine.classes, *definition.base, definition.name, key,
                               property.type);
            for (const auto& [name, doc] : docs)
                if (name == key) property.doc = doc;
            definition.properties.push_back(std::move(property));
        }
        lua_pop(L, 1);
    }
    if (states) add_state_properties(definition);
    check_documented(definition, docs);
    const std::string first_state = states ? first_state_of(definition) : std::string();
    const Class& made = machine.classes.define(std::move(definition));
    for (const std::string& function : functions) {
        push_text(L, function);
        lua_rawget(L, 1);
        machine.classes.set_function(L, made, function);
    }
    if (states) {
        lua_getfield(L, 1, "states");
        machine.classes.set_states(L, made);
        check_first_state(machine.classes, made, first_state);
    }
    machine.classes.push(L, made);
    return 1;
}

int class_function(lua_State* L) {
    Machine& machine = machine_of(L);
    lua_settop(L, 2);
    const std::string name =
        check_text(L, 1, "class: needs a name, as in class(\"Ball\", Body) { }");
    property::check_name_length(name);
    if (!property::is_identifier(name))
        throw Error(ErrorKind::bad_name, "class: \"" + name + "\" is not a name for a class");
    if (lua_isnil(L, 2)) {
        machine.classes.push(L, machine.tree.object_class());
        lua_replace(L, 2);
    } else if (lua_type(L, 2) == LUA_TSTRING) {
        machine.classes.push(L, class_called(machine.tree, string_at(L, 2)));
        lua_replace(L, 2);
    } else if (!class_object_at(L, 2)) {
        refuse_type(L, 2, "class: the base is a class or its name");
    }
    const Class* base = class_object_at(L, 2);
    if (!base->creatable())
        throw Error(ErrorKind::bad_structure, name + ": no class can derive from " + base->name() +
                                                  "; " + why_not_creatable(machine.tree, *base));
    luaL_where(L, 1);
    machine.classes.begin(name, string_at(L, -1));
    lua_pop(L, 1);
    // The result is callable. If a script uses it like a class, its error explains that the table
    // is missing.
    *static_cast<Tag*>(lua_newuserdatauv(L, sizeof(Tag), 0)) = Tag::unfinished_class;
    lua_newtable(L);
    lua_pushvalue(L, 1);
    lua_pushvalue(L, 2);
    lua_pushcclosure(L, guarded<effect<define_class>>, 2);
    lua_setfield(L, -2, "__call");
    for (const char* use : {"__index", "__newindex"}) {
        lua_pushvalue(L, 1);
        lua_pushcclosure(L, guarded<not_defined_yet>, 1);
        lua_setfield(L, -2, use);
    }
    name_metatable(L, "class without properties");
    lua_setmetatable(L, -2);
    return 1;
}

}  // namespace

Property declared_property(lua_State* L, const std::string& class_name, const std::string& name) {
    Property property;
    property.name = name;
    property.infinity = true;
    if (const Class* of = class_object_at(L, -1)) {
        property.type = Type::reference;
        property.reference_class = of->name();
        property.nullable = true;
        return property;
    }
    property.default_value = default_of(L, class_name, name);
    property.type = property.default_value.type();
    if (property.type == Type::reference) property.nullable = true;
    return property;
}

std::string why_not_creatable(const property::Tree& tree, const Class& of) {
    std::string made_of;
    std::size_t kinds = 0;
    for (const Class* each : tree.classes())
        if (each != &of && each->is_a(of) && each->creatable() && ++kinds <= max_kinds)
            made_of += (kinds == 1 ? "" : ", ") + each->name();
    if (kinds > max_kinds) made_of += " ...";
    if (kinds > 0) return "it is what these have in common: " + made_of;
    std::vector<std::string> paths;
    tree.each_below(tree.root(), [&](Handle handle) {
        if (&tree.class_of(handle) == &of) paths.push_back(tree.path(handle));
    });
    if (paths.size() == 1) return "the framework makes the one there is, " + paths.front();
    return "only the framework makes them";
}

void open_class_function(lua_State* L) {
    add_function<class_function>(L, "class");
}

}  // namespace fettle::script
