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
    fettle_world_def told{};
    told.substeps = def.substeps;
    told.gravity = converted(def.gravity);
    told.sleeping = def.sleeping;
    told.continuous = def.continuous;
    told.persist_events = def.persist_events;
    told.bounds_friction = def.bounds_friction;
    told.bounds_restitution = def.bounds_restitution;
    told.restitution_threshold = def.restitution_threshold;
    told.hit_threshold = def.hit_threshold;
    told.sleep_speed = def.sleep_speed;
    told.sleep_delay = def.sleep_delay;
    told.contact_hertz = def.contact_hertz;
    told.contact_damping = def.contact_damping;
    told.push_speed = def.push_speed;
    told.friction_mix = converted(def.friction_mix);
    told.restitution_mix = converted(def.restitution_mix);
    told.solver = converted(def.solver);
    return told;
}

fettle_body_def defaults(const BodyDef& def) {
    fettle_body_def told{};
    told.type = converted(def.type);
    told.gravity_scale = def.gravity_scale;
    told.awake = def.awake;
    told.can_sleep = def.can_sleep;
    told.enabled = def.enabled;
    told.max_speed = def.max_speed;
    return told;
}

fettle_shape_def defaults(const ShapeDef& def) {
    fettle_shape_def told{};
    told.density = def.density;
    told.friction = def.friction;
    told.contact_events = def.contact_events;
    told.sensor_events = def.sensor_events;
    told.before_solve = def.before_solve;
    told.category = def.category;
    told.mask = def.mask;
    return told;
}

fettle_mouse_joint_def defaults(const MouseJointDef& def) {
    fettle_mouse_joint_def told{};
    told.enabled = def.enabled;
    told.hertz = def.hertz;
    told.damping_ratio = def.damping_ratio;
    told.max_force = def.max_force;
    return told;
}

}  // namespace

WorldDef definition_of(const fettle_world_def* def) {
    if (def == nullptr) return {};
    check_size(def->size, sizeof *def);
    WorldDef taken;
    taken.gravity = vector_of(def->gravity);
    taken.substeps = def->substeps;
    if (flag(def->has_bounds)) taken.bounds = box_of(def->bounds);
    taken.bounds_friction = def->bounds_friction;
    taken.bounds_restitution = def->bounds_restitution;
    taken.sleeping = flag(def->sleeping);
    taken.continuous = flag(def->continuous);
    taken.restitution_threshold = def->restitution_threshold;
    taken.hit_threshold = def->hit_threshold;
    taken.sleep_speed = def->sleep_speed;
    taken.sleep_delay = def->sleep_delay;
    taken.contact_hertz = def->contact_hertz;
    taken.contact_damping = def->contact_damping;
    taken.push_speed = def->push_speed;
    taken.friction_mix = enumerator("friction_mix", def->friction_mix, MixRule::geometric);
    taken.restitution_mix = enumerator("restitution_mix", def->restitution_mix, MixRule::geometric);
    taken.solver = enumerator("solver", def->solver, Solver::direct);
    taken.persist_events = flag(def->persist_events);
    return taken;
}

BodyDef definition_of(const fettle_body_def* def) {
    if (def == nullptr) return {};
    check_size(def->size, sizeof *def);
    BodyDef taken;
    taken.type = enumerator("type", def->type, BodyType::dynamic_body);
    taken.position = position_of(def->position);
    taken.angle = def->angle;
    taken.velocity = vector_of(def->velocity);
    taken.angular_velocity = def->angular_velocity;
    taken.force = vector_of(def->force);
    taken.torque = def->torque;
    taken.gravity_scale = def->gravity_scale;
    taken.linear_damping = def->linear_damping;
    taken.angular_damping = def->angular_damping;
    if (flag(def->has_mass)) taken.mass = def->mass;
    if (flag(def->has_inertia)) taken.inertia = def->inertia;
    if (flag(def->has_center)) taken.center = vector_of(def->center);
    taken.awake = flag(def->awake);
    taken.can_sleep = flag(def->can_sleep);
    taken.bullet = flag(def->bullet);
    taken.locked_x = flag(def->locked_x);
    taken.locked_y = flag(def->locked_y);
    taken.locked_rotation = flag(def->locked_rotation);
    taken.enabled = flag(def->enabled);
    if (flag(def->has_sleep_speed)) taken.sleep_speed = def->sleep_speed;
    taken.max_speed = def->max_speed;
    if (def->name != nullptr) taken.name = def->name;
    taken.user_data = def->user_data;
    return taken;
}

ShapeDef definition_of(const fettle_shape_def* def) {
    if (def == nullptr) return {};
    check_size(def->size, sizeof *def);
    ShapeDef taken;
    taken.density = def->density;
    taken.friction = def->friction;
    taken.restitution = def->restitution;
    taken.rolling_resistance = def->rolling_resistance;
    taken.surface_speed = def->surface_speed;
    taken.sensor = flag(def->sensor);
    taken.hit_events = flag(def->hit_events);
    taken.contact_events = flag(def->contact_events);
    taken.sensor_events = flag(def->sensor_events);
    taken.before_solve = flag(def->before_solve);
    taken.material = checked(Material{def->material});
    taken.category = def->category;
    taken.mask = def->mask;
    taken.group = def->group;
    taken.user_data = def->user_data;
    return taken;
}

MouseJointDef definition_of(const fettle_world* world, const fettle_mouse_joint_def* def) {
    const fettle_mouse_joint_def& given = needed("def", def);
    check_size(given.size, sizeof given);
    MouseJointDef taken;
    taken.body = body_named([] { return "body"; }, world, given.body).id();
    taken.target = position_of(given.target);
    if (flag(given.has_anchor)) taken.anchor = vector_of(given.anchor);
    taken.hertz = given.hertz;
    taken.damping_ratio = given.damping_ratio;
    taken.max_force = given.max_force;
    taken.enabled = flag(given.enabled);
    taken.user_data = given.user_data;
    return taken;
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
