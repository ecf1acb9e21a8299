#pragma once
// Coercion of a value to the type of a property, before there is an instance.

#include <string>

#include <fettle/property/class.h>
#include <fettle/property/export.h>
#include <fettle/property/value.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

class Tree;

/// `value` as a value of the property, by the rules of `Tree::set` without the checks of the
/// property's owner. Throws Error(wrong_type, out_of_range, not_finite) with `path` in front of the
/// message.
Value coerced(const Tree& tree, const Property& property, const Value& value,
              const std::string& path);

}  // namespace fettle::property

FETTLE_PROPERTY_END
