#include "catch.h"
#include "scenes.h"

namespace compound_test {

using namespace scenes;

TEST_CASE("an L of two boxes falls over to its heavy side") {
    World world;
    add_floor(world);
    Body l = world.create_body({.position = {0, 1}});
    l.add(Box{.width = 0.4f, .height = 2.0f});
    l.add(Box{.width = 2.0f, .height = 0.4f, .center = {1.2f, 0.8f}});
    REQUIRE(l.center().x > 0.3f);
    run(world, 3.0f);
    REQUIRE(l.angle() < -0.5f);
    REQUIRE_FALSE(l.awake());
}

TEST_CASE("compounds of two triangles pile up and come to rest") {
    World world({.bounds = Aabb{{-6, 0}, {6, 40}}});
    std::vector<Body> bodies;
    for (int i = 0; i < 30; ++i) {
        Body body = world.create_body(
            {.position = {float(i % 5) * 2.0f - 4.0f, 1.0f + float(i / 5) * 2.4f}});
        body.add(Polygon{.vertices = {{-1, 0}, {0.5f, 1}, {0, 2}}});
        body.add(Polygon{.vertices = {{1, 0}, {-0.5f, 1}, {0, 2}}});
        bodies.push_back(body);
    }
    run(world, 15.0f);
    for (Body body : bodies) {
        REQUIRE(body.velocity().length() < 0.3f);
        REQUIRE(body.aabb().min.y > -0.1f);
        REQUIRE(body.aabb().min.x > -6.1f);
        REQUIRE(body.aabb().max.x < 6.1f);
    }
    REQUIRE_FALSE(world.validate());
}

TEST_CASE("the shapes of one body do not collide with each other") {
    World world({.gravity = {0, 0}});
    Body body = world.create_body();
    body.add(Circle{.radius = 1.0f});
    body.add(Circle{.radius = 1.0f, .center = {0.5f, 0}});
    run(world, 0.5f);
    REQUIRE(world.statistics().contacts == 0);
    REQUIRE(body.velocity() == Vec2(0, 0));
}

TEST_CASE("a shape taken off a compound falls away with its new body") {
    World world;
    add_floor(world);
    Body body = world.create_body({.position = {0, 0.5f}});
    body.add(Box{});
    Shape upper = body.add(Box{.center = {0, 1}});
    run(world, 2.0f);
    REQUIRE(body.mass() == Approx(2.0f));
    Body other = world.create_body({.position = {5, 3}});
    upper.attach(other);
    REQUIRE(body.mass() == Approx(1.0f));
    run(world, 2.0f);
    REQUIRE(other.position().y == Approx(-0.5f).margin(0.02));
    REQUIRE(body.position().y == Approx(0.5f).margin(0.02));
    REQUIRE_FALSE(world.validate());
}

}  // namespace compound_test
