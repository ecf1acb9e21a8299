#include <catch.h>

#include <limits>

#include <fettle/app/error_screen.h>
#include <fettle/app/layer.h>

#include "game.h"

namespace fettle::app {

namespace {

using property::Vec2;

constexpr std::string_view listener = R"(
    function key_pressed(key) print("+" .. key) end
    function key_released(key) print("-" .. key) end
    function mouse_pressed(button, world, screen)
        print(("+%s %g,%g %g,%g"):format(button, world.x, world.y, screen.x, screen.y))
    end
    function mouse_released(button) print("-" .. button) end
    function mouse_moved(world, screen) print(("to %g,%g %g,%g"):format(world.x, world.y, screen.x, screen.y)) end
    function wheel(delta, world) print("wheel " .. delta) end
    function text_input(text) print("text " .. text) end
    function resized(width, height) print(("resized %g %g"):format(width, height)) end
    function focus(gained) print("focus " .. tostring(gained)) end
    function closing() print("closing") end
    function gamepad_pressed(gamepad, button) print("pad " .. gamepad .. " +" .. button) end
    function gamepad_released(gamepad, button) print("pad " .. gamepad .. " -" .. button) end
    function gamepad_axis(gamepad, axis, value) print("pad " .. gamepad .. " " .. axis .. " " .. value) end
)";

/// Consumes every event while it is on.
struct Curtain : Layer {
    bool on = true;
    std::vector<EventKind> seen;
    bool handle(const InputEvent& event) override {
        seen.push_back(event.kind);
        return on;
    }
    void draw(Surface&, double) override {}
};

InputEvent event(EventKind kind) {
    InputEvent e;
    e.kind = kind;
    return e;
}

}  // namespace

TEST_CASE("a key is a property while it is held and a callback when it changes") {
    Game game(listener);
    game.press("space");
    CHECK(game.get("input.keys.space").boolean());
    game.loop.frame(tick);
    CHECK(game.new_output() == "+space");
    game.loop.frame(tick);
    CHECK(game.new_output() == "");
    game.release("space");
    CHECK_FALSE(game.get("input.keys.space").boolean());
    game.loop.frame(tick);
    CHECK(game.new_output() == "-space");
}

TEST_CASE("a key held down is one press however often it repeats") {
    Game game(listener);
    game.press("a");
    game.press("a", true);
    game.loop.frame(tick);
    game.press("a", true);
    game.press("a");  // a driver that does not mark repetitions
    game.loop.frame(tick);
    CHECK(game.new_output() == "+a");
}

TEST_CASE("a key pressed and released between two frames is reported") {
    Game game(listener);
    game.press("a");
    game.release("a");
    game.press("a");
    game.loop.frame(tick);
    CHECK(game.new_output() == "+a -a +a");
}

TEST_CASE("every key has a property of its own name") {
    Game game;
    for (const std::string_view name : key_names()) {
        game.press(std::string(name));
        INFO(name);
        CHECK(game.services.input.key(name));
        CHECK(game.get("input.keys[\"" + std::string(name) + "\"]").boolean());
    }
    game.press("no such key");
    CHECK_FALSE(game.services.input.key("no such key"));
}

TEST_CASE("watchers of a key are notified at the next barrier") {
    Game game(R"(input.keys:watch("space", function(new) print("space", new) end))");
    game.press("space");
    game.loop.frame(tick);
    CHECK(game.new_output() == "space\ttrue");
}

TEST_CASE("a script that sets a key has the effect of pressing it") {
    Game game(listener);
    game.runtime.run("input.keys.space = true", "test");
    game.loop.frame(tick);
    CHECK(game.new_output() == "+space");
}

TEST_CASE("a script that moves and presses the mouse has the effect of the mouse") {
    Game game(listener);
    game.runtime.run("input.mouse.world = vec(2, 1); input.mouse.left = true", "test");
    game.loop.frame(tick);
    CHECK(game.new_output() == "to 2,1 720,360 +left 2,1 720,360");
    CHECK(game.get("input.mouse.screen").vec2() == Vec2(720, 360));
}

