// Light bodies under heavy piles, on ground that is fixed: they are not pressed into it, nor
// through it. FETTLE_SEEDS=n: n worlds.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "catch.h"
#include "family.h"

namespace sunk_bodies_test {

using namespace fettle::physics;

enum class Ground { box, segment, chain, discs, wedges, border };

constexpr const char* names[] = {"a box", "a segment", "a chain", "discs", "wedges", "the border"};

/// A floor from -6 to 6 with its surface at 0 and below, and the height of its lowest point.
float make_ground(World& world, Ground kind, families::Random& random) {
    if (kind == Ground::border) return 0;
    Body ground = world.create_body({.type = BodyType::static_body});
    const float belt = random(-4, 4);
    switch (kind) {
        case Ground::box:
            ground.add(Box{.width = 12, .height = 1, .center = {0, -0.5f}});
            return 0;
        case Ground::segment:
            ground.add(Segment{.from = {-6, 0}, .to = {6, 0}});
            return 0;
        case Ground::chain:
            ground.add(Chain{.points = {{-6, 0}, {-2, 0}, {3, 0}, {6, 0}}});
            return 0;
        case Ground::discs:
            for (int i = -4; i <= 4; ++i)
                ground.add(Circle{.radius = 1, .center = {1.5f * float(i), -1}},
                           {.surface_speed = belt});
            return -0.34f;  // where two discs cross
        default:
            for (int i = -3; i <= 3; ++i)
                ground.add(Polygon{.vertices = {{2.0f * float(i) - 1, -0.6f},
                                                {2.0f * float(i) + 1, -0.6f},
                                                {2.0f * float(i), 0}}});
            return -0.6f;
    }
}

/// Piles boxes of random density on light ones, and returns how deep a light one's center got
/// into the ground, in its half heights.
float greatest_depth(Ground kind, unsigned seed) {
    families::Random random{std::mt19937(seed)};
    const float low = kind == Ground::border ? 0.0f : -50.0f;
    World world(WorldDef{
        .substeps = int(random(2, 5)), .bounds = Aabb{{-6, low}, {6, 60}}, .sleeping = false});
    const float bottom = make_ground(world, kind, random);
    const float half = random(0.1f, 0.3f);
    std::vector<Body> light;
    const int columns = int(4 / half), rows = int(random(6, 14));
    for (int row = 0; row < rows; ++row) {
        for (int i = 0; i < columns; ++i) {
            const float x = (2.05f * float(i) - float(columns)) * half;
            Body box = world.create_body({.position = {x, (1.2f + 2.05f * float(row)) * half}});
            const bool is_light = row == 0;
            box.add(Box{.width = 2 * half, .height = 2 * half},
                    {.density = is_light ? 0.2f : random(0.5f, 8), .friction = random(0, 1)});
            if (is_light) light.push_back(box);
        }
    }
    float deepest = 0;
    for (int step = 0; step < 180; ++step) {
        world.step(1.0f / 60);
        for (const Body& body : light)
            deepest = std::max(deepest, float(bottom - body.position().y) / half);
    }
    return deepest;
}

TEST_CASE("light boxes under a heavy pile are not pressed into what is fixed") {
    const unsigned seeds = families::seeds_or(16);
    for (const Ground kind : {Ground::box, Ground::segment, Ground::chain, Ground::discs,
                              Ground::wedges, Ground::border}) {
        float deepest = 0;
        unsigned pressed = 0;
        for (unsigned seed = 1; seed <= seeds; ++seed) {
            const float depth = greatest_depth(kind, seed);
            deepest = std::max(deepest, depth);
            pressed += depth > 0 ? 1 : 0;
        }
        std::printf("light boxes on %s: %u of %u in it by half, deepest %.2f half heights below\n",
                    names[int(kind)], pressed, seeds, double(deepest));
        CHECK(pressed == 0);
    }
}

}  // namespace sunk_bodies_test
