// Errors about what is observed, searched and bound: where they are told.

#include <string>

#include "catch.h"
#include "observing_rig.h"

namespace observing_errors_test {

using namespace fettle;
using console::test::ObservingRig;
using property::Value;

TEST_CASE("the key that opens the console runs no command") {
    ObservingRig rig;
    rig.run("bind('grave', 'world.ball.mass = 7')");
    CHECK(rig.text().find("bind: grave opens and closes the console; console.key chooses another "
                          "key for that") != std::string::npos);
    rig.lua.state().settings.set("key", Value("f1"));
    rig.run("bind('grave', 'world.ball.mass = 7')");
    rig.lua.open(false);
    CHECK(rig.press_key("grave"));
    CHECK(rig.value("world.ball.mass") == Value(7.0));
}

TEST_CASE("errors of what is observed and searched reach the host") {
    ObservingRig rig;
    std::string all;
    rig.lua.state().observing.on_result = [&](const std::string& line) { all += line + "|"; };
    rig.run("pin world.nothing");
    CHECK(all.starts_with("pin: world.nothing: no such name"));
    all.clear();
    rig.run("plot world.nothing");
    CHECK(all.starts_with("plot: world.nothing: no such name"));
    all.clear();
    rig.step(3);
    rig.run("last_time world.nothing");
    CHECK(all.starts_with("✗ last_time world.nothing: world.nothing: no such name"));
}

TEST_CASE("what is observed of a deleted instance is called deleted") {
    ObservingRig rig;
    rig.run("pin('world.crate.mass', 'world.crate.mass * 2', 'world.nothing.mass')");
    rig.step(2);
    rig.run("world.crate:delete()");
    rig.show(40);
    const auto problem = [&](std::size_t pin) {
        return rig.pins().at(pin).short_problem(rig.tree);
    };
    CHECK(problem(0) == "deleted");
    CHECK(problem(1) == "world.crate: no such name");
    CHECK(problem(2) == "not yet there");
}

TEST_CASE("what is observed of a renamed or moved instance says where it is now") {
    ObservingRig rig;
    rig.run("pin world.crate.mass");
    rig.run("plot world.crate.mass");
    rig.step(2);
    rig.run("world.crate.name = 'box'");
    rig.step();
    rig.show();
    CHECK(rig.pins()[0].short_problem(rig.tree) == "renamed to world.box");
    CHECK(rig.plots()[0].short_problem(rig.tree) == "renamed to world.box");
    rig.run("pins");
    CHECK(rig.text().find("world.crate.mass  renamed to world.box") != std::string::npos);
    const property::Handle box = property::get(rig.tree, "world.box").reference();
    const property::Handle world = rig.tree.parent(box);
    rig.tree.move(box, rig.tree.root(), "box");
    rig.step();
    CHECK(rig.pins()[0].short_problem(rig.tree) == "moved to box");
    rig.tree.move(box, world, "crate");
    rig.step();
    CHECK(rig.pins()[0].short_problem(rig.tree).empty());
}

TEST_CASE("a pin and a plot are those of a property as soon as its instance is made") {
    ObservingRig rig;
    rig.run("pin world.later.mass");
    rig.run("plot world.later.mass");
    rig.step(3);
    CHECK(rig.pins()[0].short_problem(rig.tree) == "not yet there");
    CHECK(rig.pins()[0].what().path.empty());
    rig.run("world.later = Body { mass = 4 }");
    rig.step();
    for (const auto* traces : {&rig.pins(), &rig.plots()}) {
        CHECK(traces->front().what().path == "world.later.mass");
        CHECK(traces->front().what().unit == "kg");
    }
    CHECK(rig.lua.state().observing.pinned("world.later.mass") == "world.later.mass");
    rig.run("pins");
    CHECK(rig.text().find("world.later.mass  4 kg") != std::string::npos);
}

TEST_CASE("a pin of an instance whose deletion is undone has its value at once") {
    ObservingRig rig;
    rig.run("pin('world.crate.mass', 'world.crate.mass * 2')");
    rig.run("time.paused = true");
    rig.run("world.crate:delete()");
    rig.show(3);
    CHECK(rig.pins()[0].short_problem(rig.tree) == "deleted");
    rig.run("undo");
    rig.show(1);
    CHECK(rig.pins()[0].value() == Value(1.0));
    rig.run("pins");
    CHECK(rig.text().find("world.crate.mass * 2  2") != std::string::npos);
}

TEST_CASE("a word of the console alone lists what there is") {
    ObservingRig rig;
    rig.step(9);
    const auto answer = [&](const std::string& command) {
        std::string all;
        for (const std::string& line : rig.lua.evaluate(command).lines) all += line + "|";
        return all;
    };
    CHECK(answer("pin") == "nothing is pinned|");
    CHECK(answer("plot") == "nothing is plotted|");
    CHECK(answer("break_when") == "no break is set|");
    CHECK(answer("bookmark") == "there is no bookmark|");
    CHECK(answer("bind") == "no key runs a command|");
    CHECK(answer("alias") == "no word is an alias|");
    rig.run("pin world.ball.mass > 1");
    rig.run("plot world.crate.mass");
    rig.run("bookmark('here', 7)");
    rig.run("bind('f5', 'rewind(5)')");
    rig.run("alias('g', 'world.gravity')");
    CHECK(answer("pins").starts_with("world.ball.mass > 1  "));
    CHECK(answer("plot") == "world.crate.mass  1 kg|");
    CHECK(answer("bookmarks") == "step 7  here|");
    CHECK(answer("bind") == "f5  rewind(5)|");
    CHECK(answer("aliases") == "g  world.gravity|");
    CHECK(answer("binds().f5 .. aliases().g") == "\"rewind(5)world.gravity\"|");
    // There is nothing to go to at other steps.
    for (const char* step : {"10", "1e9", "-1"})
        rig.run(std::string("bookmark('there', ") + step + ")");
    CHECK(answer("bookmarks") == "step 7  here|");
    CHECK(rig.text().find("bookmark: step 10 is not kept: those from 0 to 9 are") !=
          std::string::npos);
    CHECK(rig.text().find("bookmark: step 1000000000 is not kept") != std::string::npos);
    CHECK(rig.text().find("bookmark: step -1 is not kept") != std::string::npos);
    // A variable of the game is not such a word.
    rig.run("bind = 7");
    CHECK(answer("bind") == "7|");
}

TEST_CASE("a value that cannot be plotted now is named and the others are plotted") {
    ObservingRig rig;
    rig.run("plot world.ball.mass, world.nothing.mass");
    CHECK(rig.plots().size() == 2);
    CHECK(rig.text().find("it is shown when it has a value") != std::string::npos);
}

TEST_CASE("a break leaves the mark of the edit before it visible") {
    ObservingRig rig;
    rig.step(1500);
    rig.run("break_when world.ball.mass > 4");
    rig.run("world.ball.mass = 5");
    rig.step();
    rig.show(40);
    const console::Rect bar = rig.lua.state().views.time_bar.rect();
    REQUIRE_FALSE(bar.empty());
    bool edit = false, stop = false;
    const auto& pixels = rig.surface.pixels();
    const auto wide = static_cast<std::size_t>(rig.surface.width());
    for (auto y = static_cast<std::size_t>(bar.low.y); y < static_cast<std::size_t>(bar.high.y);
         ++y)
        for (auto x = static_cast<std::size_t>(bar.low.x); x < static_cast<std::size_t>(bar.high.x);
             ++x) {
            const console::test::Pixel& at = pixels[y * wide + x];
            edit = edit || at == console::test::pixel_of(console::palette::path);
            stop = stop || at == console::test::pixel_of(console::palette::number);
        }
    CHECK(edit);
    CHECK(stop);
}

TEST_CASE("the button of the inspector is struck out where that has no room") {
    ObservingRig rig;
    rig.run("plot world.ball.mass");
    console::test::RasterSurface small(400, 400);
    for (int i = 0; i < 3; ++i) rig.lua.draw(small, 1.0 / 60);
    CHECK(rig.lua.state().screen.inspector_left_out);
    rig.show();
    CHECK_FALSE(rig.lua.state().screen.inspector_left_out);
    rig.lua.state().settings.set("inspector", Value(false));
    for (int i = 0; i < 3; ++i) rig.lua.draw(small, 1.0 / 60);
    CHECK_FALSE(rig.lua.state().screen.inspector_left_out);
}

TEST_CASE("the watch list needs no scroll bar as soon as there is room for its rows") {
    ObservingRig rig;
    rig.run("pin('world.ball.position', 'world.crate.position + world.ball.position')");
    rig.step(3);
    console::test::RasterSurface low(700, 330), high(700, 900);
    const auto& list = rig.lua.state().views.watch_list;
    const auto draw = [&](console::test::RasterSurface& surface) {
        for (int i = 0; i < 4; ++i) rig.lua.draw(surface, 1.0 / 60);
    };
    draw(high);
    const float width = list.button(0).low.x, height = list.rect().high.y - list.rect().low.y;
    draw(low);
    draw(high);
    CHECK(list.button(0).low.x == width);
    CHECK(list.rect().high.y - list.rect().low.y == height);
    CHECK(list.button(1).high.y <= list.rect().high.y);
}

TEST_CASE("the inspector below the panel covers no error") {
    ObservingRig rig;
    auto& state = rig.lua.state();
    console::test::RasterSurface small(400, 500);
    const auto draw = [&] {
        for (int i = 0; i < 3; ++i) rig.lua.draw(small, 1.0 / 60);
    };
    draw();
    const float low = state.screen.inspector_rect.high.y;
    REQUIRE(low > 300);
    // A strip that ends a little above the lower edge of the inspector.
    state.options.free_of_others = [&](const app::ClipRectangle& whole) {
        return app::ClipRectangle{whole.left, whole.top, whole.width, low - 20};
    };
    draw();
    CHECK_FALSE(state.screen.inspector_rect.empty());
    CHECK(state.screen.inspector_rect.high.y <= low - 20);
    state.options.game_covered = [] { return true; };
    draw();
    CHECK(state.screen.inspector_rect.empty());
    CHECK(state.screen.inspector_left_out);
}

}  // namespace observing_errors_test
