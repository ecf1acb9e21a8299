// Two concave shapes, whichever of them comes first. FETTLE_SEEDS=n: 500 n pairs.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

#include "catch.h"
#include "family.h"

namespace concave_pairs_test {

using namespace fettle::physics;
using families::Random;
using families::seeds_or;

namespace {

/// A brick of the shape of an L, a U or a T, of cells of 1 m.
Concave brick(Random& random) {
    const int kind = int(random(0, 3));
    if (kind == 0) return {.vertices = {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {0, 2}}};
    if (kind == 1)
        return {.vertices = {{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}};
    return {.vertices = {{0, 0}, {3, 0}, {3, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 1}, {0, 1}}};
}

float deepest_of(const std::vector<ContactManifold>& manifolds) {
    float deepest = 0.0f;
    for (const auto& manifold : manifolds)
        for (int k = 0; k < manifold.point_count; ++k)
            deepest = std::max(deepest, -manifold.points[size_t(k)].separation);
    return deepest;
}

}  // namespace

TEST_CASE("two concave shapes that overlap by their faces collide in either order") {
    unsigned overlaps = 0, missed = 0;
    const unsigned seeds = 500 * seeds_or(200);
    for (unsigned seed = 0; seed < seeds; ++seed) {
        Random random{std::mt19937(seed)};
        const Concave a = brick(random), b = brick(random);
        const float quarter = 1.5708f * float(int(random(0, 4)));
        const Pose at_a = {{0, 0}, random(-3, 3)};
        const Vec2 away = families::turned(random(-3.1416f, 3.1416f)) * random(1, 3);
        const Pose at_b = {Position(away), at_a.angle + quarter + random(-0.05f, 0.05f)};
        const float one = deepest_of(contact_manifolds(a, at_a, b, at_b));
        const float other = deepest_of(contact_manifolds(b, at_b, a, at_a));
        if (std::max(one, other) < 0.02f || std::max(one, other) > 0.2f) continue;
        ++overlaps;
        missed += std::min(one, other) == 0.0f;
    }
    std::printf("concave pairs: %u of %u overlaps have no contact in one of the orders\n", missed,
                overlaps);
    CHECK(overlaps > seeds / 50);
    CHECK(missed <= overlaps / 1000);
}

}  // namespace concave_pairs_test
