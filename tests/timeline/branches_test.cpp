// Branches of the past: what came later, where the game went on from an earlier step.

#include "catch.h"

#include "playing.h"

namespace branches_test {

using namespace fettle;
using namespace fettle::app;
using property::Value;
using property::Vec2;

namespace {

constexpr const char* bouncing = R"(
    world.floor = Body { type = "static", position = vec(0, -1), Box { width = 60, height = 2 } }
    world.ball = Body { position = vec(0, 4), Circle { radius = 0.5 } }
    function step(dt)
        if time.step % 40 == 0 then Body { position = vec(time.step / 10, 6), Box {} } end
    end
)";

/// A game that went back to step 50 of 120 and on with a heavier ball to step 90.
struct Forked : Playing {
    std::uint64_t end_of_first = 0, end_of_second = 0;

    Forked() : Playing(bouncing) {
        run(120);
        end_of_first = loop->hash();
        time().go_to(50);
        property::set(tree, "world.ball.circle.restitution", Value(0.875));
        run(40);
        end_of_second = loop->hash();
    }
    void run(int steps) {
        for (int i = 0; i < steps; ++i) loop->turn();
    }
    std::string names() {
        std::string all = get("time.branch").text() + ":";
        for (const Branch& branch : time().branches())
            all += " " + branch.name + " " + std::to_string(branch.fork) + "-" +
                   std::to_string(branch.newest);
        return all;
    }
};

}  // namespace

TEST_CASE_METHOD(Forked,
                 "later steps are kept as a branch when the game goes on from an earlier one") {
    CHECK(names() == "2: 1 50-120");
    CHECK(time().newest() == 90);
}

TEST_CASE_METHOD(Forked, "switching to a branch and back gives the same states bit for bit") {
    time().switch_to("1");
    CHECK(names() == "1: 2 50-90");
    CHECK(loop->hash() == end_of_first);
    CHECK(time().newest() == 120);
    time().switch_to("2");
    CHECK(names() == "2: 1 50-120");
    CHECK(loop->hash() == end_of_second);
    CHECK(get("world.ball.circle.restitution").number() == 0.875);
    // Each of its moments can still be gone to, and the game goes on as it would have.
    time().go_to(60);
    time().go_to(90);
    CHECK(loop->hash() == end_of_second);
    run(30);
    CHECK(names() == "2: 1 50-120");
}

TEST_CASE_METHOD(Forked, "a branch is reviewed without a trace in the present one") {
    std::vector<std::int64_t> steps;
    std::vector<double> bounce;
    time().review_branch("1", 70, [&](std::int64_t step) {
        steps.push_back(step);
        bounce.push_back(get("world.ball.circle.restitution").number());
    });
    REQUIRE(steps.size() == 51);
    CHECK(steps.front() == 70);
    CHECK(steps.back() == 120);
    CHECK(bounce.back() < 0.8);
    CHECK(loop->hash() == end_of_second);
    CHECK(names() == "2: 1 50-120");
    CHECK_THROWS_AS(
        time().review_branch("1", 70, [](std::int64_t) { throw std::runtime_error("no"); }),
        std::runtime_error);
    CHECK(loop->hash() == end_of_second);
}

TEST_CASE_METHOD(Forked, "branches of branches leave the present one where they left it") {
    time().go_to(70);
    run(10);  // "3" leaves "2" at 70
    CHECK(names() == "3: 1 50-120 2 70-90");
    time().switch_to("1");
    CHECK(names() == "1: 2 50-90 3 50-80");
    time().switch_to("3");
    CHECK(names() == "3: 2 70-90 1 50-120");
    time().go_to(40);
    run(1);
    CHECK(names() == "4: 2 40-90 1 40-120 3 40-80");
}

TEST_CASE_METHOD(Forked, "edits at the end of a branch are kept with it") {
    property::set(tree, "world.ball.circle.friction", Value(0.125));
    time().switch_to("1");
    CHECK(get("world.ball.circle.friction").number() != 0.125);
    time().switch_to("2");
    CHECK(get("world.ball.circle.friction").number() == 0.125);
}

