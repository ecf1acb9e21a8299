// Functions for hosts that store slots: the values that they read and write most. They do not check
// that the body lives. They refuse a slot beyond the last one, because memory there is not of the
// world.

#include <fettle/physics/host_access.h>
#include <geometry/bits.h>
#include <handles/live.h>
#include <world/world_data.h>

#include <stdexcept>
#include <string>

namespace fettle::physics {

using namespace detail;

void HostAccess::refuse(uint32_t slot, size_t slots) {
    throw std::invalid_argument("slot = " + std::to_string(slot) + ": expected less than " +
                                std::to_string(slots) + ", the number of slots");
}

namespace {

/// The fast case, true for almost all bodies that are written: waking needs only one store.
bool is_awake_and_current(const WorldData& data, const BodyRecord& record) {
    return record.solver_index != 0 && record.mobility == Mobility::dynamic && !record.listed &&
           !data.self.locked();
}

[[gnu::noinline]] bool wake_and_set(WorldData& data, uint32_t slot, const Vec2& velocity) {
    data.self.may_edit("HostAccess", "set_velocity");
    if (data.body_generations[slot] == 0 || !wake_if_movable(data, slot)) return false;
    data.states[slot].velocity = velocity;
    return true;
}

bool same(float a, float b) {
    return detail::bits_of(a) == detail::bits_of(b);
}

bool same(const Vec2& a, const Vec2& b) {
    return same(a.x, b.x) && same(a.y, b.y);
}

/// A separate function, so that the usual path contains no jump. The stored velocity of a body just
/// edited is out of date, because the velocity changes with the center of mass.
[[gnu::cold, gnu::noinline]] Written result_without_write(const BodyRecord& record,
                                                          bool unchanged) {
    return unchanged && !record.listed ? Written::same : Written::refused;
}

bool has_slot(const WorldData& data, uint32_t slot) {
    return slot < data.bodies.size();
}

template <class T>
Written store(const WorldData& data, BodyRecord& record, T& cell, const T& value) {
    const bool unchanged = same(cell, value);
    if (unchanged || !is_awake_and_current(data, record)) [[unlikely]]
        return result_without_write(record, unchanged);
    record.sleep_time = 0.0f;
    cell = value;
    return Written::done;
}

[[gnu::noinline]] float edited_mass(WorldData& data, uint32_t slot) {
    data.read_mass(slot);
    return data.bodies[slot].mass;
}

}  // namespace

float HostAccess::mass(const World& world, uint32_t slot) {
    WorldData& data = *world.data_;
    const BodyRecord& record = at(data.bodies, slot);
    if (record.listed) [[unlikely]]
        return edited_mass(data, slot);
    return record.mass;
}

Vec2 HostAccess::velocity(const World& world, uint32_t slot) {
    WorldData& data = *world.data_;
    at(data.states, slot);
    data.read_mass(slot);  // an edited center of mass changes the velocity
    return data.states[slot].velocity;
}

bool HostAccess::set_velocity(World& world, uint32_t slot, const Vec2& velocity) {
    WorldData& data = *world.data_;
    if (!has_slot(data, slot)) [[unlikely]]
        return false;
    BodyRecord& record = data.bodies[slot];
    if (!is_awake_and_current(data, record)) [[unlikely]]
        return wake_and_set(data, slot, velocity);
    record.sleep_time = 0.0f;
    data.states[slot].velocity = velocity;
    return true;
}

Written HostAccess::write_velocity(World& world, uint32_t slot, const Vec2& velocity) {
    WorldData& data = *world.data_;
    if (!has_slot(data, slot)) [[unlikely]]
        return Written::refused;
    return store(data, data.bodies[slot], data.states[slot].velocity, velocity);
}

template <>
Written HostAccess::write<BodyNumber::angular_velocity>(World& world, uint32_t slot, float value) {
    WorldData& data = *world.data_;
    if (!has_slot(data, slot)) [[unlikely]]
        return Written::refused;
    return store(data, data.bodies[slot], data.states[slot].angular_velocity, value);
}
// Values that only the next step reads.
#define FETTLE_WRITE(number, cell)                                                             \
    template <>                                                                                \
    Written HostAccess::write<BodyNumber::number>(World & world, uint32_t slot, float value) { \
        WorldData& data = *world.data_;                                                        \
        if (!has_slot(data, slot)) [[unlikely]]                                                \
            return Written::refused;                                                           \
        BodyRecord& record = data.bodies[slot];                                                \
        return store(data, record, record.cell, value);                                        \
    }
FETTLE_WRITE(torque, load.torque)
FETTLE_WRITE(gravity_scale, gravity_scale)
FETTLE_WRITE(linear_damping, linear_damping)
FETTLE_WRITE(angular_damping, angular_damping)

void HostAccess::set_serial_callbacks(World& world, bool serial) {
    WorldData& data = *world.data_;
    data.self.may_edit("HostAccess", __func__);
    data.self.serial_callbacks = serial;
}

void HostAccess::on_refresh(World& world, RefreshCallback callback) {
    WorldData& data = *world.data_;
    data.self.may_edit("HostAccess", __func__);
    std::swap(data.self.refresh, callback);
}

void HostAccess::refresh(World& world, const Refresh& wanted) {
    WorldData& data = *world.data_;
    data.self.may_edit("HostAccess", __func__);
    data.refresh(wanted);
}

}  // namespace fettle::physics
