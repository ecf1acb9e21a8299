// Actions of the player, by simulated input.

#include "screen.h"

namespace interaction_test {

using namespace fettle::interface::test;

namespace {

constexpr const char* menu = R"(
    input.actions.jump = { "space", "mouse.left", "gamepad.a" }
    function key_pressed(key) print("key", key) end
    function mouse_pressed(button) print("mouse", button) end
    function mouse_released(button) print("mouse up", button) end
    function wheel() print("wheel") end
    function text_input(text) print("text", text) end
    function gamepad_pressed(_, button) print("pad", button) end
    function action_pressed(action) print("action", action) end
    game.menu = Panel { modal = true, Column {
        Button { name = "a", text = "a", pressed = function() print("a!") end },
        Button { name = "b", text = "b", pressed = function() print("b!") end },
        Toggle { name = "t", text = "t", changed = function(e) print("t", e.value) end },
        Slider { name = "s", min = 0, max = 10, changed = function(e) print("s", e.value) end },
        TextField { name = "f", submitted = function(e) print("f", e.text) end },
    }, cancelled = function() print("cancelled") end })";

struct Menu : Screen {
    Menu() : Screen(menu) {}
};

}  // namespace

TEST_CASE_METHOD(Menu, "a click presses a button and the game does not get it") {
    click("menu.column.a");
    CHECK(new_output() == "a!");
    click("menu.column.b");
    CHECK(new_output() == "b!");
    // Pressed on one, released over another: nothing.
    point(middle("menu.column.a"));
    set("input.mouse.left", true);
    turn();
    CHECK(get("menu.column.a.held").boolean());
    point(middle("menu.column.b"));
    set("input.mouse.left", false);
    turn();
    CHECK(new_output().empty());
    CHECK_FALSE(get("menu.column.a.held").boolean());
    CHECK(get("menu.column.b.hovered").boolean());
    // A modal menu gets clicks beside it, too.
    click(Vec2(5, 5));
    CHECK(new_output().empty());
    CHECK_FALSE(get("input.jump.held").boolean());
}

TEST_CASE_METHOD(Menu, "without a modal widget the game gets what no widget takes") {
    set("menu.modal", Value(false));
    turn();
    set("interface.focus", Value());
    click(Vec2(5, 5));
    CHECK(new_output() == "mouse\tleft action\tjump mouse up\tleft");
    click("menu.column.a");
    CHECK(new_output() == "a!");
    tap("space");
    CHECK(new_output() == "key\tspace action\tjump");
    // A click on a text field gives it the keyboard, one beside it takes it away.
    click("menu.column.f");
    new_output();
    tap("space");
    tap("q");
    CHECK(new_output().empty());
    click(Vec2(5, 5));
    new_output();
    tap("q");
    CHECK(new_output() == "key\tq");
    set("menu.visible", Value(false));
    click("menu.column.a");
    CHECK(new_output().find("mouse\tleft") == 0);
}

TEST_CASE_METHOD(Menu, "a key that the menu got does not reach the game until it is released") {
    set("input.keys.space", true);
    turn();
    CHECK(new_output() == "a!");
    run("menu:delete()");
    turn();
    CHECK_FALSE(get("input.jump.held").boolean());
    set("input.keys.space", false);
    turn();
    CHECK(new_output().empty());
    set("input.keys.space", true);
    turn();
    CHECK(new_output() == "key\tspace action\tjump");
    CHECK(get("input.jump.held").boolean());
}

