// Thin planks that fall on the bounds of a world. FETTLE_SEEDS=n: n planks.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cstdio>

#include "catch.h"
#include "family.h"

namespace planks_on_bounds_test {

using namespace fettle::physics;

TEST_CASE("thin planks lie flat on the bounds and sleep") {
    const int seeds = int(families::seeds_or(100));
    int awake = 0;
    float deepest = 0.0f;
    for (int seed = 0; seed < seeds; ++seed) {
        families::Random random{std::mt19937(unsigned(seed) + 1)};
        World world(WorldDef{.bounds = Aabb{{-20, 0}, {20, 30}}});
        const float width = random(0.2f, 2), height = random(0.005f, 0.05f);
        Body plank =
            world.create_body({.position = {0, random(0.5f, 3)}, .angle = random(-1.5f, 1.5f)});
        plank.add(Box{.width = width,
                      .height = height,
                      .rounding = seed % 2 == 0 ? 0.0f : random(0, 0.5f) * height});
        const float lengths[] = {1.0f / 60, 1.0f / 50, 1.0f / 30};
        const float length = lengths[random.engine() % 3];
        for (float time = 0; time < 6.0f; time += length) world.step(length);
        const float depth = 0.5f * height - plank.position().y;
        deepest = std::max(deepest, depth);
        awake += plank.awake();
        CAPTURE(seed, width, height, depth, plank.angle());
        CHECK(depth < 0.01f);
    }
    std::printf("planks on bounds: %d of %d awake, at most %.4f m deep\n", awake, seeds,
                double(deepest));
    CHECK(awake == 0);
}

}  // namespace planks_on_bounds_test
