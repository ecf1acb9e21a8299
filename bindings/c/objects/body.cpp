#include <calls/calls.h>

#include <fettle/physics_c/body.h>

using namespace fettle::physics;
using namespace fettle::physics_c;

bool fettle_body_is_valid(const fettle_world* world, fettle_id body) {
    return lives<BodyId>(world, body);
}

fettle_code fettle_body_destroy(fettle_world* world, fettle_id body) {
    return edit<&Body::destroy>(__func__, world, body);
}

fettle_code fettle_body_type(const fettle_world* world, fettle_id body, int32_t* type) {
    return read<&Body::type>(__func__, world, body, type);
}

fettle_code fettle_body_set_type(fettle_world* world, fettle_id body, int32_t type) {
    return edit<&Body::set_type>(__func__, world, body,
                                 Enumerated<BodyType::dynamic_body>{"type", type});
}

fettle_code fettle_body_position(const fettle_world* world, fettle_id body,
                                 fettle_position* position) {
    return read<&Body::position>(__func__, world, body, position);
}

fettle_code fettle_body_set_position(fettle_world* world, fettle_id body, fettle_coordinate x,
                                     fettle_coordinate y) {
    return edit<&Body::set_position>(__func__, world, body, Position(x, y));
}

fettle_code fettle_body_angle(const fettle_world* world, fettle_id body, float* angle) {
    return read<&Body::angle>(__func__, world, body, angle);
}

fettle_code fettle_body_set_angle(fettle_world* world, fettle_id body, float angle) {
    return edit<&Body::set_angle>(__func__, world, body, angle);
}

fettle_code fettle_body_set_pose(fettle_world* world, fettle_id body, fettle_coordinate x,
                                 fettle_coordinate y, float angle) {
    return edit<&Body::set_pose>(__func__, world, body, Pose{{x, y}, angle});
}

fettle_code fettle_body_velocity(const fettle_world* world, fettle_id body, fettle_vec2* velocity) {
    return read<&Body::velocity>(__func__, world, body, velocity);
}

fettle_code fettle_body_set_velocity(fettle_world* world, fettle_id body, float x, float y) {
    return edit<&Body::set_velocity>(__func__, world, body, Vec2(x, y));
}

fettle_code fettle_body_angular_velocity(const fettle_world* world, fettle_id body,
                                         float* angular_velocity) {
    return read<&Body::angular_velocity>(__func__, world, body, angular_velocity);
}

fettle_code fettle_body_set_angular_velocity(fettle_world* world, fettle_id body,
                                             float angular_velocity) {
    return edit<&Body::set_angular_velocity>(__func__, world, body, angular_velocity);
}

fettle_code fettle_body_set_target(fettle_world* world, fettle_id body, fettle_coordinate x,
                                   fettle_coordinate y, float angle, float dt) {
    return edit<&Body::set_target>(__func__, world, body, Pose{{x, y}, angle}, dt);
}

fettle_code fettle_body_force(const fettle_world* world, fettle_id body, fettle_vec2* force) {
    return read<&Body::force>(__func__, world, body, force);
}

fettle_code fettle_body_set_force(fettle_world* world, fettle_id body, float x, float y) {
    return edit<&Body::set_force>(__func__, world, body, Vec2(x, y));
}

fettle_code fettle_body_torque(const fettle_world* world, fettle_id body, float* torque) {
    return read<&Body::torque>(__func__, world, body, torque);
}

fettle_code fettle_body_set_torque(fettle_world* world, fettle_id body, float torque) {
    return edit<&Body::set_torque>(__func__, world, body, torque);
}

fettle_code fettle_body_apply_force(fettle_world* world, fettle_id body, float x, float y) {
    return on<Body>(__func__, world, body, [&](Body it) { it.apply_force(Vec2(x, y)); });
}

fettle_code fettle_body_apply_force_at(fettle_world* world, fettle_id body, float x, float y,
                                       fettle_coordinate at_x, fettle_coordinate at_y) {
    return on<Body>(__func__, world, body,
                    [&](Body it) { it.apply_force(Vec2(x, y), Position(at_x, at_y)); });
}

fettle_code fettle_body_apply_impulse(fettle_world* world, fettle_id body, float x, float y) {
    return on<Body>(__func__, world, body, [&](Body it) { it.apply_impulse(Vec2(x, y)); });
}

