#include <geometry/trigonometry.h>
#include <world/arguments.h>
#include <world/world_data.h>

#include <stdexcept>

namespace fettle::physics {

using namespace detail;

namespace {

WorldData& live(World* world, WorldData* data, ShapeId id) {
    if (world == nullptr || !world->is_valid(id)) dangling("shape", id.index, id.generation);
    return *data;
}

/// After any change of geometry: wakes whom it concerns, marks what is derived from it.
void geometry_changed(WorldData& data, uint32_t shape) {
    const uint32_t body = data.forms[shape].body;
    if (body != none) {
        data.wake_for_edit(body);
        data.wake_touching(body);
    }
    data.mark_geometry(shape);
}

void surface_changed(WorldData& data, uint32_t shape) {
    if (data.forms[shape].body == none) return;
    data.remix_shape(shape);
    data.wake_for_edit(data.forms[shape].body);
}

}  // namespace

#define FETTLE_LIVE_SHAPE                                                        \
    WorldData& data = live(world_, world_ ? world_->data_.get() : nullptr, id_); \
    [[maybe_unused]] ShapeRecord& record = data.shapes[id_.index];               \
    [[maybe_unused]] ShapeForm& form = data.forms[id_.index];

bool Shape::is_valid() const {
    return world_ != nullptr && world_->is_valid(id_);
}

void Shape::destroy() {
    FETTLE_LIVE_SHAPE
    if (record.type == ShapeType::border)
        throw std::invalid_argument("the border of the world: set its bounds instead");
    data.destroy_shape(id_.index);
}

ShapeType Shape::type() const {
    FETTLE_LIVE_SHAPE
    return record.type;
}

Body Shape::body() const {
    FETTLE_LIVE_SHAPE
    return form.body == none ? Body(world_, {}) : Body(world_, data.body_id(form.body));
}

void Shape::attach(const Body& body) {
    FETTLE_LIVE_SHAPE
    if (record.type == ShapeType::border)
        throw std::invalid_argument("the border of the world belongs to no body");
    if (!world_->is_valid(body.id())) dangling("body", body.index(), body.id().generation);
    if (&body.world() != world_)
        throw std::invalid_argument("body: expected a body of the same world");
    if (form.body == body.index()) return;
    data.attach_shape(id_.index, body.index());
}

void Shape::detach() {
    FETTLE_LIVE_SHAPE
    if (record.type == ShapeType::border || form.body == none) return;
    data.detach_shape(id_.index);
}

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

}  // namespace

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
    return box_value(record, "angle", &Box::angle);
}
void Shape::set_angle(float angle) {
    FETTLE_LIVE_SHAPE
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
    if (record.type == ShapeType::circle || form.count == 0) return {};
    // A polygon's hull was computed when it was written.
    if (record.type != ShapeType::polygon) data.refresh_shape(id_.index);
    // The same two floats in either struct.
    static_assert(sizeof(Vec2) == sizeof(V2) && alignof(Vec2) <= alignof(V2));
    return {reinterpret_cast<const Vec2*>(&data.pool.local[form.begin]), form.count};
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
    const HullStatus status = try_set_vertices(points);
    if (status != HullStatus::ok)
        throw std::invalid_argument(std::string("vertices: ") + describe(status));
}

void Shape::add_vertex(const Vec2& point) {
    const auto corners = vertices();
    std::vector<Vec2> points(corners.begin(), corners.end());
    points.push_back(point);
    set_vertices(points);
}

float Shape::density() const {
    FETTLE_LIVE_SHAPE
    return record.surface.density;
}

void Shape::set_density(float density) {
    FETTLE_LIVE_SHAPE
    record.surface.density = check_not_negative("density", density);
    if (form.body == none) return;
    data.wake_body(form.body);
    data.mark_mass(form.body);
}

float Shape::friction() const {
    FETTLE_LIVE_SHAPE
    return record.surface.friction;
}

void Shape::set_friction(float friction) {
    FETTLE_LIVE_SHAPE
    record.surface.friction = check_not_negative("friction", friction);
    surface_changed(data, id_.index);
}

float Shape::restitution() const {
    FETTLE_LIVE_SHAPE
    return record.surface.restitution;
}

void Shape::set_restitution(float restitution) {
    FETTLE_LIVE_SHAPE
    record.surface.restitution = check_range("restitution", restitution, 0.0f, 1.0f);
    surface_changed(data, id_.index);
}

