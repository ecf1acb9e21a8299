#include <geometry/trigonometry.h>
#include <world/live_shape.h>

#include <stdexcept>
#include <string>

// What all shapes have: owner, surface, filter, what is derived. Geometry is in shape_geometry.cpp.

namespace fettle::physics {

using namespace detail;

namespace {

/// What the border takes from the settings of its world would be lost when those are set.
void refuse_border(const ShapeRecord& record, const char* instead) {
    if (record.type == ShapeType::border) [[unlikely]]
        throw std::invalid_argument(std::string("the border of the world: set its ") + instead +
                                    " instead");
}

/// What no setting of the world is for, the border does not have.
void refuse_border_any(const ShapeRecord& record, const char* what) {
    if (record.type == ShapeType::border) [[unlikely]]
        throw std::invalid_argument(std::string(what) +
                                    ": the border of the world has friction and restitution only; "
                                    "set its bounds_friction or bounds_restitution");
}

void surface_changed(WorldData& data, uint32_t shape) {
    share_surface(data, shape);
    if (data.forms[shape].body == none) return;
    remix_shape(data, data.settings, shape);
    wake_for_edit(data.activity(), data.forms[shape].body);
}

/// A filter of the user may read the world: nothing may be out of date when it is called. The
/// refresh callback may throw, so it comes before the edit.
template <class T>
void set_filtering(WorldData& data, uint32_t shape, T ShapeDef::*what, T value) {
    if (data.self.filter) data.read_all();
    data.shapes[shape].surface.*what = value;
    share_surface(data, shape);
    WorldLock lock(data.self, WorldLock::During::change, in_edit);
    detail::refilter(data.editing(), data.user_filter(), shape);
    lock.finish();
}

}  // namespace

bool Shape::is_valid() const {
    return link_ != nullptr && link_->data != nullptr && link_->data->is_valid(id_);
}

WorldData& Shape::live() const {
    return detail::live(link_, id_);
}

World& Shape::world() const {
    live();
    return *link_->world;
}

void Shape::destroy() {
    FETTLE_EDIT_SHAPE
    data.self.may_populate("Shape", __func__);
    refuse_border(record, "bounds");
    detail::destroy_shape(data.editing(), id_.index);
}

ShapeType Shape::type() const {
    FETTLE_LIVE_SHAPE
    return record.type;
}

Body Shape::body() const {
    FETTLE_LIVE_SHAPE
    World* const world = link_->world;
    return form.body == none ? Body(world, {}) : Body(world, data.body_id(form.body));
}

void Shape::attach(const Body& body) {
    FETTLE_EDIT_SHAPE
    data.self.may_populate("Shape", __func__);
    if (record.type == ShapeType::border)
        throw std::invalid_argument("the border of the world belongs to no body");
    if (!body.is_valid()) dangling("body", body.link_, body.index(), body.id().generation);
    if (body.link_ != link_) throw std::invalid_argument("body: expected a body of the same world");
    if (body.index() == 0)
        throw std::invalid_argument("body: the bounds of the world take no other shapes");
    if (form.body == body.index()) return;
    detail::attach_shape(data.editing(), id_.index, body.index());
}

void Shape::detach() {
    FETTLE_EDIT_SHAPE
    data.self.may_populate("Shape", __func__);
    refuse_border(record, "bounds");
    if (form.body != none) detail::detach_shape(data.editing(), id_.index);
}

float Shape::density() const {
    FETTLE_LIVE_SHAPE
    return record.surface.density;
}

void Shape::set_density(float density) {
    FETTLE_EDIT_SHAPE
    refuse_border_any(record, "density");
    record.surface.density = check_not_negative("density", density);
    if (form.body == none) return;
    wake_body(data.activity(), form.body);
    mark_mass(data, data, form.body);
}

float Shape::friction() const {
    FETTLE_LIVE_SHAPE
    return record.surface.friction;
}

void Shape::set_friction(float friction) {
    FETTLE_EDIT_SHAPE
    refuse_border(record, "bounds_friction");
    record.surface.friction = check_not_negative("friction", friction);
    surface_changed(data, id_.index);
}

float Shape::restitution() const {
    FETTLE_LIVE_SHAPE
    return record.surface.restitution;
}

void Shape::set_restitution(float restitution) {
    FETTLE_EDIT_SHAPE
    refuse_border(record, "bounds_restitution");
    record.surface.restitution = check_range("restitution", restitution, 0.0f, 1.0f);
    surface_changed(data, id_.index);
}

float Shape::rolling_resistance() const {
    FETTLE_LIVE_SHAPE
    return record.surface.rolling_resistance;
}

void Shape::set_rolling_resistance(float resistance) {
    FETTLE_EDIT_SHAPE
    refuse_border_any(record, "rolling_resistance");
    record.surface.rolling_resistance = check_not_negative("rolling_resistance", resistance);
    surface_changed(data, id_.index);
}

float Shape::surface_speed() const {
    FETTLE_LIVE_SHAPE
    return record.surface.surface_speed;
}

void Shape::set_surface_speed(float speed) {
    FETTLE_EDIT_SHAPE
    refuse_border_any(record, "surface_speed");
    record.surface.surface_speed = check_finite("surface_speed", speed);
    surface_changed(data, id_.index);
}

bool Shape::sensor() const {
    FETTLE_LIVE_SHAPE
    return record.surface.sensor;
}

void Shape::set_sensor(bool sensor) {
    FETTLE_EDIT_SHAPE
    refuse_border_any(record, "sensor");
    if (record.surface.sensor == sensor) return;
    if (form.body != none) {
        wake_for_edit(data.activity(), form.body);
        wake_touching(data.activity(), form.body);
        destroy_contacts_of_shape(data.contact_list(), id_.index);  // ended as what they were
    }
    record.surface.sensor = sensor;
    share_surface(data, id_.index);
    if (form.body != none)
        data.for_each_solid(id_.index, [&](uint32_t solid) { mark_moved(data, data, solid); });
}

bool Shape::hit_events() const {
    FETTLE_LIVE_SHAPE
    return record.surface.hit_events;
}

void Shape::set_hit_events(bool enabled) {
    FETTLE_EDIT_SHAPE
    refuse_border_any(record, "hit_events");
    record.surface.hit_events = enabled;
    share_surface(data, id_.index);
    remix_shape(data, data.settings, id_.index);
}

uint64_t Shape::category() const {
    FETTLE_LIVE_SHAPE
    return record.surface.category;
}

void Shape::set_category(uint64_t category) {
    FETTLE_EDIT_SHAPE
    refuse_border_any(record, "category");
    set_filtering(data, id_.index, &ShapeDef::category, category);
}

uint64_t Shape::mask() const {
    FETTLE_LIVE_SHAPE
    return record.surface.mask;
}

void Shape::set_mask(uint64_t mask) {
    FETTLE_EDIT_SHAPE
    refuse_border_any(record, "mask");
    set_filtering(data, id_.index, &ShapeDef::mask, mask);
}

int32_t Shape::group() const {
    FETTLE_LIVE_SHAPE
    return record.surface.group;
}

void Shape::set_group(int32_t group) {
    FETTLE_EDIT_SHAPE
    refuse_border_any(record, "group");
    set_filtering(data, id_.index, &ShapeDef::group, group);
}

float Shape::area() const {
    FETTLE_LIVE_SHAPE
    data.read_shape(id_.index);
    return record.area;
}

float Shape::mass() const {
    FETTLE_LIVE_SHAPE
    data.read_shape(id_.index);
    return float(double(record.area) * double(record.surface.density));
}

Aabb Shape::aabb() const {
    FETTLE_LIVE_SHAPE
    data.read_all();
    Box4 box = no_box;
    data.for_each_solid(id_.index, [&](uint32_t s) { box = unite(box, data.boxes[s]); });
    return {to_vec2(box.low), to_vec2(box.high)};
}

std::vector<Vec2> Shape::world_vertices() const {
    FETTLE_LIVE_SHAPE
    data.read_all();
    std::vector<Vec2> all;
    if (!data.is_solid(id_.index)) {
        for (V2 p : data.outline_of(id_.index))
            all.push_back(form.body == none ? to_vec2(p) : body().world_point(to_vec2(p)));
        return all;
    }
    if (form.count < 2) return all;
    if (form.kind == FormKind::large) {
        for (const Vec2& v : vertices())
            all.push_back(form.body == none ? v : body().world_point(v));
        return all;
    }
    const V2 center = form.body == none ? V2{} : data.bodies[form.body].center;
    for (uint32_t i = 0; i < form.count; ++i)
        all.push_back(to_vec2(center + data.pool.vertices[form.begin + i]));
    return all;
}

Vec2 Shape::world_center() const {
    FETTLE_LIVE_SHAPE
    data.read_all();
    const Vec2 local = to_vec2(record.centroid);
    return form.body == none ? local : body().world_point(local);
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
    FETTLE_EDIT_SHAPE
    data.self.may_populate("Shape", __func__);
    record.surface.user_data = value;
}

}  // namespace fettle::physics
