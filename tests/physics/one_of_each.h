#pragma once
// One object of each kind, and how a method that is called on them is listed.

#include "scenes.h"

#include <string>
#include <string_view>
#include <vector>

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
    std::string_view name;  ///< "Body::set_position"
    bool edits;
    void (*call)(Things&);
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

}  // namespace scenes
