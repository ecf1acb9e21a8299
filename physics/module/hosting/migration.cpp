// Migration: bodies and shapes move between worlds with all their data. A world owns its objects,
// so moving means creating the object there and destroying it here; the rows change, the handles do
// not.

#include <algorithm>

#include <hosting/hosting.h>

namespace fettle::physics_module {
namespace {

/// Limits a coordinate or an angle to the range of setters, which a simulation may slightly exceed.
float settable(float x) {
    constexpr float limit = 1e8f;  // m or rad
    return std::clamp(x, -limit, limit);
}

physics::BodyDef description(const physics::Body& body) {
    physics::BodyDef def;
    def.type = body.type();
    def.position = {settable(body.position().x), settable(body.position().y)};
    def.angle = settable(body.angle());
    def.velocity = body.velocity();
    def.angular_velocity = body.angular_velocity();
    def.force = body.force();
    def.torque = body.torque();
    def.gravity_scale = body.gravity_scale();
    def.linear_damping = body.linear_damping();
    def.angular_damping = body.angular_damping();
    def.mass = body.mass_override();
    def.inertia = body.inertia_override();
    def.can_sleep = body.can_sleep();
    def.bullet = body.bullet();
    def.locked_x = body.locked_x();
    def.locked_y = body.locked_y();
    def.locked_rotation = body.locked_rotation();
    def.enabled = body.enabled();
    def.sleep_speed = body.sleep_speed_override();
    def.max_speed = body.max_speed();
    def.user_data = body.user_data();
    return def;
}

physics::ShapeDef description(const physics::Shape& shape) {
    physics::ShapeDef def;
    def.density = shape.density();
    def.friction = shape.friction();
    def.restitution = shape.restitution();
    def.rolling_resistance = shape.rolling_resistance();
    def.surface_speed = shape.surface_speed();
    def.sensor = shape.sensor();
    def.hit_events = shape.hit_events();
    def.contact_events = shape.contact_events();
    def.sensor_events = shape.sensor_events();
    def.before_solve = shape.before_solve();
    def.material = shape.material();
    def.category = shape.category();
    def.mask = shape.mask();
    def.group = shape.group();
    def.user_data = shape.user_data();
    return def;
}

}  // namespace

Row Hosting::migrate_body(Row from, std::uint32_t to) {
    require_unlocked(from);
    physics::Body old = body(from);
    HostedWorld& target = *worlds_[to];
    physics::BodyDef def = description(old);
    def.velocity = velocity(from);
    const std::string name = old.name();
    def.name = name;
    const bool awake = old.awake();

    // The operations that may be refused come first, so that a refusal changes nothing.
    const std::vector<physics::Shape> shapes = old.shapes();
    std::vector<physics::Shape> copies;
    physics::Body fresh = target.world.create_body(def);
    target.written_poses.note_new(fresh.index());
    const Row row = row_of(to, fresh);
    try {
        for (const physics::Shape& shape : shapes) {
            copies.push_back(copy_shape(shape, to));
            copies.back().attach(fresh);
        }
    } catch (...) {
        for (physics::Shape& copy : copies) copy.destroy();
        fresh.destroy();
        throw;
    }
    for (std::size_t i = 0; i < shapes.size(); ++i) {
        const Handle instance = unpack(shapes[i].user_data());
        const Row left = make_row(world_number(from), shapes[i].index());
        const Row placed = replace_shape(left, to, copies[i]);
        if (instance) tree.set_row(instance, placed);  // the capsule of a mover has none
    }
    if (const auto center = old.center_override()) fresh.set_center(center);
    // Computes the new center of mass now, since the velocity is that of the center.
    fresh.mass();
    fresh.set_angular_velocity(def.angular_velocity);
    set_velocity(row, def.velocity);
    if (!awake) fresh.set_awake(false);
    // Forces that wait for the next step act in the first step of the new world.
    if (const physics::Vec2 force = old.applied_force(); force != physics::Vec2{})
        fresh.apply_force(force);
    if (const float torque = old.applied_torque(); torque != 0) fresh.apply_torque(torque);
    hosted(from).velocities.reset(slot_of(from));
    const auto color = hosted(from).body_colors.take(slot_of(from));
    if (color) target.body_colors.set(fresh.index(), color);
    if (MoverRecord mover = hosted(from).movers.get(slot_of(from)); mover.slot != 0) {
        hosted(from).movers.reset(slot_of(from));
        mover.result.on_ground = 0;
        mover.result.ground_x = mover.result.ground_y = 0.0f;
        mover.result.ground = mover.result.dropped = mover.events.bumped =
            mover.events.was_ground = {};
        target.movers.set(fresh.index(), mover);
    }
    joints.disconnect_all(old);
    old.destroy();
    joints.set_connect_needed();
    return row;
}

Row Hosting::migrate_shape(Row from, std::uint32_t to, const physics::Body& owner) {
    require_unlocked(from);
    physics::Shape fresh = copy_shape(shape(from), to);
    if (owner) fresh.attach(owner);
    return replace_shape(from, to, fresh);
}

/// Creates a copy of the shape in another world, without a body.
physics::Shape Hosting::copy_shape(const physics::Shape& shape, std::uint32_t to) {
    physics::Shape made = worlds_[to]->world.create_shape(shape.geometry(), description(shape));
    (void)row_of(to, made);
    if (shape.type() == physics::ShapeType::chain)
        made.set_segment_surfaces(shape.segment_surface_overrides());
    return made;
}

/// Destroys the shape at `from`, which `fresh` replaces. Returns the row of `fresh`.
Row Hosting::replace_shape(Row from, std::uint32_t to, const physics::Shape& fresh) {
    store_departure(from);
    if (!hosted(from).looks.empty()) {
        const Look look = hosted(from).looks.take(slot_of(from));
        if (look.fill || look.border || !look.visible || look.orientation_mark)
            worlds_[to]->looks.set(fresh.index(), look);
    }
    shape(from).destroy();
    return make_row(to, fresh.index());
}

}  // namespace fettle::physics_module
