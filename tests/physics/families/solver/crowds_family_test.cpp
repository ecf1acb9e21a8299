// Many bodies in one spot: contacts stay few, the bodies come apart, and a push gives them little
// energy. FETTLE_SEEDS=n: n crowds.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <set>

#include "catch.h"
#include "family.h"

namespace crowds_family_test {

using namespace fettle::physics;
using families::Random;
using families::seeds_or;

namespace {

void add_shape(Body& body, int kind, float size) {
    if (kind == 0) body.add(Circle{.radius = size});
    if (kind == 1) body.add(Box{.width = 2 * size, .height = 2 * size});
    if (kind == 2) body.add(Segment{{-size, 0}, {size, 0}, 0.4f * size});
}

/// `kind` 3: discs, boxes and capsules of different sizes.
std::vector<Body> crowd(World& world, Random& random, int count, int kind, float spread) {
    std::vector<Body> bodies;
    for (int i = 0; i < count; ++i) {
        bodies.push_back(
            world.create_body({.position = {random(-spread, spread), random(-spread, spread)}}));
        add_shape(bodies.back(), kind == 3 ? i % 3 : kind, kind == 3 ? random(0.2f, 0.6f) : 0.5f);
    }
    return bodies;
}

float fastest(const std::vector<Body>& bodies) {
    float most = 0.0f;
    for (const Body& body : bodies) most = std::max(most, body.velocity().length());
    return most;
}

float width(const std::vector<Body>& bodies) {
    float low = 0.0f, high = 0.0f;
    for (const Body& body : bodies) {
        low = std::min<float>(low, body.position().x);
        high = std::max<float>(high, body.position().x);
    }
    return high - low;
}

TEST_CASE("a crowd comes apart slowly and with few contacts") {
    float worst_speed = 0.0f, worst_contacts = 0.0f;
    for (int seed = 0; seed < int(seeds_or(6)); ++seed) {
        Random random{std::mt19937(unsigned(seed) + 1)};
        World world({.gravity = {0, 0}});
        const int count = int(random(200, 500));
        const float spread = seed % 3 == 0 ? 0.02f : random(0.1f, 1.0f);
        const std::vector<Body> bodies = crowd(world, random, count, seed % 4, spread);
        for (int step = 0; step < 240; ++step) {
            world.step(1.0f / 60);
            worst_speed = std::max(worst_speed, fastest(bodies));
            worst_contacts =
                std::max(worst_contacts, float(world.statistics().contacts) / float(count));
        }
        CAPTURE(seed, count, spread);
        CHECK(width(bodies) > 6.0f);
        CHECK_FALSE(world.validate());
    }
    std::printf("crowds: at most %.2f m/s, %.1f contacts a body\n", double(worst_speed),
                double(worst_contacts));
    CHECK(worst_speed < 80.0f);
    CHECK(worst_contacts < 35.0f);
}

TEST_CASE("a crowd between walls comes to lie on the floor") {
    Random random{std::mt19937(3)};
    World world({.bounds = Aabb{{-12, -2}, {12, 60}}});
    const std::vector<Body> bodies = crowd(world, random, 300, 3, 0.5f);
    for (int step = 0; step < 900; ++step) world.step(1.0f / 60);
    CHECK(fastest(bodies) < 1.0f);
    for (const Body& body : bodies) {
        CHECK(body.position().y > -2.1f);
        CHECK(std::abs(body.position().x) < 12.1f);
    }
}

TEST_CASE("a crowd is computed equally by several threads and after a restore") {
    World one;
    Random random{std::mt19937(5)};
    one.create_body({.type = BodyType::static_body})
        .add(Box{.width = 60, .height = 1, .center = {0, -2}});
    crowd(one, random, 400, 3, 0.3f);
    World three = one.clone();
    three.set_threads(3);
    for (int step = 0; step < 150; ++step) {
        one.step(1.0f / 60);
        three.step(1.0f / 60);
        if (step % 25 == 10) {
            std::vector<std::byte> saved;
            three.save(saved);
            three.restore(saved);
        }
        REQUIRE(one.hash() == three.hash());
    }
}

TEST_CASE("a sensor reports every body of a crowd") {
    Random random{std::mt19937(7)};
    World world({.gravity = {0, 0}});
    world.create_body({.type = BodyType::static_body})
        .add(Box{.width = 4, .height = 4}, {.sensor = true});
    Body carried = world.create_body({.position = {0, 0}});
    carried.add(Circle{1.0f}, {.sensor = true});
    crowd(world, random, 300, 0, 0.2f);
    world.step(1.0f / 60);
    std::set<uint32_t> fixed, moving;
    for (const SensorEvent& event : world.events().sensor_begin)
        (event.sensor_body == carried.id() ? moving : fixed).insert(event.visitor_body.index);
    CHECK(fixed.size() == 300);
    CHECK(moving.size() == 300);
}

TEST_CASE("a body that wakes near a sleeping crowd is held by it") {
    World world;
    world.create_body({.type = BodyType::static_body})
        .add(Box{.width = 100, .height = 2, .center = {0, -1}});
    // Thin bars whose boxes overlap, but that touch only their neighbors.
    std::vector<Body> bars;
    for (int i = 0; i < 90; ++i) {
        bars.push_back(world.create_body({.position = {0.3f * float(i), 2.5f}, .angle = 1.2f}));
        bars.back().add(Box{.width = 5, .height = 0.1f});
    }
    for (int step = 0; step < 900; ++step) world.step(1.0f / 60);
    Body ball = world.create_body({.position = {12, 8}});
    ball.add(Circle{0.3f});
    for (int step = 0; step < 240; ++step) world.step(1.0f / 60);
    for (const Body& bar : bars) CHECK(bar.position().y > -0.1f);
    CHECK(ball.position().y > 0.1f);
    CHECK_FALSE(world.validate());
}

}  // namespace

}  // namespace crowds_family_test
