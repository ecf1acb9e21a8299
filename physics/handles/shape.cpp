#include <contacts/mixing.h>
#include <handles/live.h>
#include <step/shape_box.h>

#include <stdexcept>
#include <string>

// Common methods of all shapes: owner, surface, filter, derived data. Geometry is in
// shape_geometry.cpp.

namespace fettle::physics {

using namespace detail;

namespace {

/// Throws for a value of the border that comes from the settings of its world: a later change of
/// the settings would overwrite it. `instead`: the setter of the world.
void refuse_border(const ShapeRecord& record, const char* instead) {
    if (record.type == ShapeType::border) [[unlikely]]
        throw std::invalid_argument(std::string("the border of the world: set its ") + instead +
                                    " instead");
}

/// Throws for a value that the border does not have, because no setting of the world corresponds to
/// it.
void refuse_border_any(const ShapeRecord& record, const char* what) {
    if (record.type == ShapeType::border) [[unlikely]]
        throw std::invalid_argument(std::string(what) +
                                    ": the border of the world has friction and restitution only; "
                                    "set its bounds_friction or bounds_restitution");
}

/// A user's filter may read the world, so no data may be out of date when it is called. The refresh
/// callback may throw, so it comes before the edit.
template <class T>
void set_filtering(WorldData& data, uint32_t shape, T ShapeDef::*what, T value) {
    if (data.self.filter) data.read_all();
    data.shapes[shape].surface.*what = value;
    copy_surface_to_parts(data, shape);
    WorldLock lock(data.self, WorldLock::During::change, in_edit);
    data.change<detail::refilter>(data.user_filter(), shape);
    lock.finish();
}

}  // namespace

void detail::surface_changed(WorldData& data, uint32_t shape) {
    copy_surface_to_parts(data, shape);
    if (data.forms[shape].body == none) return;
    remix_shape(data, data.settings, shape);
    data.change<wake_for_edit>(data.forms[shape].body);
}

bool Shape::is_valid() const noexcept {
    return link_ != nullptr && link_->data != nullptr && link_->data->is_valid(id_);
}

WorldData& Shape::live() const {
    return detail::live(link_, id_, "shape");
}

World& Shape::world() const {
    live();
    return *link_->world;
}

void Shape::destroy() {
    FETTLE_EDIT_SHAPE
    data.self.may_populate("Shape", __func__);
    refuse_border(record, "bounds");
    data.change<detail::destroy_shape>(id_.index);
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
    if (!body.is_valid()) refuse_dangling("body", body.link_, body.index(), body.id().generation);
    if (body.link_ != link_) throw std::invalid_argument("body: expected a body of the same world");
    if (body.index() == 0)
        throw std::invalid_argument("body: the bounds of the world take no other shapes");
    if (form.body == body.index()) return;
    data.change<detail::attach_shape>(id_.index, body.index());
}

void Shape::detach() {
    FETTLE_EDIT_SHAPE
    data.self.may_populate("Shape", __func__);
    refuse_border(record, "bounds");
    if (form.body != none) data.change<detail::detach_shape>(id_.index);
}

FETTLE_SHAPE_READ(ShapeType, type, record.type)
FETTLE_SHAPE_READ(float, density, record.surface.density)
FETTLE_SHAPE_READ(bool, sensor, record.surface.sensor)
FETTLE_SHAPE_READ(bool, hit_events, record.surface.hit_events)
FETTLE_SHAPE_READ(bool, contact_events, record.surface.contact_events)
FETTLE_SHAPE_READ(bool, sensor_events, record.surface.sensor_events)
FETTLE_SHAPE_READ(bool, before_solve, record.surface.before_solve)
FETTLE_SHAPE_READ(uint16_t, material, record.surface.material)
FETTLE_SHAPE_READ(bool, is_touching, record.touching > 0)
FETTLE_SHAPE_READ(uint32_t, rebuilds, record.rebuilds)
FETTLE_SHAPE_READ(uint64_t, user_data, record.surface.user_data)

// Defines a number of the surface. `refuse` is called for the border; `checked` is the checked
// value.
#define FETTLE_SURFACE(name, refuse, checked)           \
    FETTLE_SHAPE_READ(float, name, record.surface.name) \
    void Shape::set_##name(float value) {               \
        FETTLE_EDIT_SHAPE                               \
        refuse;                                         \
        record.surface.name = checked;                  \
        surface_changed(data, id_.index);               \
    }
FETTLE_SURFACE(friction, refuse_border(record, "bounds_friction"),
               check_not_negative("friction", value))
