#include <iostream>

#include "catch.h"
#include "scenes.h"

namespace stability_test {

using namespace scenes;

TEST_CASE("a stack of twelve boxes stands still to a millimeter a second") {
    World world({.sleeping = false});
    add_floor(world);
    std::vector<Body> stack;
    for (int i = 0; i < 12; ++i) stack.push_back(add_box(world, {0, 0.5f + float(i)}));
    run(world, 5.0f);
    double sum = 0.0;
    for (Body box : stack) sum += double(box.velocity().length_squared());
    const double jitter = std::sqrt(sum / double(stack.size()));
    std::cout << "12-box stack: jitter " << jitter * 1000.0 << " mm/s\n";
    REQUIRE(jitter < 1e-3);
    REQUIRE(stack.back().position().y == Approx(11.5f).margin(0.05));
    for (Body box : stack) REQUIRE(std::fabs(box.position().x) < 0.01f);
}

TEST_CASE("a pyramid of fifteen rows stands") {
    World world({.sleeping = false});
    add_floor(world);
    std::vector<Body> boxes;
    for (int i = 0; i < 15; ++i) {
        for (int j = i; j < 15; ++j) {
            boxes.push_back(add_box(
                world, {float(i + 1) * 0.5f + float(j - i) - 7.5f, float(2 * i + 1) * 0.5f}));
        }
    }
    run(world, 6.0f);
    REQUIRE(boxes.back().position().y == Approx(14.5f).margin(0.1));
    for (Body box : boxes) REQUIRE(std::fabs(box.angle()) < 0.02f);
}

TEST_CASE("boxes that overlap by a quarter are pushed apart without being thrown") {
    World world({.gravity = {0, 0}});
    Body a = add_box(world, {0, 0}), b = add_box(world, {0.75f, 0});
    float fastest = 0.0f;
    for (int i = 0; i < 120; ++i) {
        world.step(frame);
        fastest = std::max({fastest, a.velocity().length(), b.velocity().length()});
    }
    REQUIRE(b.position().x - a.position().x > 0.98f);
    REQUIRE(fastest <= 3.0f);
    REQUIRE(a.velocity().length() < 0.5f);
}

TEST_CASE("many circles in a box without gravity come to rest") {
    World world({.gravity = {0, 0}, .bounds = Aabb{{-10, -10}, {10, 10}}});
    std::vector<Body> balls;
    for (int i = 0; i < 25; ++i) {
        for (int k = 0; k < 25; ++k) {
            balls.push_back(
                add_ball(world, {-9.0f + 0.75f * float(i), -9.0f + 0.75f * float(k)}, 0.39f));
        }
    }
    run(world, 12.0f);
    double sum = 0.0;
    for (Body ball : balls) sum += double(ball.velocity().length_squared());
    REQUIRE(std::sqrt(sum / double(balls.size())) < 0.05);
    REQUIRE_FALSE(world.validate());
}

TEST_CASE("a load of three hundred to one sinks in by less than a twentieth") {
    World world({.sleeping = false});
    add_floor(world);
    Body light = add_box(world, {0, 0.5f});
    Body heavy = add_box(world, {0, 1.5f}, 1.0f, {.density = 300.0f});
    run(world, 10.0f);
    REQUIRE(heavy.position().y > 1.45f);
    REQUIRE(heavy.position().y < 1.5f);
    REQUIRE(light.position().y > 0.475f);
    REQUIRE(heavy.velocity().length() < 0.02f);
}

TEST_CASE("twenty boxes that are not quite above each other stand") {
    World world({.sleeping = false});
    add_floor(world);
    std::vector<Body> stack;
    for (int i = 0; i < 20; ++i)
        stack.push_back(add_box(world, {float(i % 3 - 1) * 0.1f, 0.5f + float(i)}));
    run(world, 15.0f);
    REQUIRE(stack.back().position().y > 19.3f);
    REQUIRE(std::fabs(stack.back().angle()) < 0.02f);
}

TEST_CASE("a house of cards of five floors stands") {
    // Where it is built must not matter: one start is not a proof.
    const float start = GENERATE(0.0f, 0.37f, 1.48f, -3.3f, 12.345f);
    World world({.sleeping = false});
    const ShapeDef surface = {.friction = 0.7f};
    Body table = world.create_body({.type = BodyType::static_body, .position = {0, -2}});
    table.add(Box{.width = 80, .height = 4}, surface);
    const float half = 0.2f, lean = 25.0f * 3.14159265f / 180.0f;
    std::vector<Body> cards;
    auto add_card = [&](float x, float y, float angle) {
        cards.push_back(world.create_body({.position = {start + x, y}, .angle = angle}));
        cards.back().add(Box{.width = 0.002f, .height = 2.0f * half}, surface);
    };
    float left = 0.0f, y = half - 0.02f, top = 0.0f;
    for (int pairs = 5; pairs > 0; --pairs) {
        float x = left;
        for (int i = 0; i < pairs; ++i) {
            if (i != pairs - 1) add_card(x + 0.25f, y + half - 0.015f, 1.5707963f);
            add_card(x, y, -lean);
            add_card(x + 0.175f, y, lean);
            x += 0.35f;
        }
        top = y;
        y += 2.0f * half - 0.03f;
        left += 0.175f;
    }
    run(world, 10.0f);
    float highest = 0.0f;
    for (Body card : cards) highest = std::max<float>(highest, card.position().y);
    REQUIRE(highest > top - 0.06f);
}

TEST_CASE("bullets at 300 meters a second do not pass through thin walls") {
    for (int kind = 0; kind < 4; ++kind) {
        for (float angle : {0.0f, 0.3f, -0.8f}) {
            World world({.gravity = {0, 0}});
            Body wall = world.create_body({.type = BodyType::static_body});
            if (kind % 2 == 0)
                wall.add(Segment{.from = {0, -50}, .to = {0, 50}});
            else
                wall.add(Box{.width = 0.02f, .height = 100});
            Body bullet = world.create_body(
                {.position = {-7.3f, 0}, .angular_velocity = 20.0f, .bullet = true});
            if (kind < 2)
                bullet.add(Circle{.radius = 0.05f});
            else
                bullet.add(Box{.width = 0.2f, .height = 0.05f});
            bullet.set_velocity({300.0f * std::cos(angle), 300.0f * std::sin(angle)});
            for (int i = 0; i < 60; ++i) {
                world.step(frame);
                INFO("kind " << kind << ", angle " << angle << ", step " << i);
                REQUIRE(bullet.position().x < 0.1f);
            }
            REQUIRE_FALSE(world.validate());
        }
    }
}

TEST_CASE("a bullet hits a body that moves and an ordinary fast body does not pass a static one") {
    World world({.gravity = {0, 0}});
    Body plate = world.create_body({.position = {0, 0}});
    plate.add(Box{.width = 0.05f, .height = 2});
    Body bullet = world.create_body({.position = {-9.4f, 0}, .bullet = true});
    bullet.add(Circle{.radius = 0.05f});
    bullet.set_velocity({250, 0});
    run(world, 0.2f);
    REQUIRE(plate.velocity().x > 1.0f);
    REQUIRE(bullet.position().x < plate.position().x);
}

TEST_CASE("without continuous collision a fast ball passes a thin wall") {
    World world({.gravity = {0, 0}});
    Body wall = world.create_body({.type = BodyType::static_body});
    wall.add(Segment{.from = {0, -5}, .to = {0, 5}});
    Body ball = add_ball(world, {-10.2f, 0}, 0.1f);
    ball.set_velocity({100, 0});
    world.set_continuous(false);
    run(world, 0.3f);
    REQUIRE(ball.position().x > 1.0f);
    world.set_continuous(true);
    ball.set_position({-10.2f, 0});
    ball.set_velocity({100, 0});
    run(world, 0.3f);
    REQUIRE(ball.position().x < 0.0f);
}

TEST_CASE("nothing kicks a fast box at the seams of a floor of tiles") {
    World world;
    Body floor = world.create_body({.type = BodyType::static_body});
    for (int i = -5; i < 200; ++i) floor.add(Box{.center = {float(i), -0.5f}}, {.friction = 0.0f});
    Body box = add_box(world, {0, 0.5f}, 1.0f, {.friction = 0.0f});
    Body ball = add_ball(world, {-3, 0.5f}, 0.5f, {.friction = 0.0f});
    run(world, 0.5f);
    box.set_velocity({30, 0});
    ball.set_velocity({30, 0});
    for (int i = 0; i < 240; ++i) {
        world.step(frame);
        REQUIRE(box.position().y == Approx(0.5f).margin(0.01));
        REQUIRE(ball.position().y == Approx(0.5f).margin(0.01));
    }
    REQUIRE(box.velocity().x == Approx(30.0f).epsilon(0.01));
    REQUIRE(ball.velocity().x == Approx(30.0f).epsilon(0.01));
}

TEST_CASE("nothing kicks a circle that slides or rolls over a floor of tiles") {
    const float speed = GENERATE(0.5f, 2.0f, 5.0f, 10.0f, 30.0f);
    const float friction = GENERATE(0.0f, 0.6f);
    World world;
    Body floor = world.create_body({.type = BodyType::static_body});
    for (int i = -5; i < 100; ++i)
        floor.add(Box{.center = {float(i), -0.5f}}, {.friction = friction});
    Body ball = add_ball(world, {-3, 0.5f}, 0.5f, {.friction = friction});
    run(world, 0.5f);
    ball.set_velocity({speed, 0});
    if (friction > 0.0f) ball.set_angular_velocity(-speed / 0.5f);
    float fastest = 0.0f;
    for (int i = 0; i < 180; ++i) {
        world.step(frame);
        fastest = std::max(fastest, std::fabs(ball.velocity().y));
    }
    INFO(speed << " m/s, friction " << friction);
    CHECK(fastest < 0.03f);
    CHECK(ball.velocity().x == Approx(speed).epsilon(0.01));
}

TEST_CASE("a body thrown at a border at any speed stays inside") {
    World world({.gravity = {0, 0}, .bounds = Aabb{{-5, -5}, {5, 5}}});
    Body box = add_box(world, {0, 0}, 0.3f);
    for (float speed : {10.0f, 100.0f, 1000.0f, 9000.0f}) {
        box.set_pose({{0, 0}, 0.3f});
        box.set_velocity({speed, 0.7f * speed});
        for (int i = 0; i < 30; ++i) {
            world.step(frame);
            INFO("speed " << speed << ", step " << i);
            REQUIRE(Vec2(box.position()).abs().largest() < 5.0f);
        }
    }
}

}  // namespace stability_test
