#include "catch.h"
#include "scenes.h"

namespace impact_test {

using namespace scenes;

namespace {

const ShapeDef bouncy = {.friction = 0.0f, .restitution = 1.0f};

}  // namespace

TEST_CASE("an elastic collision conserves momentum and energy") {
    World world({.gravity = {0, 0}});
    Body a = add_ball(world, {-3, 0.1f}, 0.5f, bouncy);
    Body b = add_ball(world, {3, -0.2f}, 0.8f, bouncy);
    a.set_velocity({4, 0});
    b.set_velocity({-2, 0.3f});
    auto momentum = [&] { return Vec2(a.mass() * a.velocity() + b.mass() * b.velocity()); };
    auto energy = [&] { return a.kinetic_energy() + b.kinetic_energy(); };
    const Vec2 p = momentum();
    const float e = energy();
    run(world, 2.0f);
    REQUIRE(a.velocity().x < 0.0f);  // they did collide
    REQUIRE((momentum() - p).length() / p.length() < 1e-5f);
    REQUIRE(energy() == Approx(e).epsilon(0.01));
}

TEST_CASE("a ball dropped with restitution bounces to its share of the height") {
    World world;
    add_floor(world, 50.0f, {.restitution = 0.0f});
    Body ball = add_ball(world, {0, 5.5f}, 0.5f, {.restitution = 0.8f});
    float highest = 0.0f;
    bool bounced = false;
    for (int i = 0; i < 180; ++i) {
        world.step(frame);
        bounced |= ball.velocity().y > 0.0f;
        if (bounced && ball.velocity().y > 0.0f)
            highest = std::max<float>(highest, ball.position().y);
        if (bounced && ball.velocity().y < 0.0f) break;
    }
    REQUIRE(highest - 0.5f == Approx(0.64f * 5.0f).epsilon(0.05));
}

TEST_CASE("below the restitution threshold nothing bounces until the threshold falls") {
    World world({.restitution_threshold = 100.0f});
    add_floor(world);
    Body ball = add_ball(world, {0, 3}, 0.5f, bouncy);
    run(world, 2.0f);
    REQUIRE(ball.position().y == Approx(0.5f).margin(0.02));
    world.set_restitution_threshold(1.0f);
    ball.set_position({0, 3});
    run(world, 0.8f);
    REQUIRE(ball.velocity().y > 1.0f);
}

TEST_CASE("in a row of touching balls the last one leaves with the speed of the first") {
    World world({.gravity = {0, 0}});
    std::vector<Body> row;
    for (int i = 0; i < 5; ++i) row.push_back(add_ball(world, {float(i) * 1.05f, 0}, 0.5f, bouncy));
    row[0].set_position({-3, 0});
    row[0].set_velocity({5, 0});
    run(world, 2.0f);
    REQUIRE(row[4].velocity().x == Approx(5.0f).epsilon(0.02));
    for (int i = 0; i < 4; ++i) REQUIRE(std::fabs(row[size_t(i)].velocity().x) < 0.15f);
}

TEST_CASE("every pair of kinds of shapes collides and neither sinks in") {
    const auto add = [](Body body, int kind) {
        switch (kind) {
            case 0:
                return body.add(Circle{.radius = 0.5f});
            case 1:
                return body.add(Box{});
            case 2:
                return body.add(Polygon{
                    .vertices = {
                        {-0.5f, -0.5f}, {0.5f, -0.5f}, {0.6f, 0.2f}, {0, 0.6f}, {-0.6f, 0.2f}}});
            case 3:
                return body.add(Segment{.from = {-0.3f, 0}, .to = {0.3f, 0}, .rounding = 0.3f});
            case 4:
                return body.add(Box{.rounding = 0.2f});
            default:
                return body.add(Polygon{.vertices = {{-0.5f, -0.4f}, {0.5f, -0.4f}, {0, 0.5f}},
                                        .rounding = 0.1f});
        }
    };
    for (int below = 0; below < 6; ++below) {
        for (int above = 0; above < 6; ++above) {
            World world;
            // In a groove, so that round ones do not roll away.
            add_floor(world);
            for (float side : {-1.15f, 1.15f}) {
                Body wall =
                    world.create_body({.type = BodyType::static_body, .position = {side, 3}});
                wall.add(Box{.width = 1, .height = 6}, {.friction = 0.0f});
            }
            Body low = world.create_body({.position = {0, 0.7f}}),
                 high = world.create_body({.position = {0, 2.0f}});
            Shape low_shape = add(low, below), high_shape = add(high, above);
            run(world, 3.0f);
            INFO("below " << below << ", above " << above);
            REQUIRE(low_shape.aabb().min.y > -0.02f);
            REQUIRE(high.position().y > low.position().y + 0.4f);
            REQUIRE(high.position().y < 3.0f);
            REQUIRE(high.velocity().length() < 0.05f);
            REQUIRE(low.is_touching());
            REQUIRE(high_shape.is_touching());
        }
    }
}

TEST_CASE("a box rests on the end of a segment and on a flat chain of segments") {
    World world;
    Body ground = world.create_body({.type = BodyType::static_body});
    for (int i = -5; i < 5; ++i)
        ground.add(Segment{.from = {float(i), 0}, .to = {float(i + 1), 0}});
    Body box = add_box(world, {0.3f, 1});
    run(world, 2.0f);
    REQUIRE(box.position().y == Approx(0.5f).margin(0.01));
    REQUIRE(std::fabs(box.angle()) < 0.01f);
}

TEST_CASE("a polygon of forty corners rolls and rests like a wheel") {
    World world;
    add_floor(world);
    std::vector<Vec2> corners;
    for (int i = 0; i < 40; ++i)
        corners.emplace_back(std::cos(float(i) * 0.15708f), std::sin(float(i) * 0.15708f));
    Body wheel = world.create_body({.position = {0, 1.5f}});
    REQUIRE(wheel.add(Polygon{.vertices = corners}).vertices().size() == 40);
    run(world, 3.0f);
    REQUIRE(wheel.position().y == Approx(1.0f).margin(0.02));
}

}  // namespace impact_test
