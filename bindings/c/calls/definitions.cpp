#include <fettle/physics_c/definitions.h>

#include <calls/members.h>

namespace fettle::physics_c {

using namespace physics;

void check_size(size_t given, size_t expected) {
    if (given != expected)
        throw Failure{FETTLE_INVALID, "size = " + std::to_string(given) + ": expected " +
                                          std::to_string(expected) +
                                          ", as its init function writes it"};
}

void refuse_enumerator(const char* name, int32_t value, int32_t last) {
    throw Failure{FETTLE_INVALID, std::string(name) + " = " + std::to_string(value) +
                                      ": expected an enumerator, 0 to " + std::to_string(last)};
}

template <class InC, class Each>
void each_member(InC& c, WorldDef& def, const Each& each) {
    each(c.gravity, def.gravity);
    each(c.substeps, def.substeps);
    each(c.has_bounds, c.bounds, def.bounds);
    each(c.bounds_friction, def.bounds_friction);
    each(c.bounds_restitution, def.bounds_restitution);
    each(c.sleeping, def.sleeping);
    each(c.continuous, def.continuous);
    each(c.restitution_threshold, def.restitution_threshold);
    each(c.hit_threshold, def.hit_threshold);
    each(c.sleep_speed, def.sleep_speed);
    each(c.sleep_delay, def.sleep_delay);
    each(c.contact_hertz, def.contact_hertz);
    each(c.contact_damping, def.contact_damping);
    each(c.push_speed, def.push_speed);
    each(c.max_speed, def.max_speed);
    each(FETTLE_ENUMERATOR(friction_mix, MixRule::geometric), def.friction_mix);
    each(FETTLE_ENUMERATOR(restitution_mix, MixRule::geometric), def.restitution_mix);
    each(FETTLE_ENUMERATOR(solver, Solver::direct), def.solver);
    each(c.persist_events, def.persist_events);
}

/// All members but the name, which is a pointer in C.
template <class InC, class Each>
void each_member(InC& c, BodyDef& def, const Each& each) {
    each(FETTLE_ENUMERATOR(type, BodyType::dynamic_body), def.type);
    each(c.position, def.position);
    each(c.angle, def.angle);
    each(c.velocity, def.velocity);
    each(c.angular_velocity, def.angular_velocity);
    each(c.force, def.force);
    each(c.torque, def.torque);
    each(c.gravity_scale, def.gravity_scale);
    each(c.linear_damping, def.linear_damping);
    each(c.angular_damping, def.angular_damping);
    each(c.has_mass, c.mass, def.mass);
    each(c.has_inertia, c.inertia, def.inertia);
    each(c.has_center, c.center, def.center);
    each(c.awake, def.awake);
    each(c.can_sleep, def.can_sleep);
    each(c.bullet, def.bullet);
    each(c.locked_x, def.locked_x);
    each(c.locked_y, def.locked_y);
    each(c.locked_rotation, def.locked_rotation);
    each(c.enabled, def.enabled);
    each(c.has_sleep_speed, c.sleep_speed, def.sleep_speed);
    each(c.max_speed, def.max_speed);
    each(c.user_data, def.user_data);
}

template <class InC, class Each>
void each_member(InC& c, ShapeDef& def, const Each& each) {
    each(c.density, def.density);
    each(c.friction, def.friction);
    each(c.restitution, def.restitution);
    each(c.rolling_resistance, def.rolling_resistance);
    each(c.surface_speed, def.surface_speed);
    each(c.sensor, def.sensor);
    each(c.hit_events, def.hit_events);
    each(c.contact_events, def.contact_events);
    each(c.sensor_events, def.sensor_events);
    each(c.category, def.category);
    each(c.mask, def.mask);
    each(c.group, def.group);
    each(c.material, def.material);
    each(c.before_solve, def.before_solve);
    each(c.user_data, def.user_data);
}

/// All members but the body, whose id needs the world.
template <class InC, class Each>
void each_member(InC& c, MouseJointDef& def, const Each& each) {
    each(c.target, def.target);
    each(c.has_anchor, c.anchor, def.anchor);
    each(c.hertz, def.hertz);
    each(c.damping_ratio, def.damping_ratio);
    each(c.max_force, def.max_force);
    each(c.enabled, def.enabled);
    each(c.user_data, def.user_data);
}

WorldDef definition_of(const fettle_world_def* def) {
    return from_c_or_defaults<WorldDef>(def);
}

BodyDef definition_of(const fettle_body_def* def) {
    BodyDef result = from_c_or_defaults<BodyDef>(def);
    if (def != nullptr && def->name != nullptr) result.name = def->name;
    return result;
}

ShapeDef definition_of(const fettle_shape_def* def) {
    return from_c_or_defaults<ShapeDef>(def);
}

MouseJointDef definition_of(const fettle_world* world, const fettle_mouse_joint_def* def) {
    MouseJointDef result = from_c<MouseJointDef>(needed("def", def));
    result.body = body_named([] { return "body"; }, world, def->body).id();
    return result;
}

}  // namespace fettle::physics_c

using namespace fettle::physics_c;

fettle_code fettle_world_def_init(fettle_world_def* def, size_t size) {
    return init_as<fettle::physics::WorldDef>(__func__, def, size);
}

fettle_code fettle_body_def_init(fettle_body_def* def, size_t size) {
    return init_as<fettle::physics::BodyDef>(__func__, def, size);
}

fettle_code fettle_shape_def_init(fettle_shape_def* def, size_t size) {
    return init_as<fettle::physics::ShapeDef>(__func__, def, size);
}

fettle_code fettle_mouse_joint_def_init(fettle_mouse_joint_def* def, size_t size) {
    return init_as<fettle::physics::MouseJointDef>(__func__, def, size);
}
