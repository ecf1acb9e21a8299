#pragma once
// Elements of a module's own arrays.
//
// To the tree they are values behind functions, since a tree's column has a stride for good, and a
// module that is taken in anew may have laid its memory out in another way.

#include <fettle/property/class.h>

#include "class_bridge.h"

namespace fettle::module {

/// Fills in how the tree reads and writes a column of the module, and what it may hold.
void bind_column(property::Property& property, BridgedProperty& kept);

}  // namespace fettle::module
