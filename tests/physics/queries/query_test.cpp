#include "catch.h"
#include "scenes.h"

#include <cmath>
#include <random>

namespace query_test {

using namespace scenes;

TEST_CASE("a point query finds the shapes under the point") {
    World world;
    Body box = world.create_body({.position = {2, 0}, .angle = 0.785398f});
    Shape shape = box.add(Box{.width = 2, .height = 2});
    REQUIRE(world.query_point({2, 1.3f}) == std::vector<Shape>{shape});
    REQUIRE(world.query_point({2.9f, 0.9f}).empty());
    Body ball = add_ball(world, {2, 1}, 1.0f);
    REQUIRE(world.query_point({2, 1}).size() == 2);
    REQUIRE(world.query_point({2, 1.9f}) == ball.shapes());
}

TEST_CASE("queries are right at once after a teleport and after an edit and after a deletion") {
    World world;
    Body ball = add_ball(world, {0, 0});
    world.step(frame);
    ball.set_position({40, 7});
    REQUIRE(world.query_point({0, 0}).empty());
    REQUIRE(world.query_point({40, 7}).size() == 1);
    ball.shapes()[0].set_radius(5.0f);
    REQUIRE(world.query_point({44, 7}).size() == 1);
    REQUIRE(world.cast_ray({40, 20}, {40, 0})->point.y == Approx(12.0f));
    ball.destroy();
    REQUIRE(world.query_point({40, 7}).empty());
    REQUIRE_FALSE(world.cast_ray({40, 20}, {40, 0}));
}

TEST_CASE("a ray stops at the nearest surface with its outward normal") {
    World world;
    Body wall = world.create_body({.type = BodyType::static_body, .position = {5, 0}});
    Shape near = wall.add(Box{.width = 1, .height = 4});
    Body ball = add_ball(world, {10, 0}, 1.0f);
    const auto hit = world.cast_ray({0, 0.5f}, {20, 0.5f});
    REQUIRE(hit);
    REQUIRE(hit->shape == near);
    REQUIRE(hit->point.x == Approx(4.5f));
    REQUIRE(hit->normal == Vec2(-1, 0));
    REQUIRE(hit->fraction == Approx(4.5f / 20.0f));
    const auto all = world.cast_ray_all({0, 0.5f}, {20, 0.5f});
    REQUIRE(all.size() == 2);
    REQUIRE(all[1].shape == ball.shapes()[0]);
    REQUIRE(all[1].point.x == Approx(10.0f - std::sqrt(0.75f)));
    REQUIRE(all[1].normal.length() == Approx(1.0f));
    REQUIRE_FALSE(world.cast_ray({0, 3}, {20, 3}));
    REQUIRE_FALSE(world.cast_ray({0, 0.5f}, {4, 0.5f}));
}

TEST_CASE("a ray hits every kind of shape where it is") {
    World world;
    auto first_x = [&](Body body) {
        const auto hit = world.cast_ray({-10, 0.05f}, {10, 0.05f});
        REQUIRE(hit);
        REQUIRE(hit->shape.body() == body);
        const float x = hit->point.x;
        body.destroy();
        return x;
    };
    Body a = world.create_body();
    a.add(Segment{.from = {0, -1}, .to = {0, 1}});
    REQUIRE(first_x(a) == Approx(0.0f).margin(1e-6));
    Body b = world.create_body();
    b.add(Segment{.from = {0, -1}, .to = {0, 1}, .rounding = 0.25f});
    REQUIRE(first_x(b) == Approx(-0.25f));
    Body c = world.create_body();
    c.add(Polygon{.vertices = {{0, -1}, {2, 0.05f}, {0, 1}, {-2, 0.05f}}});
    REQUIRE(first_x(c) == Approx(-2.0f).margin(1e-4));
    Body d = world.create_body();
    d.add(Box{.rounding = 0.5f});
    REQUIRE(first_x(d) == Approx(-std::sqrt(0.25f - 0.0025f)).margin(2e-3));
}

TEST_CASE("a ray through a corner does not slip between two edges") {
    World world({.gravity = {0, 0}});
    std::vector<Vec2> corners, outline = {{2, -1}, {2, 1}, {0, 0.5f}, {-2, 1}, {-2, -1}};
    for (int i = 0; i < 7; ++i)
        corners.push_back({std::cos(0.8975979f * float(i)), std::sin(0.8975979f * float(i))});
    std::vector<Vec2> many;
    for (int i = 0; i < 50; ++i)
        many.push_back({std::cos(0.12566371f * float(i)), std::sin(0.12566371f * float(i))});
    const std::vector<Vec2> clockwise(corners.rbegin(), corners.rend());
    int calls = 0;
    for (const Geometry& form : {Geometry(Polygon{corners}), Geometry(Polygon{many}),
                                 Geometry(Concave{outline}), Geometry(Chain{clockwise, true})}) {
        for (int turn = 0; turn < 50; ++turn) {
            Body body = world.create_body({.type = BodyType::static_body,
                                           .position = {0.7f * float(turn), -3.0f},
                                           .angle = float(turn)});
            Shape shape = body.add(form);
            std::vector<Vec2> ends = corners;
            if (shape.type() != ShapeType::chain)
                ends.assign(shape.vertices().begin(), shape.vertices().end());
            for (const Vec2& corner : ends) {
                // From outside towards the inside of it.
                const Position at = body.world_point(corner);
                const Vec2 way = at - body.world_point({0, -0.01f});
                for (const float far : {0.5f, 3.0f, 20.0f}) {
                    INFO(int(shape.type()) << " " << corner.x << " " << corner.y);
                    CHECK(world.cast_ray(at + far * way, at - 0.3f * way));
                    ++calls;
                }
            }
            body.destroy();
        }
    }
    REQUIRE(calls > 9000);
}

struct Draws {
    std::mt19937 engine;
    explicit Draws(uint32_t seed) : engine(seed) {}
    float between(float low, float high) {
        return low + (high - low) * float(engine() % 65536) / 65536;
    }
};

/// Every kind of shape that a ray can meet.
std::vector<Geometry> one_of_each_kind() {
    Polygon round;
    for (int i = 0; i < 100; ++i)
        round.vertices.push_back({2 * std::cos(0.0628f * i), std::sin(0.0628f * i)});
    return {Circle{},
            Box{.angle = 0.5f},
            Ellipse{},
            Segment{.from = {-1, 0}, .to = {1, 0.5f}, .rounding = 0.3f},
            Polygon{{{-1, -1}, {1, -1}, {0, 1}}},
            Polygon{{{-1, -1}, {1, -1}, {0, 1}}, 0.2f},
            Concave{{{-1, -1}, {1, -1}, {0.2f, -0.6f}, {0, 1}}},
            Chain{.points = {{-1, 0}, {0, 0.5f}, {1, 0}}},
            round};
}

TEST_CASE("a long ray meets what a short one meets") {
    for (const Geometry& geometry : one_of_each_kind()) {
        World world;
        world.create_body({.type = BodyType::static_body, .position = {3, 5}}).add(geometry);
        Draws draw(7);
        for (int i = 0; i < 2000; ++i) {
            const float angle = draw.between(0, 6.2832f);
            const Vec2 from = Vec2{3, 5} + 10 * Vec2{std::cos(angle), std::sin(angle)};
            const Vec2 aim = {draw.between(2, 4), draw.between(4, 6)};
            const Vec2 way = (aim - from).normalized();
            const auto near = world.cast_ray(from, from + 20 * way);
            for (const float length : {1e3f, 1e5f, 1e6f, 5e7f}) {
                const auto far = world.cast_ray(from, from + length * way);
                CAPTURE(geometry.index(), i, length);
                REQUIRE(far.has_value() == near.has_value());
                if (near)
                    REQUIRE(far->fraction * length == Approx(near->fraction * 20).margin(0.001));
            }
        }
    }
}

TEST_CASE("a ray from far away has a normal of length 1 that faces it") {
    for (const Geometry& geometry : one_of_each_kind()) {
        World world;
        world.create_body({.type = BodyType::static_body, .position = {3, 5}}).add(geometry);
        Draws draw(8);
        for (int i = 0; i < 5000; ++i) {
            const float angle = draw.between(0, 6.2832f);
            const Vec2 from = 3e7f * Vec2{std::cos(angle), std::sin(angle)};
            const Vec2 to = {draw.between(2, 4), draw.between(4, 6)};
            const auto hit = world.cast_ray(from, to);
            if (!hit) continue;
            CAPTURE(geometry.index(), i, from, to);
            REQUIRE(hit->normal.length() == Approx(1).margin(1e-4));
            REQUIRE(hit->normal.dot((to - from).normalized()) <= 1e-6f);
        }
    }
}

TEST_CASE("an AABB query does not find shapes of which only the bounding box overlaps") {
    World world;
    Body diamond = world.create_body({.angle = 0.785398f});
    Shape shape = diamond.add(Box{.width = 2, .height = 2});
    REQUIRE(world.query_aabb({{-0.1f, -0.1f}, {0.1f, 0.1f}}) == std::vector<Shape>{shape});
    REQUIRE(world.query_aabb({{1.2f, 1.2f}, {1.4f, 1.4f}}).empty());
    REQUIRE(world.query_aabb({{-9, -9}, {9, 9}}).size() == 1);
    add_ball(world, {5, 0}, 1.0f);
    REQUIRE(world.query_aabb({{5.9f, -0.1f}, {7, 0.1f}}).size() == 1);
    REQUIRE(world.query_aabb({{5.8f, 0.8f}, {7, 2}}).empty());
}

TEST_CASE("queries find what their filter accepts") {
    World world;
    Body a = add_ball(world, {0, 0}, 1.0f, {.category = 2});
    Body b = add_ball(world, {0, 0}, 1.0f, {.category = 4, .mask = 8});
    Body c = add_ball(world, {0, 0}, 1.0f, {.sensor = true});
    REQUIRE(world.query_point({0, 0}).size() == 2);
    REQUIRE(world.query_point({0, 0}, {.mask = 2}) == a.shapes());
    REQUIRE(world.query_point({0, 0}, {.category = 8, .mask = 4}) == b.shapes());
    REQUIRE(world.query_point({0, 0}, {.category = 1, .mask = 4}).empty());
    REQUIRE(world.query_point({0, 0}, {.sensors = true}).size() == 3);
    const auto only_c = world.query_point(
        {0, 0}, {.sensors = true, .accept = [&](const Shape& s) { return s.body() == c; }});
    REQUIRE(only_c == c.shapes());
}

TEST_CASE("a ray agrees with brute force over many random shapes") {
    World world;
    std::vector<Body> balls;
    uint32_t seed = 1;
    auto random = [&seed] {
        seed = seed * 1664525u + 1013904223u;
        return float(seed >> 8) / 16777216.0f;
    };
    for (int i = 0; i < 300; ++i) {
        balls.push_back(
            world.create_body({.position = {random() * 100 - 50, random() * 100 - 50}}));
        balls.back().add(Circle{.radius = 0.2f + random()});
    }
    for (int i = 0; i < 200; ++i) {
        const Vec2 from = {random() * 120 - 60, random() * 120 - 60},
                   to = {random() * 120 - 60, random() * 120 - 60};
        float nearest = 2.0f;
        for (Body ball : balls) {
            const Vec2 d = to - from, m = from - ball.position();
            const float r = ball.shapes()[0].radius();
            const float b = m.dot(d), c = m.length_squared() - r * r, a = d.length_squared();
            if (c < 0 || b * b - a * c < 0) continue;
            const float t = (-b - std::sqrt(b * b - a * c)) / a;
            if (t >= 0 && t <= 1) nearest = std::min(nearest, t);
        }
        const auto hit = world.cast_ray(from, to);
        REQUIRE(bool(hit) == (nearest <= 1.0f));
        if (hit) REQUIRE(hit->fraction == Approx(nearest).margin(1e-4));
    }
}

}  // namespace query_test