float Shape::rolling_resistance() const {
    FETTLE_LIVE_SHAPE
    return record.surface.rolling_resistance;
}

void Shape::set_rolling_resistance(float resistance) {
    FETTLE_LIVE_SHAPE
    record.surface.rolling_resistance = check_not_negative("rolling_resistance", resistance);
    surface_changed(data, id_.index);
}

float Shape::surface_speed() const {
    FETTLE_LIVE_SHAPE
    return record.surface.surface_speed;
}

void Shape::set_surface_speed(float speed) {
    FETTLE_LIVE_SHAPE
    record.surface.surface_speed = check_finite("surface_speed", speed);
    surface_changed(data, id_.index);
}

bool Shape::sensor() const {
    FETTLE_LIVE_SHAPE
    return record.surface.sensor;
}

void Shape::set_sensor(bool sensor) {
    FETTLE_LIVE_SHAPE
    if (record.surface.sensor == sensor) return;
    if (form.body != none) {
        data.wake_for_edit(form.body);
        data.wake_touching(form.body);
        data.destroy_contacts_of_shape(id_.index);  // ended as what they were
    }
    record.surface.sensor = sensor;
    if (form.body != none) data.mark_moved(id_.index);
}

bool Shape::hit_events() const {
    FETTLE_LIVE_SHAPE
    return record.surface.hit_events;
}

void Shape::set_hit_events(bool enabled) {
    FETTLE_LIVE_SHAPE
    record.surface.hit_events = enabled;
    data.remix_shape(id_.index);
}

uint64_t Shape::category() const {
    FETTLE_LIVE_SHAPE
    return record.surface.category;
}

void Shape::set_category(uint64_t category) {
    FETTLE_LIVE_SHAPE
    record.surface.category = category;
    data.refilter(id_.index);
}

uint64_t Shape::mask() const {
    FETTLE_LIVE_SHAPE
    return record.surface.mask;
}

void Shape::set_mask(uint64_t mask) {
    FETTLE_LIVE_SHAPE
    record.surface.mask = mask;
    data.refilter(id_.index);
}

int32_t Shape::group() const {
    FETTLE_LIVE_SHAPE
    return record.surface.group;
}

void Shape::set_group(int32_t group) {
    FETTLE_LIVE_SHAPE
    record.surface.group = group;
    data.refilter(id_.index);
}

float Shape::area() const {
    FETTLE_LIVE_SHAPE
    data.refresh_shape(id_.index);
    return float(record.moments.area);
}

float Shape::mass() const {
    FETTLE_LIVE_SHAPE
    data.refresh_shape(id_.index);
    return float(record.moments.area * double(record.surface.density));
}

Aabb Shape::aabb() const {
    FETTLE_LIVE_SHAPE
    data.refresh();
    return {to_vec2(data.boxes[id_.index].low), to_vec2(data.boxes[id_.index].high)};
}

std::vector<Vec2> Shape::world_vertices() const {
    FETTLE_LIVE_SHAPE
    data.refresh();
    std::vector<Vec2> all;
    if (record.type == ShapeType::circle) return all;
    const V2 center = form.body == none ? V2{} : data.bodies[form.body].center;
    for (uint32_t i = 0; i < form.count; ++i)
        all.push_back(to_vec2(center + data.pool.vertices[form.begin + i]));
    return all;
}

Vec2 Shape::world_center() const {
    FETTLE_LIVE_SHAPE
    data.refresh();
    const Vec2 local = {float(record.moments.center_x), float(record.moments.center_y)};
    return form.body == none ? local : body().world_point(local);
}

bool Shape::contains(const Vec2& world_point) const {
    FETTLE_LIVE_SHAPE
    data.refresh();
    return form.count > 0 && data.shape_contains(id_.index, to_v2(world_point));
}

bool Shape::is_touching() const {
    FETTLE_LIVE_SHAPE
    return record.touching > 0;
}

uint32_t Shape::rebuilds() const {
    FETTLE_LIVE_SHAPE
    return record.rebuilds;
}

uint64_t Shape::user_data() const {
    FETTLE_LIVE_SHAPE
    return record.surface.user_data;
}

void Shape::set_user_data(uint64_t value) {
    FETTLE_LIVE_SHAPE
    record.surface.user_data = value;
}

#undef FETTLE_LIVE_SHAPE

}  // namespace fettle::physics