fettle_code fettle_body_apply_impulse_at(fettle_world* world, fettle_id body, float x, float y,
                                         fettle_coordinate at_x, fettle_coordinate at_y) {
    return on<Body>(__func__, world, body,
                    [&](Body it) { it.apply_impulse(Vec2(x, y), Position(at_x, at_y)); });
}

fettle_code fettle_body_apply_torque(fettle_world* world, fettle_id body, float torque) {
    return edit<&Body::apply_torque>(__func__, world, body, torque);
}

fettle_code fettle_body_apply_angular_impulse(fettle_world* world, fettle_id body, float impulse) {
    return edit<&Body::apply_angular_impulse>(__func__, world, body, impulse);
}

fettle_code fettle_body_applied_force(const fettle_world* world, fettle_id body,
                                      fettle_vec2* applied_force) {
    return read<&Body::applied_force>(__func__, world, body, applied_force);
}

fettle_code fettle_body_applied_torque(const fettle_world* world, fettle_id body,
                                       float* applied_torque) {
    return read<&Body::applied_torque>(__func__, world, body, applied_torque);
}

fettle_code fettle_body_gravity_scale(const fettle_world* world, fettle_id body,
                                      float* gravity_scale) {
    return read<&Body::gravity_scale>(__func__, world, body, gravity_scale);
}

fettle_code fettle_body_set_gravity_scale(fettle_world* world, fettle_id body,
                                          float gravity_scale) {
    return edit<&Body::set_gravity_scale>(__func__, world, body, gravity_scale);
}

fettle_code fettle_body_linear_damping(const fettle_world* world, fettle_id body,
                                       float* linear_damping) {
    return read<&Body::linear_damping>(__func__, world, body, linear_damping);
}

fettle_code fettle_body_set_linear_damping(fettle_world* world, fettle_id body,
                                           float linear_damping) {
    return edit<&Body::set_linear_damping>(__func__, world, body, linear_damping);
}

fettle_code fettle_body_angular_damping(const fettle_world* world, fettle_id body,
                                        float* angular_damping) {
    return read<&Body::angular_damping>(__func__, world, body, angular_damping);
}

fettle_code fettle_body_set_angular_damping(fettle_world* world, fettle_id body,
                                            float angular_damping) {
    return edit<&Body::set_angular_damping>(__func__, world, body, angular_damping);
}

fettle_code fettle_body_enabled(const fettle_world* world, fettle_id body, bool* enabled) {
    return read<&Body::enabled>(__func__, world, body, enabled);
}

fettle_code fettle_body_set_enabled(fettle_world* world, fettle_id body, bool enabled) {
    return edit<&Body::set_enabled>(__func__, world, body, enabled);
}

fettle_code fettle_body_name(fettle_world* world, fettle_id body, const char** name) {
    return guarded(__func__, [&] {
        const char*& told = needed("name", name);
        world->name = handle<Body>(world, body).name();
        told = world->name.c_str();
    });
}

fettle_code fettle_body_set_name(fettle_world* world, fettle_id body, const char* name) {
    return on<Body>(__func__, world, body, [&](Body it) { it.set_name(&needed("name", name)); });
}

fettle_code fettle_body_max_speed(const fettle_world* world, fettle_id body, float* max_speed) {
    return read<&Body::max_speed>(__func__, world, body, max_speed);
}

fettle_code fettle_body_set_max_speed(fettle_world* world, fettle_id body, float max_speed) {
    return edit<&Body::set_max_speed>(__func__, world, body, max_speed);
}

fettle_code fettle_body_sleep_speed(const fettle_world* world, fettle_id body, float* sleep_speed) {
    return read<&Body::sleep_speed>(__func__, world, body, sleep_speed);
}

fettle_code fettle_body_set_sleep_speed(fettle_world* world, fettle_id body,
                                        const float* sleep_speed) {
    return edit<&Body::set_sleep_speed>(__func__, world, body,
                                        sleep_speed ? std::optional(*sleep_speed) : std::nullopt);
}

fettle_code fettle_body_sleep_speed_override(const fettle_world* world, fettle_id body,
                                             bool* is_set, float* sleep_speed) {
    return read_optional<&Body::sleep_speed_override>(__func__, world, body, is_set, sleep_speed);
}

