#include <fettle/physics/geometry.h>
#include <fettle/physics/physics.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "catch.h"

namespace geometry_test {

using namespace fettle::physics;

namespace {

const std::vector<Vec2> l_shape = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};

/// One geometry of each type.
std::vector<Geometry> all_geometries() {
    std::vector<Vec2> many;
    for (int i = 0; i < 24; ++i)
        many.emplace_back(0.8f * std::cos(0.2618f * float(i)), 0.5f * std::sin(0.2618f * float(i)));
    return {Circle{0.4f, {0.1f, -0.2f}},
            Box{1.2f, 0.6f, {0.2f, 0.1f}, 0.4f, 0.1f},
            Segment{{-0.5f, 0.1f}, {0.6f, 0.2f}, 0.15f},
            Polygon{{{0, 0}, {1, 0}, {0.4f, 0.9f}}, 0.05f},
            Polygon{many},
            Ellipse{0.7f, 0.3f, {0.1f, 0.1f}, 0.5f},
            Concave{l_shape},
            Chain{{{-1, 0.1f}, {0, 0}, {1, 0.2f}}}};
}

struct Placed {
    Shape shape;
    Form form;
    Pose pose;
};

/// The geometries in a world that does not move them, and as forms at the same poses.
std::vector<Placed> placed_in(World& world, uint32_t seed, float spread) {
    std::mt19937 random(seed);
    const auto number = [&](float range) {
        return range * (float(random() % 2001) / 1000.0f - 1.0f);
    };
    std::vector<Placed> all;
    for (const Geometry& geometry : all_geometries()) {
        const Pose pose = {{number(spread), number(spread)}, number(3.0f)};
        Body body = world.create_body({.position = pose.position, .angle = pose.angle});
        all.push_back({body.add(geometry), Form(geometry), pose});
    }
    return all;
}

}  // namespace

TEST_CASE("a geometry has the mass of a shape") {
    World world;
    for (const Geometry& geometry : all_geometries()) {
        Body body = world.create_body();
        const Shape shape = body.add(geometry, {.density = 3.0f});
        const MassProperties mass = mass_properties(geometry, 3.0f);
        CHECK(mass.area == shape.area());
        CHECK(mass.mass == Approx(shape.mass()));
        if (shape.type() == ShapeType::chain) {
            CHECK(mass.area == 0.0f);
            continue;
        }
        CHECK((mass.centroid - body.center()).length() < 1e-6f);
        CHECK(mass.inertia == Approx(body.inertia()));
    }
    CHECK(mass_properties(Box{2, 3}).inertia == Approx(6.0f * (4.0f + 9.0f) / 12.0f));
    CHECK(mass_properties(Circle{2}).area == Approx(12.566371f));
}

TEST_CASE("bounding boxes of geometries and shapes are equal") {
    World world;
    for (const Placed& placed : placed_in(world, 1, 3.0f)) {
        const Aabb box = bounding_box(placed.form, placed.pose);
        Aabb expected = placed.shape.aabb();
        if (placed.shape.type() == ShapeType::chain || placed.shape.type() == ShapeType::concave) {
            // The box of an outline in a world is empty: its parts have boxes.
            expected = box;
            for (const Position& v : placed.shape.world_vertices()) {
                CHECK(v.x >= box.min.x - 1e-5f);
                CHECK(v.y <= box.max.y + 1e-5f);
            }
        }
        CHECK((box.min - expected.min).length() < 1e-5f);
        CHECK((box.max - expected.max).length() < 1e-5f);
    }
}

TEST_CASE("points and rays and distances of a geometry agree with those of a world") {
    for (uint32_t seed = 1; seed <= 20; ++seed) {
        World world;
        const auto all = placed_in(world, seed, 1.5f);
        std::mt19937 random(seed);
        for (int i = 0; i < 10; ++i) {
            const Vec2 from(float(random() % 600) / 100.0f - 3.0f,
                            float(random() % 600) / 100.0f - 3.0f);
            const Vec2 to(float(random() % 600) / 100.0f - 3.0f,
                          float(random() % 600) / 100.0f - 3.0f);
            float nearest = 2.0f;
            for (const Placed& placed : all) {
                CHECK(contains(placed.form, placed.pose, from) == placed.shape.contains(from));
                if (const auto hit = cast_ray(placed.form, placed.pose, from, to))
                    nearest = std::min(nearest, hit->fraction);
            }
            const auto hit = world.cast_ray(from, to);
            CHECK(hit.has_value() == (nearest <= 1.0f));
            if (hit) CHECK(hit->fraction == Approx(nearest).margin(1e-5));
        }
        for (const Placed& a : all) {
            for (const Placed& b : all) {
                if (a.shape == b.shape) continue;
                const Separation own = distance(a.form, a.pose, b.form, b.pose);
                const Separation expected = distance(a.shape, b.shape);
                CHECK(own.distance == Approx(expected.distance).margin(1e-5));
                CHECK((own.point_b - own.point_a).length() == Approx(own.distance).margin(1e-4));
            }
        }
    }
}