TEST_CASE("the mouse is known in world and screen units") {
    Game game(listener);
    game.mouse(EventKind::mouse_moved, 640, 400);
    CHECK(game.get("input.mouse.world").vec2() == Vec2(0, 0));
    game.mouse(EventKind::mouse_pressed, 680, 360, "left");
    CHECK(game.get("input.mouse.left").boolean());
    CHECK(game.get("input.mouse.world").vec2() == Vec2(1, 1));
    game.loop.frame(tick);
    CHECK(game.new_output() == "to 1,1 680,360 +left 1,1 680,360");
    game.set("view.center", Vec2(10, 0));
    CHECK(game.get("input.mouse.world").vec2() == Vec2(11, 1));
}

TEST_CASE("watchers of the mouse position in the world follow the view in a paused game") {
    Game game(R"(
        time.paused = true
        input.mouse:watch("world", function(new) print(new.x) end)
    )");
    game.mouse(EventKind::mouse_moved, 640, 400);
    game.loop.frame(tick);
    game.new_output();
    game.set("view.center", Vec2(10, 0));
    game.loop.frame(tick);
    CHECK(game.new_output() == "10.0");
}

TEST_CASE("several mouse moves between two presses are reported as one") {
    Game game(listener);
    for (int i = 0; i < 100; ++i)
        game.mouse(EventKind::mouse_moved, 640, 400 - static_cast<float>(i));
    game.mouse(EventKind::mouse_pressed, 640, 360, "left");
    game.mouse(EventKind::mouse_moved, 680, 360);
    game.loop.frame(tick);
    CHECK(game.new_output() == "to 0,1 640,360 +left 0,1 640,360 to 1,1 680,360");
    game.mouse(EventKind::mouse_released, 680, 360, "left");
    game.loop.frame(tick);
    CHECK(game.new_output() == "-left");
}

TEST_CASE("the wheel counts the notches turned in a frame") {
    Game game(listener);
    InputEvent notch = event(EventKind::wheel);
    notch.delta = 1;
    game.loop.handle(notch);
    game.loop.handle(notch);
    CHECK(game.get("input.mouse.wheel").number() == 2);
    game.loop.frame(tick);
    CHECK(game.new_output().find("wheel 1.0 wheel 1.0") != std::string::npos);
    CHECK(game.get("input.mouse.wheel").number() == 0);
}

TEST_CASE("a wheel turned by a script is reported in the next update like the mouse wheel") {
    Game game(std::string(listener) + R"(
        local todo = { 2, false, 1, false }
        function wheel(delta) print("wheel", delta, input.mouse.wheel) end
        function update()
            print(input.mouse.wheel)
            local more = table.remove(todo, 1)
            if more then input.mouse.wheel = input.mouse.wheel + more end
        end)");
    InputEvent notch = event(EventKind::wheel);
    notch.delta = 1;
    game.loop.handle(notch);
    game.loop.frame(tick);
    CHECK(game.new_output().ends_with("wheel\t1.0\t1.0 1.0"));
    game.loop.handle(notch);
    game.loop.frame(tick);
    CHECK(game.new_output().ends_with("wheel\t2.0\t3.0 wheel\t1.0\t3.0 3.0"));
    game.loop.frame(tick);
    CHECK(game.new_output() == "0.0");
    game.loop.frame(tick);
    CHECK(game.new_output() == "wheel\t1.0\t1.0 1.0");
    game.loop.frame(tick);
    CHECK(game.new_output() == "0.0");
}

TEST_CASE("control keys that the operating system reports as text produce no text") {
    Game game(listener);
    InputEvent text = event(EventKind::text);
    for (const char32_t c : {U'\b', U'\t', U'\r', U'\x1B', U'\x7F', U'\x85', U'a', U' ', U'\xA0'}) {
        text.character = c;
        game.loop.handle(text);
    }
    game.loop.frame(tick);
    CHECK(game.new_output() == "text a text   text \u00A0");
}

