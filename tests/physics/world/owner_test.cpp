#include <fettle/physics/host_access.h>
#include <functional>
#include <memory>
#include <set>
#include <string>

#include "catch.h"
#include "every_method.h"

namespace owner_test {

// A world with an owner: only the owner creates and destroys its objects.

using namespace scenes;

namespace {

const std::set<std::string>& kept_for_the_owner() {
    static const std::set<std::string> names = {
        "Body::add",           "Body::destroy",        "Body::set_user_data", "Field::destroy",
        "Joint::destroy",      "Joint::set_user_data", "Shape::attach",       "Shape::destroy",
        "Shape::detach",       "Shape::set_user_data", "World::clear",        "World::create_body",
        "World::create_field", "World::create_shape",  "World::operator=",    "World::restore",
        "World::take"};
    return names;
}

std::string message_of(const std::function<void()>& act) {
    try {
        act();
    } catch (const Locked& error) {
        return error.what();
    }
    return "no error";
}

bool kept(const std::string& name) {
    return kept_for_the_owner().contains(name) ||
           (name.starts_with("World::create_") && name.ends_with("_joint"));
}

}  // namespace

TEST_CASE("only the owner of a world creates and destroys its objects") {
    World world;
    Things things = make_things(world);
    Owner owner("it belongs to a tree: destroy the instance instead");
    world.save(things.bytes);
    world.set_owner(&owner);
    const auto hash = world.hash();
    std::set<std::string> refused;
    for (const Method& method : every_method()) {
        if (!method.edits || !kept(std::string(method.name))) continue;
        INFO(method.name);
        const std::string error = message_of([&] { method.call(things); });
        const std::string name(method.name);
        CHECK(error == name + ": it belongs to a tree: destroy the instance instead");
        if (error.starts_with(name)) refused.insert(name);
    }
    for (const std::string& name : kept_for_the_owner())
        if (name != "World::operator=" && name != "World::take") CHECK(refused.contains(name));
    World other;
    REQUIRE_THROWS_AS(world.restore(other), Locked);
    REQUIRE_THROWS_AS(world = World(), Locked);
    REQUIRE_THROWS_AS(other.take(std::move(world)), Locked);
    REQUIRE_THROWS_AS(world.take(std::move(other)), Locked);
    REQUIRE(world.hash() == hash);
    REQUIRE_FALSE(world.validate());

    // Other code may do everything else, also with a copy.
    things.body.set_velocity({1, 0});
    world.step(frame);
    World copy = world.clone();
    copy.clear();
    REQUIRE(copy.body_count() == 0);

    {
        const Owner::Acting acting(owner);
        things.third.destroy();
        REQUIRE_NOTHROW(world.create_body());
    }
    REQUIRE_THROWS_AS(things.other.destroy(), Locked);
    world.set_owner(nullptr);
    world.clear();
    REQUIRE(world.body_count() == 0);
}

TEST_CASE("only the owner changes the kind and the user data of a field and anyone its numbers") {
    World world;
    Field field = world.create_field({.force = WindField{}, .user_data = 7});
    Owner owner("it belongs to a tree");
    world.set_owner(&owner);
    FieldDef def = field.definition();
    def.enabled = false;
    field.set(def);
    REQUIRE_FALSE(field.definition().enabled);
    def.user_data = 8;
    REQUIRE_THROWS_AS(field.set(def), Locked);
    def = field.definition();
    def.force = DragField{};
    REQUIRE_THROWS_AS(field.set(def), Locked);
    REQUIRE(field.definition().user_data == 7);
}

TEST_CASE("a callback that has the last reference to its world may be replaced") {
    for (int which = 0; which < 4; ++which) {
        auto world = std::make_shared<World>();
        const std::weak_ptr<World> life = world;
        World& of = *world;
        Body body = of.create_body();
        body.add(Circle{});
        if (which == 0) of.set_filter([world](const Shape&, const Shape&) { return true; });
        if (which == 1) of.set_mixing([world](ContactEdit&) {});
        if (which == 2) of.set_before_solve([world](ContactEdit&) {});
        if (which == 3) HostAccess::on_refresh(of, [world](const Refresh&) {});
        world.reset();
        REQUIRE_FALSE(life.expired());
        if (which == 0) of.set_filter({});
        if (which == 1) of.set_mixing({});
        if (which == 2) of.set_before_solve({});
        if (which == 3) HostAccess::on_refresh(of, {});
        CHECK(life.expired());
        CHECK_FALSE(body.is_valid());
    }
}

TEST_CASE("a function that an owner calls may replace itself") {
    Owner owner("ask it");
    World world;
    world.set_owner(&owner);
    auto held = std::make_shared<int>();
    const std::weak_ptr<int> life = held;
    bool lived = false;
    owner.on_unlocked([held = std::move(held), &owner, &life, &lived] {
        const std::weak_ptr<int>& watched = life;
        bool& result = lived;
        owner.on_unlocked({});
        result = !watched.expired();
    });
    world.step(frame);
    CHECK(lived);
}

}  // namespace owner_test
