// Balls that bounce well roll over the seams of a floor of boxes as over one box.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>

#include "catch.h"
#include "family.h"

namespace elastic_balls_on_tiles_test {

using namespace fettle::physics;
using families::Random;
using families::seeds_or;

namespace {

/// A level floor of boxes, side by side, from -10 m to `length`.
void add_tiles(World& world, float length, float width, float friction) {
    Body floor = world.create_body({.type = BodyType::static_body});
    for (float x = -10; x < length; x += width)
        floor.add(Box{.width = width, .height = 1, .center = {x, -0.5f}}, {.friction = friction});
}

}  // namespace

TEST_CASE("an elastic ball rolls over the seams of tiles") {
    for (unsigned seed = 0; seed < seeds_or(60); ++seed) {
        Random random{std::mt19937(seed)};
        const float rates[] = {30, 60, 144}, rate = rates[seed % 3];
        const float speed = random(2, 50), radius = random(0.2f, 0.6f);
        World world;
        add_tiles(world, speed * 4 + 20, random(0.5f, 3), 0.5f);
        Body ball = world.create_body(
            {.position = {0, radius}, .velocity = {speed, 0}, .angular_velocity = -speed / radius});
        ball.add(Circle{radius}, {.friction = 0.5f, .restitution = random(0.3f, 1)});
        float hop = 0;
        for (int i = 0; i < int(4 * rate); ++i) {
            world.step(1 / rate);
            hop = std::max(hop, float(ball.position().y) - radius);
        }
        INFO("seed " << seed);
        CHECK(hop < 0.01f);
        CHECK(ball.velocity().x > 0.95f * speed);
    }
}

}  // namespace elastic_balls_on_tiles_test
