#include <world/live_shape.h>

#include <stdexcept>

// What a shape looks like: each type has properties of its own.

namespace fettle::physics {

using namespace detail;

namespace {

/// After any change of geometry: wakes whom it concerns, marks what is derived from it.
void geometry_changed(WorldData& data, uint32_t shape) {
    const uint32_t body = data.forms[shape].body;
    if (body != none) {
        data.wake_for_edit(body);
        data.wake_touching(body);
    }
    data.mark_geometry(shape);
}

/// The same two floats in either struct.
std::span<const Vec2> as_vectors(std::span<const V2> points) {
    static_assert(sizeof(Vec2) == sizeof(V2) && alignof(Vec2) <= alignof(V2));
    return {reinterpret_cast<const Vec2*>(points.data()), points.size()};
}

std::vector<Vec2> list_of(std::span<const V2> points) {
    const auto all = as_vectors(points);
    return {all.begin(), all.end()};
}

}  // namespace

Geometry Shape::geometry() const {
    FETTLE_LIVE_SHAPE
    switch (record.type) {
        case ShapeType::circle:
            return record.circle;
        case ShapeType::box:
            return record.box;
        case ShapeType::segment:
            return record.segment;
        case ShapeType::polygon: {
            const auto corners = vertices();
            return Polygon{{corners.begin(), corners.end()}, record.polygon_rounding};
        }
        case ShapeType::ellipse:
            return record.ellipse;
        case ShapeType::concave:
            return Concave{list_of(data.outline_of(id_.index))};
        case ShapeType::chain:
            return Chain{list_of(data.outline_of(id_.index)), record.closed};
        case ShapeType::border:
            break;
    }
    wrong_type("geometry", record.type);
}

void Shape::set_geometry(const Geometry& geometry) {
    FETTLE_LIVE_SHAPE
    if (record.type == ShapeType::border) wrong_type("geometry", record.type);
    check(geometry);
    std::vector<Vec2> hull;
    if (const Polygon* polygon = std::get_if<Polygon>(&geometry))
        convex_hull(polygon->vertices, hull);
    geometry_changed(data, id_.index);
    data.set_form(id_.index, geometry, hull);
}

float Shape::radius() const {
    FETTLE_LIVE_SHAPE
    if (record.type != ShapeType::circle) wrong_type("radius", record.type);
    return record.circle.radius;
}

void Shape::set_radius(float radius) {
    FETTLE_LIVE_SHAPE
    if (record.type != ShapeType::circle) wrong_type("radius", record.type);
    Circle circle = record.circle;
    circle.radius = radius;
    check(Geometry(circle));
    record.circle = circle;
    geometry_changed(data, id_.index);
}

Vec2 Shape::center() const {
    FETTLE_LIVE_SHAPE
    if (record.type == ShapeType::circle) return record.circle.center;
    if (record.type == ShapeType::box) return record.box.center;
    if (record.type == ShapeType::ellipse) return record.ellipse.center;
    wrong_type("center", record.type);
}

void Shape::set_center(const Vec2& center) {
    FETTLE_LIVE_SHAPE
    if (record.type == ShapeType::circle) {
        Circle circle = record.circle;
        circle.center = center;
        check(Geometry(circle));
        record.circle = circle;
    } else if (record.type == ShapeType::box) {
        Box box = record.box;
        box.center = center;
        check(Geometry(box));
        record.box = box;
    } else if (record.type == ShapeType::ellipse) {
        Ellipse ellipse = record.ellipse;
        ellipse.center = center;
        check(Geometry(ellipse));
        record.ellipse = ellipse;
    } else {
        wrong_type("center", record.type);
    }
    geometry_changed(data, id_.index);
}

namespace {

float box_value(const ShapeRecord& record, const char* name, float Box::*member) {
    if (record.type != ShapeType::box) wrong_type(name, record.type);
    return record.box.*member;
}

void set_box_value(WorldData& data, uint32_t shape, const char* name, float Box::*member,
                   float value) {
    ShapeRecord& record = data.shapes[shape];
    if (record.type != ShapeType::box) wrong_type(name, record.type);
    Box box = record.box;
    box.*member = value;
    check(Geometry(box));
    record.box = box;
    geometry_changed(data, shape);
}

float ellipse_value(const ShapeRecord& record, const char* name, float Ellipse::*member) {
    if (record.type != ShapeType::ellipse) wrong_type(name, record.type);
    return record.ellipse.*member;
}

void set_ellipse_value(WorldData& data, uint32_t shape, const char* name, float Ellipse::*member,
                       float value) {
    ShapeRecord& record = data.shapes[shape];
    if (record.type != ShapeType::ellipse) wrong_type(name, record.type);
    Ellipse ellipse = record.ellipse;
    ellipse.*member = value;
    check(Geometry(ellipse));
    record.ellipse = ellipse;
    geometry_changed(data, shape);
}

}  // namespace

float Shape::radius_x() const {
    FETTLE_LIVE_SHAPE
    return ellipse_value(record, "radius_x", &Ellipse::radius_x);
}
void Shape::set_radius_x(float radius) {
    FETTLE_LIVE_SHAPE
    set_ellipse_value(data, id_.index, "radius_x", &Ellipse::radius_x, radius);
}
float Shape::radius_y() const {
    FETTLE_LIVE_SHAPE
    return ellipse_value(record, "radius_y", &Ellipse::radius_y);
}
void Shape::set_radius_y(float radius) {
    FETTLE_LIVE_SHAPE
    set_ellipse_value(data, id_.index, "radius_y", &Ellipse::radius_y, radius);
}

float Shape::width() const {
    FETTLE_LIVE_SHAPE
    return box_value(record, "width", &Box::width);
}
void Shape::set_width(float width) {
    FETTLE_LIVE_SHAPE
    set_box_value(data, id_.index, "width", &Box::width, width);
}
float Shape::height() const {
    FETTLE_LIVE_SHAPE
    return box_value(record, "height", &Box::height);
}
void Shape::set_height(float height) {
    FETTLE_LIVE_SHAPE
    set_box_value(data, id_.index, "height", &Box::height, height);
}
float Shape::angle() const {
    FETTLE_LIVE_SHAPE
    if (record.type == ShapeType::ellipse) return record.ellipse.angle;
    return box_value(record, "angle", &Box::angle);
}
void Shape::set_angle(float angle) {
    FETTLE_LIVE_SHAPE
    if (record.type == ShapeType::ellipse)
        set_ellipse_value(data, id_.index, "angle", &Ellipse::angle, angle);
    else
        set_box_value(data, id_.index, "angle", &Box::angle, angle);
}

float Shape::rounding() const {
    FETTLE_LIVE_SHAPE
    switch (record.type) {
        case ShapeType::box:
            return record.box.rounding;
        case ShapeType::segment:
            return record.segment.rounding;
        case ShapeType::polygon:
            return record.polygon_rounding;
        default:
            wrong_type("rounding", record.type);
    }
}

void Shape::set_rounding(float rounding) {
    FETTLE_LIVE_SHAPE
    if (record.type == ShapeType::box) {
        set_box_value(data, id_.index, "rounding", &Box::rounding, rounding);
        return;
    }
    if (record.type == ShapeType::segment) {
        Segment segment = record.segment;
        segment.rounding = rounding;
        check(Geometry(segment));
        record.segment = segment;
    } else if (record.type == ShapeType::polygon) {
        record.polygon_rounding = check_range("rounding", rounding, 0.0f, 1e6f);
    } else {
        wrong_type("rounding", record.type);
    }
    geometry_changed(data, id_.index);
}

Vec2 Shape::from() const {
    FETTLE_LIVE_SHAPE
    if (record.type != ShapeType::segment) wrong_type("from", record.type);
    return record.segment.from;
}

Vec2 Shape::to() const {
    FETTLE_LIVE_SHAPE
    if (record.type != ShapeType::segment) wrong_type("to", record.type);
    return record.segment.to;
}

namespace {

void set_end(WorldData& data, uint32_t shape, const char* name, Vec2 Segment::*end,
             const Vec2& value) {
    ShapeRecord& record = data.shapes[shape];
    if (record.type != ShapeType::segment) wrong_type(name, record.type);
    Segment segment = record.segment;
    segment.*end = value;
    check(Geometry(segment));
    record.segment = segment;
    geometry_changed(data, shape);
}

}  // namespace

void Shape::set_from(const Vec2& from) {
    FETTLE_LIVE_SHAPE
    set_end(data, id_.index, "from", &Segment::from, from);
}

void Shape::set_to(const Vec2& to) {
    FETTLE_LIVE_SHAPE
    set_end(data, id_.index, "to", &Segment::to, to);
}

std::span<const Vec2> Shape::vertices() const {
    FETTLE_LIVE_SHAPE
    if (!data.is_solid(id_.index)) return as_vectors(data.outline_of(id_.index));
    if (form.count < 2) return {};
    // A polygon's hull was computed when it was written.
    if (record.type != ShapeType::polygon) data.refresh_shape(id_.index);
    return as_vectors({&data.pool.local[form.begin], form.count});
}

HullStatus Shape::try_set_vertices(std::span<const Vec2> points) {
    FETTLE_LIVE_SHAPE
    if (record.type != ShapeType::polygon) wrong_type("vertices", record.type);
    std::vector<Vec2> hull;
    const HullStatus status = convex_hull(points, hull);
    if (status != HullStatus::ok) return status;
    for (const Vec2& v : hull) check_range("vertices", v.lpNorm<Eigen::Infinity>(), 0.0f, 1e6f);
    geometry_changed(data, id_.index);
    data.set_form(id_.index, Polygon{{}, record.polygon_rounding}, hull);
    return status;
}

void Shape::set_vertices(std::span<const Vec2> points) {
    FETTLE_LIVE_SHAPE
    if (record.type == ShapeType::concave || record.type == ShapeType::chain) {
        if (record.type == ShapeType::concave)
            check_outline(points);
        else
            check_chain(points, record.closed);
        geometry_changed(data, id_.index);
        data.write_outline(id_.index, points);
        return;
    }
    const HullStatus status = try_set_vertices(points);
    if (status != HullStatus::ok)
        throw std::invalid_argument(std::string("vertices: ") + describe(status));
}

bool Shape::closed() const {
    FETTLE_LIVE_SHAPE
    if (record.type != ShapeType::chain) wrong_type("closed", record.type);
    return record.closed;
}

void Shape::set_closed(bool closed) {
    FETTLE_LIVE_SHAPE
    if (record.type != ShapeType::chain) wrong_type("closed", record.type);
    record.closed = closed;
    geometry_changed(data, id_.index);
}

std::vector<std::vector<Vec2>> Shape::pieces() const {
    FETTLE_LIVE_SHAPE
    std::vector<std::vector<Vec2>> all;
    if (data.is_solid(id_.index)) return all;
    data.refresh_shape(id_.index);
    data.for_each_solid(id_.index, [&](uint32_t part) {
        all.push_back(list_of({&data.pool.local[data.forms[part].begin], data.forms[part].count}));
    });
    return all;
}

void Shape::add_vertex(const Vec2& point) {
    FETTLE_LIVE_SHAPE
    if (record.type != ShapeType::polygon) wrong_type("add_vertex", record.type);
    const auto corners = vertices();
    std::vector<Vec2> points(corners.begin(), corners.end());
    points.push_back(point);
    set_vertices(points);
}

}  // namespace fettle::physics
