#pragma once
// Coercion and validation: what a written value becomes as a value of a property, or why it cannot.

#include <string>

#include <fettle/property/class.h>

namespace fettle::property {

struct CoerceContext {
    const Tree* tree = nullptr;  // for references; may be null, then only the type is checked
    /// Called for the path only when a message is needed.
    std::string (*path)(const void* what) = nullptr;
    const void* what = nullptr;
};

/// Throws Error(wrong_type, out_of_range, not_finite).
Value coerce_value(const Property& property, const Value& value, const CoerceContext& context);

/// As a float holds it. A call, since GCC 12 at -O2 makes nothing of two such roundings whose
/// results lie beside each other, as those of a vector do.
double narrowed(double x);
Vec2 narrowed(const Vec2& v);

/// "a number from 0 to 1 kg", "one of "static", "kinematic", "dynamic"", "a list of vec2".
std::string expectation(const Property& property);

}  // namespace fettle::property
