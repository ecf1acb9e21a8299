#pragma once

#include <string>

#include <fettle/property/value.h>

namespace fettle::property {

/// How a value of another type is written as a value of `type`, as in " (write vec(1, 2))". "" if
/// what is meant is not obvious.
std::string way_to_write(Type type, const Value& value);

}  // namespace fettle::property
