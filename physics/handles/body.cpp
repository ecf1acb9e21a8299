// Methods of bodies: state, motion and forces.

#include <checks/arguments.h>
#include <contacts/reports.h>
#include <geometry/trigonometry.h>
#include <handles/live.h>
#include <state/limits.h>

#include <stdexcept>
#include <string>

namespace fettle::physics {

using namespace detail;

namespace {

Rotation rotation(const BodyState& state) {
    return {state.cosine, state.sine};
}

/// Applies an impulse at the center of mass and an angular impulse. It has no effect on a body that
/// does not move.
void add_impulse(const BodyRecord& record, BodyState& state, Vec2 impulse, float angular_impulse) {
    if (record.mobility != Mobility::dynamic) return;
    const Vec2 velocity = state.velocity + record.inverse_mass * impulse;
    const float angular = state.angular_velocity + record.inverse_inertia * angular_impulse;
    state.velocity = bounded(velocity, 1e30f);
    state.angular_velocity = bounded(angular, 1e30f);
}

}  // namespace

void detail::refuse_border_body(const char* function) {
    throw std::invalid_argument(std::string("Body::") + function +
                                ": this body carries the bounds of its world; edit them by "
                                "World::set_bounds");
}

bool Body::is_valid() const noexcept {
    return link_ != nullptr && link_->data != nullptr && link_->data->is_valid(id_);
}

World& Body::world() const {
    FETTLE_LIVE_BODY
    return *link_->world;
}

void Body::destroy() {
    FETTLE_EDIT_BODY
    data.self.may_populate("Body", __func__);
    data.change<detail::destroy_body>(id_.index);
}

FETTLE_BODY_READ(BodyType, type, record.type)
FETTLE_BODY_READ(Position, position, state.position)
FETTLE_BODY_READ(float, angle, state.angle)
FETTLE_BODY_READ(Pose, previous_pose, data.previous[id_.index])
FETTLE_BODY_DERIVED(Vec2, velocity, state.velocity)  // an edited center of mass changes it
FETTLE_BODY_READ(float, angular_velocity, state.angular_velocity)
FETTLE_BODY_READ(Vec2, force, record.load.force)
FETTLE_BODY_READ(Vec2, applied_force, record.step_load.force)
FETTLE_BODY_READ(float, applied_torque, record.step_load.torque)
FETTLE_BODY_DERIVED(bool, awake, record.solver_index != 0)  // falls asleep with an infinite mass
FETTLE_BODY_READ(bool, can_sleep, record.flags.can_sleep)
FETTLE_BODY_READ(bool, bullet, record.flags.bullet)
FETTLE_BODY_READ(bool, enabled, !record.flags.disabled)
FETTLE_BODY_READ(float, max_speed, data.max_speed_of(record))
FETTLE_BODY_READ(float, sleep_speed, data.sleep_speed_of(data.settings, record))
FETTLE_BODY_READ(bool, is_touching, record.lists.touching > 0)
FETTLE_BODY_READ(uint64_t, user_data, record.user_data)

FETTLE_BODY_NUMBER(torque, load.torque, check_finite)
FETTLE_BODY_NUMBER(gravity_scale, gravity_scale, check_finite)
FETTLE_BODY_NUMBER(linear_damping, linear_damping, check_not_negative)
FETTLE_BODY_NUMBER(angular_damping, angular_damping, check_not_negative)

#define FETTLE_BODY_LOCK(name)                      \
    FETTLE_BODY_READ(bool, name, record.flags.name) \
    void Body::set_##name(bool locked) {            \
        FETTLE_EDIT_BODY                            \
        record.flags.name = locked;                 \
        data.change<mark_mass>(id_.index);          \
        data.change<wake_body>(id_.index);          \
    }
FETTLE_BODY_LOCK(locked_x)
FETTLE_BODY_LOCK(locked_y)
FETTLE_BODY_LOCK(locked_rotation)

void Body::set_type(BodyType type) {
    FETTLE_EDIT_BODY
    if (check_enumerator("type", type, BodyType::dynamic_body) == record.type) return;
    data.change<wake_for_edit>(id_.index);
    record.type = type;
    data.change<mark_mass>(id_.index);
    // At once, because reading `awake` or setting a velocity depends on it.
    data.change<detail::refresh_mass>(id_.index);
}

void Body::set_position(const Position& position) {
    FETTLE_EDIT_BODY
    data.change<teleport>(id_.index, check_coordinates("position", position), state.angle);
}

namespace {

/// Teleports a body to a pose of any angle. A change of its mass that is still to be computed moves
/// the point that its velocity refers to, and the direction of that way depends on the angle
/// before.
void turn(WorldData& data, uint32_t body, const Pose& pose) {
    data.read_mass(body);
    data.change<teleport>(body, pose.position, pose.angle);
}

}  // namespace

