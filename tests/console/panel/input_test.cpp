// Whether the game, the prompt or a widget gets an event.

#include "catch.h"
#include "rig.h"

namespace input_test {

using namespace fettle;
using console::test::Rig;
using property::Value;
using property::Vec2;

TEST_CASE("the grave key opens and closes the console and is never typed") {
    Rig rig;
    CHECK_FALSE(rig.console.is_open());
    CHECK(rig.press("grave"));
    CHECK(rig.character('`'));
    CHECK(rig.release("grave"));
    CHECK(rig.console.is_open());
    CHECK(rig.value("console.open") == Value(true));
    CHECK(rig.input().empty());
    rig.draw();
    CHECK(rig.surface.triangle_count() > 100);
    CHECK(rig.surface.faults() == 0);

    CHECK(rig.press("grave"));
    CHECK(rig.character('`'));
    CHECK(rig.release("grave"));
    CHECK_FALSE(rig.console.is_open());
    CHECK(rig.input().empty());
    rig.draw();
    CHECK(rig.surface.triangle_count() == 0);
}

TEST_CASE("a grave key held down toggles once") {
    Rig rig;
    rig.press("grave");
    app::InputEvent again = console::test::key_event("grave", true);
    again.repeated = true;
    for (int i = 0; i < 5; ++i) {
        CHECK(rig.console.handle(again));
        CHECK(rig.character('`'));
    }
    rig.release("grave");
    CHECK(rig.console.is_open());
    CHECK(rig.input().empty());
}

TEST_CASE("a letter typed while the grave key is still down is typed") {
    Rig rig;
    rig.press("grave");
    rig.character('`');
    rig.press("w");
    rig.character('w');
    rig.release("grave");
    rig.release("w");
    CHECK(rig.input() == "w");
}

TEST_CASE("a toggle key that is a dead key does not change the first letter") {
    Rig rig;
    rig.key("grave");  // types nothing yet, as ^ in Germany
    SECTION("it takes the letter away") {
        rig.press("w");
        rig.release("w");
        CHECK(rig.input() == "w");
    }
    SECTION("it puts an accent on the letter") {
        rig.press("w");
        rig.character(U'\u0175');
        rig.release("w");
        CHECK(rig.input() == "w");
    }
    SECTION("another key is pressed before the first one is released") {
        rig.press("w");
        rig.press("o");
        rig.character(U'o');
        CHECK(rig.input() == "wo");
    }
    SECTION("it was none") {
        rig.press("w");
        rig.character(U'w');
        rig.release("w");
        rig.press("e");
        rig.character(U'\u00e9');
        CHECK(rig.input() == "w\u00e9");
    }
    SECTION("it types a character by itself") {
        rig.key("grave");
        rig.press("grave");
        rig.character(U'\u00b2');
        rig.release("grave");
        rig.press("w");
        rig.release("w");
        CHECK(rig.input().empty());
    }
}

TEST_CASE("shift and the grave key type a tilde") {
    Rig rig;
    rig.key("grave");
    CHECK(rig.key("shift+grave"));
    rig.character('~');
    CHECK(rig.console.is_open());
    CHECK(rig.input() == "~");
}

TEST_CASE("another key can be set to open the console") {
    Rig rig;
    property::set(rig.tree, "console.key", Value("f1"));
    CHECK_FALSE(rig.key("grave"));
    CHECK_FALSE(rig.console.is_open());
    CHECK(rig.key("f1"));
    CHECK(rig.console.is_open());
    rig.character('`');
    CHECK(rig.input() == "`");
}

TEST_CASE("a name that is not a key is refused as the key of the console") {
    Rig rig;
    CHECK_THROWS_WITH(property::set(rig.tree, "console.key", Value("esc")),
                      contains("console.key: expected one of \"insert\", ") && contains("\"f15\""));
    CHECK_THROWS_WITH(property::set(rig.tree, "console.key", Value("f_1")),
                      contains("(did you mean \"f1\"?)"));
    CHECK(rig.key("grave"));
    CHECK(rig.console.is_open());
}

TEST_CASE("a key with which commands are typed cannot open the console") {
    Rig rig;
    for (const char* key : {"b", "7", "space", "enter", "period", "left", "numpad_7"})
        CHECK_THROWS_WITH(property::set(rig.tree, "console.key", Value(key)),
                          contains("console.key: expected one of"));
    CHECK(rig.value("console.key") == Value("grave"));
}

TEST_CASE("keys typed into the console never reach the game") {
    Rig rig;
    CHECK_FALSE(rig.key("space"));
    rig.key("grave");
    CHECK(rig.key("space"));
    CHECK(rig.key("f5"));
    CHECK(rig.key("ctrl+q"));
    CHECK(rig.character('x'));
    rig.key("grave");
    CHECK_FALSE(rig.key("space"));
    CHECK_FALSE(rig.character('x'));
}

TEST_CASE("a key held when the console opens is released for the game") {
    Rig rig;
    CHECK_FALSE(rig.press("left"));
    rig.key("grave");
    CHECK(rig.press("left"));  // auto-repeat
    CHECK_FALSE(rig.release("left"));
    CHECK(rig.release("left"));
}

TEST_CASE("a key released after the console closed does not reach the game") {
    Rig rig;
    rig.key("grave");
    CHECK(rig.press("a"));
    rig.key("grave");
    CHECK(rig.release("a"));
    CHECK_FALSE(rig.release("a"));
}

TEST_CASE("the console gets the mouse over it and the game gets the mouse beside it") {
    Rig rig;
    rig.key("grave");
    rig.draw();
    CHECK(rig.move(300, 100));
    CHECK(rig.button(true, 300, 100));
    CHECK(rig.move(300, 600));  // a drag that left the console is still the console's
    CHECK(rig.button(false, 300, 600));
    CHECK_FALSE(rig.move(300, 600));
    CHECK_FALSE(rig.button(true, 300, 600, "right"));
    CHECK_FALSE(rig.move(300, 100));  // a drag that entered the console is still the game's
    CHECK_FALSE(rig.button(false, 300, 100, "right"));
    rig.key("grave");
    CHECK_FALSE(rig.move(300, 100));
    CHECK_FALSE(rig.button(true, 300, 100));
}

TEST_CASE("a click on a body selects it and sets it") {
    Rig rig;
    rig.key("grave");
    rig.draw();
    Vec2 at = rig.state().options.to_pixels(Vec2(0, -4));
    CHECK(rig.button(true, static_cast<float>(at.x), static_cast<float>(at.y)));
    CHECK(rig.button(false, static_cast<float>(at.x), static_cast<float>(at.y)));
    CHECK(rig.tree.path(rig.console.selected()) == "world.ball");
    CHECK(rig.logged("it = world.ball"));
    rig.draw();
    CHECK_FALSE(rig.state()
                    .inspector.editor()
                    .widget_rect(rig.tree.property(rig.console.selected(), "position"))
                    .empty());
    // A click beside every body changes nothing.
    CHECK(rig.button(true, 600, 700));
    rig.button(false, 600, 700);
    CHECK(rig.tree.path(rig.console.selected()) == "world.ball");
}

TEST_CASE("a selected instance that the game makes again is selected again") {
    Rig rig;
    property::Handle world = rig.tree.child(rig.tree.root(), "world");
    rig.console.select(rig.tree.child(world, "crate"));
    rig.tree.destroy(rig.console.selected());
    rig.draw();
    CHECK_FALSE(rig.console.selected());
    property::Handle again = rig.tree.create(rig.tree.class_named("Body"), world, "crate");
    rig.draw();
    CHECK(rig.console.selected() == again);
}

TEST_CASE("a click does not select when picking is off or the console is closed") {
    Rig rig;
    Vec2 at = rig.state().options.to_pixels(Vec2(0, -4));
    auto x = static_cast<float>(at.x), y = static_cast<float>(at.y);
    rig.draw();
    CHECK_FALSE(rig.button(true, x, y));
    rig.button(false, x, y);
    rig.key("grave");
    rig.draw();
    property::set(rig.tree, "console.picks", Value(false));
    CHECK_FALSE(rig.button(true, x, y));
    rig.button(false, x, y);
    CHECK_FALSE(rig.console.selected());
}

TEST_CASE("the console pauses the game while it is open if the option is set") {
    Rig rig;
    property::set(rig.tree, "console.pauses", Value(true));
    CHECK(rig.value("time.paused") == Value(false));
    rig.key("grave");
    CHECK(rig.value("time.paused") == Value(true));
    property::set(rig.tree, "console.pauses", Value(false));
    rig.draw();
    CHECK(rig.value("time.paused") == Value(false));
    property::set(rig.tree, "console.pauses", Value(true));
    rig.draw();
    CHECK(rig.value("time.paused") == Value(true));
    rig.key("grave");
    CHECK(rig.value("time.paused") == Value(false));
}

TEST_CASE("a game that was paused stays paused when the console closes") {
    Rig rig;
    property::set(rig.tree, "time.paused", Value(true));
    property::set(rig.tree, "console.pauses", Value(true));
    rig.key("grave");
    rig.key("grave");
    CHECK(rig.value("time.paused") == Value(true));
}

TEST_CASE("the console can be opened by its property") {
    Rig rig;
    property::set(rig.tree, "console.open", Value(true));
    CHECK(rig.key("x"));
    rig.draw();
    CHECK(rig.surface.triangle_count() > 100);
    property::set(rig.tree, "console.open", Value(false));
    rig.draw();
    CHECK(rig.surface.triangle_count() == 0);
}

TEST_CASE("a console deleted from the tree is made again") {
    Rig rig;
    rig.tree.destroy(rig.tree.child(rig.tree.root(), "console"));
    rig.tree.barrier();
    rig.key("grave");
    rig.draw();
    CHECK(rig.console.is_open());
    CHECK(rig.value("console.open") == Value(true));
}

TEST_CASE("losing the focus releases held keys") {
    Rig rig;
    rig.key("grave");
    rig.press("left_control");
    app::InputEvent lost;
    lost.kind = app::EventKind::focus;
    CHECK_FALSE(rig.console.handle(lost));
    rig.draw();
    rig.type("a");
    CHECK(rig.input() == "a");
}

TEST_CASE("the events of one frame arrive in order") {
    Rig rig;
    rig.key("grave");
    rig.type("world.ball.mass = 7");
    rig.key("enter");
    rig.type("world.crate.mass = 8");
    rig.key("enter");
    CHECK(rig.value("world.ball.mass") == Value(7.0));
    CHECK(rig.value("world.crate.mass") == Value(8.0));
}

TEST_CASE("letters close an open list or menu and are typed into the prompt") {
    Rig rig;
    rig.key("grave");
    rig.draw();
    rig.console.select(rig.tree.child(rig.tree.child(rig.tree.root(), "world"), "ball"));
    rig.draw(3);
    const ImVec2 at = rig.widget("type");
    rig.click(at.x, at.y);
    rig.draw(2);
    REQUIRE(rig.state().screen.popup_open);
    rig.type("wor");
    CHECK(rig.input() == "wor");
    rig.draw(2);
    CHECK_FALSE(rig.state().screen.popup_open);
    rig.state().context_menu.open("world.ball");
    rig.draw(3);
    REQUIRE(rig.state().screen.popup_open);
    rig.type("ld");
    CHECK(rig.input() == "world");
    rig.draw(2);
    CHECK_FALSE(rig.state().screen.popup_open);
    CHECK(rig.value("world.ball.type") == Value("dynamic"));
}

}  // namespace input_test