TEST_CASE_METHOD(Menu, "keys and the gamepad move the keyboard focus through the menu") {
    CHECK(focus() == "menu.column.a");
    tap("down");
    CHECK(focus() == "menu.column.b");
    tap("enter");
    CHECK(new_output() == "b!");
    tap("tab");
    CHECK(focus() == "menu.column.t");
    tap("space");
    CHECK(new_output() == "t\ttrue");
    CHECK(get("menu.column.t.value").boolean());
    set("input.gamepad_1.dpad_down", true);
    turn();
    set("input.gamepad_1.dpad_down", false);
    turn();
    CHECK(focus() == "menu.column.s");
    set("input.gamepad_1.left", Value(Vec2(1, 0)));
    turn();
    CHECK(new_output() == "s\t0.5");
    CHECK(get("input.move").vec2() == Vec2(0, 0));
    set("input.gamepad_1.left", Value(Vec2(0, 0)));
    set("input.keys.left_shift", true);
    tap("tab");
    CHECK(focus() == "menu.column.t");
    set("input.keys.left_shift", false);
    tap("up");
    tap("up");
    tap("up");
    CHECK(focus() == "menu.column.f");
    tap("escape");
    set("input.gamepad_1.b", true);
    turn();
    CHECK(new_output() == "cancelled cancelled");
}

TEST_CASE_METHOD(Menu, "a direction that a gamepad holds is repeated") {
    const auto values = [&](int frames) {
        turn(frames);
        return get("menu.column.s.value").number();
    };
    set("interface.focus", Value(at("menu.column.s")));
    set("input.gamepad_1.left", Value(Vec2(1, 0)));
    CHECK(values(1) == 0.5);
    CHECK(values(20) == 0.5);  // a third of a second
    const double after = values(60);
    CHECK(after >= 3);
    CHECK(after <= 6);
    set("input.gamepad_1.left", Value(Vec2(0, 0)));
    const double end = values(1);
    CHECK(values(60) == end);
    // From one widget to the next, and not without a menu.
    new_output();
    set("input.gamepad_1.dpad_up", true);
    turn();
    CHECK(focus() == "menu.column.t");
    turn(28);
    CHECK(focus() == "menu.column.b");
    set("menu.modal", Value(false));
    set("interface.focus", Value());
    turn(60);
    CHECK(focus().empty());
}

TEST_CASE_METHOD(Menu, "disabled and invisible widgets are left out") {
    set("menu.column.a.disabled", true);
    turn();
    CHECK(focus() == "menu.column.b");
    click("menu.column.a");
    CHECK(new_output().empty());
    set("menu.column.b.visible", false);
    turn();
    CHECK(focus() == "menu.column.t");
    set("menu.column.disabled", true);
    turn();
    CHECK(focus().empty());
    click("menu.column.t");
    CHECK_FALSE(get("menu.column.t.value").boolean());
}

TEST_CASE("left and right move within a row and skip disabled widgets") {
    Screen s(R"(
        game.m = Panel { modal = true, Column {
            Row { name = "cards", Button { name = "a", text = "one", min_size = vec(200, 80) },
                                  Button { name = "b", text = "two", min_size = vec(200, 80), disabled = true },
                                  Button { name = "c", text = "three", min_size = vec(200, 80), disabled = true } },
            Row { name = "below", Button { name = "d", text = "four" }, Button { name = "e", text = "five" } } } })");
    s.turn();
    CHECK(s.focus() == "m.column.cards.a");
    s.tap("right");  // the buttons below are to the right of its middle
    CHECK(s.focus() == "m.column.cards.a");
    s.set("m.column.cards.c.disabled", false);
    s.turn();
    s.tap("right");
    CHECK(s.focus() == "m.column.cards.c");
    s.tap("right");
    CHECK(s.focus() == "m.column.cards.a");
    s.tap("left");
    CHECK(s.focus() == "m.column.cards.c");
    s.tap("down");
    CHECK(s.focus().starts_with("m.column.below."));
}

