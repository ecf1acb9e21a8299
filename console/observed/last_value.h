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

}  // namespace fettle::console
