#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "catch.h"
#include "scenes.h"

namespace copy_test {

// World::clone copies a world; moving a world keeps its handles, callbacks and future.

using namespace scenes;

namespace {

/// Boxes that fall onto a floor.
void add_heap(World& world) {
    add_floor(world);
    for (int i = 0; i < 10; ++i) add_box(world, {0.3f * float(i % 3), 0.51f + 1.02f * float(i)});
}

}  // namespace

static_assert(!std::is_copy_constructible_v<World> && !std::is_copy_assignable_v<World>);
static_assert(std::is_move_constructible_v<World> && std::is_move_assignable_v<World>);

TEST_CASE("a clone has the same future and handles stay with the original") {
    World world;
    add_heap(world);
    run(world, 0.5f);
    World copy = world.clone();
    REQUIRE(copy.hash() == world.hash());
    const Body body = world.bodies()[3];
    REQUIRE(&body.world() == &world);
    run(world, 0.5f);
    run(copy, 0.5f);
    REQUIRE(copy.hash() == world.hash());
    REQUIRE_FALSE(copy.validate());
}

TEST_CASE("a moved world has its handles callbacks and future at the new place") {
    World plain, world;
    add_heap(plain);
    add_heap(world);
    int filter_calls = 0;
    world.set_before_solve([&filter_calls](ContactEdit&) { ++filter_calls; });
    run(world, 0.5f);
    run(plain, 0.5f);
    const Body body = world.bodies()[3];
    REQUIRE(filter_calls > 0);

    World there = std::move(world);
    REQUIRE(body.is_valid());
    REQUIRE(&body.world() == &there);
    REQUIRE(there.body(body.id()) == body);
    filter_calls = 0;
    run(there, 0.5f);
    run(plain, 0.5f);
    REQUIRE(filter_calls > 0);
    REQUIRE(there.hash() == plain.hash());
    REQUIRE_FALSE(there.validate());

    // The world that was moved from is empty and can be used.
    REQUIRE(world.body_count() == 0);
    REQUIRE_FALSE(world.is_valid(body.id()));
    Body fresh = add_ball(world, {0, 5});
    run(world, 0.2f);
    REQUIRE(fresh.position().y < 5);
    REQUIRE(&fresh.world() == &world);
    REQUIRE_FALSE(world.validate());
}

TEST_CASE("a move onto a world destroys the objects of that world") {
    World world, other;
    Body gone = add_ball(world, {0, 0}), kept = add_ball(other, {1, 0});
    world = std::move(other);
    REQUIRE_FALSE(gone.is_valid());
    REQUIRE_THROWS_WITH(gone.position(), contains("its world was destroyed"));
    REQUIRE(&kept.world() == &world);
    REQUIRE(world.body_count() == 1);
    REQUIRE(other.body_count() == 0);
    World& same = world;
    world = std::move(same);
    REQUIRE(kept.is_valid());
    REQUIRE_FALSE(world.validate());
}

TEST_CASE("worlds are elements of a vector that grows") {
    std::vector<World> worlds;
    std::vector<Body> bodies;
    for (int i = 0; i < 20; ++i) {
        worlds.emplace_back();
        bodies.push_back(add_ball(worlds.back(), {float(i), 9}));
    }
    for (World& world : worlds) run(world, 0.1f);
    for (size_t i = 0; i < bodies.size(); ++i) {
        REQUIRE(&bodies[i].world() == &worlds[i]);
        REQUIRE(bodies[i].position().x == float(i));
        REQUIRE(bodies[i].position().y < 9);
    }
}

TEST_CASE("a world is not moved by a function that it calls") {
    World world;
    add_heap(world);
    std::string refused;
    world.set_before_solve([&](ContactEdit&) {
        try {
            const World stolen = std::move(world);
        } catch (const Locked& error) {
            refused = error.what();
        }
    });
    run(world, 0.2f);
    REQUIRE_THAT(refused, contains("is not allowed inside the before-solve callback"));
    REQUIRE(world.body_count() > 1);
    REQUIRE_FALSE(world.validate());
}

TEST_CASE("reserved memory changes no result and is as large as requested") {
    World world, plain;
    world.reserve({.bodies = 500, .shapes = 600, .contacts = 900, .joints = 10});
    size_t reserved = 0, used = 0;
    for (const MemoryShare& share : world.memory()) {
        if (std::string(share.purpose) != "bodies") continue;
        reserved = share.reserved;
        used = share.used;
    }
    REQUIRE(reserved > 500 * sizeof(BodyState));
    REQUIRE(used < reserved / 100);
    for (World* each : {&world, &plain}) {
        add_heap(*each);
        run(*each, 0.5f);
    }
    REQUIRE(world.hash() == plain.hash());
    REQUIRE_THROWS_WITH(world.reserve({.shapes = 1u << 25}), contains("shapes = 33554432"));
}

TEST_CASE("a copy without the filter has the contacts that the filter refused") {
    World world({.gravity = {0, 0}});
    world.set_filter([](const Shape&, const Shape&) { return false; });
    add_box(world, {0, 0});
    add_box(world, {0.3f, 0});
    run(world, 0.1f);
    REQUIRE(world.contacts().empty());
    std::vector<std::byte> saved;
    world.save(saved);
    World copy = world.clone(), restored;
    restored.restore(saved);
    for (World* each : {&copy, &restored}) {
        CHECK_FALSE(each->validate());
        run(*each, 0.1f);
        CHECK(each->contacts().size() == 1);
        CHECK_FALSE(each->validate());
    }
    world.restore(saved);
    run(world, 0.1f);
    CHECK(world.contacts().empty());
}

TEST_CASE("a state with refused pairs goes through a world without the filter and keeps its bits") {
    const auto refuse = [](const Shape& a, const Shape& b) {
        return (a.index() + b.index()) % 3 != 0;
    };
    World world, taker;
    for (World* each : {&world, &taker}) each->set_filter(refuse);
    add_heap(world);
    run(world, 0.5f);
    std::vector<std::byte> saved;
    world.save(saved);
    World between;
    between.restore(saved);
    CHECK_FALSE(between.validate());
    taker.take(std::move(between));
    for (World* each : {&world, &taker}) run(*each, 0.5f);
    CHECK(taker.hash() == world.hash());
}

TEST_CASE("a copy that gets the callbacks of the original goes on like it") {
    const bool mixes = GENERATE(false, true);
    const auto rough = [](ContactEdit& edit) {
        edit.friction = 0.1f * float((edit.shape_a.index() + edit.shape_b.index()) % 9);
    };
    World world;
    add_heap(world);
    const auto set = [&](World& each) {
        if (mixes)
            each.set_mixing(rough);
        else
            each.set_before_solve(rough);
    };
    set(world);
    for (const Shape& shape : world.shapes()) Shape(shape).set_before_solve(true);
    run(world, 0.6f);
    World copy = world.clone();
    set(copy);
    for (World* each : {&world, &copy}) run(*each, 0.5f);
    CHECK(copy.hash() == world.hash());
}

}  // namespace copy_test
