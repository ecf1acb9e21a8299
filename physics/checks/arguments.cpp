#include <checks/arguments.h>
#include <geometry/decomposition.h>
#include <geometry/number_text.h>
#include <geometry/vector.h>
#include <state/limits.h>

#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace fettle::physics::detail {
namespace {

constexpr float least_size = 1e-5f, greatest_size = 1e6f;

std::string text(float value) {
    return exact_text(value);
}

[[noreturn]] void refuse(const char* what, const std::string& value, const std::string& expected) {
    throw std::invalid_argument(std::string(what) + " = " + value + ": expected " + expected);
}

std::string text(const Vec2& v) {
    return "(" + text(v.x) + ", " + text(v.y) + ")";
}
#ifdef FETTLE_PHYSICS_DOUBLE
std::string text(double value) {
    return number_text(value, 12);
}
std::string text(const Position& p) {
    return "(" + text(p.x) + ", " + text(p.y) + ")";
}
#endif

const char* name_of(ShapeType type) {
    constexpr const char* names[] = {"a circle",   "a box",
                                     "a segment",  "a polygon",
                                     "an ellipse", "a concave polygon",
                                     "a chain",    "the border of the world"};
    return names[size_t(type)];
}

}  // namespace

void refuse_infinite(const char* what, float value) {
    refuse(what, text(value), "a finite number");
}

void refuse_infinite(const char* what, const Vec2& value) {
    refuse(what, text(value), "two finite numbers");
}

const Vec2& check_direction(const char* what, const Vec2& value) {
    check_finite(what, value);
    if (!(length(value) > 1e-6f))
        throw std::invalid_argument(std::string(what) + ": expected a direction, got no length");
    return value;
}

void refuse_negative(const char* what, float value) {
    refuse(what, text(value), "a finite number of at least 0");
}

float check_positive(const char* what, float value) {
    if (!(value > 0.0f) || !std::isfinite(value))
        refuse(what, text(value), "a finite number above 0");
    return value;
}

float check_range(const char* what, float value, float low, float high) {
    if (!(value >= low && value <= high))
        refuse(what, text(value), "a number from " + text(low) + " to " + text(high));
    return value;
}

void check_order(const char* lower_name, float lower, const char* upper_name, float upper) {
    if (lower > upper)
        refuse(lower_name, text(lower),
               std::string("at most ") + upper_name + ", which is " + text(upper));
}

void check_name(const char* what, std::string_view value) {
    constexpr size_t most = 63;
    if (value.size() > most)
        refuse(what, std::to_string(value.size()) + " bytes", "at most 63 bytes");
    if (value.find('\0') != std::string_view::npos)
        throw std::invalid_argument(std::string(what) + ": expected a text without a zero byte");
}

int check_count(const char* what, int value, int low, int high) {
    if (value < low || value > high)
        refuse(what, std::to_string(value),
               "a whole number from " + std::to_string(low) + " to " + std::to_string(high));
    return value;
}

int check_simd_width(const char* what, int value) {
    if (value != 4 && value != 8 && value != 16) refuse(what, std::to_string(value), "4, 8 or 16");
    return value;
}

const Position& check_coordinates(const char* what, const Position& value) {
    const float limit = greatest_coordinate;
    if (!(std::fabs(value.x) <= limit && std::fabs(value.y) <= limit)) {
        refuse(what, text(value), "coordinates between -" + text(limit) + " and " + text(limit));
    }
    return value;
}

namespace {

/// "what.member", without a std::string, which could allocate in every query.
struct MemberName {
    char text[64];
    MemberName(const char* what, const char* member) {
        std::snprintf(text, sizeof text, "%s.%s", what, member);
    }
};

}  // namespace

const Pose& check_pose(const char* what, const Pose& value) {
    check_coordinates(MemberName(what, "position").text, value.position);
    check_range(MemberName(what, "angle").text, value.angle, -1e8f, 1e8f);
    return value;
}