void Body::set_angle(float angle) {
    FETTLE_EDIT_BODY
    check_range("angle", angle, -greatest_coordinate, greatest_coordinate);
    turn(data, id_.index, {state.position, angle});
}

void Body::set_pose(const Pose& pose) {
    FETTLE_EDIT_BODY
    check_coordinates("position", pose.position);
    check_range("angle", pose.angle, -greatest_coordinate, greatest_coordinate);
    turn(data, id_.index, pose);
}

bool detail::wake_if_movable(WorldData& data, uint32_t body) {
    data.read_mass(body);
    if (data.bodies[body].mobility == Mobility::fixed) return keeps_motion(data.bodies[body]);
    data.change<wake_for_edit>(body);
    return true;
}

void Body::set_velocity(const Vec2& velocity) {
    FETTLE_EDIT_BODY
    check_finite("velocity", velocity);
    if (!wake_if_movable(data, id_.index)) return;
    state.velocity = velocity;
}

void Body::set_angular_velocity(float angular_velocity) {
    FETTLE_EDIT_BODY
    check_finite("angular_velocity", angular_velocity);
    if (!wake_if_movable(data, id_.index)) return;
    state.angular_velocity = angular_velocity;
}

void Body::set_target(const Pose& target, float dt) {
    FETTLE_EDIT_BODY
    check_coordinates("target", target.position);
    check_range("target", target.angle, -greatest_coordinate, greatest_coordinate);
    check_positive("dt", dt);
    data.read_mass(id_.index);
    const Position center =
        target.position + rotate(rotation_of(target.angle), record.local_center);
    const float rate = 1.0f / dt;
    const Vec2 velocity = bounded(rate * (center - record.center), greatest_speed);
    const float angular_velocity = bounded(rate * (target.angle - state.angle), 1e6f);
    const bool rests = record.solver_index == 0 && velocity == state.velocity &&
                       angular_velocity == state.angular_velocity;
    if (rests || !wake_if_movable(data, id_.index)) return;
    state.velocity = velocity;
    state.angular_velocity = angular_velocity;
}

void Body::set_force(const Vec2& force) {
    FETTLE_EDIT_BODY
    record.load.force = check_finite("force", force);
    data.change<wake_body>(id_.index);
}

namespace {

/// Adds a force for the next step, and wakes the body. A force on a body that cannot move is
/// ignored; otherwise it would act later, when the body can move.
void push(WorldData& data, uint32_t body, const Load& load) {
    BodyRecord& record = data.bodies[body];
    if (record.mobility != Mobility::dynamic) return;
    data.change<wake_body>(body);
    record.step_load.add(load);
}

}  // namespace

void Body::apply_force(const Vec2& force) {
    FETTLE_EDIT_BODY
    check_finite("force", force);
    data.read_mass(id_.index);
    push(data, id_.index, {force, 0.0f});
}

void Body::apply_force(const Vec2& force, const Position& world_point) {
    FETTLE_EDIT_BODY
    check_finite("force", force);
    check_finite_point("world_point", world_point);
    data.read_mass(id_.index);
    push(data, id_.index, {force, cross(world_point - record.center, force)});
}

void Body::apply_torque(float torque) {
    FETTLE_EDIT_BODY
    check_finite("torque", torque);
    data.read_mass(id_.index);
    push(data, id_.index, {{}, torque});
}

void Body::apply_impulse(const Vec2& impulse) {
    FETTLE_EDIT_BODY
    check_finite("impulse", impulse);
    data.read_mass(id_.index);
    data.change<wake_body>(id_.index);
    add_impulse(record, state, impulse, 0.0f);
}

void Body::apply_impulse(const Vec2& impulse, const Position& world_point) {
    FETTLE_EDIT_BODY
    check_finite("impulse", impulse);
    check_finite_point("world_point", world_point);
    data.read_mass(id_.index);
    data.change<wake_body>(id_.index);
    add_impulse(record, state, impulse, cross(world_point - record.center, impulse));
}

void Body::apply_angular_impulse(float impulse) {
    FETTLE_EDIT_BODY
    check_finite("impulse", impulse);
    data.read_mass(id_.index);
    data.change<wake_body>(id_.index);
    add_impulse(record, state, {}, impulse);
}

void Body::set_awake(bool awake) {
    FETTLE_EDIT_BODY
    if (awake) {
        data.change<wake_body>(id_.index);
    } else if (data.settings.sleeping) {
        data.read_all();
        data.change<put_group_to_sleep>(id_.index);
    }
}

void Body::set_can_sleep(bool can_sleep) {
    FETTLE_EDIT_BODY
    record.flags.can_sleep = can_sleep;
    if (!can_sleep) data.change<wake_body>(id_.index);
}

