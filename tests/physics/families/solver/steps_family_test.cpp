// Stacks that rest while long and short steps take turns. FETTLE_SEEDS=n: n stacks.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "catch.h"
#include "family.h"

namespace steps_family_test {

using namespace fettle::physics;

TEST_CASE("a stack rests while long and short steps take turns") {
    const int seeds = int(families::seeds_or(50));
    float fastest = 0.0f;
    int awake = 0;
    for (int seed = 0; seed < seeds; ++seed) {
        families::Random random{std::mt19937(unsigned(seed) + 1)};
        World world;
        world.create_body({.type = BodyType::static_body})
            .add(Box{.width = 40, .height = 1, .center = {0, -0.5f}});
        const int count = 2 + int(random.engine() % 5);
        const float size = random(0.4f, 1.5f);
        std::vector<Body> boxes;
        for (int i = 0; i < count; ++i) {
            boxes.push_back(
                world.create_body({.position = {random(-0.02f, 0.02f), (float(i) + 0.5f) * size}}));
            boxes.back().add(Box{.width = size, .height = size});
        }
        const float lengths[] = {1.0f / random(60, 144), 1.0f / random(20, 60)};
        float last_second = 0.0f;
        for (int step = 0; step < 400; ++step) {
            world.step(lengths[step % 2]);
            if (step < 350) continue;
            for (const Body& box : boxes)
                last_second = std::max(last_second, box.velocity().length());
        }
        fastest = std::max(fastest, last_second);
        awake += boxes.back().awake();
        CAPTURE(seed, count, size, lengths[0], lengths[1]);
        CHECK(last_second < 0.05f);
    }
    std::printf("steps of two lengths: at most %.4f m/s, %d of %d stacks awake\n", double(fastest),
                awake, seeds);
    CHECK(awake == 0);
}

TEST_CASE("heavy boxes rest on light ones while steps of many lengths take turns") {
    const int seeds = int(families::seeds_or(50));
    int awake = 0;
    for (int seed = 0; seed < seeds; ++seed) {
        families::Random random{std::mt19937(unsigned(seed) + 1)};
        World world;
        world.create_body({.type = BodyType::static_body})
            .add(Box{.width = 40, .height = 1, .center = {0, -0.5f}});
        const int count = 2 + int(random.engine() % 2);
        const float size = random(0.4f, 1.5f);
        std::vector<Body> boxes;
        for (int i = 0; i < count; ++i) {
            boxes.push_back(world.create_body({.position = {0, (float(i) + 0.5f) * size}}));
            boxes.back().add(Box{.width = size, .height = size},
                             {.density = i + 1 < count ? 1.0f : random(1, 8)});
        }
        float lengths[6];
        for (float& length : lengths) length = 1.0f / random(20, 144);
        lengths[random.engine() % 6] = 0.05f;
        for (int step = 0; step < 400; ++step) world.step(lengths[step % 6]);
        awake += boxes.back().awake();
    }
    std::printf("heavy on light with steps of many lengths: %d of %d awake\n", awake, seeds);
    CHECK(awake == 0);
}

namespace {

/// The deepest overlap, m, under a box that lies on a thin plate or ellipse, at this many steps a
/// second, from the second second on.
float overlap_under_load(unsigned seed, float rate) {
    families::Random random{std::mt19937(seed + 1)};
    World world;
    world.create_body({.type = BodyType::static_body})
        .add(Box{.width = 40, .height = 1, .center = {0, -0.5f}});
    const float width = random(0.2f, 0.4f), thickness = random(0.04f, 0.08f);
    Body plate = world.create_body({.position = {0, thickness / 2}});
    if (random(0, 1) < 0.5f)
        plate.add(Box{.width = width, .height = thickness});
    else
        plate.add(Ellipse{.radius_x = width / 2, .radius_y = thickness / 2});
    const float size = random(0.2f, 0.3f);
    Body load = world.create_body({.position = {0, thickness + size / 2}});
    load.add(Box{.width = size, .height = size}, {.density = random(1, 5)});
    float deepest = 0;
    for (int step = 0; step < int(3 * rate); ++step) {
        world.step(1 / rate);
        if (step < int(rate)) continue;
        for (const Contact& contact : world.contacts())
            for (int k = 0; k < contact.point_count; ++k)
                deepest = std::max(deepest, -contact.points[std::size_t(k)].separation);
    }
    return deepest;
}

/// The most by which a rod is too long, m, while a load at the end of a rope of rods and balls
/// swings down; one of the balls is light.
float stretch_of_swinging_rope(Solver solver, unsigned seed, float rate) {
    families::Random random{std::mt19937(seed + 1)};
    World world(WorldDef{.solver = solver});
    const int count = 4 + int(random.engine() % 6),
              light = 1 + int(random.engine() % unsigned(count - 2));
    const float length = random(0.3f, 0.5f), light_density = random(0.2f, 1);
    std::vector<DistanceJoint> rods;
    Body last;
    for (int i = 0; i < count; ++i) {
        Body ball = world.create_body({.position = {length * float(i + 1), 9}});
        ball.add(Circle{.radius = i + 1 < count ? 0.1f : 0.3f},
                 {.density = i == light      ? light_density
                             : i + 1 < count ? 1
                                             : random(1, 5)});
        DistanceJointDef def(JointDef{.body_a = last.id(), .body_b = ball.id()});
        if (i == 0) def.anchor_a = {0, 9};
        def.length = length;
        rods.push_back(world.create_distance_joint(def));
        last = ball;
    }
    float most = 0;
    for (int step = 0; step < int(3 * rate); ++step) {
        world.step(1 / rate);
        for (const DistanceJoint& rod : rods) most = std::max(most, std::fabs(rod.separation()));
    }
    return most;
}

}  // namespace

TEST_CASE("rods with a light ball between them hold a swinging load in long steps") {
    const unsigned seeds = families::seeds_or(50);
    for (const Solver solver : {Solver::soft_step, Solver::direct}) {
        float most = 0;
        for (unsigned seed = 0; seed < seeds; ++seed)
            for (const float rate : {20.0f, 24.0f, 30.0f, 60.0f}) {
                const float stretch = stretch_of_swinging_rope(solver, seed, rate);
                most = std::max(most, stretch);
                CAPTURE(int(solver), seed, rate);
                CHECK(stretch < 0.1f);
            }
        std::printf("rods in long steps, solver %d: at most %.3f m too long\n", int(solver),
                    double(most));
    }
}

TEST_CASE("a load sinks in no further in long steps than in short ones") {
    const unsigned seeds = families::seeds_or(50);
    float most = 0;
    for (unsigned seed = 0; seed < seeds; ++seed) {
        const float usual = overlap_under_load(seed, 60);
        for (const float rate : {20.0f, 24.0f, 30.0f, 40.0f, 50.0f}) {
            const float overlap = overlap_under_load(seed, rate);
            most = std::max(most, overlap / usual);
            CAPTURE(seed, rate, overlap, usual);
            CHECK(overlap < 1.4f * usual);
        }
    }
    std::printf("overlaps in long steps: at most %.2f times those at 60 steps a second\n",
                double(most));
}

}  // namespace steps_family_test
