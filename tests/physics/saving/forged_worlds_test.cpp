#include "catch.h"
#include "saved_worlds.h"
#include "world_inside.h"

#include <functional>

// Saved worlds whose lists and numbers contradict each other, sealed with a valid checksum: they
// are refused, since a step would not end, or would use memory that it does not own.

namespace forged_worlds_test {

using namespace fettle::physics;
using detail::WorldData;

namespace {

/// Two crates on a floor, of which one has unusual traits and one sleeps; fields and free slots.
World sample() {
    World world;
    Body floor = world.create_body({.type = BodyType::static_body});
    floor.add(Box{.width = 20});
    world.create_body({.position = {0, 1}, .name = "crate"}).add(Box{});
    world.create_body({.position = {3, 2}, .max_speed = 5}).add(Polygon{{{0, 0}, {1, 0}, {0, 1}}});
    world.create_body({.position = {6, 2}, .awake = false}).add(Box{});
    world.create_body({.position = {9, 2}, .name = "gone"}).destroy();
    world.create_body({.position = {12, 2}}).add(Ellipse{});
    world.create_field({.force = WindField{}});
    world.create_field({.force = DragField{}}).destroy();
    world.create_shape(Box{}).destroy();
    world.step(1.0f / 60);
    return world;
}

constexpr uint32_t floor_body = 1, crate = 2, limited = 3, sleeping = 4;

/// The reason why the world that `forge` has changed is refused; empty if it is not.
std::string refused(const std::function<void(WorldData&)>& forge) {
    World world = sample();
    forge(detail::WorldInside::of(world));
    const std::vector<std::byte> bytes = scenes::saved(world);
    World target;
    try {
        target.restore(bytes);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return {};
}

}  // namespace

TEST_CASE("the unchanged sample of the forged worlds is restored") {
    REQUIRE(refused([](WorldData&) {}).empty());
}

TEST_CASE("a forged world in which a body without an island has a next body is refused") {
    REQUIRE(refused([](WorldData& data) {
                data.bodies[crate].lists.next = sleeping;
            }).ends_with("body 2 is in no island but linked to another body"));
    REQUIRE(refused([](WorldData& data) {
                data.bodies[floor_body].lists.next = floor_body;
            }).ends_with("body 1 is in no island but linked to another body"));
}

TEST_CASE("a forged world with an awake body that cannot move is refused") {
    REQUIRE(refused([](WorldData& data) {
                data.bodies[crate].mobility = detail::Mobility::fixed;
            }).ends_with("body 2 is awake and cannot move"));
    REQUIRE(refused([](WorldData& data) {
                data.bodies[crate].type = BodyType::static_body;
            }).ends_with("body 2 has a mobility that does not fit its type"));
}

TEST_CASE("a forged world in which bodies share their rare values is refused") {
    REQUIRE(refused([](WorldData& data) {
                data.bodies[limited].traits = data.bodies[crate].traits;
            }).ends_with("body 3 shares its traits with another one"));
    REQUIRE(refused([](WorldData& data) {
                data.bodies[limited].traits = detail::none;
            }).ends_with("the number of unusual traits of bodies is wrong"));
    REQUIRE(refused([](WorldData& data) {
                data.trait_slots.free = data.bodies[crate].traits;
            }).ends_with("the list of free traits is wrong"));
}

TEST_CASE("a forged world with a used slot in a list of free slots is refused") {
    REQUIRE(refused([](WorldData& data) {
                ++data.island_slots.count;
            }).ends_with("the number of islands is wrong"));
    REQUIRE(refused([](WorldData& data) {
                data.island_slots.free = data.bodies[sleeping].lists.island;
            }).ends_with("the list of free islands is wrong"));
    REQUIRE(refused([](WorldData& data) {
                --data.field_slots.count;
            }).ends_with("the number of fields is wrong"));
    REQUIRE(refused([](WorldData& data) {
                data.field_slots.free = 0;
            }).ends_with("the list of free fields is wrong"));
    REQUIRE(refused([](WorldData& data) {
                data.pool.release(data.forms[4].begin, 4);
            }).ends_with("the list of free vertices is wrong"));
}

TEST_CASE("a forged world that lists a destroyed contact as awake is refused") {
    REQUIRE(refused([](WorldData& data) {
                REQUIRE(!data.awake_contacts.empty());
                const uint32_t slot = data.contact_slots.allocate(data.contact_links, data.contacts,
                                                                  data.manifold_poses);
                data.contact_slots.release(data.contact_links, slot);
                data.contacts[slot].awake_index = 0;
            }).ends_with("is destroyed but still listed"));
}

TEST_CASE("a forged world that lists a moved shape twice is refused") {
    const auto list = [](std::vector<uint32_t> moved) {
        return refused([&](WorldData& data) {
            for (const uint32_t shape : moved) data.shapes[shape].moved = true;
            data.moved_shapes = moved;
        });
    };
    REQUIRE(list({5, 6}).empty());
    REQUIRE(list({5, 6, 5}).ends_with("the list of moved shapes is wrong"));
}

// Each of these lists, followed once for each of its owners, has ten billion elements and more.
TEST_CASE("a forged world whose owners share lists is refused in linear time") {
    World world = sample();
    for (int i = 0; i < 20'000; ++i) world.create_body({.position = {float(i), 50}});
    WorldData& data = detail::WorldInside::of(world);
    const auto refuses = [&] {
        const std::vector<std::byte> bytes = scenes::saved(world);
        REQUIRE_THROWS_AS(World().restore(bytes), std::invalid_argument);
    };
    SECTION("islands that share their bodies") {
        for (uint32_t body = 1; body + 1 < data.bodies.size(); ++body)
            data.bodies[body].lists.next = body + 1;
        detail::Island shared;
        shared.first = 1;
        data.islands.assign(500'000, shared);
        refuses();
    }
    SECTION("bodies that share their joints") {
        for (int i = 0; i < 250'000; ++i) world.create_joint(JointType::weld);
        for (uint32_t joint = 0; joint + 1 < data.joints.size(); ++joint)
            data.joints[joint].edges[0].next = (joint + 1) << 1;
        for (detail::BodyRecord& body : data.bodies) body.lists.first_joint = 0;
        refuses();
    }
}

TEST_CASE("a forged world with shapes that share vertices or lack proxies is refused") {
    REQUIRE(refused([](WorldData& data) {
                data.forms[5].begin = data.forms[4].begin;
            }).ends_with("shape 5 has the vertices of another one"));
    REQUIRE(refused([](WorldData& data) {
                detail::ShapeRecord& shape = data.shapes[4];
                data.fixed_tree.remove(shape.proxy);
                shape.proxy = detail::Tree::none;
            }).ends_with("shape 4 is in no tree"));
}

TEST_CASE("a forged world with values derived from shapes out of their range is refused") {
    const auto refuses = [](auto change) { return !refused(change).empty(); };
    REQUIRE(refuses([](WorldData& data) { data.shapes[5].area = -1; }));
    REQUIRE(refuses([](WorldData& data) { data.shapes[5].moment = -1; }));
    REQUIRE(refuses([](WorldData& data) { data.shapes[5].centroid.x = 1e30f; }));
    REQUIRE(refuses([](WorldData& data) { data.forms[5].radius = 1e30f; }));
    REQUIRE(refuses([](WorldData& data) { data.bodies[crate].center.y = 1e30f; }));
    REQUIRE(refuses([](WorldData& data) { data.bodies[crate].local_center.y = -1e30f; }));
    const auto vertex = [](WorldData& data) { return data.forms[5].begin; };
    REQUIRE(refuses([&](WorldData& data) { data.pool.vertices[vertex(data)].x = infinity; }));
    const auto radii = [](WorldData& data) { return data.forms[8].begin + 1; };
    REQUIRE(refuses([&](WorldData& data) { data.pool.local[radii(data)].x = 1e30f; }));
    REQUIRE(refuses([&](WorldData& data) { data.pool.vertices[radii(data)].y = 0; }));
    REQUIRE(refuses([&](WorldData& data) { data.pool.directions[vertex(data)].y = 1e30f; }));
}

}  // namespace forged_worlds_test