TEST_CASE("manifolds of geometries agree with the contacts of a world") {
    size_t compared = 0;
    for (uint32_t seed = 1; seed <= 20; ++seed) {
        World world({.gravity = {0, 0}});
        const auto all = placed_in(world, seed, 0.8f);
        world.step(1e-6f);
        for (const Contact& contact : world.contacts()) {
            const Placed *a = nullptr, *b = nullptr;
            for (const Placed& placed : all) {
                if (placed.shape.id() == contact.shape_a) a = &placed;
                if (placed.shape.id() == contact.shape_b) b = &placed;
            }
            // Parts of outlines are shapes of their own.
            if (a == nullptr || b == nullptr || contact.point_count == 0) continue;
            if (a->form.parts().size() > 1 || b->form.parts().size() > 1) continue;
            const auto own = contact_manifolds(a->form, a->pose, b->form, b->pose, 0.01f);
            REQUIRE(own.size() == 1);
            CHECK((own[0].normal - contact.normal).length() < 1e-3f);
            REQUIRE(own[0].point_count == contact.point_count);
            for (size_t i = 0; i < size_t(contact.point_count); ++i)
                CHECK((own[0].points[i].point - contact.points[i].point).length() < 1e-3f);
            ++compared;
        }
    }
    CHECK(compared > 100);
}

TEST_CASE("a box on a concave geometry has a manifold for each part") {
    const Form l = Concave{l_shape};
    CHECK(contact_manifolds(l, {}, Box{}, {{5, 5}, 0}).empty());
    const auto touching = contact_manifolds(l, {}, Box{1, 1}, {{0.5f, 2.49f}, 0});
    REQUIRE(touching.size() == 1);
    CHECK(touching[0].normal.y == Approx(1.0f));
    CHECK(touching[0].point_count == 2);
    CHECK(touching[0].points[0].separation == Approx(-0.01f).margin(1e-4));
}

TEST_CASE("time of impact of two movements") {
    const Form ball = Circle{0.5f}, wall = Box{0.1f, 10};
    const auto t = time_of_impact(ball, {{{-10, 0}, 0}, {{10, 0}, 0}}, wall, {});
    REQUIRE(t);
    CHECK(*t == Approx((10.0f - 0.5f - 0.05f) / 20.0f).margin(1e-4));
    CHECK_FALSE(time_of_impact(ball, {{{-10, 0}, 0}, {{-5, 0}, 0}}, wall, {}));
    CHECK(time_of_impact(ball, {{{0.1f, 0}, 0}, {{5, 0}, 0}}, wall, {}) == 0.0f);
    // Both move.
    const auto both =
        time_of_impact(ball, {{{-2, 0}, 0}, {{2, 0}, 0}}, ball, {{{2, 0}, 0}, {{-2, 0}, 0}});
    REQUIRE(both);
    CHECK(*both == Approx(3.0f / 8.0f).margin(1e-4));
}

TEST_CASE("time of impact of a rotation about a given point") {
    // A rod that turns about its end by a quarter meets a ball above that end.
    const Form rod = Segment{{0, 0}, {2, 0}, 0.1f};
    const auto t = time_of_impact(rod, {{{0, 0}, 0}, {{0, 0}, 1.5707963f}}, Circle{0.1f},
                                  {{{1, 1}, 0}, {{1, 1}, 0}});
    REQUIRE(t);
    const float angle = std::asin(0.2f / std::sqrt(2.0f));
    CHECK(*t == Approx((0.78539816f - angle) / 1.5707963f).margin(1e-3));
    // The same rod, whose middle stays where it is, passes it.
    const Movement about_middle = {{{0, 0}, 0}, {{1, -1}, 1.5707963f}, {1, 0}};
    CHECK_FALSE(time_of_impact(rod, about_middle, Circle{0.1f}, {{{2.5f, 1}, 0}, {{2.5f, 1}, 0}}));
}

