#include "catch.h"
#include "fixture.h"

#include <algorithm>
#include <map>
#include <set>

namespace watching_many_test {

using namespace fettle::property;
using namespace fettle::property::testing;

namespace {

struct Fixture {
    explicit Fixture(std::size_t count = 6) {
        for (std::size_t i = 0; i < count; ++i) balls.push_back(tree.create(*module.type, world));
        tree.barrier();
    }
    void move(Handle ball, float x) { module.ball(ball).velocity[0] = x; }
    void step() {
        tree.set_step(tree.step() + 1);
        tree.stepped();
        tree.barrier();
    }
    const Property& velocity() { return *module.type->property("velocity"); }

    Tree tree;
    BallModule module{tree};
    Handle world = tree.create(tree.object_class(), tree.root(), "world");
    std::vector<Handle> balls;
};

struct Crowd : Fixture {
    Crowd() : Fixture(100'000) {}
};

}  // namespace

TEST_CASE_METHOD(Crowd, "a pattern for a hundred thousand instances reports those that moved") {
    std::map<std::string, int> heard;
    int wrong = 0;
    Connection pattern = tree.watch_pattern("world.*.velocity", [&](const Change& change) {
        ++heard[tree.path(change.instance)];
        wrong += change.cause.writer != Writer::simulation || change.cause.step != tree.step();
    });
    Connection narrow = tree.watch_pattern("world.ball_1000*.velocity", [&](const Change& change) {
        ++heard["narrow " + tree.path(change.instance)];
    });
    step();
    CHECK(heard.empty());
    for (const std::size_t moved : {std::size_t{4}, std::size_t{9'999}, std::size_t{99'999}})
        move(balls[moved], 1);
    step();
    CHECK(heard == std::map<std::string, int>{{"world.ball_5", 1},
                                              {"world.ball_10000", 1},
                                              {"world.ball_100000", 1},
                                              {"narrow world.ball_10000", 1},
                                              {"narrow world.ball_100000", 1}});
    CHECK(wrong == 0);
    pattern.stop();
    heard.clear();
    for (const Handle ball : balls) move(ball, 2);
    step();
    CHECK(heard.size() == 12);  // ball_1000, ball_10000 ... ball_10009, ball_100000
    narrow.stop();
    CHECK(tree.watcher_count() == 0);
}

TEST_CASE_METHOD(Fixture,
                 "instances match patterns or stop matching them when their names change") {
    std::vector<std::string> heard;
    tree.watch_pattern("world.ball_*.velocity",
                       [&](const Change& change) { heard.push_back(tree.name(change.instance)); });
    const Handle late = tree.create(*module.type, world);
    const Handle named = tree.create(*module.type, world, "hero");
    tree.rename(balls[0], "ghost");
    for (const Handle ball : {late, named, balls[0], balls[1]}) move(ball, 3);
    step();
    std::sort(heard.begin(), heard.end());
    CHECK(heard == std::vector<std::string>{"ball_2", "ball_7"});
    tree.rename(named, "ball_100");
    move(named, 4);
    step();
    CHECK(heard.back() == "ball_100");
}

TEST_CASE_METHOD(Fixture, "an edit and a simulated change of one cell are one change") {
    std::vector<Change> heard;
    tree.watch(balls[0], velocity(), [&](const Change& change) { heard.push_back(change); });
    tree.watch(balls[1], velocity(), [&](const Change& change) { heard.push_back(change); });
    tree.set(balls[0], velocity(), Vec2(5, 0));
    move(balls[0], 6);
    move(balls[1], 7);
    step();
    REQUIRE(heard.size() == 2);
    CHECK(heard[0].instance == balls[0]);
    CHECK(heard[0].old_value == Value(Vec2(0, 0)));
    CHECK(heard[0].new_value == Value(Vec2(6, 0)));
    CHECK(heard[0].cause.writer == Writer::simulation);
    CHECK(heard[1].new_value == Value(Vec2(7, 0)));
}

TEST_CASE_METHOD(Fixture,
                 "the last writer of a watched cell is the later of person and simulation") {
    tree.watch(balls[0], velocity(), [](const Change&) {});
    const auto who = [&] { return tree.last_writer(balls[0], velocity()).cause; };
    {
        const Tree::CauseScope console(tree, Writer::console);
        tree.set(balls[0], velocity(), Vec2(5, 0));
    }
    CHECK(who().writer == Writer::console);
    move(balls[0], 6);
    step();
    CHECK(who().writer == Writer::simulation);
    CHECK(who().step == 1);
    step();
    CHECK(who().step == 1);  // it did not move in the second step
    {
        const Tree::CauseScope console(tree, Writer::console);
        tree.set(balls[0], velocity(), Vec2(5, 0));
    }
    CHECK(who().writer == Writer::console);
    CHECK(who().step == 2);
}

TEST_CASE_METHOD(
    Fixture, "handlers of a simulated change may stop themselves and others and delete instances") {
    std::set<std::string> heard;
    std::vector<Connection> connections(balls.size());
    const auto on = [&](std::size_t i, std::function<void()> then) {
        connections[i] = tree.watch(balls[i], velocity(), [&, i, then](const Change&) {
            const std::string mine = std::to_string(i);
            then();
            heard.insert(mine);  // the captures of the handler still exist after it removed itself
        });
    };
    on(0, [&] { connections[0].stop(); });
    on(1, [&] { connections[2].stop(); });
    on(2, [] {});
    on(3, [&] { tree.destroy(balls[4]); });
    on(4, [] {});
    on(5, [&] { move(balls[5], 9); });
    for (const Handle ball : balls) move(ball, 1);
    step();
    CHECK(heard == std::set<std::string>{"0", "1", "3", "5"});
    heard.clear();
    for (const Handle ball : {balls[0], balls[1], balls[2], balls[3]}) move(ball, 2);
    tree.create(*module.type, world);
    connections[3].stop();
    step();
    CHECK(heard == std::set<std::string>{"1", "5"});
}

TEST_CASE_METHOD(Fixture,
                 "after an exception in a handler of a simulated change the others are called") {
    int heard = 0;
    for (const Handle ball : balls)
        tree.watch(ball, velocity(), [&, ball](const Change&) {
            ++heard;
            if (ball == balls[1]) throw std::runtime_error("no");
        });
    for (const Handle ball : balls) move(ball, 1);
    tree.stepped();
    CHECK_THROWS_AS(tree.barrier(), std::runtime_error);
    CHECK(heard == 6);
    std::string reported;
    tree.on_handler_error(
        [&](const HandlerError& error) { reported = error.path + ": " + error.message; });
    move(balls[1], 2);
    step();
    CHECK(reported == "world.ball_2.velocity: no");
}

TEST_CASE_METHOD(Fixture, "endless handlers are reported with their triggers") {
    const Property& mass = *module.type->property("mass");
    tree.watch(balls[1], velocity(), [&](const Change&) { tree.set(balls[2], mass, 2.0); });
    tree.watch(balls[2], mass, [&](const Change&) {
        tree.set(balls[2], mass, tree.get(balls[2], mass).number() + 1);
    });
    for (const Handle ball : balls) tree.watch(ball, velocity(), [](const Change&) {});
    for (const Handle ball : balls) move(ball, 1);
    tree.stepped();
    const std::string reported = message_of([&] { tree.barrier(); });
    CHECK(reported.find("world.ball_3.mass by module") != std::string::npos);
    CHECK(reported.find("world.ball_2.velocity by simulation") != std::string::npos);
    CHECK(reported.find("world.ball_1.velocity") == std::string::npos);
}

}  // namespace watching_many_test