TEST_CASE_METHOD(Forked, "scripts list name switch and forget branches") {
    runtime->run(R"(
        local all = time:branches()
        print(#all, all[1].name, all[1].fork, all[1].newest, time.branch)
        time:name_branch("bouncy")
        time:name_branch("dull", "1")
        print(time.branch, time:branches()[1].name)
        print(pcall(time.name_branch, time, "dull"))
        print(pcall(time.switch_to, time, "dul"))
        time:switch_to("dull")
    )",
                 "test");
    loop->turn();
    REQUIRE(printed.size() == 4);
    CHECK(printed[0] == "1\t1\t50\t120\t2");
    CHECK(printed[1] == "bouncy\tdull");
    CHECK(printed[2].find("there is a branch \"dull\" already") != std::string::npos);
    CHECK(printed[3].find("\"dull\"") != std::string::npos);
    CHECK(get("time.branch").text() == "dull");
    runtime->run("time:forget_branch('bouncy')", "test");
    loop->turn();
    CHECK(time().branches().empty());
    CHECK_THROWS_AS(time().name_branch("dull", ""), property::Error);
    CHECK_THROWS_AS(time().name_branch("dull", "a\nb"), property::Error);
    CHECK_THROWS_AS(time().switch_to("dull"), property::Error);
    CHECK_THROWS_AS(time().forget_branch("gone"), property::Error);
}

TEST_CASE_METHOD(Forked, "branches beyond the limit are dropped and named ones last") {
    property::set(tree, "time.branch_limit", Value(2));
    time().name_branch("1", "first");
    for (int i = 0; i < 3; ++i) {
        time().go_to(60);
        run(5);
    }
    const auto all = time().branches();
    REQUIRE(all.size() == 2);
    CHECK(all[0].name == "first");
    property::set(tree, "time.branch_limit", Value(0));
    time().go_to(60);
    run(1);
    CHECK(time().branches().empty());
}

TEST_CASE_METHOD(Forked,
                 "a branch is dropped when the kept past no longer contains its beginning") {
    property::set(tree, "time.rewind_limit", Value(2.0));
    run(170);  // to step 260, of which 140 is the first that is kept
    CHECK(time().branches().empty());
    CHECK(time().memory() < 128u << 20);
}

TEST_CASE_METHOD(Forked, "branches are dropped before the past gets shorter") {
    runtime->run("for i = 1, 3000 do Body { position = vec(i, 9), Box {} } end", "test");
    run(20);
    for (int i = 0; i < 4; ++i) {
        time().go_to(100);
        run(90);
    }
    REQUIRE(time().branches().size() > 1);
    const std::int64_t oldest = time().oldest();
    property::set(tree, "time.rewind_memory",
                  Value(static_cast<double>(time().memory()) / 1048576.0 - 0.2));
    const std::size_t before = time().branches().size();
    run(1);
    CHECK(time().branches().size() < before);
    CHECK(time().oldest() == oldest);
}

TEST_CASE("branches that a script leaves do not push out those of a person") {
    Playing game(R"(
        world.ball = Body { position = vec(0, 4), Circle {} }
        function step(dt) if back and time.step % 10 == 9 then rewind(0.1) back = false end end
    )");
    std::vector<std::string> told;
    game.time().on_dropped_branch([&](const std::string& line) { told.push_back(line); });
    const auto run = [&](int steps) {
        for (int i = 0; i < steps; ++i) game.loop->turn();
    };
    const auto script_goes_back = [&] {
        game.runtime->run("back = true", "test");
        run(20);
    };
    const auto names = [&] {
        std::string all = game.get("time.branch").text() + ":";
        for (const Branch& branch : game.time().branches()) all += " " + branch.name;
        return all;
    };
    run(40);
    game.time().go_to(30);
    run(20);
    CHECK(names() == "2: 1");
    for (int i = 0; i < 3; ++i) script_goes_back();
    CHECK(names() == "5: 1 2 3 4");
    CHECK(told.empty());
    script_goes_back();
    script_goes_back();
    CHECK(names() == "7: 1 4 5 6");
    REQUIRE(told.size() == 1);
    CHECK(told[0].find("branch \"2\" is dropped: time.branch_limit is 4") == 0);
    try {
        game.time().switch_to("2");
        FAIL();
    } catch (const property::Error& error) {
        CHECK(std::string(error.what()) == "the branch \"2\" was dropped: time.branch_limit is 4");
    }
    // Those of persons are dropped last, each with a line.
    for (int i = 0; i < 4; ++i) {
        game.time().go_to(game.get("time.step").integer() - 5);
        run(8);
    }
    CHECK(names() == "11: 7 8 9 10");
    CHECK(told.size() == 2);
    CHECK(told.back() == "branch \"1\" is dropped: time.branch_limit is 4");
}

}  // namespace branches_test
