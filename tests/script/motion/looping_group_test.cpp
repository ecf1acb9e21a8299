// Groups of tweens that run several times.

#include <fettle/property/snapshot.h>

#include "stage.h"

namespace looping_group_test {

using stage::Stage;

namespace {

struct Game : Stage {
    Game() { run("ball = Body { mass = 1, friction = 0 } world.ball = ball"); }
    double mass() const { return get("world.ball.mass").as_double(); }
    double friction() const { return get("world.ball.friction").as_double(); }
    bool tweens() { return prints("print(#game.tweens)") != "0"; }
};

}  // namespace

TEST_CASE("a sequence runs as often as loops says, each time from its first values") {
    Game s;
    s.run(
        "g = tween.sequence { tween(ball, 'mass', 2, 0.25), tween(ball, 'mass', 4, 0.25), "
        "loops = 3 } "
        "g:on('finished', function(e) print('finished', e.step) end)");
    s.step(15);
    CHECK(s.mass() == Approx(2));
    s.step(15);
    CHECK(s.mass() == Approx(4));
    s.step(5);  // the second run begins with 1
    CHECK(s.mass() == Approx(1 + 1.0 / 3));
    CHECK(s.get("tweens.tween_group_1.progress").as_double() == Approx(1.0 / 6));
    s.step(55);
    CHECK(s.mass() == Approx(4));
    CHECK(stage::joined(s.printed) == "finished\t90");
    s.step();
    CHECK_FALSE(s.tweens());
    CHECK(s.errors.empty());
}

TEST_CASE("a sequence that alternates goes back the same way") {
    Game s;
    s.run(
        "g = tween.sequence { tween(ball, 'mass', 2, 0.25, 'in_quad'), 0.25, "
        "tween(ball, 'friction', 1, 0.5), loops = 0, alternate = true }");
    std::vector<std::pair<double, double>> there;
    for (int i = 0; i < 60; ++i) {
        s.step();
        there.emplace_back(s.mass(), s.friction());
    }
    CHECK(there.back().first == Approx(2));
    CHECK(there.back().second == Approx(1));
    for (int run = 0; run < 2; ++run) {
        for (int i = 58; i >= 0; --i) {
            s.step();
            INFO("back at " << i);
            CHECK(s.mass() == Approx(there[static_cast<std::size_t>(i)].first).margin(1e-9));
            CHECK(s.friction() == Approx(there[static_cast<std::size_t>(i)].second).margin(1e-9));
        }
        s.step();
        CHECK(s.mass() == Approx(1));
        for (int i = 0; i < 60; ++i) s.step();
        CHECK(s.friction() == Approx(1));
    }
    CHECK(s.tweens());
    s.run("g:stop()");
    CHECK_FALSE(s.tweens());
}

TEST_CASE("in a parallel group that goes back the shorter tween waits") {
    Game s;
    s.run(
        "tween.parallel { tween(ball, 'mass', 2, 0.5), tween(ball, 'friction', 1, 1), "
        "loops = 2, alternate = true }");
    s.step(60);
    CHECK(s.mass() == Approx(2));
    CHECK(s.friction() == Approx(1));
    s.step(15);
    CHECK(s.mass() == Approx(2));
    CHECK(s.friction() == Approx(0.75));
    s.step(30);
    CHECK(s.mass() == Approx(1.5));
    CHECK(s.friction() == Approx(0.25));
    s.step(15);
    CHECK(s.mass() == Approx(1));
    CHECK(s.friction() == Approx(0).margin(1e-9));
    s.step();
    CHECK_FALSE(s.tweens());
}

TEST_CASE("groups and tweens in a group that goes back do so with all their own runs") {
    Game s;
    s.run(
        "inner = tween(ball, 'mass', 2, 0.25) inner.loops = 2 "
        "tween.sequence { inner, tween.sequence { tween(ball, 'friction', 1, 0.25), loops = 2, "
        "alternate = true }, loops = 2, alternate = true }");
    std::vector<std::pair<double, double>> there;
    for (int i = 0; i < 60; ++i) {
        there.emplace_back(s.mass(), s.friction());
        s.step();
    }
    for (int i = 59; i > 0; --i) {
        s.step();
        // Where one run of a tween meets the next, both values are right.
        if (i % 15 == 0) continue;
        INFO("back at " << i);
        CHECK(s.mass() == Approx(there[static_cast<std::size_t>(i)].first).margin(1e-9));
        CHECK(s.friction() == Approx(there[static_cast<std::size_t>(i)].second).margin(1e-9));
    }
}

TEST_CASE("an endless group without length or without members does not hang") {
    Game s;
    s.run(
        "tween.sequence { tween(ball, 'mass', 2, 0), loops = 0 } "
        "tween.sequence { loops = 0 } "
        "tween.sequence { tween(ball, 'friction', 1, 1e-7), loops = 0 } "
        "other = Body {} world.other = other "
        "tween.parallel { tween(other, 'mass', 2, 1), loops = 0 }");
    s.step(3);
    CHECK(s.mass() == 2);
    s.run("world.other = nil");
    s.step(3);
    CHECK(s.prints("print(#game.tweens)") == "2");
    CHECK(s.errors.empty());
}

TEST_CASE("a group that loops goes on after a restore") {
    Game s;
    s.run(
        "tween.sequence { tween(ball, 'mass', 2, 0.25), tween(ball, 'mass', 4, 0.25), loops = 0, "
        "alternate = true }");
    s.step(40);
    const fettle::property::Snapshot taken = s.tree->snapshot();
    const double before = s.mass();
    s.step(7);
    const double after = s.mass();
    s.tree->restore(taken);
    CHECK(s.mass() == before);
    s.step(7);
    CHECK(s.mass() == after);
}

TEST_CASE("options of a group are checked") {
    Game s;
    CHECK_THAT(s.fails("tween.sequence { loop = 0 }"),
               contains("there is no option \"loop\" (did you mean \"loops\"?)"));
    CHECK_THAT(s.fails("tween.sequence { loops = -1 }"), contains("loops"));
    CHECK_FALSE(s.tweens());
    CHECK(s.prints("local g = tween.parallel { tween(ball, 'mass', 2, 1), pauses = false } "
                   "print(g.pauses, g.loops, g.alternate)") == "false\t1\tfalse");
}

}  // namespace looping_group_test
