#include <handles/live.h>

#include <stdexcept>
#include <type_traits>

// Geometry of a shape: each type has its own properties.

namespace fettle::physics {

using namespace detail;

namespace {

/// Must be called after any change of geometry: wakes the affected bodies and marks derived data as
/// outdated.
void geometry_changed(WorldData& data, uint32_t shape) {
    const uint32_t body = data.forms[shape].body;
    if (body != none) {
        data.change<wake_for_edit>(body);
        data.change<wake_touching>(body);
    }
    data.change<mark_geometry>(shape);
}

/// The type of a shape with that figure.
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

/// A value of the figure, if the shape has one of the given figures. `name`: name of the value in
/// errors for other shapes.
template <class Kind, class T, class... Others>
T measure(const ShapeRecord& record, const char* name, T Kind::*member, Others... others) {
    if (record.type == type_of<Kind>) return record.figure.as<Kind>().*member;
    if constexpr (sizeof...(others) > 0)
        return measure(record, name, others...);
    else
        refuse_wrong_type(name, record.type);
}

/// The figure is written only if it is valid with the new value.
template <class Kind, class T, class... Others>
void set_measure(WorldData& data, uint32_t shape, const char* name,
                 const std::type_identity_t<T>& value, T Kind::*member, Others... others) {
    ShapeRecord& record = data.shapes[shape];
    if (record.type == type_of<Kind>) {
        Kind kind = record.figure.as<Kind>();
        kind.*member = value;
        check(Geometry(kind));
        record.figure.become(kind);
        geometry_changed(data, shape);
    } else if constexpr (sizeof...(others) > 0) {
        set_measure(data, shape, name, value, others...);
    } else {
        refuse_wrong_type(name, record.type);
    }
}

float polygon_rounding(const ShapeRecord& record) {
    return record.figure.as<PolygonFigure>().rounding;
}

std::vector<Vec2> list_of(std::span<const Vec2> points) {
    return {points.begin(), points.end()};
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
    refuse_wrong_type("geometry", record.type);
}

void Shape::set_geometry(const Geometry& geometry) {
    FETTLE_EDIT_SHAPE
    if (record.type == ShapeType::border) refuse_wrong_type("geometry", record.type);
    const auto type = static_cast<ShapeType>(geometry.index());
    if (type != record.type) data.self.may_populate("Shape", "set_geometry of another type");
    check(geometry);
    std::vector<Vec2> hull;
    if (const Polygon* polygon = std::get_if<Polygon>(&geometry))
        convex_hull(polygon->vertices, hull);
    geometry_changed(data, id_.index);
    data.change<detail::set_form>(id_.index, geometry, hull);
}

#define FETTLE_MEASURE(Value, Argument, name, ...)               \
    Value Shape::name() const {                                  \
        FETTLE_LIVE_SHAPE                                        \
        return measure(record, #name, __VA_ARGS__);              \
    }                                                            \
    void Shape::set_##name(Argument value) {                     \
        FETTLE_EDIT_SHAPE                                        \
        set_measure(data, id_.index, #name, value, __VA_ARGS__); \
    }
FETTLE_MEASURE(float, float, radius, &Circle::radius)
FETTLE_MEASURE(float, float, radius_x, &Ellipse::radius_x)
FETTLE_MEASURE(float, float, radius_y, &Ellipse::radius_y)
FETTLE_MEASURE(float, float, width, &Box::width)
FETTLE_MEASURE(float, float, height, &Box::height)
FETTLE_MEASURE(float, float, angle, &Ellipse::angle, &Box::angle)
FETTLE_MEASURE(Vec2, const Vec2&, center, &Circle::center, &Box::center, &Ellipse::center)
FETTLE_MEASURE(Vec2, const Vec2&, from, &Segment::from)
FETTLE_MEASURE(Vec2, const Vec2&, to, &Segment::to)

float Shape::rounding() const {
    FETTLE_LIVE_SHAPE
    if (record.type == ShapeType::polygon) return polygon_rounding(record);
    return measure(record, "rounding", &Box::rounding, &Segment::rounding);
}

void Shape::set_rounding(float rounding) {
    FETTLE_EDIT_SHAPE
    if (record.type != ShapeType::polygon)
        return set_measure(data, id_.index, "rounding", rounding, &Box::rounding,
                           &Segment::rounding);
    record.figure.become(PolygonFigure{check_range("rounding", rounding, 0.0f, 1e6f)});
    geometry_changed(data, id_.index);
}

std::span<const Vec2> Shape::vertices() const {
    WorldData& data = live();
    if (!data.is_solid(id_.index)) return data.outline_of(id_.index);
    if (data.forms[id_.index].count < 2) return {};
    // The hull of a polygon was computed when it was written. The refresh callback may read other
    // shapes, which moves all records, so no reference is taken before it.
    if (data.shapes[id_.index].type != ShapeType::polygon) data.read_shape(id_.index);
    const ShapeForm& form = data.forms[id_.index];
    return {&data.pool.local[form.begin], form.count};
}

HullStatus Shape::try_set_vertices(std::span<const Vec2> points) {
    FETTLE_EDIT_SHAPE
    if (record.type != ShapeType::polygon) refuse_wrong_type("vertices", record.type);
    std::vector<Vec2> hull;
    const HullStatus status = convex_hull(points, hull);
    if (status != HullStatus::ok) return status;
    check_vertices(points);
    geometry_changed(data, id_.index);
    data.change<detail::set_form>(id_.index, Polygon{{}, polygon_rounding(record)}, hull);
    return status;
}

void Shape::set_vertices(std::span<const Vec2> given) {
    // A copy, because `given` may be in the memory of the world, which is written below.
    const std::vector<Vec2> points(given.begin(), given.end());
    FETTLE_EDIT_SHAPE
    if (record.type == ShapeType::concave || record.type == ShapeType::chain) {
        if (record.type == ShapeType::concave)
            check_outline(points);
        else
            check_chain(points, record.closed);
        geometry_changed(data, id_.index);
        data.change<write_outline>(id_.index, points);
        // The number of its parts is not known before they are made.
        if (record.type == ShapeType::concave) data.change<detail::refresh_shape>(id_.index);
        return;
    }
    check_vertices(points);
    const HullStatus status = try_set_vertices(points);
    if (status != HullStatus::ok)
        throw std::invalid_argument(std::string("vertices: ") + describe(status));
}

bool Shape::closed() const {
    FETTLE_LIVE_SHAPE
    if (record.type != ShapeType::chain) refuse_wrong_type("closed", record.type);
    return record.closed;
}

void Shape::set_closed(bool closed) {
    FETTLE_EDIT_SHAPE
    if (record.type != ShapeType::chain) refuse_wrong_type("closed", record.type);
    check_chain(data.outline_of(id_.index), closed);
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
    if (record.type != ShapeType::polygon) refuse_wrong_type("add_vertex", record.type);
    const auto corners = vertices();
    std::vector<Vec2> points(corners.begin(), corners.end());
    points.push_back(point);
    set_vertices(points);
}

}  // namespace fettle::physics
