#include <fettle/physics/host_access.h>

#include "catch.h"
#include "scenes.h"

namespace motion_test {

using namespace scenes;

TEST_CASE("a body in free fall follows the parabola") {
    World world;
    Body ball = add_ball(world, {0, 100});
    ball.set_velocity({3, 4});
    run(world, 2.0f);
    REQUIRE(ball.velocity().y == Approx(4.0f - 20.0f).epsilon(1e-4));
    REQUIRE(ball.position().x == Approx(6.0f).epsilon(1e-4));
    // Symplectic Euler is low by half a sub-step of velocity change: g t h / 2.
    REQUIRE(ball.position().y == Approx(100.0f + 8.0f - 20.0f).margin(0.05));
}

TEST_CASE("a falling box comes to rest on the floor") {
    World world;
    add_floor(world);
    Body box = add_box(world, {0, 3});
    run(world, 3.0f);
    REQUIRE(box.position().y == Approx(0.5f).margin(0.003));
    REQUIRE(std::fabs(box.angle()) < 1e-3f);
    REQUIRE(box.velocity().length() < 1e-3f);
}

TEST_CASE("a body whose mass becomes infinite stops falling and a finite mass brings it back") {
    World world;
    Body ball = add_ball(world, {0, 10});
    run(world, 0.5f);
    ball.set_mass(infinity);
    run(world, 0.1f);
    const Position there = ball.position();
    run(world, 1.0f);
    REQUIRE(ball.position() == there);
    REQUIRE(ball.velocity() == Vec2(0, 0));
    REQUIRE(ball.mass() == infinity);
    ball.set_mass(2.0f);
    run(world, 1.0f);
    REQUIRE(ball.position().y < there.y - 4.0f);
}

TEST_CASE("a body of infinite mass carries others like a static one") {
    World world;
    Body table = add_box(world, {0, 0}, 2.0f);
    table.set_mass(infinity);
    Body box = add_box(world, {0, 2});
    run(world, 2.0f);
    REQUIRE(table.position() == Vec2(0, 0));
    REQUIRE(box.position().y == Approx(1.5f).margin(0.01));
}

TEST_CASE("forces persist when set and last one step when applied") {
    World world({.gravity = {0, 0}});
    Body a = add_box(world, {0, 0}), b = add_box(world, {10, 0});
    a.set_force({2, 0});
    b.apply_force({2, 0});
    world.step(frame);
    REQUIRE(a.velocity().x == Approx(2.0f * frame));
    REQUIRE(b.velocity().x == Approx(2.0f * frame));
    world.step(frame);
    REQUIRE(a.velocity().x == Approx(4.0f * frame));
    REQUIRE(b.velocity().x == Approx(2.0f * frame));
    a.set_torque(1.0f);
    world.step(frame);
    REQUIRE(a.angular_velocity() == Approx(frame / a.inertia()));
}

TEST_CASE("an impulse at a point pushes and turns") {
    World world({.gravity = {0, 0}});
    Body box = add_box(world, {0, 0}, 2.0f);
    box.apply_impulse({0, 8}, {1, 0});
    REQUIRE(box.velocity().y == Approx(2.0f));
    REQUIRE(box.angular_velocity() == Approx(8.0f / box.inertia()));
}

TEST_CASE("after a step no velocity is above its limit though motors and joints want more") {
    for (const int substeps : {1, 4}) {
        World world({.substeps = substeps});
        Body wheel = world.create_body();
        wheel.add(Box{});
        world.create_revolute_joint(
            {.body_b = wheel.id(), .motor_speed = 1e6f, .max_motor_torque = 1e30f});
        Body slide = world.create_body({.position = {9, 0}});
        slide.add(Box{});
        world.create_prismatic_joint({.body_b = slide.id(),
                                      .anchor_a = {9, 0},
                                      .axis = {1, 1},
                                      .motor_speed = 1e6f,
                                      .max_motor_force = 1e30f});
        for (int i = 0; i < 20; ++i) {
            world.step(frame);
            CHECK(std::fabs(wheel.angular_velocity()) <= 3.001f * 60 * float(substeps));
            CHECK(slide.velocity().length() <= 10001.0f);
        }
        CHECK(wheel.angular_velocity() > 2.9f * 60 * float(substeps));
    }
}

TEST_CASE("damping slows exponentially and gravity scale scales") {
    World world;
    Body damped =
        world.create_body({.velocity = {10, 0}, .gravity_scale = 0.0f, .linear_damping = 1.0f});
    Body floating = world.create_body({.position = {0, 5}, .gravity_scale = -0.5f});
    run(world, 1.0f);
    REQUIRE(damped.velocity().x == Approx(10.0f * std::exp(-1.0f)).epsilon(0.01));
    REQUIRE(floating.velocity().y == Approx(5.0f));
}

TEST_CASE("locked axes do not move and locked rotation does not turn") {
    World world;
    Body x = world.create_body({.velocity = {3, 0}, .locked_x = true});
    Body y = world.create_body({.position = {5, 0}, .velocity = {3, 0}, .locked_y = true});
    Body turn =
        world.create_body({.position = {10, 0}, .angular_velocity = 3, .locked_rotation = true});
    for (Body b : {x, y, turn}) b.add(Box{});
    run(world, 0.5f);
    REQUIRE(x.position().x == 0.0f);
    REQUIRE(x.position().y < -1.0f);
    REQUIRE(y.position().y == 0.0f);
    REQUIRE(y.position().x == Approx(6.5f).epsilon(1e-3));
    REQUIRE(turn.angle() == 0.0f);
    turn.set_locked_rotation(false);
    turn.set_angular_velocity(1.0f);
    x.set_locked_x(false);
    x.set_velocity({1, 0});
    run(world, 0.1f);
    REQUIRE(turn.angle() > 0.05f);
    REQUIRE(x.position().x > 0.05f);
}

TEST_CASE("a kinematic body turns about its position unless its center was set") {
    World world;
    Body door = world.create_body(
        {.type = BodyType::kinematic_body, .position = {3, 1}, .angular_velocity = 2});
    door.add(Box{.width = 2, .height = 0.2f, .center = {1, 0}});
    REQUIRE(door.center() == Vec2(0, 0));
    for (int i = 0; i < 30; ++i) world.step(1.0f / 60);
    REQUIRE(door.position() == Position(3, 1));
    REQUIRE(door.angle() == Approx(1).margin(1e-4));
    door.set_type(BodyType::dynamic_body);
    REQUIRE(door.center().x == Approx(1).margin(1e-5));
    REQUIRE(door.velocity().length() == Approx(2).margin(1e-4));  // it goes on as it was
    door.set_type(BodyType::kinematic_body);
    REQUIRE(door.velocity().length() == Approx(0).margin(1e-4));
    door.set_center(Vec2(1, 0));
    world.step(1.0f / 60);
    REQUIRE(door.position() != Position(3, 1));
}

TEST_CASE("a kinematic body moves by its velocity and carries bodies") {
    World world;
    Body belt = world.create_body({.type = BodyType::kinematic_body, .velocity = {1, 0}});
    belt.add(Box{.width = 20, .height = 1});
    Body box = add_box(world, {0, 1});
    run(world, 2.0f);
    REQUIRE(belt.position().x == Approx(2.0f).epsilon(1e-3));
    REQUIRE(belt.position().y == 0.0f);
    // Until friction (6 m/s²) has brought it up to speed, it slips by v²/2a.
    REQUIRE(box.position().x == Approx(2.0f - 1.0f / 12.0f).margin(0.01));
    REQUIRE(box.awake());
}

TEST_CASE("a slow rotation changes the angle however large it is") {
    World world({.gravity = {0, 0}, .sleeping = false});
    Body top = world.create_body({.angle = 40000.0f, .angular_velocity = 0.05f});
    top.add(Box{});
    run(world, 10.0f);
    REQUIRE(top.angle() == Approx(40000.5f).margin(0.005));
}

TEST_CASE("drawing between steps interpolates and a teleport does not smear") {
    World world({.gravity = {0, 0}});
    Body ball = add_ball(world, {0, 0});
    ball.set_velocity({6, 0});
    world.step(frame);
    REQUIRE(ball.interpolated(0.0f).position.x == Approx(0.0f).margin(1e-6));
    REQUIRE(ball.interpolated(0.5f).position.x == Approx(0.05f));
    REQUIRE(ball.interpolated(1.0f).position == ball.position());
    ball.set_position({100, 0});
    REQUIRE(ball.interpolated(0.5f).position.x == 100.0f);
}

TEST_CASE("the columns show the same as the handles") {
    World world;
    Body ball = add_ball(world, {1, 2});
    run(world, 0.3f);
    REQUIRE(HostAccess::state(world, ball.index()).position == ball.position());
    REQUIRE(HostAccess::states(world)[ball.index()].velocity == ball.velocity());
    REQUIRE(HostAccess::body_generation(world, ball.index()) == ball.id().generation);
    REQUIRE(HostAccess::previous(world, ball.index()).position == ball.previous_pose().position);
}

TEST_CASE("a change of the number of substeps or of the time step keeps a stack standing") {
    World world({.sleeping = false});
    add_floor(world);
    std::vector<Body> stack;
    for (int i = 0; i < 5; ++i) stack.push_back(add_box(world, {0, 0.5f + float(i)}));
    for (int i = 0; i < 240; ++i) {
        if (i == 100) world.set_substeps(8);
        world.step(i % 2 == 0 ? 1.0f / 120 : 1.0f / 60);
    }
    REQUIRE(stack.back().position().y == Approx(4.5f).margin(0.02));
}

}  // namespace motion_test
