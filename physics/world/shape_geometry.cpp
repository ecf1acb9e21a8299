#include <world/live_shape.h>

#include <stdexcept>
#include <type_traits>

// What a shape looks like: each type has properties of its own.

namespace fettle::physics {

using namespace detail;

namespace {

/// After any change of geometry: wakes whom it concerns, marks what is derived from it.
void geometry_changed(WorldData& data, uint32_t shape) {
    const uint32_t body = data.forms[shape].body;
    if (body != none) {
        wake_for_edit(data.activity(), body);
        wake_touching(data.activity(), body);
    }
    mark_geometry(data, data, shape);
}

/// Of which type a shape is that is such a figure.
template <class Kind>
inline constexpr ShapeType type_of = ShapeType::border;
template <>
inline constexpr ShapeType type_of<Circle> = ShapeType::circle;
template <>
inline constexpr ShapeType type_of<Box> = ShapeType::box;
template <>
inline constexpr ShapeType type_of<Segment> = ShapeType::segment;
template <>
inline constexpr ShapeType type_of<Ellipse> = ShapeType::ellipse;

/// A measure of the figure that the shape is. `name`: as the error calls it for other shapes.
template <class Kind, class T>
T measure(const ShapeRecord& record, const char* name, T Kind::*member) {
    if (record.type != type_of<Kind>) wrong_type(name, record.type);
    return record.figure.as<Kind>().*member;
}

/// The figure is written only if it is sound afterwards.
template <class Kind, class T>
void set_measure(WorldData& data, uint32_t shape, const char* name, T Kind::*member,
                 const std::type_identity_t<T>& value) {
    ShapeRecord& record = data.shapes[shape];
    if (record.type != type_of<Kind>) wrong_type(name, record.type);
    Kind kind = record.figure.as<Kind>();
    kind.*member = value;
    check(Geometry(kind));
    record.figure.become(kind);
    geometry_changed(data, shape);
}

float polygon_rounding(const ShapeRecord& record) {
    return record.figure.as<PolygonFigure>().rounding;
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
            return record.figure.as<Circle>();
        case ShapeType::box:
            return record.figure.as<Box>();
        case ShapeType::segment:
            return record.figure.as<Segment>();
        case ShapeType::polygon: {
            const auto corners = vertices();
            return Polygon{{corners.begin(), corners.end()}, polygon_rounding(record)};
        }
        case ShapeType::ellipse:
            return record.figure.as<Ellipse>();
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
    FETTLE_EDIT_SHAPE
    if (record.type == ShapeType::border) wrong_type("geometry", record.type);
    check(geometry);
    std::vector<Vec2> hull;
    if (const Polygon* polygon = std::get_if<Polygon>(&geometry))
        convex_hull(polygon->vertices, hull);
    geometry_changed(data, id_.index);
    detail::set_form(data.editing(), id_.index, geometry, hull);
}

float Shape::radius() const {
    FETTLE_LIVE_SHAPE
    return measure(record, "radius", &Circle::radius);
}

void Shape::set_radius(float radius) {
    FETTLE_EDIT_SHAPE
    set_measure(data, id_.index, "radius", &Circle::radius, radius);
}

Vec2 Shape::center() const {
    FETTLE_LIVE_SHAPE
    if (record.type == ShapeType::circle) return record.figure.as<Circle>().center;
    if (record.type == ShapeType::box) return record.figure.as<Box>().center;
    return measure(record, "center", &Ellipse::center);
}

void Shape::set_center(const Vec2& center) {
    FETTLE_EDIT_SHAPE
    if (record.type == ShapeType::circle)
        set_measure(data, id_.index, "center", &Circle::center, center);
    else if (record.type == ShapeType::box)
        set_measure(data, id_.index, "center", &Box::center, center);
    else
        set_measure(data, id_.index, "center", &Ellipse::center, center);
}

float Shape::radius_x() const {
    FETTLE_LIVE_SHAPE
    return measure(record, "radius_x", &Ellipse::radius_x);
}
void Shape::set_radius_x(float radius) {
    FETTLE_EDIT_SHAPE
    set_measure(data, id_.index, "radius_x", &Ellipse::radius_x, radius);
}
float Shape::radius_y() const {
    FETTLE_LIVE_SHAPE
    return measure(record, "radius_y", &Ellipse::radius_y);
}
void Shape::set_radius_y(float radius) {
    FETTLE_EDIT_SHAPE
    set_measure(data, id_.index, "radius_y", &Ellipse::radius_y, radius);
}

float Shape::width() const {
    FETTLE_LIVE_SHAPE
    return measure(record, "width", &Box::width);
}
void Shape::set_width(float width) {
    FETTLE_EDIT_SHAPE
    set_measure(data, id_.index, "width", &Box::width, width);
}
float Shape::height() const {
    FETTLE_LIVE_SHAPE
    return measure(record, "height", &Box::height);
}
void Shape::set_height(float height) {
    FETTLE_EDIT_SHAPE
    set_measure(data, id_.index, "height", &Box::height, height);
}
float Shape::angle() const {
    FETTLE_LIVE_SHAPE
    if (record.type == ShapeType::ellipse) return record.figure.as<Ellipse>().angle;
    return measure(record, "angle", &Box::angle);
}
void Shape::set_angle(float angle) {
    FETTLE_EDIT_SHAPE
    if (record.type == ShapeType::ellipse)
        set_measure(data, id_.index, "angle", &Ellipse::angle, angle);
    else
        set_measure(data, id_.index, "angle", &Box::angle, angle);
}

float Shape::rounding() const {
    FETTLE_LIVE_SHAPE
    if (record.type == ShapeType::box) return record.figure.as<Box>().rounding;
    if (record.type == ShapeType::polygon) return polygon_rounding(record);
    return measure(record, "rounding", &Segment::rounding);
}

void Shape::set_rounding(float rounding) {
    FETTLE_EDIT_SHAPE
    if (record.type == ShapeType::box) {
        set_measure(data, id_.index, "rounding", &Box::rounding, rounding);
    } else if (record.type == ShapeType::polygon) {
        record.figure.become(PolygonFigure{check_range("rounding", rounding, 0.0f, 1e6f)});
        geometry_changed(data, id_.index);
    } else {
        set_measure(data, id_.index, "rounding", &Segment::rounding, rounding);
    }
}

Vec2 Shape::from() const {
    FETTLE_LIVE_SHAPE
    return measure(record, "from", &Segment::from);
}
void Shape::set_from(const Vec2& from) {
    FETTLE_EDIT_SHAPE
    set_measure(data, id_.index, "from", &Segment::from, from);
}

Vec2 Shape::to() const {
    FETTLE_LIVE_SHAPE
    return measure(record, "to", &Segment::to);
}
void Shape::set_to(const Vec2& to) {
    FETTLE_EDIT_SHAPE
    set_measure(data, id_.index, "to", &Segment::to, to);
}

std::span<const Vec2> Shape::vertices() const {
    FETTLE_LIVE_SHAPE
    if (!data.is_solid(id_.index)) return as_vectors(data.outline_of(id_.index));
    if (form.count < 2) return {};
    // A polygon's hull was computed when it was written.
    if (record.type != ShapeType::polygon) data.read_shape(id_.index);
    return as_vectors({&data.pool.local[form.begin], form.count});
}

HullStatus Shape::try_set_vertices(std::span<const Vec2> points) {
    FETTLE_EDIT_SHAPE
    if (record.type != ShapeType::polygon) wrong_type("vertices", record.type);
    std::vector<Vec2> hull;
    const HullStatus status = convex_hull(points, hull);
    if (status != HullStatus::ok) return status;
    for (const Vec2& v : hull) check_point("vertices", v);
    geometry_changed(data, id_.index);
    detail::set_form(data.editing(), id_.index, Polygon{{}, polygon_rounding(record)}, hull);
    return status;
}

void Shape::set_vertices(std::span<const Vec2> points) {
    FETTLE_EDIT_SHAPE
    if (record.type == ShapeType::concave || record.type == ShapeType::chain) {
        if (record.type == ShapeType::concave)
            check_outline(points);
        else
            check_chain(points, record.closed);
        geometry_changed(data, id_.index);
        write_outline(data, data, id_.index, points);
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
    FETTLE_EDIT_SHAPE
    if (record.type != ShapeType::chain) wrong_type("closed", record.type);
    check_chain(as_vectors(data.outline_of(id_.index)), closed);
    record.closed = closed;
    geometry_changed(data, id_.index);
}

std::vector<std::vector<Vec2>> Shape::pieces() const {
    FETTLE_LIVE_SHAPE
    std::vector<std::vector<Vec2>> all;
    if (data.is_solid(id_.index)) return all;
    data.read_shape(id_.index);
    data.for_each_solid(id_.index, [&](uint32_t part) {
        all.push_back(list_of({&data.pool.local[data.forms[part].begin], data.forms[part].count}));
    });
    return all;
}

void Shape::add_vertex(const Vec2& point) {
    FETTLE_EDIT_SHAPE
    if (record.type != ShapeType::polygon) wrong_type("add_vertex", record.type);
    const auto corners = vertices();
    std::vector<Vec2> points(corners.begin(), corners.end());
    points.push_back(point);
    set_vertices(points);
}

}  // namespace fettle::physics
