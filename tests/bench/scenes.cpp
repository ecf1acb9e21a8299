// Step times are comparable only if the scenes match their descriptions.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <string>

#include "catch.h"
#include "scenes/catalogue.h"

using namespace fettle::bench;

namespace {

std::ptrdiff_t count(const Scene& scene, Motion motion) {
    return std::ranges::count(scene.bodies, motion, &SceneBody::motion);
}

const SceneBody& last(const Scene& scene) {
    return scene.bodies.back();
}

/// Twice the signed area of three consecutive corners: positive if they turn left.
float turn(Point a, Point b, Point c) {
    return (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x);
}

bool is_convex(const PolygonShape& polygon) {
    const auto& v = polygon.vertices;
    for (std::size_t i = 0; i < v.size(); ++i) {
        if (turn(v[i], v[(i + 1) % v.size()], v[(i + 2) % v.size()]) <= 0) return false;
    }
    return v.size() >= 3;
}

}  // namespace

TEST_CASE("the large pyramid has a hundred rows") {
    const Scene scene = large_pyramid();
    CHECK(scene.steps == 500);
    CHECK_FALSE(scene.sleeping);
    CHECK(count(scene, Motion::fixed) == 1);
    CHECK(count(scene, Motion::dynamic) == 5050);
    CHECK(scene.bodies[1].position == Point{-49.5f, 0.5f});
    CHECK(last(scene).position == Point{0, 99.5f});
}

TEST_CASE("there are four hundred small pyramids on twenty grounds") {
    const Scene scene = many_pyramids();
    CHECK(scene.steps == 200);
    CHECK_FALSE(scene.sleeping);
    CHECK(count(scene, Motion::fixed) == 20);
    CHECK(count(scene, Motion::dynamic) == 400 * 55);
    CHECK(last(scene).position == Point{-110 + 11 * 19 + 1 + 4.5f, 11 * 19 + 9.5f});
}

TEST_CASE("the grid hangs from seven circles and all neighbors are connected") {
    const Scene scene = joint_grid();
    CHECK(scene.bodies.size() == 10000);
    CHECK(count(scene, Motion::fixed) == 7);
    // Each body has two joints, except in the first row and the first column; the seven fixed
    // bodies are neighbors and have no joints with each other.
    CHECK(scene.joints.size() == 2 * 100 * 99 - 6);
    for (const SceneJoint& joint : scene.joints) {
        const Point a = scene.anchor_a(joint), b = scene.anchor_b(joint);
        REQUIRE(std::hypot(a.x, a.y) == 0.5f);
        REQUIRE(b == Point{-a.x, -a.y});
    }
}

TEST_CASE("the tumbler is a dynamic drum that a motor turns") {
    const Scene scene = tumbler();
    CHECK(scene.steps == 750);
    CHECK(count(scene, Motion::dynamic) == 1 + 45 * 45);
    CHECK(scene.bodies[1].shapes.size() == 4);
    REQUIRE(scene.joints.size() == 1);
    CHECK(scene.joints[0].motor_speed == Approx(0.436332));
    CHECK(scene.anchor_b(scene.joints[0]) == Point{0, 0});
}

TEST_CASE("only the ram of the smash scene is awake") {
    const Scene scene = smash();
    CHECK(scene.steps == 300);
    CHECK(scene.gravity == Point{0, 0});
    CHECK(count(scene, Motion::dynamic) == 1 + 120 * 80);
    CHECK(std::ranges::count(scene.bodies, true, &SceneBody::awake) == 1);
    CHECK(scene.bodies[0].awake);
    CHECK(scene.bodies[0].velocity == Point{40, 0});
    CHECK(scene.bodies[0].shapes[0].density == 8);
}

TEST_CASE("each compound has two triangles") {
    const Scene scene = compounds();
    CHECK(count(scene, Motion::fixed) == 81 + 200 + 1);
    CHECK(count(scene, Motion::dynamic) == 20 * 150);
    CHECK(last(scene).shapes.size() == 2);
    CHECK(last(scene).shapes[0].friction == 0.5f);
    CHECK(last(scene).position.x == Approx(2 * 19 - 19 - 0.25));
    CHECK(last(scene).position.y == Approx(2.25 * 149 + 5.575));
}

