// Bodies with joints that pressers squeeze, that other bodies hold apart, or that are made to
// overlap: nothing is thrown, and what is pressed together comes to rest.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "catch.h"
#include "family.h"

using namespace fettle::physics;
using families::Random;

namespace pressed_joints_test {
namespace {

constexpr float rates[] = {30, 60, 144};  // steps a second

struct Pit {
    Random random;
    World world;
    std::vector<Body> bodies;
    float dt;

    explicit Pit(unsigned seed, float half_width) : random{std::mt19937(seed + 1)} {
        dt = 1 / rates[seed % 3];
        Body walls = world.create_body({.type = BodyType::static_body});
        walls.add(Box{.width = 2 * half_width + 2, .height = 2, .center = {0, -1}});
        for (const float side : {-1.0f, 1.0f})
            walls.add(Box{.width = 2, .height = 80, .center = {side * (half_width + 1), 40}});
    }
    Body add(Position place, const Geometry& geometry, float density = 1) {
        bodies.push_back(world.create_body({.position = place}));
        bodies.back().add(geometry, {.density = density});
        return bodies.back();
    }
    void weld(Body a, Body b, Position place) {
        world.create_weld_joint({.body_a = a.id(),
                                 .body_b = b.id(),
                                 .anchor_a = a.local_point(place),
                                 .anchor_b = b.local_point(place)});
    }
    float fastest() const {
        float speed = 0;
        for (const Body& body : bodies) speed = std::max(speed, body.velocity().length());
        return speed;
    }
    void wait(float seconds) {
        for (float time = 0; time < seconds; time += dt) world.step(dt);
    }
    float fastest_of_a_second() {
        float most = 0;
        for (float time = 0; time < 1; time += dt) {
            world.step(dt);
            most = std::max(most, fastest());
        }
        return most;
    }
    /// Moves a presser to a place. Returns how much faster than it the fastest body gets.
    float press(Body presser, Position goal, float speed) {
        float most = 0;
        for (int step = 0; step < 4000; ++step) {
            const Vec2 way = goal - presser.position();
            const float length = way.length();
            if (length < 1e-3f) break;
            presser.set_velocity((std::min(speed, length / dt) / length) * way);
            world.step(dt);
            most = std::max(most, fastest());
        }
        presser.set_velocity({0, 0});
        return std::max(most, fastest_of_a_second()) - speed;
    }
    /// A ram comes from the left.
    float press_by_ram(float least, float greatest, float greatest_speed) {
        Body ram = world.create_body({.type = BodyType::kinematic_body, .position = {-4, 2.55f}});
        ram.add(Box{.width = 1, .height = 5});
        wait(3);
        const float speed = random(0.5f, greatest_speed);
        return press(ram, {random(least, greatest), 2.55f}, speed);
    }
};

/// A car with two wheels between a ram and a wall.
float press_car(unsigned seed) {
    Pit pit(seed, 6);
    Body chassis = pit.add({2, 1}, Box{.width = 2, .height = 0.5f}, 2);
    const float radius = pit.random(0.25f, 0.4f);
    for (const float x : {1.3f, 2.7f}) {
        Body wheel = pit.add({x, 0.5f}, Circle{.radius = radius});
        pit.world.create_wheel_joint({.body_a = chassis.id(),
                                      .body_b = wheel.id(),
                                      .anchor_a = chassis.local_point({x, 0.5f}),
                                      .lower_translation = -0.25f,
                                      .upper_translation = 0.25f});
    }
    return pit.press_by_ram(3, 5.2f, 6);
}

/// Blocks that are welded in rows and columns between a ram and a wall.
float press_welded(unsigned seed) {
    Pit pit(seed, 6);
    const int width = 2 + int(seed % 2), height = 1 + int(seed / 2 % 3);
    std::vector<Body> blocks;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const Position place = {2 + float(x), 0.5f + float(y)};
            blocks.push_back(pit.add(place, Box{.width = 1, .height = 1}));
            const size_t last = blocks.size() - 1;
            if (x > 0) pit.weld(blocks[last - 1], blocks[last], {place.x - 0.5f, place.y});
            if (y > 0)
                pit.weld(blocks[last - size_t(width)], blocks[last], {place.x, place.y - 0.5f});
        }
    }
    return pit.press_by_ram(3, 5.3f, 8);
}

