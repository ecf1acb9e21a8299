#include "catch.h"
#include "scenes.h"

namespace shape_query_test {

using namespace scenes;

TEST_CASE("a shape cast stops where the shape first meets another") {
    World world;
    Body box = add_box(world, {5, 0}), far = add_box(world, {9, 0});
    auto hit = world.cast_shape(Circle{.radius = 0.5f}, {{0, 0}, 0}, {10, 0});
    REQUIRE(hit);
    REQUIRE(hit->shape.body() == box);
    REQUIRE(hit->fraction == Approx(0.4f).margin(1e-3));
    REQUIRE(hit->point.x == Approx(4.5f).margin(1e-3));
    REQUIRE(hit->normal.x == Approx(-1.0f));
    // Turned by an eighth, a box is √2/2 long to its corner.
    hit = world.cast_shape(Box{}, {{0, 0}, 3.14159265f / 4}, {10, 0});
    REQUIRE(hit);
    REQUIRE(hit->fraction == Approx((4.5f - std::sqrt(0.5f)) / 10).margin(1e-3));
    REQUIRE_FALSE(world.cast_shape(Circle{}, {{0, 3}, 0}, {10, 0}));
    // Its own body does not stop a shape.
    hit = world.cast_shape(box.shapes()[0], {10, 0});
    REQUIRE(hit);
    REQUIRE(hit->shape.body() == far);
    REQUIRE(hit->fraction == Approx(0.3f).margin(1e-3));
    hit = world.cast_shape(Box{}, {{5.2f, 0}, 0}, {1, 0});
    REQUIRE(hit);
    REQUIRE(hit->fraction == 0.0f);
    world.set_bounds(Aabb{{-20, -20}, {20, 20}});
    hit = world.cast_shape(Circle{}, {{0, 3}, 0}, {0, 40});
    REQUIRE(hit);
    REQUIRE(hit->shape.type() == ShapeType::border);
    REQUIRE(hit->fraction == Approx(16.5f / 40));
}

TEST_CASE("an overlap query finds all shapes that overlap a shape of any kind") {
    World world;
    Body left = add_box(world, {0, 0}), right = add_box(world, {3, 0});
    Body bar = world.create_body({.type = BodyType::static_body, .position = {1.5f, 0}});
    bar.add(Segment{.from = {0, -1}, .to = {0, 1}});
    REQUIRE(world.query_overlap(Circle{.radius = 1.2f}, {{1.5f, 0}, 0}).size() == 3);
    REQUIRE(world.query_overlap(Circle{.radius = 0.9f}, {{1.5f, 0}, 0}).size() == 1);
    // Two segments that cross have no end in each other.
    REQUIRE(world.query_overlap(Segment{.from = {-1, 0}, .to = {1, 0}}, {{1.5f, 0}, 0}).size() ==
            3);
    REQUIRE(
        world.query_overlap(Segment{.from = {-0.4f, 0}, .to = {0.4f, 0}}, {{1.5f, 0}, 0}).size() ==
        1);
    REQUIRE(world.query_overlap(left.shapes()[0]).empty());
    right.set_position({0.9f, 0});
    REQUIRE(world.query_overlap(left.shapes()[0]) == std::vector<Shape>{right.shapes()[0]});
    REQUIRE(world.query_overlap(Circle{.radius = 5}, {}, {.mask = 2}).empty());
}

TEST_CASE("the closest shape to a point is found near and far") {
    World world;
    Body box = add_box(world, {4, 0}), other = add_ball(world, {0, -900}, 1.0f);
    auto hit = world.closest({0, 0});
    REQUIRE(hit);
    REQUIRE(hit->shape.body() == box);
    REQUIRE(hit->distance == Approx(3.5f));
    REQUIRE(hit->point.x == Approx(3.5f));
    REQUIRE(hit->normal.x == Approx(-1.0f));
    hit = world.closest({0, -1000});
    REQUIRE(hit);
    REQUIRE(hit->shape.body() == other);
    REQUIRE(hit->distance == Approx(99.0f).epsilon(1e-4));
    REQUIRE_FALSE(world.closest({0, 0}, 3.0f));
    REQUIRE(world.closest({4, 0.2f})->distance == 0.0f);
    World empty;
    REQUIRE_FALSE(empty.closest({0, 0}));
}

TEST_CASE("the distance of two shapes is that of their nearest points in any pose") {
    World world;
    Body a = add_box(world, {0, 0}), b = add_ball(world, {3, 4}, 1.0f);
    Separation gap = distance(a.shapes()[0], b.shapes()[0]);
    const Vec2 corner(0.5f, 0.5f);
    REQUIRE(gap.distance == Approx((Vec2(3, 4) - corner).length() - 1.0f));
    REQUIRE((gap.point_a - Position(corner)).length() < 1e-5f);
    REQUIRE((gap.point_b - gap.point_a).length() == Approx(gap.distance));
    REQUIRE((gap.normal - (Vec2(3, 4) - corner).normalized()).length() < 1e-5f);
    b.set_position({1, 0});
    REQUIRE(distance(a.shapes()[0], b.shapes()[0]).distance == 0.0f);
    b.set_position({0, 5});
    a.set_angle(0.785398163f);
    REQUIRE(distance(b.shapes()[0], a.shapes()[0]).distance ==
            Approx(4.0f - std::sqrt(0.5f)).epsilon(1e-4));
}

TEST_CASE("queries filter by category and mask and group and function") {
    World world;
    const ShapeDef grouped = {.group = -3};
    Body box = add_box(world, {4, 0}, 1.0f, grouped);
    REQUIRE(world.closest({0, 0}, infinity, {.group = -2}));
    REQUIRE_FALSE(world.closest({0, 0}, infinity, {.group = -3}));
    REQUIRE_FALSE(world.cast_ray({0, 0}, {9, 0}, {.group = -3}));
    box.shapes()[0].set_group(5);
    REQUIRE(world.cast_ray({0, 0}, {9, 0},
                           {.mask = 0, .group = 5}));  // the group decides before the mask
    REQUIRE_FALSE(world.cast_ray({0, 0}, {9, 0}, {.mask = 0}));
    REQUIRE_FALSE(world.cast_shape(
        Circle{}, {}, {9, 0}, {.accept = [&](const Shape& shape) { return shape.body() != box; }}));
}

}  // namespace shape_query_test
