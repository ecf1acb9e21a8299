#pragma once
// The clock `time` of the observed game.

#include <observed/last_value.h>

namespace fettle::console {

/// The last value of a property of the clock `time`; nil if there is none.
inline property::Value time_value(const property::Tree& tree, const char* name) {
    const property::Handle time = tree.child(tree.root(), "time");
    const property::Property* const property = time ? tree.find(time, name) : nullptr;
    return property != nullptr ? last_value(tree, time, *property) : property::Value();
}

/// Sets a boolean of the clock `time`, such as `paused`; does nothing if there is none. This is not
/// an edit by a person, so undo does not revert it.
inline void set_time_flag(property::Tree& tree, const char* name, bool on) {
    const property::Handle time = tree.child(tree.root(), "time");
    const property::Property* const property = time ? tree.find(time, name) : nullptr;
    if (property == nullptr || property->type != property::Type::boolean) return;
    const property::Tree::CauseScope cause(tree, property::Writer::module);
    tree.set(time, *property, property::Value(on));
}

}  // namespace fettle::console