/// A chain of links, and some boxes on it, between a ram and a wall.
float press_chain(unsigned seed) {
    Pit pit(seed, 6);
    std::vector<Body> links;
    for (int i = 0; i < 10; ++i) {
        const float x = -1 + 0.5f * float(i);
        links.push_back(pit.add({x, 1}, Box{.width = 0.46f, .height = 0.2f}, 2));
        if (i == 0) continue;
        const Position place = {x - 0.25f, 1};
        const Body a = links[size_t(i) - 1], b = links.back();
        pit.world.create_revolute_joint({.body_a = a.id(),
                                         .body_b = b.id(),
                                         .anchor_a = a.local_point(place),
                                         .anchor_b = b.local_point(place)});
    }
    for (int i = 0; i < 4; ++i) {
        const float size = pit.random(0.35f, 0.6f);
        const float x = pit.random(0, 4);
        pit.add({x, 3 + float(i)}, Box{.width = size, .height = 0.8f * size});
    }
    return pit.press_by_ram(3, 5.4f, 8);
}

/// Two doors close on a heap.
float close_doors(unsigned seed) {
    Pit pit(seed, 8);
    const int count = 2 + int(seed % 9);
    for (int i = 0; i < count; ++i) {
        const float size = pit.random(0.3f, 1);
        const Position place = {pit.random(-1.5f, 1.5f), 1 + 0.6f * float(i)};
        if (pit.random(0, 1) < 0.5f)
            pit.add(place, Circle{.radius = 0.5f * size});
        else
            pit.add(place, Box{.width = size, .height = size * pit.random(0.4f, 1)});
    }
    std::vector<Body> doors;
    for (const float side : {-1.0f, 1.0f}) {
        doors.push_back(pit.world.create_body(
            {.type = BodyType::kinematic_body, .position = {4 * side, 1.55f}}));
        doors.back().add(Box{.width = 0.5f, .height = 3});
    }
    pit.wait(3);
    const float speed = pit.random(0.5f, 8), end = pit.random(0.25f, 0.6f);
    float most = 0;
    while (doors[1].position().x > end + 2e-3f) {
        const float left = float(doors[1].position().x) - end;
        const float now = std::min(speed, left / pit.dt);
        doors[0].set_velocity({now, 0});
        doors[1].set_velocity({-now, 0});
        pit.world.step(pit.dt);
        most = std::max(most, pit.fastest());
    }
    for (Body& door : doors) door.set_velocity({0, 0});
    return std::max(most, pit.fastest_of_a_second()) - speed;
}

struct Result {
    unsigned thrown = 0, count = 0;
    float worst = 0;
};

/// How many of the worlds throw a body, by more than `few` m/s.
Result throw_many(float (*family)(unsigned), const char* name, float few) {
    Result result;
    result.count = families::seeds_or(60);
    for (unsigned seed = 0; seed < result.count; ++seed) {
        const float excess = family(seed);
        result.thrown += excess > few;
        result.worst = std::max(result.worst, excess);
    }
    std::printf("pressed, %s: %u of %u thrown, at most %.1f m/s faster than the presser\n", name,
                result.thrown, result.count, double(result.worst));
    return result;
}

/// Two legs that are welded to a beam.
Pit legs(unsigned seed, Body& first, Body& second) {
    Pit pit(seed, 8);
    first = pit.add({0, 1.5f}, Box{.width = 1, .height = 1});
    second = pit.add({1.2f, 1.5f}, Box{.width = 1, .height = 1});
    Body beam = pit.add({0.6f, 2.8f}, Box{.width = 2.4f, .height = 0.2f});
    pit.weld(first, beam, {0, 2});
    pit.weld(second, beam, {1.2f, 2});
    pit.wait(4);
    return pit;
}

/// A body appears between the legs. Returns the speed of the fastest body twelve seconds later.
float speed_between_legs(unsigned seed) {
    Body first, second;
    Pit pit = legs(seed, first, second);
    const float size = pit.random(0.3f, 1.2f), density = pit.random(0.2f, 3);
    const Position middle =
        first.world_center() + 0.5f * (second.world_center() - first.world_center());
    if (pit.random(0, 1) < 0.5f)
        pit.add(middle, Circle{.radius = 0.5f * size}, density);
    else
        pit.add(middle, Box{.width = size, .height = size * pit.random(0.4f, 1)}, density);
    pit.wait(12);
    return pit.fastest_of_a_second();
}

