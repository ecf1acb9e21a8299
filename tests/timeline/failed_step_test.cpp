// A step in which a script failed is made again when the script is mended.

#include "catch.h"

#include "playing.h"

namespace failed_step_test {

using namespace fettle;
using namespace fettle::app;
using property::Value;

namespace {

/// A game whose `step` fails at step 40, after it has written something.
struct Failing : Playing {
    explicit Failing(const std::string& step = {})
        : Playing(
              "world.ball = Body { position = vec(0, 9), Circle {} }\n"
              "world.floor = Body { type = 'static', Box { width = 30 } }\n"
              "bad = false\n" +
              (step.empty() ? "function step(dt) world.ball.count = time.step "
                              "world.ball.velocity = world.ball.velocity + vec(0.1, 0) "
                              "if bad and time.step == 40 then error('at forty') end end"
                            : step)) {
        runtime->on_error([this](const script::ScriptError& error) {
            errors.push_back(error.message);
            loop->halt();
        });
    }
    void fail_at_40() {
        play(39);
        runtime->run("bad = true", "test");
        for (int i = 0; i < 3; ++i) loop->turn();
        REQUIRE(errors.size() == 1);
        REQUIRE(loop->halted());
        REQUIRE(services.clock.step == 40);
        runtime->run("bad = false", "test");
    }
    std::uint64_t hash_of_good_run(int steps) {
        Failing good;
        good.play(steps);
        return good.loop->hash();
    }
};

}  // namespace

TEST_CASE_METHOD(Failing, "the failed step is made again as if it had not failed") {
    fail_at_40();
    CHECK(loop->retry());
    CHECK(services.clock.step == 39);
    CHECK(loop->hash() == hashes[39]);
    for (int i = 0; i < 21; ++i) loop->turn();
    CHECK(services.clock.step == 60);
    CHECK(loop->hash() == hash_of_good_run(60));
    CHECK(errors.size() == 1);
}

TEST_CASE_METHOD(Failing, "an edit after the failure is there when the step is made again") {
    fail_at_40();
    console("world.ball.circle.restitution = 0.7");
    CHECK(loop->retry());
    CHECK(services.clock.step == 39);
    CHECK(get("world.ball.circle.restitution").number() == Approx(0.7));
    loop->turn();
    CHECK(services.clock.step == 40);
    CHECK(get("world.ball.circle.restitution").number() == Approx(0.7));
}

TEST_CASE_METHOD(Failing,
                 "an edit in the step before the failure survives going back and returning") {
    play(39);
    runtime->run("bad = true", "test");
    console("world.ball.circle.restitution = 0.7");
    for (int i = 0; i < 3; ++i) loop->turn();
    REQUIRE(errors.size() == 1);
    runtime->run("bad = false", "test");
    const auto edited = [&] { return get("world.ball.circle.restitution").number() > 0.6; };
    CHECK(edited());
    SECTION("to the newest step") {
        time().go_to(20);
        CHECK_FALSE(edited());
        time().go_to(time().newest());
        CHECK(services.clock.step == 39);
        CHECK(edited());
        CHECK(get("world.ball.count") == Value(39));  // and nothing of the failed step
    }
    SECTION("to its branch") {
        time().go_to(20);
        loop->resume();
        for (int i = 0; i < 5; ++i) loop->turn();
        CHECK_FALSE(edited());
        time().switch_to("1");
        CHECK(edited());
        CHECK(get("world.ball.count") == Value(39));
    }
    SECTION("when the step is made again") {
        CHECK(loop->retry());
        CHECK(edited());
        loop->turn();
        CHECK(services.clock.step == 40);
        CHECK(edited());
    }
    SECTION("when the game goes on after the failed step") {
        loop->resume();
        console("world.ball.circle.restitution = 0.9");
        loop->turn();
        const std::uint64_t now = loop->hash();
        for (int i = 0; i < 5; ++i) loop->turn();
        time().go_to(41);
        CHECK(loop->hash() == now);
        CHECK(get("world.ball.circle.restitution").number() == Approx(0.9));
    }
}

TEST_CASE_METHOD(Failing, "a game may also go on after the failed step") {
    fail_at_40();
    loop->resume();
    loop->turn();
    CHECK(services.clock.step == 41);
    const std::uint64_t now = loop->hash();
    const Value velocity = get("world.ball.velocity");
    for (int i = 0; i < 20; ++i) loop->turn();
    time().go_to(41);
    CHECK(loop->hash() == now);
    CHECK(get("world.ball.velocity") == velocity);
}

TEST_CASE_METHOD(Failing, "the past before a failed step can be shown and continued") {
    fail_at_40();
    time().go_to(20);
    CHECK(loop->hash() == hashes[20]);
    CHECK_FALSE(loop->retry());
    CHECK(services.clock.step == 20);
    for (int i = 0; i < 40; ++i) loop->turn();
    CHECK(services.clock.step == 60);
    CHECK(loop->hash() == hash_of_good_run(60));
}

TEST_CASE_METHOD(Failing,
                 "a game that an error has stopped runs on from the step it was taken back to") {
    fail_at_40();
    // As the time bar does.
    tree.set(tree.child(tree.root(), "time"), "paused", true);
    time().go_to(20);
    loop->retry();
    loop->turn();
    CHECK(services.clock.step == 21);
    CHECK_FALSE(services.clock.paused);
}

TEST_CASE_METHOD(Failing, "a game that was paused when it failed stays paused") {
    fail_at_40();
    loop->resume();
    tree.set(tree.child(tree.root(), "time"), "paused", true);
    loop->halt();
    time().go_to(20);
    loop->retry();
    loop->turn();
    CHECK(services.clock.step == 20);
}

TEST_CASE("a step whose handler failed is made again") {
    Failing game(
        "world.ball:on('contact_begin', function() if bad then error('hit') end "
        "world.ball.hits = 0 end)");
    game.play(39);
    game.runtime->run("bad = true", "test");
    int turns = 0;
    while (!game.loop->halted() && ++turns < 200) game.loop->turn();
    REQUIRE(game.loop->halted());
    const std::int64_t failed = game.services.clock.step;
    game.runtime->run("bad = false", "test");
    CHECK(game.loop->retry());
    CHECK(game.services.clock.step == failed - 1);
    game.loop->turn();
    CHECK(game.services.clock.step == failed);
    CHECK(game.errors.size() == 1);
    CHECK(game.get("world.ball.hits") == Value(0));
}

TEST_CASE("an edit after a handler failed keeps the failed step as it is") {
    Failing game("world.ball:on('contact_begin', function() if bad then error('hit') end end)");
    game.runtime->run("bad = true", "test");
    int turns = 0;
    while (!game.loop->halted() && ++turns < 200) game.loop->turn();
    REQUIRE(game.loop->halted());
    const std::int64_t failed = game.services.clock.step;
    game.runtime->run("bad = false", "test");
    game.console("world.ball.mass = 9");
    CHECK_FALSE(game.loop->retry());
    CHECK_FALSE(game.loop->halted());
    CHECK(game.services.clock.step == failed);
    CHECK(game.get("world.ball.mass").number() == Approx(9));
}

TEST_CASE("an error outside of a step repeats no step") {
    Failing game("function update(dt) if bad then error('now') end end");
    game.play(20);
    game.runtime->run("bad = true", "test");
    game.loop->turn();
    REQUIRE(game.loop->halted());
    game.runtime->run("bad = false", "test");
    const std::int64_t step = game.services.clock.step;
    CHECK_FALSE(game.loop->retry());
    CHECK(game.services.clock.step == step);
}

}  // namespace failed_step_test
