#include "catch.h"
#include "scenes.h"

namespace surface_test {

using namespace scenes;

TEST_CASE("a box on a slope sticks below and slides above the angle of friction") {
    const float mu = 0.5f, limit = std::atan(mu);
    for (float difference : {-0.03f, 0.03f}) {
        World world;
        Slope slope = add_slope(world, limit + difference, mu);
        run(world, 1.0f);  // settle
        const Position start = slope.box.position();
        run(world, 3.0f);
        const float travelled = (slope.box.position() - start).dot(slope.down);
        if (difference < 0.0f)
            REQUIRE(std::fabs(travelled) < 0.01f);
        else
            REQUIRE(travelled > 1.0f);
    }
}

TEST_CASE("a sliding box accelerates by the gravity that friction leaves") {
    World world;
    const float angle = 0.6f, mu = 0.3f;
    Slope slope = add_slope(world, angle, mu);
    run(world, 0.5f);
    const float before = slope.box.velocity().dot(slope.down);
    run(world, 2.0f);
    const float measured = (slope.box.velocity().dot(slope.down) - before) / 2.0f;
    const float expected = 10.0f * (std::sin(angle) - mu * std::cos(angle));
    REQUIRE(measured == Approx(expected).epsilon(0.01));
}

TEST_CASE("a circle rolls down a slope at two thirds of the sliding acceleration") {
    World world;
    const float angle = 0.3f;
    Body ground = world.create_body({.type = BodyType::static_body, .angle = angle});
    ground.add(Box{.width = 400, .height = 1});
    const Vec2 normal = {-std::sin(angle), std::cos(angle)};
    Body ball = add_ball(world, normal * 1.0f);
    run(world, 0.5f);
    const Vec2 down = {-std::cos(angle), -std::sin(angle)};
    const float before = ball.velocity().dot(down);
    run(world, 2.0f);
    const float measured = (ball.velocity().dot(down) - before) / 2.0f;
    REQUIRE(measured == Approx(10.0f * std::sin(angle) * 2.0f / 3.0f).epsilon(0.01));
    // Without slipping: turning speed times radius is the speed. Down is to the left, so it turns
    // counter-clockwise.
    REQUIRE(ball.angular_velocity() * 0.5f == Approx(ball.velocity().length()).epsilon(0.01));
}

TEST_CASE("a ball rolls on without rolling resistance and stops with it") {
    World world;
    add_floor(world, 200.0f);
    Body free = add_ball(world, {0, 0.5f});
    Body braked = add_ball(world, {0, 0.5f}, 0.5f, {.rolling_resistance = 0.1f});
    free.shapes()[0].set_mask(1);
    braked.shapes()[0].set_group(-1);
    free.shapes()[0].set_group(-1);
    for (Body ball : {free, braked}) {
        ball.set_velocity({3, 0});
        ball.set_angular_velocity(-6);
    }
    run(world, 5.0f);
    REQUIRE(free.velocity().x == Approx(3.0f).margin(0.1));
    REQUIRE(std::fabs(braked.velocity().x) < 0.05f);
    REQUIRE(braked.position().x > 0.5f);
}

TEST_CASE("rolling resistance stops an ellipse as it stops a circle of the same area") {
    World world;
    add_floor(world, 200.0f);
    const auto rolled = [&](const Geometry& geometry, auto&& edit) {
        Body body =
            world.create_body({.position = {0, 0.5f}, .velocity = {3, 0}, .angular_velocity = -6});
        Shape shape = body.add(geometry, {.rolling_resistance = 0.1f, .group = -1});
        run(world, 0.2f);
        edit(shape);
        run(world, 5.0f);
        return body.position().x;
    };
    const auto nothing = [](Shape) {};
    const float circle = rolled(Circle{0.5f}, nothing);
    REQUIRE(circle > 5.0f);
    REQUIRE(circle < 10.0f);
    const float ellipse = rolled(Ellipse{.radius_x = 0.5f, .radius_y = 0.5f}, nothing);
    REQUIRE(ellipse == Approx(circle).epsilon(0.01));
    REQUIRE(rolled(Ellipse{.radius_x = 0.53f, .radius_y = 0.47f}, nothing) ==
            Approx(circle).epsilon(0.2));
    REQUIRE(rolled(Ellipse{.radius_x = 0.5f, .radius_y = 0.5f},
                   [](Shape shape) { shape.set_rolling_resistance(0); }) > 1.5f * ellipse);
}

TEST_CASE("a bouncy ball whose rolling resistance is set to zero rolls on") {
    World world;
    add_floor(world, 200.0f);
    // Its contact is computed like one with rolling resistance, before and after.
    Body ball = add_ball(world, {0, 0.5f}, 0.5f, {.restitution = 0.5f, .rolling_resistance = 0.1f});
    ball.set_velocity({3, 0});
    ball.set_angular_velocity(-6);
    run(world, 0.2f);
    ball.shapes()[0].set_rolling_resistance(0);
    const float velocity = ball.velocity().x;
    run(world, 5.0f);
    REQUIRE(ball.velocity().x == Approx(velocity).epsilon(0.01));
}

TEST_CASE("a conveyor takes a box along its surface") {
    World world;
    Body floor = add_floor(world);
    // Counter-clockwise round the shape: to the left along its top.
    floor.shapes()[0].set_surface_speed(2.0f);
    Body box = add_box(world, {0, 0.5f});
    run(world, 3.0f);
    REQUIRE(box.velocity().x == Approx(-2.0f).margin(0.02));
    floor.shapes()[0].set_surface_speed(-2.0f);
    run(world, 3.0f);
    REQUIRE(box.velocity().x == Approx(2.0f).margin(0.02));
}

TEST_CASE("friction mixes by the geometric mean and restitution by the greater") {
    World world;
    add_floor(world, 50.0f, {.friction = 0.4f, .restitution = 0.1f});
    Body box = add_box(world, {0, 0.5f}, 1.0f, {.friction = 0.9f, .restitution = 0.3f});
    run(world, 0.1f);
    REQUIRE(box.contacts().size() == 1);
    REQUIRE(box.contacts()[0].friction == Approx(0.6f));
    REQUIRE(box.contacts()[0].restitution == Approx(0.3f));
}

TEST_CASE("a bounce has the friction of Coulomb") {
    const float friction = GENERATE(0.1f, 0.2f), restitution = GENERATE(0.01f, 0.3f, 0.9f);
    const float speed = GENERATE(2.0f, 4.0f);
    const int substeps = GENERATE(1, 4);
    const std::vector<Geometry> forms = {Circle{}, Box{}, Segment{.rounding = 0.3f}, Ellipse{}};
    for (const Geometry& form : forms) {
        World world({.gravity = {0, 0}, .substeps = substeps});
        Body floor = world.create_body({.type = BodyType::static_body});
        floor.add(Box{.width = 400, .height = 1, .center = {0, -0.5f}}, {.friction = friction});
        Body body = world.create_body(
            {.position = {0, 0.8f}, .velocity = {10, -speed}, .locked_rotation = true});
        body.add(form, {.friction = friction, .restitution = restitution});
        run(world, 0.9f);
        CHECK(body.velocity().y == Approx(restitution * speed).margin(0.01f));
        CHECK(10 - body.velocity().x ==
              Approx(friction * (1 + restitution) * speed).epsilon(0.01f));
    }
}

TEST_CASE("a spinning ball kicks off the floor and its bounce never adds energy") {
    const float spin = GENERATE(-20.0f, -5.0f, 5.0f, 20.0f);
    World world({.gravity = {0, 0}});
    Body floor = world.create_body({.type = BodyType::static_body});
    floor.add(Box{.width = 400, .height = 1, .center = {0, -0.5f}});
    Body ball =
        world.create_body({.position = {0, 0.8f}, .velocity = {0, -4}, .angular_velocity = spin});
    ball.add(Circle{}, {.restitution = 0.8f});
    const auto energy = [&] {
        return 0.5f * (ball.mass() * ball.velocity().length_squared() +
                       ball.inertia() * ball.angular_velocity() * ball.angular_velocity());
    };
    const float before = energy();
    run(world, 1.0f);
    // It ends without slip: a third of the speed of its rim, with the inertia of a disc.
    CHECK(ball.velocity().x == Approx(-spin * 0.5f / 3).epsilon(0.1f));
    CHECK(energy() < before);
}

}  // namespace surface_test
