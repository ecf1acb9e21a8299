// Movers and the bodies around them exchange momentum, and neither gains energy. Nearly all of
// these movers have a kinematic body, as those of games do.

#include <fettle/physics/mover.h>

#include <algorithm>
#include <cmath>

#include "catch.h"
#include "random.h"
#include "scenes.h"
#include "thorough.h"

namespace mover_momentum_test {

using namespace scenes;

namespace {

/// A mover under gravity, with or without a kinematic body.
struct Hero {
    Mover mover;
    Body body;
    Vec2 velocity = {};
    float speed = 0.0f;  ///< of the last move, m/s

    Hero(World& world, MoverDef def, const Position& position, bool with_body = true) {
        if (with_body) {
            body = world.create_body({.type = BodyType::kinematic_body, .position = position});
            body.add(Segment{.from = {0, def.radius},
                             .to = {0, def.height - def.radius},
                             .rounding = def.radius});
            def.body = body.id();
        }
        mover = Mover(def, position);
    }
    Moved move(World& world, float dt, float walk = 0.0f) {
        velocity.x = walk;
        if (!mover.on_ground()) velocity.y -= 10.0f * dt;
        const Moved moved = mover.move(world, velocity, dt);
        velocity = moved.velocity;
        speed = moved.motion.length() / dt;
        if (body) body.set_velocity((1 / dt) * moved.motion);
        return moved;
    }
};

}  // namespace

TEST_CASE("a mover that lands on a seesaw gives it no more energy than it has") {
    const bool with_body = GENERATE(false, true);
    for (unsigned seed = 1; seed <= 60; ++seed) {
        if (!is_tested(seed, 4)) continue;
        Random random{std::mt19937(seed)};
        const float dt = 1 / (seed % 2 == 0 ? 60.0f : 120.0f);
        World world;
        Body floor = add_floor(world, 100.0f);
        const float length = random(3, 7), height = random(0.4f, 1.2f);
        Body plank = add_box(world, {0, height}, length, 0.15f, random(20, 150));
        world.create_revolute_joint(
            {.body_a = floor.id(), .body_b = plank.id(), .anchor_a = {0, height + 0.5f}});
        Body crate = add_box(world, {-0.42f * length, height + 0.3f}, 0.5f, 0.5f, random(5, 80));
        const float x = length * random(0.15f, 0.45f), fall = random(0.4f, 1.5f);
        Hero hero(world, {}, {x, height + fall}, with_body);
        const auto energy = [&] {
            float sum = 0.0f;
            for (const Body& body : {plank, crate})
                sum += body.kinetic_energy() + 10 * body.mass() * float(body.world_center().y);
            return sum;
        };
        const float before = energy(), of_mover = 80 * 10 * (height + fall);
        float gained = 0.0f;
        for (int i = 0; i < int(3 / dt); ++i) {
            hero.move(world, dt);
            world.step(dt);
            gained = std::max(gained, energy() - before);
        }
        INFO("seed " << seed << ", body " << with_body);
        CHECK(gained < of_mover);
    }
}

TEST_CASE("a barrel on which a mover stands does not drive itself") {
    const bool with_body = GENERATE(false, true);
    for (unsigned seed = 1; seed <= 60; ++seed) {
        if (!is_tested(seed, 4)) continue;
        Random random{std::mt19937(seed)};
        const float dt = 1 / rate_of(seed), radius = random(0.3f, 1.2f);
        World world;
        add_floor(world, 200.0f);
        const float friction = random(0.3f, 1);
        Body barrel = add_ball(world, {0, radius}, radius, {.friction = friction});
        barrel.set_mass(2 * std::pow(150.0f, random(0, 1)));
        const float fall = seed % 2 == 0 ? 0.02f : random(0.1f, 1.5f);
        const float x = radius * random(0.02f, 0.5f);
        Hero hero(world, {}, {x, 2 * radius + fall}, with_body);
        const float before = 80 * 10 * (2 * radius + fall);
        float most = 0.0f, fastest = 0.0f;
        for (int i = 0; i < int(4 / dt); ++i) {
            hero.move(world, dt);
            world.step(dt);
            const float height = float(hero.mover.position().y);
            most = std::max(
                most, 80 * 10 * height + 40 * hero.speed * hero.speed + barrel.kinetic_energy());
            fastest = std::max(fastest, hero.speed);
        }
        INFO("seed " << seed << ", body " << with_body);
        CHECK(most < 2.2f * before);
        CHECK(fastest < 9);
    }
}

TEST_CASE("a mover on the head of another drives neither of them") {
    const bool lower_first = GENERATE(false, true);
    for (unsigned seed = 1; seed <= 48; ++seed) {
        if (!is_tested(seed, 4)) continue;
        Random random{std::mt19937(seed)};
        const float dt = 1 / rate_of(seed);
        World world;
        add_floor(world, 100.0f);
        Hero lower(world, {}, {0, 0.02f});
        const float x = random(-0.4f, 0.4f), y = random(1.9f, 2.8f);
        Hero upper(world, {}, {x, y});
        float fastest = 0.0f;
        for (int i = 0; i < int(5 / dt); ++i) {
            for (Hero* hero : {lower_first ? &lower : &upper, lower_first ? &upper : &lower}) {
                hero->move(world, dt);
                fastest = std::max(fastest, hero->speed);
            }
            world.step(dt);
        }
        INFO("seed " << seed << ", lower first " << lower_first);
        CHECK(fastest < 8);
        CHECK(std::fabs(float(lower.mover.position().x)) < 0.5f);
        CHECK(lower.speed + upper.speed == 0.0f);
    }
}

TEST_CASE("a wall that pushes a mover pushes the crate in front of it too") {
    for (unsigned seed = 1; seed <= 48; ++seed) {
        if (!is_tested(seed, 4)) continue;
        Random random{std::mt19937(seed)};
        const float dt = 1 / rate_of(seed), pace = random(0.3f, 3);
        World world;
        add_floor(world, 200.0f);
        Body wall = world.create_body(
            {.type = BodyType::kinematic_body, .position = {-1.5f, 1.5f}, .velocity = {pace, 0}});
        wall.add(Box{.width = 1, .height = 3});
        Body crate = add_box(world, {1.2f, 0.4f}, 0.8f, 0.8f, random(2, 15));
        Hero hero(world, {}, {0, 0.02f}, seed % 2 == 0);
        float deepest = 0.0f;
        for (int i = 0; i < int(5 / dt); ++i) {
            hero.move(world, dt);
            world.step(dt);
            const float left = float(hero.mover.position().x) - 0.4f;
            deepest = std::max(deepest, float(wall.position().x) + 0.5f - left);
        }
        INFO("seed " << seed << ", " << pace << " m/s, " << crate.mass() << " kg");
        CHECK(deepest < 0.2f);
        CHECK(std::fabs(float(crate.position().x) - float(wall.position().x) - 1.7f) < 0.1f);
    }
}

TEST_CASE("a ball that rolls against a mover with a body stops there") {
    for (unsigned seed = 1; seed <= 24; ++seed) {
        if (!is_tested(seed, 4)) continue;
        Random random{std::mt19937(seed)};
        const float dt = 1 / rate_of(seed), radius = random(0.15f, 0.5f);
        World world;
        add_floor(world, 100.0f);
        Body ball = add_ball(world, {-2, radius}, radius);
        ball.set_mass(random(0.3f, 30));
        ball.set_velocity({random(0.3f, 4), 0});
        Hero hero(world, {}, {0, 0.01f});
        for (int i = 0; i < int(10 / dt); ++i) {
            hero.move(world, dt);
            world.step(dt);
        }
        INFO("seed " << seed << ", " << ball.mass() << " kg");
        CHECK(std::fabs(float(hero.mover.position().x)) < 0.01f);
    }
}

TEST_CASE("a mover pushes no crate that its force cannot move") {
    const bool with_callbacks = GENERATE(false, true);
    for (unsigned seed = 1; seed <= 48; ++seed) {
        if (!is_tested(seed, 4)) continue;
        Random random{std::mt19937(seed)};
        const float dt = 1 / rate_of(seed), walk = random(1, 8), x = random(2, 5);
        World world;
        if (with_callbacks) {
            world.set_before_solve([](ContactEdit&) {});
            world.set_mixing([](ContactEdit&) {});
        }
        add_floor(world, 100.0f);
        Body crate = add_box(world, {x, 0.5f}, 1, 1, 200 * std::pow(100.0f, random(0, 1)));
        MoverDef def;
        if (seed % 2 == 0) def.push_force = 0;
        Hero hero(world, def, {0, 0.02f});
        for (int i = 0; i < int(8 / dt); ++i) {
            hero.move(world, dt, walk);
            world.step(dt);
        }
        INFO("seed " << seed << ", " << crate.mass() << " kg, " << walk << " m/s");
        CHECK(std::fabs(float(crate.position().x) - x) < 0.02f);
    }
}

TEST_CASE("a mover jumps through a ledge that is a dynamic body and stands on it") {
    for (unsigned seed = 1; seed <= 24; ++seed) {
        if (!is_tested(seed, 4)) continue;
        Random random{std::mt19937(seed)};
        const float dt = 1 / rate_of(seed), height = random(2.2f, 2.6f);
        World world;
        add_floor(world, 100.0f);
        for (const float x : {-2.0f, 2.0f}) add_box(world, {x, 0.5f * height}, 0.4f, height, 1e4f);
        Body plank = world.create_body({.position = {0, height + 0.05f}});
        plank.add(Box{.width = 4.4f, .height = 0.1f}, {.category = 2});
        plank.set_mass(random(5, 120));
        MoverDef def;
        def.ledges = 2;
        Hero hero(world, def, {0, 0.02f});
        const float jump = std::sqrt(2 * 10 * (height + 0.6f));
        for (int i = 0; i < int(4 / dt); ++i) {
            if (i == int(1 / dt)) hero.velocity.y += jump;
            hero.move(world, dt);
            world.step(dt);
        }
        INFO("seed " << seed << ", " << plank.mass() << " kg");
        CHECK(float(hero.mover.position().y) == Approx(height + 0.1f).margin(0.05));
        CHECK(float(plank.position().y) == Approx(height + 0.05f).margin(0.05));
    }
}

TEST_CASE("a platform on a pulley sinks with a mover that is heavier than the load") {
    const float rate = GENERATE(30.0f, 60.0f, 144.0f);
    World world;
    add_floor(world);
    Body pan = add_box(world, {-2, 3}, 2, 0.2f, 10), load = add_box(world, {2, 3}, 1, 1, 30);
    pan.set_locked_rotation(true);
    world.create_pulley_joint(
        {.body_a = pan.id(), .body_b = load.id(), .ground_a = {-2, 8}, .ground_b = {2, 8}});
    Hero hero(world, {}, {-2, 3.11f});
    for (int i = 0; i < int(8 * rate); ++i) {
        hero.move(world, 1 / rate);
        world.step(1 / rate);
    }
    CHECK(float(pan.position().y) == Approx(0.1f).margin(0.05));
    CHECK(hero.mover.on_ground());
    CHECK(hero.speed == Approx(0).margin(0.01));
}

TEST_CASE("a sensor on a crate sees the body of the mover that pushes the crate") {
    World world;
    add_floor(world, 100.0f);
    Body crate = add_box(world, {2, 0.5f}, 1, 1, 20);
    crate.add(Box{.width = 3, .height = 0.8f}, {.density = 0, .sensor = true});
    Hero hero(world, {}, {0, 0.02f});
    int begins = 0, ends = 0;
    for (int i = 0; i < 120; ++i) {
        hero.move(world, frame, 2.0f);
        world.step(frame);
        begins += int(world.events().sensor_begin.size());
        ends += int(world.events().sensor_end.size());
    }
    CHECK(float(crate.position().x) > 2.5f);
    CHECK(begins == 1);
    CHECK(ends == 0);
}

TEST_CASE("a field elsewhere in the world changes no weight of a mover") {
    World world;
    add_floor(world);
    add_box(world, {0, 0.5f}, 1, 1, 5);
    Hero hero(world, {}, {0, 1.01f}, false);
    if (GENERATE(false, true))
        world.create_field({.force = DragField{.linear = 1}, .region = Aabb{{20, 0}, {30, 5}}});
    for (int i = 0; i < 120; ++i) {
        hero.move(world, frame);
        world.step(frame);
    }
    float force = 0.0f;
    for (const Contact& contact : world.contacts())
        for (const ContactPoint& point : contact.points)
            force += point.normal_impulse * 60 * float(world.substeps());
    CHECK(force == Approx((80 + 5) * 10).margin(20));
}

TEST_CASE("two movers on one platform both weigh on it") {
    const bool with_bodies = GENERATE(false, true);
    World world;
    Body lift = add_box(world, {0, 0}, 4, 0.2f, 20);
    world.create_prismatic_joint(
        {.body_b = lift.id(), .anchor_a = {0, 0}, .axis = {0, 1}, .hertz = 3, .damping_ratio = 1});
    const float frame = 1 / 60.0f;
    Hero left(world, {.mass = 60}, {-1, 0.2f}, with_bodies);
    Hero right(world, {.mass = 60}, {1, 0.2f}, with_bodies);
    for (int i = 0; i < 240; ++i) {
        left.move(world, frame);
        right.move(world, frame);
        world.step(frame);
    }
    const float turn = 2 * 3.14159265f * 3;
    CHECK(float(lift.position().y) ==
          Approx(-(60 + 60 + 20) * 10 / (turn * turn * 20)).epsilon(0.05));
}

TEST_CASE("ground without friction gives way alike to both sides") {
    const auto fall = [](float side) {
        World world;
        add_floor(world, 50, {.friction = 0});
        Body crate = world.create_body({.position = {0, 0.6f}});
        crate.add(Box{1, 1}, {.density = 3, .friction = 0});
        Hero hero(world, {.mass = 30}, {0.45f * side, 1.15f});
        for (int i = 0; i < 60; ++i) {
            hero.move(world, 1 / 60.0f);
            world.step(1 / 60.0f);
        }
        return Vec2(side * float(crate.position().x), side * crate.angle());
    };
    const Vec2 left = fall(-1), right = fall(1);
    CHECK(left.x == Approx(right.x).margin(1e-3));
    CHECK(left.y == Approx(right.y).margin(1e-3));
}

TEST_CASE("a mover that is put elsewhere does not go on falling through what it dropped through") {
    World world;
    Body level = world.create_body({.type = BodyType::static_body});
    level.add(Chain{{{-20, 0}, {20, 0}}});
    Hero hero(world, {}, {0, 0.01f}, false);
    for (int i = 0; i < 5; ++i) hero.move(world, 1 / 60.0f);
    REQUIRE(hero.mover.drop(world));
    hero.mover.set_position({5, 0.05f});
    hero.velocity = {};
    for (int i = 0; i < 60; ++i) hero.move(world, 1 / 60.0f);
    CHECK(hero.mover.on_ground());
    CHECK(float(hero.mover.position().y) > -0.02f);
}

TEST_CASE("a plank whose joint leads to a disabled body falls and carries no mover") {
    World world;
    Body post = world.create_body({.type = BodyType::static_body, .position = {-2, 0}});
    post.add(Box{0.2f, 0.2f});
    Body plank = add_box(world, {0, 0}, 4, 0.2f, 20);
    world.create_weld_joint({.body_a = post.id(), .body_b = plank.id(), .anchor_b = {-2, 0}});
    Hero hero(world, {}, {0, 0.12f});
    const float frame = 1 / 60.0f;
    for (int i = 0; i < 30; ++i) {
        hero.move(world, frame);
        world.step(frame);
    }
    CHECK(hero.mover.on_ground());
    post.set_enabled(false);
    for (int i = 0; i < 5; ++i) {
        hero.move(world, frame);
        world.step(frame);
    }
    CHECK_FALSE(hero.mover.on_ground());
}

TEST_CASE("a move of no time has the ground of the last move") {
    World world;
    add_floor(world);
    Hero hero(world, {}, {0, 0.01f}, false);
    const Moved last = hero.move(world, 1 / 60.0f);
    REQUIRE(last.on_ground);
    const float dt = GENERATE(0.0f, -1.0f, NAN);
    const Moved paused = hero.mover.move(world, {1, 0}, dt);
    CHECK(paused.on_ground);
    CHECK(paused.ground == last.ground);
    CHECK(paused.ground_normal == last.ground_normal);
    CHECK(paused.velocity == Vec2(1, 0));
    CHECK(paused.motion == Vec2(0, 0));
}

TEST_CASE("a weight that waits for a body that was put to sleep is gone when the body wakes") {
    World world;
    add_floor(world);
    Body crate = add_box(world, {0, 0.5f}, 1, 1, 50);
    run(world, 0.1f);
    Hero hero(world, {}, {0, 1.02f}, false);
    hero.move(world, 1 / 60.0f);
    REQUIRE(hero.mover.on_ground());
    crate.set_awake(false);
    for (int i = 0; i < 3; ++i) world.step(1 / 60.0f);
    crate.set_awake(true);
    crate.set_position({20, 5});
    crate.set_velocity({});
    world.step(1 / 60.0f);
    CHECK(crate.velocity().y == Approx(-10 / 60.0f).margin(0.01));
}

namespace {

/// The greatest speed upwards of a mover that falls into a room of bodies, or walks in it, and
/// never jumps, m/s.
float lift_in_heap(unsigned seed, bool walks) {
    Random random{std::mt19937(seed)};
    const float dt = 1 / rate_of(seed), half = walks ? 6.0f : 2.5f;
    World world;
    Body fixed = add_floor(world, 50.0f);
    for (const float side : {-1.0f, 1.0f})
        fixed.add(Box{.width = 1, .height = 20, .center = {side * (half + 0.5f), 9}});
    const int count = int(random(3, 14));
    const float density = std::exp(random(-3, 3));
    for (int i = 0; i < count; ++i) {
        const float x = random(-half + 0.6f, half - 0.6f);
        Body body = world.create_body({.position = {x, 0.7f + 0.5f * float(i)}});
        const float size = random(0.2f, 0.6f), flat = random(0.5f, 1);
        const bool round = walks && random(0, 1) < 0.5f;
        if (round)
            body.add(Circle{size}, {.density = density});
        else
            body.add(Box{.width = 2 * size, .height = 2 * size * flat}, {.density = density});
    }
    for (float time = 0; time < 4; time += dt) world.step(dt);
    const float mass = std::exp(random(2.3f, 5.7f)), x = random(1 - half, half - 1);
    Hero hero(world, {.mass = mass}, {x, walks ? 8.0f : random(6, 14)});
    float fastest = 0.0f, walk = 0.0f;
    for (float time = 0; time < 8; time += dt) {
        if (walks && random(0, 1) < dt) walk = random(-6, 6);
        hero.move(world, dt, walk);
        if (!hero.mover.on_ground()) fastest = std::max(fastest, hero.velocity.y);
        world.step(dt);
    }
    return fastest;
}

}  // namespace

TEST_CASE("a mover that only stands on crates in a pit is not thrown up") {
    for (unsigned seed = 1; seed <= 90; ++seed) {
        if (!is_tested(seed, 6)) continue;
        INFO("seed " << seed);
        CHECK(lift_in_heap(seed, false) < 3);
    }
}

TEST_CASE("a mover that walks through a heap leaves it upwards no faster than up a slope") {
    int thrown = 0, all = 0;
    for (unsigned seed = 1; seed <= 90; ++seed) {
        if (!is_tested(seed, 6)) continue;
        const float speed = lift_in_heap(seed, true);
        INFO("seed " << seed);
        CHECK(speed < 12);
        thrown += speed > 5;
        ++all;
    }
    CHECK(thrown <= all / 6);
}

}  // namespace mover_momentum_test
