// Writes names that the class does not declare: a child, an ad hoc property, or an error.

#include <optional>

#include <fettle/property/spelling.h>

#include <classes/script_classes.h>
#include <handlers/formulas.h>
#include <lua/machine.h>
#include <objects/generic_methods.h>
#include <objects/hints.h>
#include <objects/instance.h>
#include <other_languages/synonyms.h>
#include <values/values.h>
#include <writes/declarations.h>
#include <writes/writes.h>

namespace fettle::script {

namespace {

/// The kind of the value at 3; nil for all that is not compared.
Type kind_of_value(lua_State* L) {
    switch (lua_type(L, 3)) {
        case LUA_TBOOLEAN:
            return Type::boolean;
        case LUA_TNUMBER:
            return Type::number;
        case LUA_TTABLE:
            return Type::list;
        default:
            return vec_at(L, 3) != nullptr        ? Type::vec2
                   : instance_at(L, 3) != nullptr ? Type::reference
                                                  : Type::nil;
    }
}

/// The value is at 3.
void refuse_near_miss(lua_State* L, Machine& machine, Handle instance, const Class& of,
                      std::string_view name) {
    std::vector<std::string> names = of.member_names();
    const Type given = kind_of_value(L);
    if (lua_isfunction(L, 3))  // an event may be meant
        for (const property::Event* event : of.events()) names.push_back(event->name);
    machine.classes.add_function_names(of, names);
    for (const std::string& declared : names) {
        const Property* const property = of.property(declared);
        if (property::misspells(name, given, declared, property ? property->type : Type::nil))
            throw Error(ErrorKind::near_miss, path_of(machine.tree, instance, name) +
                                                  ": no such name (did you mean \"" + declared +
                                                  "\"?)");
    }
}

// The detached instance at 3, which will become a child; a null handle for other values.
Handle orphan_at(lua_State* L, const property::Tree& tree) {
    const auto* box = instance_at(L, 3);
    if (!box) return {};
    tree.require(box->handle);
    if (tree.parent(box->handle) || box->handle == tree.root()) return {};
    return box->handle;
}

void write_child(lua_State* L, Machine& machine, Handle instance, Handle child,
                 std::string_view name) {
    if (lua_isnil(L, 3)) {
        destroy(machine, child);
        return;
    }
    const auto* box = instance_at(L, 3);
    if (box && box->handle == child) return;
    if (!machine.tree.class_of(child).creatable())
        throw Error(ErrorKind::bad_structure,
                    path_of(machine.tree, instance, name) + ": is the " +
                        machine.tree.class_of(child).name() +
                        " of the framework and cannot be replaced or deleted");
    const Handle orphan = orphan_at(L, machine.tree);
    if (!orphan)
        throw Error(ErrorKind::bad_structure,
                    path_of(machine.tree, instance, name) + ": is a child of class " +
                        machine.tree.class_of(child).name() +
                        "; assign a new instance to replace it or nil to delete "
                        "it, not " +
                        (box ? machine.tree.path(box->handle) + ", which has its place elsewhere"
                             : describe_type(L, 3)));
    if (machine.tree.is_below(instance, orphan))
        throw Error(ErrorKind::bad_structure,
                    path_of(machine.tree, instance, name) + ": an instance cannot be below itself");
    replace(machine, child, orphan);
}

/// Replaces an ad hoc property by a child.
void write_over(Machine& machine, Handle instance, const Property& property, Handle orphan) {
    const std::string name = property.name;
    const property::Formula* const formula = machine.tree.formula(instance, property);
    const std::optional<property::Formula> computed =
        formula != nullptr ? std::optional(*formula) : std::nullopt;
    const Value value = machine.tree.peek(instance, property);
    clear_property(machine, instance, property);
    try {
        place(machine, orphan, instance, name);
    } catch (...) {  // the child could not be placed, so restore the property
        machine.tree.set_or_add(instance, name, value);
        if (computed) machine.tree.set_formula(instance, name, *computed);
        throw;
    }
}

/// Names from other engines differ too much for a suggestion by spelling, so synonyms are used.
void add_or_explain(Machine& machine, Handle instance, std::string_view name, const Value& value) {
    const property::Tree& tree = machine.tree;
    try {
        set_or_add(machine, instance, name, value);
    } catch (const Error& error) {
        const std::string_view reason = error.what();
        if (error.kind() != ErrorKind::unknown_name ||
            reason.find("did you mean") != std::string_view::npos)
            throw;
        for (const std::string_view meant : property_synonyms(name))
            if (tree.class_of(instance).property(meant) != nullptr)
                throw Error(error.kind(), std::string(reason) + " (did you mean \"" +
                                              std::string(meant) + "\"?)");
        throw;
    }
}

void add_property(Machine& machine, Handle instance, std::string_view name, const Value& value) {
    add_or_explain(machine, instance, name, value);
    if (machine.declarations.defers(instance)) return;
    note_added(machine, instance, name);
    machine.hints.property_added(instance, name);
}

}  // namespace

void write_member(lua_State* L, Machine& machine, Handle instance, const Class& of,
                  std::string_view name) {
    const auto where = [&] { return path_of(machine.tree, instance, name); };
    if (of.method(name) || generic_reference(L, machine, name) != LUA_NOREF)
        throw Error(ErrorKind::bad_name, where() +
                                             ": is a method and cannot be assigned; a "
                                             "property needs another name");
    if (const Handle child = child_of(machine, instance, name)) {
        write_child(L, machine, instance, child, name);
        return;
    }
    if (machine.classes.has_function(of, name))
        throw Error(ErrorKind::bad_name,
                    where() + ": is a function of " + of.name() + " and cannot be assigned");
    if (const Property* property = machine.tree.find(instance, name)) {
        if (lua_isnil(L, 3)) {
            clear_property(machine, instance, *property);
            return;
        }
        if (is_formula(L, 3)) {
            define_formula(L, machine, 3, instance, name);
            return;
        }
        if (const Handle orphan = orphan_at(L, machine.tree)) {
            write_over(machine, instance, *property, orphan);
            return;
        }
        const Value value = to_value(L, 3, where);
        assign_property(machine, instance, *property, value);
        return;
    }
    if (lua_isfunction(L, 3) && of.event(name) != nullptr)
        throw Error(ErrorKind::wrong_type, path_of(machine.tree, instance, name) +
                                               ": is an event; :on(\"" + std::string(name) +
                                               "\", function) adds a handler");
    refuse_near_miss(L, machine, instance, of, name);
    if (lua_isnil(L, 3)) return;
    if (is_formula(L, 3)) {
        define_formula(L, machine, 3, instance, name);
        return;
    }
    if (const Handle orphan = orphan_at(L, machine.tree)) {
        place(machine, orphan, instance, name);
        return;
    }
    const Value value = to_value(L, 3, where);
    add_property(machine, instance, name, value);
}

}  // namespace fettle::script
