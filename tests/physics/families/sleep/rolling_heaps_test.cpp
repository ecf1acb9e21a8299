// Bodies that roll to and fro without loss do not keep the heap awake in which they lie. A ball
// that rolls or bounces among few others goes on.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>

#include "catch.h"
#include "family.h"

namespace rolling_heaps_test {

using namespace fettle::physics;
using families::Random;

namespace {

constexpr float dt = 1.0f / 60;

/// A body of about `size`; most are round.
void add_any(Random& random, Body body, float size) {
    const ShapeDef def = {.friction = random(0.2f, 0.8f)};
    switch (unsigned(random(0, 5))) {
        case 0:
            body.add(Circle{.radius = 0.5f * size}, def);
            break;
        case 1:
            body.add(Segment{{-0.5f * size, 0}, {0.5f * size, 0}, 0.3f * size}, def);
            break;
        case 2:
            body.add(Box{.width = random(0.5f, 2) * size, .height = random(0.5f, 1.5f) * size},
                     def);
            break;
        default:
            body.add(Ellipse{.radius_x = random(0.4f, 0.8f) * size,
                             .radius_y = random(0.25f, 0.5f) * size},
                     def);
    }
}

/// Seconds until 200 bodies that fall into a funnel sleep; at most `limit`.
float funnel_to_rest(unsigned seed, float limit) {
    Random random{std::mt19937(seed)};
    World world;
    const float slope = random(0.3f, 1.2f), half = random(0.5f, 3), reach = 14;
    Body ground = world.create_body({.type = BodyType::static_body});
    ground.add(Segment{{-half, 0}, {half, 0}, 0.1f});
    for (const float side : {-1.0f, 1.0f}) {
        const Vec2 rim = {side * (half + reach), slope * reach};
        ground.add(Segment{rim, {side * half, 0}, 0.1f});
        ground.add(Segment{rim, {rim.x, 80}, 0.1f});
    }
    for (int i = 0; i < 200; ++i) {
        const float size = random(0.3f, 1);
        const Vec2 place = {1.5f * float(i % 16 - 8) + random(-0.2f, 0.2f),
                            slope * reach + 2 + 1.6f * float(i / 16)};
        add_any(random, world.create_body({.position = {place.x, place.y}, .angle = random(-3, 3)}),
                size);
    }
    for (float time = 0; time < limit; time += dt) {
        world.step(dt);
        if (world.statistics().awake_bodies == 0) return time;
    }
    return limit;
}

/// A heavy tray on the ground with a bowl in its middle, and boxes that rest on its sides.
struct Tray {
    World world;
    Body ball;

    Tray(int boxes, bool sleeping) : world({.sleeping = sleeping}) {
        Body ground = world.create_body({.type = BodyType::static_body});
        ground.add(Box{.width = 40, .height = 2, .center = {0, -1}});
        Body tray = world.create_body({.position = {0, 0.25f}});
        const ShapeDef heavy = {.density = 100, .friction = 1};
        tray.add(Box{.width = 16, .height = 0.5f}, heavy);
        // Flat pieces of an arc with a radius of 2 m.
        constexpr int pieces = 24;
        const auto rim = [](int i) {
            const float angle = 0.6f * (2.0f * float(i) / pieces - 1);
            return Vec2{2 * std::sin(angle), 2.3f - 2 * std::cos(angle)};
        };
        for (int i = 0; i < pieces; ++i)
            tray.add(Segment{rim(i), rim(i + 1), 0.02f}, {.friction = 1});
        for (int i = 0; i < boxes; ++i)
            world
                .create_body(
                    {.position = {float(i % 2 != 0 ? 2 : -2) * (1 + 0.25f * float(i / 2)), 0.6f}})
                .add(Box{.width = 0.2f, .height = 0.2f});
        ball = world.create_body({.position = {0, 0}});
    }
    /// The greatest value of `of()` in these seconds.
    template <class Quantity>
    float most(float seconds, Quantity&& of) {
        float most = 0;
        for (float time = 0; time < seconds; time += dt) {
            world.step(dt);
            most = std::max(most, of());
        }
        return most;
    }
};

}  // namespace

TEST_CASE("heaps of bodies that roll without loss come to rest") {
    const unsigned seeds = families::seeds_or(16);
    unsigned awake = 0;
    for (unsigned seed = 0; seed < seeds; ++seed) awake += funnel_to_rest(seed, 20) >= 20;
    INFO(awake << " of " << seeds << " are awake");
    CHECK(awake <= (seeds + 4) / 5);  // rounded up: few seeds may have one, too
}

TEST_CASE("a ball rolls on in a bowl among few bodies at rest") {
    for (const int boxes : {0, 4}) {
        CAPTURE(boxes);
        float far[2] = {};
        for (const bool sleeping : {false, true}) {
            Tray tray(boxes, sleeping);
            tray.ball.set_position({0.15f, 0.45f});
            tray.ball.add(Circle{.radius = 0.1f}, {.friction = 1});
            tray.most(25, [] { return 0.0f; });
            far[sleeping ? 1 : 0] =
                tray.most(5, [&] { return std::fabs(float(tray.ball.position().x)); });
        }
        CHECK(far[1] > 0.9f * far[0]);
    }
}

TEST_CASE("a ball bounces on, low, among many bodies at rest") {
    float high[2] = {};
    for (const bool sleeping : {false, true}) {
        Tray tray(12, sleeping);
        tray.ball.set_position({6, 0.85f});
        tray.ball.add(Circle{.radius = 0.1f}, {.restitution = 1});
        tray.most(5, [] { return 0.0f; });
        high[sleeping ? 1 : 0] = tray.most(2, [&] { return float(tray.ball.position().y) - 0.6f; });
    }
    INFO(high[0] << " m without sleep, " << high[1] << " m with it");
    CHECK(high[0] > 0.1f);
    CHECK(high[1] > 0.9f * high[0]);
}

}  // namespace rolling_heaps_test
