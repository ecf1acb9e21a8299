// The list of pinned values in windows of different sizes.

#include <cmath>

#include "catch.h"
#include "observing_rig.h"

namespace watch_list_test {

using namespace fettle;
using console::test::ObservingRig;

TEST_CASE("the whole name of a pin is readable in a small window") {
    ObservingRig rig;
    const std::string path = "world.ball.position.x",
                      sum = "world.ball.position.x + world.ball.position.y * 2 - world.ball.mass";
    rig.run("pin " + path);
    rig.run("pin " + sum);
    rig.run("pin " + sum + " + 1 - 1 + 1 - 1 + 1 - 1 + 1 - 1 + 1 - 1 + 1 - 1 + 1 - 1 + 1 - 1 + 1");
    REQUIRE(rig.pins().size() == 3);
    rig.step(30);
    console::test::RasterSurface small(400, 600);
    rig.show();
    for (int i = 0; i < 3; ++i) rig.lua.draw(small, 1.0 / 60);
    const console::WatchList& list = rig.lua.state().views.watch_list;
    const float width = list.rect().high.x - list.rect().low.x;
    const auto row = [&](std::size_t pin, float wide) {
        return list.row_of(rig.tree, rig.pins()[pin], wide, false);
    };
    const auto name = [&](std::size_t pin) {
        std::string all;
        for (const std::string& part : row(pin, width).above) all += part;
        return all;
    };
    CHECK(name(1) == sum);
    CHECK(row(1, width).height > row(0, width).height);
    CHECK(row(1, 1200).above.empty());  // beside the value
    CHECK(row(2, width).above.size() == 3);
    CHECK(name(2).ends_with("…"));  // a tooltip has the rest
    // The rows do not overlap.
    CHECK(list.button(1).low.y >= list.button(0).high.y);
    CHECK(list.button(1).high.y - list.button(1).low.y >= row(1, width).height - 1);
}

TEST_CASE("a window of 400 by 300 pixels shows several lines of the log and a pinned value") {
    ObservingRig rig;
    rig.run("pin world.ball.position.x + world.ball.position.y * 2 - world.ball.mass");
    rig.step(30);
    console::test::RasterSurface small(400, 300);
    rig.show();
    for (int i = 0; i < 3; ++i) rig.lua.draw(small, 1.0 / 60);
    const console::Rect& panel = rig.lua.state().screen.panel_rect;
    const float line = rig.lua.state().views.log_view.line_height();
    CHECK(panel.high.y - panel.low.y > 6.5f * line);  // title, prompt and three lines
    const console::WatchList& list = rig.lua.state().views.watch_list;
    CHECK(list.button(0).high.y <= list.rect().high.y);
    CHECK(list.rect().low.y >= panel.high.y);
    // Of a command with many lines, those that are drawn are whole.
    const auto prompt_height = [&](console::test::RasterSurface& on) {
        for (int i = 0; i < 3; ++i) rig.lua.draw(on, 1.0 / 60);
        const console::Rect& prompt = rig.lua.state().views.prompt_view.rect();
        return prompt.high.y - prompt.low.y;
    };
    const auto new_line = [&] {
        for (const bool pressed : {true, false}) {
            fettle::app::InputEvent enter = console::test::key_event("enter", pressed);
            enter.shift = true;
            rig.lua.handle(enter);
        }
    };
    console::test::RasterSurface large(1280, 800);
    const float one = prompt_height(large);
    new_line();
    const float spacing = prompt_height(large) - one;
    REQUIRE(spacing > 5);
    for (int i = 0; i < 5; ++i) new_line();
    const float lines = 1 + (prompt_height(small) - one) / spacing;
    CHECK(lines > 1.9f);
    CHECK(lines < 4);
    CHECK(lines == Approx(std::round(lines)));
}

}  // namespace watch_list_test
