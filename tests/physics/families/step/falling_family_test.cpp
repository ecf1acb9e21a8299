// Long, thin and angular bodies fall fast on every kind of ground. No body passes through the
// ground or stands still in the air. FETTLE_SEEDS=n: n bodies for each pair of shape and ground.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <random>
#include <string>

#include "catch.h"
#include "family.h"

namespace falling_family_test {

using namespace fettle::physics;
using families::Random;

namespace {

struct Size {
    float length, thickness;
};

struct Kind {
    const char* name;
    std::function<void(Body&, Size, Random&)> add;
};

std::vector<Vec2> ring(Size size) {
    std::vector<Vec2> points;
    const float outer = 0.5f * size.length,
                inner = outer - std::min(size.thickness, size.length / 3);
    for (int i = 0; i <= 24; ++i)
        points.emplace_back(outer * std::cos(0.25f * float(i)), outer * std::sin(0.25f * float(i)));
    for (int i = 24; i >= 0; --i)
        points.emplace_back(inner * std::cos(0.25f * float(i)), inner * std::sin(0.25f * float(i)));
    return points;
}

std::vector<Vec2> star(Size size, int tips) {
    std::vector<Vec2> points;
    for (int i = 0; i < 2 * tips; ++i) {
        const float angle = 3.14159265f * float(i) / float(tips);
        const float radius = 0.5f * (i % 2 ? size.thickness : size.length) + 0.05f;
        points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    return points;
}

const std::vector<Kind>& kinds() {
    static const std::vector<Kind> all = {
        {"plank",
         [](Body& b, Size s, Random&) { b.add(Box{.width = s.length, .height = s.thickness}); }},
        {"capsule",
         [](Body& b, Size s, Random&) {
             b.add(Segment{{-0.5f * s.length, 0}, {0.5f * s.length, 0}, 0.5f * s.thickness});
         }},
        {"ellipse",
         [](Body& b, Size s, Random&) {
             b.add(Ellipse{.radius_x = 0.5f * s.length, .radius_y = 0.5f * s.thickness});
         }},
        {"triangle",
         [](Body& b, Size s, Random& random) {
             const float x = 0.5f * s.length, y = 0.5f * s.thickness;
             b.add(Polygon{{{-x, -y}, {x, -y}, {random(-x, x), y}}});
         }},
        {"angle",
         [](Body& b, Size s, Random&) {
             const float at = 0.5f * s.length;
             b.add(Box{.width = s.length, .height = s.thickness});
             b.add(Box{.width = s.thickness, .height = s.length, .center = {at, at}});
         }},
        {"star",
         [](Body& b, Size s, Random& random) { b.add(Concave{star(s, int(random(5, 9)))}); }},
        {"ring", [](Body& b, Size s, Random&) { b.add(Concave{ring(s)}); }}};
    return all;
}

const char* const grounds[] = {
    "a chain of long segments",  "a thick box",      "a thin box", "bounds", "tiles",
    "a chain of short segments", "capsules in a row"};

void add_ground(World& world, int which) {
    Body ground = world.create_body({.type = BodyType::static_body});
    switch (which) {
        case 0:
            ground.add(Chain{{{-600, 0}, {-20, 0}, {0, 0}, {20, 0}, {600, 0}}});
            break;
        case 1:
        case 2: {
            const float height = which == 1 ? 1.0f : 0.05f;
            ground.add(Box{.width = 1200, .height = height, .center = {0, -0.5f * height}});
            break;
        }
        case 3:
            world.set_bounds(Aabb{{-600, 0}, {600, 600}});
            break;
        case 4:
            for (int i = -300; i < 300; ++i)
                ground.add(Box{.width = 1, .height = 1, .center = {float(i) + 0.5f, -0.5f}});
            break;
        case 5: {
            Chain chain;
            for (int i = -1200; i <= 1200; ++i) chain.points.emplace_back(0.25f * float(i), 0.0f);
            ground.add(chain);
            break;
        }
        default:
            for (int i = -300; i < 300; ++i)
                ground.add(Segment{{float(i), -0.05f}, {float(i) + 1, -0.05f}, 0.05f});
    }
}

struct Outcome {
    bool through = false, frozen = false;
};

Outcome fall(const Kind& kind, int ground, unsigned seed) {
    Random random{std::mt19937(seed)};
    World world;
    add_ground(world, ground);
    const float length = random(0.5f, 2.5f);
    const Size size = {length, std::max(length * std::exp(-random(0, std::log(50.0f))), 0.02f)};
    const float spin = seed % 2 ? random(-50, 50) : 0.0f;
    const float down = seed % 3 ? 0.0f : random(-30, 0);
    Body body = world.create_body({.position = {random(-2, 2), random(3, 23)},
                                   .angle = random(0, 6.28f),
                                   .velocity = {random(-10, 10), down},
                                   .angular_velocity = spin});
    kind.add(body, size, random);
    int still = 0, longest = 0;
    Position place = body.position();
    float angle = body.angle();
    for (int i = 0; i < 300; ++i) {
        world.step(1.0f / 60);
        const bool same = body.position() == place && body.angle() == angle;
        still = same && body.velocity().length() > 1 ? still + 1 : 0;
        longest = std::max(longest, still);
        place = body.position();
        angle = body.angle();
    }
    return {!(place.y > -0.3f), longest >= 3};
}

}  // namespace

TEST_CASE("fast bodies of any shape neither pass through a ground nor stand still above it") {
    const unsigned seeds = families::seeds_or(50);
    for (const Kind& kind : kinds())
        for (int ground = 0; ground < int(std::size(grounds)); ++ground) {
            unsigned through = 0, frozen = 0, example = 0;
            for (unsigned seed = 0; seed < seeds; ++seed) {
                const Outcome outcome = fall(kind, ground, 1000 * unsigned(ground) + seed);
                through += outcome.through;
                frozen += outcome.frozen;
                if (outcome.through || outcome.frozen) example = seed;
            }
            INFO(kind.name << " on " << grounds[ground] << ", for example " << example);
            CHECK(through == 0);
            CHECK(frozen == 0);
        }
}

}  // namespace falling_family_test
