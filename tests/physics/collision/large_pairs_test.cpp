#include <collision/ellipse.h>
#include <distance/distance.h>

#include <set>

#include "catch.h"
#include "twofold.h"

namespace large_pairs_test {

using namespace scenes;
using namespace fettle::physics::detail;

// Large polygons with every other kind of shape: the results are those of a search of all vertices.

namespace {

Vec2 direction_of(float angle) {
    return {std::cos(angle), std::sin(angle)};
}

EllipseForm any_ellipse(std::mt19937& random) {
    std::uniform_real_distribution<float> angle(0.0f, 6.2831853f), radius(0.1f, 2.0f);
    return {{0.2f, -0.3f}, direction_of(angle(random)), radius(random), radius(random)};
}

/// How far the two are apart along a direction that leads from the ellipse to the polygon.
float separation_along(Vec2 d, const EllipseForm& ellipse, const Convex& polygon, Vec2 offset) {
    float nearest = 1e30f;
    for (int i = 0; i < polygon.count; ++i) nearest = min(nearest, dot(d, polygon.vertices[i]));
    return nearest + dot(d, offset - ellipse.center) - ellipse.reach(d);
}

/// The greatest separation: along the normal of an edge, or from the rim to a vertex.
float separation_of_all(const EllipseForm& ellipse, const Convex& polygon, Vec2 offset) {
    float most = -1e30f;
    for (int i = 0; i < polygon.count; ++i) {
        const Vec2 from_rim = nearest_on_rim(ellipse, polygon.vertices[i] + offset).normal;
        for (Vec2 d : {-polygon.normals[i], from_rim})
            most = max(most, separation_along(d, ellipse, polygon, offset));
    }
    return most;
}

/// The offset of a polygon that puts it `gap` (m) away from the ellipse along `d`.
Vec2 beside(const EllipseForm& ellipse, const Convex& polygon, Vec2 d, float gap) {
    return (gap - separation_along(d, ellipse, polygon, {})) * d;
}

}  // namespace

TEST_CASE("a search for the deepest of many edges evaluates only a few times their logarithm") {
    std::mt19937 random(17);
    std::uniform_real_distribution<float> angle(0.0f, 6.2831853f), gap(-0.02f, 3.0f);
    for (int count : {16, 128, 1024}) {
        for (int trial = 0; trial < 200; ++trial) {
            const Twofold shape(random, count, 0.0f);
            const Convex form = shape.convex();
            const EllipseForm ellipse = any_ellipse(random);
            const Vec2 offset = beside(ellipse, form, direction_of(angle(random)), gap(random));
            const Vec2 center = ellipse.center - offset;
            int looked_at = 0;
            const EdgeGap found = deepest_edge(Facets(form), center, [&](Vec2 n) {
                ++looked_at;
                return dot(n, center) - ellipse.reach(n);
            });
            float most = -1e30f;
            for (int i = 0; i < count; ++i) {
                const Vec2 n = form.normals[i];
                most = max(most, dot(n, center) - ellipse.reach(n) - form.offsets[i]);
            }
            REQUIRE(found.separation == Approx(most).margin(1e-5));
            CHECK(looked_at <= 10 + 4 * std::log2(count));
        }
    }
}

TEST_CASE("the distance between an ellipse and a large polygon is that of a search of all edges") {
    std::mt19937 random(23);
    std::uniform_real_distribution<float> angle(0.0f, 6.2831853f), gap(-0.05f, 2.0f);
    for (int trial = 0; trial < 300; ++trial) {
        const Twofold shape(random, trial % 2 ? 30 : 200, 0.0f);
        const Convex form = shape.convex();
        const EllipseForm ellipse = any_ellipse(random);
        const Vec2 offset = beside(ellipse, form, direction_of(angle(random)), gap(random));
        const float expected = separation_of_all(ellipse, form, offset);
        const EllipseGap found = gap_between(ellipse, form, offset);
        INFO(trial);
        CHECK(found.separation == Approx(expected).margin(1e-5));
        CHECK(separation_along(found.normal, ellipse, form, offset) ==
              Approx(expected).margin(1e-5));
        // The same in the frame of the polygon.
        const Vec2 vertices[2] = {ellipse.center, {ellipse.first, ellipse.second}};
        const Solid round = {{vertices, &ellipse.axis, nullptr, 1, 0.0f}, FormKind::ellipse};
        const Nearest near = nearest_points(round, shape.large(), offset);
        CHECK(near.distance == Approx(max(0.0f, expected)).margin(1e-5));
        const Nearest back = nearest_points(shape.large(), round, -offset);
        CHECK(back.distance == Approx(near.distance).margin(1e-5));
        if (expected < 1e-3f) continue;
        CHECK(length(near.on_b - near.on_a - near.distance * near.normal) < 1e-4f);
        CHECK(separation_along(near.normal, ellipse, form, offset) ==
              Approx(expected).margin(1e-4));
        CHECK(length(back.on_a + offset - near.on_b) < 2e-3f);
    }
}

TEST_CASE("rays and points find large polygons as in a search of all edges") {
    std::mt19937 random(29);
    std::uniform_real_distribution<float> angle(0.0f, 6.2831853f), far(0.0f, 5.0f);
    int hits = 0, inside = 0;
    for (int trial = 0; trial < 3000; ++trial) {
        const int counts[] = {9, 10, 33, 500};
        const Twofold shape(random, counts[trial % 4], trial % 3 ? 0.2f : 0.0f);
        const Convex form = shape.convex();
        const Vec2 p = far(random) * direction_of(angle(random));
        const Vec2 d = 2.0f * far(random) * direction_of(angle(random));
        float outside = -1e30f, distance = 1e30f, first = 2.0f;
        for (int i = 0; i < form.count; ++i) {
            outside = max(outside, dot(form.normals[i], p) - form.offsets[i]);
            const Vec2 ends[2] = {form.vertices[i], form.vertices[(i + 1) % form.count]};
            const Vec2 normals[2] = {form.normals[i], -form.normals[i]};
            const float offsets[2] = {form.offsets[i], -form.offsets[i]};
            const Convex edge = {ends, normals, offsets, 2, form.radius};
            distance = min(distance, signed_distance(edge, p));
            first = min(first, cast_segment(edge, p, d).fraction);
        }
        if (std::fabs(outside) < 1e-4f || std::fabs(distance) < 1e-4f) continue;
        const float found = signed_distance(shape.large(), p);
        const Probe probe = cast_segment(shape.large(), p, d);
        INFO(trial);
        if (outside < 0.0f || distance < 0.0f) {
            ++inside;
            CHECK(found < 0.0f);
            CHECK(probe.fraction > 1.0f);
            continue;
        }
        CHECK(found == Approx(distance).margin(1e-5));
        // One that only just touches may be seen either way.
        if (probe.fraction > 1.0f && first <= 1.0f) {
            const Vec2 deeper = p + (first + 0.01f) * d;
            CHECK(signed_distance(form, deeper) > -1e-3f);
            continue;
        }
        REQUIRE((probe.fraction > 1.0f) == (first > 1.0f));
        if (probe.fraction > 1.0f) continue;
        ++hits;
        CHECK(probe.fraction == Approx(first).margin(1e-4));
        const Vec2 at = p + probe.fraction * d;
        CHECK(signed_distance(form, at + 0.01f * probe.normal) == Approx(0.01f).margin(1e-3));
    }
    REQUIRE(hits > 300);
    REQUIRE(inside > 300);
}

namespace {

struct Touch {
    float separation = 1e30f;  ///< the least
    Vec2 normal = {};
    int points = 0;
};

/// The touch of a polygon of many vertices next to a fixed geometry.
Touch touch_of(const Geometry& fixed, const Polygon& polygon, const Pose& pose) {
    World world({.gravity = {0, 0}, .sleeping = false});
    Body ground = world.create_body({.type = BodyType::static_body});
    ground.add(fixed);
    Body body = world.create_body({.position = pose.position, .angle = pose.angle});
    body.add(polygon);
    world.step(1e-5f);
    Touch touch;
    for (const Contact& contact : world.contacts()) {
        for (int k = 0; k < contact.point_count; ++k) {
            ++touch.points;
            if (contact.points[size_t(k)].separation >= touch.separation) continue;
            touch.separation = contact.points[size_t(k)].separation;
            touch.normal = contact.normal;
            if (contact.body_b != body.id()) touch.normal = -touch.normal;
        }
    }
    return touch;
}

}  // namespace

TEST_CASE("large polygons meet pieces of outlines as they meet the convex polygon of these") {
    std::mt19937 random(31);
    std::uniform_real_distribution<float> angle(0.0f, 6.2831853f), gap(-0.02f, 0.01f);
    const std::vector<Vec2> outline = {{1.5f, -0.4f}, {1.3f, 0.7f},   {0.2f, 1.1f},
                                       {-1.2f, 0.9f}, {-1.6f, -0.3f}, {-0.1f, -1.2f}};
    const std::vector<Vec2> clockwise(outline.rbegin(), outline.rend());
    int met = 0, behind = 0;
    for (int trial = 0; trial < 400; ++trial) {
        const Polygon polygon{ellipse_points(0.8f, 0.5f, trial % 2 ? 300 : 20),
                              trial % 3 ? 0.0f : 0.1f};
        // Pushed out along some direction until it touches.
        Pose pose{.angle = angle(random)};
        const float t = angle(random);
        const Vec2 d(std::cos(t), std::sin(t));
        World measure;
        Body body = measure.create_body({.angle = pose.angle});
        Shape moving = body.add(polygon);
        Shape fixed = measure.create_body({.type = BodyType::static_body}).add(Polygon{outline});
        body.set_position(4.0f * d);
        const auto hit = measure.cast_shape(moving, -4.0f * d);
        REQUIRE(hit);
        pose.position = (4.0f * (1.0f - hit->fraction) + gap(random)) * d;
        const Touch plain = touch_of(Polygon{outline}, polygon, pose);
        INFO(trial << " " << t << " " << plain.separation);
        const Touch touches[] = {touch_of(Concave{outline}, polygon, pose),
                                 touch_of(Chain{clockwise, true}, polygon, pose)};
        if (plain.points == 0) continue;
        ++met;
        for (const Touch& touch : touches) {
            // A segment does not push what appears for the greater part behind it.
            if (&touch != touches && touch.points == 0) {
                ++behind;
                continue;
            }
            REQUIRE(touch.points > 0);
            // Beside a corner, a segment may push with its face.
            const bool segment = &touch != touches;
            CHECK(touch.separation == Approx(plain.separation).margin(segment ? 5e-4 : 2e-4));
            CHECK(touch.normal.dot(plain.normal) > (segment ? 0.98f : 0.99f));
        }
        REQUIRE(distance(fixed, moving).distance >= 0.0f);
    }
    REQUIRE(met > 300);
    REQUIRE(behind < 5);
}

TEST_CASE("a body that slides over a large polygon in pieces is held by all of them") {
    // A crescent: its outer arc is cut into few pieces of many vertices.
    std::vector<Vec2> crescent;
    for (int i = 0; i <= 200; ++i) {
        const float t = 3.1415927f * float(i) / 200.0f;
        crescent.push_back({3.0f * std::cos(t), 3.0f * std::sin(t)});
    }
    for (int i = 40; i >= 0; --i) {
        const float t = 3.1415927f * float(i) / 40.0f;
        crescent.push_back({2.8f * std::cos(t), 1.5f * std::sin(t)});
    }
    const std::vector<Vec2> wheel = ellipse_points(0.3f, 0.3f, 100);
    for (const Geometry& form : {Geometry(Polygon{wheel}), Geometry(Ellipse{0.3f, 0.29f})}) {
        World world({.sleeping = false});
        Body ground = world.create_body({.type = BodyType::static_body});
        ground.add(Concave{crescent}, {.friction = 0.0f});
        Body body = world.create_body({.position = {0.1f, 3.31f}});
        body.add(form, {.friction = 0.0f});
        // Down the outside, as long as it presses against it: to cos θ = 2/3 and a little before.
        for (int i = 0; i < 300 && body.position().y > 2.6f; ++i) {
            world.step(frame);
            REQUIRE(Vec2(body.position()).length() > 3.1f);
            REQUIRE(Vec2(body.position()).length() < 3.4f);
        }
        CHECK(body.position().y <= 2.6f);
        const float drop = 3.3f - body.position().y;
        INFO(form.index());
        CHECK(body.kinetic_energy() == Approx(10.0f * body.mass() * drop).epsilon(0.05));
    }
}

}  // namespace large_pairs_test
