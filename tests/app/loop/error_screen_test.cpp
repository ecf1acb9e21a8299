// The picture of the error screen: where its lines are.

#include <fettle/app/error_screen.h>

#include <algorithm>
#include <string>
#include <vector>

#include "catch.h"
#include "noting_screen.h"

namespace error_screen_test {

using namespace fettle;
using app::NotingSurface;

namespace {

script::ScriptError an_error() {
    script::ScriptError error;
    error.message = "main.lua:3: world.bal: no such name";
    error.traceback = "main.lua:3: in update";
    return error;
}

}  // namespace

TEST_CASE("the keys of the error screen are above layers that cover the lower edge") {
    float covered = 0;
    app::ErrorScreen screen({.reload = {}, .go_on = {}, .covered_below = [&] { return covered; }});
    screen.show(an_error());
    NotingSurface open;
    screen.draw(open, 0);
    CHECK(open.line_with("R  reload") > 756);
    CHECK(open.line_with("no such name") > 0);
    covered = 60;
    NotingSurface under;
    screen.draw(under, 0);
    CHECK(under.line_with("R  reload") > 0);
    CHECK(under.line_with("R  reload") < 740);
}

TEST_CASE("the text of an error is in the part of the window that an open console leaves free") {
    app::ClipRectangle free{0, 0, 1280, 800};
    app::ErrorScreen screen({.reload = {},
                             .go_on = {},
                             .covered_below = [] { return 60.0f; },
                             .free_area = [&](const app::ClipRectangle&) { return free; }});
    script::ScriptError error = an_error();
    for (int i = 0; i < 12; ++i) error.message += " word" + std::to_string(i);
    screen.show(error);
    NotingSurface whole;
    screen.draw(whole, 0);
    CHECK(whole.line_with("The game stopped") == 48);
    CHECK(whole.line_with("no such name") == whole.line_with("word5"));
    free = {0, 370, 640, 370};
    NotingSurface part;
    screen.draw(part, 0);
    REQUIRE(!part.lines.empty());
    for (const auto& [line, y] : part.lines) CHECK(y > 370);
    CHECK(part.line_with("word5") > part.line_with("no such name"));  // it is narrower
    CHECK(part.line_with("in update") > part.line_with("word11"));
    // Where nothing is free, no text lies behind another layer.
    free = {0, 700, 640, 0};
    NotingSurface none;
    screen.draw(none, 0);
    CHECK(none.line_with("The game stopped") == -1);
    CHECK(none.line_with("R  reload") > 0);
}

TEST_CASE("the game is visible above a strip while the past before an error is shown") {
    bool past = false;
    app::ErrorScreen screen({.reload = {},
                             .go_on = {},
                             .covered_below = [] { return 60.0f; },
                             .viewing_past = [&] { return past; }});
    screen.show(an_error());
    NotingSurface whole;
    screen.draw(whole, 0);
    CHECK(whole.top == 0);
    CHECK(whole.line_with("in update") > 0);
    past = true;
    NotingSurface strip;
    screen.draw(strip, 0);
    CHECK(strip.top > 600);
    CHECK(strip.line_with("no such name") > 600);
    CHECK(strip.line_with("R  reload") > 600);
    CHECK(strip.line_with("in update") == -1);
}

TEST_CASE("the strip of an error shows the whole message or says that it goes on") {
    app::ErrorScreen screen({.reload = {}, .go_on = {}, .viewing_past = [] { return true; }});
    script::ScriptError error;
    error.message = "main.lua:3:";
    for (int i = 0; i < 30; ++i) error.message += " word" + std::to_string(i);
    screen.show(error);
    NotingSurface strip;
    screen.draw(strip, 0);
    CHECK(strip.line_with("word29") > strip.line_with("main.lua:3"));
    CHECK(strip.line_with("…") == -1);
    CHECK(strip.line_with("main.lua:3") > strip.top);
    CHECK(strip.line_with("R  reload") > strip.line_with("word29") + 16);
    NotingSurface narrow;
    narrow.wide = 400;
    screen.draw(narrow, 0);
    CHECK(narrow.line_with("word29") == -1);
    CHECK(narrow.line_with("…") > narrow.line_with("main.lua:3"));
    CHECK(narrow.text_right <= 400);
}

TEST_CASE("an error that has too little room beside other layers says that it goes on") {
    app::ClipRectangle free{0, 0, 500, 120};
    app::ErrorScreen screen(
        {.reload = {}, .go_on = {}, .free_area = [&](const app::ClipRectangle&) { return free; }});
    script::ScriptError error = an_error();
    for (int i = 0; i < 30; ++i) error.message += " word" + std::to_string(i);
    screen.show(error);
    NotingSurface low;
    screen.draw(low, 0);
    CHECK(low.line_with("…") > 0);
    CHECK(low.line_with("word29") == -1);
    // A heading is left out with the rows below it.
    for (float height = 40; height < 400; height += 4) {
        free = {0, 0, 900, height};
        screen.hide();
        screen.show(an_error());
        NotingSurface surface;
        screen.draw(surface, 0);
        INFO(height);
        CHECK((surface.line_with("Called from") > 0) == (surface.line_with("in update") > 0));
    }
}

TEST_CASE("a long error of changed files takes several lines of its strip") {
    app::ErrorScreen screen({.reload = {}, .go_on = {}, .covered_below = [] { return 0.0f; }});
    script::ScriptError error;
    for (int i = 0; i < 40; ++i) error.message += "word" + std::to_string(i) + " ";
    screen.show_over(error);
    NotingSurface surface;
    screen.draw(surface, 0);
    CHECK(surface.line_with("word0 ") > surface.top);
    CHECK(surface.line_with("word39 ") > surface.line_with("word0 "));
    CHECK(surface.line_with("word39 ") < 800 - 17);
    // Marks of other layers are above it, and nothing of the game shines through.
    const app::ClipRectangle free = screen.free_area({0, 0, 1280, 800});
    CHECK(free.height == surface.top);
    REQUIRE_FALSE(surface.fills.empty());
    CHECK(surface.fills.front().a == 255);
    screen.hide();
    NotingSurface after;
    screen.draw(after, 0);
    CHECK(after.lines.empty());
    CHECK(screen.free_area({0, 0, 1280, 800}).height == 800);
}

TEST_CASE("in a narrow window all keys are shown and lines break between words") {
    app::ErrorScreen screen({.reload = {}, .go_on = {}});
    script::ScriptError error = an_error();
    error.source_line = "wheel.motor_speed = start.motor_speed * factor + offset + drift - losses";
    screen.show(error);
    NotingSurface surface;
    surface.wide = 600;
    screen.draw(surface, 0);
    CHECK(surface.text_right <= surface.wide);
    CHECK(surface.line_with("back in time") > 0);
    CHECK(surface.line_with("scroll") > 0);
    // Each word of the source line is in one row.
    for (const char* word :
         {"wheel.motor_speed", "start.motor_speed", "factor", "offset", "losses"})
        CHECK(surface.line_with(word) > 0);
}

TEST_CASE("while the console is open only the key that closes it is listed") {
    bool open = true, past = GENERATE(false, true);
    app::ErrorScreen screen({.reload = {},
                             .go_on = {},
                             .viewing_past = [&] { return past; },
                             .console_is_open = [&] { return open; }});
    screen.show(an_error());
    NotingSurface surface;
    screen.draw(surface, 0);
    CHECK(surface.line_with("close the console") > 0);
    CHECK(surface.line_with("reload") < 0);
    open = false;
    surface.lines.clear();
    screen.draw(surface, 0);
    CHECK(surface.line_with("close the console") < 0);
    CHECK(surface.line_with("reload") > 0);
}

TEST_CASE("the error screen names the key of the console if there is one") {
    std::string key = "f1";
    bool open = false;
    app::ErrorScreen screen({.reload = {},
                             .go_on = {},
                             .console_is_open = [&] { return open; },
                             .console_key = [&] { return key; }});
    screen.show(an_error());
    const auto has = [&](const char* text) {
        NotingSurface surface;
        screen.draw(surface, 0);
        return surface.line_with(text) > 0;
    };
    CHECK(has("f1  console"));
    CHECK_FALSE(has("`"));
    open = true;
    CHECK(has("f1  close the console"));
    open = false;
    key.clear();
    CHECK_FALSE(has("console"));
    CHECK(has("back in time"));
}

TEST_CASE("the caret is below the row of a wrapped line that has the error") {
    app::ErrorScreen screen({.reload = {}, .go_on = {}});
    script::ScriptError error = an_error();
    error.file = "main.lua";
    error.line = 3;
    for (int i = 0; i < 60; ++i) error.source_line += i == 30 ? "wrong " : "right ";
    error.column = 30 * 6 + 1;
    screen.show(error);
    NotingSurface surface;
    screen.draw(surface, 0);
    const auto& lines = surface.lines;
    const auto caret = std::find_if(lines.begin(), lines.end(),
                                    [](const auto& line) { return line.first.ends_with('^'); });
    REQUIRE(caret != lines.end());
    CHECK((caret - 1)->first.find("wrong") == caret->first.size() - 1);
    CHECK(caret->second > (caret - 1)->second);
    // Further rows begin below the text, and not below the number of the line.
    CHECK((caret + 1)->first.starts_with("   right"));
}

TEST_CASE("arrows go through the past while the error is shown") {
    int went = 0;
    app::ErrorScreen screen(
        {.reload = {}, .go_on = {}, .travel = [&](int steps) { went += steps; }});
    const auto press = [&](const char* key, bool repeated) {
        app::InputEvent event;
        event.kind = app::EventKind::key_pressed;
        event.name = key;
        event.repeated = repeated;
        return screen.handle(event);
    };
    CHECK_FALSE(press("left", false));
    screen.show(an_error());
    CHECK(press("left", false));
    CHECK(went == -6);
    CHECK(press("left", true));  // a held key goes on
    CHECK(went == -12);
    CHECK(press("right", false));
    CHECK(went == -6);
}

}  // namespace error_screen_test
