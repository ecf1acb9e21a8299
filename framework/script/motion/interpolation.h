#pragma once
// Values between two others, for tweens.

#include <fettle/property/class.h>
#include <fettle/property/value.h>

namespace fettle::script {

/// Whether there are values between the two: numbers, vectors, colors, and lists of these of the
/// same length.
bool mixable(const property::Value& from, const property::Value& to);

/// The value at `part` of the way; below 0 and above 1 it lies beyond the ends. The
/// property accepts the result: it is rounded if the property takes integers only, and limited to
/// the property's range. The two must be mixable.
property::Value mix(const property::Value& from, const property::Value& to, double part,
                    const property::Property& property);

}  // namespace fettle::script
