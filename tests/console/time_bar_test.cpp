// The time bar: the effects of its buttons and its track on `time`.

#include "catch.h"
#include "rig.h"

namespace time_bar_test {

using namespace fettle;
using console::test::Rig;
using property::Value;

namespace {

/// A game at step 300 that can go back to step 100; `commands` are the requested ones.
struct Bar {
    Rig rig;
    explicit Bar(std::int64_t step = 300, bool paused = false) {
        property::Tree& tree = rig.tree;
        tree.destroy(tree.child(tree.root(), "time"));
        property::ClassDescriptor time;
        time.name = "TimeWithPast";
        const auto number = [&](const char* name, std::int64_t value) {
            time.properties.push_back(
                {.name = name, .type = property::Type::integer, .default_value = Value(value)});
        };
        number("step", step);
        number("oldest", 100);
        number("newest", 300);
        time.properties.push_back(
            {.name = "paused", .type = property::Type::boolean, .default_value = Value(paused)});
        time.properties.push_back(
            {.name = "step_once", .type = property::Type::boolean, .default_value = Value(false)});
        tree.create(tree.define(std::move(time)), tree.root(), "time");
        rig.key("grave");
        rig.draw(3);
    }
    console::TimeBar& bar() { return rig.state().time_bar; }
    void click(const console::Rect& place) { rig.click(place.middle().x, place.middle().y); }
    bool paused() { return rig.value("time.paused").boolean(); }
};

}  // namespace

TEST_CASE("the time bar is shown if the game has a timeline") {
    Rig without;
    without.key("grave");
    without.draw(3);
    CHECK(without.state().time_bar.rect().empty());
    Bar with;
    CHECK_FALSE(with.bar().rect().empty());
    with.rig.state().settings.set("time_bar", Value(false));
    with.rig.draw(2);
    CHECK(with.bar().rect().empty());
    with.rig.state().settings.set("time_bar", Value(true));
    with.rig.draw(2);
    with.rig.key("grave");
    with.rig.draw(2);
    CHECK(with.bar().rect().empty());
}

TEST_CASE("the play button toggles the pause and makes no edit") {
    Bar bar;
    bar.click(bar.bar().play_button());
    bar.rig.draw(2);
    CHECK(bar.paused());
    bar.click(bar.bar().play_button());
    bar.rig.draw(2);
    CHECK_FALSE(bar.paused());
    CHECK(bar.rig.tree.history().empty());
}

TEST_CASE("the step button makes one step in the present and moves one step in the past") {
    Bar bar;
    bar.click(bar.bar().step_button());
    bar.rig.draw(2);
    CHECK(bar.paused());
    CHECK(bar.rig.value("time.step_once").boolean());
    Bar past(200, true);
    past.click(past.bar().step_button());
    past.rig.draw(2);
    CHECK(past.rig.commands == std::vector<std::string>{"time:go_to(201)"});
}

TEST_CASE("a drag over the track moves through the past and pauses the game") {
    Bar bar;
    const console::Rect track = bar.bar().track();
    const float y = track.middle().y;
    bar.rig.drag(track.high.x - 6, y, track.middle().x, y);
    bar.rig.draw(2);
    CHECK(bar.paused());
    REQUIRE_FALSE(bar.rig.commands.empty());
    CHECK(bar.rig.commands.back() == "time:go_to(200)");
    // The game does not get these events.
    CHECK(bar.rig.button(true, track.middle().x, y));
    bar.rig.button(false, track.middle().x, y);
}

TEST_CASE("one click returns from the past to the present") {
    Bar bar(150, true);
    REQUIRE_FALSE(bar.bar().return_button().empty());
    bar.click(bar.bar().return_button());
    bar.rig.draw(2);
    CHECK(bar.rig.commands == std::vector<std::string>{"time:go_to(300)"});
    Bar present;
    CHECK(present.bar().return_button().empty());
}

TEST_CASE("edits and errors have marks at their steps") {
    Bar bar;
    property::Tree& tree = bar.rig.tree;
    const property::Handle time = tree.child(tree.root(), "time");
    tree.set_step(150);
    {
        const property::Tree::CauseScope cause(tree, property::Writer::console);
        tree.set(time, *tree.find(time, "paused"), Value(true));
    }
    tree.set_step(200);
    script::ScriptError error;
    error.message = "main.lua:3: no ball\nmore";
    for (int times = 0; times < 2; ++times) bar.rig.console.report(error);
    bar.rig.draw(40);
    const console::TimeMarks& marks = bar.rig.state().time_marks;
    REQUIRE(marks.edits().size() == 1);
    CHECK(marks.edits()[0].step == 150);
    REQUIRE(marks.others().size() == 1);
    CHECK(marks.others()[0].step == 200);
    CHECK(marks.others()[0].text == "main.lua:3: no ball");
    // A click beside the mark goes to its step.
    const console::Rect track = bar.bar().track();
    bar.rig.click(track.middle().x + 3, track.middle().y);
    bar.rig.draw(2);
    CHECK(bar.rig.commands == std::vector<std::string>{"time:go_to(200)"});
}

TEST_CASE("a right click on the track sets a bookmark and removes it") {
    Bar bar;
    const console::Rect track = bar.bar().track();
    const console::TimeMarks& marks = bar.rig.state().time_marks;
    const auto right_click = [&](float x) {
        bar.rig.button(true, x, track.middle().y, "right");
        bar.rig.draw(2);
        bar.rig.button(false, x, track.middle().y, "right");
        bar.rig.draw(2);
    };
    right_click(track.middle().x);
    REQUIRE(marks.others().size() == 1);
    CHECK(marks.others()[0].step == 200);
    CHECK(bar.rig.commands.empty());
    right_click(track.middle().x + 2);
    CHECK(marks.others().empty());
}

}  // namespace time_bar_test