TEST_CASE("properties cannot be added to the input") {
    Game game;
    const auto [code, reported] = GENERATE(table<std::string, std::string>(
        {{"input.keys.ctrl = true", "(did you mean \"left_control\"?)"},
         {"input.keys.spcae = true", "(did you mean \"space\"?)"},
         {"input.mouse.wheels = 1", "(did you mean \"wheel\"?)"},
         {"input.gamepad_1.trigger = 1", "Gamepad has no property \"trigger\""},
         {"input.gamepad_1.button_17 = true", "none can be added to it"},
         {"input.shake = 1", "Input has no property \"shake\", and none can be added to it"}}));
    CHECK_FALSE(game.runtime.run(code, "test"));
    REQUIRE(game.errors.size() == 1);
    INFO(game.errors[0].message);
    CHECK(game.errors[0].message.find(reported) != std::string::npos);
}

TEST_CASE("losing the focus releases everything held") {
    Game game(listener);
    game.press("left");
    game.mouse(EventKind::mouse_pressed, 640, 400, "right");
    game.loop.frame(tick);
    game.new_output();
    game.loop.handle(event(EventKind::focus));
    game.loop.frame(tick);
    CHECK(game.new_output() == "-left -right focus false");
    CHECK_FALSE(game.get("input.keys.left").boolean());
    CHECK_FALSE(game.get("input.mouse.right").boolean());
}

TEST_CASE("typed text is reported as text") {
    Game game(listener);
    InputEvent typed = event(EventKind::text);
    for (const char32_t c : U"ä€😀") {
        if (c == 0) break;
        typed.character = c;
        game.loop.handle(typed);
    }
    game.loop.frame(tick);
    CHECK(game.new_output() == "text ä text € text 😀");
}

TEST_CASE("the view gets a new size of the window") {
    Game game(listener);
    InputEvent size = event(EventKind::resized);
    size.x = 1000;
    size.y = 500;
    game.loop.handle(size);
    game.loop.frame(tick);
    CHECK(game.new_output() == "resized 1000 500");
    CHECK(game.get("view.screen").vec2() == Vec2(1000, 500));
    CHECK(game.get("view.width").number() == 40);
}

TEST_CASE("closing is reported to the game and to the loop") {
    Game game(listener);
    game.loop.handle(event(EventKind::closing));
    CHECK(game.loop.closing());
    game.loop.frame(tick);
    CHECK(game.new_output() == "closing");
}

TEST_CASE("an event consumed by a layer does not reach the game") {
    Game game(listener);
    Curtain curtain;
    game.loop.add(curtain);
    game.press("a");
    game.mouse(EventKind::mouse_pressed, 1, 1, "left");
    game.mouse(EventKind::mouse_moved, 640, 400);
    game.loop.frame(tick);
    CHECK(game.new_output() == "");
    CHECK_FALSE(game.get("input.keys.a").boolean());
    CHECK_FALSE(game.get("input.mouse.left").boolean());
    CHECK(game.get("input.mouse.screen").vec2() ==
          Vec2(640, 400));  // the property is updated all the same
    CHECK(curtain.seen.size() == 3);
}

TEST_CASE("a key held when a layer opens is released for the game when it is released") {
    Game game(listener);
    Curtain curtain;
    curtain.on = false;
    game.loop.add(curtain);
    game.press("a");
    game.mouse(EventKind::mouse_pressed, 640, 400, "left");
    game.loop.frame(tick);
    game.new_output();
    curtain.on = true;
    game.mouse(EventKind::mouse_moved, 680, 400);  // the drag continues
    game.release("a");
    game.mouse(EventKind::mouse_released, 680, 400, "left");
    game.mouse(EventKind::mouse_moved, 690, 400);
    game.loop.frame(tick);
    CHECK(game.new_output() == "to 1,0 680,400 -a -left");
}

TEST_CASE("the layer added last gets events first") {
    Game game(listener);
    Curtain below, above;
    game.loop.add(below);
    game.loop.add(above);
    game.press("a");
    CHECK(above.seen.size() == 1);
    CHECK(below.seen.empty());
    above.on = false;
    game.press("b");
    CHECK(below.seen.size() == 1);
}

