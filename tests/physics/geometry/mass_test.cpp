#include "catch.h"
#include "scenes.h"

namespace mass_test {

using namespace scenes;

namespace {

constexpr float pi = 3.14159265f;

}  // namespace

TEST_CASE("mass and inertia of a circle are those of a disc") {
    World world;
    Body body = world.create_body();
    body.add(Circle{.radius = 2.0f}, {.density = 3.0f});
    REQUIRE(body.area() == Approx(4.0f * pi));
    REQUIRE(body.mass() == Approx(12.0f * pi));
    REQUIRE(body.inertia() == Approx(0.5f * 12.0f * pi * 4.0f));
    REQUIRE(body.center().length() < 1e-6f);
}

TEST_CASE("mass and inertia of a box are those of a rectangle wherever it is on the body") {
    World world;
    Body body = world.create_body();
    body.add(Box{.width = 3.0f, .height = 2.0f, .center = {5.0f, -1.0f}, .angle = 0.7f},
             {.density = 2.0f});
    REQUIRE(body.mass() == Approx(12.0f));
    REQUIRE(body.inertia() == Approx(12.0f * (9.0f + 4.0f) / 12.0f).epsilon(1e-4));
    REQUIRE(body.center().x == Approx(5.0f));
    REQUIRE(body.center().y == Approx(-1.0f));
}

TEST_CASE("a triangle balances at the mean of its corners") {
    World world;
    Body body = world.create_body();
    body.add(Polygon{.vertices = {{0, 0}, {3, 0}, {0, 6}}});
    REQUIRE(body.area() == Approx(9.0f));
    REQUIRE(body.center().x == Approx(1.0f));
    REQUIRE(body.center().y == Approx(2.0f));
    // Right triangle with legs a and b: m (a² + b²) / 18 about the centroid.
    REQUIRE(body.inertia() == Approx(9.0f * (9.0f + 36.0f) / 18.0f).epsilon(1e-5));
}

TEST_CASE("a capsule weighs a rectangle and two half discs") {
    World world;
    Body body = world.create_body();
    const float r = 0.5f, l = 2.0f;
    body.add(Segment{.from = {-1, 0}, .to = {1, 0}, .rounding = r});
    const float rectangle = 2 * r * l, discs = pi * r * r;
    REQUIRE(body.area() == Approx(rectangle + discs));
    // Half discs: centroid 4r/3π beyond the end, about which the polar moment is m r² (1/2 -
    // (4/3π)²).
    const float lever = 4 * r / (3 * pi);
    const float ends =
        discs * (0.5f * r * r - lever * lever + (0.5f * l + lever) * (0.5f * l + lever));
    const float middle = rectangle * (l * l + 4 * r * r) / 12;
    REQUIRE(body.inertia() == Approx(ends + middle).epsilon(1e-5));
}

TEST_CASE("a rounded box lies between its core and its outline") {
    World world;
    Body body = world.create_body();
    Shape shape = body.add(Box{.width = 2.0f, .height = 2.0f, .rounding = 0.5f});
    REQUIRE(body.area() == Approx(4.0f - (1.0f - pi / 4.0f)).epsilon(1e-4));
    REQUIRE(shape.aabb().max.x == Approx(1.0f));
    shape.set_rounding(1.0f);  // as round as it gets: a disc
    REQUIRE(body.area() == Approx(pi).epsilon(1e-2));
}

TEST_CASE("a compound weighs its parts and turns about their common center") {
    World world;
    Body body = world.create_body();
    body.add(Circle{.radius = 1.0f, .center = {-3.0f, 0.0f}}, {.density = 1.0f});
    body.add(Circle{.radius = 1.0f, .center = {3.0f, 0.0f}}, {.density = 3.0f});
    REQUIRE(body.mass() == Approx(4.0f * pi));
    REQUIRE(body.center().x == Approx(1.5f));
    // Steiner: own moments plus mass times distance squared.
    const float expected = 0.5f * 4.0f * pi + pi * 4.5f * 4.5f + 3.0f * pi * 1.5f * 1.5f;
    REQUIRE(body.inertia() == Approx(expected).epsilon(1e-5));
}

TEST_CASE("overriding the mass scales the inertia and ending the override restores both") {
    World world;
    Body body = add_box(world, {0, 0});
    const float inertia = body.inertia();
    body.set_mass(5.0f);
    REQUIRE(body.mass() == Approx(5.0f));
    REQUIRE(body.inertia() == Approx(5.0f * inertia));
    REQUIRE(body.mass_override() == 5.0f);
    body.set_mass(std::nullopt);
    REQUIRE(body.mass() == Approx(1.0f));
    REQUIRE(body.inertia() == Approx(inertia));
    REQUIRE_FALSE(body.mass_override().has_value());
}

TEST_CASE("lines alone have their mass along them") {
    World world;
    Body rod = world.create_body();
    rod.add(Segment{.from = {1, 0}, .to = {4, 0}});
    CHECK(rod.mass() == 1.0f);
    CHECK(rod.center().x == Approx(2.5f));
    CHECK(rod.inertia() == Approx(9.0f / 12));
    rod.set_mass(6.0f);
    CHECK(rod.inertia() == Approx(6 * 9.0f / 12));
    rod.set_center(Vec2(1, 0));
    CHECK(rod.inertia() == Approx(6 * 9.0f / 3));
    rod.set_center(std::nullopt);
    rod.add(Segment{.from = {1, 0}, .to = {1, 1}});
    CHECK(rod.center().x == Approx((3 * 2.5f + 1) / 4));
    CHECK(rod.center().y == Approx(0.5f / 4));
    rod.add(Circle{.radius = 1});
    rod.set_mass(std::nullopt);
    CHECK(rod.mass() == Approx(pi));
    CHECK(rod.inertia() == Approx(pi / 2));
}

TEST_CASE("a rod without thickness falls over") {
    World world;
    add_floor(world);
    Body rod = world.create_body({.position = {0, 2}, .angle = 0.5f});
    rod.add(Segment{.from = {-1, 0}, .to = {1, 0}});
    run(world, 4);
    CHECK(std::abs(rod.angle()) < 0.01f);
    CHECK(std::abs(rod.position().y) < 0.02f);
    CHECK_FALSE(rod.awake());
}

TEST_CASE("overriding the center moves the inertia with it") {
    World world;
    Body body = add_box(world, {0, 0});
    body.set_center(Vec2(2.0f, 0.0f));
    REQUIRE(body.inertia() == Approx(1.0f / 6.0f + 4.0f));
    REQUIRE(body.position() == Vec2(0, 0));
    body.set_inertia(9.0f);
    REQUIRE(body.inertia() == 9.0f);
    body.set_center(std::nullopt);
    REQUIRE(body.center().length() < 1e-6f);
}

TEST_CASE("a body keeps its place in the world when its center of mass moves") {
    World world({.gravity = {0, 0}});
    Body body = add_box(world, {3, 4});
    body.set_angle(0.5f);
    body.set_angular_velocity(2.0f);
    const Vec2 corner_velocity = body.velocity_at({5, 5});
    body.add(Circle{.radius = 0.5f, .center = {2, 0}});
    REQUIRE(body.position() == Vec2(3, 4));
    REQUIRE(body.center().x > 0.5f);
    REQUIRE((body.velocity_at({5, 5}) - corner_velocity).length() < 1e-5f);
    REQUIRE(body.velocity().length() > 0.1f);
}

TEST_CASE("ten edits of a shape cost one rebuild of it and of its body") {
    World world;
    Body body = add_box(world, {0, 0});
    Shape shape = body.shapes()[0];
    world.step(frame);
    const uint32_t shape_before = shape.rebuilds(), body_before = body.rebuilds();
    for (int i = 1; i <= 10; ++i) shape.set_width(1.0f + 0.1f * float(i));
    REQUIRE(shape.rebuilds() == shape_before);
    REQUIRE(body.mass() == Approx(2.0f));
    world.step(frame);
    REQUIRE(shape.rebuilds() == shape_before + 1);
    REQUIRE(body.rebuilds() == body_before + 1);
}

TEST_CASE("a shape without a body has an area and adds mass to the body that it is attached to") {
    World world;
    Shape shape = world.create_shape(Box{.width = 2, .height = 3}, {.density = 2});
    REQUIRE(shape.area() == Approx(6.0f));
    REQUIRE(shape.mass() == Approx(12.0f));
    REQUIRE_FALSE(shape.body());
    Body a = world.create_body(), b = world.create_body();
    shape.attach(a);
    REQUIRE(a.mass() == Approx(12.0f));
    shape.attach(b);
    REQUIRE(b.mass() == Approx(12.0f));
    REQUIRE(a.shape_count() == 0);
    REQUIRE(shape.body() == b);
    shape.detach();
    REQUIRE(b.shape_count() == 0);
    REQUIRE_FALSE(shape.body());
    REQUIRE_FALSE(world.validate());
}

}  // namespace mass_test
