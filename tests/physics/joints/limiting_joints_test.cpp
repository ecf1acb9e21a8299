#include "catch.h"
#include "scenes.h"

namespace limiting_joints_test {

// Filter joints, rotary limit joints, and the limits and the motor of springs.

using namespace scenes;

TEST_CASE("bodies of a filter joint pass through each other and through nothing else") {
    World world;
    add_floor(world);
    Body low = add_box(world, {0, 0.5f}), high = add_box(world, {0.1f, 3});
    FilterJoint filter = world.create_filter_joint({.body_a = low.id(), .body_b = high.id()});
    run(world, 3.0f);
    CHECK(high.position().y == Approx(0.5f).margin(0.02));
    CHECK(low.position().y == Approx(0.5f).margin(0.02));
    CHECK(filter.force().length() == 0);
    CHECK_FALSE(world.validate());
    filter.destroy();
    run(world, 2.0f);
    CHECK(std::abs(high.position().x - low.position().x) > 0.9f);  // they were pushed apart
}

TEST_CASE("a filter joint connects no islands and can be switched off") {
    World world;
    add_floor(world);
    Body resting = add_box(world, {0, 0.5f}), moving = add_ball(world, {5, 4});
    FilterJoint filter = world.create_filter_joint({.body_a = resting.id(), .body_b = moving.id()});
    const auto keep_moving = [&](float seconds) {
        for (float t = 0; t < seconds; t += frame) {
            moving.set_velocity({0, 1});
            world.step(frame);
        }
    };
    keep_moving(3.0f);
    CHECK_FALSE(resting.awake());
    CHECK(moving.awake());
    CHECK_FALSE(world.validate());
    moving.set_position({0, 3});
    moving.set_velocity({0, 0});
    filter.set_enabled(false);
    run(world, 2.0f);
    CHECK(moving.position().y > 1.2f);
}

TEST_CASE("a filter joint is saved and can be dormant") {
    World world;
    Body a = add_box(world, {0, 0}), b = add_box(world, {0.2f, 0});
    const Joint dormant = world.create_joint(JointType::filter);
    world.create_filter_joint({.body_a = a.id(), .body_b = b.id()});
    std::vector<std::byte> bytes;
    world.save(bytes);
    World other;
    other.restore(bytes);
    for (World* each : {&world, &other}) {
        run(*each, 0.5f);
        CHECK(each->contacts().empty());
        CHECK_FALSE(each->validate());
    }
    CHECK(world.hash() == other.hash());
    CHECK(dormant.dormant());
}

TEST_CASE("a rotary limit holds an angle wherever the bodies are") {
    for (const Solver solver : {Solver::soft_step, Solver::sequential, Solver::direct}) {
        World world({.gravity = {0, 0}, .sleeping = false, .solver = solver});
        Body a = add_box(world, {0, 0}), b = add_box(world, {20, 3});
        RotaryLimitJoint limit = world.create_rotary_limit_joint(
            {.body_a = a.id(), .body_b = b.id(), .lower_angle = -0.5f, .upper_angle = 1.0f});
        b.set_angular_velocity(3);
        b.set_velocity({1, 0});
        run(world, 0.25f);
        CHECK(limit.angle() == Approx(0.75f).epsilon(0.05));  // free between the limits
        CHECK(limit.torque() == 0);
        run(world, 1.0f);
        CHECK(limit.angle() == Approx(1.0f).margin(0.02));
        CHECK(a.angular_velocity() == Approx(1.5f).epsilon(0.05));  // both turn together
        CHECK(b.position().x == Approx(21.25f).epsilon(0.01));
        b.set_angular_velocity(-9);
        run(world, 1.0f);
        CHECK(limit.angle() == Approx(-0.5f).margin(0.02));
        CHECK_FALSE(world.validate());
    }
}

TEST_CASE("a rotary limit counts from its reference angle and turns") {
    World world({.gravity = {0, 0}, .sleeping = false});
    Body body = world.create_body({.angle = 7.0f});
    body.add(Box{});
    RotaryLimitJoint limit = world.create_rotary_limit_joint({.body_b = body.id()});
    CHECK(limit.angle() == 0);
    limit.set_upper_angle(10);
    body.set_angular_velocity(20);
    run(world, 2.0f);
    CHECK(body.angle() == Approx(17).margin(0.03));
    limit.set_lower_angle(12);  // the upper limit is used
    run(world, 1.0f);
    CHECK(body.angle() == Approx(17).margin(0.03));
}

TEST_CASE("a spring pulls and pushes with no more than its limits") {
    for (const Solver solver : {Solver::soft_step, Solver::sequential, Solver::direct}) {
        World world({.gravity = {0, 0}, .sleeping = false, .solver = solver});
        Body ball = add_ball(world, {10, 0});
        DistanceJoint spring = world.create_distance_joint({.body_b = ball.id(),
                                                            .length = 2.0f,
                                                            .hertz = 3,
                                                            .lower_spring_force = -4,
                                                            .upper_spring_force = 1});
        run(world, 0.5f);
        CHECK(ball.velocity().x == Approx(-4 * 0.5f / ball.mass()).epsilon(0.02));
        CHECK(spring.force().x == Approx(-4).epsilon(0.01));
        ball.set_position({0.5f, 0});
        ball.set_velocity({0, 0});
        run(world, 0.25f);
        CHECK(ball.velocity().x == Approx(1 * 0.25f / ball.mass()).epsilon(0.05));
    }
}

TEST_CASE("the motor of a distance joint drives to its limits") {
    for (const Solver solver : {Solver::soft_step, Solver::sequential, Solver::direct}) {
        World world({.gravity = {0, 0}, .sleeping = false, .solver = solver});
        Body ball = add_ball(world, {2, 0});
        DistanceJoint winch = world.create_distance_joint({.body_b = ball.id(),
                                                           .min_length = 1,
                                                           .max_length = 4,
                                                           .hertz = 0,
                                                           .motor_speed = 1,
                                                           .max_motor_force = 100});
        run(world, 1.0f);
        CHECK(winch.distance() == Approx(3).epsilon(0.02));
        run(world, 3.0f);
        CHECK(winch.distance() == Approx(4).margin(0.02));
        winch.set_motor_speed(-2);
        run(world, 1.0f);
        CHECK(winch.distance() == Approx(2).epsilon(0.03));
        run(world, 2.0f);
        CHECK(winch.distance() == Approx(1).margin(0.02));
        ball.set_force({20, 0});
        winch.set_motor_speed(0);
        run(world, 0.5f);
        CHECK(winch.motor_force() == Approx(-20).epsilon(0.02));
        CHECK(winch.distance() == Approx(1).margin(0.02));
    }
}

TEST_CASE("a rod has no motor") {
    World world({.gravity = {0, 0}});
    Body ball = add_ball(world, {2, 0});
    const auto rod = world.create_distance_joint(
        {.body_b = ball.id(), .motor_speed = 3, .max_motor_force = 100});
    run(world, 1.0f);
    CHECK(rod.distance() == Approx(2).margin(1e-3));
    CHECK(rod.motor_force() == 0);
}

}  // namespace limiting_joints_test