FETTLE_SURFACE(restitution, refuse_border(record, "bounds_restitution"),
               check_range("restitution", value, 0.0f, 1.0f))
FETTLE_SURFACE(rolling_resistance, refuse_border_any(record, "rolling_resistance"),
               check_not_negative("rolling_resistance", value))
FETTLE_SURFACE(surface_speed, refuse_border_any(record, "surface_speed"),
               check_finite("surface_speed", value))

#define FETTLE_FILTER(Value, name)                              \
    FETTLE_SHAPE_READ(Value, name, record.surface.name)         \
    void Shape::set_##name(Value value) {                       \
        FETTLE_EDIT_SHAPE                                       \
        refuse_border_any(record, #name);                       \
        set_filtering(data, id_.index, &ShapeDef::name, value); \
    }
FETTLE_FILTER(uint64_t, category)
FETTLE_FILTER(uint64_t, mask)
FETTLE_FILTER(int32_t, group)

void Shape::set_density(float density) {
    FETTLE_EDIT_SHAPE
    refuse_border_any(record, "density");
    record.surface.density = check_not_negative("density", density);
    if (form.body == none) return;
    data.change<wake_body>(form.body);
    data.change<mark_mass>(form.body);
}

void Shape::set_sensor(bool sensor) {
    FETTLE_EDIT_SHAPE
    refuse_border_any(record, "sensor");
    if (record.surface.sensor == sensor) return;
    if (form.body != none) {
        data.change<wake_for_edit>(form.body);
        data.change<wake_touching>(form.body);
        // The contacts end with their old kind, as sensor contacts or not.
        data.change<destroy_contacts_of_shape>(id_.index);
    }
    record.surface.sensor = sensor;
    data.sensors += sensor ? 1u : ~0u;  // ± 1, modulo 2³²
    copy_surface_to_parts(data, id_.index);
    if (form.body != none) data.change<mark_refiltered>(id_.index);
}

void Shape::set_hit_events(bool enabled) {
    FETTLE_EDIT_SHAPE
    refuse_border_any(record, "hit_events");
    record.surface.hit_events = enabled;
    copy_surface_to_parts(data, id_.index);
    remix_shape(data, data.settings, id_.index);
}

// Defines the setter of a value of the surface that does not change the simulation.
#define FETTLE_SURFACE_OPTION(Value, name)      \
    void Shape::set_##name(Value value) {       \
        FETTLE_EDIT_SHAPE                       \
        refuse_border_any(record, #name);       \
        record.surface.name = value;            \
        copy_surface_to_parts(data, id_.index); \
    }
FETTLE_SURFACE_OPTION(bool, contact_events)
FETTLE_SURFACE_OPTION(bool, sensor_events)
FETTLE_SURFACE_OPTION(bool, before_solve)
FETTLE_SURFACE_OPTION(uint16_t, material)

float Shape::area() const {
    FETTLE_REFRESHED_SHAPE(read_shape(id_.index))
    return record.area;
}

float Shape::mass() const {
    FETTLE_REFRESHED_SHAPE(read_shape(id_.index))
    return float(double(record.area) * double(record.surface.density));
}

Aabb Shape::aabb() const {
    FETTLE_REFRESHED_SHAPE(read_all())
    Aabb all = {no_box.low, no_box.high};
    data.for_each_solid(id_.index,
                        [&](uint32_t s) { add_box(all, box_of_shape(data, data, data.boxes, s)); });
    return all;
}

std::vector<Position> Shape::world_vertices() const {
    FETTLE_REFRESHED_SHAPE(read_all())
    std::vector<Position> all;
    if (!data.is_solid(id_.index)) {
        for (Vec2 p : data.outline_of(id_.index))
            all.push_back(form.body == none ? Position(p) : body().world_point(p));
        return all;
    }
    if (form.count < 2) return all;
    if (form.kind == FormKind::large) {
        for (const Vec2& v : vertices())
            all.push_back(form.body == none ? Position(v) : body().world_point(v));
        return all;
    }
    const Position center = form.body == none ? Position{} : data.bodies[form.body].center;
    for (uint32_t i = 0; i < form.count; ++i)
        all.push_back(center + data.pool.vertices[form.begin + i]);
    return all;
}

Position Shape::world_center() const {
    FETTLE_REFRESHED_SHAPE(read_all())
    const Vec2 local = record.centroid;
    return form.body == none ? Position(local) : body().world_point(local);
}

void Shape::set_user_data(uint64_t value) {
    FETTLE_EDIT_SHAPE
    data.self.may_populate("Shape", __func__);
    record.surface.user_data = value;
}

}  // namespace fettle::physics
