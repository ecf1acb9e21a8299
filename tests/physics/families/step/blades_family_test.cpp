// Bodies that fast blades hit, which move on their own: they are flung away, and none sticks to the
// blade, gets into it or is faster than a blade can make it. FETTLE_SEEDS=n: n worlds of each kind.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "catch.h"
#include "family.h"

namespace blades_family_test {

using namespace fettle::physics;
using families::Random;
using families::seeds_or;

namespace {

constexpr float frame = 1.0f / 60;

/// A blade turns in a room into which bodies fall.
struct Mill {
    Random random;
    World world;
    Body blade;
    float speed = 0;   ///< of the blade, rad/s
    float length = 0;  ///< from end to end, m
    std::vector<Body> bodies;

    Mill(unsigned kind, unsigned seed) : random{std::mt19937(seed * 7919 + kind)} {
        Body room = world.create_body({.type = BodyType::static_body});
        room.add(Box{.width = 40, .height = 1, .center = {0, -5}});
        for (const float x : {-8.0f, 8.0f})
            room.add(Box{.width = 1, .height = 30, .center = {x, 5}});
        speed = random(5, 40) * (seed % 2 == 0 ? 1.0f : -1.0f);
        length = random(1, 4);
        add_blade(seed);
        for (unsigned i = 0; i <= seed % 6; ++i) add_body(kind);
    }
    void add_blade(unsigned seed) {
        const float thickness = random(0.06f, 0.3f);
        const ShapeDef grips = {.friction = random(0, 1)};
        blade = world.create_body({.type = BodyType::kinematic_body, .angular_velocity = speed});
        if (seed % 4 == 3) {
            blade.add(Segment{{-0.5f * length, 0}, {0.5f * length, 0}, 0.5f * thickness}, grips);
            return;
        }
        blade.add(Box{.width = length, .height = thickness}, grips);
        if (seed % 4 == 2) blade.add(Box{.width = thickness, .height = length}, grips);
    }
    void add_body(unsigned kind) {
        Body body = world.create_body({.position = {random(-1.5f, 1.5f), random(2.5f, 8)},
                                       .angle = random(-3, 3),
                                       .velocity = {0, random(-10, 0)},
                                       .angular_velocity = random(-10, 10)});
        const float size = random(0.2f, 0.6f);
        const ShapeDef surface = {.density = random(0.5f, 3), .friction = random(0, 1)};
        switch (kind) {
            case 0:
                body.add(Segment{{-size, 0}, {size, 0}, random(0.005f, 0.05f)}, surface);
                break;
            case 1:
                body.add(Box{.width = 2 * size, .height = size * random(0.03f, 0.3f)}, surface);
                break;
            case 2:
                body.add(Circle{0.5f * size}, surface);
                break;
            case 3:
                body.add(Box{.width = size, .height = size}, surface);
                break;
            case 4:
                for (const float x : {-0.5f * size, 0.5f * size})
                    body.add(Circle{.radius = 0.3f * size, .center = {x, 0}}, surface);
                body.add(Box{.width = size, .height = 0.1f * size}, surface);
                break;
            default:
                body.add(Concave{.vertices = {{size, 0},
                                              {0.3f * size, 0.3f * size},
                                              {0, size},
                                              {-0.3f * size, 0.3f * size},
                                              {-size, 0},
                                              {0, -size}}},
                         surface);
        }
        bodies.push_back(body);
    }
};

/// Where a body was beside the blade, and for how many steps it has stayed there.
struct Stuck {
    Vec2 place;
    float angle = 0;
    int steps = 0;

