// Kept steps are repeated with a change at their beginning.

#include <map>

#include "catch.h"

#include "playing.h"

namespace changed_past_test {

using namespace fettle;
using namespace fettle::app;
using property::Value;
using property::Vec2;

namespace {

constexpr const char* bounce = R"(
    world.floor = Body { type = "static", position = vec(0, -1), Box { width = 60, height = 2 } }
    world.ball = Body { position = vec(0, 4), Circle { radius = 0.5 } }
    world.other = Body { position = vec(6, 4), Circle { radius = 0.5 } }
    steps = 0
    function step(dt)
        steps = steps + 1
        if steps == 30 then world.other.velocity = vec(0, 9) end
        if steps == 50 then world.late = Body { position = vec(-6, 3), Box {} } end
    end
)";

struct Branching : Playing {
    using Positions = std::map<std::int64_t, Vec2>;
    Branching() : Playing(bounce) {}
    Positions branch(std::int64_t from, const std::function<void()>& change, const char* path) {
        Positions positions;
        time().repeat_with(from, change, [&](std::int64_t step) {
            CHECK(positions.emplace(step, get(path).vec2()).second);
        });
        return positions;
    }
    Positions as_it_was(std::int64_t from, const char* path) {
        Positions positions;
        time().review(from, [&](std::int64_t step) { positions.emplace(step, get(path).vec2()); });
        return positions;
    }
};

}  // namespace

TEST_CASE_METHOD(Branching, "a branch without a change is the past as it was") {
    play(120);
    const Positions was = as_it_was(20, "world.ball.position");
    CHECK(branch(
              20, [] {}, "world.ball.position") == was);
    CHECK(was.size() == 101);
}

TEST_CASE_METHOD(Branching, "a branch begins after the last restored snapshot") {
    play(40);
    const property::Snapshot kept = tree.snapshot();
    play(20);
    tree.restore(kept);
    play(30);
    const Positions was = as_it_was(20, "world.ball.position");
    CHECK(branch(
              20, [] {}, "world.ball.position") == was);
    CHECK(was.begin()->first == 40);
}

TEST_CASE_METHOD(Branching, "a branch differs by its change and leaves no trace") {
    play(120);
    const Positions was = as_it_was(20, "world.ball.position");
    const auto change = [&] { property::set(tree, "world.ball.circle.restitution", Value(0.9)); };
    const Positions other = branch(20, change, "world.ball.position");
    REQUIRE(other.size() == was.size());
    CHECK(other.at(20) == was.at(20));
    CHECK(other.at(120) != was.at(120));
    // Writes of scripts come from the log.
    CHECK(branch(20, change, "world.other.position") == as_it_was(20, "world.other.position"));
    REQUIRE(loop->hash() == hashes[120]);
    CHECK(get("world.ball.circle.restitution").number() != 0.9);
    CHECK(time().newest() == 120);
    for (const std::int64_t step : {25, 60, 119, 120}) check(step);
    // The game goes on as one that never branched.
    Branching twin;
    twin.play(160);
    play(40);
    CHECK(loop->hash() == twin.loop->hash());
}

TEST_CASE_METHOD(Branching, "a branch may be made from the past") {
    play(120);
    time().go_to(80);
    const Positions seen = branch(
        30, [] {}, "world.ball.position");
    CHECK(seen.begin()->first == 30);
    CHECK(seen.rbegin()->first == 80);
    REQUIRE(loop->hash() == hashes[80]);
    CHECK(time().newest() == 120);
    check(120);
}

TEST_CASE_METHOD(Branching, "an edit of an earlier step survives a review and a branch") {
    Branching twin;
    for (Branching* each : {static_cast<Branching*>(this), &twin}) {
        each->play(120);
        each->time().go_to(80);
        property::set(each->tree, "world.ball.circle.restitution", Value(0.75));
    }
    (void)as_it_was(30, "world.ball.position");
    (void)branch(
        30, [] {}, "world.ball.position");
    CHECK(get("world.ball.circle.restitution").number() == 0.75);
    REQUIRE(loop->hash() == twin.loop->hash());
    CHECK(time().newest() == 120);
    // The edit belongs to the step that follows.
    play(20);
    twin.play(20);
    CHECK(loop->hash() == twin.loop->hash());
    CHECK(time().newest() == 100);
    time().go_to(90);
    CHECK(get("world.ball.circle.restitution").number() == 0.75);
    time().go_to(80);
    CHECK(get("world.ball.circle.restitution").number() != 0.75);
}

TEST_CASE_METHOD(Branching, "an exception in a branch leaves the game as it was") {
    play(100);
    const auto nothing = [](std::int64_t) {};
    const auto fails = [] { throw std::runtime_error("no"); };
    CHECK_THROWS_WITH(time().repeat_with(50, fails, nothing), "no");
    REQUIRE(loop->hash() == hashes[100]);
    int looks = 0;
    CHECK_THROWS_WITH(time().repeat_with(
                          50, [] {},
                          [&](std::int64_t) {
                              if (++looks == 20) throw std::runtime_error("enough");
                          }),
                      "enough");
    CHECK(looks == 20);
    REQUIRE(loop->hash() == hashes[100]);
    CHECK_THROWS(time().repeat_with(
        500, [] {}, nothing));
    CHECK_THROWS(time().repeat_with(
        -1, [] {}, nothing));
    for (const std::int64_t step : {10, 70, 100}) check(step);
}

TEST_CASE_METHOD(Branching, "a write of a script that a branch refuses is left out") {
    play(60);
    // At step 30 the script sets the velocity of a body that cannot move in the branch.
    const Positions other = branch(
        20, [&] { property::set(tree, "world.other.type", Value("static")); },
        "world.other.position");
    CHECK(other.at(20) == other.at(60));
    CHECK(as_it_was(20, "world.other.position").at(60) != other.at(60));
    REQUIRE(loop->hash() == hashes[60]);
    CHECK(time().oldest() == 0);
    check(40);
    check(60);
}

}  // namespace changed_past_test
