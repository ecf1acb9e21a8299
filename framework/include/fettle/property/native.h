#pragma once
// Elements of columns: size in bytes, and type of the value.

#include <cstddef>

#include <fettle/property/class.h>
#include <fettle/property/export.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// The type of the values that a column of this native type holds.
Type type_of(Native native);

/// The size of one element in bytes.
std::size_t size_of(Native native);
/// The maximum distance from one element of a column to the next, bytes.
inline constexpr std::size_t largest_stride = std::size_t{1} << 30;

}  // namespace fettle::property

FETTLE_PROPERTY_END
