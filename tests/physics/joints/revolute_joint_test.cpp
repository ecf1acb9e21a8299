#include "catch.h"
#include "scenes.h"

namespace revolute_joint_test {

using namespace scenes;

namespace {

constexpr float pi = 3.14159265f;

/// A wheel that turns about its center, pinned to the world.
struct Wheel {
    World world{{.gravity = {0, 0}, .sleeping = false}};
    Body body = add_ball(world, {0, 0}, 1.0f);
    RevoluteJoint pin = world.create_revolute_joint({.body_b = body.id()});
};

float gap(const Joint& joint) {
    return (joint.world_anchor_b() - joint.world_anchor_a()).length();
}

}  // namespace

TEST_CASE("a bar pinned at its end swings with its period and stays on its pin") {
    World world({.sleeping = false});
    const float length = 2.0f, angle = 0.1f;
    Body bar = world.create_body({.angle = angle});
    bar.add(Box{.width = 0.2f, .height = length});
    bar.set_position(Vec2(std::sin(angle), -std::cos(angle)) * (length / 2));
    const RevoluteJoint pin =
        world.create_revolute_joint({.body_b = bar.id(), .anchor_b = {0, length / 2}});
    // T = 2π √(I / (m g l)) with I about the pin.
    const float inertia = bar.inertia() + bar.mass() * length * length / 4;
    const float expected =
        2 * pi * std::sqrt(inertia / (bar.mass() * 10.0f * length / 2)) * (1 + angle * angle / 16);
    int passes = 0;
    float first = 0.0f, last = 0.0f;
    for (int i = 1; passes < 11; ++i) {
        const float before = bar.angle();
        world.step(frame);
        REQUIRE(gap(pin) < 0.002f);
        if (before >= 0.0f || bar.angle() < 0.0f) continue;
        last = (float(i) - bar.angle() / (bar.angle() - before)) * frame;
        if (passes++ == 0) first = last;
    }
    REQUIRE((last - first) / 10 == Approx(expected).epsilon(0.01));
}

TEST_CASE("a motor reaches its speed and is no stronger than its torque") {
    Wheel wheel;
    wheel.pin.set_motor_speed(3.0f);
    run(wheel.world, 0.5f);
    REQUIRE(wheel.body.angular_velocity() == 0.0f);  // without torque there is none
    const float torque = 0.5f * wheel.body.inertia();
    wheel.pin.set_max_motor_torque(torque);
    run(wheel.world, 2.0f);
    REQUIRE(wheel.body.angular_velocity() == Approx(1.0f).epsilon(0.01));  // 0.5 rad/s² for 2 s
    REQUIRE(wheel.pin.motor_torque() == Approx(torque).epsilon(0.01));
    run(wheel.world, 6.0f);
    REQUIRE(wheel.body.angular_velocity() == Approx(3.0f).epsilon(0.001));
    REQUIRE(std::fabs(wheel.pin.motor_torque()) < 0.01f * torque);
    wheel.pin.set_max_motor_torque(infinity);
    wheel.pin.set_motor_speed(-20.0f);
    wheel.world.step(frame);
    REQUIRE(wheel.body.angular_velocity() == Approx(-20.0f).epsilon(0.001));
}

TEST_CASE("limits hold a pin between two angles and over many turns") {
    Wheel wheel;
    wheel.pin.set_lower_angle(-0.5f);
    wheel.pin.set_upper_angle(1.0f);
    wheel.body.set_torque(2.0f);
    run(wheel.world, 3.0f);
    REQUIRE(wheel.pin.angle() == Approx(1.0f).margin(0.01));
    REQUIRE(wheel.pin.torque() == Approx(-2.0f).epsilon(0.02));
    wheel.body.set_torque(-2.0f);
    run(wheel.world, 3.0f);
    REQUIRE(wheel.pin.angle() == Approx(-0.5f).margin(0.01));
    wheel.pin.set_lower_angle(-5 * pi);
    run(wheel.world, 20.0f);
    REQUIRE(wheel.pin.angle() == Approx(-5 * pi).margin(0.02));
    wheel.body.set_torque(0.0f);
    wheel.pin.set_upper_angle(-6 * pi);  // counts where they cross
    run(wheel.world, 20.0f);
    REQUIRE(wheel.pin.angle() == Approx(-6 * pi).margin(0.02));
}

TEST_CASE("the spring of a pin swings about its target with its frequency") {
    Wheel wheel;
    wheel.pin.set_hertz(2.0f);
    wheel.pin.set_target_angle(0.5f);
    float highest = 0.0f;
    for (int i = 0; i < 60; ++i) {
        wheel.world.step(frame);
        highest = std::max(highest, wheel.pin.angle());
        // 0.5 - 0.5 cos(2π · 2 Hz · t)
        REQUIRE(wheel.pin.angle() ==
                Approx(0.5f - 0.5f * std::cos(4 * pi * float(i + 1) * frame)).margin(0.04));
    }
    REQUIRE(highest == Approx(1.0f).epsilon(0.02));
    wheel.pin.set_damping_ratio(1.0f);
    run(wheel.world, 2.0f);
    REQUIRE(wheel.pin.angle() == Approx(0.5f).epsilon(0.01));
}

TEST_CASE("two pinned bodies keep their momentum and their pin") {
    World world({.gravity = {0, 0}, .sleeping = false});
    Body a = add_box(world, {0, 0}), b = add_box(world, {1, 0}, 0.5f);
    const RevoluteJoint pin = world.create_revolute_joint(
        {.body_a = a.id(), .body_b = b.id(), .anchor_a = {0.5f, 0.5f}, .anchor_b = {-0.5f, 0.5f}});
    b.set_velocity({0, 4});
    b.set_angular_velocity(-8.0f);
    const Vec2 momentum = b.mass() * b.velocity();
    for (int i = 0; i < 300; ++i) {
        world.step(frame);
        REQUIRE(gap(pin) < 0.01f);
    }
    const Vec2 after = a.mass() * a.velocity() + b.mass() * b.velocity();
    REQUIRE((after - momentum).length() < 1e-3f);
    REQUIRE(std::fabs(b.angular_velocity() - a.angular_velocity()) > 1.0f);
}

TEST_CASE(
    "a chain of 30 links with a ball of a hundred links' weight stretches under two percent") {
    World world({.sleeping = false});
    const int links = 30;
    const float length = 0.5f;
    BodyId above = {};
    Body link;
    for (int i = 0; i < links; ++i) {
        link = world.create_body({.position = {0, -length * (float(i) + 0.5f)}});
        link.add(Box{.width = 0.1f, .height = length}, {.density = 20.0f});
        world.create_revolute_joint({.body_a = above,
                                     .body_b = link.id(),
                                     .anchor_a = {0, above ? -length / 2 : 0.0f},
                                     .anchor_b = {0, length / 2}});
        above = link.id();
    }
    Body ball = add_ball(world, {0, -length * float(links)}, 0.5f, {.mask = 0});
    ball.set_mass(100.0f * link.mass());
    world.create_revolute_joint(
        {.body_a = above, .body_b = ball.id(), .anchor_a = {0, -length / 2}});
    auto stretch = [&] {
        float sum = 0.0f;
        for (const Joint& joint : world.joints()) sum += gap(joint);
        return sum / (length * float(links));
    };
    for (int i = 0; i < 600; ++i) {
        world.step(frame);
        REQUIRE(stretch() < 0.02f);
    }
    REQUIRE(stretch() < 0.01f);
    // Pushed aside it swings, and neither flies nor tears.
    ball.set_velocity({3, 0});
    for (int i = 0; i < 600; ++i) {
        world.step(frame);
        REQUIRE(stretch() < 0.02f);
    }
}

// The limits, the pins and the motor of an arm of two parts are solved one after the other.
// The point of the pin holds the reactions of both, which cancel; it yielded to that of the spring.
TEST_CASE("a motor that winds up the spring of its pin does not pull the pin apart") {
    for (const Solver solver : {Solver::soft_step, Solver::direct}) {
        for (const float torque : {1.0f, 10.0f, 100.0f}) {
            CAPTURE(int(solver), torque);
            World world({.gravity = {0, 0}, .solver = solver});
            Body arm = world.create_body({.position = {0.75f, 0}});
            arm.add(Box{.width = 0.8f, .height = 0.04f});
            const RevoluteJoint pin = world.create_revolute_joint({.body_b = arm.id(),
                                                                   .anchor_b = {-0.75f, 0},
                                                                   .motor_speed = 7,
                                                                   .max_motor_torque = torque,
                                                                   .hertz = 4});
            float widest = 0.0f;
            for (int i = 0; i < 200; ++i) {
                world.step(0.02f);
                widest = std::max(widest, Vec2(arm.world_point({-0.75f, 0})).length());
            }
            CHECK(widest < 0.004f);
            CHECK(pin.angle() > 0.3f);
        }
    }
}

TEST_CASE("an arm whose elbow motor presses against its limit comes to rest") {
    const float rate = GENERATE(30.0f, 60.0f, 144.0f);
    const float torque = GENERATE(20.0f, 40.0f, 300.0f);
    World world;
    Body upper = world.create_body({.position = {0.5f, 0}}),
         fore = world.create_body({.position = {1.5f, 0}});
    for (Body part : {upper, fore}) part.add(Box{.width = 1, .height = 0.2f}, {.density = 5});
    world.create_revolute_joint(
        {.body_b = upper.id(), .anchor_b = {-0.5f, 0}, .lower_angle = -0.5f, .upper_angle = 0.5f});
    const RevoluteJoint elbow = world.create_revolute_joint({.body_a = upper.id(),
                                                             .body_b = fore.id(),
                                                             .anchor_a = {0.5f, 0},
                                                             .anchor_b = {-0.5f, 0},
                                                             .lower_angle = -0.2f,
                                                             .upper_angle = 0.2f,
                                                             .motor_speed = 2,
                                                             .max_motor_torque = torque});
    for (int i = 0; i < int(10 * rate); ++i) world.step(1 / rate);
    CHECK_FALSE(fore.awake());
    CHECK(elbow.angle() == Approx(0.2).margin(0.002));
    CHECK(elbow.force().length() == Approx(fore.mass() * 10).epsilon(0.02));
}

TEST_CASE("an arm of several links whose strong motors press against their limits comes to rest") {
    const int links = GENERATE(2, 3, 4);
    const float torque = GENERATE(100.0f, 300.0f);
    const float gravity = GENERATE(0.0f, -10.0f);
    World world({.gravity = {0, gravity}});
    Body last;
    for (int i = 0; i < links; ++i) {
        Body link = world.create_body({.position = {float(i) + 0.5f, 5}});
        link.add(Box{.width = 1, .height = 0.2f}, {.density = 5});
        world.create_revolute_joint({.body_a = last.id(),
                                     .body_b = link.id(),
                                     .anchor_a = last ? Vec2(0.5f, 0) : Vec2(0, 5),
                                     .anchor_b = {-0.5f, 0},
                                     .lower_angle = -0.3f,
                                     .upper_angle = 0.3f,
                                     .motor_speed = 2,
                                     .max_motor_torque = torque});
        last = link;
    }
    for (int i = 0; i < 60 * 10; ++i) world.step(frame);
    CHECK_FALSE(last.awake());
    CHECK(last.angle() == Approx(0.3 * links).margin(0.02));
}

}  // namespace revolute_joint_test