fettle_code fettle_body_awake(const fettle_world* world, fettle_id body, bool* awake) {
    return read<&Body::awake>(__func__, world, body, awake);
}

fettle_code fettle_body_set_awake(fettle_world* world, fettle_id body, bool awake) {
    return edit<&Body::set_awake>(__func__, world, body, awake);
}

fettle_code fettle_body_can_sleep(const fettle_world* world, fettle_id body, bool* can_sleep) {
    return read<&Body::can_sleep>(__func__, world, body, can_sleep);
}

fettle_code fettle_body_set_can_sleep(fettle_world* world, fettle_id body, bool can_sleep) {
    return edit<&Body::set_can_sleep>(__func__, world, body, can_sleep);
}

fettle_code fettle_body_bullet(const fettle_world* world, fettle_id body, bool* bullet) {
    return read<&Body::bullet>(__func__, world, body, bullet);
}

fettle_code fettle_body_set_bullet(fettle_world* world, fettle_id body, bool bullet) {
    return edit<&Body::set_bullet>(__func__, world, body, bullet);
}

fettle_code fettle_body_locked_x(const fettle_world* world, fettle_id body, bool* locked_x) {
    return read<&Body::locked_x>(__func__, world, body, locked_x);
}

fettle_code fettle_body_set_locked_x(fettle_world* world, fettle_id body, bool locked_x) {
    return edit<&Body::set_locked_x>(__func__, world, body, locked_x);
}

fettle_code fettle_body_locked_y(const fettle_world* world, fettle_id body, bool* locked_y) {
    return read<&Body::locked_y>(__func__, world, body, locked_y);
}

fettle_code fettle_body_set_locked_y(fettle_world* world, fettle_id body, bool locked_y) {
    return edit<&Body::set_locked_y>(__func__, world, body, locked_y);
}

fettle_code fettle_body_locked_rotation(const fettle_world* world, fettle_id body,
                                        bool* locked_rotation) {
    return read<&Body::locked_rotation>(__func__, world, body, locked_rotation);
}

fettle_code fettle_body_set_locked_rotation(fettle_world* world, fettle_id body,
                                            bool locked_rotation) {
    return edit<&Body::set_locked_rotation>(__func__, world, body, locked_rotation);
}

fettle_code fettle_body_mass(const fettle_world* world, fettle_id body, float* mass) {
    return read<&Body::mass>(__func__, world, body, mass);
}

fettle_code fettle_body_set_mass(fettle_world* world, fettle_id body, const float* mass) {
    return edit<&Body::set_mass>(__func__, world, body, mass ? std::optional(*mass) : std::nullopt);
}

fettle_code fettle_body_mass_override(const fettle_world* world, fettle_id body, bool* is_set,
                                      float* mass) {
    return read_optional<&Body::mass_override>(__func__, world, body, is_set, mass);
}

fettle_code fettle_body_inertia(const fettle_world* world, fettle_id body, float* inertia) {
    return read<&Body::inertia>(__func__, world, body, inertia);
}

fettle_code fettle_body_set_inertia(fettle_world* world, fettle_id body, const float* inertia) {
    return edit<&Body::set_inertia>(__func__, world, body,
                                    inertia ? std::optional(*inertia) : std::nullopt);
}

fettle_code fettle_body_inertia_override(const fettle_world* world, fettle_id body, bool* is_set,
                                         float* inertia) {
    return read_optional<&Body::inertia_override>(__func__, world, body, is_set, inertia);
}

fettle_code fettle_body_center(const fettle_world* world, fettle_id body, fettle_vec2* center) {
    return read<&Body::center>(__func__, world, body, center);
}

fettle_code fettle_body_set_center(fettle_world* world, fettle_id body, const fettle_vec2* center) {
    return edit<&Body::set_center>(
        __func__, world, body, center ? std::optional(Vec2(center->x, center->y)) : std::nullopt);
}

fettle_code fettle_body_center_override(const fettle_world* world, fettle_id body, bool* is_set,
                                        fettle_vec2* center) {
    return read_optional<&Body::center_override>(__func__, world, body, is_set, center);
}

