// Heavy bodies that stand on light ones, to which joints connect them: tables, robots, wagons.
// FETTLE_SEEDS=n: n worlds of each family.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

#include "catch.h"
#include "family.h"

namespace light_legs_test {

using namespace fettle::physics;
using families::Random;
using families::seeds_or;

namespace {

constexpr float dt = 1.0f / 60;

enum class Legs { welded, with_limits, wheels };

struct Table {
    World world;
    Body top;

    Table(unsigned seed, Legs kind) {
        Random random{std::mt19937(seed)};
        Body ground = world.create_body({.type = BodyType::static_body});
        if (seed % 2 == 0)
            ground.add(Box{.width = 60, .height = 2, .center = {0, -1}});
        else
            ground.add(Chain{{{-30, 0}, {-10, 0}, {0, 0}, {10, 0}, {30, 0}}});
        const float ratio = 8.0f * std::pow(11.0f, random(0, 1));
        const float height = random(0.4f, 1), thickness = random(0.06f, 0.15f);
        const float width = random(1, 2), mass = height * thickness, lean = random(-0.15f, 0.15f);
        top = world.create_body({.position = {0, height + 0.5f}, .angle = lean});
        top.add(Box{.width = width, .height = 0.4f}, {.density = ratio * mass / (0.4f * width)});
        const int count = int(random(2, 4));
        for (int i = 0; i < count; ++i) {
            const float along = (float(i) / float(count - 1) - 0.5f) * 0.9f * width;
            const Vec2 joint = {along, -0.2f};
            const Vec2 center = {along, kind == Legs::wheels ? -0.2f : -0.2f - 0.5f * height};
            Body leg = world.create_body({.position = top.world_point(center), .angle = lean});
            if (kind == Legs::wheels)
                leg.add(Circle{0.2f}, {.density = mass / 0.1257f, .rolling_resistance = 0.02f});
            else if (random(0, 1) < 0.5f)
                leg.add(Box{.width = thickness, .height = height});
            else
                leg.add(Segment{{0, -0.5f * height + 0.5f * thickness},
                                {0, 0.5f * height - 0.5f * thickness},
                                0.5f * thickness});
            const JointDef def = {.body_a = top.id(),
                                  .body_b = leg.id(),
                                  .anchor_a = joint,
                                  .anchor_b = joint - center};
            if (kind == Legs::welded) {
                world.create_weld_joint(def);
                continue;
            }
            RevoluteJointDef hinge = def;
            if (kind == Legs::with_limits) hinge.lower_angle = -0.2f, hinge.upper_angle = 0.2f;
            world.create_revolute_joint(hinge);
        }
    }
    /// The time until all bodies sleep, at most 15 s.
    float time_to_rest() {
        float time = 0.0f;
        while (time < 15.0f && world.statistics().awake_bodies + (time == 0.0f) > 0) {
            world.step(dt);
            time += dt;
        }
        return time;
    }
};

void check_rest(Legs kind, const char* name) {
    unsigned restless = 0;
    float sum = 0.0f;
    const unsigned seeds = seeds_or(50);
    for (unsigned seed = 0; seed < seeds; ++seed) {
        const float time = Table(seed, kind).time_to_rest();
        sum += time;
        restless += time >= 15.0f;
    }
    std::printf("heavy on light %s: %u of %u never rest, the mean rests after %.2f s\n", name,
                restless, seeds, double(sum) / double(seeds));
    CHECK(restless * 50 <= seeds);
}

}  // namespace

TEST_CASE("a heavy table on light legs comes to rest") {
    check_rest(Legs::welded, "welded legs");
}

TEST_CASE("a heavy body on light legs with limits comes to rest") {
    check_rest(Legs::with_limits, "legs with limits");
}

TEST_CASE("a heavy wagon on light wheels comes to rest") {
    check_rest(Legs::wheels, "wheels");
}

TEST_CASE("a heavy table on light legs has the same future on several threads and when restored") {
    for (unsigned seed = 0; seed < 5; ++seed) {
        Table one(seed, Legs::welded), two(seed, Legs::welded);
        two.world.set_threads(2);
        for (int i = 0; i < 90; ++i) {
            if (i == 40) {
                std::vector<std::byte> bytes;
                two.world.save(bytes);
                for (int k = 0; k < 5; ++k) two.world.step(dt);
                two.world.restore(bytes);
            }
            one.world.step(dt);
            two.world.step(dt);
        }
        CHECK(one.world.hash() == two.world.hash());
    }
}

}  // namespace light_legs_test
