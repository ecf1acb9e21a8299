#include "catch.h"
#include "scenes.h"

namespace coupling_joints_test {

using namespace scenes;

namespace {

constexpr float pi = 3.14159265f;

/// A wheel pinned to the world at its center.
Body add_axle(World& world, const Vec2& at, float radius) {
    Body wheel = add_ball(world, at, radius);
    world.create_revolute_joint({.body_b = wheel.id(), .anchor_a = at});
    return wheel;
}

}  // namespace

TEST_CASE("a welded cantilever of five boxes holds its load") {
    World world({.sleeping = false});
    BodyId before = {};
    Body box;
    std::vector<WeldJoint> welds;
    for (int i = 0; i < 5; ++i) {
        box = add_box(world, {float(i) + 0.5f, 0});
        welds.push_back(world.create_weld_joint({.body_a = before,
                                                 .body_b = box.id(),
                                                 .anchor_a = {before ? 0.5f : 0.0f, 0},
                                                 .anchor_b = {-0.5f, 0}}));
        before = box.id();
    }
    run(world, 5.0f);
    REQUIRE(std::fabs(box.position().y) < 0.08f);
    REQUIRE(std::fabs(box.angle()) < 0.02f);
    REQUIRE(welds[0].force().y == Approx(50.0f).epsilon(0.02));
    // 10 N at each of 0.5 m ... 4.5 m.
    REQUIRE(welds[0].torque() == Approx(125.0f).epsilon(0.02));
}

TEST_CASE("the moment at a weld is that of the load") {
    World world({.sleeping = false});
    Body beam = world.create_body({.position = {2, 0}});
    beam.add(Box{.width = 4, .height = 0.2f});
    WeldJoint weld = world.create_weld_joint({.body_b = beam.id(), .anchor_b = {-2, 0}});
    run(world, 2.0f);
    const float weight = 10.0f * beam.mass();
    REQUIRE(weld.force().y == Approx(weight).epsilon(0.01));
    // The torque of the weld balances the torque of its force about the center of mass.
    REQUIRE(weld.torque() == Approx(2.0f * weight).epsilon(0.01));
    REQUIRE(std::fabs(beam.angle()) < 0.001f);
    REQUIRE(beam.position().y == Approx(0.0f).margin(0.002));
}

TEST_CASE("a soft weld swings with its frequency about its angle") {
    World world({.gravity = {0, 0}, .sleeping = false});
    Body wheel = add_ball(world, {0, 0}, 1.0f);
    WeldJoint weld = world.create_weld_joint({.body_b = wheel.id()});
    weld.set_angular_hertz(2.0f);
    weld.set_reference_angle(-0.5f);
    for (int i = 0; i < 60; ++i) {
        world.step(frame);
        REQUIRE(weld.angle() ==
                Approx(0.5f * std::cos(4 * pi * float(i + 1) * frame)).margin(0.04));
    }
    weld.set_angular_damping_ratio(1.0f);
    weld.set_hertz(1.0f);
    weld.set_damping_ratio(1.0f);
    wheel.set_position({3, 0});
    run(world, 4.0f);
    REQUIRE(std::fabs(weld.angle()) < 0.01f);
    REQUIRE(Vec2(wheel.position()).length() < 0.01f);
    weld.set_hertz(0.0f);  // the point is free
    wheel.set_velocity({1, 0});
    run(world, 1.0f);
    REQUIRE(wheel.position().x == Approx(1.0f).epsilon(0.05));
}

TEST_CASE("a motor drives a body to its velocity with no more than its force and torque") {
    World world({.gravity = {0, 0}, .sleeping = false});
    Body box = add_box(world, {0, 0});
    MotorJoint motor = world.create_motor_joint({.body_b = box.id()});
    motor.set_linear_velocity({3, 4});
    motor.set_angular_velocity(2.0f);
    run(world, 0.5f);
    REQUIRE(box.velocity().length() == 0.0f);
    motor.set_max_force(box.mass());
    motor.set_max_torque(0.5f * box.inertia());
    run(world, 2.0f);
    REQUIRE(box.velocity().length() == Approx(2.0f).epsilon(0.01));
    REQUIRE(box.angular_velocity() == Approx(1.0f).epsilon(0.01));
    REQUIRE(motor.force().length() == Approx(box.mass()).epsilon(0.01));
    run(world, 5.0f);
    REQUIRE((box.velocity() - Vec2(3, 4)).length() < 0.01f);
    REQUIRE(box.angular_velocity() == Approx(2.0f).epsilon(0.01));
    REQUIRE(motor.force().length() < 0.01f);
}

TEST_CASE("a motor with a stiffness brings a body to its offset from a moving one") {
    World world({.gravity = {0, 0}, .sleeping = false});
    Body carrier = world.create_body(
        {.type = BodyType::kinematic_body, .velocity = {1, 0}, .angular_velocity = 0.5f});
    Body box = add_box(world, {4, 4});
    MotorJoint motor = world.create_motor_joint({.body_a = carrier.id(), .body_b = box.id()});
    motor.set_hertz(3.0f);
    motor.set_linear_offset({2, 0});
    motor.set_angular_offset(1.0f);
    motor.set_max_force(1000.0f);
    motor.set_max_torque(1000.0f);
    run(world, 5.0f);
    REQUIRE((carrier.local_point(box.position()) - Vec2(2, 0)).length() < 0.1f);
    REQUIRE(box.angle() - carrier.angle() == Approx(1.0f).margin(0.03));
}

TEST_CASE("a motor without velocity acts like friction up to its force") {
    World world({.gravity = {0, 0}, .sleeping = false});
    Body box = add_box(world, {0, 0});
    MotorJoint motor = world.create_motor_joint({.body_b = box.id()});
    motor.set_max_force(5.0f);
    box.set_force({4.9f, 0});
    run(world, 2.0f);
    REQUIRE(Vec2(box.position()).length() < 0.001f);
    box.set_force({6.0f, 0});
    run(world, 2.0f);
    REQUIRE(box.velocity().x == Approx(2.0f).epsilon(0.01));  // (6 - 5) N on 1 kg
}

TEST_CASE("a pulley keeps the length of its rope and accelerates by the masses") {
    World world({.sleeping = false});
    Body a = add_box(world, {-2, 0}), b = add_box(world, {2, 0});
    b.set_mass(3.0f);
    PulleyJoint pulley = world.create_pulley_joint({.body_a = a.id(), .body_b = b.id()});
    pulley.set_ground_a({-2, 10});
    pulley.set_ground_b({2, 10});
    pulley.set_length(20.0f);
    for (int i = 0; i < 60; ++i) {
        world.step(frame);
        REQUIRE(pulley.length_a() + pulley.length_b() == Approx(20.0f).margin(0.01));
    }
    // Atwood: a = g (m_b - m_a)/(m_a + m_b), T = 2 m_a m_b g/(m_a + m_b).
    REQUIRE(a.velocity().y == Approx(5.0f).epsilon(0.01));
    REQUIRE(pulley.tension() == Approx(15.0f).epsilon(0.01));
}

TEST_CASE("a tackle of three parts balances a threefold load and a slack rope pulls nothing") {
    World world({.sleeping = false});
    Body a = add_box(world, {-2, 0}), b = add_box(world, {2, 0});
    b.set_mass(3.0f);
    PulleyJoint pulley = world.create_pulley_joint({.body_a = a.id(), .body_b = b.id()});
    pulley.set_ground_a({-2, 10});
    pulley.set_ground_b({2, 10});
    pulley.set_ratio(3.0f);
    pulley.set_length(10.0f + 30.0f);
    run(world, 2.0f);
    REQUIRE(std::fabs(a.velocity().y) < 0.01f);
    a.set_velocity({0, -3});
    run(world, 0.5f);
    const float sum = pulley.length_a() + 3 * pulley.length_b();
    REQUIRE(sum == Approx(40.0f).margin(0.03));
    REQUIRE(b.velocity().y == Approx(-a.velocity().y / 3).epsilon(0.02));
    pulley.set_length(100.0f);
    const float before = a.velocity().y;
    run(world, 0.5f);
    REQUIRE(a.velocity().y == Approx(before - 5.0f).epsilon(0.01));
    REQUIRE(pulley.tension() == 0.0f);
}

TEST_CASE("gears keep their ratio over many turns and pass their torque on") {
    World world({.gravity = {0, 0}, .sleeping = false});
    Body small = add_axle(world, {0, 0}, 0.5f), large = add_axle(world, {2.5f, 0}, 2.0f);
    GearJoint gear = world.create_gear_joint({.body_a = small.id(), .body_b = large.id()});
    gear.set_ratio(-0.25f);
    gear.set_phase(0.0f);
    small.set_torque(1.0f);
    for (int i = 0; i < 600; ++i) {
        world.step(frame);
        REQUIRE(large.angle() == Approx(-0.25f * small.angle()).margin(0.002));
    }
    // α = τ / (I_a + ratio² I_b) for ten seconds.
    const float alpha = 1.0f / (small.inertia() + large.inertia() / 16);
    REQUIRE(small.angular_velocity() == Approx(10.0f * alpha).epsilon(0.01));
    REQUIRE(gear.torque() == Approx(-0.25f * large.inertia() * alpha).epsilon(0.02));
    small.set_torque(0.0f);
    small.set_angular_velocity(0.0f);
    large.set_angular_velocity(0.0f);
    gear.set_ratio(2.0f);
    gear.set_phase(large.angle() - 2 * small.angle() + 1.0f);  // off by 1 rad
    run(world, 2.0f);
    REQUIRE(large.angle() - 2 * small.angle() == Approx(gear.phase()).margin(0.005));
}

TEST_CASE("a ratchet turns freely one way and holds at its teeth the other way") {
    World world({.gravity = {0, 0}, .sleeping = false});
    Body wheel = add_axle(world, {0, 0}, 1.0f);
    RatchetJoint ratchet = world.create_ratchet_joint({.body_b = wheel.id()});
    ratchet.set_tooth(0.5f);
    wheel.set_angular_velocity(1.0f);
    run(world, 1.2f);
    REQUIRE(ratchet.angle() == Approx(1.2f).epsilon(0.01));  // free that way
    REQUIRE(ratchet.caught_angle() == Approx(1.0f));
    wheel.set_angular_velocity(0.0f);
    wheel.set_torque(-3.0f);
    run(world, 3.0f);
    REQUIRE(ratchet.angle() == Approx(1.0f).margin(0.01));
    REQUIRE(ratchet.torque() == Approx(3.0f).epsilon(0.01));
    ratchet.set_tooth(0.0f);
    wheel.set_torque(1.0f);
    run(world, 0.5f);
    wheel.set_torque(-1.0f);
    wheel.set_angular_velocity(0.0f);
    const float here = ratchet.angle();
    run(world, 2.0f);
    REQUIRE(ratchet.angle() == Approx(here).margin(0.02));
    ratchet.set_backwards(true);
    run(world, 2.0f);
    REQUIRE(ratchet.angle() < here - 1.0f);
    wheel.set_torque(2.0f);
    wheel.set_angular_velocity(0.0f);
    const float there = ratchet.angle();
    run(world, 2.0f);
    REQUIRE(ratchet.angle() == Approx(there).margin(0.02));
}

TEST_CASE(
    "the caught angle of a ratchet is kept in sleep and in copies and set anew when it is "
    "enabled") {
    World world({.gravity = {0, 0}});
    Body wheel = add_axle(world, {0, 0}, 1.0f);
    RatchetJoint ratchet = world.create_ratchet_joint({.body_b = wheel.id()});
    ratchet.set_tooth(0.5f);
    wheel.set_angle(1.2f);
    run(world, 2.0f);
    REQUIRE_FALSE(wheel.awake());
    REQUIRE(ratchet.caught_angle() == Approx(1.0f));
    World copy = world.clone();
    REQUIRE(copy.joint<RatchetJoint>(ratchet.id()).caught_angle() == Approx(1.0f));
    ratchet.set_enabled(false);
    wheel.set_angle(-0.7f);
    run(world, 0.1f);
    ratchet.set_enabled(true);
    run(world, 0.1f);
    REQUIRE(ratchet.caught_angle() == Approx(-1.0f));
}

}  // namespace coupling_joints_test
