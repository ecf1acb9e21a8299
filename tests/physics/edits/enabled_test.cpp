#include <fettle/physics/host_access.h>

#include "catch.h"
#include "saved_worlds.h"
#include "scenes.h"

namespace enabled_test {

// Disabled bodies.

using namespace scenes;

TEST_CASE("a disabled body is not moved and touches nothing and comes back") {
    World world;
    add_floor(world);
    Body low = add_box(world, {0, 0.5f}), high = add_box(world, {0, 1.5f});
    run(world, 1.0f);
    REQUIRE(low.contacts().size() == 2);
    low.set_enabled(false);
    REQUIRE_FALSE(low.enabled());
    REQUIRE_FALSE(low.awake());
    REQUIRE_FALSE(low.is_touching());
    REQUIRE_FALSE(world.validate());
    const Position place = low.position();
    run(world, 1.5f);
    REQUIRE(low.position() == place);
    REQUIRE(high.position().y == Approx(0.5).margin(0.02));
    REQUIRE_FALSE(world.validate());

    low.set_position({3, 4});
    low.set_enabled(true);
    REQUIRE(low.awake());
    run(world, 2.0f);
    REQUIRE(low.position().y == Approx(0.5).margin(0.02));
    REQUIRE(low.position().x == Approx(3).margin(0.01));
    REQUIRE(low.is_touching());
    REQUIRE_FALSE(world.validate());
}

TEST_CASE("a disabled body is found by no query and kept by its lists") {
    World world;
    Body body = world.create_body({.position = {0, 0}, .enabled = false});
    const Shape shape = body.add(Box{.width = 2});
    body.add(Concave{.vertices = {{0, 0}, {2, 0}, {1, 0.5f}, {1, 2}}});
    world.step(frame);
    const auto found = [&] {
        return world.query_point({0, 0}).size() + world.query_aabb({{-1, -1}, {1, 1}}).size() +
               world.query_overlap(Circle{}).size() + size_t(bool(world.closest({0, 0}))) +
               size_t(bool(world.cast_ray({-9, 0}, {9, 0})));
    };
    REQUIRE(found() == 0);
    REQUIRE(body.shape_count() == 2);
    REQUIRE(world.bodies().size() == 1);
    REQUIRE(shape.contains({0.5f, 0}));
    REQUIRE(body.mass() > 2);
    body.add(Circle{.radius = 3});
    REQUIRE(found() == 0);
    REQUIRE_FALSE(world.validate());
    body.set_enabled(true);
    REQUIRE(found() > 5);
    REQUIRE_FALSE(world.validate());
}

TEST_CASE("a disabled body keeps the velocity that it has or gets") {
    World world({.gravity = {0, 0}});
    Body body = add_ball(world, {0, 0}),
         late = world.create_body({.position = {0, 9}, .velocity = {0, 1}, .enabled = false});
    body.set_velocity({2, 0});
    body.set_angular_velocity(3);
    body.set_enabled(false);
    world.step(frame);
    REQUIRE(body.velocity() == Vec2(2, 0));
    REQUIRE(body.position() == Vec2{});
    body.set_velocity({4, 0});
    REQUIRE(HostAccess::set_velocity(world, late.index(), {0, 2}));
    body.apply_impulse({100, 0});
    body.apply_force({100, 0});
    body.set_enabled(true);
    late.set_enabled(true);
    world.step(0.5f);
    REQUIRE(body.velocity().x == Approx(4));
    REQUIRE(body.angular_velocity() == Approx(3));
    REQUIRE(body.position().x == Approx(2));
    REQUIRE(late.position().y == Approx(10));

    body.set_enabled(false);
    body.set_type(BodyType::static_body);
    body.set_enabled(true);
    REQUIRE(body.velocity() == Vec2{});
}

TEST_CASE("the joints of a disabled body do not act and act again") {
    World world;
    Body pivot = world.create_body({.type = BodyType::static_body, .position = {0, 10}});
    Body bob = add_ball(world, {2, 10});
    Joint rope = world.create_distance_joint({.body_a = pivot.id(), .body_b = bob.id()});
    run(world, 0.5f);
    REQUIRE((bob.position() - pivot.position()).length() == Approx(2).margin(0.02));
    pivot.set_enabled(false);
    REQUIRE_FALSE(world.validate());
    run(world, 0.5f);
    REQUIRE((bob.position() - pivot.position()).length() > 3);
    REQUIRE(rope.is_valid());
    REQUIRE_FALSE(world.validate());
    bob.set_position({2, 10});
    bob.set_velocity({0, 0});
    pivot.set_enabled(true);
    run(world, 0.5f);
    REQUIRE((bob.position() - pivot.position()).length() == Approx(2).margin(0.02));
    REQUIRE_FALSE(world.validate());
}

TEST_CASE("a body that rests on a body that is disabled wakes and falls") {
    World world;
    Body shelf = world.create_body({.type = BodyType::static_body, .position = {0, 5}});
    shelf.add(Box{.width = 4, .height = 0.2f});
    Body crate = add_box(world, {0, 5.6f});
    run(world, 3.0f);
    REQUIRE_FALSE(crate.awake());
    shelf.set_enabled(false);
    REQUIRE(crate.awake());
    run(world, 0.5f);
    REQUIRE(crate.position().y < 4.8f);
    REQUIRE(world.events().contact_end.empty());
    REQUIRE_FALSE(world.validate());
}

TEST_CASE("disabled bodies of each type are saved and edited and destroyed") {
    for (const BodyType type :
         {BodyType::static_body, BodyType::kinematic_body, BodyType::dynamic_body}) {
        World world;
        add_floor(world);
        Body body = world.create_body({.type = type, .position = {0, 1}});
        body.add(Box{});
        Body other = add_box(world, {0.2f, 2.1f});
        run(world, 0.5f);
        body.set_enabled(false);
        World copy = world.clone();
        World restored;
        restored.restore(saved(world));
        REQUIRE_FALSE(restored.body(body.id()).enabled());
        for (World* each : {&world, &copy, &restored}) {
            Body same = each->body(body.id());
            run(*each, 0.2f);
            same.set_type(BodyType::dynamic_body);
            same.shapes()[0].set_sensor(true);
            same.shapes()[0].set_sensor(false);
            same.shapes()[0].set_mask(3);
            same.set_awake(true);
            same.set_awake(false);
            each->wake_all();
            REQUIRE_FALSE(each->validate());
            run(*each, 0.2f);
            same.set_enabled(true);
            run(*each, 0.2f);
            REQUIRE_FALSE(each->validate());
        }
        REQUIRE(world.hash() == copy.hash());
        REQUIRE(world.hash() == restored.hash());
        body.set_enabled(false);
        body.destroy();
        run(world, 1.0f);
        REQUIRE(other.position().y == Approx(0.5).margin(0.05));
        REQUIRE_FALSE(world.validate());
    }
}

}  // namespace enabled_test
