// Who wrote a value last, after going through the past.

#include "catch.h"

#include "playing.h"

namespace writers_test {

using namespace fettle;
using namespace fettle::app;
using property::Cause;
using property::Value;
using property::Writer;

namespace {

constexpr const char* writing = R"(
    world.ball = Body { position = vec(0, 4), Circle {}, name = "ball" }
    world.crate = Body { position = vec(9, 4), Box {} }
    function step(dt)
        if time.step % 20 == 0 then world.ball.mass = 2 + time.step end
        if time.step == 30 then world.ball.tag = "text" world.ball.angle = 1 end
        if time.step == 30 then world.late = Body { position = vec(3, 3) } end
    end
)";

struct Writing : Playing {
    Writing() : Playing(writing) {}
    void run(int steps) {
        for (int i = 0; i < steps; ++i) loop->turn();
    }
    Cause who(const char* path) {
        const property::Place place = property::resolve(tree, path);
        return tree.last_writer(place.instance, *place.property).cause;
    }
};

}  // namespace

TEST_CASE_METHOD(Writing, "after going back the last writer is that of the moment") {
    run(70);
    for (const int step : {65, 50, 35}) {
        INFO("step " << step);
        time().go_to(step);
        CHECK(who("world.ball.mass").writer == Writer::script);
        CHECK(who("world.ball.mass").step == static_cast<std::uint64_t>(step / 20 * 20));
        // Texts are not written by the fast way for numbers and vectors.
        CHECK(who("world.ball.tag").text() == "script, step 30");
        CHECK(who("world.late.position").writer == Writer::script);
    }
    time().go_to(70);
    CHECK(who("world.ball.mass").text() == "script, step 60");
}

TEST_CASE_METHOD(Writing, "a value that its owner computes until it is set has no writer") {
    run(10);
    CHECK(who("world.ball.velocity").writer == Writer::simulation);
    const property::Place speed = property::resolve(tree, "world.ball.sleep_speed");
    CHECK_FALSE(tree.last_writer(speed.instance, *speed.property).known);
    {
        const property::Tree::CauseScope cause(tree, Writer::console);
        property::set(tree, "world.ball.sleep_speed", Value(1.0));
    }
    run(2);
    CHECK(who("world.ball.sleep_speed").writer == Writer::console);
}

TEST_CASE_METHOD(Writing, "edits by people keep their writer when the past is repeated") {
    run(10);
    {
        const property::Tree::CauseScope cause(tree, Writer::console);
        property::set(tree, "world.crate.mass", Value(5.0));
        property::set(tree, "world.crate.color", Value(property::Color{1, 0, 0, 1}));
    }
    const std::size_t edits = tree.history().size();
    run(40);
    time().go_to(45);
    CHECK(who("world.crate.mass").text() == "console, step 10");
    CHECK(who("world.crate.color").text() == "console, step 10");
    CHECK(tree.history().size() == edits);
    // What is written now has its own writer and step again.
    property::set(tree, "world.crate.mass", Value(6.0));
    CHECK(who("world.crate.mass").text() == "module, step 45");
}

TEST_CASE_METHOD(Writing,
                 "at the step after which a value was edited the writer is the one before") {
    run(25);
    {
        const property::Tree::CauseScope cause(tree, Writer::console);
        property::set(tree, "world.ball.mass", Value(5.0));
        property::set(tree, "world.crate.mass", Value(5.0));
    }
    CHECK(who("world.ball.mass").text() == "console, step 25");
    run(5);
    const std::uint64_t made = who("world.crate.position").step;
    time().go_to(25);
    CHECK(get("world.ball.mass") == Value(22.0));
    CHECK(who("world.ball.mass").text() == "script, step 20");
    CHECK(who("world.crate.mass").writer != Writer::console);
    time().go_to(26);
    CHECK(get("world.ball.mass") == Value(5.0));
    CHECK(who("world.ball.mass").text() == "console, step 25");
    time().go_to(20);
    CHECK(who("world.ball.mass").text() == "script, step 20");
    time().go_to(25);
    run(1);  // without the edit
    CHECK(get("world.ball.mass") == Value(22.0));
    CHECK(who("world.ball.mass").text() == "script, step 20");
    CHECK(who("world.crate.position").step == made);
}

TEST_CASE_METHOD(Writing,
                 "an edit after the newest step has its writer when the game returns to it") {
    run(25);
    const auto edit = [&](double value) {
        const property::Tree::CauseScope cause(tree, Writer::console);
        property::set(tree, "world.ball.mass", Value(value));
    };
    edit(5);
    time().go_to(22);
    CHECK(who("world.ball.mass").text() == "script, step 20");
    time().go_to(25);
    CHECK(get("world.ball.mass") == Value(5.0));
    CHECK(who("world.ball.mass").text() == "console, step 25");
    run(1);
    edit(6);
    run(1);
    time().go_to(26);
    CHECK(who("world.ball.mass").text() == "console, step 25");
    time().go_to(25);
    CHECK(who("world.ball.mass").text() == "script, step 20");
}

TEST_CASE_METHOD(Writing, "a write in a past that was left is not the last write") {
    run(70);
    time().go_to(30);
    {
        const property::Tree::CauseScope cause(tree, Writer::console);
        property::set(tree, "world.ball.mass", Value(5.0));
    }
    CHECK(who("world.ball.mass").text() == "console, step 30");
    time().review(10, [](std::int64_t) {});  // as a plot does
    CHECK(who("world.ball.mass").text() == "console, step 30");
    time().go_to(70);  // the edit is gone
    CHECK(who("world.ball.mass").text() == "script, step 60");
    time().go_to(30);
    CHECK(who("world.ball.mass").text() == "script, step 20");
    run(8);  // the writes of steps 40 and 60 are of another past now
    CHECK(who("world.ball.mass").text() == "script, step 20");
    run(20);
    CHECK(who("world.ball.mass").text() == "script, step 40");
    CHECK(who("world.crate.position").writer == Writer::script);
}

TEST_CASE_METHOD(Writing, "a branch has its own writers") {
    run(70);
    time().go_to(50);
    {
        const property::Tree::CauseScope cause(tree, Writer::console);
        property::set(tree, "world.ball.mass", Value(5.0));
    }
    run(5);
    CHECK(who("world.ball.mass").text() == "console, step 50");
    time().switch_to("1");
    CHECK(who("world.ball.mass").text() == "restore, step 50");
    CHECK(who("world.late.position").text() == "script, step 30");
    time().switch_to("2");
    CHECK(who("world.ball.mass").text() == "restore, step 50");
    run(10);
    CHECK(who("world.ball.mass").text() == "script, step 60");
}

}  // namespace writers_test