/// A crate between two posts on a sill becomes larger than the place between them. Returns the
/// speed of the fastest body ten seconds later.
float speed_in_gate(unsigned seed) {
    Pit pit(seed, 6);
    Body sill = pit.add({0, 0.1f}, Box{.width = 3, .height = 0.2f}, 2);
    for (const float side : {-1.0f, 1.0f}) {
        Body post = pit.add({side, 1.2f}, Box{.width = 0.3f, .height = 2});
        pit.weld(sill, post, {side, 0.2f});
    }
    Body crate = pit.add({0, 0.7f}, Box{.width = 1, .height = 1});
    pit.wait(2);
    const float size = pit.random(1.4f, 2.6f);
    if (pit.random(0, 1) < 0.5f)
        crate.shapes()[0].set_geometry(Box{.width = size, .height = pit.random(0.5f, 1.5f)});
    else
        crate.shapes()[0].set_geometry(Circle{.radius = 0.5f * size});
    pit.wait(10);
    return pit.fastest_of_a_second();
}

}  // namespace

TEST_CASE("a ram does not throw what joints connect") {
    for (const Result& result :
         {throw_many(press_car, "car", 10), throw_many(press_welded, "welded", 10)}) {
        CHECK(result.thrown * 5 <= result.count + 5);  // rounded up where there are few seeds
        CHECK(result.worst < 25);
    }
}

TEST_CASE("a chain that a ram presses together does not spring open") {
    const Result result = throw_many(press_chain, "chain", 6);
    CHECK(result.thrown * 20 <= result.count);
    CHECK(result.worst < 10);
}

TEST_CASE("a straight chain that is pressed at its ends buckles") {
    float apart = 0;
    for (unsigned seed = 0; seed < families::seeds_or(60); ++seed) {
        families::Random random{std::mt19937(seed)};
        World world({.gravity = {0, seed % 2 == 0 ? -10.0f : 0.0f}});
        const int count = 2 + int(seed / 2 % 8);
        const float length = random(0.3f, 1), height = length * random(0.2f, 0.5f);
        const float half = 0.5f * length * float(count);
        Body floor = world.create_body({.type = BodyType::static_body, .position = {0, -0.5f}});
        floor.add(Box{.width = 80, .height = 1});
        std::vector<Body> walls, planks;
        for (const float side : {-1.0f, 1.0f}) {
            walls.push_back(world.create_body(
                {.type = BodyType::kinematic_body, .position = {side * (half + 0.5f), 3}}));
            walls.back().add(Box{.width = 1, .height = 6});
        }
        for (int i = 0; i < count; ++i) {
            planks.push_back(world.create_body(
                {.position = {-half + length * (float(i) + 0.5f), 0.5f * height}}));
            planks.back().add(Box{.width = length, .height = height}, {.friction = 0.3f});
            if (i > 0)
                world.create_revolute_joint({.body_a = planks[size_t(i) - 1].id(),
                                             .body_b = planks[size_t(i)].id(),
                                             .anchor_a = {0.5f * length, 0},
                                             .anchor_b = {-0.5f * length, 0}});
        }
        const auto wait = [&](float seconds) {
            for (int i = 0; i < int(seconds * 60); ++i) world.step(1.0f / 60);
        };
        walls[0].set_velocity({0.5f, 0});
        walls[1].set_velocity({-0.5f, 0});
        wait(0.4f * half);
        for (Body wall : walls) wall.set_velocity({0, 0});
        wait(3);
        CAPTURE(seed, count);
        for (Joint joint : world.joints()) {
            // The flat ends of two planks lie against the walls, so that these cannot buckle.
            if (count > 2) CHECK(joint.separation() < 0.02f);
            if (joint.separation() > 0.02f) CHECK(joint.body_b().awake());
            if (count > 2) apart = std::max(apart, joint.separation());
        }
    }
    std::printf("pressed straight chains: joints part by at most %.4f m\n", double(apart));
}

TEST_CASE("doors that close on a heap do not throw it") {
    const Result result = throw_many(close_doors, "doors", 6);
    CHECK(result.thrown * 4 <= result.count);
    CHECK(result.worst < 15);
}

TEST_CASE("a body between two welded legs comes to rest") {
    const unsigned count = families::seeds_or(60);
    unsigned moving = 0;
    for (unsigned seed = 0; seed < count; ++seed) moving += speed_between_legs(seed) > 0.3f;
    std::printf("between legs: %u of %u move\n", moving, count);
    CHECK(moving * 5 <= count);
}

TEST_CASE("a crate that grows between welded posts comes to rest") {
    const unsigned count = families::seeds_or(60);
    unsigned moving = 0;
    for (unsigned seed = 0; seed < count; ++seed) moving += speed_in_gate(seed) > 0.3f;
    std::printf("in a gate: %u of %u move\n", moving, count);
    CHECK(moving == 0);
}

}  // namespace pressed_joints_test
