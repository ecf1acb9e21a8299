#include "restored_values.h"

#include <fettle/property/error.h>

#include "coerce.h"
#include "state.h"

namespace fettle::property {
namespace {

std::string name_of(const void* what) {
    const auto& property = *static_cast<const Property*>(what);
    return property.owner == nullptr ? property.name : property.owner->name() + "." + property.name;
}

}  // namespace

void RestoredValues::check(const Property& property, const Value& value) const {
    Value taken;
    try {
        // Without a tree: who is there now says nothing of who is about to be.
        taken =
            coerce_value(property, value, {.tree = nullptr, .path = &name_of, .what = &property});
    } catch (const Error& error) {
        from_.fail(error.what());
    }
    if (!(taken == value)) from_.fail(name_of(&property) + ": a value that nobody could write");
    check_references(property, value);
}

void RestoredValues::check_ad_hoc(const Value& value) const {
    static const Property any = [] {
        Property property;
        property.name = "a property that was added";
        property.type = Type::nil;
        property.any_type = property.infinity = true;
        return property;
    }();
    check(any, value);
}

void RestoredValues::check_references(const Property& property, const Value& value) const {
    if (value.is(Type::list))
        for (const Value& element : value.list()) check_references(property, element);
    if (!value.is(Type::reference) || value.reference() == Handle{}) return;
    const Class* wanted =
        property.reference_class.empty() ? nullptr : tree_.find_class(property.reference_class);
    if (!is_or_was(value.reference(), wanted))
        from_.fail(name_of(&property) + ": a reference to nobody who ever was");
}

bool RestoredValues::is_or_was(Handle handle, const Class* wanted) const {
    if (handle.index == 0 || handle.index >= nodes_.end() || !handle) return false;
    const Node& node = nodes_[handle.index];
    // Of a slot whose generations are used up all have been.
    if (handle.generation < node.generation || (!node.alive() && node.generation == 0)) return true;
    if (!node.alive() || handle.generation != node.generation) return false;
    return wanted == nullptr || tree_.state().classes[node.class_id].is_a(*wanted);
}

}  // namespace fettle::property
