// Stacks that rest while long and short steps take turns. FETTLE_SEEDS=n: n stacks.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cstdio>

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

}  // namespace steps_family_test
