// What the physics will do, shown by a copy of the world.

#include "catch.h"
#include "game.h"

namespace ghosts_test {

using namespace fettle::physics_module::testing;
using namespace fettle;
using property::Record;

namespace {

struct Ahead : Game {
    std::vector<Record> ghosts(std::initializer_list<Value> arguments = {}) {
        return std::get<std::vector<Record>>(tree.call(world(), "ghosts", arguments));
    }
    std::vector<std::byte> state() { return tree.snapshot().to_bytes(); }
};

}  // namespace

TEST_CASE_METHOD(Ahead, "a ghost is where its body will be after the same steps") {
    floor();
    const Handle ball = body("Circle", {0, 3});
    set(shape_of(ball), "restitution", 0.5);
    set(ball, "velocity", Vec2(3, 0));
    step(5);
    const auto seen = ghosts({1.0});
    REQUIRE(seen.size() == 1);
    CHECK(seen[0].get("body") == ball);
    const List points = seen[0].get("points").list();
    REQUIRE(points.size() == 61);
    CHECK(points.front() == get(ball, "position"));
    for (std::size_t i = 1; i < points.size(); ++i) {
        step();
        REQUIRE(get(ball, "position") == points[i]);
    }
    CHECK(get(ball, "angle") == seen[0].get("angle"));
}

TEST_CASE_METHOD(Ahead, "a ghost that only turns has a point for each step") {
    set(world(), "gravity", Vec2(0, 0));
    const Handle wheel = body("Circle", {2, 3}), late = body("Circle", {6, 3});
    set(wheel, "angular_velocity", 2.0);
    set(late, "velocity", Vec2(1, 0));
    const auto seen = ghosts({1.0});
    REQUIRE(seen.size() == 2);
    for (const Record& each : seen) CHECK(each.get("points").list().size() == 61);
    CHECK(seen[0].get("points").list().back() == Vec2(2, 3));
}

TEST_CASE_METHOD(Ahead, "looking ahead is as long for bodies that move as before") {
    set(world(), "gravity", Vec2(0, 0));
    for (int i = 0; i < 1200; ++i)
        set(body("Circle", {3.0 * (i % 40), 3.0 * (i / 40)}), "velocity", Vec2(0.1, 0));
    const auto seen = ghosts({4.0});
    REQUIRE(seen.size() == 1200);
    CHECK(seen[0].get("points").list().size() == 241);
}

TEST_CASE_METHOD(Ahead, "looking ahead changes no bit of the game") {
    floor();
    for (int i = 0; i < 12; ++i) body(i % 2 == 0 ? "Box" : "Circle", {0.3 * i, 1.1 * i + 0.6});
    const Handle crate = body("Box", {-5, 4});
    step(40);
    // An edit leaves data out of date until the next step; looking ahead must not update them.
    set(shape_of(crate), "height", 2);
    set(crate, "velocity", Vec2(1, 5));
    Game twin;
    twin.floor();
    for (int i = 0; i < 12; ++i) twin.body(i % 2 == 0 ? "Box" : "Circle", {0.3 * i, 1.1 * i + 0.6});
    const Handle other = twin.body("Box", {-5, 4});
    twin.step(40);
    twin.set(twin.shape_of(other), "height", 2);
    twin.set(other, "velocity", Vec2(1, 5));
    REQUIRE(physics.hash() == twin.physics.hash());
    const auto before = state();
    CHECK(ghosts({2.0}).size() > 2);
    CHECK(state() == before);
    for (int i = 0; i < 60; ++i) {
        step();
        twin.step();
        REQUIRE(physics.hash() == twin.physics.hash());
    }
}

TEST_CASE_METHOD(Ahead, "a joint that was made since the last step acts in the ghosts") {
    const Handle post = body("Box", {0, 5}, "static"), ball = body("Circle", {3, 5});
    step(3);
    CHECK(ghosts({1.0}).size() == 1);
    // The rod measures its length when it begins to act.
    const Handle rod =
        make("DistanceJoint", world(), {{"body_a", Value(post)}, {"body_b", Value(ball)}});
    const auto before = state();
    const auto seen = ghosts({1.0});
    CHECK(state() == before);
    REQUIRE(seen.size() == 1);
    const List points = seen[0].get("points").list();
    CHECK((points.back().vec2() - Vec2(0, 5)).length() < 3.1);
    for (std::size_t i = 1; i < points.size(); ++i) {
        step();
        REQUIRE(get(ball, "position") == points[i]);
    }
    // Other bodies, and a deleted joint, are in the next look, too.
    const Handle crate = body("Box", {-3, 5});
    set(rod, "body_b", crate);
    CHECK((ghosts({1.0}).back().get("points").list().back().vec2() - Vec2(0, 5)).length() < 3.1);
    tree.destroy(rod);
    CHECK(ghosts({1.0}).back().get("points").list().back().vec2().y < 1);
}

TEST_CASE_METHOD(Ahead, "looking ahead calls no handlers of events or questions") {
    floor();
    const Handle ball = body("Circle", {0, 1});
    int called = 0;
    tree.on(ball, *tree.class_of(ball).event("contact_begin"),
            [&](const property::Occurrence&) { ++called; });
    tree.on(ball, *tree.class_of(ball).event("before_solve"),
            [&](const property::Occurrence&) { ++called; });
    step();
    CHECK_FALSE(ghosts({2.0}).empty());
    tree.barrier();
    CHECK(called == 0);
    step(60);
    CHECK(called > 0);
}

TEST_CASE_METHOD(Ahead, "a body that does not move has no ghost") {
    floor();
    body("Box", {8, 0.5}, "static");
    const Handle crate = body("Box", {0, 0.5});
    REQUIRE(falls_asleep(crate));
    CHECK(ghosts().empty());
    set(crate, "velocity", Vec2(2, 0));
    REQUIRE(ghosts().size() == 1);
    CHECK(ghosts()[0].get("points").list().size() == 121);
}

TEST_CASE_METHOD(Ahead,
                 "looking ahead takes a time up to a minute and ends early for many bodies") {
    CHECK_THROWS(ghosts({-1.0}));
    CHECK_THROWS(ghosts({61.0}));
    const Handle ball = body("Circle", {0, 3});
    CHECK(ghosts({0.0}).empty());
    CHECK(ghosts({60.0})[0].get("points").list().size() == 3601);
    // Without shapes they cost little, and they count all the same.
    for (int i = 0; i < 9999; ++i) make("Body", world(), {{"position", Vec2(3.0 * i, 50)}});
    const auto seen = ghosts({60.0});
    CHECK(seen.size() == 10'000);
    CHECK(seen[0].get("points").list().size() < 40);
    CHECK(tree.alive(ball));
}

}  // namespace ghosts_test
