#include <cmath>

#include "catch.h"
#include "scenes.h"

namespace target_test {

// Bodies that are steered to a pose, and the list of the bodies that a step moved.

using namespace scenes;

TEST_CASE("a kinematic body reaches its target in one step and keeps it") {
    World world;
    Body door = world.create_body({.type = BodyType::kinematic_body, .position = {1, 2}});
    door.add(Box{.center = {2, 0}});  // its center of mass is not its origin
    const Pose path[] = {{{1.5f, 2}, 0.3f}, {{1.5f, 2.5f}, 0.9f}, {{0, 0}, 0.9f}, {{0, 0}, -1}};
    for (const Pose& target : path) {
        door.set_target(target, frame);
        world.step(frame);
        REQUIRE(door.position().x == Approx(target.position.x).margin(1e-5));
        REQUIRE(door.position().y == Approx(target.position.y).margin(1e-5));
        REQUIRE(door.angle() == Approx(target.angle).margin(1e-5));
    }
    door.set_target(path[3], frame);
    REQUIRE(door.velocity().length() < 0.01f);
}

TEST_CASE("a platform that is steered to a target carries bodies") {
    World world;
    Body platform = world.create_body({.type = BodyType::kinematic_body});
    platform.add(Box{.width = 6, .height = 0.5f});
    Body crate = add_box(world, {0, 0.75f});
    run(world, 0.5f);
    for (int i = 1; i <= 60; ++i) {
        platform.set_target({{0.02f * float(i), 0}}, frame);
        world.step(frame);
    }
    REQUIRE(platform.position().x == Approx(1.2).margin(1e-4));
    REQUIRE(crate.position().x > 1.0f);
}

TEST_CASE("a target at the own pose wakes nothing") {
    World world;
    Body body = world.create_body({.type = BodyType::kinematic_body, .position = {3, 3}});
    body.add(Circle{});
    run(world, 3.0f);
    REQUIRE_FALSE(body.awake());
    body.set_target({{3, 3}}, frame);
    REQUIRE_FALSE(body.awake());
    body.set_target({{3, 4}}, frame);
    REQUIRE(body.awake());
}

TEST_CASE("an invalid target is refused and changes nothing") {
    World world;
    Body body = add_ball(world, {0, 0});
    REQUIRE_THROWS_WITH(body.set_target({{1, 1}}, 0),
                        contains("dt = 0: expected a finite number above 0"));
    REQUIRE_THROWS_WITH(body.set_target({{1, 1}}, -1), contains("dt"));
    REQUIRE_THROWS_WITH(body.set_target({{NAN, 1}}, 1), contains("target"));
    REQUIRE(body.velocity() == Vec2{});
    Body fixed = world.create_body({.type = BodyType::static_body});
    fixed.set_target({{1, 1}}, 1);
    REQUIRE(fixed.velocity() == Vec2{});
}

TEST_CASE("the list of moved bodies has those that a step moved and no others") {
    World world;
    add_floor(world);
    std::vector<Body> resting, falling;
    for (int i = 0; i < 5; ++i) resting.push_back(add_box(world, {2.0f * float(i), 0.5f}));
    run(world, 3.0f);
    for (int i = 0; i < 5; ++i) falling.push_back(add_ball(world, {2.0f * float(i), 30}));
    world.create_body({.type = BodyType::kinematic_body, .position = {50, 9}});
    REQUIRE(world.moved_bodies().empty());
    world.step(frame);
    const std::vector<Body> moved = world.moved_bodies();
    REQUIRE(moved == falling);
    falling[0].destroy();
    falling[1].set_position({9, 9});
    REQUIRE(world.moved_bodies() == std::vector<Body>(falling.begin() + 2, falling.end()));
}

}  // namespace target_test
