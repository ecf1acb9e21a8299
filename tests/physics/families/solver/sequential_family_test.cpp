// Heaps under the solver `sequential`, which tremble, but stay on the ground. FETTLE_SEEDS=n: n
// heaps.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cstdio>
#include <vector>

#include "catch.h"
#include "family.h"

namespace sequential_family_test {

using namespace fettle::physics;

TEST_CASE("heaps stay on the ground under the sequential solver") {
    const int seeds = int(families::seeds_or(100));
    float lowest = 1.0f;
    for (int seed = 0; seed < seeds; ++seed) {
        families::Random random{std::mt19937(unsigned(seed) + 1)};
        World world(WorldDef{.solver = Solver::sequential});
        world.create_body({.type = BodyType::static_body})
            .add(Chain{.points = {{-20, 0}, {-10, 0}, {0, 0}, {10, 0}, {20, 0}}});
        std::vector<Body> boxes;
        const int count = 4 + int(random.engine() % 5);
        for (int i = 0; i < count; ++i) {
            const float height = random(0.1f, 0.5f);
            boxes.push_back(
                world.create_body({.position = {random(-0.2f, 0.2f), 0.6f * (float(i) + 0.5f)}}));
            boxes.back().add(Box{.width = random(0.2f, 1), .height = height});
        }
        for (int step = 0; step < 180; ++step) {
            world.step(1.0f / 60);
            for (const Body& box : boxes) lowest = std::min<float>(lowest, box.position().y);
        }
    }
    std::printf("heaps under the sequential solver: lowest center at %.3f m\n", double(lowest));
    CHECK(lowest > 0.0f);
}

// Each load presses the plank in by half of its overlap. That may be faster than bodies are pushed
// apart.
TEST_CASE("no load presses a light plank through the ground under the sequential solver") {
    const int seeds = int(families::seeds_or(100));
    float lowest = 1.0f;
    for (int seed = 0; seed < seeds; ++seed) {
        families::Random random{std::mt19937(unsigned(seed) + 1)};
        World world(WorldDef{.solver = Solver::sequential});
        Body ground = world.create_body({.type = BodyType::static_body});
        if (random.engine() % 2 == 0)
            ground.add(Chain{.points = {{-20, 0}, {-10, 0}, {0, 0}, {10, 0}, {20, 0}}});
        else
            ground.add(Segment{.from = {-20, -0.05f}, .to = {20, -0.05f}, .rounding = 0.05f});
        std::vector<Body> bodies;
        float top = random(0, 1);
        const auto pile_up = [&](float x, float width, float height, float density) {
            bodies.push_back(world.create_body({.position = {x, top + height / 2}}));
            bodies.back().add(Box{.width = width, .height = height}, {.density = density});
            top += height;
        };
        const float thickness = random(0.1f, 0.3f), length = random(1, 3);
        pile_up(0, length, thickness, 0.2f);
        const int loads = 2 + int(random.engine() % 5);
        for (int i = 0; i < loads; ++i) {
            const float x = random(-length / 2, length / 2);
            const float width = random(0.2f, 2), height = random(0.2f, 1.2f);
            pile_up(x, width, height, random(1, 5));
        }
        const float dt = 1 / random(30, 120);
        for (float time = 0; time < 3; time += dt) {
            world.step(dt);
            for (const Body& body : bodies) lowest = std::min<float>(lowest, body.world_center().y);
        }
    }
    std::printf("planks under loads, sequential solver: lowest center at %.3f m\n", double(lowest));
    CHECK(lowest > 0.0f);
}

}  // namespace sequential_family_test
