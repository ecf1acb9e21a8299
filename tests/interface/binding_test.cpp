// Widgets bound to properties.

#include "screen.h"

namespace binding_test {

using namespace fettle::interface::test;

TEST_CASE("a bound slider and its property have one value") {
    Screen s("game.s = Slider { bind = 'audio.volume' }");
    CHECK(s.get("s.value").number() == 1);
    s.set("audio.volume", Value(0.25));
    s.turn();
    CHECK(s.get("s.value").number() == 0.25);
    s.set("s.value", Value(0.5));
    s.turn();
    CHECK(s.get("audio.volume").number() == 0.5);
    const Vec2 corner = s.get("s.screen_position").vec2();
    s.click(corner + Vec2(1, 10));
    CHECK(s.get("audio.volume").number() == 0);
    CHECK(s.problems.empty());
}

TEST_CASE("a bound widget has the value of its property as soon as it has a parent") {
    Screen s("game.level, game.lit = 3, true");
    s.set("audio.volume", Value(0.25));
    s.run(R"(
        game.s = Slider { bind = "audio.volume" }
        game.r = Row { Toggle { bind = "game.lit" }, Label { bind = "game.level" } }
        game.later = Slider { bind = "game.none" }
        assert(game.s.value == 0.25 and game.r.toggle.value and game.r.label.text == "3"))");
    s.turn();
    CHECK(s.get("s.value").number() == 0.25);
    CHECK(s.get("audio.volume").number() == 0.25);
}

TEST_CASE("the range of a bound slider is that of the property unless it has its own") {
    Screen s(
        "game.s = Slider { bind = 'input.dead_zone' }  game.i = Slider { offset = vec(0, 100), "
        "bind = 'time.max_steps', min = 1, max = 9 }");
    s.click(s.get("s.screen_position").vec2() + Vec2(219, 10));
    const auto& range = s.tree.property(s.at("input"), "dead_zone").range;
    CHECK(s.get("input.dead_zone").number() == Approx(range.max));
    s.run("game.s = nil");
    s.click(s.get("i.screen_position").vec2() + Vec2(121, 10));
    CHECK(s.get("time.max_steps").integer() == 5);
    CHECK(s.get("i.value").number() == 5);
}

TEST_CASE("toggles text fields lists and labels are bound") {
    Screen s(R"(
        game.player, game.level, game.weight = "ann", 3, 0.5
        game.t = Toggle { bind = "view.show.grid" }
        game.n = TextField { bind = "game.player", offset = vec(0, 100) }
        game.w = TextField { bind = "game.weight", offset = vec(0, 200) }
        game.f = List { bind = "view.fit", offset = vec(0, 300) }
        game.l = Label { bind = "game.level" })");
    s.click("t");
    CHECK(s.get("view.show.grid").boolean());
    s.set("view.show.grid", false);
    s.turn();
    CHECK_FALSE(s.get("t.value").boolean());
    s.click("n");
    s.tap("end");
    s.type(U"a");
    CHECK(s.get("game.player").text() == "anna");
    s.click("w");
    s.tap("end");
    s.type(U"2");
    CHECK(s.get("game.weight").number() == 0.52);
    s.type(U"x");  // no number
    CHECK(s.get("game.weight").number() == 0.52);
    CHECK(s.get("w.text").text() == "0.52x");
    s.click(Vec2(1200, 700));
    s.turn();
    CHECK(s.get("w.text").text() == "0.52");
    CHECK(s.get("f.items").list().size() == 3);
    CHECK(s.get("f.selected").integer() == 1);
    s.set("f.selected", Value(2));
    s.turn();
    CHECK(s.get("view.fit").text() == "letterbox");
    s.set("game.level", Value(4));
    s.turn();
    CHECK(s.get("l.text").text() == "4");
    CHECK(s.problems.empty());
}

TEST_CASE("a button that is bound to an action shows all of its keys") {
    Screen s(R"(
        input.actions.walk = { { "a", "d", "s", "w" }, "gamepad.left", "left_shift" }
        game.keys = Button { bind = "input.actions.walk" }
        game.one = Button { bind = "input.actions.walk[1][2]" }
    )");
    CHECK(s.get("game.keys.text").text() == "a d s w, gamepad left, left shift");
    CHECK(s.get("game.one.text").text() == "d");
}

TEST_CASE("an invalid bind is reported once with the nearest name") {
    Screen s("game.s = Slider { bind = 'audio.volum' }");
    s.turn(3);
    REQUIRE(s.problems.size() == 1);
    CHECK(s.problems[0].find("s.bind") == 0);
    CHECK(s.problems[0].find("volume") != std::string::npos);
    s.set("s.bind", Value("view"));
    s.turn(2);
    REQUIRE(s.problems.size() == 2);
    s.set("s.bind", Value("view.show.grid"));
    s.turn(2);
    REQUIRE(s.problems.size() == 3);
    CHECK(s.problems[2].find("expected a number") != std::string::npos);
    s.set("s.bind", Value("audio.volume"));
    s.turn();
    CHECK(s.get("s.value").number() == 1);
    CHECK(s.problems.size() == 3);
}

TEST_CASE("a value that the property refuses is put back") {
    Screen s("game.s = Slider { bind = 'audio.volume', max = 1000 }");
    s.set("s.value", Value(900.0));
    s.turn();
    const double volume = s.get("audio.volume").number();
    s.turn();
    CHECK(s.get("s.value").number() == volume);
    CHECK(s.problems.size() == 1);
}

}  // namespace binding_test
