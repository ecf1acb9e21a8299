// Bodies with joints that hit the ground or a wall fast enough for continuous collision: nothing
// passes through, and the joints stay together.
// FETTLE_SEEDS=n: n worlds of each family.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "catch.h"
#include "family.h"

namespace joined_impacts_test {

using namespace fettle::physics;
using families::Random;
using families::seeds_or;

namespace {

constexpr float dt = 1.0f / 60;
constexpr float infinite = 1e9f;

/// Thin ground, thick ground, a chain or tiles, whose surface is y = 0, and perhaps a thin wall.
void add_surroundings(World& world, unsigned kind, float wall_at) {
    Body ground = world.create_body({.type = BodyType::static_body});
    if (kind % 4 == 0) {
        ground.add(Segment{.from = {-300, 0}, .to = {300, 0}});
    } else if (kind % 4 == 1) {
        ground.add(Box{.width = 600, .height = 2, .center = {0, -1}});
    } else if (kind % 4 == 2) {
        Chain chain;
        for (int i = -300; i <= 300; ++i) chain.points.push_back({float(i), 0.0f});
        ground.add(chain);
    } else {
        for (int i = -150; i < 150; ++i)
            ground.add(Box{.width = 2, .height = 0.3f, .center = {2.0f * float(i), -0.15f}});
    }
    if (wall_at < infinite) ground.add(Segment{.from = {wall_at, -1}, .to = {wall_at, 100}});
}

/// Joined bodies, and the worst values that were measured on them.
struct Joined {
    World world;
    std::vector<Body> bodies;
    float wall_at = infinite;
    float gap = 0.0f;          ///< the widest of a joint, m
    unsigned passed = 0;       ///< bodies behind the ground or the wall
    float momentum_up = 0.0f;  ///< the greatest speed of the common center upwards, m/s

