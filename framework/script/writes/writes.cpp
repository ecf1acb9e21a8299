#include <utility>

#include <fettle/property/formula_problems.h>
#include <fettle/property/question.h>
#include <fettle/property/storage/tweaks.h>
#include <fettle/script/runtime.h>

#include <lua/machine.h>
#include <reference/language.h>
#include <text/words.h>
#include <values/moved_lists.h>
#include <values/recording.h>
#include <writes/change_notes.h>
#include <writes/declarations.h>
#include <writes/degree_notes.h>
#include <writes/replaced_formulas.h>
#include <writes/writes.h>

namespace fettle::script {

using property::BindingKind;

namespace {

// Performs `write` and, during a console command, records the property's value before and after.
template <class Write>
void recorded(Machine& machine, Handle instance, const Property& property, Write write) {
    if (!machine.recording.active) {
        write();
        return;
    }
    const property::Symbol symbol = property.symbol;
    const std::string path = machine.tree.path(instance, property);
    const Value before = machine.tree.peek(instance, property);
    const std::string unit = property.unit;
    const property::Precision precision = property.precision();
    const bool replaced = machine.tree.formula(instance, property) != nullptr;
    write();  // may remove the property
    const Property* after = machine.tree.find(instance, symbol);
    if (Recording::Edit* edit = machine.recording.edit_of(instance, symbol)) {
        if (edit->path.empty()) {
            edit->path = path;
            edit->before = before;
        }
        edit->unit = unit;
        edit->precision = precision;
        edit->after = after ? machine.tree.peek(instance, *after) : Value();
        if (replaced) edit->replaced = true;
    }
}

/// What was probably meant with an instance in the place of another value: a text without
/// quotes that is the name of an instance, or a child.
std::string meaning_of_instance(const property::Tree& tree, Handle instance,
                                const Property& property, Handle value) {
    const std::string name = tree.name(value);
    if (among(property.enumerators, name))
        return "; a text needs quotes: did you mean " + property.name + " = \"" + name + "\"?";
    if (tree.parent(value) || value == tree.root()) return {};
    return "; " + property.name + " is a property of " + tree.class_of(instance).name() +
           ", so a child needs another name";
}

/// What was probably meant with the name of a picture in the place of another value.
std::string meaning_of_file(const property::Tree& tree, Handle instance, const Value& value) {
    const Property* const image = tree.find(instance, "image");
    if (image == nullptr || image->type != property::Type::text) return {};
    const std::string& name = value.text();
    for (const std::string_view ending : {".json", ".png", ".jpg", ".jpeg", ".bmp", ".tga"})
        if (name.ends_with(ending)) return "; did you mean image = \"" + name + "\"?";
    return {};
}

template <class Write>
void explained(property::Tree& tree, Handle instance, const Property& property, const Value& value,
               Write write) {
    try {
        write();
    } catch (const Error& error) {
        if (error.kind() != ErrorKind::wrong_type || !tree.alive(instance)) throw;
        if (value.is(property::Type::text))
            throw Error(error.kind(), error.what() + meaning_of_file(tree, instance, value));
        if (!value.is(property::Type::reference) || property.type == property::Type::reference ||
            !tree.alive(value.reference()))
            throw;
        throw Error(error.kind(), error.what() + meaning_of_instance(tree, instance, property,
                                                                     value.reference()));
    }
}

void set_or_explain(property::Tree& tree, Handle instance, const Property& property,
                    const Value& value) {
    explained(tree, instance, property, value, [&] { tree.set(instance, property, value); });
}

}  // namespace

void assign_property(Machine& machine, Handle instance, const Property& property,
                     const Value& value) {
    Origin place;
    place.instance = instance;
    place.symbol = property.symbol;
    const bool is_list = value.is(property::Type::list);
    Value before = is_list ? machine.tree.peek(instance, property) : Value();
    write_property(machine, instance, property, value);
    if (before.is(property::Type::list)) machine.moved_lists.note_whole(place, std::move(before));
}

void write_property(Machine& machine, Handle instance, const Property& property,
                    const Value& value) {
    note_change(machine, instance, property.name);
    if (value.is_numeric()) note_degrees(machine, instance, property, value.as_double());
    Declarations& declarations = machine.declarations;
    if (!declarations.active()) {
        note_replaced_formula(machine, instance, property.name);
        recorded(machine, instance, property,
                 [&] { set_or_explain(machine.tree, instance, property, value); });
        return;
    }
    const std::string name = property.name;
    if (declarations.defers(instance)) return declarations.defer(instance, name, value);
    declarations.writing(instance, name);
    recorded(machine, instance, property,
             [&] { set_or_explain(machine.tree, instance, property, value); });
    declarations.wrote(instance, name);
}

bool write_element(Machine& machine, const Origin& place, std::size_t index, const Value& element) {
    if (place.depth > 0 || machine.declarations.reloading() || machine.recording.active)
        return false;
    const Property& property = origin_property(machine.tree, place);
    const std::string name = property.name;
    note_change(machine, place.instance, name);
    note_replaced_formula(machine, place.instance, name);
    machine.declarations.writing(place.instance, name);
    explained(machine.tree, place.instance, property, element, [&] {
        if (element.is_nil())
            machine.tree.remove_last_element(place.instance, property);
        else
            machine.tree.set_element(place.instance, property, index, element);
    });
    machine.declarations.wrote_element(place.instance, name);
    return true;
}

namespace {

/// Refuses a formula whose value now the property cannot have, as it refuses the value itself. A
/// formula that fails now, or has no value, may have one later.
void require_fitting(Machine& machine, Handle instance, std::string_view name,
                     const property::Formula& formula) {
    property::Tree& tree = machine.tree;
    const Property* const property = tree.find(instance, name);
    if (property == nullptr || property->binding.kind == property::BindingKind::node) return;
    Value value;
    try {
        const property::Inquiry inquiry(tree, "a formula", "cannot");
        value = formula.function(tree);
    } catch (const std::exception&) {
        return;
    }
    if (value.is_nil()) return;
    try {
        (void)tree.coerce(instance, *property, value);
    } catch (const Error& error) {
        if (error.kind() == ErrorKind::wrong_type) throw;
    }
}

}  // namespace

void write_formula(Machine& machine, Handle instance, std::string_view name,
                   property::Formula formula) {
    note_change(machine, instance, name);
    const std::string source = formula.source.empty() ? "a function" : one_line(formula.source);
    Declarations& declarations = machine.declarations;
    if (declarations.defers(instance))
        return declarations.defer(instance, name, std::move(formula));
    if (machine.recording.active) require_fitting(machine, instance, name, formula);
    note_replaced_formula(machine, instance, name);
    declarations.writing(instance, name);
    const bool added = machine.tree.find(instance, name) == nullptr;
    machine.tree.set_formula(instance, name, std::move(formula));
    note_typed_formula(machine, instance, name);
    declarations.wrote(instance, name);
    if (!machine.recording.active) return;
    const Property& property = machine.tree.property(instance, name);
    const std::string problem = machine.tree.problem(instance, property);
    std::string description = "is " + source + " = ";
    description += machine.tree.text(machine.tree.peek(instance, property), property.precision());
    if (!property.unit.empty()) description += " " + property.unit;
    if (!problem.empty()) description = "is " + source + ", in error: " + problem;
    property::formula_problem_reported(machine.tree, instance, property);
    Recording::Edit* const noted =
        machine.recording.note(instance, machine.tree.path(instance, property), description);
    if (added && noted != nullptr) noted->added = name;
}

void note_added(Machine& machine, Handle instance, std::string_view name) {
    if (!machine.recording.active) return;
    const Property& property = machine.tree.property(instance, name);
    if (Recording::Edit* edit = machine.recording.edit_of(instance, property.symbol)) {
        if (edit->path.empty()) edit->path = machine.tree.path(instance, property);
        edit->after = machine.tree.get(instance, property);
        edit->added = name;
    }
}

void set_or_add(Machine& machine, Handle instance, std::string_view name, const Value& value) {
    note_change(machine, instance, name);
    Declarations& declarations = machine.declarations;
    if (declarations.defers(instance)) return declarations.defer(instance, name, value);
    declarations.writing(instance, name);
    machine.tree.set_or_add(instance, name, value);
    declarations.wrote(instance, name);
}

Handle child_of(Machine& machine, Handle instance, std::string_view name) {
    const Declarations& declarations = machine.declarations;
    if (declarations.reloading())
        if (const Handle waiting = declarations.child(instance, name)) return waiting;
    const Handle child = machine.tree.child(instance, name);
    return declarations.hides(child) ? Handle{} : child;
}

void clear_property(Machine& machine, Handle instance, const Property& property) {
    note_change(machine, instance, property.name);
    Declarations& declarations = machine.declarations;
    const std::string name = property.name;
    if (declarations.defers(instance)) return declarations.defer(instance, name, Value());
    declarations.writing(instance, name);
    recorded(machine, instance, property, [&] {
        if (property.binding.kind == BindingKind::ad_hoc)
            machine.tree.remove_ad_hoc(instance, property.name);
        else
            machine.tree.set(instance, property, Value());
    });
    declarations.wrote(instance, name);
}

namespace {

void note_placed(Machine& machine, Handle instance) {
    if (machine.options.tweaks != nullptr) machine.options.tweaks->placed(instance);
    if (machine.recording.active && machine.tree.is_below(instance, machine.tree.root()))
        machine.recording.note(instance, machine.tree.path(instance),
                               "new " + machine.tree.class_of(instance).name());
}

/// Whether the instance was given a name that means something else in every place below the parent.
bool is_named_wrongly(const property::Tree& tree, Handle instance, Handle parent,
                      const std::string& own) {
    const property::Class& above = tree.class_of(parent);
    return tree.parent(instance) != parent && own != tree.class_of(instance).stem() &&
           (above.property(own) != nullptr || above.method(own) != nullptr ||
            among(generic_names(), own));
}

}  // namespace

void place(Machine& machine, Handle instance, Handle parent, std::string_view name,
           property::PlainNames* plain_names) {
    note_change(machine, parent, name);
    // The tree would put a number after a wrong name of its own; as a given name it is an error.
    std::string own;
    if (name.empty() && machine.tree.alive(instance) && machine.tree.alive(parent)) {
        own = machine.tree.name(instance);
        if (is_named_wrongly(machine.tree, instance, parent, own)) name = own;
    }
    if (machine.declarations.defers(parent) || machine.declarations.has_place(instance))
        return machine.declarations.place(instance, parent, name);
    machine.tree.move(instance, parent, name, plain_names);
    note_placed(machine, instance);
}

void replace(Machine& machine, Handle old, Handle by) {
    note_change(machine, old, {});
    Declarations& declarations = machine.declarations;
    if (declarations.reloading() && declarations.has_place(old)) {
        const Declarations::Place place = declarations.place_of(old);
        declarations.remove(old);
        machine.tree.destroy(old);
        return declarations.place(by, place.parent, place.name);
    }
    if (declarations.defers(old))
        return declarations.place(by, machine.tree.parent(old), machine.tree.name(old));
    const bool placed = machine.tree.is_below(old, machine.tree.root());
    const std::string path = machine.recording.active ? machine.tree.path(old) : "";
    machine.tree.replace(old, by);
    if (placed) machine.recording.note(old, path, "deleted");
    note_placed(machine, by);
}

void destroy(Machine& machine, Handle instance) {
    machine.tree.require(instance);
    if (!machine.tree.class_of(instance).creatable())
        throw Error(ErrorKind::bad_structure, machine.tree.path(instance) +
                                                  ": is the framework's own and cannot "
                                                  "be deleted; find(Class):delete(), as in "
                                                  "world:find(Body):delete(), deletes those of "
                                                  "a class");
    note_change(machine, instance, {});
    if (machine.declarations.defers(instance)) return;
    if (machine.declarations.reloading()) machine.declarations.remove(instance);
    const bool placed = machine.tree.is_below(instance, machine.tree.root());
    const std::string path = machine.recording.active ? machine.tree.path(instance) : "";
    machine.tree.destroy(instance);
    if (placed) machine.recording.note(instance, path, "deleted");
}

}  // namespace fettle::script
