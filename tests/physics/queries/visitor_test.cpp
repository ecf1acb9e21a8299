#include "catch.h"
#include "scenes.h"

// Visitors of queries: they get what the lists have, and end a query.

namespace visitor_test {

using namespace scenes;

namespace {

/// A floor that is a chain, boxes and balls on it, and a body with an outline of several parts.
void fill(World& world) {
    std::vector<Vec2> points;
    for (int i = 0; i <= 40; ++i) points.push_back({float(i - 20), i % 2 == 0 ? 0.0f : 0.2f});
    world.create_body({.type = BodyType::static_body}).add(Chain{.points = points});
    for (int i = 0; i < 12; ++i) add_box(world, {float(i) - 6.0f, 0.8f});
    for (int i = 0; i < 6; ++i) add_ball(world, {2.0f * float(i) - 6.0f, 2.0f});
    const std::vector<Vec2> angle = {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}};
    world.create_body({.position = {-1, 3}}).add(Concave{angle});
    run(world, 0.5f);
}

const Aabb all = {{-30, -5}, {30, 20}};
const Position left = {-30, 0.5f}, right = {30, 0.9f};

/// What a visitor gets.
template <class Found, class Query>
std::vector<Found> found_by(Query&& query) {
    std::vector<Found> list;
    query([&](const Found& found) { list.push_back(found); });
    return list;
}

}  // namespace

TEST_CASE("a visitor gets what the list of a query has") {
    World world;
    fill(world);
    const Shape probe = world.create_shape(Concave{{{-9, 0}, {9, 0}, {9, 4}, {0, 1}, {-9, 4}}});
    for (const QueryFilter& filter : {QueryFilter(), QueryFilter{.accept = [](const Shape& shape) {
                                          return shape.type() != ShapeType::circle;
                                      }}}) {
        CHECK(found_by<Shape>([&](auto visitor) { world.visit_aabb(all, visitor, filter); }) ==
              world.query_aabb(all, filter));
        CHECK(found_by<Shape>([&](auto visitor) {
                  world.visit_point({0, 3.5f}, visitor, filter);
              }) == world.query_point({0, 3.5f}, filter));
        CHECK(found_by<Shape>([&](auto visitor) { world.visit_overlap(probe, visitor, filter); }) ==
              world.query_overlap(probe, filter));
        CHECK(found_by<Shape>([&](auto visitor) {
                  world.visit_overlap(Box{9, 4}, {{0, 1}, 0.2f}, visitor, filter);
              }) == world.query_overlap(Box{9, 4}, {{0, 1}, 0.2f}, filter));
        auto hits =
            found_by<RayHit>([&](auto visitor) { world.visit_ray(left, right, visitor, filter); });
        const auto listed = world.cast_ray_all(left, right, filter);
        REQUIRE(listed.size() > 5);
        std::sort(hits.begin(), hits.end(),
                  [](const RayHit& a, const RayHit& b) { return a.fraction < b.fraction; });
        REQUIRE(hits.size() == listed.size());
        for (size_t i = 0; i < hits.size(); ++i) {
            CHECK(hits[i].fraction == listed[i].fraction);
            CHECK(hits[i].point == listed[i].point);
        }
    }
    REQUIRE(world.query_aabb(all).size() == 20);
}

TEST_CASE("a visitor ends a query and may begin others") {
    World world;
    fill(world);
    int calls = 0;
    world.visit_aabb(all, [&](const Shape&) { return ++calls < 3; });
    CHECK(calls == 3);
    world.visit_ray(left, right, [&](const RayHit&) { return ++calls < 4; });
    CHECK(calls == 4);
    // The inner query finds the outline although the outer query has found it before.
    size_t inside = 0, outside = 0;
    world.visit_aabb(all, [&](const Shape&) {
        ++outside;
        world.visit_aabb(all, [&](const Shape&) { ++inside; });
    });
    CHECK(outside == 20);
    CHECK(inside == 20 * 20);
}

TEST_CASE("a copy of a visitor calls the same function") {
    World world;
    fill(world);
    int first = 0, second = 0;
    const auto count_first = [&](const Shape&) { ++first; };
    const auto count_second = [&](const Shape&) { ++second; };
    Visitor<Shape> visitor = count_first;
    const Visitor<Shape> copy = visitor;
    Visitor<Shape> moved = std::move(visitor);
    visitor = count_second;
    world.visit_aabb(all, copy);
    world.visit_aabb(all, moved);
    CHECK(first == 40);
    CHECK(second == 0);
    world.visit_aabb(all, visitor);
    CHECK(second == 20);
}

TEST_CASE("a visitor that edits or throws or destroys the world is an error without damage") {
    World world;
    fill(world);
    CHECK_THROWS_WITH(world.visit_aabb(all, [&](Shape shape) { shape.destroy(); }),
                      contains("inside the visitor of a query"));
    CHECK_THROWS_AS(world.visit_ray(left, right, [](const RayHit&) { throw 5; }), int);
    CHECK_THROWS_AS(world.visit_point({0, NAN}, [](const Shape&) {}), std::invalid_argument);
    CHECK_FALSE(world.locked());
    CHECK_FALSE(world.validate());
    CHECK(found_by<Shape>([&](auto visitor) { world.visit_aabb(all, visitor); }).size() == 20);
    auto dying = std::make_unique<World>();
    fill(*dying);
    World& raw = *dying;
    CHECK_THROWS_WITH(raw.visit_aabb(all, [&](const Shape&) { dying.reset(); }),
                      contains("destroyed inside the visitor"));
}

}  // namespace visitor_test
