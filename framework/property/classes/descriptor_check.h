#pragma once
// Errors in a class descriptor, found when the class is registered: without this check they would
// show much later, as a call through a null pointer or a member that no name reaches.

#include <fettle/property/class.h>

namespace fettle::property {

/// Letters, digits and underscores. Properties may be called as nothing else may: the keys "0" and
/// "end" of a keyboard, say.
bool is_word(std::string_view name);

/// Throws Error, which names the class and the member. `base`: the class it derives from; null for
/// Object alone.
void check_descriptor(const ClassDescriptor& descriptor, const Class* base);

}  // namespace fettle::property
