// Pictures of the console: the log with selection and links, sizes, fonts, other surfaces.

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>

#include <fettle/property/storage/font_files.h>

#include <look/theme.h>
#include <text/utf8.h>
#include "catch.h"
#include "rig.h"

namespace view_test {

using namespace fettle;
using console::Rect;
using console::text_width;
using console::wrapped;
using console::test::RasterSurface;
using console::test::Rig;
using property::Value;

namespace {

/// Pixel position of a character in the last row of a line of the log.
ImVec2 log_position(Rig& rig, std::size_t lines_from_end, float column) {
    rig.draw(2);
    float line = rig.state().views.log_view.line_height();
    ImVec2 corner = rig.state().views.log_view.text_end();
    return ImVec2(corner.x + (column + 2) * rig.state().views.log_view.cell(),
                  corner.y - (static_cast<float>(lines_from_end) + 0.5f) * line);
}

}  // namespace

TEST_CASE("typed text changes the picture") {
    Rig rig;
    rig.key("grave");
    rig.draw(3);
    auto before = rig.surface.pixels();
    rig.draw();
    CHECK(rig.surface.pixels() == before);
    rig.type("world");
    rig.draw();
    CHECK(rig.surface.pixels() != before);
}

TEST_CASE("text in the log selected with a drag is copied") {
    Rig rig;
    rig.key("grave");
    rig.console.print("first line");
    rig.console.print("second line");
    ImVec2 from = log_position(rig, 1, 6), to = log_position(rig, 0, 6);
    rig.drag(from.x, from.y, to.x, to.y);
    rig.key("ctrl+c");
    CHECK(rig.clipboard.text == "line\nsecond");
    rig.key("escape");
    CHECK(rig.console.is_open());
    CHECK_FALSE(rig.state().views.log_view.selecting());
}

TEST_CASE("a double click in the log selects a word") {
    Rig rig;
    rig.key("grave");
    rig.console.print("this is some prose");
    ImVec2 at = log_position(rig, 0, 10);
    rig.click(at.x, at.y);
    rig.click(at.x, at.y);
    rig.draw();
    CHECK(rig.state().views.log_view.selected() == "some");
}

TEST_CASE("a path in the log is a link to its instance") {
    Rig rig;
    rig.key("grave");
    rig.console.print("world.crate.friction: 0.2 → 0.6");
    ImVec2 at = log_position(rig, 0, 8);
    rig.click(at.x, at.y);
    rig.draw();
    CHECK(rig.tree.path(rig.console.selected()) == "world.crate");
    rig.press("left_control");
    at = log_position(rig, 1, 8);  // one line higher, because the choice printed one line
    rig.click(at.x, at.y);
    rig.release("left_control");
    CHECK(rig.input() == "world.crate.friction");
}

TEST_CASE("a word in the log that is not a path is not a link") {
    Rig rig;
    rig.key("grave");
    rig.console.print("world.nothing.here is not there");
    ImVec2 at = log_position(rig, 0, 8);
    rig.click(at.x, at.y);
    rig.draw();
    CHECK_FALSE(rig.console.selected());
}

TEST_CASE("the log scrolls by pages and returns to the end with the next command") {
    Rig rig;
    rig.key("grave");
    for (int i = 0; i < 500; ++i) rig.console.print("line " + std::to_string(i));
    rig.draw(3);
    float end = rig.state().views.log_view.scrolled();
    CHECK(end > 1000);
    rig.key("page_up");
    rig.draw(2);
    CHECK(rig.state().views.log_view.scrolled() < end - 50);
    float up = rig.state().views.log_view.scrolled();
    rig.console.print("more");
    rig.draw(2);
    CHECK(rig.state().views.log_view.scrolled() == Approx(up));  // the lines that are shown stay
    rig.type("world.ball.mass");
    rig.key("enter");
    rig.draw(3);
    CHECK(rig.state().views.log_view.scrolled() > end);
}

TEST_CASE("long lines are wrapped and any text can be drawn") {
    Rig rig;
    rig.key("grave");
    rig.console.print(std::string(3000, 'x'));
    rig.console.print("→ ∞ ² ° ü \xff\xfe 漢字 \t tab");
    rig.console.print("%s %n %d");
    rig.type("%s%n");
    rig.draw(3);
    CHECK(rig.surface.faults() == 0);
    CHECK(rig.surface.triangle_count() > 1000);
}

TEST_CASE("a long path of a reference is shown by its end") {
    Rig rig;
    rig.draw(3);
    const property::Class& body = *rig.tree.find_class("Body");
    property::Handle at = rig.tree.child(rig.tree.root(), "world");
    for (int i = 0; i < 12; ++i)
        at = rig.tree.create(body, at, "a_rather_long_name_" + std::to_string(i));
    const property::Handle leaf = rig.tree.create(body, at, "leaf");
    rig.key("grave");
    rig.state().choose(leaf);
    const ImVec2 middle = rig.widget("parent");
    const auto picture = [&] {
        rig.draw(3);
        auto seen = rig.surface.pixels();
        const auto wide = static_cast<std::ptrdiff_t>(rig.surface.width());
        const auto row = static_cast<std::ptrdiff_t>(middle.y) * wide;
        seen.erase(seen.begin() + row + static_cast<std::ptrdiff_t>(middle.x) + 60, seen.end());
        seen.erase(seen.begin(), seen.begin() + row + static_cast<std::ptrdiff_t>(middle.x) - 60);
        return seen;
    };
    const auto before = picture();
    rig.tree.rename(at, "another_name_at_the_end");
    CHECK(picture() != before);
}

TEST_CASE("a click opens folded output") {
    Rig rig;
    rig.key("grave");
    rig.draw(3);
    std::vector<std::string> lines;
    for (int i = 0; i < 70; ++i) lines.push_back("line " + std::to_string(i));
    script::Evaluation evaluation;
    evaluation.lines = lines;
    rig.state().log.output(evaluation);
    rig.draw(3);
    const auto& view = rig.state().views.log_view;
    rig.click(view.text_end().x + 4 * view.cell(), view.text_end().y - view.line_height() / 2);
    rig.draw(3);
    CHECK(rig.logged("line 69"));
    CHECK(rig.surface.faults() == 0);
}

TEST_CASE("the text grows by a factor") {
    Rig rig;
    rig.key("grave");
    rig.draw(3);
    const float cell = rig.state().views.log_view.cell();
    property::set(rig.tree, "console.scale", Value(2.0));
    rig.draw(3);
    CHECK(rig.state().views.log_view.cell() == Approx(2 * cell).margin(1));
    // Lengths measured in letters grow with it, as long as there is room beside the panel.
    property::set(rig.tree, "console.scale", Value(1.25));
    rig.draw(3);
    const auto wide = [&] {
        return rig.state().screen.inspector_rect.high.x - rig.state().screen.inspector_rect.low.x;
    };
    CHECK(wide() == Approx(1.25 * 420).margin(2));
    const float edge = rig.state().screen.inspector_rect.low.x;
    rig.drag(edge + 2, 200, edge + 52, 200);
    rig.draw(2);
    CHECK(wide() == Approx(1.25 * 420 - 50).margin(4));
    property::set(rig.tree, "console.scale", Value(4.0));
    property::set(rig.tree, "console.font_size", Value(48.0));
    rig.draw(3);
    CHECK(rig.surface.faults() == 0);
}

TEST_CASE("the filter field in the title is high enough") {
    Rig rig;
    property::set(rig.tree, "console.font_size", Value(10.0));
    rig.key("grave");
    rig.draw(3);
    const Rect& field = rig.state().screen.filter_rect;
    CHECK(field.high.y - field.low.y >= 16);
}

TEST_CASE("remarks break at blanks and not inside of numbers") {
    Rig rig;
    rig.key("grave");
    rig.draw(2);
    rig.state().ui.activate();
    const std::string text = "mixed: -0.0005695 to 0.0003446 rad";
    CHECK(wrapped(text, 1000) == text);
    CHECK(wrapped(text, text_width("mixed: -0.0005695 to 0.00")) ==
          "mixed: -0.0005695 to\n0.0003446 rad");
    CHECK(wrapped(text, 1) == "mixed:\n-0.0005695\nto\n0.0003446\nrad");
    CHECK(wrapped("a\nb c", text_width("b c")) == "a\nb c");
    CHECK(wrapped("", 10).empty());
}

TEST_CASE("a color in the log has a swatch") {
    Rig rig;
    rig.key("grave");
    rig.state().log.output("world.ball.color: color(\"#12fe34\")");
    rig.draw(3);
    const auto& pixels = rig.surface.pixels();
    CHECK(std::ranges::count(pixels, console::test::Pixel{0x12, 0xfe, 0x34}) > 30);
    rig.state().log.clear();
    rig.state().log.output("\"#12fe34\" is not a color here");
    rig.draw(3);
    CHECK(std::ranges::count(rig.surface.pixels(), console::test::Pixel{0x12, 0xfe, 0x34}) == 0);
}

TEST_CASE("changes of the size properties take effect at once") {
    Rig rig;
    rig.key("grave");
    rig.draw(2);
    float before = rig.state().screen.panel_rect.high.y;
    property::set(rig.tree, "console.height", Value(0.8));
    rig.draw();
    CHECK(rig.state().screen.panel_rect.high.y > before + 100);
    property::set(rig.tree, "console.inspector", Value(false));
    rig.draw();
    CHECK(rig.state().screen.inspector_rect.empty());
    CHECK(rig.state().screen.panel_rect.high.x > 1200);
    property::set(rig.tree, "console.font_size", Value(24.0));
    rig.draw();
    CHECK(rig.state().ui.font_size() == 24);
    CHECK(rig.surface.faults() == 0);
}

TEST_CASE("the lower edge of the panel is dragged") {
    Rig rig;
    rig.key("grave");
    rig.draw(2);
    float y = rig.state().screen.panel_rect.high.y - 2;
    rig.drag(300, y, 300, y + 100);
    rig.draw();
    CHECK(rig.state().screen.panel_rect.high.y == Approx(y + 100).margin(8));
}

TEST_CASE("the console draws on another surface and on tiny ones") {
    Rig rig;
    rig.key("grave");
    rig.draw(2);
    std::deque<RasterSurface>
        others;  // all exist at the same time, because surfaces are distinguished by address
    for (auto [width, height] : {std::pair{1920u, 1080u}, {320u, 200u}, {40u, 30u}, {1u, 1u}}) {
        RasterSurface& other = others.emplace_back(width, height);
        rig.console.draw(other, 1.0 / 60);
        CHECK(other.faults() == 0);
    }
    rig.draw();
    CHECK(rig.surface.faults() == 0);
}

TEST_CASE("the console can be drawn with any numbers from the host") {
    /// Only its size is used.
    struct Sized : app::Surface {
        float wide = 0, high = 0;
        int drawn = 0;
        float width() const override { return wide; }
        float height() const override { return high; }
        Texture create_texture(unsigned, unsigned, const std::uint8_t*) override { return 1; }
        void update_texture(Texture, unsigned, unsigned, unsigned, unsigned,
                            const std::uint8_t*) override {}
        void destroy_texture(Texture) override {}
        void triangles(std::span<const app::SurfaceVertex>, std::span<const std::uint16_t>, Texture,
                       const app::ClipRectangle&) override {
            ++drawn;
        }
    };
    constexpr float infinite = std::numeric_limits<float>::infinity();
    const float odd[] = {std::nanf(""), -infinite, -1.0f, 0.0f,  1e-40f,  1.0f,
                         7.0f,          333.0f,    1e9f,  1e38f, infinite};
    Rig rig;
    rig.key("grave");
    rig.draw(2);
    rig.console.select(rig.tree.root());
    for (const float number : odd) {
        INFO(number);
        app::InputEvent event;
        for (const auto kind : {app::EventKind::mouse_moved, app::EventKind::mouse_pressed,
                                app::EventKind::mouse_released, app::EventKind::wheel}) {
            event.kind = kind;
            event.name = "left";
            event.x = event.y = event.delta = number;
            rig.console.handle(event);
            rig.draw();
        }
        Sized surface;
        surface.wide = number;
        surface.high = 300;
        rig.console.draw(surface, 1.0 / 60);
        std::swap(surface.wide, surface.high);
        rig.console.draw(surface, 1.0 / 60);
        rig.console.draw(rig.surface, double(number));
    }
    Sized good;
    good.wide = good.high = 500;
    rig.console.draw(good, 1.0 / 60);
    CHECK(good.drawn > 0);
}

TEST_CASE("two consoles at the same time do not affect each other") {
    Rig one, two;
    one.key("grave");
    two.key("grave");
    one.draw();
    two.draw();
    one.type("only one");
    one.draw();
    two.draw();
    CHECK(one.input() == "only one");
    CHECK(two.input().empty());
    CHECK(one.surface.faults() + two.surface.faults() == 0);
}

TEST_CASE("a candidate is chosen with the mouse") {
    Rig rig;
    rig.key("grave");
    rig.draw();
    rig.type("world.ball.f");
    rig.key("tab");
    rig.draw(2);
    auto rect = rig.state().views.prompt_view.menu_rect();
    REQUIRE_FALSE(rect.empty());
    std::string second = rig.state().prompt.menu().candidates()[1].completion.text;
    float row = rig.state().ui.font_size() + 5;
    rig.click(rect.low.x + 60, rect.low.y + 7 + row * 1.5f);
    rig.draw();
    CHECK(rig.input() == "world.ball." + second);
    CHECK(rig.console.is_open());
}

TEST_CASE("the mouse sets the cursor and selects in the prompt") {
    Rig rig;
    rig.key("grave");
    rig.type("world.ball.mass");
    rig.draw(2);
    auto rect = rig.state().views.prompt_view.rect();
    float cell = rig.state().views.log_view.cell();
    float x = rect.low.x + 6 + 2 * cell;
    rig.drag(x + 6 * cell, rect.middle().y, x + 10 * cell, rect.middle().y);
    CHECK(rig.state().prompt.edit().selected() == "ball");
    rig.type("x");
    CHECK(rig.input() == "world.x.mass");
}

TEST_CASE("errors and printed text of the game are shown in the console") {
    Rig rig;
    rig.console.print("hello\nworld");
    script::ScriptError error;
    error.message = "main.lua:3: world.bal: no such name";
    error.source_line = "  world.bal.mass = 1";
    error.traceback = "main.lua:3: in update\nmain.lua:9: in main\n";
    rig.console.report(error);
    CHECK(rig.logged("hello\nworld\n"));
    CHECK(rig.logged("        ^^^\n"));
    CHECK(rig.logged("main.lua:9"));
    rig.key("grave");
    rig.draw(2);
    CHECK(rig.surface.faults() == 0);
}

TEST_CASE("a window that an exception leaves open is ended and the console goes on") {
    Rig rig;
    rig.key("grave");
    rig.console.select(property::resolve(rig.tree, "world.ball").instance);
    rig.draw(3);
    rig.state().inspector.editor().define = [](const std::string&,
                                               const std::string&) -> std::string {
        throw std::runtime_error("no formulas today");
    };
    rig.state().inspector.editor().fields().calculate =
        [](const std::string&) -> std::optional<double> {
        throw std::runtime_error("no calculator");
    };
    for (const char* typed : {"2+2", "is 2"}) {
        const ImVec2 at = rig.widget("mass");
        rig.click(at.x, at.y);
        rig.draw(2);
        rig.key("ctrl+a");
        rig.type(typed);
        rig.key("enter");
        rig.draw(3);
        rig.key("escape");
        rig.draw(2);
    }
    CHECK(rig.logged("console: no formulas today"));
    CHECK(rig.value("world.ball.mass") == Value(1.0));
    rig.console.open();  // the second Escape closed it
    rig.draw();
    rig.type("world.ball.mass = 5");
    rig.key("enter");
    CHECK(rig.value("world.ball.mass") == Value(5.0));
    CHECK(rig.surface.faults() == 0);
}

TEST_CASE("Chinese and Japanese letters are drawn in two cells each") {
    if (property::font_file("DroidSansFallbackFull.ttf").empty()) return;  // it is not installed
    const auto picture = [](const char* text) {
        Rig rig;
        rig.key("grave");
        rig.console.print(text);
        rig.draw(4);
        return rig.surface.pixels();
    };
    // Without their font, all of them would be the same box.
    const bool differ = picture("日本") != picture("本日");
    CHECK(differ);
    CHECK(console::cell_count("a日本b") == 6);
    CHECK(console::cell_offset("a日本b", 3) == 4);
    CHECK(console::cell_offset("a日本b", 2) == 1);  // the second half of the first
    CHECK(console::cell_offset("a日", 9) == 4);
    CHECK(console::cell_count("\xe6\x97") == 1);  // not complete
    Rig rig;
    rig.key("grave");
    for (const char32_t c : U"日本x")
        if (c != 0) rig.character(c);
    CHECK(rig.state().prompt.edit().column_of(rig.input().size()) == 5);
}

TEST_CASE("the edges of the windows are dragged from either side") {
    Rig rig;
    rig.key("grave");
    rig.draw(3);
    const auto drag = [&](float x, float y, float to_x, float to_y) {
        rig.move(x, y);
        rig.draw(2);
        rig.button(true, x, y);
        rig.draw(2);
        rig.move(to_x, to_y);
        rig.draw(2);
        rig.button(false, to_x, to_y);
        rig.draw(2);
    };
    for (const float beside : {7.0f, -7.0f}) {
        const console::Rect panel = rig.state().screen.panel_rect;
        drag(300, panel.high.y + beside, 300, panel.high.y + 60);
        CHECK(rig.state().screen.panel_rect.high.y == Approx(panel.high.y + 60).margin(12));
        const console::Rect side = rig.state().screen.inspector_rect;
        drag(side.low.x + beside, 200, side.low.x - 50, 200);
        CHECK(rig.state().screen.inspector_rect.low.x == Approx(side.low.x - 50).margin(12));
    }
}

}  // namespace view_test
