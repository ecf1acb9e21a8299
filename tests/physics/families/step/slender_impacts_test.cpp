// Slender bodies that hit a wall fast. A step is long compared with their rotation: the tip that
// touches moves away within it, and the contact cannot stop the center. FETTLE_SEEDS=n: n bodies.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cstdio>

#include "catch.h"
#include "family.h"

namespace slender_impacts_test {

using namespace fettle::physics;

Geometry slender_shape(families::Random& random, int kind) {
    const float length = random(0.1f, 0.6f), width = random(0.01f, 0.05f) * length;
    if (kind == 0) return Ellipse{.radius_x = 0.5f * length, .radius_y = 0.5f * width};
    if (kind == 1) return Box{.width = length, .height = width};
    return Segment{.from = {-0.5f * length, 0}, .to = {0.5f * length, 0}, .rounding = 0.5f * width};
}

TEST_CASE("slender bodies that hit a wall fast come back from it") {
    const int seeds = int(families::seeds_or(150));
    int beyond = 0, frozen = 0;
    for (int seed = 0; seed < seeds; ++seed) {
        families::Random random{std::mt19937(unsigned(seed) + 1)};
        World world(WorldDef{});
        Body room = world.create_body({.type = BodyType::static_body});
        if (seed % 2 == 0)
            room.add(Chain{.points = {{-20, 0}, {20, 0}, {20, 30}, {-20, 30}}, .closed = true});
        else
            room.add(Box{.width = 0.2f, .height = 60, .center = {20.1f, 0}});
        Body body = world.create_body({.position = {random(10, 15), random(5, 20)},
                                       .angle = random(-3, 3),
                                       .velocity = {random(60, 150), random(-20, 20)},
                                       .angular_velocity = random(-30, 30)});
        body.add(slender_shape(random, seed % 3));
        int steps_in_place = 0, longest_in_place = 0;
        for (int step = 0; step < 60; ++step) {
            const Position before = body.position();
            world.step(1.0f / 60);
            const bool in_place =
                (body.position() - before).length() < 1e-5f && body.velocity().length() > 1.0f;
            steps_in_place = in_place ? steps_in_place + 1 : 0;
            longest_in_place = std::max(longest_in_place, steps_in_place);
        }
        CAPTURE(seed, body.position().x, body.velocity().x, longest_in_place);
        beyond += body.position().x > 20.0f;
        frozen += longest_in_place > 2;
    }
    std::printf("slender bodies: %d of %d beyond the wall, %d frozen at it\n", beyond, seeds,
                frozen);
    CHECK(beyond == 0);
    CHECK(frozen == 0);
}

}  // namespace slender_impacts_test
