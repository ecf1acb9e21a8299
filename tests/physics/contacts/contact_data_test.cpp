#include <algorithm>

#include "catch.h"
#include "saved_worlds.h"
#include "scenes.h"

// Numbers of the host for contacts.

namespace contact_data_test {

using namespace scenes;

namespace {

ContactId pair_of(const Body& a, const Body& b) {
    return ContactId::of(a.shapes()[0].id(), b.shapes()[0].id());
}

/// Two boxes that lie on the floor.
struct Lying {
    World world;
    Body floor = add_floor(world);
    Body left = add_box(world, {0, 0.5f}), right = add_box(world, {5, 0.5f});
    ContactId of_left = pair_of(left, floor), of_right = pair_of(right, floor);

    Lying() { world.step(frame); }
};

}  // namespace

TEST_CASE("a contact has a number until its shapes separate") {
    Lying scene;
    World& world = scene.world;
    REQUIRE(world.contact_data(scene.of_left) == 0);
    world.set_contact_data(scene.of_left, 7);
    world.set_contact_data({scene.of_right.shape_b, scene.of_right.shape_a}, 9);  // in any order
    for (int i = 0; i < 120; ++i) {  // also while they sleep
        world.step(frame);
        REQUIRE(world.contact_data({scene.of_left.shape_b, scene.of_left.shape_a}) == 7);
        REQUIRE(world.contact_data(scene.of_right) == 9);
    }
    REQUIRE_FALSE(scene.left.awake());
    scene.left.set_position({0, 20});
    world.step(frame);
    REQUIRE(world.events().contact_end.at(0).id() == scene.of_left);
    REQUIRE(world.contact_data(scene.of_left) ==
            7);  // still readable for handlers of the end event
    world.step(frame);
    REQUIRE(world.contact_data(scene.of_left) == 0);
    scene.left.set_position({0, 0.5f});
    world.step(frame);
    REQUIRE(world.is_touching(scene.of_left));
    REQUIRE(world.contact_data(scene.of_left) == 0);  // another contact
    world.set_contact_data(scene.of_right, 0);
    REQUIRE(world.contact_data(scene.of_right) == 0);
    REQUIRE_FALSE(world.validate());
}

TEST_CASE("the number of a contact outlives a destroyed shape by one step") {
    Lying scene;
    scene.world.set_contact_data(scene.of_left, 7);
    scene.left.destroy();
    scene.world.step(frame);
    REQUIRE(scene.world.events().contact_end.at(0).id() == scene.of_left);
    REQUIRE(scene.world.contact_data(scene.of_left) == 7);
    Body next = add_box(scene.world, {0, 0.5f});  // takes the same slots
    scene.world.step(frame);
    REQUIRE(scene.world.contact_data(scene.of_left) == 0);
    REQUIRE(scene.world.contact_data(pair_of(next, scene.floor)) == 0);
}

TEST_CASE("numbers of contacts are saved and copied with the world") {
    Lying scene;
    scene.world.set_contact_data(scene.of_left, 7);
    World copy = scene.world.clone(), restored;
    restored.restore(saved(scene.world));
    scene.world.set_contact_data(scene.of_left, 8);
    for (World* each : {&copy, &restored}) {
        each->step(frame);
        REQUIRE(each->contact_data(scene.of_left) == 7);
    }
    REQUIRE(scene.world.contact_data(scene.of_left) == 8);
}

TEST_CASE("shapes that do not touch have no number") {
    Lying scene;
    World& world = scene.world;
    REQUIRE_THROWS_WITH(world.set_contact_data(pair_of(scene.left, scene.right), 1),
                        contains("do not touch"));
    REQUIRE_THROWS_WITH(world.set_contact_data({}, 1), contains("do not touch"));
    REQUIRE_NOTHROW(world.set_contact_data({}, 0));
    REQUIRE(world.contact_data({}) == 0);
    uint64_t read = 0;
    world.set_contact_data(scene.of_left, 7);
    world.set_before_solve([&](ContactEdit& contact) {
        read = std::max(
            read, world.contact_data(ContactId::of(contact.shape_a.id(), contact.shape_b.id())));
        world.set_contact_data(scene.of_left, 8);
    });
    REQUIRE_THROWS_AS(world.step(frame), Locked);
    REQUIRE(read == 7);
    REQUIRE(world.contact_data(scene.of_left) == 7);
}

}  // namespace contact_data_test
