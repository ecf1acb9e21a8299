// Two bullets that hit the same free box, in one step or one after the other. FETTLE_SEEDS=n: n
// pairs.

#include <fettle/physics/physics.h>

#include <array>
#include <cmath>
#include <cstdio>

#include "catch.h"
#include "family.h"

namespace two_bullets_test {

using namespace fettle::physics;

Geometry bullet_shape(families::Random& random) {
    const float length = random(0.1f, 0.3f), width = random(0.02f, 0.2f);
    if (random(0, 1) < 0.5f) return Box{.width = length, .height = width};
    return Ellipse{.radius_x = 0.5f * length, .radius_y = 0.5f * width};
}

/// In coordinates of the box.
Vec2 seen_from(const Body& box, const Position& place) {
    const Vec2 d = place - box.position();
    const float c = std::cos(box.angle()), s = std::sin(box.angle());
    return {c * d.x + s * d.y, c * d.y - s * d.x};
}

TEST_CASE("two bullets do not pass through the box that both hit") {
    const int seeds = int(families::seeds_or(100));
    int through = 0, frozen = 0;
    for (int seed = 0; seed < seeds; ++seed) {
        families::Random random{std::mt19937(unsigned(seed) + 1)};
        World world;
        Body box = world.create_body({.position = {0, 2}});
        box.add(Box{.width = random(0.1f, 0.5f), .height = 3}, {.friction = random(0, 1)});
        std::array<Body, 2> bullets;
        for (int i = 0; i < 2; ++i) {
            bullets[size_t(i)] = world.create_body({.position = {-4, random(1, 1.8f) + float(i)},
                                                    .velocity = {random(20, 200), random(-2, 2)},
                                                    .angular_velocity = random(-20, 20),
                                                    .bullet = true});
            bullets[size_t(i)].add(bullet_shape(random));
        }
        const float lengths[] = {1.0f / 60, 1.0f / random(20, 60), 1.0f / 30};
        int stood = 0;
        std::array<Vec2, 2> before;
        for (size_t i = 0; i < 2; ++i) before[i] = seen_from(box, bullets[i].position());
        for (int step = 0; step < 30; ++step) {
            const Position place = box.position();
            world.step(lengths[step % 3]);
            const bool stands = (box.position() - place).length() < 1e-5f;
            stood = stands && box.velocity().length() > 1 ? stood + 1 : 0;
            frozen += stood == 3;
            for (size_t i = 0; i < 2; ++i) {
                const Vec2 now = seen_from(box, bullets[i].position());
                const bool on_it = std::fabs(before[i].y) < 1.4f && std::fabs(now.y) < 1.4f;
                if (on_it && before[i].x < 0 && now.x > 0) ++through;
                before[i] = now;
            }
        }
    }
    std::printf("two bullets: %d of %d through the box, %d boxes frozen\n", through, 2 * seeds,
                frozen);
    CHECK(through == 0);
    CHECK(frozen == 0);
}

}  // namespace two_bullets_test
