// Buttons of gamepads by name, and mappings.

#include <catch.h>

#include <string>

#include "game.h"

namespace gamepad_test {

using namespace fettle::app;
using fettle::property::Vec2;

namespace {

constexpr std::string_view listener = R"(
    function gamepad_pressed(gamepad, button) print("+" .. gamepad .. "." .. button) end
    function gamepad_released(gamepad, button) print("-" .. gamepad .. "." .. button) end
    function gamepad_axis(gamepad, axis, value) print(axis .. "=" .. value) end
)";

void button(Game& game, const std::string& name, bool down) {
    InputEvent event;
    event.kind = down ? EventKind::gamepad_pressed : EventKind::gamepad_released;
    event.name = name;
    event.gamepad = 1;
    game.loop.handle(event);
}

void axis(Game& game, const std::string& name, float value) {
    InputEvent event;
    event.kind = EventKind::gamepad_axis;
    event.name = name;
    event.delta = value;
    event.gamepad = 1;
    game.loop.handle(event);
}

void connect(Game& game, const std::string& device) {
    InputEvent event;
    event.kind = EventKind::gamepad_connected;
    event.name = device;
    event.gamepad = 1;
    game.loop.handle(event);
}

std::string refusal(Game& game, const std::string& mapping) {
    game.errors.clear();
    game.runtime.run("input.gamepad_1.mapping = '" + mapping + "'", "test");
    return game.errors.empty() ? "" : game.errors.front().message;
}

}  // namespace

TEST_CASE("a button has a number and a name") {
    Game game(listener);
    button(game, "5", true);
    CHECK(game.get("input.gamepad_1.left_shoulder").boolean());
    CHECK(game.get("input.gamepad_1.button_5").boolean());
    game.loop.frame(tick);
    CHECK(game.new_output() == "+1.5 +1.left_shoulder");
    button(game, "5", false);
    game.loop.frame(tick);
    CHECK(game.new_output() == "-1.5 -1.left_shoulder");
}

TEST_CASE("setting a button by name has the effect of pressing it") {
    Game game(listener);
    game.set("input.gamepad_1.start", true);
    CHECK(game.get("input.gamepad_1.button_8").boolean());
    game.loop.frame(tick);
    CHECK(game.new_output() == "+1.start +1.8");
    game.set("input.gamepad_1.button_8", false);
    CHECK_FALSE(game.get("input.gamepad_1.start").boolean());
    game.loop.frame(tick);
    CHECK(game.new_output() == "-1.8 -1.start");
}

TEST_CASE("the directional pad and its buttons have the same state") {
    Game game(listener);
    axis(game, "pad_y", 1);
    CHECK(game.get("input.gamepad_1.dpad_up").boolean());
    axis(game, "pad_y", -1);
    CHECK_FALSE(game.get("input.gamepad_1.dpad_up").boolean());
    CHECK(game.get("input.gamepad_1.dpad_down").boolean());
    game.loop.frame(tick);
    CHECK(game.new_output() == "pad_y=1.0 +1.dpad_up pad_y=-1.0 -1.dpad_up +1.dpad_down");
    axis(game, "pad_y", -0.0f);
    game.loop.frame(tick);
    CHECK(game.new_output() == "pad_y=0.0 -1.dpad_down");
    game.set("input.gamepad_1.dpad_down", false);
    CHECK(game.get("input.gamepad_1.pad").vec2() == Vec2(0, 0));
    game.set("input.gamepad_1.dpad_left", true);
    game.set("input.gamepad_1.dpad_right", true);
    CHECK(game.get("input.gamepad_1.pad").vec2() == Vec2(1, 0));
    CHECK_FALSE(game.get("input.gamepad_1.dpad_left").boolean());
}

TEST_CASE("an axis moves the stick or trigger of its name") {
    Game game;
    axis(game, "left_x", 0.5);
    axis(game, "left_y", 0.25);
    axis(game, "right_y", -1);
    axis(game, "right_trigger", -1);
    axis(game, "left_trigger", 1);
    CHECK(game.get("input.gamepad_1.left").vec2() == Vec2(0.5, 0.25));
    CHECK(game.get("input.gamepad_1.right").vec2() == Vec2(0, -1));
    CHECK(game.get("input.gamepad_1.right_trigger").number() == 0);
    CHECK(game.get("input.gamepad_1.left_trigger").number() == 1);
}

