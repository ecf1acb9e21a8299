#include <fettle/physics/mover.h>

#include <cmath>

#include "catch.h"
#include "random.h"
#include "scenes.h"
#include "thorough.h"

// A mover is moved by its walk, its ground and what pushes it: never by a jump to another place.

namespace mover_jerks_test {

using namespace scenes;

namespace {

float fastest(const World& world) {
    float most = 0.0f;
    for (const Body& body : world.bodies()) most = std::max(most, body.velocity().length());
    return most;
}

/// A ladder of rungs on ropes.
void add_ladder(World& world, Random& random) {
    const float mass = random(0.3f, 2);
    Body above;
    for (int i = 0; i < 8; ++i) {
        const Body rung = add_box(world, {0, 6 - 0.6f * float(i)}, 1.4f, 0.1f, mass);
        for (const float x : {-0.6f, 0.6f})
            world.create_distance_joint({.body_a = i == 0 ? BodyId{} : above.id(),
                                         .body_b = rung.id(),
                                         .anchor_a = i == 0 ? Vec2{x, 6.6f} : Vec2{x, 0},
                                         .anchor_b = {x, 0},
                                         .max_length = 0.6f,
                                         .hertz = 0});
        above = rung;
    }
}

}  // namespace

TEST_CASE("a mover that bodies overlap is pushed out of them slowly") {
    for (unsigned seed = 1; seed <= 50; ++seed) {
        if (!is_tested(seed, 5)) continue;
        Random random{std::mt19937(seed)};
        const float dt = 1 / rate_of(seed);
        World world;
        add_floor(world, 100.0f);
        Body press;
        if (seed % 3 == 0) {  // a lift that comes down onto the mover
            press = world.create_body({.type = BodyType::kinematic_body, .position = {0, 3}});
            press.add(Box{.width = random(1, 4), .height = 0.3f});
            const float x = random(0.5f, 1), mass = random(0.3f, 20);
            add_box(world, {x, 0.3f}, 0.6f, 0.6f, mass);
        } else if (seed % 3 == 1) {  // crates that fall onto it
            for (int i = 0; i < 4; ++i) {
                const float x = random(-0.5f, 0.5f), mass = random(1, 100);
                add_box(world, {x, 3 + 1.2f * float(i)}, 1, 1, mass);
            }
        } else {  // a ladder in which it appears
            add_ladder(world, random);
        }
        Mover mover({}, {random(-0.8f, 0.8f), seed % 3 == 2 ? random(1, 3) : 0.01f});
        Vec2 velocity = {};
        for (int i = 0; i < int(4 / dt); ++i) {
            if (press) press.set_velocity({0, float(i) * dt < 2 ? -1.5f : 1.5f});
            velocity.x = 0.0f;
            if (!mover.on_ground()) velocity.y -= 10.0f * dt;
            // Between two bodies it goes up to twice as far as each of them pushes it.
            const float most = velocity.length() + 2 * (3 + 1.5f * fastest(world));
            const Moved moved = mover.move(world, velocity, dt);
            velocity = moved.velocity;
            INFO("seed " << seed << ", step " << i << " at " << mover.position().x << ", "
                         << mover.position().y);
            REQUIRE(moved.motion.length() < most * dt + 0.015f);
            REQUIRE_FALSE(moved.stepped);
            world.step(dt);
        }
    }
}

TEST_CASE(
    "a mover that stands falls when its ground goes away, and one that walks stays on ground") {
    const bool walks = GENERATE(false, true);
    World world;
    add_floor(world, 100.0f);
    Body slab = world.create_body({.type = BodyType::static_body, .position = {0, 0.1f}});
    slab.add(Box{.width = 10, .height = 0.2f});
    Mover mover({}, {0, 0.21f});
    Vec2 velocity = {walks ? 2.0f : 0.0f, 0};
    velocity = mover.move(world, velocity, frame).velocity;
    REQUIRE(mover.on_ground());
    slab.destroy();
    const Moved moved = mover.move(world, velocity, frame);
    CHECK(moved.on_ground == walks);
    CHECK((moved.motion.y < -0.1f) == walks);
}

TEST_CASE("a mover does not drive the rope ladder on which it stands by pushing its rungs") {
    for (unsigned seed = 1; seed <= 50; ++seed) {
        if (!is_tested(seed, 5)) continue;
        Random random{std::mt19937(seed)};
        const float dt = 1 / rate_of(seed), walk = random(1, 3);
        World world;
        add_ladder(world, random);
        Mover mover({}, {random(-0.5f, 0.5f), 2.0f});
        Vec2 velocity = {};
        for (int i = 0; i < int(4 / dt); ++i) {
            velocity.x = i < int(2 / dt) ? walk : -walk;
            if (!mover.on_ground()) velocity.y -= 10.0f * dt;
            velocity = mover.move(world, velocity, dt).velocity;
            world.step(dt);
            INFO("seed " << seed << ", step " << i);
            REQUIRE(fastest(world) < 14);
        }
    }
}

TEST_CASE("what a mover pushes and its ground keep their momentum") {
    const float heavy = GENERATE(5.0f, 20.0f, 100.0f), rate = GENERATE(30.0f, 60.0f, 144.0f);
    World world;
    add_floor(world, 100.0f, {.friction = 0.0f});
    Body board = add_box(world, {0, 0.1f}, 20, 0.2f, 50);
    for (Shape& shape : board.shapes()) shape.set_friction(0.3f);
    world.step(1 / rate);
    Body crate = add_box(world, {1.5f, 0.7f}, 1, 1, heavy);
    Mover mover({}, {0, 0.21f});
    Vec2 velocity = {};
    float pushed = 0.0f;
    for (int i = 0; i < int(2 * rate); ++i) {
        velocity.x = 3.0f;
        if (!mover.on_ground()) velocity.y -= 10 / rate;
        velocity = mover.move(world, velocity, 1 / rate).velocity;
        world.step(1 / rate);
        pushed = std::max(pushed, crate.velocity().x - board.velocity().x);
        // The mover moves with the board; what it walks relative to it is no momentum.
        const float momentum = board.mass() * board.velocity().x + heavy * crate.velocity().x +
                               80 * mover.state().ground_velocity.x;
        INFO(heavy << " kg, " << rate << " Hz, step " << i);
        REQUIRE(std::fabs(momentum) < 5.0f);
    }
    CHECK(pushed > 1.0f);
}

}  // namespace mover_jerks_test
