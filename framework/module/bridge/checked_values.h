#pragma once
// Checks of what functions of a module give back.

#include <vector>

#include <fettle/property/class.h>

namespace fettle::module {

/// Returns the value of a getter, or the default if the property cannot hold a value of that type:
/// so an error in a module cannot make the host read a value as the wrong type. The same for NaN,
/// and for infinity unless the property allows it.
property::Value checked_value(const property::Property& declared, property::Value value);

/// Throws Error unless each value is of the type of its field and no NaN. A result without a value
/// may stand for a record.
void require_returned(const property::Result& result, const std::vector<property::Field>& fields);

}  // namespace fettle::module
