// Functions for hosts that store slots: the values that they read and write most. They do not check
// that the body lives. Those that write refuse a slot beyond the last one: it would be in memory
// that is not theirs.

#include <fettle/physics/world.h>
#include <geometry/bits.h>
#include <handles/live.h>
#include <world/world_data.h>

namespace fettle::physics {

using namespace detail;

Vec2 World::velocity(uint32_t index) const {
    data_->read_mass(index);  // an edited center of mass changes the velocity
    return data_->states[index].velocity;
}

namespace {

/// The fast case, true for almost all bodies that are written: waking needs only one store.
bool is_awake_and_current(const WorldData& data, const BodyRecord& record) {
    return record.solver_index != 0 && record.mobility == Mobility::dynamic && !record.listed &&
           !data.self.locked();
}

[[gnu::noinline]] bool wake_and_set(WorldData& data, uint32_t index, const Vec2& velocity) {
    data.self.may_edit("World", "set_velocity");
    if (!wake_if_movable(data, index)) return false;
    data.states[index].velocity = velocity;
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

bool has_slot(const WorldData& data, uint32_t index) {
    return index < data.bodies.size();
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

}  // namespace

bool World::set_velocity(uint32_t index, const Vec2& velocity) {
    if (!has_slot(*data_, index)) [[unlikely]]
        return false;
    BodyRecord& record = data_->bodies[index];
    if (!is_awake_and_current(*data_, record)) [[unlikely]]
        return wake_and_set(*data_, index, velocity);
    record.sleep_time = 0.0f;
    data_->states[index].velocity = velocity;
    return true;
}

Written World::write_velocity(uint32_t index, const Vec2& velocity) {
    if (!has_slot(*data_, index)) [[unlikely]]
        return Written::refused;
    return store(*data_, data_->bodies[index], data_->states[index].velocity, velocity);
}

template <>
Written World::write<BodyNumber::angular_velocity>(uint32_t index, float value) {
    if (!has_slot(*data_, index)) [[unlikely]]
        return Written::refused;
    return store(*data_, data_->bodies[index], data_->states[index].angular_velocity, value);
}
// Values that only the next step reads.
#define FETTLE_WRITE(number, cell)                                          \
    template <>                                                             \
    Written World::write<BodyNumber::number>(uint32_t index, float value) { \
        if (!has_slot(*data_, index)) [[unlikely]]                          \
            return Written::refused;                                        \
        BodyRecord& record = data_->bodies[index];                          \
        return store(*data_, record, record.cell, value);                   \
    }
FETTLE_WRITE(torque, load.torque)
FETTLE_WRITE(gravity_scale, gravity_scale)
FETTLE_WRITE(linear_damping, linear_damping)
FETTLE_WRITE(angular_damping, angular_damping)

}  // namespace fettle::physics
