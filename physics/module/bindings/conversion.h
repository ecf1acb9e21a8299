#pragma once
// Conversion between the values of the tree (double) and those of the physics library (float).

#include <cmath>
#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>

#include <fettle/physics/types.h>
#include <fettle/property/value.h>

namespace fettle::physics_module {

inline property::Vec2 widen(const physics::Vec2& v) {
    return property::Vec2(v);
}
inline property::Vec2 widen(float x, float y) {
    return {static_cast<double>(x), static_cast<double>(y)};
}

inline physics::Vec2 narrow(const property::Vec2& v) {
    return physics::Vec2(v);
}

inline property::Value to_value(bool v) {
    return v;
}
inline property::Value to_value(float v) {
    return static_cast<double>(v);
}
inline property::Value to_value(int v) {
    return v;
}
inline property::Value to_value(std::uint32_t v) {
    return static_cast<std::int64_t>(v);
}
/// The bits are kept: all of them set is -1, as in Lua.
inline property::Value to_value(std::uint64_t v) {
    return static_cast<std::int64_t>(v);
}
inline property::Value to_value(const physics::Vec2& v) {
    return widen(v);
}
/// Lower left and upper right corner.
inline property::Value to_value(const physics::Aabb& box) {
    return property::List{widen(box.min), widen(box.max)};
}

/// `value` already has the type of the property.
template <class T>
T from_value(const property::Value& value);
template <>
inline bool from_value<bool>(const property::Value& value) {
    return value.boolean();
}
template <>
inline float from_value<float>(const property::Value& value) {
    return static_cast<float>(value.number());
}
template <>
inline int from_value<int>(const property::Value& value) {
    return static_cast<int>(value.integer());
}
template <>
inline std::uint64_t from_value<std::uint64_t>(const property::Value& value) {
    return static_cast<std::uint64_t>(value.integer());
}
template <>
inline physics::Vec2 from_value<physics::Vec2>(const property::Value& value) {
    return narrow(value.vec2());
}
template <>
inline std::optional<float> from_value<std::optional<float>>(const property::Value& value) {
    return from_value<float>(value);
}
template <>
inline std::optional<physics::Vec2> from_value<std::optional<physics::Vec2>>(
    const property::Value& value) {
    return from_value<physics::Vec2>(value);
}

// Arguments of methods: finite doubles that may be out of the range of a float.

[[noreturn]] inline void refuse_argument(const property::Value& value, const char* expected) {
    throw std::invalid_argument(std::string("expected ") + expected +
                                " from -3.4028235e+38 to 3.4028235e+38, got " +
                                property::value_text(value));
}

inline float float_argument(const property::Value& value) {
    const auto narrowed = static_cast<float>(value.number());
    if (!std::isfinite(narrowed)) refuse_argument(value, "a number");
    return narrowed;
}
inline physics::Vec2 vec2_argument(const property::Value& value) {
    physics::Vec2 narrowed = narrow(value.vec2());
    if (!std::isfinite(narrowed.x) || !std::isfinite(narrowed.y)) refuse_argument(value, "a vec2");
    return narrowed;
}
/// A list of two corners, in any order. Throws std::invalid_argument for another number of them.
template <>
inline physics::Aabb from_value<physics::Aabb>(const property::Value& value) {
    const property::List& corners = value.list();
    if (corners.size() != 2)
        throw std::invalid_argument(
            "expected two corners, lower left and upper right, got a list of " +
            std::to_string(corners.size()));
    const physics::Vec2 a = narrow(corners[0].vec2()), b = narrow(corners[1].vec2());
    return {a.min(b), a.max(b)};
}

}  // namespace fettle::physics_module