TEST_CASE_METHOD(Menu, "a slider follows the mouse and the arrow keys") {
    const Vec2 corner = get("menu.column.s.screen_position").vec2();
    const Vec2 size = get("menu.column.s.screen_size").vec2();
    point(corner + Vec2(0.5 * size.x, 0.5 * size.y));
    set("input.mouse.left", true);
    turn();
    CHECK(get("menu.column.s.value").number() == Approx(5));
    point(corner + Vec2(size.x + 500, -100));
    turn();
    CHECK(get("menu.column.s.value").number() == 10);
    set("input.mouse.left", false);
    turn();
    point(corner);
    turn();
    CHECK(get("menu.column.s.value").number() == 10);
    set("menu.column.s.step", Value(3.0));
    tap("left");
    CHECK(get("menu.column.s.value").number() == 6);
    new_output();
    set("menu.column.s.value", Value(2.0));  // by a script: no event
    turn();
    CHECK(new_output().empty());
}

TEST_CASE_METHOD(Menu, "text is typed at the caret") {
    click("menu.column.f");
    type(U"héllo");
    CHECK(get("menu.column.f.text").text() == "héllo");
    tap("home");
    tap("right");
    tap("delete");
    type(U"e");
    CHECK(get("menu.column.f.text").text() == "hello");
    tap("end");
    tap("backspace");
    CHECK(get("menu.column.f.text").text() == "hell");
    CHECK(get("menu.column.f.caret").integer() == 4);
    set("menu.column.f.max_length", Value(5));
    type(U" you");
    CHECK(get("menu.column.f.text").text() == "hell ");
    tap("enter");
    CHECK(new_output() == "f\thell ");
    // A caret beyond the end of its text, or of a shorter text, is moved to the end.
    set("menu.column.f.caret", Value(1000));
    tap("backspace");
    CHECK(get("menu.column.f.text").text() == "hell");
}

TEST_CASE_METHOD(Menu, "in a text from right to left, the caret follows the arrow of the key") {
    click("menu.column.f");
    type(U"שלום");
    CHECK(get("menu.column.f.caret").integer() == 4);
    tap("left");  // the caret is at the end, which is at the left
    CHECK(get("menu.column.f.caret").integer() == 4);
    tap("right");
    CHECK(get("menu.column.f.caret").integer() == 3);
    tap("home");
    tap("left");
    CHECK(get("menu.column.f.caret").integer() == 1);
    tap("backspace");
    CHECK(get("menu.column.f.text").text() == "לום");
    // A click at the left end goes to the end.
    const Vec2 corner = get("menu.column.f.screen_position").vec2();
    click(corner + Vec2(2, 0.5 * get("menu.column.f.screen_size").vec2().y));
    CHECK(get("menu.column.f.caret").integer() == 3);
}

TEST_CASE_METHOD(Menu, "a click puts the caret behind a space at the end of a text") {
    click("menu.column.f");
    type(U"ab  ");
    tap("home");
    const Vec2 corner = get("menu.column.f.screen_position").vec2();
    const Vec2 size = get("menu.column.f.screen_size").vec2();
    click(corner + Vec2(size.x - 5, 0.5 * size.y));
    CHECK(get("menu.column.f.caret").integer() == 4);
}

TEST_CASE("a list scrolls and its lines are chosen") {
    Screen s(R"(
        local items = {}
        for i = 1, 40 do items[i] = "line " .. i end
        game.l = List { items = items, size = vec(200, 150), changed = function(e) print("c", e.selected) end,
            submitted = function(e) print("s", e.selected) end }
        function wheel() print("wheel") end)");
    s.click(s.get("l.screen_position").vec2() + Vec2(50, 50));
    CHECK(s.new_output() == "c\t2");
    s.click(s.get("l.screen_position").vec2() + Vec2(50, 50));
    CHECK(s.new_output() == "s\t2");
    s.set("input.mouse.wheel", Value(-2.0));
    s.turn();
    CHECK(s.new_output().empty());
    const double scrolled = s.get("l.scroll").number();
    CHECK(scrolled > 50);
    s.set("input.mouse.wheel", Value(-1000.0));
    s.turn();
    const double end = s.get("l.scroll").number();
    CHECK(end < 40 * 40);
    s.run("l:focus()");
    s.tap("end");
    CHECK(s.get("l.selected").integer() == 40);
    s.tap("home");
    CHECK(s.get("l.scroll").number() == 0);
    s.point(Vec2(1000, 700));
    s.set("input.mouse.wheel", Value(1.0));
    s.turn();
    CHECK(s.new_output().find("wheel") != std::string::npos);
    // Widgets in a list scroll, too, and the one with the keyboard is shown.
    s.run(R"(game.m = List { modal = true, size = vec(200, 100) }
        for i = 1, 10 do m:add(Button { text = "b" .. i, pressed = function() print("b" .. i) end }) end)");
    s.turn();
    s.new_output();
    for (int i = 0; i < 9; ++i) s.tap("tab");
    CHECK(s.get("m.scroll").number() > 200);
    s.click("m.button_10");
    CHECK(s.new_output() == "b10");
    CHECK(s.draw().drawn > 0);
}

