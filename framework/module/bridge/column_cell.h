#pragma once
// Properties in a module's own arrays.
//
// The tree accesses them through functions and not as columns, because the stride of a column is
// fixed, and a reloaded module may have another memory layout.

#include <fettle/property/class.h>

#include "class_bridge.h"

namespace fettle::module {

/// Sets the binding of a property in a column of the module, and the range that its memory allows.
void bind_column(property::Property& property, BridgedProperty& kept);

}  // namespace fettle::module
