// The command line, key by key, without a window.

#include <chrono>
#include <string>

#include "catch.h"
#include "rig.h"

#include <look/imgui_compat.h>

namespace prompt_test {

using namespace fettle::console;
using fettle::console::test::Rig;
using fettle::property::Value;
using fettle::property::Vec2;

namespace {

/// A rig whose console is open.
struct OpenRig : Rig {
    OpenRig() { key("grave"); }
    void run(std::string_view command) {
        type(command);
        key("enter");
    }
    const CompletionMenu& menu() { return state().prompt.menu(); }
};

}  // namespace

TEST_CASE("Enter runs the command and the log shows the command and the result") {
    OpenRig rig;
    rig.run("world.ball.mass = 5");
    CHECK(rig.value("world.ball.mass") == Value(5.0));
    CHECK(rig.input().empty());
    CHECK(rig.logged("world.ball.mass = 5\nworld.ball.mass: 5"));
}

TEST_CASE("Enter on an empty prompt runs nothing") {
    OpenRig rig;
    rig.run("");
    rig.run("   ");
    CHECK(rig.commands.empty());
    CHECK(rig.input().empty());
}

TEST_CASE("Enter on an incomplete command adds an indented line") {
    OpenRig rig;
    rig.type("  for i = 1, 3 do");
    rig.key("enter");
    CHECK(rig.commands.empty());
    CHECK(rig.input() == "  for i = 1, 3 do\n  ");
    rig.type("end");
    rig.key("enter");
    REQUIRE(rig.commands.size() == 1);
    CHECK(rig.commands[0] == "  for i = 1, 3 do\n  end");
}

TEST_CASE("ctrl Enter runs the prompt and shift Enter adds a line") {
    OpenRig rig;
    rig.type("world.ball.mass");
    rig.key("shift+enter");
    CHECK(rig.input() == "world.ball.mass\n");
    rig.key("backspace");
    rig.key("ctrl+enter");
    CHECK(rig.commands.back() == "world.ball.mass");
    rig.type("for x do");
    rig.key("ctrl+enter");
    CHECK(rig.input().empty());
    CHECK(rig.logged("not complete"));
}

TEST_CASE("Up and Down visit the commands that begin with the typed text") {
    OpenRig rig;
    for (const char* command : {"world.ball.mass", "time.paused", "world.crate.mass"})
        rig.run(command);
    rig.type("world");
    rig.key("up");
    CHECK(rig.input() == "world.crate.mass");
    rig.key("up");
    CHECK(rig.input() == "world.ball.mass");
    rig.key("up");
    CHECK(rig.input() == "world.ball.mass");
    rig.key("down");
    CHECK(rig.input() == "world.crate.mass");
    rig.key("down");
    CHECK(rig.input() == "world");
    rig.key("ctrl+a");
    rig.key("delete");
    rig.key("up");
    rig.key("up");
    CHECK(rig.input() == "time.paused");
}

TEST_CASE("Up within several lines moves the cursor first") {
    OpenRig rig;
    rig.run("time.paused");
    rig.type("a");
    rig.key("shift+enter");
    rig.type("b");
    rig.key("up");
    CHECK(rig.input() == "a\nb");
    CHECK(rig.state().prompt.edit().cursor() == 1);
}

TEST_CASE("reverse search finds older and older commands") {
    OpenRig rig;
    for (const char* command : {"world.ball.mass", "time.paused", "world.crate.mass"})
        rig.run(command);
    rig.type("draft");
    rig.key("ctrl+r");
    rig.type("mas");
    CHECK(rig.input() == "world.crate.mass");
    rig.key("ctrl+r");
    CHECK(rig.input() == "world.ball.mass");
    rig.key("ctrl+r");
    CHECK(rig.state().prompt.search_failed());
    rig.key("ctrl+r");  // starts again with the newest
    CHECK(rig.input() == "world.crate.mass");
    rig.key("escape");
    CHECK(rig.input() == "draft");
    CHECK(rig.console.is_open());

    rig.key("ctrl+r");
    rig.type("ball");
    rig.key("enter");
    CHECK(rig.commands.back() == "world.ball.mass");
    CHECK_FALSE(rig.state().prompt.search());
}

TEST_CASE("reverse search is narrowed and widened by typing") {
    OpenRig rig;
    rig.run("world.ball.mass");
    rig.run("world.crate.mass");
    rig.key("ctrl+r");
    rig.type("ballx");
    CHECK(rig.state().prompt.search_failed());
    rig.key("backspace");
    CHECK_FALSE(rig.state().prompt.search_failed());
    CHECK(rig.input() == "world.ball.mass");
    rig.key("left");  // accepts the command for editing
    CHECK_FALSE(rig.state().prompt.search());
    CHECK(rig.input() == "world.ball.mass");
}

TEST_CASE("Tab completes at once when there is one candidate") {
    OpenRig rig;
    rig.type("world.ball.m");
    rig.key("tab");
    CHECK(rig.input() == "world.ball.mass");
    CHECK_FALSE(rig.menu().open());
}

TEST_CASE("Tab completes at once to the only name that begins with what is typed") {
    const auto named = [](const char* name) {
        return fettle::script::Completion{.text = name, .label = name, .detail = {}, .doc = {}};
    };
    CompletionMenu menu;
    menu.show({named("velocity"), named("angular_velocity")}, "vel", 3);
    CHECK(menu.select_continuation("vel", 3));
    CHECK(menu.selection().text == "velocity");
    menu.show({named("World"), named("world")}, "wor", 3);
    CHECK(menu.select_continuation("wor", 3));
    CHECK(menu.selection().text == "world");
    menu.show({named("mass"), named("mass_center")}, "mas", 3);
    CHECK_FALSE(menu.select_continuation("mas", 3));
    menu.show({named("mass"), named("mass_center")}, "mass", 4);
    CHECK_FALSE(menu.select_continuation("mass", 4));  // the list shows the other
    menu.show({named("force"), named("torque")}, "", 0);
    CHECK_FALSE(menu.select_continuation("", 0));
}

TEST_CASE("Tab shows candidates and typing narrows them") {
    OpenRig rig;
    rig.type("world.ball.f");
    rig.key("tab");
    REQUIRE(rig.menu().open());
    CHECK(rig.menu().candidates().size() == 3);
    CHECK(rig.menu().selection().detail == "0.612345 · number · 0 to inf");
    rig.type("o");
    CHECK(rig.menu().selection().label == "force");
    rig.key("backspace");
    rig.type("r");
    CHECK(rig.menu().selection().label == "friction");
    rig.key("tab");
    CHECK(rig.input() == "world.ball.friction");
    CHECK_FALSE(rig.menu().open());
}

TEST_CASE("the arrow keys choose a candidate and Enter inserts it without running") {
    OpenRig rig;
    rig.type("world.ball.f");
    rig.key("tab");
    std::string first = rig.menu().selection().text;
    rig.key("down");
    std::string second = rig.menu().selection().text;
    CHECK(first != second);
    rig.key("up");
    rig.key("up");
    rig.key("down");
    CHECK(rig.menu().selection().text == first);
    rig.key("down");
    rig.key("enter");
    CHECK(rig.input() == "world.ball." + second);
    CHECK(rig.commands.empty());
    rig.key("enter");
    CHECK(rig.commands.size() == 1);
}

TEST_CASE("Enter on a completely typed name runs it") {
    OpenRig rig;
    rig.type("world.ball.f");
    rig.key("tab");
    rig.type("riction");
    REQUIRE(rig.menu().open());
    rig.key("enter");
    CHECK(rig.commands.size() == 1);
}

TEST_CASE("the candidates are closed when other text is typed") {
    OpenRig rig;
    rig.type("world.ball.f");
    rig.key("tab");
    rig.type(" ");
    CHECK_FALSE(rig.menu().open());
    rig.type("= 2");
    rig.key("ctrl+a");
    rig.type("f");
    rig.key("tab");
    REQUIRE(rig.menu().open());
    rig.key("left");
    CHECK_FALSE(rig.menu().open());
}

TEST_CASE("Escape clears the text before it closes the console") {
    Rig rig;
    rig.key("grave");
    rig.type("world.ball");
    CHECK(rig.key("escape"));
    CHECK(rig.input().empty());
    CHECK(rig.console.is_open());
    CHECK(rig.key("ctrl+z"));  // the text comes back
    CHECK(rig.input() == "world.ball");
    rig.key("escape");
    rig.key("escape");
    CHECK_FALSE(rig.console.is_open());
}

TEST_CASE("ctrl Z undoes typing and then the game's last edit") {
    Rig rig;
    rig.key("grave");
    rig.type("a");
    rig.key("ctrl+z");
    CHECK(rig.input().empty());
    CHECK(rig.commands.empty());
    rig.key("ctrl+z");
    REQUIRE(rig.commands.size() == 1);
    CHECK(rig.commands.back() == "undo");
    Rig again;
    again.key("grave");
    again.key("ctrl+y");
    again.key("ctrl+shift+z");
    CHECK(again.commands == std::vector<std::string>{"redo", "redo"});
}

TEST_CASE("Escape closes the candidates before the console") {
    OpenRig rig;
    rig.type("f");
    rig.key("tab");
    REQUIRE(rig.menu().open());
    rig.key("escape");
    CHECK_FALSE(rig.menu().open());
    CHECK(rig.console.is_open());
    rig.key("escape");
    CHECK(rig.console.is_open());
    CHECK(rig.input().empty());
    rig.key("escape");
    CHECK_FALSE(rig.console.is_open());
}

TEST_CASE("the latest command with the same beginning is suggested and accepted by Right") {
    OpenRig rig;
    rig.run("world.ball.mass = 4");
    rig.type("world.b");
    CHECK(rig.state().prompt.suggestion() == "all.mass = 4");
    rig.key("right");
    CHECK(rig.input() == "world.ball.mass = 4");
    CHECK(rig.state().prompt.suggestion().empty());
}

TEST_CASE("copy and cut and paste use the clipboard") {
    OpenRig rig;
    rig.type("world.ball");
    rig.key("ctrl+a");
    rig.key("ctrl+c");
    CHECK(rig.clipboard.text == "world.ball");
    rig.key("end");
    rig.clipboard.text = ".mass = 3\r\n";
    rig.key("ctrl+v");
    CHECK(rig.input() == "world.ball.mass = 3");
    CHECK(rig.commands.empty());  // a pasted line end does not run the command
    rig.key("shift+home");
    rig.key("ctrl+x");
    CHECK(rig.input().empty());
    CHECK(rig.clipboard.text == "world.ball.mass = 3");
    rig.key("ctrl+z");
    CHECK(rig.input() == "world.ball.mass = 3");
}

TEST_CASE("several pasted lines are one command") {
    OpenRig rig;
    rig.clipboard.text = "for i = 1, 2 do\n\tprint(i)\nend\n";
    rig.key("ctrl+v");
    rig.key("enter");
    REQUIRE(rig.commands.size() == 1);
    CHECK(rig.commands[0] == "for i = 1, 2 do\n  print(i)\nend");
}

TEST_CASE("a paste that is not possible says why") {
    OpenRig rig;
    rig.type("world.ball");
    rig.clipboard.text = "";  // the same as for a text that is too long for the window system
    rig.key("ctrl+v");
    CHECK(rig.input() == "world.ball");
    CHECK(rig.logged("nothing is pasted: the clipboard has no text, or one that is too long"));
    // The text is not cut to fit, because a part of a command may have another effect.
    rig.clipboard.text = std::string(TextEdit::max_bytes - 9, 'x');
    rig.key("ctrl+v");
    CHECK(rig.input() == "world.ball");
    CHECK(
        rig.logged("nothing is pasted: the text has 1048567 bytes, and a command has at most "
                   "1048576"));
    // It fits if it replaces the selected text.
    rig.key("ctrl+a");
    rig.key("ctrl+v");
    CHECK(rig.input() == rig.clipboard.text);
}

TEST_CASE("ctrl Z undoes an edit with the mouse and not a text that was deleted before") {
    OpenRig rig;
    rig.type("world");
    rig.key("escape");
    CHECK(rig.input().empty());
    rig.key("ctrl+z");
    CHECK(rig.input() == "world");
    rig.key("escape");
    rig.click(600, 500);
    rig.key("ctrl+z");
    CHECK(rig.input().empty());
    REQUIRE(rig.commands.size() == 1);
    CHECK(rig.commands[0] == "undo");
    // While the prompt has a text, ctrl Z undoes its typing.
    rig.type("world");
    rig.click(600, 500);
    rig.key("ctrl+z");
    CHECK(rig.input().empty());
    CHECK(rig.commands.size() == 1);
}

TEST_CASE("an error shows its line with a caret and the suggestion") {
    OpenRig rig;
    rig.run("world.bal.mass = 5");
    CHECK(rig.logged("did you mean \"ball\"?"));
    CHECK(rig.logged("world.bal.mass = 5\n      ^^^\n"));
    CHECK(rig.state().log.lines().back().kind == LineKind::caret);
}

TEST_CASE("ctrl L clears the log") {
    OpenRig rig;
    rig.run("world.ball.mass");
    rig.draw();
    rig.key("ctrl+l");
    CHECK(rig.log_text().empty());
    rig.run("world.ball.mass");
    rig.draw();
    CHECK(rig.logged("world.ball.mass"));
}

TEST_CASE("the whole value of a candidate is shown where the mouse is") {
    OpenRig rig;
    const auto tooltip = [] {
        const ImGuiWindow* const window = ImGui::FindWindowByName("##Tooltip_00");
        return window != nullptr && window->Active;
    };
    rig.type("world.ball.");
    rig.key("tab");
    rig.draw(3);
    const Rect menu = rig.state().views.prompt_view.menu_rect();
    REQUIRE_FALSE(menu.empty());
    CHECK_FALSE(tooltip());
    rig.move(menu.middle().x, menu.low.y + 20);  // the first row shows 0.6123
    rig.draw(3);
    CHECK(tooltip());
}

TEST_CASE("a frame with a long text in the prompt takes no longer than its text") {
    OpenRig rig;
    const auto seconds = [&](const std::string& text) {
        rig.state().prompt.edit().assign(text);
        rig.draw(2);
        const auto begin = std::chrono::steady_clock::now();
        rig.draw(3);
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    };
    std::string words, lines;
    for (int i = 0; i < 16'000; ++i) words += "x = 12 ";
    for (int i = 0; i < 5'000; ++i) lines += "line = " + std::to_string(i) + "\n";
    // These took minutes and seconds when the columns before each word were counted again.
    CHECK(seconds(words) < 1);
    CHECK(seconds(lines) < 1);
}

}  // namespace prompt_test
