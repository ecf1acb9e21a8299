#include "restored_values.h"

#include <fettle/property/error.h>

#include <classes/coerce.h>
#include <tree/state.h>

namespace fettle::property {

std::optional<Value> RestoredValues::coerced(const Property& property, const Value& value) const {
    try {
        // No tree is given, because references are checked against the nodes of the snapshot
        // instead.
        return coerce_value(
            property, value,
            {.tree = nullptr, .path = [](const void*) { return std::string(); }, .what = nullptr});
    } catch (const Error&) {
        return std::nullopt;
    }
}

std::optional<Value> RestoredValues::fitted(const Property& property, const Value& value) const {
    if (!of_its_class(property, value)) return std::nullopt;
    return coerced(property, value);
}

void RestoredValues::check_ad_hoc(const Value& value) const {
    static const Property any = [] {
        Property property;
        property.name = "a property that was added";
        property.type = Type::nil;
        property.any_type = property.infinity = true;
        return property;
    }();
    const std::optional<Value> taken = fitted(any, value);
    if (!taken || !(*taken == value)) from_.fail(any.name + ": a value that no write can give");
}

/// Whether all references in the value lead to instances that exist or existed, and have the class
/// that the property requires.
bool RestoredValues::of_its_class(const Property& property, const Value& value) const {
    if (value.is(Type::list)) {
        bool all = true;
        for (const Value& element : value.list()) all &= of_its_class(property, element);
        return all;
    }
    if (!value.is(Type::reference) || value.reference() == Handle{}) return true;
    const Handle handle = value.reference();
    if (handle.index == 0 || handle.index >= nodes_.end() || !handle) refuse_reference(property);
    const Node& node = nodes_[handle.index];
    // A slot whose generations are used up had every generation.
    if (handle.generation < node.generation || (!node.alive() && node.generation == 0)) return true;
    if (!node.alive() || handle.generation != node.generation) refuse_reference(property);
    const Class* wanted =
        property.reference_class.empty() ? nullptr : tree_.find_class(property.reference_class);
    return wanted == nullptr || tree_.state().instances.classes[node.class_id].is_a(*wanted);
}

void RestoredValues::refuse_reference(const Property& property) const {
    from_.fail((property.owner == nullptr ? std::string() : property.owner->name() + ".") +
               property.name + ": a reference to an instance that never existed");
}

}  // namespace fettle::property
