// Elastic balls that hit a corner, wherever in a step and however glancing: they keep their speed.
// FETTLE_SEEDS=n: n shots at each kind of corner.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "catch.h"
#include "family.h"

namespace corner_bounces_test {

using namespace fettle::physics;
using families::Random;
using families::seeds_or;
using families::turned;

namespace {

const ShapeDef elastic = {.friction = 0, .restitution = 1};

/// Adds an obstacle with a corner at the origin, between normals along x and y.
void add_corner(World& world, int kind) {
    Body body =
        world.create_body({.type = kind == 3 ? BodyType::dynamic_body : BodyType::static_body});
    if (kind == 1) {
        body.add(Chain{.points = {{-5, 0}, {0, 0}, {0, -5}}}, elastic);
    } else if (kind == 2) {
        body.add(Polygon{.vertices = {{0, 0}, {-4, 0}, {-3, -3}, {0, -4}}}, elastic);
    } else {
        body.add(Box{.width = 4, .height = 4, .center = {-2, -2}}, elastic);
        if (kind == 3) body.set_mass(1e9f), body.set_inertia(1e9f);
    }
}

}  // namespace

TEST_CASE("an elastic ball keeps its speed at a corner") {
    double least = 1, most = 1;
    for (int kind = 0; kind < 4; ++kind) {
        for (unsigned seed = 0; seed < seeds_or(400); ++seed) {
            Random random{std::mt19937(seed)};
            const float rates[] = {30, 60, 144, 240}, rate = rates[seed % 4];
            const float radius = random(0.05f, 0.4f), speed = random(3, 40);
            // The normal at the impact is between those of the faces.
            const Vec2 normal = turned(random(0.02f, 1.55f));
            const float offset = random(-1, 1);
            const Vec2 across = {-normal.y, normal.x};
            const Vec2 way = std::sqrt(1 - offset * offset) * normal + offset * across;
            const float closing = speed * way.dot(normal);
            // The impacts of slower balls have no restitution. A ball must not come from the other
            // side of a face.
            if (closing < 1.5f || way.x < -0.9f || way.y < -0.9f) continue;
            World world({.gravity = {0, 0}});
            add_corner(world, kind);
            const float distance = random(0.1f, 0.1f + speed / rate);
            Body ball = world.create_body({.position = radius * normal + distance * way,
                                           .velocity = -speed * way,
                                           .bullet = seed % 8 >= 4});
            ball.add(Circle{radius}, elastic);
            const int steps = int(distance / speed * rate) + 3;
            for (int i = 0; i < steps; ++i) world.step(1 / rate);
            const float kept = ball.velocity().length() / speed;
            INFO("kind " << kind << ", seed " << seed << ", closing " << closing);
            CHECK(kept == Approx(1).epsilon(0.005));
            least = std::min(least, double(kept));
            most = std::max(most, double(kept));
        }
    }
    std::printf("balls at corners keep %.4f to %.4f of their speed\n", least, most);
}

}  // namespace corner_bounces_test
