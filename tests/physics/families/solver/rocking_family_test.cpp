// Bodies that rock on round supports: they neither gain energy nor lose much of it.
// FETTLE_SEEDS=n: n worlds of each family.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "catch.h"
#include "family.h"

namespace rocking_family_test {

using namespace fettle::physics;
using families::Random;
using families::seeds_or;

namespace {

/// A plank or a capsule that rocks on a fixed log of two to ten times its thickness.
struct Plank {
    World world;
    Body body;

    explicit Plank(unsigned seed) {
        Random random{std::mt19937(seed)};
        const float length = random(1, 5), thickness = random(0.05f, 0.2f);
        const float log = thickness * random(2, 10);
        const ShapeDef grips = {.friction = 1};
        Body ground = world.create_body({.type = BodyType::static_body});
        ground.add(Circle{log}, grips);
        body = world.create_body({.position = {0, log + 0.5f * thickness}});
        const unsigned kind = seed % 3;
        if (kind == 0) body.add(Box{.width = length, .height = thickness}, grips);
        if (kind == 1)
            body.add(Segment{{-0.5f * length, 0}, {0.5f * length, 0}, 0.5f * thickness}, grips);
        if (kind == 2)
            body.add(Box{.width = length, .height = thickness, .rounding = 0.2f * thickness},
                     grips);
        for (int i = 0; i < 30; ++i) world.step(1.0f / 60);
        const float rate = std::sqrt(12 * 9.81f * (log - 0.5f * thickness)) / length;  // rad/s
        body.set_angular_velocity(random(0.06f, 0.2f) * rate);
    }
    /// The greatest angle in these seconds, rad.
    float swing(float seconds) {
        float most = 0;
        for (float time = 0; time < seconds; time += 1.0f / 60) {
            world.step(1.0f / 60);
            most = std::max(most, std::fabs(body.angle()));
        }
        return most;
    }
};

}  // namespace

TEST_CASE("a plank that rocks on a log gains no energy and keeps most of it") {
    const unsigned seeds = seeds_or(50);
    float sum = 0, most = 1;
    for (unsigned seed = 1; seed <= seeds; ++seed) {
        Plank plank(seed);
        const float first = plank.swing(5);
        plank.swing(25);
        const float part = plank.swing(5) / first;
        sum += part;
        most = std::max(most, part);
    }
    const float mean = sum / float(seeds);
    INFO("after half a minute, the swings have " << mean << " of their angle as a mean, at most "
                                                 << most);
    CHECK(most < 1.02f);
    CHECK(mean > 0.9f);
}

TEST_CASE("a plank on a log has the same future in a copy and when restored") {
    for (unsigned seed = 1; seed <= 6; ++seed) {
        Plank plank(seed);
        plank.swing(1);
        World copy = plank.world.clone(), restored;
        std::vector<std::byte> saved;
        plank.world.save(saved);
        restored.restore(saved);
        for (int i = 0; i < 200; ++i)
            for (World* world : {&plank.world, &copy, &restored}) world->step(1.0f / 60);
        CHECK(copy.hash() == plank.world.hash());
        CHECK(restored.hash() == plank.world.hash());
    }
}

}  // namespace rocking_family_test
