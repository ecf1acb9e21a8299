#pragma once

#include <fettle/property/tree.h>

namespace fettle::console {

/// The value of a property; while its formula fails, its last value. `Tree::get` would throw then,
/// and the console must work, so that the formula can be removed.
inline property::Value last_value(const property::Tree& tree, property::Handle instance,
                                  const property::Property& property) {
    (void)tree.problem(instance, property);  // computes the formula, if something has changed
    return tree.peek(instance, property);
}

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
