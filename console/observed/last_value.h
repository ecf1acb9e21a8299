#pragma once

#include <fettle/property/tree.h>

namespace fettle::console {

/// The value of a property. While its formula fails, its last value: reading it by `Tree::get` is
/// an error then, and the console must go on, so that the formula can be ended in it.
inline property::Value last_value(const property::Tree& tree, property::Handle instance,
                                  const property::Property& property) {
    (void)tree.problem(instance, property);  // computes the formula, if something has changed
    return tree.peek(instance, property);
}

}  // namespace fettle::console
