// Presses of keys and buttons that are released before a step has seen them.

#include <catch.h>

#include "game.h"

namespace fettle::app {

namespace {

constexpr std::string_view key_listener = R"(
    function key_pressed(key) print("+" .. key) end
    function key_released(key) print("-" .. key) end
    function focus(gained) print("focus " .. tostring(gained)) end
)";

}  // namespace

TEST_CASE("a press that is shorter than a frame is down in its callback and in one step") {
    Game game(R"(
        local function report(what)
            print(what .. time.step, input.keys.a and input.mouse.left and input.gamepad_1.button_2)
        end
        function key_pressed() report("press ") end
        function key_released() report("release ") end
        function mouse_released(button, at, screen) print(screen, input.mouse.screen) end
        function step() report("step ") end
    )");
    const auto pad = [&](EventKind kind) {
        InputEvent event;
        event.kind = kind;
        event.name = "2";
        event.gamepad = 1;
        game.loop.handle(event);
    };
    game.press("a");
    game.mouse(EventKind::mouse_pressed, 680, 360, "left");
    pad(EventKind::gamepad_pressed);
    game.release("a");
    game.mouse(EventKind::mouse_released, 680, 360, "left");
    pad(EventKind::gamepad_released);
    game.mouse(EventKind::mouse_moved, 700, 400);
    game.loop.frame(tick / 4);  // a frame without a step
    CHECK(game.new_output() == "press 0\ttrue");
    game.loop.frame(tick);
    CHECK(game.new_output() == "step 1\ttrue");
    game.loop.frame(tick);
    CHECK(game.new_output() == "release 1\tfalse vec(680, 360)\tvec(700, 400) step 2\tfalse");
}

TEST_CASE("a press that is shorter than a frame of a paused game ends with the frame") {
    Game game(key_listener);
    game.set("time.paused", true);
    game.press("a");
    game.release("a");
    game.loop.frame(tick);
    CHECK(game.new_output() == "+a");
    game.loop.frame(tick);
    CHECK(game.new_output() == "-a");
}

TEST_CASE("in slow motion a key that is released waits for no step") {
    Game game(key_listener);
    game.set("time.scale", 1e-3);
    game.press("a");
    game.release("a");
    for (int i = 0; i < 10; ++i) {
        game.loop.frame(tick);
        CHECK(game.new_output() == (i == 0 ? "+a" : ""));
        CHECK(game.get("input.keys.a").boolean() == (i < 9));
    }
    game.loop.frame(tick);
    CHECK(game.new_output() == "-a");
}

TEST_CASE("the loss of the focus ends a press that is shorter than a frame once") {
    Game game(key_listener);
    game.press("a");
    game.release("a");
    InputEvent focus;
    focus.kind = EventKind::focus;
    game.loop.handle(focus);
    for (int i = 0; i < 3; ++i) game.loop.frame(tick);
    CHECK(game.new_output() == "+a -a focus false");
}

}  // namespace fettle::app
