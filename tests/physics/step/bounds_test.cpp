#include "catch.h"
#include "scenes.h"

namespace bounds_test {

using namespace scenes;

TEST_CASE("bounds keep bodies of every kind inside") {
    World world({.bounds = Aabb{{-5, 0}, {5, 10}}});
    Body box = add_box(world, {4, 8}), ball = add_ball(world, {-4, 8});
    Body capsule = world.create_body({.position = {0, 8}});
    capsule.add(Segment{.from = {-0.5f, 0}, .to = {0.5f, 0.2f}, .rounding = 0.25f});
    box.set_velocity({20, 5});
    ball.set_velocity({-20, 20});
    capsule.set_velocity({3, 25});
    for (int i = 0; i < 300; ++i) {
        world.step(frame);
        for (Body body : {box, ball, capsule}) {
            REQUIRE(body.position().x > -5.0f);
            REQUIRE(body.position().x < 5.0f);
            REQUIRE(body.position().y > 0.0f);
            REQUIRE(body.position().y < 10.0f);
        }
    }
    REQUIRE(box.position().y < 0.75f);  // it may lean on the capsule
    REQUIRE(ball.position().y == Approx(0.5f).margin(0.02));
}

TEST_CASE("a change of the bounds acts at once and wakes bodies that rest on them") {
    World world({.bounds = Aabb{{-5, 0}, {5, 10}}});
    Body box = add_box(world, {0, 0.5f});
    run(world, 3.0f);
    REQUIRE_FALSE(box.awake());
    world.set_bounds(Aabb{{-5, -3}, {5, 10}});
    run(world, 3.0f);
    REQUIRE(box.position().y == Approx(-2.5f).margin(0.02));
    world.set_bounds(Aabb{{-5, -1}, {5, 10}});  // the box is pushed back inside
    run(world, 3.0f);
    REQUIRE(box.position().y == Approx(-0.5f).margin(0.02));
    world.set_bounds(std::nullopt);
    run(world, 1.0f);
    REQUIRE(box.position().y < -3.0f);
    REQUIRE_FALSE(world.validate());
}

TEST_CASE("the border has friction and restitution of its own") {
    World world({.bounds = Aabb{{-100, 0}, {100, 100}}, .bounds_friction = 0.0f});
    Body box = add_box(world, {0, 0.5f}, 1.0f, {.friction = 1.0f});
    box.set_velocity({3, 0});
    run(world, 1.0f);
    REQUIRE(box.velocity().x == Approx(3.0f).epsilon(1e-3));
    world.set_bounds_friction(1.0f);
    run(world, 1.0f);
    REQUIRE(std::fabs(box.velocity().x) < 0.01f);
    world.set_bounds_restitution(1.0f);
    box.set_position({0, 5});
    box.set_velocity({0, -5});
    float fastest = 0.0f;
    for (int i = 0; i < 90; ++i) {
        world.step(frame);
        fastest = std::max(fastest, box.velocity().y);
    }
    REQUIRE(fastest > 5.0f);
}

TEST_CASE("contacts and rays find the border") {
    World world({.bounds = Aabb{{-5, 0}, {5, 10}}});
    Body box = add_box(world, {0, 0.5f});
    run(world, 0.5f);
    const auto contacts = box.contacts();
    REQUIRE(contacts.size() == 1);
    REQUIRE(world.shape(contacts[0].shape_a).type() == ShapeType::border);
    REQUIRE(contacts[0].normal == Vec2(0, 1));
    const auto hit = world.cast_ray({0, 5}, {20, 5});
    REQUIRE(hit);
    REQUIRE(hit->point.x == Approx(5.0f));
    REQUIRE(hit->shape.type() == ShapeType::border);
    Shape border = hit->shape;
    REQUIRE_THROWS(border.destroy());
    // Values that are settings of the world can be set only there.
    REQUIRE_THROWS_WITH(border.detach(), contains("bounds"));
    REQUIRE_THROWS_WITH(border.set_friction(3), contains("bounds_friction"));
    REQUIRE_THROWS_WITH(border.set_restitution(1), contains("bounds_restitution"));
    REQUIRE(border.friction() == world.bounds_friction());
    // The border does not have the other properties of shapes.
    const auto refuses = [](const std::string& what, const auto& set) {
        REQUIRE_THROWS_WITH(set(), contains(what + ": the border of the world has friction"));
    };
    refuses("sensor", [&] { border.set_sensor(true); });
    refuses("density", [&] { border.set_density(3); });
    refuses("rolling_resistance", [&] { border.set_rolling_resistance(3); });
    refuses("surface_speed", [&] { border.set_surface_speed(3); });
    refuses("hit_events", [&] { border.set_hit_events(true); });
    refuses("category", [&] { border.set_category(2); });
    refuses("mask", [&] { border.set_mask(2); });
    refuses("group", [&] { border.set_group(2); });
    REQUIRE_FALSE(border.sensor());
    REQUIRE(world.shapes().size() == 1);
    REQUIRE(world.bodies().size() == 1);
}

}  // namespace bounds_test