fettle_code fettle_body_world_center(const fettle_world* world, fettle_id body,
                                     fettle_position* world_center) {
    return read<&Body::world_center>(__func__, world, body, world_center);
}

fettle_code fettle_body_area(const fettle_world* world, fettle_id body, float* area) {
    return read<&Body::area>(__func__, world, body, area);
}

fettle_code fettle_body_aabb(const fettle_world* world, fettle_id body, fettle_aabb* aabb) {
    return read<&Body::aabb>(__func__, world, body, aabb);
}

fettle_code fettle_body_rebuilds(const fettle_world* world, fettle_id body, uint32_t* rebuilds) {
    return read<&Body::rebuilds>(__func__, world, body, rebuilds);
}

fettle_code fettle_body_previous_pose(const fettle_world* world, fettle_id body,
                                      fettle_pose* previous_pose) {
    return read<&Body::previous_pose>(__func__, world, body, previous_pose);
}

fettle_code fettle_body_interpolated(const fettle_world* world, fettle_id body, float fraction,
                                     fettle_pose* pose) {
    return read<&Body::interpolated>(__func__, world, body, pose, Finite{"fraction", fraction});
}

fettle_code fettle_body_world_point(const fettle_world* world, fettle_id body, float x, float y,
                                    fettle_position* out) {
    return read<&Body::world_point>(__func__, world, body, out, FiniteVector{x, y});
}

fettle_code fettle_body_local_point(const fettle_world* world, fettle_id body, fettle_coordinate x,
                                    fettle_coordinate y, fettle_vec2* out) {
    return read<&Body::local_point>(__func__, world, body, out, FinitePoint{x, y});
}

fettle_code fettle_body_world_vector(const fettle_world* world, fettle_id body, float x, float y,
                                     fettle_vec2* out) {
    return read<&Body::world_vector>(__func__, world, body, out, FiniteVector{x, y});
}

fettle_code fettle_body_local_vector(const fettle_world* world, fettle_id body, float x, float y,
                                     fettle_vec2* out) {
    return read<&Body::local_vector>(__func__, world, body, out, FiniteVector{x, y});
}

fettle_code fettle_body_velocity_at(const fettle_world* world, fettle_id body, fettle_coordinate x,
                                    fettle_coordinate y, fettle_vec2* out) {
    return read<&Body::velocity_at>(__func__, world, body, out, FinitePoint{x, y});
}

fettle_code fettle_body_kinetic_energy(const fettle_world* world, fettle_id body,
                                       float* kinetic_energy) {
    return read<&Body::kinetic_energy>(__func__, world, body, kinetic_energy);
}

fettle_code fettle_body_add(fettle_world* world, fettle_id body, const fettle_geometry* geometry,
                            const fettle_shape_def* def, fettle_id* shape) {
    return on<Body>(__func__, world, body, [&](Body it) {
        give(shape, it.add(geometry_of(geometry), definition_of(def)).id());
    });
}

fettle_code fettle_body_shape_count(const fettle_world* world, fettle_id body,
                                    uint32_t* shape_count) {
    return read<&Body::shape_count>(__func__, world, body, shape_count);
}

fettle_code fettle_body_shapes(const fettle_world* world, fettle_id body, fettle_id* out,
                               uint32_t room, uint32_t* count) {
    return list<&Body::shapes>(__func__, world, body, out, room, count);
}

fettle_code fettle_body_joints(const fettle_world* world, fettle_id body, fettle_id* out,
                               uint32_t room, uint32_t* count) {
    return list<&Body::joints>(__func__, world, body, out, room, count);
}

fettle_code fettle_body_is_touching(const fettle_world* world, fettle_id body, bool* is_touching) {
    return read<&Body::is_touching>(__func__, world, body, is_touching);
}

fettle_code fettle_body_contacts(const fettle_world* world, fettle_id body, fettle_contact* out,
                                 uint32_t room, uint32_t* count) {
    return list<&Body::contacts>(__func__, world, body, out, room, count);
}

fettle_code fettle_body_user_data(const fettle_world* world, fettle_id body, uint64_t* user_data) {
    return read<&Body::user_data>(__func__, world, body, user_data);
}

fettle_code fettle_body_set_user_data(fettle_world* world, fettle_id body, uint64_t user_data) {
    return edit<&Body::set_user_data>(__func__, world, body, user_data);
}
