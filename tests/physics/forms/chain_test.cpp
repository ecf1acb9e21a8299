#include <numeric>

#include "catch.h"
#include "scenes.h"

namespace chain_test {

using namespace scenes;

namespace {

Shape ground_of(World& world, const std::vector<Vec2>& points, bool closed = false,
                const ShapeDef& surface = {}) {
    Body body = world.create_body({.type = BodyType::static_body});
    return body.add(Chain{points, closed}, surface);
}

std::vector<Vec2> flat(int segments, float length, float left = 0.0f) {
    std::vector<Vec2> points;
    for (int i = 0; i <= segments; ++i) points.push_back({left + length * float(i), 0.0f});
    return points;
}

std::vector<Vec2> circle(int count, float radius, float direction = 1.0f) {
    std::vector<Vec2> points;
    for (int i = 0; i < count; ++i) {
        const float a = direction * 6.2831853f * float(i) / float(count);
        points.push_back({radius * std::cos(a), radius * std::sin(a)});
    }
    return points;
}

Shape add_slider(World& world, int kind, const Vec2& at, const Vec2& velocity, float friction) {
    Body body = world.create_body({.position = at, .velocity = velocity});
    const ShapeDef surface = {.friction = friction};
    if (kind == 0) return body.add(Circle{.radius = 0.5f}, surface);
    if (kind == 1) return body.add(Box{}, surface);
    if (kind == 2) return body.add(Segment{{-0.5f, 0}, {0.5f, 0}, 0.5f}, surface);
    if (kind == 3) return body.add(Ellipse{0.8f, 0.5f}, surface);
    return body.add(Polygon{{{-0.4f, -0.45f}, {0.4f, -0.45f}, {0.4f, 0.2f}, {0.0f, 0.4f}}, 0.05f},
                    surface);
}

}  // namespace

TEST_CASE("a chain is one shape with one set of properties") {
    World world;
    Shape chain = ground_of(world, flat(20, 1.0f, -10.0f));
    REQUIRE(world.shape_count() == 1);
    REQUIRE(world.shapes().size() == 1);
    REQUIRE(chain.type() == ShapeType::chain);
    REQUIRE(chain.vertices().size() == 21);
    REQUIRE(chain.pieces().size() == 20);
    REQUIRE(chain.body().shapes().size() == 1);
    REQUIRE(chain.body().shape_count() == 1);
    REQUIRE(chain.area() == 0.0f);
    REQUIRE(chain.aabb().min == Vec2(-10, 0));
    REQUIRE(chain.aabb().max == Vec2(10, 0));
    Body ball = add_ball(world, {0.25f, 0.5f}, 0.5f, {.friction = 0.3f});
    run(world, 1.0f);
    REQUIRE(ball.position().y == Approx(0.5f).margin(0.005));
    REQUIRE(ball.contacts().size() >= 1);
    REQUIRE((ball.contacts()[0].shape_a == chain.id() || ball.contacts()[0].shape_b == chain.id()));
    chain.set_friction(0.75f);
    run(world, 0.1f);
    REQUIRE(ball.contacts()[0].friction == Approx(std::sqrt(0.75f * 0.3f)));
    REQUIRE_FALSE(world.validate());
}

TEST_CASE("a body that slides along a flat chain is not kicked at its seams") {
    const int kind = GENERATE(0, 1, 2, 3, 4);
    const float speed = GENERATE(0.5f, 2.0f, 7.0f, 15.0f, 30.0f);
    World world({.sleeping = false});
    ground_of(world, flat(400, 0.37f, -20.0f), false, {.friction = 0.0f});

    Shape slider = add_slider(world, kind, {-10, 0.5f}, {0, 0}, 0.0f);
    run(world, 1.0f);
    slider.body().set_velocity({speed, 0.0f});
    float kick = 0.0f, turn = 0.0f, low = 1e9f, high = -1e9f;
    for (int i = 0; i < 150; ++i) {
        world.step(frame);
        kick = std::max(kick, std::fabs(slider.body().velocity().y));
        turn = std::max(turn, std::fabs(slider.body().angular_velocity()));
        low = std::min<float>(low, slider.body().position().y);
        high = std::max<float>(high, slider.body().position().y);
    }
    INFO("kind " << kind << " at " << speed << " m/s: kick " << kick << " turn " << turn);
    CHECK(slider.body().velocity().x == Approx(speed).epsilon(1e-4));
    CHECK(kick < 0.01f);
    CHECK(turn < 0.02f);
    CHECK(high - low < 0.002f);
}

TEST_CASE("a chain is solid on its left side and bodies pass through it from its right side") {
    World world({.gravity = {0, 0}});
    ground_of(world, flat(10, 1.0f, -5.0f));
    Body above = add_ball(world, {-2, 1}, 0.25f), below = add_ball(world, {2, -1}, 0.25f);
    above.set_velocity({0, -3});
    below.set_velocity({0, 3});
    run(world, 1.0f);
    REQUIRE(above.position().y == Approx(0.25f).margin(0.02));
    REQUIRE(below.position().y > 1.5f);
    // Fast enough to pass in one step.
    Body bullet = add_ball(world, {0, 5}, 0.05f), back = add_ball(world, {0.5f, -5}, 0.05f);
    bullet.set_velocity({0, -300});
    back.set_velocity({0, 300});
    run(world, 0.5f);
    REQUIRE(bullet.position().y > 0.0f);
    REQUIRE(back.position().y > 20.0f);
}

TEST_CASE("a closed chain keeps bodies inside and a clockwise one keeps bodies outside") {
    World world;
    ground_of(world, circle(60, 5.0f), true);
    std::vector<Body> inside;
    for (int i = 0; i < 30; ++i)
        inside.push_back(i % 2 ? add_box(world, {float(i % 6) - 2.5f, float(i / 6) - 2.0f}, 0.5f)
                               : add_ball(world, {float(i % 6) - 2.5f, float(i / 6) - 2.0f}, 0.3f));
    run(world, 6.0f);
    for (Body body : inside) REQUIRE(Vec2(body.position()).length() < 5.0f);
    REQUIRE_FALSE(world.validate());

    World other;
    ground_of(other, circle(60, 2.0f, -1.0f), true);
    Body on_top = add_box(other, {0, 2.6f}, 1.0f);
    run(other, 0.5f);
    REQUIRE(on_top.position().y == Approx(2.5f).margin(0.02));
}

TEST_CASE("things rest in the valleys and on the peaks of a chain and do not fall through") {
    World world;
    std::vector<Vec2> points;
    for (int i = 0; i <= 80; ++i) points.push_back({float(i) - 40.0f, i % 2 ? 0.6f : -0.2f});
    points.front().y = points.back().y = 8.0f;
    ground_of(world, points);
    std::vector<Body> bodies;
    for (int i = 0; i < 60; ++i) {
        const Vec2 at = {0.9f * float(i % 30) - 13.0f, 2.0f + 1.2f * float(i / 30)};
        bodies.push_back(add_slider(world, i % 5, at, {float(i % 7) - 3.0f, 0}, 0.5f).body());
    }
    run(world, 12.0f);
    for (Body body : bodies) {
        INFO(body.position().x << " " << body.position().y);
        CHECK(body.position().y > -0.2f);
        CHECK(body.velocity().length() < 0.1f);
    }
    REQUIRE_FALSE(world.validate());
}

TEST_CASE("a box rests with one end over the end of an open chain") {
    World world({.sleeping = false});
    ground_of(world, flat(5, 1.0f, -5.0f));
    Body box = add_box(world, {-0.3f, 0.5f});
    run(world, 3.0f);
    REQUIRE(box.position().y == Approx(0.5f).margin(0.01));
    REQUIRE(std::fabs(box.angle()) < 0.01f);
    Body tipping = add_box(world, {-4.8f + -0.5f, 0.5f});
    run(world, 3.0f);
    REQUIRE(tipping.position().y < -1.0f);
}

TEST_CASE("a ball that rolls over a chain begins one contact") {
    World world({.sleeping = false});
    Shape chain = ground_of(world, flat(100, 0.5f, -10.0f));
    Body ball = add_ball(world, {-5, 0.5f}, 0.5f);
    ball.set_velocity({6, 0});
    ball.set_angular_velocity(-12.0f);
    size_t begins = 0, ends = 0;
    world.set_persist_events(true);
    for (int i = 0; i < 120; ++i) {
        world.step(frame);
        begins += world.events().contact_begin.size();
        ends += world.events().contact_end.size();
        if (i > 2) REQUIRE(world.events().contact_persist.size() == 1);
        for (const auto& e : world.events().contact_begin)
            REQUIRE((e.shape_a == chain.id() || e.shape_b == chain.id()));
    }
    REQUIRE(begins == 1);
    REQUIRE(ends == 0);
    REQUIRE(chain.is_touching());
    ball.set_position({0, 10});
    world.step(frame);
    REQUIRE(world.events().contact_end.size() == 1);
    REQUIRE_FALSE(chain.is_touching());
    REQUIRE_FALSE(world.validate());
}

TEST_CASE("a chain is found by rays from its front and by every other query") {
    World world;
    Shape chain = ground_of(world, {{-5, 0}, {0, 0}, {0, -2}, {5, -2}});
    const auto hit = world.cast_ray({-2, 3}, {-2, -3});
    REQUIRE(hit);
    REQUIRE(hit->shape == chain);
    REQUIRE(hit->point.y == Approx(0.0f).margin(1e-5));
    REQUIRE(hit->normal.y == Approx(1.0f));
    REQUIRE_FALSE(world.cast_ray({-2, -3}, {-2, 3}));
    REQUIRE(world.cast_ray_all({-2, 3}, {-2, -5}).size() == 1);
    REQUIRE(world.query_overlap(Circle{.radius = 1.5f}, {{0, 0}, 0}).size() == 1);
    REQUIRE(world.query_aabb({{-1, -3}, {1, 1}}).size() == 1);
    const auto near = world.closest({1, 0}, 10.0f);
    REQUIRE(near);
    REQUIRE(near->distance == Approx(1.0f));
    const auto swept = world.cast_shape(Box{}, {{-2, 3}, 0}, {0, -6});
    REQUIRE(swept);
    REQUIRE(swept->fraction == Approx(2.5f / 6.0f).epsilon(1e-3));
    Body ball = add_ball(world, {3, 0});
    REQUIRE(distance(chain, ball.shapes()[0]).distance == Approx(1.5f));
    REQUIRE(distance(ball.shapes()[0], chain).distance == Approx(1.5f));
}

TEST_CASE("a change of the points of a chain has an effect at once") {
    World world;
    Shape chain = ground_of(world, flat(10, 1.0f, -5.0f));
    Body ball = add_ball(world, {0.5f, 0.5f}, 0.5f);
    run(world, 3.0f);
    REQUIRE_FALSE(ball.awake());
    std::vector<Vec2> points(chain.vertices().begin(), chain.vertices().end());
    for (Vec2& p : points) p.y = -1.0f;
    chain.set_vertices(points);
    run(world, 1.0f);
    REQUIRE(ball.position().y == Approx(-0.5f).margin(0.01));
    points.resize(4);
    chain.set_vertices(points);
    REQUIRE(chain.pieces().size() == 3);
    run(world, 1.0f);
    REQUIRE(ball.position().y < -2.0f);
    chain.set_vertices(std::vector<Vec2>{{0, 0}, {1, 0}, {1, 1}});
    REQUIRE(chain.pieces().size() == 2);
    chain.set_closed(true);
    REQUIRE(chain.pieces().size() == 3);
    REQUIRE_FALSE(world.validate());
    chain.detach();
    REQUIRE(chain.aabb().max == Vec2(1, 1));
    REQUIRE_FALSE(world.validate());
    chain.set_geometry(Box{});
    REQUIRE(chain.type() == ShapeType::box);
    REQUIRE(chain.area() == 1.0f);
    chain.set_geometry(Chain{flat(3, 1.0f)});
    chain.destroy();
    REQUIRE(world.shape_count() == 1);
    REQUIRE_FALSE(world.validate());
}

TEST_CASE("invalid points make no chain and the error has the reason") {
    World world;
    const auto refused = [&](const Chain& chain, const std::string& why) {
        try {
            world.create_shape(chain);
        } catch (const std::invalid_argument& error) {
            INFO(error.what());
            return std::string(error.what()).find(why) != std::string::npos;
        }
        return false;
    };
    REQUIRE(refused({}, "at least two points"));
    REQUIRE(refused({{{0, 0}}}, "at least two points, got 1"));
    REQUIRE(refused({{{1, 1}, {1, 1}, {1, 1}}}, "same place"));
    REQUIRE(refused({{{0, 0}, {1, 0}}, true}, "at least three"));
    REQUIRE(refused({{{0, 0}, {std::nanf(""), 0}}}, "points: point 2 = (nan, 0)"));
    REQUIRE(refused({{{0, 0}, {2e6f, 0}}}, "1e+06"));
    // Points that follow each other in the same place count once.
    Shape doubled = world.create_shape(Chain{{{0, 0}, {0, 0}, {1, 0}, {1, 0}}});
    REQUIRE(doubled.pieces().size() == 1);
    REQUIRE(doubled.vertices().size() == 4);
}

TEST_CASE("ten thousand segments cost no more than those that are near") {
    World world({.sleeping = false});
    std::vector<Vec2> points;
    for (int i = 0; i <= 10000; ++i)
        points.push_back({0.1f * float(i) - 500.0f, 0.3f * std::sin(0.05f * float(i))});
    ground_of(world, points);
    std::vector<Body> balls;
    for (int i = 0; i < 50; ++i) balls.push_back(add_ball(world, {float(i) * 4 - 100, 2.0f}, 0.3f));
    run(world, 2.0f);
    for (Body ball : balls) REQUIRE(ball.position().y > -0.3f);
    REQUIRE(world.statistics().contacts < 50 * 20);
    REQUIRE(world.statistics().shapes == 51);
}

// When the search for contacts that begin or end visited all parts of an outline for each body,
// these two tests took 50 s and 40 s.
TEST_CASE(
    "the cost of a long chain across the border of the world does not grow with the square of its "
    "points") {
    World world({.bounds = Aabb{{-1, -1}, {1, 1}}});
    Chain chain;
    for (int i = 0; i < 40'000; ++i) chain.points.push_back({float(i), float(i % 2)});
    Body body = world.create_body();
    body.add(chain);
    world.step(frame);
    CHECK(body.is_touching());
    world.step(frame);
    body.destroy();
    CHECK_FALSE(world.validate());
}

TEST_CASE(
    "the cost of deleting a chain under many bodies does not grow with the square of its "
    "contacts") {
    World world;
    Chain chain;
    for (int i = 0; i < 1'500; ++i)
        chain.points.push_back({0.002f * float(i), 0.001f * float(i % 2)});
    Body ground = world.create_body({.type = BodyType::static_body});
    Shape line = ground.add(chain);
    for (int i = 0; i < 200; ++i) add_ball(world, {1.5f, 0.1f}, 2.0f);
    run(world, 2 * frame);
    CHECK(world.statistics().contacts > 250'000);
    SECTION("the body") {
        ground.destroy();
    }
    SECTION("the shape") {
        line.destroy();
    }
    SECTION("most of its points") {
        line.set_geometry(Chain{{chain.points.begin(), chain.points.begin() + 2}});
    }
    run(world, frame);
    CHECK(world.statistics().contacts < 200 * 200);
}

}  // namespace chain_test
