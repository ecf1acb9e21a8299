// Saved worlds: restored in place they go on bit for bit, and damaged bytes change nothing.

#include "catch.h"
#include "scenes.h"

#include <functional>

using namespace scenes;

namespace {

std::vector<std::byte> saved(const World& world) {
    std::vector<std::byte> bytes;
    world.save(bytes);
    return bytes;
}

std::vector<uint64_t> hashes(World& world, int steps) {
    std::vector<uint64_t> all;
    for (int i = 0; i < steps; ++i) {
        world.step(frame);
        all.push_back(world.hash());
    }
    return all;
}

/// Saves after `before` steps, goes on, restores, goes on again: both futures are the same, after
/// `meddle` has done what it likes with the world in between.
void check_restored(World& world, int before, int after,
                    const std::function<void(World&)>& meddle = {}) {
    for (int i = 0; i < before; ++i) world.step(frame);
    const auto bytes = saved(world);
    const auto expected = hashes(world, after);
    if (meddle) {
        meddle(world);
        for (int i = 0; i < 30; ++i) world.step(frame);
    }
    world.restore(bytes);
    REQUIRE_FALSE(world.validate());
    // Only generations given since differ.
    if (!meddle) REQUIRE((saved(world) == bytes));
    REQUIRE(hashes(world, after) == expected);
    // And once more, into a world that has never seen any of it.
    World other;
    other.restore(bytes);
    REQUIRE(hashes(other, after) == expected);
    REQUIRE_FALSE(other.validate());
}

void build_stack(World& world) {
    add_floor(world);
    for (int i = 0; i < 10; ++i) add_box(world, {0.02f * float(i % 3), 0.5f + 1.01f * float(i)});
}

void build_tumbler(World& world) {
    Body drum = world.create_body({.position = {0, 10}});
    for (const Vec2& side : {Vec2(10, 0), Vec2(-10, 0)})
        drum.add(Box{.width = 1, .height = 20, .center = side}, {.density = 50});
    for (const Vec2& side : {Vec2(0, 10), Vec2(0, -10)})
        drum.add(Box{.width = 20, .height = 1, .center = side}, {.density = 50});
    RevoluteJoint hinge =
        world.create_revolute_joint({.body_b = drum.id(), .anchor_a = {0, 10}, .anchor_b = {0, 0}});
    hinge.set_motor_speed(0.43f);
    hinge.set_max_motor_torque(1e8f);
    for (int i = 0; i < 12; ++i)
        for (int k = 0; k < 12; ++k)
            add_box(world, {-5 + 0.8f * float(i), 4 + 0.8f * float(k)}, 0.5f);
    Body bob = add_ball(world, {3, 22});
    DistanceJoint rope =
        world.create_distance_joint({.body_b = bob.id(), .anchor_a = {0, 25}, .anchor_b = {0, 0}});
    rope.set_hertz(2);
    world.create_mouse_joint({.body = bob.id(), .target = {5, 22}});
}

void build_compounds(World& world) {
    add_floor(world);
    for (int i = 0; i < 40; ++i) {
        Body body = world.create_body(
            {.position = {float(i % 8) * 1.5f - 6, 2 + float(i / 8) * 2.3f}, .angle = 0.1f});
        body.add(Polygon{.vertices = {{-1, 0}, {0.5f, 1}, {0, 2}}, .rounding = 0.02f});
        body.add(Polygon{.vertices = {{1, 0}, {-0.5f, 1}, {0, 2}}}, {.restitution = 0.4f});
        if (i % 3 == 0) body.add(Circle{.radius = 0.3f}, {.rolling_resistance = 0.1f});
        if (i % 5 == 0) body.add(Segment{.from = {-1, 0}, .to = {1, 0}, .rounding = 0.1f});
    }
}

}  // namespace

TEST_CASE("a restored stack goes on bit for bit") {
    World world;
    build_stack(world);
    check_restored(world, 40, 200);
}

TEST_CASE("a restored tumbler with joints goes on bit for bit") {
    World world;
    build_tumbler(world);
    check_restored(world, 120, 240);
}

TEST_CASE("restored compounds go on bit for bit") {
    World world;
    build_compounds(world);
    check_restored(world, 90, 240);
}

TEST_CASE("restored sleepers sleep on and wake as they would have") {
    World world;
    build_stack(world);
    run(world, 6.0f);
    REQUIRE(world.statistics().awake_bodies == 0);
    add_ball(world, {0.3f, 30.0f});  // comes down on them later
    check_restored(world, 10, 400);
}

