// The time bar: the effects of its buttons and its track on `time`.

#include "catch.h"
#include "rig.h"

#include <look/imgui_compat.h>
#include <look/theme.h>

namespace time_bar_test {

using namespace fettle;
using console::test::Rig;
using property::Value;

namespace {

/// The method `branches` of `time`, with the branches of the test.
struct BranchList {
    std::vector<console::OtherBranch> all;
};
const std::vector<property::Field> branch_fields = {
    {.name = "name", .type = property::Type::text},
    {.name = "fork", .type = property::Type::integer},
    {.name = "newest", .type = property::Type::integer}};

property::Method branches_method(BranchList& branches) {
    return {.name = "branches",
            .returns = branch_fields,
            .many = true,
            .context = &branches,
            .call = [](void* context, property::Tree&, property::Handle, property::Row,
                       std::span<const Value>) -> property::Result {
                std::vector<property::Record> all;
                for (const console::OtherBranch& each : static_cast<BranchList*>(context)->all)
                    all.push_back(
                        {&branch_fields, {Value(each.name), Value(each.fork), Value(each.newest)}});
                return all;
            },
            .effect = property::Effect::nothing};
}

/// A game at step 300 that can go back to step 100; `commands` are the requested ones.
struct Bar {
    Rig rig;
    explicit Bar(std::int64_t step = 300, bool paused = false, BranchList* branches = nullptr,
                 console::Options options = {})
        : rig(std::move(options)) {
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
        time.properties.push_back({.name = "real", .default_value = Value(0.0)});
        time.properties.push_back(
            {.name = "paused", .type = property::Type::boolean, .default_value = Value(paused)});
        time.properties.push_back(
            {.name = "step_once", .type = property::Type::boolean, .default_value = Value(false)});
        if (branches != nullptr) {
            time.properties.push_back({.name = "branch",
                                       .type = property::Type::text,
                                       .default_value = Value(std::string("2"))});
            time.methods.push_back(branches_method(*branches));
        }
        tree.create(tree.define(std::move(time)), tree.root(), "time");
        rig.key("grave");
        rig.draw(3);
    }
    console::TimeBar& bar() { return rig.state().views.time_bar; }
    void click(const console::Rect& place) { rig.click(place.middle().x, place.middle().y); }
    bool paused() { return rig.value("time.paused").boolean(); }
    /// Begins a frame that is `seconds` after the last one.
    void begin_frame(double seconds) {
        property::set(rig.tree, "time.real", rig.value("time.real").number() + seconds);
        rig.console.between_frames();
    }
    void begin_playing(double seconds) {
        bar().play_back(seconds);
        begin_frame(0);
    }
};

}  // namespace

TEST_CASE("the time bar is shown if the game has a timeline") {
    Rig without;
    without.key("grave");
    without.draw(3);
    CHECK(without.state().views.time_bar.rect().empty());
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

TEST_CASE("the mark of a failed step stays in sight after going back") {
    Bar bar(200, true);  // the newest kept step is 300
    bar.rig.tree.set_step(301);
    script::ScriptError error;
    error.message = "main.lua:3: no ball";
    bar.rig.console.report(error);
    bar.rig.tree.set_step(200);
    bar.rig.draw(2);
    const console::Rect track = bar.bar().track();
    const auto red = console::test::pixel_of(console::palette::error);
    const auto& pixels = bar.rig.surface.pixels();
    const auto wide = static_cast<std::size_t>(bar.rig.surface.width());
    std::size_t drawn = 0;
    for (auto y = static_cast<std::size_t>(track.low.y); y < track.middle().y; ++y)
        for (auto x = static_cast<std::size_t>(track.high.x - 10); x < track.high.x; ++x)
            drawn += pixels[y * wide + x] == red ? 1 : 0;
    CHECK(drawn > 4);
    bar.rig.click(track.high.x - 6, track.middle().y);
    bar.rig.draw(2);
    CHECK(bar.rig.commands == std::vector<std::string>{"time:go_to(300)"});
}

TEST_CASE(
    "after going back the edits of later steps stay marked until the game goes on from there") {
    Rig rig;
    console::TimeMarks& marks = rig.state().time_marks;
    const auto look = [&] {
        for (int i = 0; i < 20; ++i) marks.update();
        return marks.edits().size();
    };
    marks.follow("1", {});
    const property::Tree::CauseScope cause(rig.tree, property::Writer::console);
    rig.tree.set_step(50);
    property::set(rig.tree, "world.ball.mass", 4.0);
    rig.tree.set_step(150);
    property::set(rig.tree, "world.ball.mass", 5.0);
    CHECK(look() == 2);
    // The history that is restored with step 100 ends before the second edit.
    rig.tree.undo();
    rig.tree.set_step(100);
    CHECK(look() == 2);
    marks.follow("2", {{"1", 100}});
    CHECK(look() == 1);
    CHECK(marks.edits().front().step == 50);
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

namespace {

/// A bar of a game at step 300 with the branch "1", which parts after step 200 and ends at 400.
struct Branched {
    BranchList branches{{{"1", 200, 400}}};
    Bar bar{300, true, &branches};
    void right_click(const console::Rect& place) {
        const ImVec2 at = place.middle();
        bar.rig.move(at.x, at.y);
        bar.rig.draw();
        bar.rig.button(true, at.x, at.y, "right");
        bar.rig.button(false, at.x, at.y, "right");
        bar.rig.draw(3);
    }
};

}  // namespace

TEST_CASE("each branch has a lane of the time bar with a menu") {
    Branched with;
    Bar& bar = with.bar;
    REQUIRE(bar.bar().lanes().size() == 1);
    CHECK(bar.bar().lanes()[0].high.y - bar.bar().lanes()[0].low.y >= 16);
    CHECK(bar.bar().times().end == 400);
    const float tall = bar.bar().height();
    bar.click(bar.bar().lanes()[0]);
    bar.rig.draw(2);
    REQUIRE_FALSE(bar.rig.commands.empty());
    CHECK(bar.rig.commands.back() == "compare_branch(\"1\")");
    with.right_click(bar.bar().lanes()[0]);
    REQUIRE_FALSE(bar.bar().menu_entry("Go there").empty());
    bar.rig.save("branch_menu");
    bar.click(bar.bar().menu_entry("Go there"));
    bar.rig.draw(2);
    CHECK(bar.rig.commands.back() == "time:switch_to(\"1\")");
    with.right_click(bar.bar().lanes()[0]);
    bar.click(bar.bar().menu_entry("Name …"));
    bar.rig.draw(2);
    CHECK(bar.rig.input() == "time:name_branch(\"\", \"1\")");
    bar.rig.type("high");
    CHECK(bar.rig.input() == "time:name_branch(\"high\", \"1\")");
    with.branches.all.clear();
    bar.rig.draw(2);
    CHECK(bar.bar().lanes().empty());
    CHECK(bar.bar().height() < tall);
}

TEST_CASE("the track reaches no step beyond the newest of the present branch") {
    Branched with;
    const console::Rect track = with.bar.bar().track();
    with.bar.rig.button(true, track.high.x - 6, track.middle().y);
    with.bar.rig.draw(2);
    with.bar.rig.button(false, track.high.x - 6, track.middle().y);
    with.bar.rig.draw(2);
    REQUIRE_FALSE(with.bar.rig.commands.empty());
    CHECK(with.bar.rig.commands.back() == "time:go_to(300)");
}

TEST_CASE("playing back shows each step of the past again and ends at the present") {
    Bar bar;
    bar.click(bar.bar().play_back_button());
    bar.rig.draw();
    bar.begin_frame(0);
    CHECK(bar.paused());
    CHECK(bar.rig.commands == std::vector<std::string>{"time:go_to(100)"});
    CHECK(bar.bar().plays_back());
    bar.begin_frame(0.5);  // the test's steps are 1/60 s
    CHECK(bar.rig.commands.back() == "time:go_to(130)");
    bar.begin_frame(1e9);
    CHECK(bar.rig.commands.back() == "time:go_to(300)");
    bar.begin_frame(0);
    CHECK_FALSE(bar.bar().plays_back());
    CHECK_FALSE(bar.paused());  // the game goes on
    bar.begin_playing(1);
    CHECK(bar.rig.commands.back() == "time:go_to(240)");
    bar.click(bar.bar().play_back_button());  // stops
    bar.rig.draw();
    CHECK_FALSE(bar.bar().plays_back());
}

TEST_CASE("a game that was paused is paused after it was played back") {
    Bar bar(300, true);
    bar.begin_playing(1);
    bar.begin_frame(1e9);
    bar.begin_frame(0);
    CHECK_FALSE(bar.bar().plays_back());
    CHECK(bar.paused());
}

TEST_CASE("an edit while the past is played back ends the playing there") {
    const bool drag = GENERATE(false, true);
    Bar bar;
    property::Tree& tree = bar.rig.tree;
    bar.begin_playing(1);
    property::set(tree, "time.step", Value(240));
    bar.begin_frame(0.1);
    const std::size_t gone = bar.rig.commands.size();
    if (drag) {  // the edit ends when the button is released
        bar.rig.console.select(tree.child(tree.child(tree.root(), "world"), "ball"));
        bar.rig.draw(3);
        const ImVec2 at = bar.rig.widget("mass");
        bar.rig.button(true, at.x, at.y);
        bar.rig.draw();
        bar.rig.move(at.x + 30, at.y);
        bar.rig.draw();
    } else {
        const property::Tree::CauseScope cause(tree, property::Writer::console);
        property::set(tree, "world.ball.mass", 5.0);
    }
    bar.begin_frame(0.1);
    bar.begin_frame(0.1);
    CHECK(bar.rig.commands.size() == gone);
    CHECK_FALSE(bar.bar().plays_back());
    CHECK(bar.paused());
    CHECK(bar.rig.logged("playing back ends at step 240: an edit was made here"));
}

TEST_CASE("the play button lets a game go on that an error has stopped") {
    const std::int64_t step = GENERATE(300, 200);
    bool halted = true;
    Bar bar(step, step < 300, nullptr,
            {.halted = [&] { return halted; }, .resume = [&] { halted = false; }});
    CHECK(bar.bar().times().stands());
    bar.click(bar.bar().play_button());
    bar.rig.draw();
    CHECK_FALSE(halted);
    CHECK_FALSE(bar.bar().times().stands());
    halted = true;
    bar.click(bar.bar().step_button());
    bar.rig.draw();
    CHECK(halted == (step < 300));  // a step of the past is shown, and not made
    CHECK(bar.rig.value("time.step_once").boolean() == (step == 300));
}

TEST_CASE("a command that plays the past back changes nothing itself") {
    Bar bar;
    property::Tree& tree = bar.rig.tree;
    const property::Tree::CauseScope cause(tree, property::Writer::console);
    tree.begin_edit("play_back(1)");
    bar.bar().play_back(1);
    tree.end_edit();
    CHECK(tree.history().empty());
    CHECK_FALSE(bar.paused());
    CHECK(bar.bar().plays_back());
}

TEST_CASE("a drag reaches the place of the release if both come in one frame") {
    Bar bar;
    const console::Rect track = bar.bar().track();
    const float y = track.middle().y;
    bar.rig.button(true, track.high.x - 6, y);
    bar.rig.draw(2);
    bar.rig.move(track.middle().x, y);
    bar.rig.button(false, track.middle().x, y);
    bar.rig.draw(2);
    CHECK(bar.rig.commands.back() == "time:go_to(200)");
}

TEST_CASE("a button of the time bar begins and ends a recording") {
    bool recording = false;
    Bar bar(300, false, nullptr,
            {.record =
                 [&](bool on) {
                     recording = on;
                     return std::string();
                 },
             .records = [&] { return recording; }});
    bar.click(bar.bar().record_button());
    bar.rig.draw(2);
    REQUIRE_FALSE(bar.rig.commands.empty());
    CHECK(bar.rig.commands.back() == "record()");
    recording = true;
    bar.click(bar.bar().record_button());
    bar.rig.draw(2);
    CHECK(bar.rig.commands.back() == "record(false)");
    Bar without;  // a run that cannot be recorded
    CHECK(without.bar().record_button().empty());
}

TEST_CASE("a narrow bar leaves out buttons and has room for the track and the time") {
    const unsigned width = GENERATE(300u, 400u, 1280u);
    const double scale = GENERATE(1.0, 2.0);
    INFO(width << ", scale " << scale);
    Bar bar(300, false, nullptr,
            {.record = [](bool) { return std::string(); }, .records = [] { return false; }});
    bar.rig.state().settings.set("scale", Value(scale));
    console::test::RasterSurface window(width, 300);
    for (int i = 0; i < 3; ++i) bar.rig.console.draw(window, 1.0 / 60);
    const console::Rect &whole = bar.bar().rect(), &track = bar.bar().track();
    CHECK_FALSE(bar.bar().play_button().empty());
    CHECK(track.high.x - track.low.x >= 40);
    // The time of step 300, "5.00 s", in letters of `scale` times 14 pixels where these have room.
    CHECK(whole.high.x - track.high.x > 60 * static_cast<float>(width == 1280 ? scale : 1));
    const bool all = width >= 400;
    CHECK(bar.bar().record_button().empty() == !all);
    CHECK(bar.bar().step_button().empty() == !all);
}

TEST_CASE("bookmarks have names and each branch has its own marks") {
    Rig rig;
    console::TimeMarks& marks = rig.state().time_marks;
    marks.bookmark("start", 10);
    marks.bookmark("", std::nullopt);
    marks.bookmark("start", 20);
    using All = std::vector<std::pair<std::string, std::int64_t>>;
    const auto now = static_cast<std::int64_t>(rig.tree.step());
    CHECK(marks.bookmarks() == All{{"bookmark 1", now}, {"start", 20}});
    CHECK(marks.unbookmark("bookmark 1") == 1);
    CHECK(marks.unbookmark("stop") == 0);
    CHECK_THROWS_AS(marks.bookmark("a\nb", 1), property::Error);
    CHECK_THROWS_AS(marks.bookmark("early", -1), property::Error);
    marks.follow("1", {});
    marks.bookmark("late", 90);
    marks.follow("2", {{"1", 50}});  // the game went on from step 50
    CHECK(marks.bookmarks() == All{{"start", 20}});
    marks.bookmark("other", 60);
    marks.follow("1", {{"2", 50}});
    CHECK(marks.bookmarks() == All{{"start", 20}, {"late", 90}});
    marks.follow("first", {{"2", 50}});  // another name
    CHECK(marks.bookmarks() == All{{"start", 20}, {"late", 90}});
    marks.follow("2", {{"first", 50}});
    CHECK(marks.bookmarks() == All{{"start", 20}, {"other", 60}});
    CHECK(marks.unbookmark("") == 2);
}

TEST_CASE("views above the time bar leave room for its tooltips") {
    Bar bar;
    Rig& rig = bar.rig;
    rig.draw(2);
    const console::Rect play = rig.state().views.time_bar.play_button();
    rig.move(play.middle().x, play.middle().y);
    rig.draw(3);
    const ImGuiWindow* const tip = ImGui::FindWindowByName("##Tooltip_00");
    REQUIRE(tip != nullptr);
    REQUIRE(tip->Active);
    CHECK(tip->Pos.y >= rig.surface.height() - rig.console.covered_below());
}

}  // namespace time_bar_test
