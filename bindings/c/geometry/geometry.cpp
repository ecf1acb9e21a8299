
#include <calls/calls.h>

namespace fettle::physics_c {

using namespace physics;

namespace {

Geometry default_geometry(ShapeType type) {
    switch (type) {
        case ShapeType::circle:
            return Circle{};
        case ShapeType::box:
            return Box{};
        case ShapeType::segment:
            return Segment{};
        case ShapeType::polygon:
            return Polygon{};
        case ShapeType::ellipse:
            return Ellipse{};
        case ShapeType::concave:
            return Concave{};
        default:
            return Chain{};
    }
}

/// Writes the members that the type of the geometry uses.
void write(const Geometry& geometry, fettle_geometry& result) {
    if (const auto* circle = std::get_if<Circle>(&geometry)) {
        result.radius = circle->radius;
        result.center = converted(circle->center);
    } else if (const auto* box = std::get_if<Box>(&geometry)) {
        result.width = box->width;
        result.height = box->height;
        result.center = converted(box->center);
        result.angle = box->angle;
        result.rounding = box->rounding;
    } else if (const auto* segment = std::get_if<Segment>(&geometry)) {
        result.from = converted(segment->from);
        result.to = converted(segment->to);
        result.rounding = segment->rounding;
    } else if (const auto* polygon = std::get_if<Polygon>(&geometry)) {
        result.point_count = uint32_t(polygon->vertices.size());
        result.rounding = polygon->rounding;
    } else if (const auto* ellipse = std::get_if<Ellipse>(&geometry)) {
        result.radius_x = ellipse->radius_x;
        result.radius_y = ellipse->radius_y;
        result.center = converted(ellipse->center);
        result.angle = ellipse->angle;
    } else if (const auto* concave = std::get_if<Concave>(&geometry)) {
        result.point_count = uint32_t(concave->vertices.size());
    } else if (const auto* chain = std::get_if<Chain>(&geometry)) {
        result.point_count = uint32_t(chain->points.size());
        result.closed = chain->closed;
    }
}

fettle_geometry defaults_of(ShapeType type) {
    fettle_geometry geometry{};
    geometry.size = sizeof geometry;
    geometry.type = int32_t(type);
    write(default_geometry(type), geometry);
    return geometry;
}

ShapeType geometry_type(int32_t type) {
    return enumerator("type", type, ShapeType::chain);
}

}  // namespace

std::vector<Vec2> points_of(const fettle_vec2* points, uint32_t count) {
    constexpr uint32_t most = 1u << 20;
    if (count > most)
        throw Failure{FETTLE_INVALID, "points: expected at most " + std::to_string(most) +
                                          " of them, got " + std::to_string(count)};
    if (count > 0) needed("points", points);
    std::vector<Vec2> result(count);
    for (uint32_t i = 0; i < count; ++i) result[i] = vector_of(points[i]);
    return result;
}

Geometry geometry_of(const fettle_geometry* geometry) {
    const fettle_geometry& given = needed("geometry", geometry);
    check_size(given.size, sizeof given);
    const Vec2 center = vector_of(given.center);
    switch (geometry_type(given.type)) {
        case ShapeType::circle:
            return Circle{given.radius, center};
        case ShapeType::box:
            return Box{given.width, given.height, center, given.angle, given.rounding};
        case ShapeType::segment:
            return Segment{vector_of(given.from), vector_of(given.to), given.rounding};
        case ShapeType::polygon:
            return Polygon{points_of(given.points, given.point_count), given.rounding};
        case ShapeType::ellipse:
            return Ellipse{given.radius_x, given.radius_y, center, given.angle};
        case ShapeType::concave:
            return Concave{points_of(given.points, given.point_count)};
        default:
            return Chain{points_of(given.points, given.point_count), flag(given.closed)};
    }
}

void write_geometry(const Shape& shape, fettle_geometry* geometry) {
    fettle_geometry& target = needed("geometry", geometry);
    check_size(target.size, sizeof target);
    fettle_geometry result = defaults_of(shape.type());
    write(shape.geometry(), result);
    target = result;
}

}  // namespace fettle::physics_c

using namespace fettle::physics_c;

fettle_code fettle_geometry_init(fettle_geometry* geometry, size_t size, int32_t type) {
    return guarded(__func__, [&] {
        fettle_geometry& result = needed("geometry", geometry);
        check_size(size, sizeof result);
        result = defaults_of(geometry_type(type));
    });
}

fettle_code fettle_convex_hull(const fettle_vec2* points, uint32_t point_count, fettle_vec2* out,
                               uint32_t room, uint32_t* count, int32_t* status) {
    return guarded(__func__, [&] {
        int32_t& result = needed("status", status);
        const auto given = points_of(points, point_count);
        std::vector<fettle::physics::Vec2> hull;
        const auto found = fettle::physics::convex_hull(given, hull);
        write_list(hull, out, room, count);
        result = int32_t(found);
    });
}

const char* fettle_describe(int32_t hull_status) {
    using fettle::physics::HullStatus;
    if (hull_status < 0 || hull_status > int32_t(HullStatus::not_finite)) return "unknown";
    return fettle::physics::describe(HullStatus(hull_status));
}
