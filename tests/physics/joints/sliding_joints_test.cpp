#include "catch.h"
#include "scenes.h"

namespace sliding_joints_test {

using namespace scenes;

namespace {

constexpr float pi = 3.14159265f;
const Vec2 slanted = Vec2(0.6f, 0.8f);

/// How far anchor b is beside the line through anchor a.
float beside(const Joint& joint, const Vec2& axis) {
    const Vec2 gap = joint.world_anchor_b() - joint.world_anchor_a();
    return std::fabs(axis.x * gap.y - axis.y * gap.x) / axis.length();
}

}  // namespace

TEST_CASE(
    "a drawer falls along its slanted axis at the share of gravity and neither turns nor leaves "
    "it") {
    World world({.sleeping = false});
    Body box = add_box(world, {0, 0});
    PrismaticJoint rail = world.create_prismatic_joint({
        .body_b = box.id(),
        .anchor_b = {0.4f, 0.3f},
    });
    rail.set_anchor_a({0.4f, 0.3f});
    rail.set_axis(3 * slanted);
    for (int i = 0; i < 60; ++i) {
        world.step(frame);
        REQUIRE(beside(rail, slanted) < 0.001f);
        REQUIRE(std::fabs(rail.angle()) < 0.001f);
    }
    // s = ½ g sin(α) t², with half a sub-step more for the way the positions are integrated.
    REQUIRE(rail.translation() == Approx(-0.5f * 10.0f * 0.8f).epsilon(0.01));
}

TEST_CASE("the motor of a drawer reaches its speed and stays under its force") {
    World world({.gravity = {0, 0}, .sleeping = false});
    Body box = add_box(world, {0, 0});
    PrismaticJoint rail = world.create_prismatic_joint({.body_b = box.id()});
    rail.set_motor_speed(2.0f);
    run(world, 0.5f);
    REQUIRE(box.velocity().length() == 0.0f);
    rail.set_max_motor_force(0.5f * box.mass());
    run(world, 2.0f);
    REQUIRE(box.velocity().x == Approx(1.0f).epsilon(0.01));  // 0.5 m/s² for 2 s
    REQUIRE(rail.motor_force() == Approx(0.5f * box.mass()).epsilon(0.01));
    run(world, 3.0f);
    REQUIRE(box.velocity().x == Approx(2.0f).epsilon(0.001));
    REQUIRE(std::fabs(rail.motor_force()) < 0.01f);
}

TEST_CASE("a drawer stops at its limits and its spring swings with its frequency") {
    World world({.gravity = {0, 0}, .sleeping = false});
    Body box = add_box(world, {0, 0});
    PrismaticJoint rail = world.create_prismatic_joint({.body_b = box.id()});
    rail.set_lower_translation(-1.0f);
    rail.set_upper_translation(2.0f);
    box.set_force({3, 5});
    run(world, 4.0f);
    REQUIRE(rail.translation() == Approx(2.0f).margin(0.005));
    REQUIRE(rail.force().x == Approx(-3.0f).epsilon(0.02));
    REQUIRE(rail.force().y == Approx(-5.0f).epsilon(0.02));
    box.set_force({-3, 0});
    run(world, 4.0f);
    REQUIRE(rail.translation() == Approx(-1.0f).margin(0.005));
    box.set_force({0, 0});
    rail.set_lower_translation(-infinity);
    rail.set_upper_translation(infinity);
    box.set_position({0, 0});
    box.set_velocity({0, 0});
    rail.set_hertz(2.0f);
    rail.set_target_translation(0.5f);
    for (int i = 0; i < 60; ++i) {
        world.step(frame);
        REQUIRE(rail.translation() ==
                Approx(0.5f - 0.5f * std::cos(4 * pi * float(i + 1) * frame)).margin(0.04));
    }
}

// The limit and the motor hold the load together: what both read is what the body needs.
TEST_CASE("a motor that presses against a limit carries its load and holds still") {
    for (const int substeps : {1, 2, 3, 4, 5}) {
        for (const float strength : {20.0f, 100.0f, 1000.0f, 1e5f}) {
            CAPTURE(substeps, strength);
            World world({.substeps = substeps});
            Body lift = add_box(world, {0, 0});
            PrismaticJoint rail = world.create_prismatic_joint({.body_b = lift.id(),
                                                                .axis = {0, 1},
                                                                .lower_translation = -1,
                                                                .upper_translation = 1,
                                                                .motor_speed = 3,
                                                                .max_motor_force = strength});
            lift.set_can_sleep(false);
            run(world, 3);
            const float load = lift.mass() * -world.gravity().y;
            for (int i = 0; i < 3; ++i) {
                world.step(frame);
                CHECK(rail.force().y == Approx(load).epsilon(0.01));
                CHECK(rail.motor_force() > 0.99f * load);
                CHECK(std::abs(lift.velocity().y) < 1e-4f);
            }
            CHECK(rail.translation() == Approx(1).epsilon(substeps > 1 ? 1e-3 : 2e-3));
        }
    }
}

TEST_CASE("a drawer loaded far from its rail neither jams nor sags") {
    World world({.sleeping = false});
    Body box = add_box(world, {0, 0});
    box.add(Box{.width = 1, .height = 0.2f, .center = {4, 0}});  // its weight turns it
    PrismaticJoint rail = world.create_prismatic_joint({.body_b = box.id()});
    rail.set_max_motor_force(100.0f);
    rail.set_motor_speed(1.0f);
    run(world, 2.0f);
    REQUIRE(std::fabs(rail.angle()) < 0.002f);
    REQUIRE(rail.translation() == Approx(2.0f).epsilon(0.02));
    const float lever = box.world_center().x - box.position().x;
    REQUIRE(rail.torque() == Approx(10.0f * box.mass() * lever).epsilon(0.02));
}

TEST_CASE("a rail that turns carries its slider around and keeps it on the line") {
    World world({.gravity = {0, 0}, .sleeping = false});
    Body arm = world.create_body({.type = BodyType::kinematic_body, .angular_velocity = 2.0f});
    Body box = add_box(world, {1, 0}, 0.5f);
    PinSlotJoint slot = world.create_pin_slot_joint({.body_a = arm.id(), .body_b = box.id()});
    slot.set_upper_translation(1.5f);
    box.set_velocity({0, 2});
    for (int i = 0; i < 300; ++i) {
        world.step(frame);
        REQUIRE(beside(slot, arm.world_vector({1, 0})) < 0.01f);
    }
    // Thrown outward, it lies at the end: centripetal force m ω² r.
    REQUIRE(slot.translation() == Approx(1.5f).margin(0.02));
    REQUIRE(slot.force().length() == Approx(box.mass() * 4.0f * 1.5f).epsilon(0.03));
}

TEST_CASE("a pin in a slot turns freely and each of its properties has an effect at once") {
    World world({.gravity = {0, 0}});
    Body box = add_box(world, {0, 0});
    PinSlotJoint slot = world.create_pin_slot_joint({.body_b = box.id()});
    box.set_angular_velocity(3.0f);
    run(world, 1.0f);
    REQUIRE(box.angular_velocity() == Approx(3.0f).epsilon(1e-3));
    box.set_angular_velocity(0.0f);
    run(world, 2.0f);
    REQUIRE_FALSE(box.awake());
    slot.set_axis({0, 1});
    REQUIRE(box.awake());
    slot.set_max_motor_force(10.0f);
    slot.set_motor_speed(1.0f);
    run(world, 2.0f);
    REQUIRE(box.velocity().y == Approx(1.0f).epsilon(0.01));
    slot.set_upper_translation(3.0f);
    run(world, 3.0f);
    REQUIRE(slot.translation() == Approx(3.0f).margin(0.01));
    slot.set_max_motor_force(0.0f);
    slot.set_hertz(2.0f);
    slot.set_damping_ratio(1.0f);
    slot.set_target_translation(1.0f);
    run(world, 3.0f);
    REQUIRE(slot.translation() == Approx(1.0f).margin(0.01));
    REQUIRE_THROWS_WITH(slot.set_axis({0, 0}), contains("axis"));
}

TEST_CASE("a pin in a groove stays between its ends") {
    World world({.sleeping = false});
    Body ball = add_ball(world, {1, 0}, 0.2f);
    GrooveJoint groove = world.create_groove_joint({.body_b = ball.id(), .anchor_a = {0, 0}});
    groove.set_end({3, -1});
    run(world, 10.0f);
    REQUIRE((ball.position() - Position(3, -1)).length() < 0.01f);
    groove.set_end({3, 1});  // now it rises: back to where it begins
    run(world, 10.0f);
    REQUIRE(Vec2(ball.position()).length() < 0.01f);
    groove.set_end({0, 0});  // no length: a pin
    ball.set_velocity({2, 0});
    run(world, 1.0f);
    REQUIRE(Vec2(ball.position()).length() < 0.02f);
}

TEST_CASE("a suspension gives by the load over its stiffness") {
    World world({.sleeping = false});
    Body chassis = world.create_body({.position = {0, 1}, .locked_rotation = true});
    chassis.add(Box{.width = 4, .height = 0.5f}, {.category = 2, .mask = 2});
    Body wheel = add_ball(world, {0, 0.4f}, 0.4f);
    add_floor(world);
    WheelJoint joint = world.create_wheel_joint(
        {.body_a = chassis.id(), .body_b = wheel.id(), .anchor_a = {0, -0.6f}});
    joint.set_damping_ratio(1.0f);
    for (const float hertz : {3.0f, 6.0f}) {
        joint.set_hertz(hertz);
        run(world, 4.0f);
        // The spring has the frequency of both masses against each other.
        const float mass = 1.0f / (1.0f / chassis.mass() + 1.0f / wheel.mass());
        const float stiffness = mass * (2 * pi * hertz) * (2 * pi * hertz);
        REQUIRE(joint.translation() == Approx(10.0f * chassis.mass() / stiffness).epsilon(0.03));
    }
    joint.set_hertz(0.0f);
    joint.set_upper_translation(0.1f);
    run(world, 3.0f);
    REQUIRE(joint.translation() == Approx(0.1f).margin(0.005));
}

TEST_CASE("the motor of a wheel drives a car at its speed and with no more than its torque") {
    World world({.sleeping = false});
    add_floor(world, 400.0f);
    Body chassis = world.create_body({.position = {0, 1}});
    chassis.add(Box{.width = 3, .height = 0.5f});
    std::vector<WheelJoint> axles;
    for (const float x : {-1.0f, 1.0f}) {
        Body wheel = add_ball(world, {x, 0.4f}, 0.4f, {.friction = 1.0f});
        axles.push_back(world.create_wheel_joint(
            {.body_a = chassis.id(), .body_b = wheel.id(), .anchor_a = {x, -0.6f}}));
    }
    run(world, 2.0f);
    axles[0].set_motor_speed(-20.0f);
    axles[0].set_max_motor_torque(2.0f);
    for (int i = 0; i < 900; ++i) {
        world.step(frame);
        REQUIRE(std::fabs(axles[0].motor_torque()) <= 2.0f * 1.001f);
        REQUIRE(std::fabs(chassis.angle()) < 0.3f);
    }
    REQUIRE(chassis.velocity().x == Approx(20.0f * 0.4f).epsilon(0.02));
}

}  // namespace sliding_joints_test
