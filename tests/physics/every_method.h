#pragma once

#include "scenes.h"

#include <functional>
#include <string>
#include <vector>

// Every method of the handles, and every one that edits a world: for rules that hold for all of
// them. A test compares the list with the headers.

namespace scenes {

/// One of each kind, in one world or in none.
struct Things {
    World& world;
    Body body = {}, other = {}, third = {};
    Shape circle = {}, box = {}, segment = {}, polygon = {}, ellipse = {}, chain = {};
    Joint joint = {};
    MouseJoint mouse = {};
    DistanceJoint distance = {};
    RevoluteJoint revolute = {};
    PrismaticJoint prismatic = {};
    WheelJoint wheel = {};
    WeldJoint weld = {};
    MotorJoint motor = {};
    PulleyJoint pulley = {};
    GearJoint gear = {};
    GrooveJoint groove = {};
    PinSlotJoint pin_slot = {};
    RatchetJoint ratchet = {};
    RotaryLimitJoint rotary_limit = {};
    Field field = {};
    std::vector<std::byte> bytes = {};  ///< of a saved world
};

inline JointDef joined(const Things& things) {
    return {.body_a = things.body.id(), .body_b = things.other.id()};
}

inline const std::vector<Vec2>& triangle() {
    static const std::vector<Vec2> points = {{0, 0}, {1, 0}, {0, 1}};
    return points;
}

/// A heap on a floor with a body of every shape, and joints of every type high above it.
inline Things make_things(World& world) {
    Things things = {.world = world};
    add_floor(world);
    for (int i = 0; i < 12; ++i) add_box(world, {0.9f * float(i % 4) - 4, 0.5f + float(i / 4)});
    things.body = world.create_body({.position = {5, 2}});
    things.circle = things.body.add(Circle{});
    things.box = things.body.add(Box{.center = {1, 0}});
    things.segment = things.body.add(Segment{.rounding = 0.1f});
    things.polygon = things.body.add(Polygon{.vertices = triangle()});
    things.ellipse = things.body.add(Ellipse{.center = {-1, 0}});
    things.other = add_box(world, {0, 40});
    things.third = add_box(world, {4, 40});
    things.chain = world.create_body({.type = BodyType::static_body, .position = {0, -20}})
                       .add(Chain{.points = {{-3, 0}, {0, 0}, {3, 0}}});
    const BodyId anchor = add_box(world, {8, 40}).id();
    const JointDef def = {.body_a = anchor, .body_b = things.other.id(), .collide = true};
    things.mouse = world.create_mouse_joint({.body = things.third.id(), .target = {4, 40}});
    things.distance = world.create_distance_joint(def);
    things.revolute = world.create_revolute_joint(def);
    things.prismatic = world.create_prismatic_joint(def);
    things.wheel = world.create_wheel_joint(def);
    things.joint = things.weld = world.create_weld_joint(def);
    things.motor = world.create_motor_joint(def);
    things.pulley = world.create_pulley_joint(def);
    things.gear = world.create_gear_joint(def);
    things.groove = world.create_groove_joint(def);
    things.pin_slot = world.create_pin_slot_joint(def);
    things.ratchet = world.create_ratchet_joint(def);
    things.rotary_limit = world.create_rotary_limit_joint(def);
    things.field = world.create_field({.force = DragField{.linear = 0.01f}});
    World().save(things.bytes);
    return things;
}

struct Method {
    std::string name;  ///< "Body::set_position"
    bool edits;
    std::function<void(Things&)> call;
};

#define READ(Class, method, object, arguments)                              \
    {                                                                       \
#Class "::" #method, false,                                         \
            [](Things & things) { (void)(things.object.method arguments); } \
    }
#define EDIT(Class, method, object, arguments)                                                     \
    {                                                                                              \
#Class "::" #method, true, [](Things & things) { (void)(things.object.method arguments); } \
    }

// clang-format off
inline const std::vector<Method>& every_method() {
    static const std::vector<Method> all = {
        READ(Body, world, body, ()),
        EDIT(Body, destroy, body, ()),
        READ(Body, type, body, ()),
        EDIT(Body, set_type, body, (BodyType::kinematic_body)),
        READ(Body, position, body, ()),
        EDIT(Body, set_position, body, (Vec2(0.6f, 0.8f))),
        READ(Body, angle, body, ()),
        EDIT(Body, set_angle, body, (0.5f)),
        EDIT(Body, set_pose, body, (Pose{{1, 2}, 0.5f})),
        READ(Body, velocity, body, ()),
        EDIT(Body, set_velocity, body, (Vec2(0.6f, 0.8f))),
        READ(Body, angular_velocity, body, ()),
        EDIT(Body, set_angular_velocity, body, (0.5f)),
        EDIT(Body, set_target, body, (Pose{{1, 2}, 0.5f}, 0.1f)),
        READ(Body, force, body, ()),
        EDIT(Body, set_force, body, (Vec2(0.6f, 0.8f))),
        READ(Body, torque, body, ()),
        EDIT(Body, set_torque, body, (0.5f)),
        EDIT(Body, apply_force, body, (Vec2(0.6f, 0.8f))),
        EDIT(Body, apply_force, body, (Vec2(0.6f, 0.8f), Vec2(0.6f, 0.8f))),
        EDIT(Body, apply_torque, body, (0.5f)),
        READ(Body, applied_force, body, ()),
        READ(Body, applied_torque, body, ()),
        EDIT(Body, apply_impulse, body, (Vec2(0.6f, 0.8f))),
        EDIT(Body, apply_impulse, body, (Vec2(0.6f, 0.8f), Vec2(0.6f, 0.8f))),
        EDIT(Body, apply_angular_impulse, body, (0.5f)),
        READ(Body, gravity_scale, body, ()),
        EDIT(Body, set_gravity_scale, body, (0.5f)),
        READ(Body, linear_damping, body, ()),
        EDIT(Body, set_linear_damping, body, (0.5f)),
        READ(Body, angular_damping, body, ()),
        EDIT(Body, set_angular_damping, body, (0.5f)),
        READ(Body, awake, body, ()),
        EDIT(Body, set_awake, body, (true)),
        READ(Body, can_sleep, body, ()),
        EDIT(Body, set_can_sleep, body, (true)),
        READ(Body, enabled, body, ()),
        EDIT(Body, set_enabled, body, (false)),
        READ(Body, name, body, ()),
        EDIT(Body, set_name, body, ("crate")),
        READ(Body, max_speed, body, ()),
        EDIT(Body, set_max_speed, body, (0.5f)),
        READ(Body, sleep_speed, body, ()),
        EDIT(Body, set_sleep_speed, body, (0.5f)),
        READ(Body, sleep_speed_override, body, ()),
        READ(Body, bullet, body, ()),
        EDIT(Body, set_bullet, body, (true)),
        READ(Body, locked_x, body, ()),
        EDIT(Body, set_locked_x, body, (true)),
        READ(Body, locked_y, body, ()),
        EDIT(Body, set_locked_y, body, (true)),
        READ(Body, locked_rotation, body, ()),
        EDIT(Body, set_locked_rotation, body, (true)),
        READ(Body, mass, body, ()),
        EDIT(Body, set_mass, body, (2.0f)),
        READ(Body, mass_override, body, ()),
        READ(Body, inertia, body, ()),
        EDIT(Body, set_inertia, body, (2.0f)),
        READ(Body, inertia_override, body, ()),
        READ(Body, center, body, ()),
        EDIT(Body, set_center, body, (Vec2(0.1f, 0))),
        READ(Body, center_override, body, ()),
        READ(Body, world_center, body, ()),
        READ(Body, area, body, ()),
        READ(Body, aabb, body, ()),
        READ(Body, rebuilds, body, ()),
        READ(Body, previous_pose, body, ()),
        READ(Body, interpolated, body, (0.5f)),
        READ(Body, world_point, body, (Vec2(0.6f, 0.8f))),
        READ(Body, local_point, body, (Vec2(0.6f, 0.8f))),
        READ(Body, world_vector, body, (Vec2(0.6f, 0.8f))),
        READ(Body, local_vector, body, (Vec2(0.6f, 0.8f))),
        READ(Body, velocity_at, body, (Vec2(0.6f, 0.8f))),
        READ(Body, kinetic_energy, body, ()),
        EDIT(Body, add, body, (Circle{})),
        READ(Body, shape_count, body, ()),
        READ(Body, joints, body, ()),
        READ(Body, shapes, body, ()),
        READ(Body, is_touching, body, ()),
        READ(Body, contacts, body, ()),
        READ(Body, user_data, body, ()),
        EDIT(Body, set_user_data, body, (1)),
        READ(Shape, world, box, ()),
        EDIT(Shape, destroy, box, ()),
        READ(Shape, type, box, ()),
        READ(Shape, body, box, ()),
        EDIT(Shape, attach, box, (things.other)),
        EDIT(Shape, detach, box, ()),
        READ(Shape, geometry, box, ()),
        EDIT(Shape, set_geometry, box, (Circle{})),
        READ(Shape, radius, circle, ()),
        EDIT(Shape, set_radius, circle, (0.5f)),
        READ(Shape, radius_x, ellipse, ()),
        EDIT(Shape, set_radius_x, ellipse, (0.5f)),
        READ(Shape, radius_y, ellipse, ()),
        EDIT(Shape, set_radius_y, ellipse, (0.5f)),
        READ(Shape, center, circle, ()),
        EDIT(Shape, set_center, circle, (Vec2(0.6f, 0.8f))),
        READ(Shape, width, box, ()),
        EDIT(Shape, set_width, box, (0.5f)),
        READ(Shape, height, box, ()),
        EDIT(Shape, set_height, box, (0.5f)),
        READ(Shape, angle, box, ()),
        EDIT(Shape, set_angle, box, (0.5f)),
        READ(Shape, rounding, box, ()),
        EDIT(Shape, set_rounding, box, (0.5f)),
        READ(Shape, from, segment, ()),
        EDIT(Shape, set_from, segment, (Vec2(0.6f, 0.8f))),
        READ(Shape, to, segment, ()),
        EDIT(Shape, set_to, segment, (Vec2(0.6f, 0.8f))),
        READ(Shape, vertices, polygon, ()),
        EDIT(Shape, set_vertices, polygon, (triangle())),
        EDIT(Shape, try_set_vertices, polygon, (triangle())),
        EDIT(Shape, add_vertex, polygon, (Vec2(0.6f, 0.8f))),
        READ(Shape, closed, chain, ()),
        EDIT(Shape, set_closed, chain, (true)),
        READ(Shape, pieces, box, ()),
        READ(Shape, density, box, ()),
        EDIT(Shape, set_density, box, (0.5f)),
        READ(Shape, friction, box, ()),
        EDIT(Shape, set_friction, box, (0.5f)),
        READ(Shape, restitution, box, ()),
        EDIT(Shape, set_restitution, box, (0.5f)),
        READ(Shape, rolling_resistance, box, ()),
        EDIT(Shape, set_rolling_resistance, box, (0.5f)),
        READ(Shape, surface_speed, box, ()),
        EDIT(Shape, set_surface_speed, box, (0.5f)),
        READ(Shape, sensor, box, ()),
        EDIT(Shape, set_sensor, box, (true)),
        READ(Shape, hit_events, box, ()),
        EDIT(Shape, set_hit_events, box, (true)),
        READ(Shape, contact_events, box, ()),
        EDIT(Shape, set_contact_events, box, (false)),
        READ(Shape, sensor_events, box, ()),
        EDIT(Shape, set_sensor_events, box, (false)),
        READ(Shape, before_solve, box, ()),
        EDIT(Shape, set_before_solve, box, (false)),
        READ(Shape, material, box, ()),
        EDIT(Shape, set_material, box, (3)),
        READ(Shape, category, box, ()),
        EDIT(Shape, set_category, box, (1)),
        READ(Shape, mask, box, ()),
        EDIT(Shape, set_mask, box, (1)),
        READ(Shape, group, box, ()),
        EDIT(Shape, set_group, box, (3)),
        READ(Shape, area, box, ()),
        READ(Shape, mass, box, ()),
        READ(Shape, aabb, box, ()),
        READ(Shape, world_vertices, box, ()),
        READ(Shape, world_center, box, ()),
        READ(Shape, contains, box, (Vec2(0.6f, 0.8f))),
        READ(Shape, is_touching, box, ()),
        READ(Shape, rebuilds, box, ()),
        READ(Shape, user_data, box, ()),
        EDIT(Shape, set_user_data, box, (1)),
        READ(Joint, world, joint, ()),
        EDIT(Joint, destroy, joint, ()),
        READ(Joint, type, joint, ()),
        READ(Joint, body_a, joint, ()),
        EDIT(Joint, set_body_a, joint, (things.third)),
        READ(Joint, body_b, joint, ()),
        EDIT(Joint, set_body_b, joint, (things.third)),
        EDIT(Joint, connect, joint, (things.body, things.third)),
        EDIT(Joint, disconnect, joint, ()),
        READ(Joint, dormant, joint, ()),
        READ(Joint, anchor_a, joint, ()),
        EDIT(Joint, set_anchor_a, joint, (Vec2(0.6f, 0.8f))),
        READ(Joint, anchor_b, joint, ()),
        EDIT(Joint, set_anchor_b, joint, (Vec2(0.6f, 0.8f))),
        READ(Joint, world_anchor_a, joint, ()),
        READ(Joint, world_anchor_b, joint, ()),
        READ(Joint, enabled, joint, ()),
        EDIT(Joint, set_enabled, joint, (true)),
        READ(Joint, collide, joint, ()),
        EDIT(Joint, set_collide, joint, (true)),
        READ(Joint, break_force, joint, ()),
        EDIT(Joint, set_break_force, joint, (0.5f)),
        READ(Joint, break_torque, joint, ()),
        EDIT(Joint, set_break_torque, joint, (0.5f)),
        READ(Joint, report_force, joint, ()), EDIT(Joint, set_report_force, joint, (3.0f)),
        READ(Joint, report_torque, joint, ()), EDIT(Joint, set_report_torque, joint, (3.0f)),
        READ(Joint, constraint_hertz, joint, ()), EDIT(Joint, set_constraint_hertz, joint, (30.0f)),
        READ(Joint, constraint_damping_ratio, joint, ()), EDIT(Joint, set_constraint_damping_ratio, joint, (1.0f)),
        READ(Joint, separation, joint, ()),
        READ(Joint, angular_separation, joint, ()),
        READ(Joint, broken, joint, ()),
        EDIT(Joint, set_broken, joint, (true)),
        READ(Joint, force, joint, ()),
        READ(Joint, torque, joint, ()),
        READ(Joint, user_data, joint, ()),
        EDIT(Joint, set_user_data, joint, (1)),
        READ(MouseJoint, body, mouse, ()),
        EDIT(MouseJoint, set_body, mouse, (things.other)),
        READ(MouseJoint, anchor, mouse, ()),
        EDIT(MouseJoint, set_anchor, mouse, (Vec2(0.6f, 0.8f))),
        READ(MouseJoint, target, mouse, ()),
        EDIT(MouseJoint, set_target, mouse, (Vec2(0.6f, 0.8f))),
        READ(MouseJoint, hertz, mouse, ()),
        EDIT(MouseJoint, set_hertz, mouse, (0.5f)),
        READ(MouseJoint, damping_ratio, mouse, ()),
        EDIT(MouseJoint, set_damping_ratio, mouse, (0.5f)),
        READ(MouseJoint, max_force, mouse, ()),
        EDIT(MouseJoint, set_max_force, mouse, (0.5f)),
        READ(DistanceJoint, length, distance, ()),
        EDIT(DistanceJoint, set_length, distance, (0.5f)),
        READ(DistanceJoint, min_length, distance, ()),
        EDIT(DistanceJoint, set_min_length, distance, (0.5f)),
        READ(DistanceJoint, max_length, distance, ()),
        EDIT(DistanceJoint, set_max_length, distance, (0.5f)),
        READ(DistanceJoint, hertz, distance, ()),
        EDIT(DistanceJoint, set_hertz, distance, (0.5f)),
        READ(DistanceJoint, damping_ratio, distance, ()),
        EDIT(DistanceJoint, set_damping_ratio, distance, (0.5f)),
        READ(DistanceJoint, lower_spring_force, distance, ()), EDIT(DistanceJoint, set_lower_spring_force, distance, (-3.0f)),
        READ(DistanceJoint, upper_spring_force, distance, ()), EDIT(DistanceJoint, set_upper_spring_force, distance, (3.0f)),
        READ(DistanceJoint, motor_speed, distance, ()), EDIT(DistanceJoint, set_motor_speed, distance, (0.5f)),
        READ(DistanceJoint, max_motor_force, distance, ()), EDIT(DistanceJoint, set_max_motor_force, distance, (0.5f)),
        READ(DistanceJoint, motor_force, distance, ()),
        READ(DistanceJoint, distance, distance, ()),
        READ(RevoluteJoint, angle, revolute, ()),
        READ(RevoluteJoint, reference_angle, revolute, ()),
        EDIT(RevoluteJoint, set_reference_angle, revolute, (0.5f)),
        READ(RevoluteJoint, lower_angle, revolute, ()),
        EDIT(RevoluteJoint, set_lower_angle, revolute, (0.5f)),
        READ(RevoluteJoint, upper_angle, revolute, ()),
        EDIT(RevoluteJoint, set_upper_angle, revolute, (0.5f)),
        READ(RevoluteJoint, motor_speed, revolute, ()),
        EDIT(RevoluteJoint, set_motor_speed, revolute, (0.5f)),
        READ(RevoluteJoint, max_motor_torque, revolute, ()),
        EDIT(RevoluteJoint, set_max_motor_torque, revolute, (0.5f)),
        READ(RevoluteJoint, hertz, revolute, ()),
        EDIT(RevoluteJoint, set_hertz, revolute, (0.5f)),
        READ(RevoluteJoint, damping_ratio, revolute, ()),
        EDIT(RevoluteJoint, set_damping_ratio, revolute, (0.5f)),
        READ(RevoluteJoint, target_angle, revolute, ()),
        EDIT(RevoluteJoint, set_target_angle, revolute, (0.5f)),
        READ(RevoluteJoint, motor_torque, revolute, ()),
        READ(PrismaticJoint, axis, prismatic, ()),
        EDIT(PrismaticJoint, set_axis, prismatic, (Vec2(0.6f, 0.8f))),
        READ(PrismaticJoint, translation, prismatic, ()),
        READ(PrismaticJoint, lower_translation, prismatic, ()),
        EDIT(PrismaticJoint, set_lower_translation, prismatic, (0.5f)),
        READ(PrismaticJoint, upper_translation, prismatic, ()),
        EDIT(PrismaticJoint, set_upper_translation, prismatic, (0.5f)),
        READ(PrismaticJoint, motor_speed, prismatic, ()),
        EDIT(PrismaticJoint, set_motor_speed, prismatic, (0.5f)),
        READ(PrismaticJoint, max_motor_force, prismatic, ()),
        EDIT(PrismaticJoint, set_max_motor_force, prismatic, (0.5f)),
        READ(PrismaticJoint, motor_force, prismatic, ()),
        READ(PrismaticJoint, hertz, prismatic, ()),
        EDIT(PrismaticJoint, set_hertz, prismatic, (0.5f)),
        READ(PrismaticJoint, damping_ratio, prismatic, ()),
        EDIT(PrismaticJoint, set_damping_ratio, prismatic, (0.5f)),
        READ(PrismaticJoint, target_translation, prismatic, ()),
        EDIT(PrismaticJoint, set_target_translation, prismatic, (0.5f)),
        READ(PrismaticJoint, angle, prismatic, ()),
        READ(PrismaticJoint, reference_angle, prismatic, ()),
        EDIT(PrismaticJoint, set_reference_angle, prismatic, (0.5f)),
        READ(PinSlotJoint, axis, pin_slot, ()),
        EDIT(PinSlotJoint, set_axis, pin_slot, (Vec2(0.6f, 0.8f))),
        READ(PinSlotJoint, translation, pin_slot, ()),
        READ(PinSlotJoint, lower_translation, pin_slot, ()),
        EDIT(PinSlotJoint, set_lower_translation, pin_slot, (0.5f)),
        READ(PinSlotJoint, upper_translation, pin_slot, ()),
        EDIT(PinSlotJoint, set_upper_translation, pin_slot, (0.5f)),
        READ(PinSlotJoint, motor_speed, pin_slot, ()),
        EDIT(PinSlotJoint, set_motor_speed, pin_slot, (0.5f)),
        READ(PinSlotJoint, max_motor_force, pin_slot, ()),
        EDIT(PinSlotJoint, set_max_motor_force, pin_slot, (0.5f)),
        READ(PinSlotJoint, motor_force, pin_slot, ()),
        READ(PinSlotJoint, hertz, pin_slot, ()),
        EDIT(PinSlotJoint, set_hertz, pin_slot, (0.5f)),
        READ(PinSlotJoint, damping_ratio, pin_slot, ()),
        EDIT(PinSlotJoint, set_damping_ratio, pin_slot, (0.5f)),
        READ(PinSlotJoint, target_translation, pin_slot, ()),
        EDIT(PinSlotJoint, set_target_translation, pin_slot, (0.5f)),
        READ(GrooveJoint, end, groove, ()),
        EDIT(GrooveJoint, set_end, groove, (Vec2(0.6f, 0.8f))),
        READ(GrooveJoint, translation, groove, ()),
        READ(WheelJoint, axis, wheel, ()),
        EDIT(WheelJoint, set_axis, wheel, (Vec2(0.6f, 0.8f))),
        READ(WheelJoint, translation, wheel, ()),
        READ(WheelJoint, hertz, wheel, ()),
        EDIT(WheelJoint, set_hertz, wheel, (0.5f)),
        READ(WheelJoint, damping_ratio, wheel, ()),
        EDIT(WheelJoint, set_damping_ratio, wheel, (0.5f)),
        READ(WheelJoint, lower_translation, wheel, ()),
        EDIT(WheelJoint, set_lower_translation, wheel, (0.5f)),
        READ(WheelJoint, upper_translation, wheel, ()),
        EDIT(WheelJoint, set_upper_translation, wheel, (0.5f)),
        READ(WheelJoint, motor_speed, wheel, ()),
        EDIT(WheelJoint, set_motor_speed, wheel, (0.5f)),
        READ(WheelJoint, max_motor_torque, wheel, ()),
        EDIT(WheelJoint, set_max_motor_torque, wheel, (0.5f)),
        READ(WheelJoint, motor_torque, wheel, ()),
        READ(WeldJoint, angle, weld, ()),
        READ(WeldJoint, reference_angle, weld, ()),
        EDIT(WeldJoint, set_reference_angle, weld, (0.5f)),
        READ(WeldJoint, hertz, weld, ()),
        EDIT(WeldJoint, set_hertz, weld, (0.5f)),
        READ(WeldJoint, damping_ratio, weld, ()),
        EDIT(WeldJoint, set_damping_ratio, weld, (0.5f)),
        READ(WeldJoint, angular_hertz, weld, ()),
        EDIT(WeldJoint, set_angular_hertz, weld, (0.5f)),
        READ(WeldJoint, angular_damping_ratio, weld, ()),
        EDIT(WeldJoint, set_angular_damping_ratio, weld, (0.5f)),
        READ(MotorJoint, linear_velocity, motor, ()),
        EDIT(MotorJoint, set_linear_velocity, motor, (Vec2(0.6f, 0.8f))),
        READ(MotorJoint, angular_velocity, motor, ()),
        EDIT(MotorJoint, set_angular_velocity, motor, (0.5f)),
        READ(MotorJoint, max_force, motor, ()),
        EDIT(MotorJoint, set_max_force, motor, (0.5f)),
        READ(MotorJoint, max_torque, motor, ()),
        EDIT(MotorJoint, set_max_torque, motor, (0.5f)),
        READ(MotorJoint, linear_offset, motor, ()),
        EDIT(MotorJoint, set_linear_offset, motor, (Vec2(0.6f, 0.8f))),
        READ(MotorJoint, angular_offset, motor, ()),
        EDIT(MotorJoint, set_angular_offset, motor, (0.5f)),
        READ(MotorJoint, hertz, motor, ()),
        EDIT(MotorJoint, set_hertz, motor, (0.5f)),
        READ(MotorJoint, damping_ratio, motor, ()),
        EDIT(MotorJoint, set_damping_ratio, motor, (0.5f)),
        READ(PulleyJoint, ground_a, pulley, ()),
        EDIT(PulleyJoint, set_ground_a, pulley, (Vec2(0.6f, 0.8f))),
        READ(PulleyJoint, ground_b, pulley, ()),
        EDIT(PulleyJoint, set_ground_b, pulley, (Vec2(0.6f, 0.8f))),
        READ(PulleyJoint, ratio, pulley, ()),
        EDIT(PulleyJoint, set_ratio, pulley, (0.5f)),
        READ(PulleyJoint, length, pulley, ()),
        EDIT(PulleyJoint, set_length, pulley, (0.5f)),
        READ(PulleyJoint, length_now, pulley, ()),
        READ(PulleyJoint, length_a, pulley, ()),
        READ(PulleyJoint, length_b, pulley, ()),
        READ(PulleyJoint, tension, pulley, ()),
        READ(GearJoint, ratio, gear, ()),
        EDIT(GearJoint, set_ratio, gear, (0.5f)),
        READ(GearJoint, phase, gear, ()),
        EDIT(GearJoint, set_phase, gear, (0.5f)),
        READ(GearJoint, phase_now, gear, ()),
        READ(RatchetJoint, angle, ratchet, ()),
        READ(RatchetJoint, reference_angle, ratchet, ()),
        EDIT(RatchetJoint, set_reference_angle, ratchet, (0.5f)),
        READ(RatchetJoint, tooth, ratchet, ()),
        EDIT(RatchetJoint, set_tooth, ratchet, (0.5f)),
        READ(RatchetJoint, backwards, ratchet, ()),
        EDIT(RatchetJoint, set_backwards, ratchet, (true)),
        READ(RatchetJoint, caught_angle, ratchet, ()),
        READ(RotaryLimitJoint, angle, rotary_limit, ()),
        READ(RotaryLimitJoint, reference_angle, rotary_limit, ()),
        EDIT(RotaryLimitJoint, set_reference_angle, rotary_limit, (0.5f)),
        READ(RotaryLimitJoint, lower_angle, rotary_limit, ()),
        EDIT(RotaryLimitJoint, set_lower_angle, rotary_limit, (-0.5f)),
        READ(RotaryLimitJoint, upper_angle, rotary_limit, ()),
        EDIT(RotaryLimitJoint, set_upper_angle, rotary_limit, (0.5f)),
        READ(Field, world, field, ()),
        EDIT(Field, destroy, field, ()),
        READ(Field, definition, field, ()),
        EDIT(Field, set, field, ({DragField{}})),
        EDIT(World, step, world, (1.0f / 60)),
        EDIT(World, set_gravity, world, ({0, -9})),
        EDIT(World, set_substeps, world, (3)),
        EDIT(World, set_bounds, world, (Aabb{{-50, -50}, {50, 50}})),
        EDIT(World, set_bounds_friction, world, (0.5f)),
        EDIT(World, set_bounds_restitution, world, (0.5f)),
        EDIT(World, set_sleeping, world, (false)),
        EDIT(World, set_continuous, world, (false)),
        EDIT(World, set_restitution_threshold, world, (2.0f)),
        EDIT(World, set_hit_threshold, world, (2.0f)),
        EDIT(World, set_sleep_speed, world, (0.1f)),
        EDIT(World, set_sleep_delay, world, (1.0f)),
        EDIT(World, set_contact_hertz, world, (30.0f)),
        EDIT(World, set_contact_damping, world, (5.0f)),
        EDIT(World, set_push_speed, world, (1.0f)),
        EDIT(World, set_solver, world, (Solver::sequential)),
        EDIT(World, set_friction_mix, world, (MixRule::average)),
        EDIT(World, set_restitution_mix, world, (MixRule::average)),
        EDIT(World, set_persist_events, world, (true)),
        EDIT(World, keep_account, world, (things.body.id())),
        EDIT(World, wake_all, world, ()),
        EDIT(World, ignore_until_separated, world, (things.box, things.circle)),
        EDIT(World, reserve, world, ({.bodies = 2})),
        EDIT(World, limit_simd_width, world, (4)),
        EDIT(World, set_threads, world, (2)),
        EDIT(World, set_scheduler, world, (nullptr, 2)),
        EDIT(World, set_filter, world, ({})),
        EDIT(World, set_mixing, world, ({})),
        EDIT(World, set_before_solve, world, ({})),
        EDIT(World, on_refresh, world, ({})),
        EDIT(World, refresh, world, ({})),
        EDIT(World, set_owner, world, (nullptr)),
        EDIT(World, create_body, world, ()),
        EDIT(World, create_shape, world, (Circle{})),
        EDIT(World, create_joint, world, (things.joint)),
        EDIT(World, create_mouse_joint, world, ({.body = things.body.id()})),
        EDIT(World, create_distance_joint, world, (joined(things))),
        EDIT(World, create_revolute_joint, world, (joined(things))),
        EDIT(World, create_prismatic_joint, world, (joined(things))),
        EDIT(World, create_wheel_joint, world, (joined(things))),
        EDIT(World, create_weld_joint, world, (joined(things))),
        EDIT(World, create_motor_joint, world, (joined(things))),
        EDIT(World, create_pulley_joint, world, (joined(things))),
        EDIT(World, create_gear_joint, world, (joined(things))),
        EDIT(World, create_groove_joint, world, (joined(things))),
        EDIT(World, create_pin_slot_joint, world, (joined(things))),
        EDIT(World, create_ratchet_joint, world, (joined(things))),
        EDIT(World, create_filter_joint, world, (joined(things))),
        EDIT(World, create_rotary_limit_joint, world, (joined(things))),
        EDIT(World, create_field, world, ({})),
        EDIT(World, clear, world, ()),
        EDIT(World, restore, world, (things.bytes)),
        EDIT(World, take, world, (World())),
        EDIT(World, explode, world, ({0, 1}, 2.0f, 3.0f)),
    };
    return all;
}
// clang-format on

#undef READ
#undef EDIT

}  // namespace scenes
