#include <calls/properties.h>

#include <fettle/physics_c/body.h>

using namespace fettle::physics;
using namespace fettle::physics_c;

bool fettle_body_is_valid(const fettle_world* world, fettle_id body) {
    return lives<BodyId>(world, body);
}

fettle_code fettle_body_destroy(fettle_world* world, fettle_id body) {
    return edit<&Body::destroy>(__func__, world, body);
}

FETTLE_READING(body, Body, type, int32_t)

fettle_code fettle_body_set_type(fettle_world* world, fettle_id body, int32_t type) {
    return edit<&Body::set_type>(__func__, world, body,
                                 Enumerated<BodyType::dynamic_body>{"type", type});
}

FETTLE_POSITION(body, Body, position)
FETTLE_PROPERTY(body, Body, angle, float)

fettle_code fettle_body_set_pose(fettle_world* world, fettle_id body, fettle_coordinate x,
                                 fettle_coordinate y, float angle) {
    return edit<&Body::set_pose>(__func__, world, body, Pose{{x, y}, angle});
}

FETTLE_VECTOR(body, Body, velocity)
FETTLE_PROPERTY(body, Body, angular_velocity, float)

fettle_code fettle_body_set_target(fettle_world* world, fettle_id body, fettle_coordinate x,
                                   fettle_coordinate y, float angle, float dt) {
    return edit<&Body::set_target>(__func__, world, body, Pose{{x, y}, angle}, dt);
}

FETTLE_VECTOR(body, Body, force)
FETTLE_PROPERTY(body, Body, torque, float)

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

FETTLE_READING(body, Body, applied_force, fettle_vec2)
FETTLE_READING(body, Body, applied_torque, float)
FETTLE_PROPERTY(body, Body, gravity_scale, float)
FETTLE_PROPERTY(body, Body, linear_damping, float)
FETTLE_PROPERTY(body, Body, angular_damping, float)
FETTLE_PROPERTY(body, Body, enabled, bool)

fettle_code fettle_body_name(fettle_world* world, fettle_id body, const char** name) {
    return guarded(__func__, [&] {
        const char*& result = needed("name", name);
        world->name = handle<Body>(world, body).name();
        result = world->name.c_str();
    });
}

fettle_code fettle_body_set_name(fettle_world* world, fettle_id body, const char* name) {
    return on<Body>(__func__, world, body, [&](Body it) { it.set_name(&needed("name", name)); });
}

FETTLE_PROPERTY(body, Body, max_speed, float)
FETTLE_READING(body, Body, sleep_speed, float)

fettle_code fettle_body_set_sleep_speed(fettle_world* world, fettle_id body,
                                        const float* sleep_speed) {
    return edit<&Body::set_sleep_speed>(__func__, world, body,
                                        sleep_speed ? std::optional(*sleep_speed) : std::nullopt);
}

fettle_code fettle_body_sleep_speed_override(const fettle_world* world, fettle_id body,
                                             bool* is_set, float* sleep_speed) {
    return read_optional<&Body::sleep_speed_override>(__func__, world, body, is_set, sleep_speed);
}

FETTLE_PROPERTY(body, Body, awake, bool)
FETTLE_PROPERTY(body, Body, can_sleep, bool)
FETTLE_PROPERTY(body, Body, bullet, bool)
FETTLE_PROPERTY(body, Body, locked_x, bool)
FETTLE_PROPERTY(body, Body, locked_y, bool)
FETTLE_PROPERTY(body, Body, locked_rotation, bool)
FETTLE_READING(body, Body, mass, float)

fettle_code fettle_body_set_mass(fettle_world* world, fettle_id body, const float* mass) {
    return edit<&Body::set_mass>(__func__, world, body, mass ? std::optional(*mass) : std::nullopt);
}

fettle_code fettle_body_mass_override(const fettle_world* world, fettle_id body, bool* is_set,
                                      float* mass) {
    return read_optional<&Body::mass_override>(__func__, world, body, is_set, mass);
}

FETTLE_READING(body, Body, inertia, float)

fettle_code fettle_body_set_inertia(fettle_world* world, fettle_id body, const float* inertia) {
    return edit<&Body::set_inertia>(__func__, world, body,
                                    inertia ? std::optional(*inertia) : std::nullopt);
}

fettle_code fettle_body_inertia_override(const fettle_world* world, fettle_id body, bool* is_set,
                                         float* inertia) {
    return read_optional<&Body::inertia_override>(__func__, world, body, is_set, inertia);
}

FETTLE_READING(body, Body, center, fettle_vec2)

fettle_code fettle_body_set_center(fettle_world* world, fettle_id body, const fettle_vec2* center) {
    return edit<&Body::set_center>(
        __func__, world, body, center ? std::optional(Vec2(center->x, center->y)) : std::nullopt);
}

fettle_code fettle_body_center_override(const fettle_world* world, fettle_id body, bool* is_set,
                                        fettle_vec2* center) {
    return read_optional<&Body::center_override>(__func__, world, body, is_set, center);
}

FETTLE_READING(body, Body, world_center, fettle_position)
FETTLE_READING(body, Body, area, float)
FETTLE_READING(body, Body, aabb, fettle_aabb)
FETTLE_READING(body, Body, rebuilds, uint32_t)
FETTLE_READING(body, Body, previous_pose, fettle_pose)

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

FETTLE_READING(body, Body, kinetic_energy, float)

fettle_code fettle_body_add(fettle_world* world, fettle_id body, const fettle_geometry* geometry,
                            const fettle_shape_def* def, fettle_id* shape) {
    return on<Body>(__func__, world, body, [&](Body it) {
        store_id(shape, it.add(geometry_of(geometry), definition_of(def)).id());
    });
}

FETTLE_READING(body, Body, shape_count, uint32_t)

fettle_code fettle_body_shapes(const fettle_world* world, fettle_id body, fettle_id* out,
                               uint32_t room, uint32_t* count) {
    return list<&Body::shapes>(__func__, world, body, out, room, count);
}

fettle_code fettle_body_joints(const fettle_world* world, fettle_id body, fettle_id* out,
                               uint32_t room, uint32_t* count) {
    return list<&Body::joints>(__func__, world, body, out, room, count);
}

FETTLE_READING(body, Body, is_touching, bool)

fettle_code fettle_body_contacts(const fettle_world* world, fettle_id body, fettle_contact* out,
                                 uint32_t room, uint32_t* count) {
    return list<&Body::contacts>(__func__, world, body, out, room, count);
}

FETTLE_PROPERTY(body, Body, user_data, uint64_t)