TEST_CASE("a mapping names the buttons and axes") {
    Game game;
    game.set("input.gamepad_1.mapping",
             "03000000de2800,Some Pad,a:b2,b:b1,righttrigger:b7,rightx:a2,righty:a5~,"
             "lefttrigger:+a3,dpup:-a4,misc1:b3,platform:Linux,");
    button(game, "3", true);
    CHECK(game.get("input.gamepad_1.a").boolean());
    CHECK_FALSE(game.get("input.gamepad_1.x").boolean());
    button(game, "8", true);
    CHECK(game.get("input.gamepad_1.right_trigger").number() == 1);
    axis(game, "left_trigger", 0.5);  // axis 2
    CHECK(game.get("input.gamepad_1.right").vec2() == Vec2(0.5, 0));
    axis(game, "right_trigger", 0.5);  // axis 5, which points down where it is not inverted
    CHECK(game.get("input.gamepad_1.right").vec2() == Vec2(0.5, 0.5));
    axis(game, "right_x", 0.75);  // axis 3
    CHECK(game.get("input.gamepad_1.left_trigger").number() == 0.75);
    axis(game, "right_x", -0.75);
    CHECK(game.get("input.gamepad_1.left_trigger").number() == 0);
    axis(game, "right_y", 1);  // axis 4: up, which the device reports as -1
    CHECK(game.get("input.gamepad_1.dpad_up").boolean());
    CHECK(game.get("input.gamepad_1.left").vec2() == Vec2(0, 0));
}

TEST_CASE("a changed mapping gives new names to buttons that are held") {
    Game game;
    button(game, "3", true);
    CHECK(game.get("input.gamepad_1.x").boolean());
    game.set("input.gamepad_1.mapping", "playstation");
    CHECK_FALSE(game.get("input.gamepad_1.x").boolean());
    CHECK(game.get("input.gamepad_1.y").boolean());
    CHECK(game.get("input.gamepad_1.button_3").boolean());
    game.loop.frame(1.0 / 60);
    button(game, "3", false);
    CHECK_FALSE(game.get("input.gamepad_1.y").boolean());
}

TEST_CASE("a known controller gets its mapping when it is connected") {
    Game game;
    connect(game, "054c:0ce6");
    CHECK(game.get("input.gamepad_1.mapping").text() == "playstation");
    connect(game, "057e:2009");
    CHECK(game.get("input.gamepad_1.mapping").text() == "switch_pro");
    connect(game, "1234:5678");
    CHECK(game.get("input.gamepad_1.mapping").text() == "xbox");
    game.set("input.gamepad_1.mapping", "a:b7");
    connect(game, "054c:0ce6");
    CHECK(game.get("input.gamepad_1.mapping").text() == "a:b7");
}

TEST_CASE("a mapping that is malformed is refused and changes nothing") {
    Game game;
    CHECK_THAT(refusal(game, "a:b0,leftsholder:b4"),
               contains("no part of a gamepad is called \"leftsholder\" (did you mean "
                        "\"leftshoulder\"?)"));
    for (const char* bad : {"a:b16", "a:c1", "a:", "a:h0.3", "a:b-1", "a:~", "a:+b1", "leftx:a8",
                            "a:b99999999999", "x:h1.1"})
        CHECK_THAT(refusal(game, bad), contains("is not an entry of a mapping"));
    CHECK_THAT(refusal(game, "playstatoin"), contains("did you mean \"playstation\"?"));
    CHECK_THAT(refusal(game, ""), contains("one entry at least"));
    CHECK_THAT(refusal(game, "0300,Name,"), contains("neither a known controller"));
    CHECK(game.get("input.gamepad_1.mapping").text() == "xbox");
}

TEST_CASE("a gamepad that is disconnected releases its named buttons") {
    Game game;
    game.set("input.gamepad_1.connected", true);
    game.set("input.gamepad_1.mapping", "a:b0");
    game.set("input.gamepad_1.y", true);
    game.set("input.gamepad_1.a", true);
    game.set("input.gamepad_1.connected", false);
    CHECK_FALSE(game.get("input.gamepad_1.y").boolean());
    CHECK_FALSE(game.get("input.gamepad_1.a").boolean());
}

}  // namespace gamepad_test
