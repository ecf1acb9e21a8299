// Slender boxes that lean on a corner: beyond their tipping angle they fall, below it they stand.
// FETTLE_SEEDS=n: n worlds of each family.

#include <fettle/physics/physics.h>

#include <cmath>
#include <random>

#include "catch.h"
#include "family.h"

namespace tipping_family_test {

using namespace fettle::physics;
using families::Random;
using families::seeds_or;

namespace {

/// A box 5 to 50 times as high as wide that leans on its lower right corner.
struct LeaningBox {
    World world;
    Body body;
    float tipping_angle;

    /// `part`: of the tipping angle at which it begins.
    LeaningBox(Random& random, float part) {
        Body ground = world.create_body({.type = BodyType::static_body});
        if (random(0, 1) < 0.5f)
            ground.add(Box{.width = 60, .height = 2, .center = {0, -1}});
        else
            ground.add(Chain{{{-30, 0}, {-10, 0}, {0, 0}, {10, 0}, {30, 0}}});
        const float height = 0.3f * std::pow(15.0f, random(0, 1)), aspect = random(5, 50);
        tipping_angle = std::atan(1 / aspect);
        const float lean = part * tipping_angle, c = std::cos(lean), s = std::sin(lean);
        const Vec2 corner = {0.5f * height / aspect, -0.5f * height};
        body = world.create_body(
            {.position = {-c * corner.x - s * corner.y, s * corner.x - c * corner.y},
             .angle = -lean});
        body.add(Box{.width = height / aspect, .height = height});
    }
    float lean_at_rest() {
        for (int step = 0; step < 1800 && (step == 0 || body.awake()); ++step)
            world.step(1.0f / 60);
        return body.awake() ? NAN : std::fabs(body.angle());
    }
};

}  // namespace

TEST_CASE("a slender box that leans too far falls") {
    const unsigned seeds = seeds_or(200);
    unsigned fallen = 0;
    for (unsigned seed = 1; seed <= seeds; ++seed) {
        Random random{std::mt19937(seed)};
        const float part = random(1.05f, 2.5f);
        fallen += LeaningBox(random, part).lean_at_rest() > 1.2f;
    }
    INFO(fallen << " of " << seeds << " have fallen");
    CHECK(fallen == seeds);
}

TEST_CASE("a slender box that leans less than its tipping angle does not fall") {
    const unsigned seeds = seeds_or(200);
    unsigned standing = 0;
    for (unsigned seed = 1; seed <= seeds; ++seed) {
        Random random{std::mt19937(seed)};
        const float part = random(0.05f, 0.9f);
        LeaningBox box(random, part);
        standing += box.lean_at_rest() < box.tipping_angle;
    }
    INFO(standing << " of " << seeds << " stand");
    CHECK(standing == seeds);
}

}  // namespace tipping_family_test
