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

}  // namespace fettle::console
