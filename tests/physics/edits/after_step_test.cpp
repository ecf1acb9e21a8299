#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "catch.h"
#include "scenes.h"

namespace after_step_test {

// Edits that a callback requests and that are made after the step.

using namespace scenes;

namespace {

/// Boxes that fall onto a floor.
void add_heap(World& world) {
    add_floor(world);
    for (int i = 0; i < 10; ++i) add_box(world, {0.3f * float(i % 3), 0.51f + 1.02f * float(i)});
}

}  // namespace

TEST_CASE("edits that a callback requests are made once after the step") {
    World world;
    add_floor(world);
    Body ball = add_ball(world, {0, 0.52f});
    int calls = 0;
    world.set_before_solve([&](ContactEdit& contact) {
        if (calls > 0) return;
        ++calls;
        contact.shape_a.world().after_step([&world, ball]() mutable {
            REQUIRE_FALSE(world.locked());
            ball.set_velocity({3, 0});
            world.create_body({.type = BodyType::static_body}).add(Circle{.center = {50, 0}});
        });
    });
    for (int i = 0; i < 30 && calls == 0; ++i) world.step(frame);
    REQUIRE(calls == 1);
    REQUIRE(ball.velocity().x == 3.0f);
    const uint32_t bodies = world.body_count();
    run(world, 0.2f);
    REQUIRE(world.body_count() == bodies);
    REQUIRE_FALSE(world.validate());
}

TEST_CASE(
    "functions are called in their order and one that is added during these calls after the next "
    "step") {
    World world;
    std::string order;
    world.after_step([&] {
        order += 'a';
        world.after_step([&] { order += 'c'; });
    });
    world.after_step([&] { order += 'b'; });
    world.after_step({});
    REQUIRE(order.empty());
    world.step(frame);
    REQUIRE(order == "ab");
    world.step(frame);
    REQUIRE(order == "abc");
    world.step(frame);
    REQUIRE(order == "abc");
}

TEST_CASE("all functions are called even if one throws") {
    World world;
    add_ball(world, {0, 5});
    int calls = 0;
    world.after_step([] { throw std::runtime_error("first"); });
    world.after_step([] { throw std::runtime_error("second"); });
    world.after_step([&] { ++calls; });
    REQUIRE_THROWS_WITH(world.step(frame), "first");
    REQUIRE(calls == 1);
    REQUIRE(world.statistics().steps == 1);
    REQUIRE_NOTHROW(world.step(frame));
}

TEST_CASE("a function may edit the world after a step in which a callback threw") {
    World world;
    add_heap(world);
    world.set_before_solve([](ContactEdit&) { throw std::runtime_error("callback"); });
    std::optional<Body> made;
    world.after_step([&] { made = world.create_body(); });
    REQUIRE_THROWS_WITH(world.step(frame), "callback");
    REQUIRE(made.has_value());
    REQUIRE_FALSE(world.locked());
}

TEST_CASE("a function may destroy the world and the later ones are not called") {
    auto world = std::make_unique<World>();
    Body body = add_ball(*world, {0, 5});
    int calls = 0;
    world->after_step([&] { world.reset(); });
    world->after_step([&] { ++calls; });
    REQUIRE_NOTHROW(world->step(frame));
    REQUIRE(world == nullptr);
    REQUIRE(calls == 0);
    REQUIRE_FALSE(body.is_valid());
}

TEST_CASE("functions of a destroyed world are not called for a world in its place") {
    // The new world may have the address of the old one; in the second case it always has.
    int calls = 0;
    auto world = std::make_unique<World>();
    world->after_step([&] {
        world.reset();
        world = std::make_unique<World>();
    });
    world->after_step([&] { ++calls; });
    world->step(frame);
    World other;
    other.after_step([&] { other = World(); });
    other.after_step([&] { ++calls; });
    other.step(frame);
    REQUIRE(calls == 0);
    // A world that is moved is still the same world.
    World from, to;
    from.after_step([&] { to = std::move(from); });
    from.after_step([&] { ++calls; });
    from.step(frame);
    REQUIRE(calls == 1);
}

TEST_CASE("a world that a callback destroys calls nothing after the step") {
    auto world = std::make_unique<World>();
    add_heap(*world);
    int calls = 0;
    world->set_before_solve([&](ContactEdit& contact) {
        if (world == nullptr) return;
        contact.shape_a.world().after_step([&] { ++calls; });
        world.reset();
    });
    REQUIRE_THROWS_AS(world->step(frame), Locked);
    REQUIRE(calls == 0);
}

}  // namespace after_step_test
