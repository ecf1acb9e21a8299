#pragma once

#include <fettle/physics/definitions.h>
#include <fettle/physics/field.h>
#include <fettle/physics/hull.h>
#include <fettle/physics/shape.h>

#include <cmath>
#include <span>
#include <string_view>

// Checks of arguments. Each returns its argument or throws std::invalid_argument with the name of
// the value, the value and what was expected. `what` is a name such as "linear_damping".

namespace fettle::physics::detail {

[[noreturn]] void refuse_infinite(const char* what, float value);
[[noreturn]] void refuse_infinite(const char* what, const Vec2& value);
inline float check_finite(const char* what, float value) {
    if (!std::isfinite(value)) [[unlikely]]
        refuse_infinite(what, value);
    return value;
}
inline const Vec2& check_finite(const char* what, const Vec2& value) {
    if (!std::isfinite(value.x) || !std::isfinite(value.y)) [[unlikely]]
        refuse_infinite(what, value);
    return value;
}
inline void check_finite_point(const char* what, const Position& value) {
    if (!value.is_finite()) [[unlikely]]
        refuse_infinite(what, Vec2(value));
}
/// A direction; any length above 0 is valid.
const Vec2& check_direction(const char* what, const Vec2& value);
[[noreturn]] void refuse_negative(const char* what, float value);
/// Finite and >= 0.
inline float check_not_negative(const char* what, float value) {
    if (!(value >= 0.0f) || !std::isfinite(value)) [[unlikely]]
        refuse_negative(what, value);
    return value;
}
/// Finite and > 0.
float check_positive(const char* what, float value);
float check_range(const char* what, float value, float low, float high);
/// Any number, also an infinite one; not NaN.
inline float check_limit(const char* what, float value) {
    return check_range(what, value, -infinity, std::numeric_limits<float>::infinity());
}
/// At least 0, may be infinite.
inline float check_strength(const char* what, float value) {
    return check_range(what, value, 0.0f, infinity);
}
/// Two limits that a definition gives together.
void check_order(const char* lower_name, float lower, const char* upper_name, float upper);
/// At most 63 bytes without a zero.
void check_name(const char* what, std::string_view value);
int check_count(const char* what, int value, int low, int high);
/// 4, 8 or 16.
int check_simd_width(const char* what, int value);
[[noreturn]] void refuse_enumerator(const char* what, int value, int last);
/// Enumerators count from 0 to `last`; a cast number may be out of range.
template <class Enum>
Enum check_enumerator(const char* what, Enum value, Enum last) {
    if (value < Enum{} || value > last) [[unlikely]]
        refuse_enumerator(what, int(value), int(last));
    return value;
}
const Position& check_coordinates(const char* what, const Position& value);  ///< within ±1e8
const Pose& check_pose(const char* what, const Pose& value);
const Pose& check_pose(const char* what, const char* member, const Pose& value);  ///< "what.member"
#ifdef FETTLE_PHYSICS_DOUBLE
inline const Vec2& check_coordinates(const char* what, const Vec2& value) {
    check_coordinates(what, Position(value));
    return value;
}
#endif
const Vec2& check_point(const char* what, const Vec2& value);  ///< a point of a body: within ±1e6
const Vec2& check_point(const char* what, const char* member, const Vec2& value);
/// Points of a body in a list. The message counts from 1, and calls each of them `one`: "vertex".
void check_points(const char* what, const char* one, std::span<const Vec2> points);
/// Positive or infinite: mass, inertia.
std::optional<float> check_inertial(const char* what, std::optional<float> value);
/// A limit of the speed of all bodies: above 0, at most 1e4 m/s.
float check_speed_limit(const char* what, float value);
const Aabb& check_box(const char* what, const Aabb& value);

void check(const WorldDef& def);
void check(const BodyDef& def);
void check(const ShapeDef& def);
void check(const SegmentSurface& surface);
void check(const FieldDef& def);
/// The vertices of a polygon: how many, and where.
void check_vertices(std::span<const Vec2> vertices);
/// The outline of a concave polygon.
void check_outline(std::span<const Vec2> points);
void check_chain(std::span<const Vec2> points, bool closed);
void check(const Geometry& geometry);  ///< polygons: also that they have a hull

[[noreturn]] void refuse_wrong_type(const char* property, ShapeType type);

}  // namespace fettle::physics::detail
