// Thin bodies that a bullet hits: a bat on a pin, which is thicker than they are. FETTLE_SEEDS=n: n
// bodies.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "catch.h"
#include "family.h"

namespace thin_on_bullets_test {

using namespace fettle::physics;

Geometry thin_shape(families::Random& random, int kind) {
    const float length = random(0.3f, 0.6f), width = random(0.02f, 0.04f);
    if (kind == 0) return Ellipse{.radius_x = 0.5f * length, .radius_y = 0.5f * width};
    if (kind == 1) return Box{.width = length, .height = width};
    return Segment{.from = {-0.5f * length, 0}, .to = {0.5f * length, 0}, .rounding = 0.5f * width};
}

/// In coordinates of the bat, which lies along x from its pin.
Vec2 seen_from(const Body& bat, Vec2 pin, const Position& place) {
    const Vec2 d = place - Position(pin);
    const float c = std::cos(bat.angle()), s = std::sin(bat.angle());
    return {c * d.x + s * d.y, c * d.y - s * d.x};
}

TEST_CASE("thin bodies do not pass through a thicker bullet") {
    const int seeds = int(families::seeds_or(150));
    int through = 0;
    for (int seed = 0; seed < seeds; ++seed) {
        families::Random random{std::mt19937(unsigned(seed) + 1)};
        World world(WorldDef{.gravity = {0, 0}});
        const Vec2 pin(0, 2);
        Body bat = world.create_body({.position = {1, 2}, .bullet = true});
        bat.add(Box{.width = 2, .height = random(0.1f, 0.3f)});
        RevoluteJoint joint{&world, world.create_joint(JointType::revolute).id()};
        joint.connect(Body(), bat);
        joint.set_anchor_a(pin);
        joint.set_anchor_b({-1, 0});
        joint.set_motor_speed(random(5, 20));
        joint.set_max_motor_torque(300);
        const float at = random(1, 2.5f), distance = random(0.5f, 1.9f);
        Body thin =
            world.create_body({.position = pin + distance * Vec2(std::cos(at), std::sin(at)),
                               .angle = random(-3, 3)});
        thin.add(thin_shape(random, seed % 3));
        Vec2 before = seen_from(bat, pin, thin.position());
        for (int step = 0; step < 60; ++step) {
            world.step(1.0f / 60);
            const Vec2 now = seen_from(bat, pin, thin.position());
            const bool crossed = before.y > 0 && now.y < 0;
            if (crossed && before.x > 0 && now.x > 0 && before.x < 1.8f && now.x < 1.8f) {
                ++through;
                break;
            }
            before = now;
        }
    }
    std::printf("thin bodies: %d of %d through the bullet\n", through, seeds);
    CHECK(through == 0);
}

TEST_CASE("thin bodies do not pass through a slow bullet") {
    const int seeds = int(families::seeds_or(150));
    int through = 0;
    for (int seed = 0; seed < seeds; ++seed) {
        families::Random random{std::mt19937(unsigned(seed) + 1)};
        World world;
        Body ground = world.create_body({.type = BodyType::static_body});
        ground.add(Box{.width = 200, .height = 1, .center = {0, -0.5f}});
        const float height = random(0.1f, 0.4f);
        Body bar = world.create_body({.position = {0, 0.5f * height}, .bullet = true});
        bar.add(Box{.width = 100, .height = height}, {.density = 5});
        Body thin = world.create_body({.position = {random(-0.5f, 0.5f), random(3, 8)},
                                       .angle = random(-3, 3),
                                       .velocity = {0, random(-40, 0)}});
        thin.add(thin_shape(random, seed % 3));
        for (int step = 0; step < 60; ++step) {
            world.step(1.0f / 60);
            if (thin.position().y > bar.position().y) continue;
            ++through;
            break;
        }
    }
    std::printf("thin bodies: %d of %d through the slow bullet\n", through, seeds);
    CHECK(through == 0);
}

TEST_CASE("a bullet that contains a thin body keeps moving") {
    const int seeds = int(families::seeds_or(200));
    int still = 0;
    for (int seed = 0; seed < seeds; ++seed) {
        families::Random random{std::mt19937(unsigned(seed) + 1)};
        World world(WorldDef{.gravity = {0, 0}});
        const float size = random(0.2f, 0.6f);
        Body bullet = world.create_body({.velocity = {random(5, 60), random(-5, 5)},
                                         .angular_velocity = random(-60, 60),
                                         .bullet = true});
        if (seed % 2 == 0)
            bullet.add(Circle{0.5f * size});
        else
            bullet.add(Box{.width = size, .height = size});
        Body plank =
            world.create_body({.position = {size * random(-0.5f, 0.5f), size * random(-0.5f, 0.5f)},
                               .angle = random(-3, 3),
                               .velocity = {random(0, 60), random(-10, 10)},
                               .angular_velocity = random(-40, 40)});
        plank.add(Box{.width = random(0.3f, 1.5f), .height = random(0.01f, 0.06f)},
                  {.density = random(0.2f, 1)});
        int most = 0, steps = 0;  // in which it hardly moves
        for (int step = 0; step < 30; ++step) {
            const Position before = bullet.position();
            world.step(1.0f / 60);
            const float way = Vec2(bullet.position() - before).length();
            steps = way < 0.02f * bullet.velocity().length() / 60 ? steps + 1 : 0;
            most = std::max(most, steps);
        }
        if (most >= 4) ++still;
    }
    std::printf("thin bodies: %d of %d bullets stand still\n", still, seeds);
    CHECK(still <= seeds / 50);
}

}  // namespace thin_on_bullets_test
