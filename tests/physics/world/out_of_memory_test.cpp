// Memory ends at every place in the life of a world.

#include "catch.h"
#include "every_method.h"
#include "memory_end.h"

#include <fettle/physics/damaged.h>

#include <new>

namespace out_of_memory_test {

using namespace scenes;

namespace {

/// Edits, steps, copies and queries of all kinds.
void use_everything(World& world) {
    world.create_body({.type = BodyType::static_body})
        .add(Chain{.points = {{-20, 0}, {0, 0}, {5, -0.5f}, {20, 0}}});
    const std::vector<Vec2> notched = {
        {-0.5f, -0.5f}, {0.5f, -0.5f}, {0.5f, 0.5f}, {0, 0}, {-0.5f, 0.5f}};
    std::vector<Body> bodies;
    for (int i = 0; i < 9; ++i) {
        Body body =
            world.create_body({.position = {float(i % 3), 0.6f + float(i / 3)}, .name = "crate"});
        if (i % 3 == 0) body.add(Box{});
        if (i % 3 == 1) body.add(Circle{});
        if (i % 3 == 2) body.add(Concave{notched});
        bodies.push_back(body);
    }
    world.create_revolute_joint(
        {.body_a = bodies[0].id(), .body_b = bodies[1].id(), .break_force = 100});
    world.create_field({BuoyancyField{.level = 0.5f}});
    for (int i = 0; i < 8; ++i) world.step(frame);
    bodies[0].set_position({0, 3});
    bodies[1].shapes()[0].set_radius(0.7f);
    bodies[2].set_type(BodyType::kinematic_body);
    bodies[3].destroy();
    bodies[4].set_enabled(false);
    bodies[5].shapes()[0].set_geometry(Box{});
    bodies[6].add(Ellipse{});
    bodies[7].shapes()[0].set_sensor(true);
    bodies[8].shapes()[0].set_mask(2);
    world.set_bounds(Aabb{{-30, -5}, {30, 30}});
    world.set_filter([](const Shape&, const Shape&) { return true; });
    for (int i = 0; i < 8; ++i) world.step(frame);
    bodies[0].set_awake(false);
    world.step(frame);
    (void)world.query_aabb({{-5, -5}, {5, 5}});
    (void)world.contacts();
    std::vector<std::byte> bytes;
    world.save(bytes);
    world.restore(bytes);
    const World copy = world.clone();
    world.step(frame);
    world.clear();
    world.step(frame);
}

bool is_damaged(const World& world) {
    try {
        (void)world.contacts();
        return false;
    } catch (const Damaged&) {
        return true;
    }
}

/// True if memory ended in `act`.
template <class Act>
bool ends_within(int64_t allocations, Act&& act) {
    const MemoryEnd end(allocations);
    try {
        act();
        return false;
    } catch (const std::bad_alloc&) {
        return true;
    }
}

}  // namespace

TEST_CASE("when memory runs out a world is unchanged or refuses all calls until it is restored") {
    World intact;
    add_floor(intact);
    add_box(intact, {0, 3});
    int damaged = 0, whole = 0;
    for (int64_t allocations = 0;; ++allocations) {
        INFO("memory ends after " << allocations << " allocations");
        World world;
        if (!ends_within(allocations, [&] { use_everything(world); })) break;
        ++(is_damaged(world) ? damaged : whole);
        if (is_damaged(world)) {
            REQUIRE(world.bodies().empty());
            REQUIRE(world.body_count() + world.shape_count() + world.joint_count() == 0);
            REQUIRE_THROWS_AS(world.step(frame), Damaged);
            REQUIRE_THROWS_AS(world.create_body(), Damaged);
            world.restore(intact);
        }
        REQUIRE_FALSE(world.validate());
        for (Body body : world.bodies()) body.set_velocity({1, 1});
        for (int i = 0; i < 3; ++i) world.step(frame);
        REQUIRE_FALSE(world.validate());
    }
    REQUIRE(damaged > 20);
    REQUIRE(whole > 20);
}

TEST_CASE("without memory for a body or a shape nothing is created and the world is as before") {
    World world;
    int without = 0;
    while (world.body_count() < 100) {
        const uint32_t before = world.body_count();
        Body body;
        if (ends_within(0, [&] { body = world.create_body(); })) {
            ++without;
            REQUIRE(world.body_count() == before);
            body = world.create_body();
        }
        if (ends_within(0, [&] { body.add(Circle{}); })) {
            ++without;
            REQUIRE(body.shape_count() == 0);
        }
        REQUIRE_FALSE(is_damaged(world));
        REQUIRE_FALSE(world.validate());
    }
    REQUIRE(without > 10);
}

TEST_CASE("without memory a world takes nothing from another and both stay as they were") {
    for (int64_t allocations = 0;; ++allocations) {
        INFO("memory ends after " << allocations << " allocations");
        World world, other;
        add_floor(world);
        for (int i = 0; i < 8; ++i) add_ball(other, {0.8f * float(i), 0});
        world.step(frame);
        other.step(frame);
        const Body ball = other.bodies()[0];
        const bool ended = ends_within(allocations, [&] { world.take(std::move(other)); });
        REQUIRE_FALSE(world.validate());
        REQUIRE_FALSE(other.validate());
        REQUIRE(world.body_count() == (ended ? 1 : 8));
        REQUIRE(other.body_count() == (ended ? 8 : 0));
        REQUIRE(ball.is_valid() == ended);
        for (World* each : {&world, &other}) each->step(frame);
        if (!ended) break;
    }
}

TEST_CASE("every method of a damaged world and of its handles throws but those that replace it") {
    World world;
    Things things = make_things(world);
    int64_t allocations = 0;
    while (!is_damaged(world)) {
        world.wake_all();
        (void)ends_within(allocations++, [&] { world.step(frame); });
    }
    REQUIRE_FALSE(things.body.is_valid());
    REQUIRE_FALSE(things.box.is_valid());
    REQUIRE_FALSE(things.joint.is_valid());
    REQUIRE_FALSE(things.field.is_valid());
    REQUIRE_FALSE(world.locked());
    for (const Method& method : every_method()) {
        if (method.name == "World::restore" || method.name == "World::take") continue;
        INFO(method.name);
        REQUIRE_THROWS_AS(method.call(things), Damaged);
    }
    std::vector<std::byte> bytes;
    REQUIRE_THROWS_AS(world.save(bytes), Damaged);
    REQUIRE_THROWS_AS(world.clone(), Damaged);
    REQUIRE_THROWS_AS(world.query_point({0, 0}), Damaged);
    REQUIRE_THROWS_AS(world.cast_ray({0, 9}, {0, -9}), Damaged);
    world.restore(things.bytes);
    world.step(frame);
    REQUIRE_FALSE(world.validate());
}

TEST_CASE("a damaged world can be assigned to and handles of a copy that it takes back are valid") {
    World world;
    add_floor(world);
    const Body box = add_box(world, {0, 0.5f});
    const World before = world.clone();
    for (int64_t allocations = 0; !is_damaged(world); ++allocations)
        (void)ends_within(allocations, [&] { world.step(frame); });
    REQUIRE_THROWS_AS(box.position(), Damaged);
    world.restore(before);
    REQUIRE(box.position().y == Approx(0.5f));
    world.step(frame);
    for (int64_t allocations = 0; !is_damaged(world) && allocations < 1000; ++allocations)
        (void)ends_within(allocations, [&] {
            for (int i = 0; i < 5; ++i) world.create_body().add(Chain{.points = triangle()});
            world.step(frame);
        });
    REQUIRE(is_damaged(world));
    world = World();
    world.create_body().add(Box{});
    world.step(frame);
    REQUIRE_FALSE(world.validate());
}

}  // namespace out_of_memory_test
