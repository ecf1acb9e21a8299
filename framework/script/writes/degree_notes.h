#pragma once
// A note where a script gives a usual number of degrees to a property in radians, as in angle = 90.

#include <cmath>

#include <values/values.h>

namespace fettle::script {

/// Whether a value of the property was probably meant in degrees: 15, 90, -45, but not 1.5.
inline bool looks_like_degrees(const Property& property, double value) {
    return std::abs(value) >= 15 && std::abs(value) <= 3600 && property.unit == "rad" &&
           std::fmod(value, 5) == 0;
}

/// To be called when a script gives a value. Each property of a class is noted once; a command of
/// the console is not, because its answer shows the unit.
void note_degrees(Machine& machine, Handle instance, const Property& property, double value);

}  // namespace fettle::script
