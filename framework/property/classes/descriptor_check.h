#pragma once
// Checks a class descriptor when the class is registered. Without this check, errors would show
// much later, as a call through a null pointer or a member that cannot be reached.

#include <fettle/property/class.h>

namespace fettle::property {

/// Letters, digits and underscores only. Names of properties are less restricted: a keyboard has
/// the properties "0" and "end".
bool is_word(std::string_view name);

/// Throws Error with the names of the class and the member. `base`: the class it derives from; null
/// only for Object.
void check_descriptor(const ClassDescriptor& descriptor, const Class* base);

}  // namespace fettle::property
