#pragma once
// What is probably meant by a value of the wrong type or of another range, for error messages.

#include <string>

#include <fettle/property/export.h>
#include <fettle/property/value.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// How a value of another type is written as a value of `type`, as in " (write vec(1, 2))". "" if
/// what is meant is not obvious. Channels of a color may be given as a list of numbers.
std::string literal_hint(Type type, const Value& value);

}  // namespace fettle::property

FETTLE_PROPERTY_END
