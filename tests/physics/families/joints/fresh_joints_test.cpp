// Joints that are made, or whose bodies get another velocity, while the bodies move against each
// other: sticky shapes, grabbed crates. What joints do not allow is not an approach that a contact
// could stop.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>
#include <utility>
#include <vector>

#include "catch.h"
#include "family.h"

namespace fresh_joints_test {

using namespace fettle::physics;
using families::Random;

namespace {

float energy(const World& world) {
    float sum = 0;
    for (const Body& body : world.bodies())
        sum += body.kinetic_energy() - body.mass() * world.gravity().dot(Vec2(body.world_center()));
    return sum;
}

void weld(World& world, const Body& a, const Body& b, const Position& point) {
    world.create_weld_joint({.body_a = a.id(),
                             .body_b = b.id(),
                             .anchor_a = a.local_point(point),
                             .anchor_b = b.local_point(point)});
}

Geometry any_shape(Random& random, float size) {
    const float kind = random(0, 3);
    if (kind < 1) return Box{.width = size, .height = size * random(0.6f, 1)};
    if (kind < 2) return Circle{.radius = 0.5f * size};
    return Ellipse{.radius_x = size * random(0.4f, 0.8f), .radius_y = size * random(0.3f, 0.5f)};
}

/// A body is thrown at another one, to which it is welded by way of a third one. Returns the energy
/// afterwards as a share of the energy before.
float energy_after_throw_at_welded_body(unsigned seed) {
    Random random{std::mt19937(seed)};
    World world(WorldDef{.gravity = {0, 0}});
    const auto body = [&](const Position& position) {
        Body made = world.create_body({.position = position});
        made.add(Box{}, {.density = std::exp(random(-2, 2))});
        return made;
    };
    const Body below = body({0, 0}), beside = body({random(0.9f, 1.4f), random(0, 2)});
    Body above = body({random(-0.6f, 0.6f), 1 + random(0.005f, 0.1f)});
    weld(world, below, beside, {0.5f, 0.5f});
    weld(world, beside, above, {0.5f, 1});
    above.set_velocity({random(-3, 3), random(-20, -2)});
    const float before = energy(world);
    float most = 0;
    for (int step = 0; step < 30; ++step) {
        world.step(1.0f / 60);
        most = std::max(most, energy(world));
    }
    return most / before;
}

/// Shapes fall, and each that touches another one is welded to it. Returns the energy that they
/// gain as a share of their energy at the start.
float energy_gain_of_sticky_shapes(unsigned seed) {
    Random random{std::mt19937(seed)};
    World world;
    Body bin = world.create_body({.type = BodyType::static_body});
    bin.add(Box{.width = 12, .height = 1, .center = {0, -0.5f}});
    for (const float x : {-5.5f, 5.5f}) bin.add(Box{.width = 1, .height = 30, .center = {x, 10}});
    for (int i = 0; i < 20; ++i) {
        Body body = world.create_body({.position = {random(-4, 4), 2 + 0.9f * float(i)}});
        body.add(any_shape(random, random(0.3f, 0.8f)), {.density = random(0.5f, 3)});
    }
    std::set<std::pair<BodyId, BodyId>> joined;
    const float before = energy(world), dt = seed % 2 != 0 ? 1.0f / 60 : 1.0f / 120;
    float gain = 0;
    for (float time = 0; time < 4; time += dt) {
        const float now = energy(world);
        world.step(dt);
        gain = std::max(gain, energy(world) - now);
        const std::vector<ContactBeginEvent> touches = world.events().contact_begin;
        for (const ContactBeginEvent& touch : touches)
            if (random(0, 1) < 0.5f && joined.insert({touch.body_a, touch.body_b}).second)
                weld(world, world.body(touch.body_a), world.body(touch.body_b), touch.point);
    }
    return gain / before;
}

/// A chain of pinned boxes after one of them was moved somewhere else.
struct MovedChain {
    float time = 0;      ///< s, until no joint is wider than 2 cm for good
    float speed = 0;     ///< m/s, of the fastest body in the end
    float distance = 0;  ///< m, by which the body was moved
};

MovedChain moved_chain(unsigned seed) {
    Random random{std::mt19937(seed)};
    World world(WorldDef{.gravity = {0, 0}});
    std::vector<Body> bodies;
    std::vector<Joint> joints;
    Position top = {};
    const bool hangs = random(0, 1) < 0.5f;
    const auto count = size_t(random(2, 5));
    for (size_t i = 0; i < count; ++i) {
        const float length = random(0.4f, 1.2f);
        Body body = world.create_body({.position = top - Vec2{0, 0.5f * length}});
        body.add(Box{.width = 0.2f, .height = length}, {.group = -1});
        JointDef ends = {.body_b = body.id(), .anchor_b = {0, 0.5f * length}};
        if (i > 0) ends.body_a = bodies.back().id();
        ends.anchor_a = i > 0 ? Position(bodies.back().local_point(top)) : top;
        if (i > 0 || hangs) joints.push_back(world.create_revolute_joint(ends));
        bodies.push_back(body);
        top -= Vec2{0, length};
    }
    MovedChain moved = {.distance = random(0.5f, 12)};
    Body away = bodies[size_t(random(0, 0.999f) * float(count))];
    const float direction = random(0, 6.28f);
    const Vec2 way = {std::cos(direction), std::sin(direction)};
    away.set_pose({away.position() + moved.distance * way, random(-3, 3)});
    for (int step = 1; step <= 180; ++step) {
        world.step(1.0f / 60);
        for (const Joint& joint : joints)
            if (joint.separation() > 0.02f) moved.time = float(step) / 60;
    }
    for (const Body& body : bodies) moved.speed = std::max(moved.speed, body.velocity().length());
    return moved;
}

}  // namespace

TEST_CASE("a body that is thrown at bodies that it is welded to gains no energy") {
    const unsigned seeds = families::seeds_or(200);
    float most = 0;
    unsigned gained = 0;
    for (unsigned seed = 1; seed <= seeds; ++seed) {
        const float ratio = energy_after_throw_at_welded_body(seed);
        most = std::max(most, ratio);
        gained += ratio > 1.05f;
    }
    std::printf("thrown at their own: %u of %u gain energy, at most %.3g times\n", gained, seeds,
                double(most));
    CHECK(gained == 0);
}

TEST_CASE("shapes that are welded as they touch gain no energy") {
    const unsigned seeds = families::seeds_or(100);
    float most = 0;
    for (unsigned seed = 1; seed <= seeds; ++seed)
        most = std::max(most, energy_gain_of_sticky_shapes(seed));
    std::printf("sticky shapes: gain at most %.3g of their energy in a step\n", double(most));
    CHECK(most < 0.05f);
}

TEST_CASE("a body that is moved away from its joints is soon back and nothing is thrown") {
    unsigned slow = 0, fast = 0;
    float time = 0, speed = 0;
    const unsigned seeds = families::seeds_or(50);
    for (unsigned seed = 1; seed <= seeds; ++seed) {
        const MovedChain moved = moved_chain(seed);
        if (moved.time > 1 || moved.speed > 6)
            std::printf("seed %u: %.1f m away, back after %.2f s, then %.1f m/s\n", seed,
                        double(moved.distance), double(moved.time), double(moved.speed));
        slow += moved.time > 1;
        fast += moved.speed > 6;
        time += moved.time / float(seeds);
        speed += moved.speed / float(seeds);
    }
    std::printf("back after %.2f s as a mean, then %.2f m/s\n", double(time), double(speed));
    CHECK(slow <= seeds / 25);
    CHECK(fast <= seeds / 50);
    CHECK(time < 0.6f);
    CHECK(speed < 2);
}

}  // namespace fresh_joints_test