TEST_CASE("gamepads are properties") {
    Game game(listener);
    CHECK_FALSE(game.get("input.gamepad_2.connected").boolean());
    InputEvent axis = event(EventKind::gamepad_axis);
    axis.gamepad = 2;
    axis.name = "left_y";
    axis.delta = 0.5f;
    game.loop.handle(axis);
    InputEvent button = event(EventKind::gamepad_pressed);
    button.gamepad = 2;
    button.name = "3";
    game.loop.handle(button);
    game.loop.frame(tick);
    CHECK(game.new_output() == "pad 2 left_y 0.5 pad 2 +3 pad 2 +x");
    CHECK(game.get("input.gamepad_2.left").vec2() == Vec2(0, 0.5));
    CHECK(game.get("input.gamepad_2.connected").boolean());
    CHECK(game.get("input.gamepad_2.button_3").boolean());
    CHECK_FALSE(game.get("input.gamepad_1.button_3").boolean());
    game.runtime.run("print(input.gamepads[2].left.y)", "test");
    CHECK(game.new_output() == "0.5");
}

TEST_CASE("a script that moves a stick or pulls a trigger has the effect of the gamepad") {
    Game game(listener);
    game.runtime.run("input.gamepad_1.left = vec(0.5, -1)", "test");
    game.loop.frame(tick);
    CHECK(game.new_output() == "pad 1 left_x 0.5 pad 1 left_y -1.0");
    game.runtime.run("input.gamepads[3].right.y = 0.25 input.gamepad_3.pad = vec(1, 0)", "test");
    game.loop.frame(tick);
    CHECK(game.new_output() == "pad 3 right_y 0.25 pad 3 pad_x 1.0 pad 3 +dpad_right");
    game.runtime.run("input.gamepad_4.left_trigger = 1 input.gamepad_4.right_trigger = 0.5",
                     "test");
    game.loop.frame(tick);
    CHECK(game.new_output() == "pad 4 left_trigger 1.0 pad 4 right_trigger 0.5");
    game.runtime.run("input.gamepad_1.left = vec(0.5, -1) input.gamepad_4.left_trigger = 1",
                     "test");
    game.loop.frame(tick);
    CHECK(game.new_output() == "");  // the sticks are in these positions already
}

TEST_CASE("every axis of a gamepad has the same name as an event and as a callback") {
    Game game(listener);
    for (const std::string name : {"left_x", "left_y", "right_x", "right_y", "pad_x", "pad_y"}) {
        InputEvent axis = event(EventKind::gamepad_axis);
        axis.gamepad = 1;
        axis.name = name;
        axis.delta = -0.5f;
        game.loop.handle(axis);
        game.loop.frame(tick);
        CHECK(game.new_output() == "pad 1 " + name + " -0.5");
        const Vec2 stick = game.get("input.gamepad_1." + name.substr(0, name.size() - 2)).vec2();
        CHECK(stick[name.back() == 'x' ? 0 : 1] == -0.5);
    }
    for (const std::string name : {"left_trigger", "right_trigger"}) {
        InputEvent axis = event(EventKind::gamepad_axis);
        axis.gamepad = 1;
        axis.name = name;
        axis.delta = 0;  // the device reports values from -1 to 1
        game.loop.handle(axis);
        game.loop.frame(tick);
        CHECK(game.new_output() == "pad 1 " + name + " 0.5");
        CHECK(game.get("input.gamepad_1." + name).number() == 0.5);
    }
}