void refuse_enumerator(const char* what, int value, int last) {
    refuse(what, std::to_string(value), "an enumerator, 0 to " + std::to_string(last));
}

std::optional<float> check_inertial(const char* what, std::optional<float> value) {
    if (value && !(*value > 0.0f)) refuse(what, text(*value), "a positive number or infinity");
    return value;
}

float check_speed_limit(const char* what, float value) {
    if (!(value > 0.0f && value <= greatest_speed))
        refuse(what, text(value), "a number above 0, at most " + text(greatest_speed));
    return value;
}

const Aabb& check_box(const char* what, const Aabb& value) {
    check_coordinates(MemberName(what, "min").text, value.min);
    check_coordinates(MemberName(what, "max").text, value.max);
    if (!(value.min.x < value.max.x && value.min.y < value.max.y)) {
        refuse(what, text(value.min) + " to " + text(value.max),
               "a lower left and an upper right corner");
    }
    return value;
}

const Pose& check_pose(const char* what, const char* member, const Pose& value) {
    return check_pose(MemberName(what, member).text, value);
}

const Vec2& check_point(const char* what, const Vec2& p) {
    check_range(what, p.x, -greatest_size, greatest_size);
    check_range(what, p.y, -greatest_size, greatest_size);
    return p;
}

const Vec2& check_point(const char* what, const char* member, const Vec2& p) {
    return check_point(MemberName(what, member).text, p);
}

void check_points(const char* what, const char* one, std::span<const Vec2> points) {
    for (const Vec2& p : points) {
        if (std::fabs(p.x) <= greatest_size && std::fabs(p.y) <= greatest_size) continue;
        const std::string place =
            std::string(what) + ": " + one + " " + std::to_string(&p - points.data() + 1);
        refuse(place.c_str(), text(p),
               "coordinates between -" + text(greatest_size) + " and " + text(greatest_size));
    }
}

void check(const WorldDef& def) {
    check_finite("gravity", def.gravity);
    check_count("substeps", def.substeps, 1, 64);
    if (def.bounds) check_box("bounds", *def.bounds);
    check_not_negative("bounds_friction", def.bounds_friction);
    check_range("bounds_restitution", def.bounds_restitution, 0.0f, 1.0f);
    check_not_negative("restitution_threshold", def.restitution_threshold);
    check_not_negative("hit_threshold", def.hit_threshold);
    check_not_negative("sleep_speed", def.sleep_speed);
    check_not_negative("sleep_delay", def.sleep_delay);
    check_not_negative("contact_hertz", def.contact_hertz);
    check_not_negative("contact_damping", def.contact_damping);
    check_not_negative("push_speed", def.push_speed);
    check_speed_limit("max_speed", def.max_speed);
    check_enumerator("friction_mix", def.friction_mix, MixRule::geometric);
    check_enumerator("restitution_mix", def.restitution_mix, MixRule::geometric);
    check_enumerator("solver", def.solver, Solver::direct);
}

void check(const BodyDef& def) {
    check_enumerator("type", def.type, BodyType::dynamic_body);
    check_coordinates("position", def.position);
    check_range("angle", def.angle, -greatest_coordinate, greatest_coordinate);
    check_finite("velocity", def.velocity);
    check_finite("angular_velocity", def.angular_velocity);
    check_finite("force", def.force);
    check_finite("torque", def.torque);
    check_finite("gravity_scale", def.gravity_scale);
    check_not_negative("linear_damping", def.linear_damping);
    check_not_negative("angular_damping", def.angular_damping);
    check_inertial("mass", def.mass);
    check_inertial("inertia", def.inertia);
    if (def.center) check_point("center", *def.center);
    if (def.sleep_speed) check_not_negative("sleep_speed", *def.sleep_speed);
    check_inertial("max_speed", def.max_speed);
    check_name("name", def.name);
}

void check(const ShapeDef& def) {
    check_not_negative("density", def.density);
    check_not_negative("friction", def.friction);
    check_range("restitution", def.restitution, 0.0f, 1.0f);
    check_not_negative("rolling_resistance", def.rolling_resistance);
    check_finite("surface_speed", def.surface_speed);
}

