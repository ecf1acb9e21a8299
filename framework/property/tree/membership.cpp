// Callers in C++ give classes, properties, events and methods by reference. A property of another
// class, or of another tree, would be read from memory that does not belong to it.

#include <fettle/property/pinned.h>
#include <fettle/property/spelling.h>
#include <fettle/property/tree.h>

#include "state.h"

namespace fettle::property {

bool Tree::State::has_otherwise(const Node& node, const Property& property) const {
    if (property.owner != nullptr) return classes[node.class_id].is_a(*property.owner);
    if (!node.has_ad_hoc) return false;
    const auto& own = ad_hoc.at(static_cast<std::uint32_t>(&node - &nodes[0]));
    const auto found = own.find(property.name);
    return found != own.end() && found->second.first == &property;
}

void Tree::State::refuse_foreign(Handle handle, const Property& property) const {
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
            ", and the instance a " + of.name());
}

void Tree::State::require_own(const Class& of) const {
    if (classes.find(of.name()) != &of)
        throw Error(ErrorKind::unknown_name, "class " + of.name() + " is of another tree");
}

void Tree::State::require_event(const Class& of, const Event& event) const {
    require_own(of);
    refuse_unless_of(of, event);
}

void Tree::State::require_event(Handle instance, const Event& event) const {
    refuse_unless_of(classes[require(instance).class_id], event);
}

void Tree::State::refuse_unless_of(const Class& of, const Event& event) {
    if (event.owner == nullptr || !of.is_a(*event.owner))
        throw Error(ErrorKind::unknown_name,
                    of.name() + " has no such event: \"" + event.name + "\" is of " +
                        (event.owner == nullptr ? "no class" : event.owner->name()));
}

void Tree::State::require_values(Handle instance, const Event& event,
                                 const std::vector<Value>& values) const {
    if (values.size() == event.fields.size()) return;
    throw Error(ErrorKind::wrong_type, tree.path(instance) + " " + event.name + ": it tells " +
                                           std::to_string(event.fields.size()) +
                                           " values, and was given " +
                                           std::to_string(values.size()));
}

void Tree::State::require_method(Handle handle, const Method& method) const {
    const Class& of = tree.class_of(handle);
    if (method.owner == nullptr || !of.is_a(*method.owner))
        throw Error(ErrorKind::unknown_name,
                    tree.path(handle) + " has no such method: \"" + method.name + "\" is of " +
                        (method.owner == nullptr ? "no class" : method.owner->name()) +
                        ", and the instance a " + of.name());
}

void Tree::State::require_unpinned() const {
    if (pinned != nullptr)
        throw Error(ErrorKind::bad_structure,
                    std::string("the tree is destroyed by ") + pinned +
                        " that it is calling, which must not do so (see \"Lifetimes\" in tree.h)");
}

Pinned::Pinned(Tree& tree, const char* what)
    : tree_(tree), outer_(std::exchange(tree.state().pinned, what)) {}

Pinned::~Pinned() {
    tree_.state().pinned = outer_;
}

void Tree::State::Use::finish() const {
    if (state_.ending)
        throw Error(ErrorKind::deleted, "the tree was destroyed by what it was calling");
}

}  // namespace fettle::property
