// Another definition of a class that has instances.

#include <fettle/property/redefinition.h>

#include <classes/fit_saved_value.h>

#include "state.h"

namespace fettle::property {

namespace {

/// The value of a property whose type changes, or that an instance had added.
struct Carried {
    Handle instance;
    std::string name;
    Value value;
};

const Property* among(const std::vector<Property>& all, const std::string& name) {
    for (const Property& each : all)
        if (each.name == name) return &each;
    return nullptr;
}

/// The values of the instance that the class will keep in another way.
void carry(const Tree& tree, Handle instance, const Class& of, const std::vector<Property>& own,
           std::vector<Carried>& carried) {
    for (const Property& wanted : own) {
        if (of.base()->property(wanted.name) != nullptr) continue;
        const Property* const now = tree.find(instance, wanted.name);
        if (now == nullptr && tree.child(instance, wanted.name))
            throw Error(ErrorKind::bad_name, tree.path(instance) + ": has a child \"" +
                                                 wanted.name + "\", which is to be a property of " +
                                                 of.name());
        if (now == nullptr) continue;
        if (now->binding.kind == BindingKind::ad_hoc || now->type != wanted.type)
            carried.push_back({instance, wanted.name, tree.peek(instance, *now)});
    }
}

/// Ends formulas of properties that will not exist any more.
void end_formulas(Tree& tree, Handle instance, const Class& of, const std::vector<Property>& own) {
    for (const Property* now : tree.class_of(instance).properties()) {
        if (now->owner != &of || tree.formula(instance, *now) == nullptr) continue;
        const Property* const wanted = among(own, now->name);
        if (wanted == nullptr || wanted->type != now->type) tree.remove_formula(instance, *now);
    }
}

}  // namespace

void redefine(Tree& tree, const Class& of, std::vector<Property> own) {
    tree.require_changeable("define a class");
    Tree::State& s = tree.state();
    const Nodes& nodes = s.instances.nodes;
    std::vector<Handle> all;
    for (std::uint32_t i = 1; i < nodes.end(); ++i)
        if (nodes[i].alive() && tree.class_of(nodes.handle(i)).is_a(of))
            all.push_back(nodes.handle(i));
    std::vector<Carried> carried;
    for (const Handle each : all) carry(tree, each, of, own, carried);
    for (const Handle each : all) end_formulas(tree, each, of, own);
    for (const Carried& each : carried)
        if (tree.property(each.instance, each.name).binding.kind == BindingKind::ad_hoc)
            tree.remove_ad_hoc(each.instance, each.name);
    s.instances.classes.redefine(s.instances.classes[of.id()], std::move(own));
    tree.add_weight(ClassRegistry::weight_of(of));
    for (const Class* each : tree.classes()) {
        if (!each->is_a(of)) continue;
        s.instances.stored[each->id()]->extend();
        for (const Property& property : ClassRegistry::own_properties(*each))
            property.shortcut.set_interest(s.changes.watchers.interest(property));
    }
    UnfitValues unfit;
    for (const Carried& each : carried)
        if (const Property* now = tree.find(each.instance, each.name))
            tree.set(each.instance, *now, fit_saved_value(*now, each.value, unfit));
    ++s.structure.version;
}

void declare_events(Tree& tree, const Class& of, std::vector<Event> own) {
    tree.require_changeable("define a class");
    ClassRegistry& classes = tree.state().instances.classes;
    tree.add_weight(classes.declare_events(classes[of.id()], std::move(own)));
}

}  // namespace fettle::property
