// Moving bodies that meet within a step: bullets, bodies that move on their own, and bodies that
// rotate in place. None passes through another one. FETTLE_SEEDS=n: n worlds of each kind.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <random>
#include <string>

#include "catch.h"
#include "family.h"

namespace swept_family_test {

using namespace fettle::physics;
using families::Random;
using families::seeds_or;

namespace {

constexpr float pi = 3.14159265f;
const char* const shape_names[] = {"discs", "boxes", "capsules", "ellipses", "planks"};

void add_shape(Body& body, unsigned kind, float radius) {
    if (kind == 0) body.add(Circle{radius});
    if (kind == 1) body.add(Box{.width = 2 * radius, .height = 2 * radius});
    if (kind == 2) body.add(Segment{{-radius, 0}, {radius, 0}, 0.3f * radius});
    if (kind == 3) body.add(Ellipse{.radius_x = radius, .radius_y = 0.5f * radius});
    if (kind == 4) body.add(Box{.width = 4 * radius, .height = 0.4f * radius});
}

Vec2 direction(float angle) {
    return {std::cos(angle), std::sin(angle)};
}

World empty_world() {
    return World({.gravity = {0, 0}});
}

void run(World& world, int steps) {
    for (int i = 0; i < steps; ++i) world.step(1.0f / 60);
}

/// Two bodies whose centers would be in the same place at the same time.
bool bullets_miss(unsigned kind, bool both, unsigned seed) {
    Random random{std::mt19937(seed)};
    World world = empty_world();
    const float time = random(0.1f, 0.3f), first = random(0, 2 * pi);
    const auto shoot = [&](float angle, float speed, bool bullet) {
        const Vec2 velocity = speed * direction(angle);
        Body body = world.create_body({.position = -time * velocity,
                                       .angle = random(0, 2 * pi),
                                       .velocity = velocity,
                                       .angular_velocity = random(-20, 20),
                                       .bullet = bullet});
        add_shape(body, kind, random(0.05f, 0.3f));
        return body;
    };
    Body a = shoot(first, random(30, 150), true);
    shoot(first + random(0.5f, 5.7f), both ? random(30, 150) : random(0, 3), both);
    const Vec2 before = a.velocity();
    run(world, 40);
    return (a.velocity() - before).length() < 1e-3f * before.length();
}

/// A paddle that rotates in place, and a body within its reach.
bool paddle_misses(bool bullet, unsigned seed) {
    Random random{std::mt19937(seed)};
    World world = empty_world();
    const float length = random(1, 3), spin = random(20, 60) * (seed % 2 ? 1.0f : -1.0f);
    Body paddle =
        world.create_body({.type = bullet ? BodyType::dynamic_body : BodyType::kinematic_body,
                           .angular_velocity = spin,
                           .bullet = bullet});
    paddle.add(Box{.width = length, .height = random(0.05f, 0.2f)}, {.density = 100});
    const Vec2 place = random(0.3f, 0.45f) * length * direction(random(0.6f, 2.5f));
    Body body = world.create_body({.position = place});
    add_shape(body, seed % 3, random(0.05f, 0.12f));
    run(world, 15);
    return (body.position() - Position(place)).length() < 0.01f;
}

/// A wall that moves on its own towards a row of bodies; returns how many it left behind. A body
/// that goes round an end of a rotating wall does not count.
int left_behind(unsigned kind, float speed, int count, bool rotates, unsigned seed) {
    Random random{std::mt19937(seed)};
    World world = empty_world();
    const float turn = rotates ? random(1, 3) * (seed % 2 ? 1.0f : -1.0f) : 0.0f, height = 12;
    Body wall = world.create_body({.type = BodyType::kinematic_body,
                                   .position = {-3 - random(0, 1), 0},
                                   .velocity = {speed, 0},
                                   .angular_velocity = turn});
    wall.add(Box{.width = 0.02f * std::exp(random(0, std::log(50.0f))), .height = height});
    const float radius = 0.03f * std::exp(random(0, std::log(15.0f)));
    std::vector<Body> bodies;
    for (int i = 0; i < count; ++i) {
        const float x = (kind == 4 ? 4.04f : 2.04f) * float(i) * radius;
        bodies.push_back(world.create_body(
            {.position = {x, random(-0.3f, 0.3f) * radius}, .angle = random(0, 2 * pi)}));
        add_shape(bodies.back(), kind, radius);
    }
    std::vector<bool> beside(bodies.size());  // has been beyond an end
    int behind = 0;
    for (int steps = int(60 * 5 / speed) + 1; steps > 0; --steps) {
        run(world, 1);
        const Vec2 across = direction(wall.angle()), along = {-across.y, across.x};
        behind = 0;
        for (size_t i = 0; i < bodies.size(); ++i) {
            const Vec2 place = bodies[i].position() - wall.position();
            beside[i] = beside[i] || std::fabs(place.dot(along)) > 0.5f * height;
            behind += !beside[i] && place.dot(across) < 0;
        }
    }
    return behind;
}

void add_wheel(Body& body, unsigned kind) {
    if (kind == 0) body.add(Circle{0.5f});
    if (kind == 1) body.add(Box{});
    if (kind == 2) body.add(Segment{{0, -0.3f}, {0, 0.3f}, 0.3f});
    if (kind == 3) body.add(Ellipse{.radius_x = 0.5f, .radius_y = 0.6f});
    if (kind == 4) body.add(Polygon{.vertices = {{-0.5f, -0.4f}, {0.5f, -0.4f}, {0, 0.6f}}});
    if (kind == 5)
        body.add(Concave{
            .vertices = {{-0.5f, -0.5f}, {0.5f, -0.5f}, {0.5f, 0.5f}, {0, 0.2f}, {-0.5f, 0.5f}}});
}

/// A fast body towards the middle of a kinematic one; false if it went round it without a contact.
bool meets_wheel(unsigned kind, unsigned seed) {
    Random random{std::mt19937(seed)};
    World world = empty_world();
    const float speed = random(40, 200);
    Body wheel = world.create_body(
        {.type = BodyType::kinematic_body, .position = {random(5, 8), 0}, .angle = random(-3, 3)});
    if (seed % 2 == 0) wheel.set_velocity({random(-3, 3), 0});
    add_wheel(wheel, kind);
    Body body = world.create_body({.angle = random(-3, 3),
                                   .velocity = {speed, 0},
                                   .angular_velocity = random(-3, 3),
                                   .bullet = seed % 4 < 2});
    add_shape(body, seed % 5, random(0.1f, 0.25f));
    const float line = body.world_center().y;
    for (int steps = int(60 * 12 / speed) + 2; steps > 0; --steps) {
        const bool on_line = std::fabs(body.world_center().y - line) < 0.01f;
        run(world, 1);
        if (!world.events().contact_begin.empty()) return on_line;
    }
    return false;
}

/// A plank that rotates in place beside a thin fixed post.
bool plank_misses_post(unsigned seed) {
    Random random{std::mt19937(seed)};
    World world = empty_world();
    const float length = random(0.5f, 3), spin = random(10, 70) * (seed % 2 ? 1.0f : -1.0f);
    const float thickness = random(0.02f, 0.06f) * length, size = random(0.01f, 0.05f);
    Body plank = world.create_body({.angular_velocity = spin});
    plank.add(Box{.width = length, .height = thickness});
    const float angle = random(0.7f, pi - 0.7f);
    Body post = world.create_body(
        {.type = BodyType::static_body,
         .position = random(0.3f, 0.42f) * length * direction(angle + (seed % 4 < 2 ? pi : 0))});
    if (seed % 3 == 0) post.add(Circle{size});
    if (seed % 3 == 1) post.add(Box{.width = size, .height = size});
    if (seed % 3 == 2) post.add(Segment{{0, -size}, {0, size}});
    run(world, int(60 * pi / std::fabs(spin)) + 3);
    return std::fabs(plank.angular_velocity() - spin) < 0.01f * std::fabs(spin);
}

}  // namespace

TEST_CASE("bullets of any shape do not pass through other moving bodies") {
    for (unsigned kind = 0; kind < std::size(shape_names); ++kind)
        for (const bool both : {false, true}) {
            unsigned missed = 0;
            for (unsigned seed = 0; seed < seeds_or(50); ++seed)
                missed += bullets_miss(kind, both, seed);
            INFO(shape_names[kind] << (both ? ", both fast" : ", one fast"));
            CHECK(missed == 0);
        }
}

TEST_CASE("a paddle that rotates fast hits a body in its reach") {
    for (const bool bullet : {false, true}) {
        unsigned missed = 0;
        for (unsigned seed = 0; seed < 2 * seeds_or(50); ++seed)
            missed += paddle_misses(bullet, seed);
        INFO((bullet ? "a bullet" : "a kinematic paddle"));
        CHECK(missed == 0);
    }
}

TEST_CASE("a fast wall leaves no body behind") {
    for (unsigned kind = 0; kind < std::size(shape_names); ++kind)
        for (const float speed : {5.0f, 20.0f, 40.0f})
            for (const int count : {1, 4})
                for (const bool rotates : {false, true}) {
                    int behind = 0;
                    for (unsigned seed = 0; seed < seeds_or(50); ++seed)
                        behind += left_behind(kind, speed, count, rotates, seed);
                    INFO(count << " " << shape_names[kind] << ", " << speed
                               << " m/s, rotates: " << rotates);
                    // One ellipse in a thousand that is pressed between others and the wall slips
                    // through it.
                    const int allowed = kind == 3 ? count * int(seeds_or(50)) / 1000 : 0;
                    CHECK(behind <= allowed);
                }
}

TEST_CASE("fast bodies do not pass through a kinematic body that is slow or stands still") {
    unsigned through = 0;
    for (unsigned seed = 0; seed < 4 * seeds_or(50); ++seed) {
        Random random{std::mt19937(seed)};
        World world = empty_world();
        Body wall = world.create_body(
            {.type = BodyType::kinematic_body, .velocity = {seed % 2 ? random(-1, 1) : 0, 0}});
        wall.add(Box{.width = random(0.02f, 0.2f), .height = 6});
        if (seed % 4 == 0) run(world, 60);  // it falls asleep
        Body body = world.create_body({.position = {-3 - random(0, 1), 0},
                                       .angle = random(0, 2 * pi),
                                       .velocity = {random(20, 200), 0}});
        add_shape(body, seed % 5, random(0.05f, 0.2f));
        run(world, 60);
        through += body.position().x > wall.position().x;
    }
    CHECK(through == 0);
}

TEST_CASE("a fast body in the way of a kinematic body touches it before it is turned aside") {
    for (unsigned kind = 0; kind < 6; ++kind) {
        unsigned missed = 0;
        for (unsigned seed = 0; seed < 4 * seeds_or(50); ++seed) missed += !meets_wheel(kind, seed);
        INFO("kind " << kind);
        CHECK(missed == 0);
    }
}

TEST_CASE("a plank that rotates in place does not pass a thin post") {
    unsigned missed = 0;
    for (unsigned seed = 0; seed < 4 * seeds_or(50); ++seed) missed += plank_misses_post(seed);
    CHECK(missed == 0);
}

TEST_CASE("a body between a fast wall and a fixed one stays where the fixed one holds it") {
    for (const float speed : {20.0f, 60.0f}) {
        World world = empty_world();
        Body fixed = world.create_body({.type = BodyType::static_body, .position = {2, 0}});
        fixed.add(Box{.width = 0.1f, .height = 6});
        Body wall = world.create_body(
            {.type = BodyType::kinematic_body, .position = {-3, 0}, .velocity = {speed, 0}});
        wall.add(Box{.width = 0.1f, .height = 6});
        Body disc = world.create_body({});
        disc.add(Circle{0.1f});
        run(world, 30);
        CHECK(disc.position().x < 2);
        CHECK(disc.position().x > 1);
        CHECK(wall.position().x > 2);
    }
}

TEST_CASE("a body that bullets hit in every step goes on falling") {
    World world;
    Body plate = world.create_body({.position = {0, 20}, .velocity = {0, -5}});
    plate.add(Box{.width = 4, .height = 1}, {.density = 1000});
    for (int i = 0; i < 30; ++i) {
        Body bullet =
            world.create_body({.position = {0.1f * float(i) - 1.5f, plate.position().y - 2},
                               .velocity = {0, 90},
                               .bullet = true});
        bullet.add(Circle{0.05f}, {.density = 0.01f});
        world.step(1.0f / 60);
    }
    CHECK(plate.position().y == Approx(20 - 5 * 0.5f - 5 * 0.25f).margin(0.1f));
}

TEST_CASE("impacts of moving bodies do not depend on the number of threads") {
    const auto hash_of = [](int threads) {
        World world;
        world.set_threads(threads);
        Random random{std::mt19937(1)};
        Body ground = world.create_body({.type = BodyType::static_body});
        ground.add(Box{.width = 100, .height = 1, .center = {0, -1}});
        Body paddle = world.create_body({.type = BodyType::kinematic_body,
                                         .position = {0, 3},
                                         .velocity = {5, 0},
                                         .angular_velocity = 40});
        paddle.add(Box{.width = 4, .height = 0.1f});
        paddle.add(Circle{3}, {.sensor = true});
        for (unsigned i = 0; i < 400; ++i) {
            Body body = world.create_body({.position = {random(-20, 20), random(0, 20)},
                                           .velocity = {random(-80, 80), random(-80, 80)},
                                           .bullet = i % 3 == 0});
            add_shape(body, i % 5, random(0.05f, 0.2f));
        }
        size_t reports = 0;
        for (int i = 0; i < 60; ++i) {
            world.step(1.0f / 60);
            reports = 31 * reports + world.events().sensor_begin.size();
        }
        CHECK(!world.validate());
        return std::pair(world.hash(), reports);
    };
    const auto one = hash_of(1);
    CHECK((hash_of(2) == one));
    CHECK((hash_of(3) == one));
}

}  // namespace swept_family_test