void Body::set_enabled(bool enabled) {
    FETTLE_EDIT_BODY
    data.change<set_body_enabled>(id_.index, enabled);
}

std::string Body::name() const {
    FETTLE_LIVE_BODY
    return record.traits == none ? std::string() : data.traits[record.traits].name.data();
}

void Body::set_name(std::string_view name) {
    FETTLE_EDIT_BODY
    check_name("name", name);
    detail::set_name(data, id_.index, name);
}

void Body::set_max_speed(float speed) {
    FETTLE_EDIT_BODY
    check_inertial("max_speed", speed);
    traits_of(data, id_.index).max_speed = speed;
    free_default_traits(data, id_.index);
    data.change<wake_body>(id_.index);
}

std::optional<float> Body::sleep_speed_override() const {
    FETTLE_LIVE_BODY
    if (record.traits == none || !is_given(data.traits[record.traits].sleep_speed)) return {};
    return data.traits[record.traits].sleep_speed;
}

void Body::set_sleep_speed(std::optional<float> speed) {
    FETTLE_EDIT_BODY
    if (speed) check_not_negative("sleep_speed", *speed);
    traits_of(data, id_.index).sleep_speed = speed.value_or(not_given);
    free_default_traits(data, id_.index);
    data.change<wake_body>(id_.index);
}

void Body::set_bullet(bool bullet) {
    FETTLE_EDIT_BODY
    data.bullets += uint32_t(bullet) - uint32_t(record.flags.bullet);
    record.flags.bullet = bullet;
}

Pose Body::interpolated(float fraction) const {
    FETTLE_LIVE_BODY
    const Pose& from = data.previous[id_.index];
    return {from.position + fraction * (state.position - from.position),
            from.angle + fraction * (state.angle - from.angle)};
}

Position Body::world_point(const Vec2& local) const {
    FETTLE_LIVE_BODY
    return state.position + rotate(rotation(state), local);
}

Vec2 Body::local_point(const Position& world) const {
    FETTLE_LIVE_BODY
    return unrotate(rotation(state), world - state.position);
}

Vec2 Body::world_vector(const Vec2& local) const {
    FETTLE_LIVE_BODY
    return rotate(rotation(state), local);
}

Vec2 Body::local_vector(const Vec2& world) const {
    FETTLE_LIVE_BODY
    return unrotate(rotation(state), world);
}

Vec2 Body::velocity_at(const Position& world_point) const {
    FETTLE_LIVE_BODY
    data.read_mass(id_.index);
    return state.velocity + cross(state.angular_velocity, world_point - record.center);
}

float Body::kinetic_energy() const {
    FETTLE_LIVE_BODY
    data.read_mass(id_.index);
    if (record.mobility != Mobility::dynamic) return 0.0f;
    float energy = 0.5f * record.mass * state.velocity.length_squared();
    if (record.inverse_inertia > 0.0f) {
        energy += 0.5f * record.inertia * state.angular_velocity * state.angular_velocity;
    }
    return energy;
}

Shape Body::add(const Geometry& geometry, const ShapeDef& def) {
    FETTLE_EDIT_BODY
    data.self.may_populate("Body", __func__);
    const Shape shape = link_->world->create_shape(geometry, def);
    data.change<detail::attach_shape>(shape.index(), id_.index);
    return shape;
}

uint32_t Body::shape_count() const {
    FETTLE_LIVE_BODY
    uint32_t count = 0;
    for (uint32_t s = record.lists.first_shape; s != none; s = data.shapes[s].next)
        count += data.shapes[s].owner == none;
    return count;
}

std::vector<Joint> Body::joints() const {
    FETTLE_LIVE_BODY
    std::vector<Joint> all;
    data.for_each_joint(id_.index, [&](uint32_t joint, uint32_t) {
        if (!data.joints[joint].dormant())
            all.emplace_back(link_->world, JointId{joint, data.joint_generations[joint]});
    });
    return all;
}

std::vector<Shape> Body::shapes() const {
    FETTLE_LIVE_BODY
    std::vector<Shape> all;
    for (uint32_t s = record.lists.first_shape; s != none; s = data.shapes[s].next) {
        if (data.shapes[s].owner == none) all.emplace_back(link_->world, data.shape_id(s));
    }
    return all;
}

std::vector<Contact> Body::contacts() const {
    FETTLE_LIVE_BODY
    std::vector<Contact> all;
    data.for_each_contact(id_.index, [&](uint32_t contact) {
        const ContactRecord& c = data.contacts[contact];
        if (c.touching && !c.sensor) all.push_back(view_of(data, data, data.last_substep, c));
    });
    return all;
}

void Body::set_user_data(uint64_t value) {
    FETTLE_LIVE_BODY
    data.self.may_populate("Body", __func__);
    record.user_data = value;
}

}  // namespace fettle::physics