    Body add(const Position& at, float angle, const Geometry& geometry) {
        Body body = world.create_body({.position = at, .angle = angle});
        body.add(geometry, {.friction = 0.5f, .group = -1});
        return bodies.emplace_back(body);
    }
    RevoluteJoint pin(const Body& a, const Body& b, const Position& at, float low = -infinity,
                      float high = infinity) {
        return world.create_revolute_joint({.body_a = a.id(),
                                            .body_b = b.id(),
                                            .anchor_a = a.local_point(at),
                                            .anchor_b = b.local_point(at),
                                            .lower_angle = low,
                                            .upper_angle = high});
    }
    /// Turns all bodies about the first one, which was made above the origin, and throws them.
    void throw_from(const Position& at, float angle, const Vec2& velocity, float spin) {
        const Position middle = bodies.front().position();
        const float c = std::cos(angle), s = std::sin(angle);
        for (Body& body : bodies) {
            const Vec2 arm = body.position() - middle;
            const Vec2 turned(c * arm.x - s * arm.y, s * arm.x + c * arm.y);
            body.set_position(at + turned);
            body.set_angle(body.angle() + angle);
            body.set_velocity(velocity + spin * Vec2(-turned.y, turned.x));
            body.set_angular_velocity(spin);
        }
    }
    void run(int steps) {
        for (int i = 0; i < steps; ++i) {
            world.step(dt);
            for (const Joint& joint : world.joints()) gap = std::max(gap, joint.separation());
            float mass = 0.0f, momentum = 0.0f;
            for (const Body& body : bodies) {
                mass += body.mass();
                momentum += body.mass() * body.velocity().y;
            }
            momentum_up = std::max(momentum_up, momentum / mass);
        }
        for (const Body& body : bodies) {
            const Position center = body.world_center();
            passed += center.y < -0.02f || center.x > wall_at;
        }
    }
};

Segment capsule(float half, float radius) {
    return {.from = {0, -half}, .to = {0, half}, .rounding = radius};
}

/// A figure of eleven bones is thrown to the ground or at a wall.
Joined thrown_figure(unsigned seed, float speed) {
    Random random{std::mt19937(seed)};
    Joined all;
    const float size = random(0.6f, 1.6f);
    const auto bone = [&](float y, float half, float radius) {
        return all.add({0, y * size}, 0, capsule(half * size, radius * size));
    };
    const auto joint = [&](const Body& a, const Body& b, float y, float low, float high) {
        all.pin(a, b, {0, y * size}, low, high);
    };
    const Body hip = bone(0.95f, 0.02f, 0.095f), torso = bone(1.2f, 0.135f, 0.09f),
               head = bone(1.475f, 0.0385f, 0.075f);
    joint(hip, torso, 1.0f, -0.8f, 0.3f);
    joint(torso, head, 1.4f, -0.9f, 0.3f);
    for (int side = 0; side < 2; ++side) {
        const Body thigh = bone(0.775f, 0.125f, 0.06f), shin = bone(0.475f, 0.14f, 0.045f),
                   arm = bone(1.225f, 0.125f, 0.035f), forearm = bone(0.975f, 0.125f, 0.03f);
        joint(hip, thigh, 0.9f, -0.2f, 1.2f);
        joint(thigh, shin, 0.625f, -1.5f, -0.02f);
        joint(torso, arm, 1.35f, -0.3f, 2.5f);
        joint(arm, forearm, 1.1f, -0.6f, 0.9f);
    }
    const bool at_wall = seed % 3 == 0;
    if (at_wall) all.wall_at = random(2.5f, 6.0f) + 2 * size;
    add_surroundings(all.world, seed, all.wall_at);
    const Vec2 way = at_wall ? Vec2(1, -0.2f) : Vec2(random(-0.7f, 0.7f), -1);
    all.throw_from({0, random(0.5f, 2) + 2 * size}, random(-3.14f, 3.14f),
                   (speed / way.length()) * way, random(-5, 5));
    all.run(150);
    return all;
}

/// A wagon drives over bumps, or against a wall, or falls.
Joined fast_wagon(unsigned seed, float speed) {
    Random random{std::mt19937(seed)};
    Joined all;
    const float length = random(0.8f, 3), height = random(0.2f, 0.8f), radius = random(0.12f, 0.5f);
    const Body wagon = all.add({0, radius + height / 2}, 0, Box{.width = length, .height = height});
    for (const float side : {-0.45f, 0.45f}) {
        const Vec2 axle(side * length, radius);
        const Body wheel = all.add(Position(axle), 0, Circle{.radius = radius});
        if (seed % 5 < 2) {
            all.pin(wagon, wheel, Position(axle));
            continue;
        }
        all.world.create_wheel_joint({.body_a = wagon.id(),
                                      .body_b = wheel.id(),
                                      .anchor_a = wagon.local_point(Position(axle)),
                                      .axis = {0, 1},
                                      .lower_translation = -0.3f * radius,
                                      .upper_translation = 0.3f * radius,
                                      .hertz = random(2, 6),
                                      .damping_ratio = 0.7f});
    }
    if (seed % 3 == 0) all.wall_at = random(5, 15) + length;
    add_surroundings(all.world, seed, all.wall_at);
    Body bumps = all.world.create_body({.type = BodyType::static_body});
    for (int i = 1; i < 30 && seed % 3 == 1; ++i)
        bumps.add(Circle{.radius = random(0.05f, 0.4f) * radius,
                         .center = {5.0f * float(i) + random(-0.5f, 0.5f), 0}});
    const bool falls = seed % 2 == 1;
    all.throw_from({0, radius + height / 2 + (falls ? random(1, 4) : 0)}, 0,
                   falls ? Vec2(speed / 2, -speed) : Vec2(speed, 0), 0);
    all.run(150);
    return all;
}

/// A chain of links, perhaps with a ball at its end, is thrown to the ground.
Joined thrown_chain(unsigned seed, float speed) {
    Random random{std::mt19937(seed)};
    Joined all;
    const int links = int(random(3, 16));
    const float length = random(0.15f, 0.6f), radius = random(0.015f, 0.06f);
    for (int i = 0; i < links; ++i) {
        const Body link = all.add({0, length * float(i)}, 0, capsule(length / 2, radius));
        const Position at = {0, length * (float(i) - 0.5f)};
        if (i > 0) all.pin(all.bodies[all.bodies.size() - 2], link, at);
    }
    if (seed % 2 == 1) {
        const Position at = {0, length * (float(links) - 0.5f)};
        const Body last = all.bodies.back();
        all.pin(last, all.add(at, 0, Circle{.radius = random(0.1f, 0.3f)}), at);
    }
    add_surroundings(all.world, seed, infinite);
    all.throw_from({0, random(0.5f, 3) + length * float(links + 1)}, random(-3.14f, 3.14f),
                   {0.3f * speed, -speed}, 0);
    all.run(150);
    return all;
}

/// The widest gap of many worlds, m, and the mean of their widest ones. Nothing passes through.
struct Gaps {
    float widest = 0.0f, mean = 0.0f;
};
Gaps gaps_of(auto&& make, float speed) {
    Gaps gaps;
    const unsigned seeds = seeds_or(120);
    for (unsigned seed = 0; seed < seeds; ++seed) {
        const Joined all = make(seed, speed);
        INFO("seed " << seed << " at " << speed << " m/s: gap " << all.gap);
        CHECK(all.passed == 0);
        CHECK(all.momentum_up < 0.5f * speed + 3.0f);
        gaps.widest = std::max(gaps.widest, all.gap);
        gaps.mean += all.gap / float(seeds);
    }
    return gaps;
}

}  // namespace

// A limb that continuous collision puts back takes the others with it.
TEST_CASE("a thrown figure keeps its limbs") {
    for (const float speed : {5.0f, 10.0f, 20.0f}) {
        const Gaps gaps = gaps_of(thrown_figure, speed);
        INFO(speed << " m/s: " << gaps.mean << ", at most " << gaps.widest);
        CHECK(gaps.mean < 0.07f);
        CHECK(gaps.widest < 0.18f);
    }
    for (const float speed : {40.0f, 60.0f}) CHECK(gaps_of(thrown_figure, speed).mean < 0.17f);
}

TEST_CASE("a fast wagon keeps its wheels") {
    for (const float speed : {5.0f, 10.0f, 20.0f, 40.0f, 60.0f}) {
        const Gaps gaps = gaps_of(fast_wagon, speed);
        INFO(speed << " m/s: " << gaps.mean << ", at most " << gaps.widest);
        CHECK(gaps.mean < 0.05f);
        CHECK(gaps.widest < 0.3f);
    }
}

TEST_CASE("a thrown chain keeps its links") {
    for (const float speed : {5.0f, 10.0f, 20.0f}) {
        const Gaps gaps = gaps_of(thrown_chain, speed);
        INFO(speed << " m/s: " << gaps.mean << ", at most " << gaps.widest);
        CHECK(gaps.mean < 0.07f);
        CHECK(gaps.widest < 0.2f);
    }
    for (const float speed : {40.0f, 60.0f}) CHECK(gaps_of(thrown_chain, speed).mean < 0.2f);
}

}  // namespace joined_impacts_test
