#include <collision/large_polygon.h>
#include <distance/distance.h>

#include "catch.h"
#include "twofold.h"

namespace large_polygon_test {

using namespace scenes;
using namespace fettle::physics::detail;

TEST_CASE("bisection finds the same farthest vertex as a search of all vertices") {
    std::mt19937 random(3);
    for (int count : {3, 8, 9, 10, 17, 64, 255, 1000, 4096}) {
        const Twofold shape(random, count, 0.0f);
        const Convex form = shape.convex();
        std::uniform_real_distribution<float> angle(0.0f, 6.2831853f);
        for (int i = 0; i < 200; ++i) {
            const float t =
                i < count ? std::atan2(form.normals[i].y, form.normals[i].x) : angle(random);
            const Vec2 d = {std::cos(t), std::sin(t)};
            float most = -1e30f;
            for (int k = 0; k < count; ++k) most = std::max(most, dot(d, form.vertices[k]));
            REQUIRE(dot(d, form.vertices[farthest_vertex(form, d)]) == Approx(most).margin(1e-6));
        }
    }
}

TEST_CASE("contacts of large polygons are those of a search of all edges") {
    std::mt19937 random(5);
    std::uniform_real_distribution<float> angle(0.0f, 6.2831853f), gap(-0.2f, 0.03f);
    int met = 0, apart = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        const int counts[] = {4, 9, 12, 30, 100, 500};
        const int count_a = counts[random() % 6],
                  count_b = std::max(counts[random() % 6], count_a == 4 ? 9 : 4);
        const float rounding = trial % 2 ? 0.1f : 0.0f;
        const Twofold a(random, count_a, rounding), b(random, count_b, 0.5f * rounding);
        const float t = angle(random);
        const Vec2 d = {std::cos(t), std::sin(t)};
        const float reach = dot(d, a.convex().vertices[farthest_vertex(a.convex(), d)]) -
                            dot(d, b.convex().vertices[farthest_vertex(b.convex(), -d)]);
        const Vec2 offset = (reach + a.radius + b.radius + gap(random)) * d;
        Manifold fast, slow;
        collide_large(a.large(), b.large(), offset, 0.02f, fast);
        collide(a.convex(), b.convex(), offset, 0.02f, slow);
        INFO(trial << ": " << count_a << " and " << count_b);
        REQUIRE(fast.count == slow.count);
        ++(fast.count > 0 ? met : apart);
        if (fast.count == 0) continue;
        CHECK(dot(fast.normal, slow.normal) > 0.999f);
        for (int k = 0; k < fast.count; ++k) {
            CHECK(fast.points[k].separation == Approx(slow.points[k].separation).margin(1e-4));
            CHECK(length(fast.points[k].anchor_a - slow.points[k].anchor_a) < 0.02f);
        }
    }
    REQUIRE(met > 500);
    REQUIRE(apart > 100);
}

TEST_CASE("distances to large polygons are those of a search of all edges") {
    std::mt19937 random(11);
    std::uniform_real_distribution<float> angle(0.0f, 6.2831853f), gap(0.01f, 3.0f);
    for (int trial = 0; trial < 500; ++trial) {
        const Twofold a(random, trial % 2 ? 40 : 300, 0.05f), b(random, trial % 3 ? 5 : 60, 0.0f);
        const float t = angle(random);
        const Vec2 d = {std::cos(t), std::sin(t)};
        const float reach = dot(d, a.convex().vertices[farthest_vertex(a.convex(), d)]) -
                            dot(d, b.convex().vertices[farthest_vertex(b.convex(), -d)]);
        const Vec2 offset = (reach + 0.05f + gap(random)) * d;
        const Nearest fast = nearest_points(a.large(), b.large(), offset);
        const Nearest slow = nearest_points(a.convex(), b.convex(), offset);
        CHECK(fast.distance == Approx(slow.distance).margin(1e-5));
        CHECK(dot(fast.normal, slow.normal) > 0.9999f);
    }
}

TEST_CASE("a polygon of four thousand vertices rolls like a disc") {
    Chain chain;
    for (int i = 0; i <= 400; ++i) chain.points.push_back({float(i - 200), 0.0f});
    const Geometry surface = GENERATE_COPY(
        Geometry(Box{.width = 400, .height = 1, .center = {0, -0.5f}}), Geometry(chain));
    INFO("surface: " << surface.index());
    World world({.sleeping = false});
    const float slope = 0.2f;
    Body ground = world.create_body({.type = BodyType::static_body, .angle = -slope});
    ground.add(surface);
    Body body =
        world.create_body({.position = Vec2(0.5f * std::sin(slope), 0.5f * std::cos(slope))});
    Shape shape = body.add(Polygon{ellipse_points(0.5f, 0.5f, 4096)});
    REQUIRE(shape.vertices().size() == 4096);
    REQUIRE(body.mass() == Approx(3.14159265f * 0.25f).epsilon(1e-4));
    run(world, 2.0f);
    const double expected = 2.0 / 3.0 * 10.0 * std::sin(double(slope)) * 2.0;
    REQUIRE(double(body.velocity().length()) == Approx(expected).epsilon(0.01));
    REQUIRE_FALSE(world.validate());
    // Queries of the polygon.
    const Position center = body.world_center();
    REQUIRE(shape.contains(center + Vec2(0, 0.49f)));
    REQUIRE_FALSE(shape.contains(center + Vec2(0, 0.51f)));
    const auto hit = world.cast_ray(center + Vec2(3, 0), center);
    REQUIRE(hit);
    REQUIRE(hit->point.x == Approx(center.x + 0.5f).margin(1e-3));
    REQUIRE(shape.aabb().max.x == Approx(center.x + 0.5f).margin(1e-3));
    const auto corners = shape.world_vertices();
    REQUIRE(corners.size() == 4096);
    for (const Position& v : corners) REQUIRE((v - center).length() == Approx(0.5f).margin(1e-3));
}

TEST_CASE("polygons of many vertices pile up with every other shape") {
    World world({.bounds = Aabb{{-6, 0}, {6, 60}}});
    std::vector<Body> bodies;
    for (int i = 0; i < 90; ++i) {
        Body body = world.create_body(
            {.position = {float(i % 6) * 1.9f - 4.75f, 1.5f + 1.6f * float(i / 6)},
             .angle = float(i)});
        const std::vector<Vec2> points = ellipse_points(0.7f, 0.4f, 9 + 7 * (i % 11));
        if (i % 6 == 0)
            body.add(Circle{.radius = 0.5f});
        else if (i % 6 == 1)
            body.add(Box{});
        else if (i % 6 == 2)
            body.add(Ellipse{0.6f, 0.4f});
        else
            body.add(Polygon{points, i % 2 ? 0.05f : 0.0f});
        bodies.push_back(body);
    }
    Body ground = world.create_body({.type = BodyType::static_body});
    ground.add(Chain{{{-6, 2}, {-3, 0.5f}, {0, 1}, {3, 0.5f}, {6, 2}}});
    run(world, 12.0f);
    double energy = 0.0;
    float deepest = 0.0f;
    for (Body body : bodies) {
        energy += double(body.kinetic_energy());
        CHECK(body.position().y > 0.0f);
    }
    for (const Contact& contact : world.contacts())
        for (int k = 0; k < contact.point_count; ++k)
            deepest = std::min(deepest, contact.points[size_t(k)].separation);
    CHECK(energy < 1.0);
    CHECK(deepest > -0.03f);
    REQUIRE_FALSE(world.validate());
}

}  // namespace large_polygon_test
