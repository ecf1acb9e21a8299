#include <handles/live.h>
#include <step/shape_box.h>

// Mass and size of a body: computed from its shapes, or overridden.

namespace fettle::physics {

using namespace detail;

namespace {

std::optional<float> if_given(float value) {
    return is_given(value) ? std::optional(value) : std::nullopt;
}

}  // namespace

FETTLE_BODY_DERIVED(float, mass, record.mass)
FETTLE_BODY_DERIVED(float, inertia, record.inertia)
FETTLE_BODY_DERIVED(Vec2, center, record.local_center)
FETTLE_BODY_DERIVED(Position, world_center, record.center)
FETTLE_BODY_READ(std::optional<float>, mass_override, if_given(record.given.mass))
FETTLE_BODY_READ(std::optional<float>, inertia_override, if_given(record.given.inertia))
FETTLE_BODY_READ(uint32_t, rebuilds, record.rebuilds)

void Body::set_mass(std::optional<float> mass) {
    FETTLE_EDIT_BODY
    record.given.mass = check_inertial("mass", mass).value_or(not_given);
    data.change<wake_for_edit>(id_.index);
    data.change<mark_mass>(id_.index);
}

void Body::set_inertia(std::optional<float> inertia) {
    FETTLE_EDIT_BODY
    record.given.inertia = check_inertial("inertia", inertia).value_or(not_given);
    data.change<wake_body>(id_.index);
    data.change<mark_mass>(id_.index);
}

void Body::set_center(std::optional<Vec2> center) {
    FETTLE_EDIT_BODY
    record.given.center =
        center ? check_coordinates("center", *center) : Vec2{not_given, not_given};
    data.change<wake_body>(id_.index);
    data.change<mark_mass>(id_.index);
}

std::optional<Vec2> Body::center_override() const {
    FETTLE_LIVE_BODY
    if (!is_given(record.given.center.x)) return std::nullopt;
    return record.given.center;
}

float Body::area() const {
    FETTLE_LIVE_BODY
    data.read_mass(id_.index);
    float area = 0.0f;
    for (uint32_t s = record.lists.first_shape; s != none; s = data.shapes[s].next)
        if (data.shapes[s].owner == none) area += data.shapes[s].area;
    return area;
}

Aabb Body::aabb() const {
    FETTLE_LIVE_BODY
    data.read_all();
    if (record.lists.first_shape == none) return {state.position, state.position};
    Aabb all = {no_box.low, no_box.high};
    for (uint32_t s = record.lists.first_shape; s != none; s = data.shapes[s].next)
        if (data.is_solid(s)) add_box(all, box_of_shape(data, data, data.boxes, s));
    return all;
}

}  // namespace fettle::physics
