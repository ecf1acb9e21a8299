// Watchers of simulated values and of derived values.

#include "catch.h"
#include "game.h"

namespace watching_test {

using namespace fettle::physics_module::testing;
using namespace fettle;

TEST_CASE_METHOD(Game, "a watcher of a position is called for every step that moved it") {
    const Handle ball = body("Circle", {0, 10});
    std::vector<property::Change> changes;
    auto connection =
        tree.watch(ball, "position", [&](const property::Change& c) { changes.push_back(c); });
    step(3);
    REQUIRE(changes.size() == 3);
    CHECK(changes[0].old_value == Vec2(0, 10));
    CHECK(changes[1].old_value == changes[0].new_value);
    CHECK(changes[2].new_value == get(ball, "position"));
    CHECK(changes[2].cause.writer == property::Writer::simulation);
    CHECK(changes[2].cause.step == 3);
    connection.stop();
    step(3);
    CHECK(changes.size() == 3);
    CHECK(tree.watcher_count() == 0);
}

TEST_CASE_METHOD(Game, "a watcher of a sleeping body is not called") {
    floor();
    const Handle ball = body("Circle", {0, 0.5});
    REQUIRE(falls_asleep(ball));
    int calls = 0;
    tree.watch(ball, [&](const property::Change&) { ++calls; });
    step(10);
    CHECK(calls == 0);
}

TEST_CASE_METHOD(Game, "a watcher of the inertia is called when a vertex is edited") {
    const Handle stone = make("Body", world(), "stone");
    make("Polygon", stone, "hull");
    tree.barrier();
    std::vector<property::Change> changes;
    for (const char* name : {"inertia", "mass", "center"})
        tree.watch(stone, name, [&](const property::Change& c) { changes.push_back(c); });
    const double before = number(stone, "inertia");
    property::set(tree, "world.stone.hull.vertices[3]", Vec2(0, 2));
    tree.barrier();
    REQUIRE(changes.size() == 3);
    for (const property::Change& change : changes)
        if (change.property->name == "inertia") {
            CHECK(change.old_value.number() == before);
            CHECK(change.new_value.number() == number(stone, "inertia"));
            CHECK(change.new_value.number() > before);
        }
}

TEST_CASE_METHOD(Game, "a watcher of contacts gets the new list of touched bodies") {
    floor();
    const Handle ball = body("Circle", {0, 2});
    std::vector<std::string> log;
    tree.watch(ball, "contacts",
               [&](const property::Change& c) { log.push_back(tree.text(c.new_value)); });
    step(60);
    set(ball, "position", Vec2(0, 20));
    step(2);
    CHECK(log == std::vector<std::string>{"{world.body_1}", "{}"});
}

TEST_CASE_METHOD(Game, "a watcher of awake is called when a body falls asleep and when it wakes") {
    floor();
    const Handle ball = body("Circle", {0, 0.5});
    std::vector<bool> log;
    tree.watch(ball, "awake",
               [&](const property::Change& c) { log.push_back(c.new_value.boolean()); });
    REQUIRE(falls_asleep(ball));
    set(world(), "gravity", Vec2(0, -9));
    step(2);
    CHECK(log == std::vector<bool>{false, true});
}

TEST_CASE_METHOD(Game, "a pattern can watch every velocity in the world") {
    const Handle a = body("Circle", {0, 10}), b = body("Circle", {5, 10});
    int calls = 0;
    tree.watch_pattern("world.*.velocity", [&](const property::Change& c) {
        calls += c.instance == a || c.instance == b;
    });
    step(2);
    CHECK(calls == 4);
}

TEST_CASE_METHOD(Game,
                 "a write and the change of the same value by the step are two changes in order") {
    const Handle ball = body("Circle", {0, 10});
    std::vector<double> heights;
    tree.watch(ball, "position",
               [&](const property::Change& c) { heights.push_back(c.new_value.vec2().y); });
    set(ball, "position", Vec2(0, 50));
    step();
    REQUIRE(heights.size() == 2);
    CHECK(heights[0] == 50);
    CHECK(heights[1] < 50);
}

}  // namespace watching_test