TEST_CASE("the button that has the keyboard is lighter than the others and has a thick ring") {
    Screen s(R"(game.m = Column { modal = true, Button { text = "a" }, Button { text = "b" } }
        interface.theme.focus = color("#00ff00"))");
    s.point({700, 700});
    s.tap("down");
    s.turn(60);
    const std::vector<Paint> drawn = s.draw().polygons;
    REQUIRE(drawn.size() == 3);  // a button, a ring, and the button in it
    CHECK(s.focus() == "m.button_2");
    CHECK(drawn[1].border == Color{0, 1, 0, 1});
    CHECK(drawn[1].border_width >= 3);
    CHECK(drawn[2].fill.r > drawn[0].fill.r + 0.05f);
}

TEST_CASE("a list has no chosen line after the chosen line is removed") {
    Screen s(R"(
        game.l = List { items = { "a", "b", "c" }, selected = 3, size = vec(200, 150),
            changed = function(e) print("c", e.selected) end, submitted = function(e) print("s", e.selected) end }
        l:focus()
        l.items = { "a", "b" })");
    s.tap("enter");
    CHECK(s.new_output().empty());
    s.tap("up");
    CHECK(s.new_output() == "c\t2");
    s.tap("enter");
    CHECK(s.new_output() == "s\t2");
}

TEST_CASE("a button listens for a key and binds an action") {
    Screen s(R"(
        input.actions.jump = { "space", "gamepad.a" }
        game.m = Panel { modal = true, Column {
            Button { name = "jump", bind = "input.actions.jump" },
            Button { name = "any", text = "any", captured = function(e) print("got", e.name) end } } })");
    s.turn();
    CHECK(s.get("m.column.jump.text").text() == "space, gamepad a");
    s.tap("enter");
    CHECK(s.get("m.column.jump.listening").boolean());
    s.tap("escape");
    CHECK_FALSE(s.get("m.column.jump.listening").boolean());
    s.tap("enter");
    s.tap("left_shift");
    CHECK(s.get("m.column.jump.text").text() == "left shift, gamepad a");
    s.tap("enter");
    s.set("input.gamepad_1.left_shoulder", true);
    s.turn();
    CHECK(s.tree.text(s.get("input.actions.jump")) ==
          "{\"left_shift\", \"gamepad.left_shoulder\"}");
    s.set("m.column.any.listening", true);
    s.set("input.mouse.right", true);
    s.turn();
    CHECK(s.new_output() == "got\tmouse.right");
}

TEST_CASE("the menu in front has the keyboard until it is closed") {
    Screen s(
        R"(game.m = Panel { modal = true, Column { Button { name = "a", text = "a" }, Button { name = "b", text = "b" } } })");
    s.tap("down");
    CHECK(s.focus() == "m.column.b");
    s.run(R"(game.n = Panel { modal = true, Button { text = "c" } })");
    s.turn();
    CHECK(s.focus() == "n.button");
    s.tap("down");
    CHECK(s.focus() == "n.button");
    s.run("n:delete()");
    s.turn();
    CHECK(s.focus() == "m.column.b");
    s.run("m:delete()");
    s.turn();
    CHECK(s.focus().empty());
}

