#pragma once
// Coercion and validation: converts a written value to the type of a property, or throws with the
// reason.

#include <string>

#include <fettle/property/class.h>

namespace fettle::property {

struct CoerceContext {
    const Tree* tree = nullptr;  // needed for references; if null, only the type is checked
    /// Called for the path when an error message is made.
    std::string (*path)(const void* what) = nullptr;
    const void* what = nullptr;
};

/// The property that accepts what a parameter or an answer of this field accepts.
Property property_like(const Field& field);

/// Throws Error(wrong_type, out_of_range, not_finite).
Value coerce_value(const Property& property, const Value& value, const CoerceContext& context);

/// The same for one element, from 1, of a list that the property holds.
Value coerce_element(const Property& property, std::size_t index, const Value& value,
                     const CoerceContext& context);

/// Rounds to a float. Not inline, because GCC 12 at -O2 removes two such roundings whose results
/// lie side by side in memory, as those of a vector do.
double narrowed(double x);
Vec2 narrowed(const Vec2& v);

/// "a number from 0 to 1 kg", "one of "static", "kinematic", "dynamic"", "a list of vec2".
std::string expectation(const Property& property);

}  // namespace fettle::property
