#include <cmath>
#include <random>
#include <string>

#include "catch.h"
#include "saved_worlds.h"
#include "scenes.h"

namespace traits_test {

// Values that few bodies have: a name, a maximum speed, a sleep speed.

using namespace scenes;

TEST_CASE("names are kept with the state and need no memory when they are empty") {
    World world;
    Body door = world.create_body({.name = "the door"}), plain = world.create_body();
    REQUIRE(door.name() == "the door");
    REQUIRE(plain.name().empty());
    plain.set_name(std::string(63, 'x'));
    REQUIRE(plain.name().size() == 63);
    REQUIRE_THROWS_WITH(plain.set_name(std::string(64, 'x')), contains("at most 63 bytes"));
    REQUIRE_THROWS_WITH(plain.set_name(std::string_view("a\0b", 3)), contains("zero byte"));
    REQUIRE_THROWS_WITH(world.create_body({.name = std::string(80, 'x')}), contains("name"));
    REQUIRE(plain.name().size() == 63);
    World restored;
    restored.restore(saved(world));
    REQUIRE(restored.body(door.id()).name() == "the door");
    plain.set_name("");
    REQUIRE(plain.name().empty());
    REQUIRE(door.name() == "the door");
    door.destroy();
    Body next = world.create_body();
    REQUIRE(next.name().empty());
    REQUIRE_FALSE(world.validate());
}

TEST_CASE("a maximum speed holds in every solver and in every step") {
    for (const Solver solver : {Solver::soft_step, Solver::sequential, Solver::direct}) {
        World world({.solver = solver});
        Body slow = world.create_body({.position = {0, 100}, .max_speed = 2});
        Body free = world.create_body({.position = {5, 100}});
        slow.add(Circle{});
        free.add(Circle{});
        for (int i = 0; i < 60; ++i) {
            world.step(frame);
            REQUIRE(slow.velocity().length() <= 2.0001f);
        }
        REQUIRE(slow.position().y > 97.9f);
        REQUIRE(free.position().y < 96);
        slow.set_velocity({30, 40});
        world.step(frame);
        REQUIRE(slow.velocity().length() > 1.8f);  // gravity acts against it
        REQUIRE(slow.velocity().x > 1);
        slow.set_max_speed(infinity);
        run(world, 0.5f);
        REQUIRE(slow.velocity().length() > 3);
        REQUIRE_FALSE(world.validate());
    }
}

TEST_CASE("a maximum speed limits a body that is pushed") {
    World world({.gravity = {0, 0}});
    Body ball = world.create_body({.max_speed = 1});
    ball.add(Circle{}, {.restitution = 1});
    Body hammer = world.create_body({.position = {-5, 0}, .velocity = {50, 0}});
    hammer.add(Box{.width = 2, .height = 2}, {.density = 20, .restitution = 1});
    for (int i = 0; i < 30; ++i) {
        world.step(frame);
        REQUIRE(ball.velocity().length() <= 1.0001f);
    }
}

TEST_CASE("the maximum speed of a world holds for every body in every solver") {
    for (const Solver solver : {Solver::soft_step, Solver::sequential, Solver::direct}) {
        World world({.gravity = {0, 0}, .max_speed = 5, .solver = solver});
        Body fast = world.create_body({.velocity = {60, 80}});
        Body slower = world.create_body({.position = {0, -10}, .velocity = {60, 80}});
        slower.set_max_speed(2);
        Body lift = world.create_body(
            {.type = BodyType::kinematic_body, .position = {50, 0}, .velocity = {0, -30}});
        Body light = world.create_body({.position = {50, -3}});
        for (Body* body : {&fast, &slower, &lift, &light}) body->add(Circle{});
        light.set_mass(0.001f);
        for (int i = 0; i < 60; ++i) {
            world.step(frame);
            for (const Body& body : world.bodies()) REQUIRE(body.velocity().length() <= 5.0001f);
        }
        // Its direction is that of the velocity that it was given.
        REQUIRE(fast.position().x == Approx(3).margin(0.01));
        REQUIRE(fast.position().y == Approx(4).margin(0.01));
        REQUIRE(slower.velocity().length() == Approx(2));
        REQUIRE(lift.position().y == Approx(-5).margin(0.01));
        REQUIRE(light.position().y < -5);
        world.set_max_speed(1e4f);
        fast.set_velocity({60, 80});
        world.step(frame);
        REQUIRE(fast.velocity().length() == Approx(100));
        REQUIRE_FALSE(world.validate());
    }
}

TEST_CASE("the forces of a step do not throw back a body that lands with its maximum speed") {
    World world({.gravity = {0, -1e4f}, .max_speed = 20});
    Body floor = world.create_body({.type = BodyType::static_body});
    floor.add(Box{.width = 10, .height = 0.1f});
    Body ball = world.create_body({.position = {0, 2.03f}});
    ball.add(Circle{.radius = 0.05f});
    for (int i = 0; i < 60; ++i) {
        world.step(frame);
        REQUIRE(ball.velocity().y < 1);
        REQUIRE(ball.position().y > 0);
    }
    REQUIRE(ball.position().y < 0.2f);
}

TEST_CASE("bullets and what drives them do not exceed the maximum speed of their world") {
    for (unsigned seed = 225; seed < 245; ++seed) {
        std::mt19937 random(seed);
        const auto between = [&](float low, float high) {
            return low + (high - low) * float(random() % 10001) / 10000;
        };
        World world({.gravity = {0, 0}, .bounds = Aabb{{-5, -5}, {5, 5}}, .max_speed = 100});
        for (int i = 0; i < 30; ++i) {
            const bool driver = i % 7 == 0;
            Body body = world.create_body(
                {.type = driver ? BodyType::kinematic_body : BodyType::dynamic_body,
                 .position = {between(-4, 4), between(-4, 4)},
                 .velocity = {between(-90, 90), between(-90, 90)},
                 .angular_velocity = between(-90, 90),
                 .bullet = random() % 3 != 0});
            const Geometry ball = Circle{.radius = between(0.05f, 0.2f)},
                           stick = Box{.width = 0.05f, .height = between(0.1f, 1.5f)};
            body.add(random() % 2 == 0 ? ball : stick,
                     {.density = random() % 3 == 0 ? 100.0f : 1.0f, .restitution = 1});
        }
        for (int i = 0; i < 60; ++i) {
            world.step(frame);
            for (const Body& body : world.bodies()) REQUIRE(body.velocity().length() <= 100.01f);
        }
    }
}

TEST_CASE("the maximum speed of a world is saved and checked") {
    World world({.max_speed = 20});
    for (const float speed : {0.0f, -1.0f, 10001.0f, infinity, float(NAN)}) {
        REQUIRE_THROWS_WITH(world.set_max_speed(speed), contains("max_speed"));
        REQUIRE_THROWS_WITH(World({.max_speed = speed}), contains("at most 10000"));
    }
    REQUIRE(world.max_speed() == 20.0f);
    World restored;
    REQUIRE(restored.max_speed() == 1e4f);
    restored.restore(saved(world));
    REQUIRE(restored.max_speed() == 20.0f);
}

TEST_CASE("locked axes and a maximum speed hold for kinematic bodies") {
    for (const Solver solver : {Solver::soft_step, Solver::sequential, Solver::direct}) {
        World world({.solver = solver});
        Body lift = world.create_body({.type = BodyType::kinematic_body,
                                       .velocity = {3, 4},
                                       .angular_velocity = 2,
                                       .locked_rotation = true});
        lift.add(Box{});
        world.step(frame);
        REQUIRE(lift.angular_velocity() == 0.0f);
        REQUIRE(lift.angle() == 0.0f);
        REQUIRE(lift.velocity() == Vec2{3, 4});
        lift.set_max_speed(2.5f);
        world.step(frame);
        REQUIRE(lift.velocity().x == Approx(1.5));
        REQUIRE(lift.velocity().y == Approx(2));
        lift.set_locked_x(true);
        lift.set_velocity({9, 1});
        const Position before = lift.position();
        world.step(frame);
        REQUIRE(lift.velocity() == Vec2{0, 1});
        REQUIRE(lift.position().x == before.x);
        REQUIRE(lift.position().y == Approx(before.y + frame));
        lift.set_locked_y(true);
        run(world, 1.0f);
        REQUIRE(lift.position().y == Approx(before.y + frame));
        REQUIRE_FALSE(lift.awake());
        lift.set_locked_x(false);
        lift.set_velocity_function([](VelocityEdit& edit) { edit.velocity = {1, 1}; });
        world.step(frame);
        REQUIRE(lift.velocity() == Vec2{1, 0});
    }
}

TEST_CASE("an invalid maximum speed or sleep speed is refused") {
    World world;
    Body body = world.create_body();
    REQUIRE(body.max_speed() == infinity);
    REQUIRE_THROWS_WITH(body.set_max_speed(0), contains("max_speed"));
    REQUIRE_THROWS_WITH(body.set_max_speed(NAN), contains("max_speed"));
    REQUIRE_THROWS_WITH(body.set_sleep_speed(-1.0f), contains("sleep_speed"));
    REQUIRE_THROWS_WITH(world.create_body({.max_speed = -1}), contains("max_speed"));
    REQUIRE_THROWS_WITH(world.create_body({.sleep_speed = infinity}), contains("sleep_speed"));
    REQUIRE(body.max_speed() == infinity);
    REQUIRE_FALSE(body.sleep_speed_override());
}

TEST_CASE("a body rests below its own sleep speed or that of the world") {
    World world({.gravity = {0, 0}});
    Body creeps = world.create_body({.velocity = {0.01f, 0}});
    Body snail =
        world.create_body({.position = {0, 5}, .velocity = {0.01f, 0}, .sleep_speed = 0.5f});
    for (Body* body : {&creeps, &snail}) body->add(Circle{});
    REQUIRE(creeps.sleep_speed() == world.sleep_speed());
    REQUIRE(snail.sleep_speed() == 0.5f);
    run(world, 1.0f);
    REQUIRE(creeps.awake());
    REQUIRE_FALSE(snail.awake());
    World restored;
    restored.restore(saved(world));
    REQUIRE(restored.body(snail.id()).sleep_speed_override() == 0.5f);
    snail.set_sleep_speed({});
    REQUIRE(snail.sleep_speed() == world.sleep_speed());
    REQUIRE(snail.awake());
    snail.set_velocity({0.01f, 0});
    run(world, 1.0f);
    REQUIRE(snail.awake());
    REQUIRE_FALSE(world.validate());
}

}  // namespace traits_test
