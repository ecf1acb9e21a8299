#include <fettle/physics_c/definitions.h>

#include <calls/calls.h>

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

namespace {

fettle_world_def defaults(const WorldDef& def) {
    fettle_world_def result{};
    result.substeps = def.substeps;
    result.gravity = converted(def.gravity);
    result.sleeping = def.sleeping;
    result.continuous = def.continuous;
    result.persist_events = def.persist_events;
    result.bounds_friction = def.bounds_friction;
    result.bounds_restitution = def.bounds_restitution;
    result.restitution_threshold = def.restitution_threshold;
    result.hit_threshold = def.hit_threshold;
    result.sleep_speed = def.sleep_speed;
    result.sleep_delay = def.sleep_delay;
    result.contact_hertz = def.contact_hertz;
    result.contact_damping = def.contact_damping;
    result.push_speed = def.push_speed;
    result.friction_mix = converted(def.friction_mix);
    result.restitution_mix = converted(def.restitution_mix);
    result.solver = converted(def.solver);
    return result;
}

fettle_body_def defaults(const BodyDef& def) {
    fettle_body_def result{};
    result.type = converted(def.type);
    result.gravity_scale = def.gravity_scale;
    result.awake = def.awake;
    result.can_sleep = def.can_sleep;
    result.enabled = def.enabled;
    result.max_speed = def.max_speed;
    return result;
}

fettle_shape_def defaults(const ShapeDef& def) {
    fettle_shape_def result{};
    result.density = def.density;
    result.friction = def.friction;
    result.contact_events = def.contact_events;
    result.sensor_events = def.sensor_events;
    result.before_solve = def.before_solve;
    result.category = def.category;
    result.mask = def.mask;
    return result;
}

fettle_mouse_joint_def defaults(const MouseJointDef& def) {
    fettle_mouse_joint_def result{};
    result.enabled = def.enabled;
    result.hertz = def.hertz;
    result.damping_ratio = def.damping_ratio;
    result.max_force = def.max_force;
    return result;
}

}  // namespace

WorldDef definition_of(const fettle_world_def* def) {
    if (def == nullptr) return {};
    check_size(def->size, sizeof *def);
    WorldDef result;
    result.gravity = vector_of(def->gravity);
    result.substeps = def->substeps;
    if (flag(def->has_bounds)) result.bounds = box_of(def->bounds);
    result.bounds_friction = def->bounds_friction;
    result.bounds_restitution = def->bounds_restitution;
    result.sleeping = flag(def->sleeping);
    result.continuous = flag(def->continuous);
    result.restitution_threshold = def->restitution_threshold;
    result.hit_threshold = def->hit_threshold;
    result.sleep_speed = def->sleep_speed;
    result.sleep_delay = def->sleep_delay;
    result.contact_hertz = def->contact_hertz;
    result.contact_damping = def->contact_damping;
    result.push_speed = def->push_speed;
    result.friction_mix = enumerator("friction_mix", def->friction_mix, MixRule::geometric);
    result.restitution_mix =
        enumerator("restitution_mix", def->restitution_mix, MixRule::geometric);
    result.solver = enumerator("solver", def->solver, Solver::direct);
    result.persist_events = flag(def->persist_events);
    return result;
}

BodyDef definition_of(const fettle_body_def* def) {
    if (def == nullptr) return {};
    check_size(def->size, sizeof *def);
    BodyDef result;
    result.type = enumerator("type", def->type, BodyType::dynamic_body);
    result.position = position_of(def->position);
    result.angle = def->angle;
    result.velocity = vector_of(def->velocity);
    result.angular_velocity = def->angular_velocity;
    result.force = vector_of(def->force);
    result.torque = def->torque;
    result.gravity_scale = def->gravity_scale;
    result.linear_damping = def->linear_damping;
    result.angular_damping = def->angular_damping;
    if (flag(def->has_mass)) result.mass = def->mass;
    if (flag(def->has_inertia)) result.inertia = def->inertia;
    if (flag(def->has_center)) result.center = vector_of(def->center);
    result.awake = flag(def->awake);
    result.can_sleep = flag(def->can_sleep);
    result.bullet = flag(def->bullet);
    result.locked_x = flag(def->locked_x);
    result.locked_y = flag(def->locked_y);
    result.locked_rotation = flag(def->locked_rotation);
    result.enabled = flag(def->enabled);
    if (flag(def->has_sleep_speed)) result.sleep_speed = def->sleep_speed;
    result.max_speed = def->max_speed;
    if (def->name != nullptr) result.name = def->name;
    result.user_data = def->user_data;
    return result;
}

ShapeDef definition_of(const fettle_shape_def* def) {
    if (def == nullptr) return {};
    check_size(def->size, sizeof *def);
    ShapeDef result;
    result.density = def->density;
    result.friction = def->friction;
    result.restitution = def->restitution;
    result.rolling_resistance = def->rolling_resistance;
    result.surface_speed = def->surface_speed;
    result.sensor = flag(def->sensor);
    result.hit_events = flag(def->hit_events);
    result.contact_events = flag(def->contact_events);
    result.sensor_events = flag(def->sensor_events);
    result.before_solve = flag(def->before_solve);
    result.material = checked(Material{def->material});
    result.category = def->category;
    result.mask = def->mask;
    result.group = def->group;
    result.user_data = def->user_data;
    return result;
}

MouseJointDef definition_of(const fettle_world* world, const fettle_mouse_joint_def* def) {
    const fettle_mouse_joint_def& given = needed("def", def);
    check_size(given.size, sizeof given);
    MouseJointDef result;
    result.body = body_named([] { return "body"; }, world, given.body).id();
    result.target = position_of(given.target);
    if (flag(given.has_anchor)) result.anchor = vector_of(given.anchor);
    result.hertz = given.hertz;
    result.damping_ratio = given.damping_ratio;
    result.max_force = given.max_force;
    result.enabled = flag(given.enabled);
    result.user_data = given.user_data;
    return result;
}

}  // namespace fettle::physics_c

using namespace fettle::physics_c;

fettle_code fettle_world_def_init(fettle_world_def* def, size_t size) {
    return init(__func__, def, size, defaults(fettle::physics::WorldDef()));
}

fettle_code fettle_body_def_init(fettle_body_def* def, size_t size) {
    return init(__func__, def, size, defaults(fettle::physics::BodyDef()));
}

fettle_code fettle_shape_def_init(fettle_shape_def* def, size_t size) {
    return init(__func__, def, size, defaults(fettle::physics::ShapeDef()));
}

fettle_code fettle_mouse_joint_def_init(fettle_mouse_joint_def* def, size_t size) {
    return init(__func__, def, size, defaults(fettle::physics::MouseJointDef()));
}
