#include "catch.h"
#include "fixture.h"

namespace instances_test {

using namespace fettle::property;
using namespace fettle::property::testing;

namespace {
struct Fixture {
    Tree tree;
    BallModule module{tree};
    Handle world = tree.create(tree.object_class(), tree.root(), "world");

    std::vector<std::string> child_names(Handle of) {
        std::vector<std::string> names;
        for (const Handle c : tree.children(of)) names.push_back(tree.name(c));
        return names;
    }
};
using Names = std::vector<std::string>;
}  // namespace

TEST_CASE_METHOD(Fixture, "children keep their order and equal names get numbers") {
    tree.create(*module.type, world);
    tree.create(*module.type, world, "odd name");
    tree.create(*module.type, world);
    CHECK(child_names(world) == Names{"ball_1", "odd name", "ball_2"});
    const Handle odd = tree.child(world, "odd name");
    CHECK(tree.path(odd) == "world[\"odd name\"]");
    CHECK(resolve(tree, "world[\"odd name\"].mass").instance == odd);
    tree.destroy(tree.child(world, "ball_2"));
    tree.create(*module.type, world);
    CHECK(child_names(world) == Names{"ball_1", "odd name", "ball_3"});
}

TEST_CASE_METHOD(Fixture, "the name of an instance without one has the words of its class") {
    for (const auto& [of, name] : {std::pair{"TextField", "text_field_1"},
                                   {"HUD", "hud_1"},
                                   {"HUDBar", "hud_bar_1"},
                                   {"Level2Boss", "level2_boss_1"},
                                   {"Ice_Crate", "ice_crate_1"},
                                   {"crate", "crate_1"}})
        CHECK(tree.name(tree.create(tree.define({.name = of}), world)) == name);
}

TEST_CASE_METHOD(Fixture, "a number is not used again after the deletion of the first child") {
    const auto next = [&](Handle parent) {
        const Handle made = tree.create(*module.type, parent);
        return std::pair(made, tree.name(made));
    };
    const auto [first, name] = next(world);
    CHECK(name == "ball_1");
    tree.destroy(first);
    CHECK(next(world).second == "ball_2");
    // After a move the first number is free again; after a renaming it stays used.
    const Handle shelf = tree.create(tree.object_class(), tree.root(), "shelf");
    tree.move(next(shelf).first, world);
    CHECK(next(shelf).second == "ball_2");
    const Handle box = tree.create(tree.object_class(), tree.root(), "box");
    tree.set(next(box).first, "name", "marble");
    CHECK(next(box).second == "ball_2");
    // A snapshot contains the used numbers, whether the child still exists or not.
    const Handle jar = tree.create(tree.object_class(), tree.root(), "jar");
    next(jar);
    Snapshot snapshot = tree.snapshot();
    CHECK(next(jar).second == "ball_2");
    CHECK(next(box).second == "ball_3");
    tree.restore(snapshot);
    CHECK(next(jar).second == "ball_2");
    CHECK(next(box).second == "ball_3");
    // A new parent in the same slot starts with the first number.
    tree.destroy(box);
    CHECK(next(tree.create(tree.object_class(), tree.root(), "bag")).second == "ball_1");
}

TEST_CASE_METHOD(Fixture, "the first unnamed child of a constructor has no number") {
    PlainNames names;
    for (int i = 0; i < 3; ++i) tree.move(tree.create(*module.type), world, "", &names);
    CHECK(child_names(world) == Names{"ball", "ball_2", "ball_3"});
}

TEST_CASE_METHOD(Fixture, "a renamed child keeps its place among its siblings") {
    for (const char* name : {"a", "b", "c"}) tree.create(*module.type, world, name);
    tree.set(tree.child(world, "a"), "name", "w");
    CHECK(child_names(world) == Names{"w", "b", "c"});
    CHECK_FALSE(tree.child(world, "a"));
    CHECK(tree.path(tree.child(world, "w")) == "world.w");
    CHECK_THAT(message_of([&] { tree.rename(tree.child(world, "w"), "b"); }),
               contains("has a child \"b\" already"));
    CHECK_THAT(
        message_of([&] { tree.create(tree.object_class(), tree.child(world, "w"), "mass"); }),
        contains("a property of Ball"));
}

TEST_CASE_METHOD(
    Fixture,
    "a dangling handle is detected and the error names who deleted the instance and when") {
    const Handle ball = tree.create(*module.type, world, "ball");
    tree.set_step(412);
    {
        Tree::CauseScope scope(tree, Writer::console);
        tree.destroy(ball);
    }
    CHECK_FALSE(tree.alive(ball));
    CHECK(message_of([&] { tree.get(ball, "mass"); }) ==
          "world.ball was deleted at step 412 by console");
}

TEST_CASE_METHOD(Fixture, "a handle never refers to the next instance in its slot") {
    const Handle ball = tree.create(*module.type, world, "ball");
    std::function<std::string()> locate = [] { return std::string("main.lua:7"); };
    {
        Tree::CauseScope scope(tree, Writer::script, &locate);
        tree.destroy(ball);
    }
    const Handle next = tree.create(*module.type, world, "ball");
    CHECK(next.index == ball.index);
    CHECK_FALSE(tree.alive(ball));
    CHECK(message_of([&] { tree.set(ball, "mass", 2); }) ==
          "world.ball was deleted at step 0 by main.lua:7");
    CHECK(tree.get(next, "mass") == Value(1.0));
}

TEST_CASE_METHOD(Fixture,
                 "deleting an instance deletes those below it and notifies the module of each") {
    const Handle ball = tree.create(*module.type, world, "ball");
    const Handle part = tree.create(*module.type, ball, "part");
    const Handle deep = tree.create(*module.type, part, "deep");
    tree.destroy(ball);
    CHECK(module.destroyed == 3);
    CHECK_FALSE(tree.alive(part));
    CHECK_FALSE(tree.alive(deep));
    CHECK(tree.child_count(world) == 0);
    CHECK_THROWS_AS(tree.destroy(tree.root()), Error);
}

TEST_CASE_METHOD(Fixture, "moving an instance moves those below it and cannot make a cycle") {
    const Handle ball = tree.create(*module.type);
    const Handle part = tree.create(*module.type, ball, "part");
    CHECK(tree.path(part) == "(detached ball).part");
    module.placed = 0;
    tree.move(ball, world);
    CHECK(module.placed == 2);
    CHECK(tree.path(part) == "world.ball_1.part");
    CHECK_THAT(message_of([&] { tree.move(world, part); }), contains("below itself"));
    CHECK(tree.is_below(part, world));
    tree.set(part, "parent", world);
    CHECK(tree.path(part) == "world.part");
    CHECK(tree.child_count(ball) == 0);
}

TEST_CASE_METHOD(Fixture,
                 "a hundred thousand instances are created and found by name and deleted") {
    std::vector<Handle> all;
    for (int i = 0; i < 100000; ++i) all.push_back(tree.create(*module.type, world));
    CHECK(tree.child(world, "ball_77777") == all[77776]);
    for (std::size_t i = 0; i < all.size(); i += 2) tree.destroy(all[i]);
    CHECK_FALSE(tree.child(world, "ball_1"));
    CHECK(tree.child(world, "ball_2") == all[1]);
    CHECK(tree.child_count(world) == 50000);
    tree.destroy(world);
    CHECK(tree.size() == 1);
}

TEST_CASE_METHOD(Fixture, "attached and detached children are found by name after random changes") {
    // The table of children moves entries on deletion; a simple list gives the expected results.
    std::vector<std::pair<std::string, Handle>> model;
    std::uint32_t seed = 7;
    const auto random = [&](std::uint32_t below) {
        seed = seed * 1664525u + 1013904223u;
        return (seed >> 8) % below;
    };
    for (int i = 0; i < 20000; ++i) {
        if (model.empty() || random(5) < 3) {
            const std::string name = "n" + std::to_string(random(3)) + "_" + std::to_string(i + 1);
            model.emplace_back(name, tree.create(*module.type, world, name));
        } else {
            const std::size_t at = random(static_cast<std::uint32_t>(model.size()));
            tree.destroy(model[at].second);
            model.erase(model.begin() + static_cast<std::ptrdiff_t>(at));
        }
    }
    REQUIRE(tree.child_count(world) == model.size());
    std::size_t found = 0;
    const std::vector<Handle> children = tree.children(world);
    for (std::size_t i = 0; i < model.size(); ++i)
        found +=
            tree.child(world, model[i].first) == model[i].second && children[i] == model[i].second;
    CHECK(found == model.size());
}

}  // namespace instances_test
