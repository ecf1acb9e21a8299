#include <fettle/physics/mover.h>

#include "catch.h"
#include "random.h"
#include "scenes.h"
#include "thorough.h"

// A mover of 80 kg walks over what weighs a hundredth of it and gives way.

namespace light_ground_test {

using namespace scenes;

namespace {

enum class Ground { crate, bridge, hanging_platform, cart, raft, balls };

float build_crate(World& world, Random& random) {
    add_floor(world, 100.0f);
    const float size = random(0.3f, 1.2f);
    add_box(world, {0, 0.5f * size}, size, size, random(0.3f, 3) * size * size);
    return size;
}

float build_bridge(World& world, Random& random) {
    const float mass = random(0.2f, 4);
    BodyId before;
    for (int i = 0; i < 10; ++i) {
        const Body plank = add_box(world, {-4.5f + float(i), 3}, 1, 0.2f, mass);
        const Vec2 anchor = i == 0 ? Vec2{-5, 3} : Vec2{0.5f, 0};
        world.create_revolute_joint(
            {.body_a = before, .body_b = plank.id(), .anchor_a = anchor, .anchor_b = {-0.5f, 0}});
        before = plank.id();
    }
    world.create_revolute_joint({.body_a = before, .anchor_a = {0.5f, 0}, .anchor_b = {5, 3}});
    return 3.1f;
}

float build_hanging_platform(World& world, Random& random) {
    const Body platform = add_box(world, {0, 2}, 3, 0.2f, random(0.4f, 6));
    for (const float x : {-1.4f, 1.4f})
        world.create_distance_joint({.body_b = platform.id(),
                                     .anchor_a = {x, 6},
                                     .anchor_b = {x, 0},
                                     .max_length = 4,
                                     .hertz = 0});
    return 2.1f;
}

float build_cart(World& world, Random& random) {
    add_floor(world, 100.0f);
    const float mass = random(0.5f, 5);
    const Body deck = add_box(world, {0, 0.8f}, 2, 0.3f, mass);
    for (const float x : {-0.7f, 0.7f}) {
        Body wheel = world.create_body({.position = {x, 0.4f}});
        wheel.add(Circle{.radius = 0.35f});
        wheel.set_mass(0.3f * mass);
        world.create_wheel_joint(
            {.body_a = deck.id(), .body_b = wheel.id(), .anchor_a = {x, -0.4f}, .hertz = 6});
    }
    return 0.95f;
}

float build_raft(World& world, Random& random) {
    world.create_field({BuoyancyField{.level = 3}});
    add_box(world, {0, 3}, 3, 0.4f, 1.2f * random(0.2f, 0.7f));
    return 3.2f;
}

float build_balls(World& world, Random& random) {
    Body floor = add_floor(world, 100.0f);
    for (const float x : {-1.4f, 1.3f})
        floor.add(Box{.width = 0.2f, .height = 1, .center = {x, 0.5f}});
    const float density = random(0.5f, 3);
    for (int i = 0; i < 12; ++i) {
        Body ball = world.create_body(
            {.position = {-1 + 0.45f * float(i % 5), 0.2f + 0.42f * float(i / 5)}});
        ball.add(Circle{.radius = 0.2f}, {.density = density});
    }
    return 1.3f;
}

/// Returns the height of its top, m.
float build(World& world, Ground ground, Random& random) {
    switch (ground) {
        case Ground::crate:
            return build_crate(world, random);
        case Ground::bridge:
            return build_bridge(world, random);
        case Ground::hanging_platform:
            return build_hanging_platform(world, random);
        case Ground::cart:
            return build_cart(world, random);
        case Ground::raft:
            return build_raft(world, random);
        case Ground::balls:
            return build_balls(world, random);
    }
    return 0.0f;
}

}  // namespace

TEST_CASE("a mover throws nothing that is much lighter than itself") {
    const Ground ground = GENERATE(Ground::crate, Ground::bridge, Ground::hanging_platform,
                                   Ground::cart, Ground::raft, Ground::balls);
    for (unsigned seed = 1; seed <= 50; ++seed) {
        if (!is_tested(seed, 5)) continue;
        Random random{std::mt19937(seed)};
        World world;
        const float top = build(world, ground, random);
        const float rate = rate_of(seed);
        const float walk = random(-3, 3), x = random(-0.6f, 0.6f);
        Mover mover({}, {x, top + 0.3f});
        Vec2 velocity = {};
        for (float time = 0; time < 3; time += 1 / rate) {
            velocity.x = walk;
            if (!mover.on_ground()) velocity.y -= 10 / rate;
            velocity = mover.move(world, velocity, 1 / rate).velocity;
            world.step(1 / rate);
            for (const Body& body : world.bodies()) {
                INFO("ground " << int(ground) << ", seed " << seed << ", after " << time << " s");
                REQUIRE(body.velocity().length() < 10.0f);
            }
        }
    }
}

TEST_CASE("a mover stands on a platform without weight") {
    World world;
    Body deck = world.create_body({.gravity_scale = 0, .locked_rotation = true});
    deck.add(Box{.width = 20, .height = 0.2f}, {.density = 500});
    Mover mover({}, {0, 0.11f});
    Vec2 velocity;
    int stood = 0;
    for (int i = 0; i < 60; ++i) {
        if (!mover.on_ground()) velocity.y -= 10.0f / 60;
        const Moved moved = mover.move(world, velocity, 1.0f / 60);
        velocity = moved.velocity;
        stood += moved.on_ground;
        world.step(1.0f / 60);
    }
    CHECK(stood > 55);
    CHECK(deck.velocity().y < -0.05f);  // its weight draws the deck down
}

}  // namespace light_ground_test