TEST_CASE("a value impossible for a gamepad is refused and not reported") {
    Game game(listener);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK_THROWS_WITH(game.set("input.gamepad_1.left", Vec2(2, 0)), contains("gamepad_1.left"));
    CHECK_THROWS(game.set("input.gamepad_1.left", Vec2(nan, 0)));
    CHECK_THROWS(game.set("input.gamepad_1.left_trigger", -0.5));
    CHECK_THROWS(game.set("input.gamepad_1.button_17", true));
    CHECK_THROWS_WITH(game.set("input.gamepad_5.left", Vec2(1, 0)), contains("gamepad_"));
    CHECK_THROWS(game.set("input.mouse.world", Vec2(1e308, 0)));
    InputEvent wrong = event(EventKind::gamepad_axis);
    wrong.gamepad = 9;
    wrong.name = "left_x";
    wrong.delta = 1;
    game.loop.handle(wrong);
    wrong.gamepad = 1;
    wrong.name = "left_z";
    game.loop.handle(wrong);
    wrong.name = "left_x";
    wrong.delta = std::numeric_limits<float>::quiet_NaN();
    game.loop.handle(wrong);
    game.loop.frame(tick);
    CHECK(game.new_output() == "");
    CHECK(game.get("input.gamepad_1.left").vec2() == Vec2(0, 0));
}

TEST_CASE("unplugging a gamepad releases its held buttons") {
    Game game(listener);
    game.runtime.run("input.gamepad_2.left = vec(1, 0) input.gamepad_2.button_3 = true", "test");
    game.loop.frame(tick);
    game.new_output();
    InputEvent gone = event(EventKind::gamepad_disconnected);
    gone.gamepad = 2;
    SECTION("by the player") {
        InputEvent here = event(EventKind::gamepad_connected);
        here.gamepad = 2;
        game.loop.handle(here);
        game.loop.handle(gone);
    }
    SECTION("by a script") {
        game.runtime.run("input.gamepad_2.connected = true input.gamepad_2.connected = false",
                         "test");
    }
    game.loop.frame(tick);
    CHECK(game.new_output() == "pad 2 left_x 0.0 pad 2 -3 pad 2 -x");
    CHECK_FALSE(game.get("input.gamepad_2.connected").boolean());
    CHECK_FALSE(game.get("input.gamepad_2.button_3").boolean());
}

TEST_CASE("going back in time does not press keys again") {
    Game game(listener);
    game.loop.frame(tick);
    game.press("a");
    game.loop.frame(tick);
    game.release("a");
    for (int i = 0; i < 30; ++i) game.loop.frame(tick);
    game.new_output();
    game.runtime.run("input.keys.b = true rewind(0.2)", "test");
    for (int i = 0; i < 3; ++i) game.loop.frame(tick);
    CHECK(game.new_output() == "+b");
    CHECK(game.get("input.keys.b").boolean());
    CHECK_FALSE(game.get("input.keys.a").boolean());
}

TEST_CASE("a callback that raises an error ends the delivery of events in the frame") {
    Game game("function key_pressed(key) print(key) error('wrong') end");
    game.press("a");
    game.press("b");
    game.loop.frame(tick);
    CHECK(game.new_output() == "a");
    CHECK(game.errors.size() == 1);
}

TEST_CASE("the error screen keeps input from the game and handles its own keys") {
    Game game(listener);
    int reloads = 0, resumes = 0;
    std::string copied;
    ErrorScreen screen({.reload = [&] { ++reloads; },
                        .go_on = [&] { ++resumes; },
                        .copy = [&](const std::string& text) { copied = text; }});
    game.loop.add(screen);
    game.press("r");
    CHECK(reloads == 0);  // there is no error, so the game gets the key
    game.loop.frame(tick);
    CHECK(game.new_output() == "+r");
    game.release("r");

    script::ScriptError error;
    error.message = "main.lua:3: world.bal: no such name";
    error.file = "main.lua";
    error.line = 3;
    error.source_line = "world.bal.mass = 2";
    error.traceback = "main.lua:3: in main chunk";
    screen.show(error);
    error.message = "another";
    screen.show(error);
    CHECK(screen.error()->message == "main.lua:3: world.bal: no such name");
    game.press("c");
    CHECK(copied.find("world.bal.mass = 2") != std::string::npos);
    game.press("r");
    CHECK(reloads == 1);
    game.press("escape");
    CHECK(resumes == 1);
    CHECK_FALSE(screen.visible());
    game.loop.frame(tick);
    CHECK(game.new_output() == "-r");
}

}  // namespace fettle::app