TEST_CASE("fast rotations that pass a geometry closely have no time of impact") {
    const Form arm = Circle{0.5f, {3, 0}};
    const Movement turns = {{{0, 0}, 0}, {{0, 0}, 60.0f}};
    const auto beside = [](float x) { return Movement{{{x, 0}, 0}, {{x, 0}, 0}}; };
    CHECK_FALSE(time_of_impact(arm, turns, Circle{0.5f}, beside(-4.002f)));
    // It passes nine times before a wall comes near enough.
    const Movement nearer = {{{-4.1f, 0}, 0}, {{-3.99f, 0}, 0}};
    const auto t = time_of_impact(arm, turns, Circle{0.5f}, nearer);
    REQUIRE(t);
    const float angle = 60.0f * *t;
    const Separation then =
        distance(arm, {{0, 0}, angle}, Circle{0.5f}, {{-4.1f + 0.11f * *t, 0}, 0});
    CHECK(then.distance < 3e-4f);
}

TEST_CASE("an ellipse beyond the tip of a thin geometry is apart from it") {
    // It leans over the tip, so its lowest point is below the inside of the segment.
    const Pose leaning = {{0.3f, 0.1f}, 1.0471976f};
    const Form ellipse = Ellipse{1.0f, 0.1f};
    const Geometry thin[] = {Segment{{-5, 0}, {0, 0}}, Box{5, 0.002f, {-2.5f, 0}},
                             Polygon{{{-5, -0.01f}, {0, 0}, {-5, 0.01f}}}};
    for (const Geometry& geometry : thin) {
        const Separation gap = distance(ellipse, leaning, geometry, {});
        CHECK(gap.distance == Approx(0.1125f).margin(0.001));
        CHECK(contact_manifolds(ellipse, leaning, geometry, {}).empty());
        // A tip that is a little inside is pushed out over the tip, and not to the side.
        const auto overlap = contact_manifolds(ellipse, {{0.169f, 0.1f}, 1.0471976f}, geometry, {});
        REQUIRE(overlap.size() == 1);
        CHECK(overlap[0].points[0].separation > -0.01f);
        CHECK(overlap[0].normal.x < -0.8f);
    }
}

TEST_CASE("points beside flat polygons with many vertices are not in them") {
    // Flat ellipses: the tips are far from the flat sides, and few edges turn round them.
    std::vector<Vec2> points;
    for (int i = 0; i < 30; ++i)
        points.emplace_back(2.0f * std::cos(0.21f * float(i)), 0.2f * std::sin(0.21f * float(i)));
    const Form flat = Polygon{points};
    const std::vector<Vec2> corners = flat.parts()[0];
    int outside = 0;
    for (int column = -60; column <= 60; ++column) {
        for (int row = -25; row <= 25; ++row) {
            const Vec2 p(0.037f * float(column), 0.0173f * float(row));
            float farthest = -1.0f;  // beyond the line of an edge
            for (size_t i = 0; i < corners.size(); ++i) {
                const Vec2 along = corners[(i + 1) % corners.size()] - corners[i];
                farthest = std::max(farthest, (p - corners[i]).cross(along) / along.length());
            }
            if (std::fabs(farthest) < 1e-4f) continue;
            outside += farthest > 0.0f;
            CHECK(contains(flat, {}, p) == (farthest < 0.0f));
            const bool apart = distance(flat, {}, Circle{1e-4f}, {p, 0}).distance > 0.0f;
            CHECK(apart == (farthest > 1e-4f));
        }
    }
    CHECK(outside > 1000);
}

TEST_CASE("convex pieces cover an outline") {
    const auto pieces = convex_pieces(l_shape);
    REQUIRE(pieces.size() == 2);
    float area = 0.0f;
    for (const auto& piece : pieces) area += mass_properties(Polygon{piece}).area;
    CHECK(area == Approx(3.0f));
    const std::vector<Vec2> bow = {{0, 0}, {1, 1}, {1, 0}, {0, 1}};
    CHECK_THROWS_WITH(convex_pieces(bow), contains("crosses"));
}

TEST_CASE("numbers out of range are refused by name") {
    const float nan = std::nanf("");
    CHECK_THROWS_WITH(Form(Circle{nan}), contains("radius"));
    CHECK_THROWS_WITH(contains(Circle{}, {{nan, 0}, 0}, {0, 0}), contains("pose.position"));
    CHECK_THROWS_WITH(contains(Circle{}, {}, {0, nan}), contains("point"));
    CHECK_THROWS_WITH(mass_properties(Circle{}, -1.0f), contains("density"));
    CHECK_THROWS_WITH(contact_manifolds(Circle{}, {}, Circle{}, {}, nan), contains("margin"));
    CHECK_THROWS_WITH(time_of_impact(Circle{}, {{}, {{0, 0}, nan}}, Circle{}, {}),
                      contains("movement_a.to.angle"));
}

}  // namespace geometry_test