TEST_CASE("the washer is a drum with four fins around its load") {
    const Scene scene = washer();
    REQUIRE(count(scene, Motion::kinematic) == 1);
    CHECK(scene.bodies[0].shapes.size() == 36 + 4);
    CHECK(scene.bodies[0].angular_velocity == Approx(0.436332));
    CHECK(count(scene, Motion::dynamic) == 90 * 90);
    CHECK(last(scene).shapes[0].hit_events);
    for (const SceneBody& body : scene.bodies) {
        if (body.motion != Motion::dynamic) continue;
        REQUIRE(std::hypot(body.position.x, body.position.y - 10) < 16);
    }
}

TEST_CASE("one body that moves on a path pushes the bodies of the junkyard") {
    const Scene scene = junkyard();
    CHECK(scene.steps == 800);
    CHECK(count(scene, Motion::fixed) == 161 + 100);
    CHECK(count(scene, Motion::dynamic) == 200 * 40);
    REQUIRE(count(scene, Motion::kinematic) == 1);
    const auto pusher = std::ranges::find(scene.bodies, Motion::kinematic, &SceneBody::motion);
    REQUIRE(pusher->path);
    CHECK(pusher->path(0) == Point{0, 0});
    CHECK(pusher->path(2.5 * std::acos(-1.0)).x == Approx(60));
}

TEST_CASE("the crowd has ten thousand bodies that stay awake") {
    const Scene scene = crowd();
    CHECK(count(scene, Motion::dynamic) == 10000);
    CHECK_FALSE(scene.sleeping);
    CHECK(count(crowd_of(100, 3), Motion::dynamic) == 300);
}

TEST_CASE("every polygon of a scene is convex and counter-clockwise") {
    for (const CatalogueEntry& entry : catalogue()) {
        INFO(entry.name);
        std::size_t polygons = 0;
        bool convex = true;
        for (const SceneBody& body : entry.make().bodies) {
            for (const SceneShape& shape : body.shapes) {
                const auto* polygon = std::get_if<PolygonShape>(&shape.geometry);
                if (!polygon) continue;
                ++polygons;
                convex = convex && is_convex(*polygon);
            }
        }
        CHECK(convex);
        if (entry.name == "junkyard") CHECK(polygons == 8000);
    }
}

TEST_CASE("a scene is found by its name and an unknown name is reported") {
    std::set<std::string> names;
    for (const CatalogueEntry& entry : catalogue()) {
        CHECK(names.insert(std::string(entry.name)).second);
        CHECK(entry.make().name == entry.name);
    }
    CHECK(scene_named("smash").make == &smash);
    CHECK_THROWS_WITH(scene_named("smsh"), contains("there are large_pyramid, many"));
}

TEST_CASE("the rain adds a column of twenty five ragdolls every eight steps") {
    const Scene scene = rain();
    CHECK(scene.steps == 1000);
    CHECK(scene.bodies.size() == 5);
    CHECK(scene.bodies[4].shapes.size() == 501);
    REQUIRE(scene.groups.size() == 40);
    CHECK(scene.groups[0].bodies.size() == 25 * 11);
    CHECK(scene.groups[0].joints.size() == 25 * 10);
    CHECK(scene.groups[0].bodies[0].position == Point{-121.875f, 40.95f});
    CHECK(scene.arrivals.size() == 125);
    CHECK(scene.arrivals[41].step == 328);
    CHECK(scene.arrivals[41].group == 1);
    CHECK(scene.runs_on("fettle"));
    CHECK_FALSE(scene.runs_on("box2d"));
}

TEST_CASE("the spinner moves six thousand bodies in a ring") {
    const Scene scene = spinner();
    const auto& ring = std::get<ChainShape>(scene.bodies[0].shapes.at(0).geometry);
    CHECK(ring.closed);
    CHECK(ring.points.size() == 360);
    CHECK(count(scene, Motion::dynamic) == 6077);
    CHECK_FALSE(scene.bodies[1].can_sleep);
    CHECK(last(scene).position == Point{-23 + 0.5f * 3, 2 + 0.5f * 66});
    CHECK(scene.runs_on("chipmunk"));
    CHECK_FALSE(scene.runs_on("box2d"));
}
