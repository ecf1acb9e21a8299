#include <limits>

#include "catch.h"
#include "scenes.h"

namespace body_functions_test {

// Functions of the user that move single bodies.

using namespace scenes;

TEST_CASE("a velocity function that sets nothing changes no bit of the result") {
    World plain({.sleeping = false}), asked({.sleeping = false});
    for (World* world : {&plain, &asked}) {
        add_floor(*world);
        for (int i = 0; i < 6; ++i) add_box(*world, {0.1f * float(i), 0.5f + float(i)});
    }
    int calls = 0;
    asked.bodies()[3].set_velocity_function([&](VelocityEdit& edit) {
        REQUIRE(edit.dt == frame);
        REQUIRE(edit.before == edit.body.velocity());
        ++calls;
    });
    plain.bodies()[3].set_awake(true);
    asked.bodies()[3].set_position_function([](PositionEdit&) {});
    for (World* world : {&plain, &asked}) run(*world, 1.0f);
    REQUIRE(calls == 60);
    REQUIRE(plain.hash() == asked.hash());
}

TEST_CASE("a velocity function gets gravity and forces and damping") {
    World world({.gravity = {0, -10}});
    Body body = world.create_body({.velocity = {3, 0}, .linear_damping = 0.5f});
    body.add(Circle{});
    body.set_force({0, 20 * body.mass()});
    Vec2 told;
    body.set_velocity_function([&](VelocityEdit& edit) { told = edit.velocity; });
    world.step(frame);
    REQUIRE(told.y == Approx(10 * frame).epsilon(0.01));
    REQUIRE(told.x == Approx(3 / (1 + 0.5f * frame)).epsilon(0.001));
    REQUIRE(body.velocity().x == Approx(told.x).epsilon(1e-6));
    REQUIRE(body.velocity().y == Approx(told.y).epsilon(1e-5));
}

TEST_CASE("a velocity function replaces gravity and the body rests under it") {
    World world;
    add_floor(world);
    // Gravity of a planet: towards a point below the floor, half as strong.
    Body low = add_box(world, {0, 0.5f}), usual = add_box(world, {5, 0.5f});
    low.set_velocity_function([](VelocityEdit& edit) {
        edit.velocity = edit.before + Vec2{0, -5 * edit.dt};
    });
    low.set_can_sleep(false);
    usual.set_can_sleep(false);
    run(world, 2.0f);
    REQUIRE(std::fabs(low.velocity().y) < 0.001f);
    REQUIRE(low.position().y == Approx(0.5f).margin(0.005));
    REQUIRE(low.contacts().size() == 1);
    REQUIRE(low.contacts()[0].normal_force ==
            Approx(usual.contacts()[0].normal_force / 2).epsilon(0.02));
    low.set_velocity_function({});
    low.set_position({0, 5});
    run(world, 0.5f);
    REQUIRE(low.velocity().y == Approx(-5).epsilon(0.05));
}

TEST_CASE("a velocity function sets the angular velocity alone and steers a kinematic body") {
    World world({.gravity = {0, -10}});
    Body spun = add_box(world, {0, 50});
    spun.set_velocity_function([](VelocityEdit& edit) { edit.angular_velocity = 2; });
    Body lift = world.create_body({.type = BodyType::kinematic_body, .velocity = {0, 0.1f}});
    lift.add(Box{});
    lift.set_velocity_function([](VelocityEdit& edit) { edit.velocity = {1, 0}; });
    run(world, 1.0f);
    REQUIRE(spun.angular_velocity() == Approx(2));
    REQUIRE(spun.velocity().y == Approx(-10).epsilon(0.001));
    REQUIRE(lift.velocity() == Vec2{1, 0});
    REQUIRE(lift.position().x == Approx(1).epsilon(0.001));
    REQUIRE(lift.position().y == Approx(0).margin(0.001));
}

TEST_CASE("locked axes and the maximum speed hold after a velocity function") {
    World world({.gravity = {0, 0}});
    Body body = world.create_body({.locked_y = true, .max_speed = 2});
    body.add(Circle{});
    body.set_velocity_function([](VelocityEdit& edit) { edit.velocity = {30, 30}; });
    run(world, 0.2f);
    REQUIRE(body.velocity().x == Approx(2));
    REQUIRE(body.velocity().y == 0.0f);
}

TEST_CASE("a position function holds a body on a path and the drawn pose follows") {
    World world;
    Body bead = add_ball(world, {2, 0}, 0.2f);
    bead.set_position_function([](PositionEdit& edit) {
        edit.pose.position = Vec2(edit.pose.position).normalized() * 2.0f;
    });
    float lowest = 0;
    for (int i = 0; i < 60; ++i) {
        const Position before = bead.position();
        world.step(frame);
        REQUIRE(Vec2(bead.position()).length() == Approx(2).epsilon(1e-5));
        REQUIRE(bead.previous_pose().position == before);
        lowest = std::min<float>(lowest, bead.position().y);
        REQUIRE(world.query_point(bead.position()).size() == 1);
    }
    REQUIRE(lowest < -1.9f);
    REQUIRE_FALSE(world.validate());
}

TEST_CASE("invalid numbers from functions of a body change nothing or are limited") {
    World plain, odd;
    for (World* world : {&plain, &odd}) {
        add_floor(*world);
        add_box(*world, {0, 3});
        add_box(*world, {0.2f, 5});
    }
    const float nan = std::numeric_limits<float>::quiet_NaN();
    odd.bodies()[1].set_velocity_function([nan](VelocityEdit& edit) {
        edit.velocity = {nan, nan};
        edit.angular_velocity = nan;
    });
    odd.bodies()[1].set_position_function([nan](PositionEdit& edit) {
        edit.pose = {{nan, nan}, nan};
    });
    run(plain, 1.0f);
    run(odd, 1.0f);
    REQUIRE(plain.hash() == odd.hash());
    odd.bodies()[2].set_velocity_function([](VelocityEdit& edit) {
        edit.velocity = {infinity, -infinity};
        edit.angular_velocity = 1e38f;
    });
    odd.bodies()[1].set_position_function([](PositionEdit& edit) {
        edit.pose = {{infinity, 1e30f}, -infinity};
    });
    run(odd, 0.2f);
    for (const Body& body : odd.bodies()) {
        REQUIRE(std::isfinite(body.position().x + body.position().y + body.angle()));
        REQUIRE(std::isfinite(body.velocity().length()));
    }
    REQUIRE_FALSE(odd.validate());
}

TEST_CASE(
    "functions are not called for static or sleeping bodies and are not copied with a world") {
    World world;
    Body floor = add_floor(world);
    Body box = add_box(world, {0, 0.5f});
    int calls = 0;
    const auto count = [&calls](VelocityEdit&) { ++calls; };
    floor.set_velocity_function(count);
    world.step(frame);
    REQUIRE(calls == 0);
    box.set_velocity_function(count);
    run(world, 3.0f);
    REQUIRE_FALSE(box.awake());
    const int before = calls;
    REQUIRE(before > 10);
    run(world, 1.0f);
    REQUIRE(calls == before);
    box.set_velocity_function(count);  // wakes
    REQUIRE(box.awake());
    World copy = world.clone();
    copy.step(frame);
    REQUIRE(calls == before);
    world.restore(copy);
    box.set_awake(true);
    world.step(frame);
    REQUIRE(calls == before + 1);
}

TEST_CASE("a function is there again when a destroyed body is restored and not for its successor") {
    World world({.gravity = {0, 0}});
    Body body = add_ball(world, {0, 0});
    int calls = 0;
    body.set_velocity_function([&](VelocityEdit&) { ++calls; });
    const World before = world.clone();
    body.destroy();
    Body next = add_ball(world, {0, 0});
    REQUIRE(next.index() == body.index());
    world.step(frame);
    REQUIRE(calls == 0);
    world.restore(before);
    world.step(frame);
    REQUIRE(calls == 1);
    body.destroy();
    next = add_ball(world, {0, 0});
    next.set_velocity_function([](VelocityEdit& edit) { edit.velocity = {7, 0}; });
    world.step(frame);
    REQUIRE(next.velocity() == Vec2{7, 0});
    REQUIRE(calls == 1);
}

TEST_CASE("functions of many bodies are called in the order of their slots with any threads") {
    std::vector<uint64_t> hashes;
    for (const int threads : {1, 3}) {
        World world;
        world.set_threads(threads);
        add_floor(world, 100);
        std::vector<Body> bodies;
        for (int i = 0; i < 200; ++i)
            bodies.push_back(add_box(world, {float(i % 20) * 1.1f, 1.0f + 1.1f * float(i / 20)}));
        std::vector<uint32_t> order;
        for (auto each = bodies.rbegin(); each != bodies.rend(); ++each)
            each->set_velocity_function([&order](VelocityEdit& edit) {
                order.push_back(edit.body.index());
                edit.velocity.x += 0.1f * float(order.size() % 3);
            });
        run(world, 0.5f);
        REQUIRE(std::is_sorted(order.begin(), order.begin() + 200));
        REQUIRE(order.size() == 200 * 30);
        hashes.push_back(world.hash());
    }
    REQUIRE(hashes[0] == hashes[1]);
}

TEST_CASE("every solver takes the velocity of a function") {
    for (const Solver solver : {Solver::soft_step, Solver::sequential, Solver::direct}) {
        World world({.gravity = {0, -10}, .solver = solver});
        add_floor(world);
        Body box = add_box(world, {0, 0.5f});
        box.set_can_sleep(false);
        box.set_velocity_function([](VelocityEdit& edit) {
            edit.velocity = edit.before + Vec2{0, -20 * edit.dt};
        });
        Body free = add_ball(world, {10, 20});
        free.set_velocity_function([](VelocityEdit& edit) { edit.velocity = {1, 2}; });
        run(world, 1.0f);
        REQUIRE(box.position().y == Approx(0.5f).margin(0.02));
        REQUIRE(free.velocity().x == Approx(1).epsilon(1e-5));
        REQUIRE(free.velocity().y == Approx(2).epsilon(1e-5));
    }
}

}  // namespace body_functions_test
