// Checks of arguments from C++. Callers pass classes, properties, events and methods by reference.
// A property of another class or tree would access memory that does not belong to it.

#include <fettle/property/error.h>
#include <fettle/property/spelling.h>

#include "instances.h"

namespace fettle::property {
namespace {

void refuse_unless_of(const Class& of, const Event& event) {
    if (event.owner == nullptr || !of.is_a(*event.owner))
        throw Error(ErrorKind::unknown_name,
                    of.name() + " has no such event: \"" + event.name + "\" is of " +
                        (event.owner == nullptr ? "no class" : event.owner->name()));
}

}  // namespace

bool Instances::has_otherwise(const Node& node, const Property& property) const {
    if (property.owner != nullptr) return classes[node.class_id].is_a(*property.owner);
    if (!node.has_ad_hoc) return false;
    const AdHoc::Entry* own =
        ad_hoc.find(static_cast<std::uint32_t>(&node - &nodes[0]), property.name);
    return own != nullptr && own->first == &property;
}

void Instances::refuse_foreign(Handle handle, const Property& property) const {
    if (property.owner == nullptr && property.binding.kind == BindingKind::ad_hoc)
        throw Error(ErrorKind::unknown_name, tree.path(handle) + " has no property \"" +
                                                 property.name +
                                                 "\": it was added to another instance, or "
                                                 "removed since");
    const Class& of = tree.class_of(handle);
    const std::string owner =
        property.owner == nullptr ? "of no class" : "of " + property.owner->name();
    throw Error(
        ErrorKind::unknown_name,
        tree.path(handle) + ": the property \"" + property.name + "\" is " + owner +
            (property.owner != nullptr && classes.find(property.owner->name()) != property.owner
                 ? " of another tree"
                 : "") +
            ", and the instance " + with_article(of.name()));
}

void Instances::require_own(const Class& of) const {
    if (classes.find(of.name()) != &of)
        throw Error(ErrorKind::unknown_name, "class " + of.name() + " belongs to another tree");
}

void Instances::require_event(const Class& of, const Event& event) const {
    require_own(of);
    refuse_unless_of(of, event);
}

void Instances::require_event(Handle instance, const Event& event) const {
    refuse_unless_of(classes[require(instance).class_id], event);
}

void Instances::require_values(Handle instance, const Event& event,
                               const std::vector<Value>& values) const {
    if (values.size() == event.fields.size()) return;
    throw Error(ErrorKind::wrong_type, tree.path(instance) + " " + event.name + ": it has " +
                                           std::to_string(event.fields.size()) +
                                           " values, and was given " +
                                           std::to_string(values.size()));
}

void Instances::require_method(Handle handle, const Method& method) const {
    const Class& of = tree.class_of(handle);
    if (method.owner == nullptr || !of.is_a(*method.owner))
        throw Error(ErrorKind::unknown_name,
                    tree.path(handle) + " has no such method: \"" + method.name + "\" is of " +
                        (method.owner == nullptr ? "no class" : method.owner->name()) +
                        ", and the instance " + with_article(of.name()));
}

/// Instances that only a module or the framework can make stay where they were made: a scene file
/// could not put them anywhere else.
void Instances::require_movable(Handle instance) const {
    const Class& of = classes[require(instance).class_id];
    if (!of.creatable())
        throw Error(ErrorKind::bad_structure,
                    tree.path(instance) + ": the " + of.name() + " cannot be moved or renamed");
}

/// `levels`: the height of the subtree that is going to be below `parent`.
void Instances::require_room_below(Handle parent, std::size_t levels) const {
    if (nodes.depth(parent.index) + levels <= Nodes::deepest) return;
    std::string path = tree.path(parent);
    if (path.size() > 80) path = path.substr(0, 50) + "…" + path.substr(path.size() - 25);
    throw Error(ErrorKind::bad_structure, path + ": too deep; a tree has " +
                                              std::to_string(Nodes::deepest) + " levels at most");
}

}  // namespace fettle::property