TEST_CASE("a menu that is not modal has the keyboard again after a modal one above it") {
    Screen s(R"(
        game.m = Panel { Column { Button { name = "a", text = "a" }, Button { name = "b", text = "b" } } }
        game.m.column.b:focus())");
    s.turn();
    const auto open_and_close = [&](const std::string& inside, const std::string& close) {
        s.run("game.n = Panel { modal = true, " + inside + " }");
        s.turn();
        CHECK(s.focus() != "m.column.b");
        s.tap("down");
        s.run(close);
        s.turn();
    };
    open_and_close(R"(Button { text = "c" })", "n:delete()");
    CHECK(s.focus() == "m.column.b");
    s.tap("up");
    CHECK(s.focus() == "m.column.a");
    open_and_close(R"(Button { text = "c" })", "n.visible = false");
    CHECK(s.focus() == "m.column.a");
    s.run("n:delete()");
    open_and_close(R"(Label { text = "nothing to press" })", "n:delete()");
    CHECK(s.focus() == "m.column.a");
    // One modal menu above the other, and the one that takes the keyboard by itself.
    s.run(R"(game.n = Panel { modal = true, Button { text = "c" } })");
    s.turn();
    s.run(R"(game.o = Panel { modal = true, Button { text = "d" } } o.button:focus())");
    s.turn();
    CHECK(s.focus() == "o.button");
    s.run("o:delete() n:delete()");
    s.turn();
    CHECK(s.focus() == "m.column.a");
    // It does not get the keyboard back if the player or the game has taken it away.
    s.tap("escape");
    open_and_close(R"(Button { text = "c" })", "n:delete()");
    CHECK(s.focus().empty());
    s.run("m.column.a:focus()");
    s.turn();
    s.run("interface.focus = nil");
    s.turn();
    CHECK(s.focus().empty());
    s.run("m.column.a:focus()");
    open_and_close(R"(Button { text = "c" })", "m.column.a.visible = false n:delete()");
    CHECK(s.focus().empty());
}

TEST_CASE("after a rewind into a modal menu its end returns the keyboard to the widget before") {
    Screen s(R"(
        game.m = Panel { Column { Button { name = "a", text = "a" }, Button { name = "b", text = "b" } } }
        game.m.column.b:focus())");
    s.turn();
    s.run(R"(game.n = Panel { modal = true, Button { text = "c" } })");
    s.turn();
    const Snapshot then = s.tree.snapshot();
    s.run("n:delete()");
    s.turn();
    s.tap("up");
    s.tree.restore(then);
    s.turn();
    CHECK(s.focus() == "n.button");
    s.run("n:delete()");
    s.turn();
    CHECK(s.focus() == "m.column.b");
}

TEST_CASE_METHOD(Menu, "changes of widgets by the player are restored with a snapshot") {
    set("time.rewind_limit", Value(60.0));
    click("menu.column.f");
    type(U"abc");
    const Snapshot then = tree.snapshot();
    type(U"def");
    tap("tab");
    set("menu.column.s.value", Value(7.0));
    tree.restore(then);
    turn();
    CHECK(get("menu.column.f.text").text() == "abc");
    CHECK(get("menu.column.f.caret").integer() == 3);
    CHECK(focus() == "menu.column.f");
    CHECK(get("menu.column.s.value").number() == 0);
    // A snapshot of a moment in which a slider was dragged does not go on with it.
    point(middle("menu.column.s"));
    set("input.mouse.left", true);
    turn();
    const Snapshot dragged = tree.snapshot();
    set("input.mouse.left", false);
    turn();
    tree.restore(dragged);
    turn();
    point(Vec2(1200, 300));
    turn();
    CHECK(get("menu.column.s.value").number() == Approx(5));
}

}  // namespace interaction_test
