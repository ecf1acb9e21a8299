#include <world/live_body.h>

// What a body weighs and how large it is: derived from its shapes, or overridden.

namespace fettle::physics {

using namespace detail;

float Body::mass() const {
    FETTLE_LIVE_BODY
    data.read_mass(id_.index);
    return record.mass;
}

void Body::set_mass(std::optional<float> mass) {
    FETTLE_LIVE_BODY
    record.mass_override = check_inertial("mass", mass);
    data.wake_for_edit(id_.index);
    data.mark_mass(id_.index);
}

std::optional<float> Body::mass_override() const {
    FETTLE_LIVE_BODY
    return record.mass_override;
}

float Body::inertia() const {
    FETTLE_LIVE_BODY
    data.read_mass(id_.index);
    return record.inertia;
}

void Body::set_inertia(std::optional<float> inertia) {
    FETTLE_LIVE_BODY
    record.inertia_override = check_inertial("inertia", inertia);
    data.wake_body(id_.index);
    data.mark_mass(id_.index);
}

std::optional<float> Body::inertia_override() const {
    FETTLE_LIVE_BODY
    return record.inertia_override;
}

Vec2 Body::center() const {
    FETTLE_LIVE_BODY
    data.read_mass(id_.index);
    return to_vec2(record.local_center);
}

void Body::set_center(std::optional<Vec2> center) {
    FETTLE_LIVE_BODY
    std::optional<V2> wanted;
    if (center) wanted = to_v2(check_coordinates("center", *center));
    record.center_override = wanted;
    data.wake_body(id_.index);
    data.mark_mass(id_.index);
}

std::optional<Vec2> Body::center_override() const {
    FETTLE_LIVE_BODY
    if (!record.center_override) return std::nullopt;
    return to_vec2(*record.center_override);
}

Vec2 Body::world_center() const {
    FETTLE_LIVE_BODY
    data.read_mass(id_.index);
    return to_vec2(record.center);
}

float Body::area() const {
    FETTLE_LIVE_BODY
    data.read_mass(id_.index);
    return record.area;
}

Aabb Body::aabb() const {
    FETTLE_LIVE_BODY
    data.read_all();
    if (record.first_shape == none) return {state.position, state.position};
    Box4 box = no_box;
    for (uint32_t s = record.first_shape; s != none; s = data.shapes[s].next)
        if (data.is_solid(s)) box = unite(box, data.boxes[s]);
    return {to_vec2(box.low), to_vec2(box.high)};
}

uint32_t Body::rebuilds() const {
    FETTLE_LIVE_BODY
    return record.rebuilds;
}

namespace {

[[gnu::noinline]] float edited_mass(WorldData& data, uint32_t index) {
    data.read_mass(index);
    return data.bodies[index].mass;
}

}  // namespace

float World::mass(uint32_t index) const {
    const BodyRecord& record = data_->bodies[index];
    if (record.listed) [[unlikely]]
        return edited_mass(*data_, index);
    return record.mass;
}

}  // namespace fettle::physics
