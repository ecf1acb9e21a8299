#include <stdexcept>

#include "catch.h"
#include "scenes.h"

namespace joint_definitions_test {

using namespace scenes;

TEST_CASE("a definition has all that a joint can have") {
    World world;
    const Body a = add_box(world, {0, 0}), b = add_box(world, {2, 0});
    const RevoluteJoint pin = world.create_revolute_joint({.body_a = a.id(),
                                                           .body_b = b.id(),
                                                           .anchor_a = {1, 0},
                                                           .anchor_b = {-1, 0},
                                                           .break_force = 500,
                                                           .report_torque = 7,
                                                           .constraint_hertz = 30,
                                                           .reference_angle = 0.25f,
                                                           .lower_angle = -1,
                                                           .upper_angle = 2,
                                                           .motor_speed = 3,
                                                           .max_motor_torque = 4,
                                                           .hertz = 5,
                                                           .damping_ratio = 0.6f,
                                                           .target_angle = 0.7f});
    CHECK(pin.break_force() == 500);
    CHECK(pin.report_torque() == 7);
    CHECK(pin.report_force() == infinity);
    CHECK(pin.constraint_hertz() == 30);
    CHECK(pin.reference_angle() == 0.25f);
    CHECK(pin.lower_angle() == -1);
    CHECK(pin.upper_angle() == 2);
    CHECK(pin.motor_speed() == 3);
    CHECK(pin.max_motor_torque() == 4);
    CHECK(pin.hertz() == 5);
    CHECK(pin.damping_ratio() == 0.6f);
    CHECK(pin.target_angle() == 0.7f);
    const WheelJoint wheel = world.create_wheel_joint({.body_a = a.id(),
                                                       .body_b = b.id(),
                                                       .axis = {0, 2},
                                                       .lower_translation = -0.1f,
                                                       .upper_translation = 0.2f,
                                                       .hertz = 3,
                                                       .damping_ratio = 1,
                                                       .motor_speed = -4,
                                                       .max_motor_torque = 50});
    CHECK(wheel.axis() == Vec2(0, 2));
    CHECK(wheel.lower_translation() == -0.1f);
    CHECK(wheel.upper_translation() == 0.2f);
    CHECK(wheel.hertz() == 3);
    CHECK(wheel.damping_ratio() == 1);
    CHECK(wheel.motor_speed() == -4);
    CHECK(wheel.max_motor_torque() == 50);
    const PrismaticJoint rail = world.create_prismatic_joint({.body_a = a.id(),
                                                              .body_b = b.id(),
                                                              .axis = {0, 1},
                                                              .max_motor_force = 9,
                                                              .target_translation = 2,
                                                              .reference_angle = 0.5f});
    CHECK(rail.axis() == Vec2(0, 1));
    CHECK(rail.max_motor_force() == 9);
    CHECK(rail.target_translation() == 2);
    CHECK(rail.reference_angle() == 0.5f);
    const MotorJoint motor = world.create_motor_joint({.body_b = b.id(),
                                                       .linear_velocity = {1, 2},
                                                       .max_force = 3,
                                                       .linear_offset = {4, 5},
                                                       .angular_offset = 6.0f,
                                                       .hertz = 7});
    CHECK(motor.linear_velocity() == Vec2(1, 2));
    CHECK(motor.max_force() == 3);
    CHECK(motor.linear_offset() == Vec2(4, 5));
    CHECK(motor.angular_offset() == 6);
    CHECK(motor.hertz() == 7);
    const PulleyJoint pulley = world.create_pulley_joint({.body_a = a.id(),
                                                          .body_b = b.id(),
                                                          .ground_a = {0, 5},
                                                          .ground_b = {2, 5},
                                                          .ratio = 2,
                                                          .length = 20.0f});
    CHECK(pulley.ratio() == 2);
    CHECK(pulley.length() == 20);
    const RatchetJoint ratchet =
        world.create_ratchet_joint({.body_b = b.id(), .tooth = 0.3f, .backwards = true});
    CHECK(ratchet.tooth() == 0.3f);
    CHECK(ratchet.backwards());
    const DistanceJoint spring = world.create_distance_joint({.body_b = b.id(),
                                                              .length = 3.0f,
                                                              .min_length = 1,
                                                              .max_length = 5,
                                                              .hertz = 2,
                                                              .lower_spring_force = -6,
                                                              .upper_spring_force = 7,
                                                              .motor_speed = 8,
                                                              .max_motor_force = 9});
    CHECK(spring.length() == 3);
    CHECK(spring.min_length() == 1);
    CHECK(spring.max_length() == 5);
    CHECK(spring.lower_spring_force() == -6);
    CHECK(spring.upper_spring_force() == 7);
    CHECK(spring.motor_speed() == 8);
    CHECK(spring.max_motor_force() == 9);
}

TEST_CASE("values that a definition leaves open are measured") {
    World world;
    const Body a = add_box(world, {0, 0});
    const Body b = world.create_body({.position = {3, 0}, .angle = 0.5f});
    const JointDef ends = {.body_a = a.id(), .body_b = b.id()};
    CHECK(world.create_distance_joint(ends).length() == 3);
    CHECK(world.create_revolute_joint(ends).reference_angle() == 0.5f);
    CHECK(world.create_weld_joint(ends).reference_angle() == 0.5f);
    CHECK(world.create_motor_joint(ends).angular_offset() == 0.5f);
    CHECK(world.create_gear_joint(ends).phase() == 0.5f);
    const float taut = world
                           .create_pulley_joint({.body_a = a.id(),
                                                 .body_b = b.id(),
                                                 .ground_a = {0, 2},
                                                 .ground_b = {3, 4},
                                                 .ratio = 0.5f})
                           .length();
    CHECK(taut == Approx(2 + 0.5f * 4));
}

TEST_CASE("an invalid definition makes no joint") {
    World world;
    const Body body = add_box(world, {0, 0});
    CHECK_THROWS_WITH(world.create_wheel_joint({.body_b = body.id(), .axis = {0, 0}}),
                      contains("axis"));
    CHECK_THROWS_WITH(world.create_weld_joint({.body_b = body.id(), .report_force = -1}),
                      contains("report_force"));
    CHECK_THROWS_WITH(world.create_gear_joint({.body_b = body.id(), .constraint_hertz = infinity}),
                      contains("constraint_hertz"));
    CHECK_THROWS_WITH(
        world.create_distance_joint({.body_b = body.id(), .lower_spring_force = 1.0f}),
        contains("lower_spring_force"));
    CHECK_THROWS_WITH(world.create_ratchet_joint({.body_b = body.id(), .tooth = -1.0f}),
                      contains("tooth"));
    CHECK_THROWS_WITH(
        world.create_weld_joint({.body_b = body.id(), .constraint_damping_ratio = 3e38f}),
        contains("constraint_damping_ratio"));
    CHECK(world.joint_count() == 0);
}

TEST_CASE("a definition with a lower limit above the upper one is refused with both numbers") {
    World world;
    const BodyId b = add_box(world, {0, 0}).id();
    CHECK_THROWS_WITH(
        world.create_revolute_joint({.body_b = b, .lower_angle = 2, .upper_angle = 1}),
        "lower_angle = 2: expected at most upper_angle, which is 1");
    CHECK_THROWS_WITH(
        world.create_rotary_limit_joint({.body_b = b, .lower_angle = 0.5f, .upper_angle = -0.5f}),
        "lower_angle = 0.5: expected at most upper_angle, which is -0.5");
    const char* translation =
        "lower_translation = 0: expected at most upper_translation, which is -1";
    CHECK_THROWS_WITH(world.create_prismatic_joint(
                          {.body_b = b, .lower_translation = 0, .upper_translation = -1}),
                      translation);
    CHECK_THROWS_WITH(
        world.create_pin_slot_joint({.body_b = b, .lower_translation = 0, .upper_translation = -1}),
        translation);
    CHECK_THROWS_WITH(
        world.create_wheel_joint({.body_b = b, .lower_translation = 0, .upper_translation = -1}),
        translation);
    CHECK_THROWS_WITH(world.create_distance_joint({.body_b = b, .min_length = 3, .max_length = 2}),
                      "min_length = 3: expected at most max_length, which is 2");
    CHECK(world.joint_count() == 0);

    // Equal limits are a definition, and a handle sets one limit after the other.
    RevoluteJoint pin =
        world.create_revolute_joint({.body_b = b, .lower_angle = 1, .upper_angle = 1});
    pin.set_lower_angle(3);
    pin.set_upper_angle(4);
    CHECK(pin.lower_angle() == 3);
}

}  // namespace joint_definitions_test
