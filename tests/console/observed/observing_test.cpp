// Pinned values, plots, breaks, searches of the past, keys and words with commands: the console
// with the Lua runtime.

#include <observed/plot_table.h>

#include <fstream>
#include <map>
#include <set>

#include "catch.h"
#include "observing_rig.h"

#include <imgui_internal.h>
#include "temporary_folder.h"

namespace observing_test {

using namespace fettle;
using console::test::ObservingRig;
using property::Value;
using property::Vec2;

TEST_CASE("observing an unknown name is an error with the nearest name") {
    ObservingRig rig;
    rig.run("pin world.ball.mss");
    rig.run("plot world.ball.positon");
    rig.run("break_when world.boll.mass > 3");
    INFO(rig.text());
    CHECK(rig.text().find("pin: world.ball.mss: no such name (did you mean \"mass\"?)") !=
          std::string::npos);
    CHECK(rig.text().find("plot: world.ball.positon: no such name (did you mean \"position\"?)") !=
          std::string::npos);
    CHECK(
        rig.text().find("it has no value yet: world.boll: no such name (did you mean \"ball\"?)") !=
        std::string::npos);
    REQUIRE(rig.pins().size() == 1);  // it may be made later
    CHECK(rig.pins().front().problem().starts_with("world.ball.mss"));
}

TEST_CASE("a pinned value is shown with its unit and followed from the kept past on") {
    ObservingRig rig;
    rig.step(500);
    rig.run("pin world.ball.position.x");
    REQUIRE(rig.pins().size() == 1);
    CHECK(rig.pins()[0].samples().size() == 241);
    CHECK(rig.pins()[0].value() == Value(500.0));
    rig.step(3);
    CHECK(rig.pins()[0].samples().size() == 244);
    CHECK(rig.pins()[0].samples().back().x == 503);
    rig.run("pin world.ball.position.x");  // again: no second one
    CHECK(rig.pins().size() == 1);
    rig.run("pin world.ball.mass * 2");
    rig.show();
    CHECK_FALSE(rig.lua.state().views.watch_list.rect().empty());
    rig.click_at(rig.lua.state().views.watch_list.button(1).middle());
    REQUIRE(rig.pins().size() == 1);
    rig.run("unpin()");
    CHECK(rig.pins().empty());
    rig.show();
    CHECK(rig.lua.state().views.watch_list.rect().empty());
}

TEST_CASE("a pinned value that fails shows why and comes back") {
    ObservingRig rig;
    rig.run("pin world.crate.mass");
    rig.run("world.crate:delete()");
    rig.step(2);
    CHECK(rig.pins()[0].problem().find("crate") != std::string::npos);
    rig.show();
    CHECK(rig.surface.faults() == 0);
    rig.run("world.crate = Body { mass = 4 }");
    rig.step(100);
    CHECK(rig.pins()[0].problem().empty());
    CHECK(rig.pins()[0].value() == Value(4.0));
}

TEST_CASE("a plot shows the past and a click goes to that moment") {
    ObservingRig rig;
    rig.step(100);
    rig.run("plot world.ball.position, world.ball.mass > 2");
    REQUIRE(rig.plots().size() == 2);
    CHECK(rig.plots()[0].is_vector());
    CHECK(rig.plots()[0].samples().front().step == 0);
    CHECK(rig.plots()[1].samples().back().x == 0);
    rig.show();
    const console::Rect area = rig.lua.state().views.plot_view.area();
    REQUIRE_FALSE(area.empty());
    rig.click_at(area.middle());
    CHECK(rig.went_to == Approx(50).margin(2));
    CHECK(rig.value("time.paused") == Value(true));
    rig.click_at(rig.lua.state().views.plot_view.close_button().middle());
    CHECK(rig.plots().empty());
    rig.run("plot world.ball.label");
    CHECK(rig.text().find("neither a number, a vector nor a boolean") != std::string::npos);
}

TEST_CASE("samples after a moment are dropped when the game goes on from it") {
    ObservingRig rig;
    rig.run("plot world.ball.position.x");
    rig.step(20);
    rig.now = 10;
    rig.step(1);
    CHECK(rig.plots()[0].samples().back().step == 11);
    CHECK(rig.plots()[0].samples().size() == 12);
}

TEST_CASE("a break pauses the game when its condition becomes true") {
    ObservingRig rig;
    rig.run("break_when world.ball.position.x >= 7");
    rig.step(20);
    CHECK(rig.now == 7);
    CHECK(rig.value("time.paused") == Value(true));
    INFO(rig.text());
    CHECK(rig.text().find("break at step 7: world.ball.position.x >= 7: false → true") !=
          std::string::npos);
    CHECK(rig.text().find("world.ball.position.x = 7 m   simulation") != std::string::npos);
    // It breaks once, not in every step in which it is true.
    property::set(rig.tree, "time.paused", Value(false));
    rig.step(5);
    CHECK(rig.now == 12);
}

TEST_CASE("a break on a value waits for a change and all breaks can be ended") {
    ObservingRig rig;
    rig.run("break_when world.crate.mass");
    rig.step(5);
    CHECK(rig.now == 5);
    rig.run("world.crate.mass = 8");
    rig.step(5);
    CHECK(rig.now == 6);
    INFO(rig.text());
    CHECK(rig.text().find("world.crate.mass: 1 → 8") != std::string::npos);
    CHECK(rig.text().find("world.crate.mass = 8 kg   console") != std::string::npos);
    // A number that fits into a float has its digits.
    property::set(rig.tree, "time.paused", Value(false));
    property::set(rig.tree, "world.crate.mass", Value(6.44407844543457));
    rig.step(1);
    CHECK(rig.text().find("world.crate.mass: 8 → 6.4440784\n") != std::string::npos);
    rig.run("time.paused = false");
    rig.run("break_when()");
    rig.run("world.crate.mass = 9");
    rig.step(5);
    CHECK(rig.now == 12);
}

TEST_CASE("a break whose condition has no value any more says that it pauses") {
    ObservingRig rig;
    rig.run("break_when world.crate.mass > 5");
    rig.step(2);
    rig.tree.destroy(property::resolve(rig.tree, "world.crate").instance);
    rig.step(5);
    CHECK(rig.now == 3);
    CHECK(rig.value("time.paused") == Value(true));
    INFO(rig.text());
    CHECK(rig.text().find("break at step 3: world.crate.mass > 5 has no value any more, so the "
                          "game is paused: ") != std::string::npos);
}

TEST_CASE("breaks say what they wait for and are listed and removed singly") {
    ObservingRig rig;
    const auto says = [&](const std::string& command, const char* expected) {
        rig.run("clear");
        rig.show();
        rig.run(command);
        INFO(rig.text());
        CHECK(rig.text().find(expected) != std::string::npos);
    };
    says("break_when world.ball.position.x >= 7",
         "breaks when world.ball.position.x >= 7 becomes true; it is false");
    says("break_when world.crate.mass", "breaks when world.crate.mass changes; it is 1 kg");
    says("break_when world.boss.mass > 3",
         "breaks when world.boss.mass > 3 becomes true or changes; it has no value yet");
    const auto& breaks = rig.lua.state().observing.breaks();
    // The same again is no other break.
    rig.run("break_when world.crate.mass");
    CHECK(breaks.size() == 3);
    says("breaks", "world.ball.position.x >= 7");
    says("#breaks()", "3");
    says("unbreak world.crate.mas", "no break has that condition");
    says("unbreak world.boss.mass > 3", "that break is removed");
    rig.run("unbreak(breaks()[1])");
    CHECK(breaks.texts() == std::vector<std::string>{"world.crate.mass"});
    says("unbreak()", "no break is set any more");
    says("unbreak()", "no break is set");
    says("break_when()", "no break is set any more");
    // One that was removed does not pause.
    rig.step(20);
    CHECK(rig.now == 20);
}

TEST_CASE("last_time finds the last step at which a condition was true and goes there") {
    ObservingRig rig;
    rig.step(60);
    rig.run("last_time world.ball.position.x < 20");
    CHECK(rig.went_to == 19);
    CHECK(rig.text().find("true at step 19, 41 steps ago") != std::string::npos);
    rig.run("last_time world.ball.position.x > 30");  // true now: since when
    CHECK(rig.went_to == 31);
    rig.went_to = -1;
    rig.run("last_time world.ball.position.x > 1000");
    CHECK(rig.went_to == -1);
    CHECK(rig.text().find("never since step 0") != std::string::npos);
    rig.run("last_time world.ball.position.x >= 0");
    CHECK(rig.text().find("true now, and ever since step 0") != std::string::npos);
    rig.run("last_time world.boll.position.x >= 0");
    CHECK(rig.text().find("did you mean \"ball\"") != std::string::npos);
}

TEST_CASE("a key runs its command while the console is closed") {
    ObservingRig rig;
    rig.run("bind('k', 'world.ball.mass = 7')");
    rig.lua.open(false);
    CHECK(rig.press_key("k"));
    CHECK(rig.value("world.ball.mass") == Value(7.0));
    CHECK_FALSE(rig.press_key("j"));
    rig.lua.open();
    rig.run("world.ball.mass = 1");
    rig.press_key("k");  // typed
    CHECK(rig.value("world.ball.mass") == Value(1.0));
    rig.run("bind('f5', 'world.ball.mass = 5')");
    rig.press_key("f5");
    CHECK(rig.value("world.ball.mass") == Value(5.0));
    rig.run("bind('k')");
    rig.lua.open(false);
    CHECK_FALSE(rig.press_key("k"));
    rig.run("bind('spacd', 'x = 1')");
    CHECK(rig.text().find("there is no key \"spacd\" (did you mean \"space\"?)") !=
          std::string::npos);
}

TEST_CASE("an alias stands for a command with what follows it") {
    ObservingRig rig;
    rig.run("alias('heavy', 'world.ball.mass =')");
    rig.run("heavy 12");
    CHECK(rig.value("world.ball.mass") == Value(12.0));
    rig.run("heavy = 3");  // a variable
    CHECK(rig.value("world.ball.mass") == Value(12.0));
    // Alone it is an error: the next line is another command.
    const script::Evaluation alone = rig.lua.evaluate("heavy");
    CHECK_FALSE(alone.incomplete);
    REQUIRE(alone.error);
    CHECK(alone.error->message.starts_with("heavy stands for \"world.ball.mass =\": it needs"));
    rig.run("alias('heavy')");
    rig.run("heavy 13");
    CHECK(rig.value("world.ball.mass") == Value(12.0));
}

TEST_CASE("the commands in a file are run as if they were typed") {
    TemporaryFolder folder;
    std::ofstream(folder.path / "main.lua") << "x = 1\n";
    std::ofstream(folder.path / "setup.lua") << "-- prepares\n"
                                                "world.ball.mass = 3\n"
                                                "\n"
                                                "for i = 1, 2 do\n"
                                                "  world.crate.mass = 10 * i\n"
                                                "end\n"
                                                "world.floor.friction is world.ball.mass / 6\n"
                                                "world.boll\n";
    ObservingRig rig;
    REQUIRE(rig.runtime.load(folder.path));
    rig.run("exec 'setup.lua'");
    INFO(rig.text());
    CHECK(rig.value("world.ball.mass") == Value(3.0));
    CHECK(rig.value("world.crate.mass") == Value(20.0));
    CHECK(rig.value("world.floor.friction").number() == Approx(0.5));
    CHECK(rig.text().find("world.boll: no such name") != std::string::npos);
    CHECK(rig.text().find("this command is in setup.lua:8") != std::string::npos);
    rig.run("exec 'setip.lua'");
    CHECK(rig.text().find("did you mean \"setup.lua\"") != std::string::npos);
}

TEST_CASE("files of commands that run each other end with an error") {
    TemporaryFolder folder;
    std::ofstream(folder.path / "main.lua") << "x = 1\n";
    std::ofstream(folder.path / "loop.lua") << "world.ball.mass = world.ball.mass + 1\n"
                                               "exec 'loop.lua'\n";
    ObservingRig rig;
    REQUIRE(rig.runtime.load(folder.path));
    rig.run("world.ball.mass = 1");
    rig.run("exec 'loop.lua'");
    CHECK(rig.value("world.ball.mass") == Value(102.0));
    CHECK(rig.text().find("exec: files of commands have run 100 others") != std::string::npos);
}

TEST_CASE("each file of commands ends its own last command") {
    TemporaryFolder folder;
    std::ofstream(folder.path / "main.lua") << "x = 1\n";
    std::ofstream(folder.path / "open.lua") << "if true then\n";
    std::ofstream(folder.path / "marked.lua") << "\xEF\xBB\xBFworld.ball.mass = 7\r\n";
    ObservingRig rig;
    REQUIRE(rig.runtime.load(folder.path));
    rig.run("exec 'open.lua' exec 'marked.lua'");
    CHECK(rig.value("world.ball.mass") == Value(7.0));
    CHECK(rig.text().find("the command is not complete") != std::string::npos);
}

TEST_CASE("clear empties the log") {
    ObservingRig rig;
    rig.run("1 + 1");
    rig.run("clear");
    CHECK(rig.text().empty());
    rig.run("2 + 2");
    CHECK(rig.text().find("4") != std::string::npos);
}

TEST_CASE("a formula is typed into a field of the inspector") {
    ObservingRig rig;
    rig.lua.select(rig.tree.child(rig.tree.child(rig.tree.root(), "world"), "ball"));
    rig.show();
    auto& state = rig.lua.state();
    const auto type = [&](const std::string& text) {
        rig.click_at(state.inspector.editor()
                         .widget_rect(rig.tree.property(rig.lua.selected(), "angle"))
                         .middle());
        rig.show(4);
        for (const char c : text) {
            app::InputEvent event;
            event.kind = app::EventKind::text;
            event.character = static_cast<char32_t>(c);
            rig.lua.handle(event);
        }
        rig.press_key("enter");
        rig.show(4);
    };
    type("is it.mass * 3");
    CHECK(rig.value("world.ball.angle") == Value(3.0));
    rig.run("world.ball.mass = 2");
    CHECK(rig.value("world.ball.angle") == Value(6.0));
    rig.run("world.ball.angle = 0");
    type("is it.mas * 3 +");
    CHECK_FALSE(
        state.inspector.editor().problem(rig.tree.property(rig.lua.selected(), "angle")).empty());
    CHECK(rig.value("world.ball.angle") == Value(0.0));
}

TEST_CASE("a plot is written as a table and as a picture") {
    ObservingRig rig;
    rig.run("export_plot()");
    CHECK(rig.text().find("export_plot: nothing is plotted") != std::string::npos);
    rig.run("export_plot('gif')");
    CHECK(rig.text().find("expected \"csv\" or \"png\", got \"gif\"") != std::string::npos);
    rig.step(2);
    rig.run("plot world.ball.position, world.ball.mass > 2");
    rig.run("export_plot()");
    REQUIRE(rig.written.size() == 1);
    CHECK(rig.written[0] ==
          "step,seconds,world.ball.position x [m],world.ball.position y [m],world.ball.mass > 2\r\n"
          "0,0,0,-4,0\r\n"
          "1,0.016666666666666666,1,-4,0\r\n"
          "2,0.03333333333333333,2,-4,0\r\n");
    CHECK(rig.text().find("wrote /plots/plot-1.csv\n") != std::string::npos);
    rig.refuses = true;
    rig.run("export_plot('csv')");
    CHECK(rig.text().find("the disk is full") != std::string::npos);
    // By the menu of the right mouse button.
    rig.show();
    rig.click_at(rig.lua.state().views.plot_view.area().middle(), "right");
    rig.show(2);
    const console::Rect entry = rig.lua.state().views.plot_view.entry("Export as PNG");
    REQUIRE_FALSE(entry.empty());
    rig.click_at(entry.middle());
    rig.lua.between_frames();
    REQUIRE(rig.pictures.size() == 1);
    const auto& pixels = rig.pictures[0];
    CHECK(std::set(pixels.begin(), pixels.end()).size() > 20);
    CHECK(rig.text().find("wrote /plots/plot-1.png\n") != std::string::npos);
    rig.show();
    CHECK(rig.surface.faults() == 0);
}

TEST_CASE("columns of a table have quotes where they need them and gaps where nothing was") {
    script::Observed what;
    what.text = "f(1, \"a\")";
    double value = 1;
    what.value = [&value] { return Value(value); };
    const property::Tree tree;
    std::vector<console::Trace> plots;
    plots.emplace_back(what);
    plots.back().take(tree, 5);
    what.text = "late";
    plots.emplace_back(what);
    value = 2.5;
    for (console::Trace& each : plots) each.take(tree, 6);
    CHECK(console::csv_of(plots, 0.5) ==
          "step,seconds,\"f(1, \"\"a\"\")\",late\r\n5,2.5,1,\r\n6,3,2.5,2.5\r\n");
}

TEST_CASE("the menu of an instance lists who moved it and adds a break on its movement") {
    ObservingRig rig;
    rig.show();
    auto& menu = rig.lua.state().context_menu;
    const auto choose = [&](const char* entry) {
        menu.open("world.ball");
        rig.show();
        const console::Rect at = menu.entry(entry);
        REQUIRE_FALSE(at.empty());
        rig.click_at(at.middle());
    };
    choose("Who");
    CHECK(rig.text().find("who world.ball.position") != std::string::npos);
    choose("Break when it moves");
    CHECK(rig.text().find("break_when world.ball.position") != std::string::npos);
    choose("Keep");
    CHECK(rig.text().find("keep(\"world.ball\")") != std::string::npos);
}

TEST_CASE("the tooltip of an entry of a menu covers no entry and is inside of the window") {
    ObservingRig rig;
    rig.lua.state().settings.set("scale", Value(GENERATE(1.0, 2.0)));
    rig.lua.select(rig.tree.child(rig.tree.child(rig.tree.root(), "world"), "ball"));
    rig.show();
    auto& state = rig.lua.state();
    state.inspector.select(rig.lua.selected(), "mass");  // scrolls to it
    rig.show();
    rig.show();
    rig.click_at(state.inspector.editor()
                     .widget_rect(rig.tree.property(rig.lua.selected(), "mass"))
                     .middle(),
                 "right");
    rig.show();
    const console::Rect entry = state.context_menu.entry("Keep");
    REQUIRE_FALSE(entry.empty());
    app::InputEvent event;
    event.kind = app::EventKind::mouse_moved;
    event.x = entry.middle().x;
    event.y = entry.middle().y;
    rig.lua.handle(event);
    rig.show();
    const ImGuiWindow* const tip = ImGui::FindWindowByName("##Tooltip_00");
    REQUIRE(tip != nullptr);
    REQUIRE(tip->Active);
    CHECK((tip->Pos.x >= entry.high.x || tip->Pos.x + tip->Size.x <= entry.low.x));
    CHECK(tip->Pos.y + tip->Size.y <= rig.surface.height());
    CHECK(tip->Pos.x + tip->Size.x <= rig.surface.width());
}

TEST_CASE("the menu of a property pins and plots and copies its path") {
    ObservingRig rig;
    rig.lua.select(rig.tree.child(rig.tree.child(rig.tree.root(), "world"), "ball"));
    rig.show();
    auto& state = rig.lua.state();
    const auto open = [&] {
        const console::Rect at =
            state.inspector.editor().widget_rect(rig.tree.property(rig.lua.selected(), "mass"));
        REQUIRE_FALSE(at.empty());
        rig.click_at(at.middle(), "right");
        rig.show();
    };
    const auto choose = [&](const char* entry) {
        open();
        const console::Rect at = state.context_menu.entry(entry);
        REQUIRE_FALSE(at.empty());
        rig.click_at(at.middle());
    };
    choose("Pin");
    REQUIRE(rig.pins().size() == 1);
    CHECK(rig.pins()[0].what().path == "world.ball.mass");
    open();
    CHECK(state.context_menu.entry("Pin").empty());
    rig.press_key("escape");
    rig.show();
    choose("Unpin");
    CHECK(rig.pins().empty());
    choose("Pin");
    REQUIRE(rig.pins().size() == 1);
    choose("Plot");
    CHECK(rig.plots().size() == 1);
    choose("Break on change");
    CHECK(rig.text().find("breaks when world.ball.mass changes; it is 1 kg") != std::string::npos);
    open();
    CHECK(state.context_menu.entry("Break on change").empty());
    rig.press_key("escape");
    rig.show();
    choose("No break any more");
    CHECK(state.observing.breaks().size() == 0);
    choose("Copy path");
    CHECK(rig.clipboard.text == "world.ball.mass");
    choose("Who");
    CHECK(rig.text().find("who world.ball.mass") != std::string::npos);
    rig.run("world.ball.mass = 4");
    choose("Reset");
    CHECK(rig.value("world.ball.mass") == Value(1.0));
    choose("Formula …");
    rig.show();
    for (const char c : std::string("2 + 3")) {
        app::InputEvent event;
        event.kind = app::EventKind::text;
        event.character = static_cast<char32_t>(c);
        rig.lua.handle(event);
    }
    rig.press_key("enter");
    rig.show();
    CHECK(rig.value("world.ball.mass") == Value(5.0));
    state.settings.set("inspector", Value(false));
    rig.show();
    CHECK_FALSE(state.context_menu.begin_formula(property::resolve(rig.tree, "world.ball.mass")));
}

}  // namespace observing_test