    /// True while the body turns with the blade, though nothing pulls it to the axis.
    void look(const Body& body, const Mill& mill) {
        const float turn = mill.blade.angle();
        const Vec2 at = Vec2(body.world_center());
        const Vec2 now = {std::cos(turn) * at.x + std::sin(turn) * at.y,
                          std::cos(turn) * at.y - std::sin(turn) * at.x};
        const float relative = body.angle() - turn;
        const bool stays = (now - place).length() < 1e-3f && std::fabs(relative - angle) < 1e-2f &&
                           mill.speed * mill.speed * at.length() > 50.0f;
        steps = stays ? steps + 1 : 0;
        place = now;
        angle = relative;
    }
};

}  // namespace

TEST_CASE("a body that a fast blade hits flies away and does not stick to the blade") {
    const unsigned seeds = seeds_or(50);
    for (unsigned kind = 0; kind < 6; ++kind) {
        int longest = 0;
        float fastest = 0;  // times as fast as the end of the blade and a fall
        for (unsigned seed = 1; seed <= seeds; ++seed) {
            Mill mill(kind, seed);
            const float most = std::fabs(mill.speed) * mill.length + 25.0f;
            std::vector<Stuck> stuck(mill.bodies.size());
            for (int step = 0; step < 300; ++step) {
                mill.world.step(frame);
                for (std::size_t i = 0; i < stuck.size(); ++i) {
                    stuck[i].look(mill.bodies[i], mill);
                    longest = std::max(longest, stuck[i].steps);
                    fastest = std::max(fastest, mill.bodies[i].velocity().length() / most);
                }
            }
        }
        INFO("kind " << kind << ": stuck for at most " << longest << " steps, at most " << fastest
                     << " times as fast as a blade and a fall can make it");
        CHECK(longest < 5);
        CHECK(fastest < 1.5f);
    }
}

TEST_CASE("a flipper shoots a body that lies on it") {
    const unsigned seeds = seeds_or(100);
    for (int kind = 0; kind < 3; ++kind) {
        unsigned through = 0;
        float slowest = 100;  // of the speed that the place of the body has on the flipper
        for (unsigned seed = 1; seed <= seeds; ++seed) {
            Random random{std::mt19937(seed)};
            World world;
            Body flipper = world.create_body({.type = BodyType::kinematic_body});
            const float length = random(0.8f, 2), thickness = random(0.1f, 0.25f);
            flipper.add(Box{.width = length, .height = thickness, .center = {0.5f * length, 0}},
                        {.friction = 0.3f});
            const float arm = random(0.4f, 0.95f) * length, size = random(0.05f, 0.2f);
            Body ball = world.create_body({.position = {arm, 0.5f * thickness + size + 0.005f}});
            if (kind == 0) ball.add(Circle{size});
            if (kind == 1) ball.add(Box{.width = 2 * size, .height = 2 * size});
            if (kind == 2) ball.add(Box{.width = 4 * size, .height = size});
            for (int step = 0; step < 30; ++step) world.step(frame);
            const float speed = random(8, 30);
            flipper.set_angular_velocity(speed);
            while (flipper.angle() < 1) world.step(frame);
            flipper.set_angular_velocity(0);
            for (int step = 0; step < 6; ++step) world.step(frame);
            const Vec2 at = flipper.local_point(ball.position());
            if (at.y < 0 && at.length() < length) ++through;
            slowest = std::min(slowest, ball.velocity().length() / (speed * arm));
        }
        INFO("kind " << kind << ": " << through << " through the flipper, the slowest with "
                     << slowest << " of the speed of the flipper");
        CHECK(through == 0);
        CHECK(slowest > 0.8f);
    }
}

TEST_CASE("a drum that turns fast keeps the bodies in it") {
    const unsigned seeds = seeds_or(20);
    for (int kind = 0; kind < 3; ++kind) {
        unsigned out = 0;
        float fastest = 0;  // times as fast as the drum and a fall
        for (unsigned seed = 1; seed <= seeds; ++seed) {
            Random random{std::mt19937(seed)};
            World world;
            const float radius = random(2, 4), speed = random(3, 25), wall = 0.3f;
            Body drum =
                world.create_body({.type = BodyType::kinematic_body, .angular_velocity = speed});
            constexpr int walls = 24;
            for (int i = 0; i < walls; ++i) {
                const float angle = 6.2831853f * float(i) / walls;
                const Vec2 out_there = {std::cos(angle), std::sin(angle)};
                drum.add(Box{.width = wall,
                             .height = 2.1f * radius * std::tan(3.1415927f / walls),
                             .center = (radius + 0.5f * wall) * out_there,
                             .angle = angle});
                if (i % 6 != 0) continue;
                drum.add(Box{.width = 0.5f,
                             .height = 0.1f,
                             .center = (radius - 0.25f) * out_there,
                             .angle = angle});
            }
            std::vector<Body> bodies;
            for (int i = 0; i < 30; ++i) {
                bodies.push_back(world.create_body(
                    {.position = {radius * random(-0.5f, 0.5f), radius * random(-0.5f, 0.5f)}}));
                const float size = random(0.08f, 0.2f);
                if (kind == 0) bodies.back().add(Circle{size});
                if (kind == 1) bodies.back().add(Box{.width = 2 * size, .height = 2 * size});
                if (kind == 2) bodies.back().add(Box{.width = 4 * size, .height = size});
            }
            for (int step = 0; step < 300; ++step) {
                world.step(frame);
                for (const Body& body : bodies)
                    fastest = std::max(fastest, body.velocity().length() / (speed * radius + 8));
            }
            for (const Body& body : bodies)
                if (Vec2(body.position()).length() > radius + wall) ++out;
        }
        INFO("kind " << kind << ": " << out << " of " << 30 * seeds << " out of the drum, at most "
                     << fastest << " times as fast as the drum and a fall can make them");
        CHECK(out <= seeds / 4);
        CHECK(fastest < 2);
    }
}

}  // namespace blades_family_test
