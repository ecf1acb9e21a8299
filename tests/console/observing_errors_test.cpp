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
        return console::short_problem(rig.tree, rig.pins().at(pin));
    };
    CHECK(problem(0) == "deleted");
    CHECK(problem(1) == "world.crate: no such name");
    CHECK(problem(2) == "world.nothing: no such name");
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

}  // namespace observing_errors_test