TEST_CASE("bodies made and deleted since make no difference to a restored world") {
    World world({.bounds = Aabb{{-20, 0}, {20, 60}}});
    build_compounds(world);
    check_restored(world, 60, 200, [](World& w) {
        auto bodies = w.bodies();
        for (size_t i = 1; i < bodies.size(); i += 2) bodies[i].destroy();
        for (int i = 0; i < 70; ++i) add_ball(w, {float(i % 7), 20 + float(i)});
        w.set_gravity({3, -5});
    });
}

TEST_CASE("fast bodies and bullets go on bit for bit") {
    World world({.bounds = Aabb{{-20, 0}, {20, 60}}, .bounds_restitution = 1.0f});
    build_stack(world);
    for (int i = 0; i < 6; ++i) {
        Body ball = add_ball(world, {-15, 5 + float(i)}, 0.2f, {.restitution = 1});
        ball.set_bullet(i % 2 == 0);
        ball.set_velocity({150, 10});
    }
    check_restored(world, 20, 200);
}

TEST_CASE("edits that wait for the next step are part of a saved world") {
    World world;
    build_compounds(world);
    run(world, 1.0f);
    world.bodies()[3].shapes()[0].set_vertices(std::vector<Vec2>{{0, 0}, {2, 0}, {0, 1}});
    world.bodies()[5].set_position({0, 12});
    world.bodies()[7].apply_force({100, 0});
    world.bodies()[9].set_mass(infinity);
    check_restored(world, 0, 120);
}

TEST_CASE("handles to what was alive are valid again and to what was made since for ever not") {
    World world;
    add_floor(world);
    Body kept = add_ball(world, {0, 5});
    Body lost = add_box(world, {3, 5});
    Shape part = lost.shapes()[0];
    const auto bytes = saved(world);

    lost.destroy();
    Body later = add_ball(world, {6, 5});  // in the slot of `lost`
    REQUIRE(later.index() == lost.index());
    run(world, 0.5f);
    world.restore(bytes);
    REQUIRE(kept.is_valid());
    REQUIRE(lost.is_valid());
    REQUIRE(part.is_valid());
    REQUIRE(part.body() == lost);
    REQUIRE_FALSE(later.is_valid());

    Body other = add_ball(world, {6, 5});
    REQUIRE(other.id() != later.id());
    REQUIRE_FALSE(later.is_valid());
    lost.destroy();
    Body again = add_ball(world, {6, 5});
    REQUIRE(again.index() == later.index());
    REQUIRE_FALSE(later.is_valid());
    REQUIRE_FALSE(lost.is_valid());
}

TEST_CASE("assigning an older world does not give its generations twice") {
    World world;
    const World before = world;
    Body first = add_ball(world, {0, 0});
    world = before;
    Body second = add_ball(world, {0, 0});
    REQUIRE(second.is_valid());
    REQUIRE_FALSE(first.is_valid());
}

TEST_CASE("bytes that end early or belong to somebody else change nothing") {
    World world;
    build_tumbler(world);
    run(world, 1.0f);
    const auto bytes = saved(world);
    World target;
    build_stack(target);
    run(target, 0.3f);
    const auto before = saved(target);
    for (size_t size = 0; size < bytes.size(); size += 1 + size / 9) {
        const std::span<const std::byte> part(bytes.data(), size);
        REQUIRE_THROWS_AS(target.restore(part), std::invalid_argument);
    }
    auto longer = bytes;
    longer.push_back(std::byte{0});
    REQUIRE_THROWS_AS(target.restore(longer), std::invalid_argument);
    auto other = bytes;
    other[4] = std::byte{99};
    REQUIRE_THROWS_AS(target.restore(other), std::invalid_argument);
    REQUIRE((saved(target) == before));
    run(target, 0.3f);
    REQUIRE_FALSE(target.validate());
}

TEST_CASE("flipped bits are refused or leave a world that can be stepped") {
    World world({.bounds = Aabb{{-20, 0}, {20, 60}}});
    build_tumbler(world);
    build_stack(world);
    run(world, 1.0f);
    const auto bytes = saved(world);
    uint64_t state = 1;
    const auto next = [&state] {
        return state = state * 6364136223846793005u + 1442695040888963407u;
    };
    int refused = 0;
    for (int trial = 0; trial < 400; ++trial) {
        auto damaged = bytes;
        for (int flips = 0; flips < 3; ++flips)
            damaged[16 + (next() >> 20) % (bytes.size() - 16)] ^=
                std::byte(1 << (next() >> 60) % 8);
        World target;
        try {
            target.restore(damaged);
            for (int i = 0; i < 3; ++i) target.step(frame);
        } catch (const std::invalid_argument&) {
            ++refused;
        }
    }
    REQUIRE(refused > 0);
    REQUIRE(refused < 400);
}
