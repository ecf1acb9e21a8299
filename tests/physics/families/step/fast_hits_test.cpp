// Fast bodies that come through the air: they touch what is in their way, at the place where they
// meet it. FETTLE_SEEDS=n: n shots of each kind.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "catch.h"
#include "family.h"

namespace fast_hits_test {

using namespace fettle::physics;
using families::Random;
using families::seeds_or;
using families::turned;

namespace {

constexpr float dt = 1.0f / 60;
constexpr float degrees = 57.29578f;
const ShapeDef elastic = {.friction = 0, .restitution = 1};

/// How far directions are from those that are expected, in degrees.
struct Directions {
    double sum = 0, worst = 0;

    void add(Vec2 expected, Vec2 velocity) {
        const double error =
            std::fabs(std::atan2(expected.cross(velocity), expected.dot(velocity))) * degrees;
        sum += error;
        worst = std::max(worst, error);
    }
    void check(const char* what, unsigned count) const {
        std::printf("%s %.2f degrees off, %.1f at most\n", what, sum / count, worst);
        CHECK(sum / count < 1);
        CHECK(worst < 12);
    }
};

/// An obstacle whose topmost point is the origin.
void add_obstacle(World& world, int kind) {
    Body body =
        world.create_body({.type = kind < 4 ? BodyType::static_body : BodyType::kinematic_body});
    if (kind == 0)
        body.add(Box{.width = 2, .height = 2, .center = {1, -1}}, elastic);
    else if (kind == 1)
        body.add(Box{.width = 0.1f, .height = 3, .center = {0, -1.5f}}, elastic);
    else if (kind == 2)
        body.add(Polygon{.vertices = {{0, 0}, {-0.5f, -2}, {0.5f, -2}}}, elastic);
    else
        body.add(Circle{.radius = 0.2f, .center = {0, -0.2f}}, elastic);
}

}  // namespace

TEST_CASE("a fast ball touches each obstacle that it meets") {
    unsigned shots = 0, missed = 0;
    for (int kind = 0; kind < 5; ++kind) {
        for (unsigned seed = 0; seed < seeds_or(100); ++seed) {
            Random random{std::mt19937(seed)};
            const float radius = random(0.05f, 0.5f), speed = random(5, 80);
            World world({.gravity = {0, 0}});
            add_obstacle(world, kind);
            // The ball flies level, and reaches below the top by this part of its radius.
            const float below = random(0.02f, 1) * radius;
            Body ball = world.create_body(
                {.position = {-3 - random(0, speed * dt), radius - below}, .velocity = {speed, 0}});
            ball.add(Circle{.radius = radius}, elastic);
            while (ball.position().x < 4 && ball.velocity().x > 0 && ball.velocity().y < 0.01f)
                world.step(dt);
            ++shots;
            missed += ball.velocity() == Vec2{speed, 0};
        }
    }
    std::printf("fast balls: %u of %u miss what they meet\n", missed, shots);
    CHECK(missed == 0);
}

TEST_CASE("a fast ball leaves a post in the right direction") {
    Directions directions;
    const unsigned seeds = seeds_or(200);
    for (unsigned seed = 0; seed < seeds; ++seed) {
        Random random{std::mt19937(seed)};
        const float radius = random(0.1f, 0.4f), post = 0.3f, speed = random(5, 40);
        World world({.gravity = {0, 0}});
        world.create_body({.type = BodyType::static_body}).add(Circle{.radius = post}, elastic);
        const float aside = random(-0.9f, 0.9f);
        Body ball =
            world.create_body({.position = {-3, aside * (radius + post)}, .velocity = {speed, 0}});
        ball.add(Circle{.radius = radius}, elastic);
        for (float time = 0; time < 8 / speed; time += dt) world.step(dt);
        const Vec2 normal = {-std::sqrt(1 - aside * aside), aside};
        const Vec2 expected = Vec2{1, 0} - 2 * normal.x * normal;
        directions.add(expected, ball.velocity());
    }
    directions.check("fast balls leave a post", seeds);
}

TEST_CASE("a bullet pushes a ball in the direction in which it hits it") {
    Directions directions;
    const unsigned seeds = seeds_or(200);
    for (unsigned seed = 0; seed < seeds; ++seed) {
        Random random{std::mt19937(seed)};
        const float radius = random(0.1f, 0.4f), speed = random(5, 30);
        World world({.gravity = {0, 0}});
        Body target = world.create_body({});
        target.add(Circle{.radius = radius}, elastic);
        const float aside = random(-0.9f, 0.9f);
        Body cue = world.create_body(
            {.position = {-3, 2 * aside * radius}, .velocity = {speed, 0}, .bullet = true});
        cue.add(Circle{.radius = radius}, elastic);
        for (float time = 0; time < 6 / speed; time += dt) world.step(dt);
        REQUIRE(target.velocity().length() > 0);
        const Vec2 expected = {std::sqrt(1 - aside * aside), -aside};
        directions.add(expected, target.velocity());
    }
    directions.check("bullets push a ball", seeds);
}

TEST_CASE("a fast body does not get through a slot that is narrower than it is") {
    unsigned through = 0;
    const unsigned seeds = seeds_or(200);
    for (unsigned seed = 0; seed < seeds; ++seed) {
        Random random{std::mt19937(seed)};
        World world({.gravity = {0, 0}});
        const float size = 0.6f, slot = random(0.3f, 0.9f) * size, speed = random(5, 20);
        Body wall = world.create_body({.type = BodyType::static_body});
        for (const float side : {-1.0f, 1.0f})
            wall.add(Box{
                .width = random(0.1f, 1), .height = 4, .center = {0, side * (2 + 0.5f * slot)}});
        Body body = world.create_body(
            {.position = {-3 - random(0, 0.3f), random(-0.02f, 0.02f)}, .velocity = {speed, 0}});
        if (seed % 2 == 0)
            body.add(Circle{.radius = 0.5f * size});
        else
            body.add(Box{.width = size, .height = size});
        for (float time = 0; time < 2; time += dt) world.step(dt);
        through += body.position().x > 0.5f;
    }
    std::printf("slots: %u of %u bodies get through\n", through, seeds);
    CHECK(through == 0);
}

TEST_CASE("what falls does not sink into the ground") {
    float deepest = 0;
    for (unsigned seed = 0; seed < seeds_or(100); ++seed) {
        Random random{std::mt19937(seed)};
        World world;
        Body ground = world.create_body({.type = BodyType::static_body});
        ground.add(Box{.width = 200, .height = 2, .center = {0, -1}});
        const float speed = random(2, 60), size = random(0.1f, 2);
        Body body = world.create_body(
            {.position = {0, size + random(0.1f, 2)}, .velocity = {random(-5, 5), -speed}});
        if (seed % 3 == 0)
            body.add(Circle{.radius = 0.5f * size});
        else
            body.add(Box{.width = size, .height = size});
        for (int i = 0; i < 120; ++i) {
            world.step(dt);
            deepest = std::max(deepest, 0.5f * size - float(body.position().y));
        }
    }
    std::printf("what falls sinks in by %.4f m at most\n", double(deepest));
    CHECK(deepest < 0.01f);
}

// Contacts are found before the body is in the ledge, so the callback sees it above.
TEST_CASE("a ledge that `before_solve` opens from below holds who lands on it") {
    unsigned fallen = 0;
    const unsigned seeds = seeds_or(200);
    for (unsigned seed = 0; seed < seeds; ++seed) {
        Random random{std::mt19937(seed)};
        World world({.gravity = {0, -20}});
        world.create_body({.type = BodyType::static_body})
            .add(Box{.width = 50, .height = 1, .center = {0, -0.5f}});
        const float height = random(1, 3), thickness = random(0.05f, 0.4f);
        Body ledge = world.create_body(
            {.type = seed % 3 == 0 ? BodyType::kinematic_body : BodyType::static_body,
             .position = {0, height}});
        ledge.add(Box{.width = 4, .height = thickness});
        const float top = height + 0.5f * thickness;
        Body player =
            world.create_body({.position = {random(-1.5f, 1.5f), 0.6f}, .locked_rotation = true});
        player.add(Box{.width = 0.5f, .height = 1.2f});
        const auto feet = [&] { return float(player.position().y) - 0.6f; };
        world.set_before_solve([&](ContactEdit& contact) {
            const bool at_ledge =
                contact.shape_a.body() == ledge || contact.shape_b.body() == ledge;
            if (at_ledge && feet() < top - 0.02f) contact.enabled = false;
        });
        for (int i = 0; i < 20; ++i) world.step(dt);
        player.set_velocity({random(-0.5f, 0.5f), std::sqrt(40 * (top + random(0.3f, 1)))});
        for (int i = 0; i < 150; ++i) world.step(dt);
        fallen += feet() < top - 0.01f;
    }
    CHECK(fallen == 0);
}

TEST_CASE("a box without restitution that lands on a corner does not hop") {
    float most = 0;
    for (unsigned seed = 0; seed < seeds_or(120); ++seed) {
        Random random{std::mt19937(seed)};
        const float speed = random(3, 12), rate = seed % 2 == 0 ? 60.0f : 240.0f;
        World world({.gravity = {0, 0}});
        world.create_body({.type = BodyType::static_body})
            .add(Box{.width = 40, .height = 2, .center = {0, -1}});
        const float width = random(0.5f, 1.5f), height = random(0.2f, 0.5f);
        const float angle = random(0.1f, 1.4f);
        Body body = world.create_body(
            {.position = {0, 1 + width}, .angle = angle, .velocity = {0, -speed}});
        body.add(Box{.width = width, .height = height},
                 {.friction = random(0.3f, 1), .restitution = 0});
        for (int i = 0; i < int(rate) && body.velocity() == Vec2{0, -speed}; ++i)
            world.step(1 / rate);
        // The speed of the lowest corner, which is the one that hit.
        float low = 1e9f;
        for (const float x : {-1.0f, 1.0f})
            for (const float y : {-1.0f, 1.0f}) {
                const Vec2 at = {0.5f * x * width, 0.5f * y * height};
                const Position place = body.world_point(at);
                if (float(place.y) < low) {
                    low = float(place.y);
                    const Vec2 arm = place - body.position();
                    most = std::max(most,
                                    (body.velocity().y + body.angular_velocity() * arm.x) / speed);
                }
            }
    }
    std::printf("a corner that lands leaves with %.3f of its speed at most\n", double(most));
    CHECK(most < 0.12f);
}

TEST_CASE("a disc that lands with a spin rolls as fast as its spin makes it") {
    float worst = 0;
    for (unsigned seed = 0; seed < seeds_or(60); ++seed) {
        Random random{std::mt19937(seed)};
        const float radius = random(0.2f, 0.6f), spin = random(5, 40);
        World world({.sleeping = false});
        world.create_body({.type = BodyType::static_body})
            .add(Box{.width = 400, .height = 2, .center = {0, -1}}, {.friction = 1});
        Body disc = world.create_body(
            {.position = {0, radius + random(0.1f, 6)}, .angular_velocity = -spin});
        disc.add(Circle{.radius = radius},
                 {.friction = 1, .restitution = seed % 2 == 0 ? 0.0f : 0.6f});
        for (int i = 0; i < 600; ++i) world.step(dt);
        worst = std::max(worst, std::fabs(disc.velocity().x / (spin * radius / 3) - 1));
    }
    std::printf("spinning discs roll %.4f off at most\n", double(worst));
    CHECK(worst < 0.02f);
}

TEST_CASE("a wheel notices a kerb") {
    unsigned missed = 0;
    const unsigned seeds = seeds_or(60);
    for (unsigned seed = 0; seed < seeds; ++seed) {
        Random random{std::mt19937(seed)};
        const float speed = random(5, 30), height = random(0.1f, 0.16f);
        World world;
        Body road = world.create_body({.type = BodyType::static_body});
        road.add(Box{.width = 200, .height = 2, .center = {0, -1}}, {.friction = 1});
        road.add(Box{.width = 0.2f, .height = 2 * height}, {.friction = 1});
        Body wheel = world.create_body({.position = {-10 - random(0, speed * dt), 0.4f},
                                        .velocity = {speed, 0},
                                        .angular_velocity = -speed / 0.4f});
        wheel.add(Circle{.radius = 0.4f}, {.friction = 1});
        float rise = 0;
        for (float time = 0; time < 12 / speed; time += dt) {
            world.step(dt);
            rise = std::max(rise, wheel.velocity().y);
        }
        missed += rise < 0.2f;
    }
    std::printf("kerbs: %u of %u wheels roll through\n", missed, seeds);
    CHECK(missed <= seeds / 20);
}

}  // namespace fast_hits_test