void check(const SegmentSurface& surface) {
    const auto own = [](float value) { return value == infinity ? 0.0f : value; };
    check_not_negative("friction", own(surface.friction));
    check_range("restitution", own(surface.restitution), 0.0f, 1.0f);
    check_not_negative("rolling_resistance", own(surface.rolling_resistance));
    check_finite("surface_speed", own(surface.surface_speed));
}

namespace {

/// A shape stores the number of its vertices in 24 bits.
constexpr size_t most_points = 1u << 20;

void check_count(const char* what, size_t count, size_t most = most_points) {
    if (count > most)
        refuse(what, std::to_string(count) + " points",
               "at most " + std::to_string(most) + " points");
}

bool all_the_same(std::span<const Vec2> points) {
    for (const Vec2& p : points)
        if ((p - points.front()).abs().largest() > least_size) return false;
    return true;
}

}  // namespace

void check_vertices(std::span<const Vec2> vertices) {
    check_count("vertices", vertices.size());
    check_points("vertices", "vertex", vertices);
}

void check_outline(std::span<const Vec2> points) {
    check_count("vertices", points.size(), Concave::most_vertices);
    check_vertices(points);
    std::vector<Vec2> outline;
    for (const Vec2& v : points) outline.push_back(v);
    if (const auto problem = outline_problem(outline))
        throw std::invalid_argument("vertices: " + *problem);
}

void check_chain(std::span<const Vec2> points, bool closed) {
    check_count("points", points.size());
    if (points.size() < 2)
        throw std::invalid_argument("points: a chain needs at least two points, got " +
                                    std::to_string(points.size()));
    check_points("points", "point", points);
    if (all_the_same(points))
        throw std::invalid_argument("points: all points of the chain are in the same place");
    if (closed && points.size() < 3)
        throw std::invalid_argument("points: a closed chain needs at least three points");
}

void check(const Geometry& geometry) {
    if (const Circle* circle = std::get_if<Circle>(&geometry)) {
        check_range("radius", circle->radius, least_size, greatest_size);
        check_point("center", circle->center);
    } else if (const Box* box = std::get_if<Box>(&geometry)) {
        check_range("width", box->width, least_size, greatest_size);
        check_range("height", box->height, least_size, greatest_size);
        check_range("rounding", box->rounding, 0.0f, greatest_size);
        check_range("angle", box->angle, -greatest_coordinate, greatest_coordinate);
        check_point("center", box->center);
    } else if (const Segment* segment = std::get_if<Segment>(&geometry)) {
        check_point("from", segment->from);
        check_point("to", segment->to);
        check_range("rounding", segment->rounding, 0.0f, greatest_size);
    } else if (const Ellipse* ellipse = std::get_if<Ellipse>(&geometry)) {
        check_range("radius_x", ellipse->radius_x, least_size, greatest_size);
        check_range("radius_y", ellipse->radius_y, least_size, greatest_size);
        check_range("angle", ellipse->angle, -greatest_coordinate, greatest_coordinate);
        check_point("center", ellipse->center);
    } else if (const Concave* concave = std::get_if<Concave>(&geometry)) {
        check_outline(concave->vertices);
    } else if (const Chain* chain = std::get_if<Chain>(&geometry)) {
        check_chain(chain->points, chain->closed);
    } else {
        const Polygon& polygon = std::get<Polygon>(geometry);
        check_vertices(polygon.vertices);
        check_range("rounding", polygon.rounding, 0.0f, greatest_size);
        std::vector<Vec2> hull;
        const HullStatus status = convex_hull(polygon.vertices, hull);
        if (status != HullStatus::ok)
            throw std::invalid_argument(std::string("vertices: ") + describe(status));
    }
}

void refuse_wrong_type(const char* property, ShapeType type) {
    throw std::invalid_argument(std::string(property) + ": " + name_of(type) +
                                " has no such property");
}

}  // namespace fettle::physics::detail
