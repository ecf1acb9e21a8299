// Settings of the player when time jumps: a volume or a key that the player has chosen stays, and
// what the game writes into the same properties is state.

#include "screen.h"

namespace preference_test {

using namespace fettle::interface::test;

namespace {

const char* const settings = R"(
    input.actions.jump = { "space" }
    game.volume = Slider { bind = "audio.volume", size = vec(200, 20) }
    game.music = Slider { bind = "audio.buses.music.volume", offset = vec(0, 100), size = vec(200, 20) }
    game.keys = Button { bind = "input.actions.jump", offset = vec(0, 200) }
    game.level = Slider { bind = "game.difficulty", offset = vec(0, 300), max = 9 }
    game.difficulty = 1
)";

/// Drags the slider to its left end, which is 0.
void lower(Screen& s, const std::string& slider) {
    s.click(s.get(slider + ".screen_position").vec2() + Vec2(1, 10));
}

std::string keys(const Screen& s) {
    return s.get("input.actions.jump").list().at(0).text();
}

}  // namespace

TEST_CASE("a rewind leaves the settings of the player and takes the rest back") {
    Screen s(settings);
    s.turn(10);
    lower(s, "volume");
    s.click("keys");
    s.tap("j");
    s.set("level.value", Value(5));
    s.run("world_speed = 3  audio.max_voices = 7  audio.buses.music.volume = 0.25");
    s.turn();
    REQUIRE(s.get("audio.volume").number() == 0);
    REQUIRE(keys(s) == "j");
    REQUIRE(s.get("game.difficulty").as_double() == 5);

    s.run("time:go_to(5)");
    s.turn(2);
    CHECK(s.get("audio.volume").number() == 0);
    CHECK(s.get("volume.value").number() == 0);
    CHECK(keys(s) == "j");
    CHECK(s.get("game.difficulty").as_double() == 1);
    CHECK(s.get("audio.max_voices").integer() == 64);
    CHECK(s.get("audio.buses.music.volume").number() == 1);
    s.tap("space");
    s.set("input.keys.j", true);
    s.turn();
    CHECK(s.get("input.jump.held").boolean());
    CHECK(s.problems.empty());
}

TEST_CASE("a rewind within a step has the settings of the player before the next picture") {
    Screen s(settings);
    s.turn(10);
    lower(s, "volume");
    s.run("function step() if time.step == 30 then time:go_to(5) end end");
    while (s.services.clock.step < 29) s.turn();
    s.turn();
    CHECK(s.services.clock.step == 5);
    CHECK(s.get("audio.volume").number() == 0);
    CHECK(s.problems.empty());
}

TEST_CASE("a write of the game over a setting of the player is state") {
    Screen s(settings);
    s.turn(5);
    lower(s, "music");
    s.turn(5);
    const auto before = s.services.clock.step;
    s.run("audio.buses.music.volume = 0.5");  // the game, for a while
    s.turn(5);
    const auto within = s.services.clock.step;
    s.run("audio.buses.music.volume = 0");
    s.turn(5);
    s.loop.timeline().go_to(within);
    s.turn();
    CHECK(s.get("audio.buses.music.volume").number() == 0.5);
    s.loop.timeline().go_to(before);
    s.turn();
    CHECK(s.get("audio.buses.music.volume").number() == 0);
}

TEST_CASE("settings stay at each of several moments and on the way back") {
    Screen s(settings);
    s.turn(20);
    lower(s, "volume");
    s.turn(20);
    const auto newest = s.services.clock.step;
    const std::uint64_t hash = s.loop.hash();
    for (const int step : {3, 30, 2, 10}) {
        s.run("time.paused = true");
        s.loop.timeline().go_to(step);
        s.turn();
        CHECK(s.get("audio.volume").number() == 0);
        CHECK(s.get("volume.value").number() == 0);
    }
    s.run("time.paused = false");
    s.loop.timeline().go_to(newest);
    CHECK(s.loop.hash() == hash);
}

TEST_CASE("a snapshot keeps no setting that the player changes later") {
    Screen s(settings);
    s.run("before = snapshot()");
    s.turn(2);
    lower(s, "volume");
    s.run("restore(before)");
    s.turn(2);
    CHECK(s.get("audio.volume").number() == 0);
    CHECK(s.get("volume.value").number() == 0);
}

TEST_CASE("a game prefers a value for the player and ends that") {
    Screen s(settings);
    s.turn(5);
    s.run("interface:prefer('game.difficulty', 4)");
    s.turn(5);
    s.run("time:go_to(3)");
    s.turn(2);
    CHECK(s.get("game.difficulty").as_double() == 4);
    CHECK(s.get("level.value").number() == 4);
    s.run("interface:prefer('game.difficulty')");
    s.turn();
    s.run("game.difficulty = 6");
    s.run("time:go_to(2)");
    s.turn(2);
    CHECK(s.get("game.difficulty").as_double() == 1);
}

TEST_CASE("a property that cannot be preferred is refused with the nearest name") {
    Screen s(settings);
    const auto refused = [&](const char* chunk, const char* expected) {
        INFO(chunk);
        CHECK_FALSE(s.runtime.run(chunk, "test"));
        REQUIRE_FALSE(s.errors.empty());
        INFO(s.errors.back());
        CHECK(s.errors.back().find(expected) != std::string::npos);
        s.loop.resume();
    };
    refused("interface:prefer('audio.volum', 1)", "volume");
    refused("interface:prefer('audio', 1)", "expected the path of a property");
    refused("interface:prefer('audio.volume', 'loud')", "audio.volume");
    refused("interface:prefer('audio.volume', 9e9)", "audio.volume");
    CHECK(s.get("audio.volume").number() == 1);
}

TEST_CASE("settings of an earlier run wait for their property") {
    Screen s;
    std::vector<std::string> kept;
    s.interface.on_preference([&](const std::string& path, const Value& value) {
        kept.push_back(path + " = " + s.tree.text(value));
    });
    s.interface.begin_with("audio.volume", Value(0.25));
    s.interface.begin_with("audio.buses.speech.volume", Value(0.5));
    s.interface.begin_with("audio.buses.music.volume", Value("loud"));
    s.turn(2);
    CHECK(s.get("audio.volume").number() == 0.25);
    CHECK(s.get("audio.buses.music.volume").number() == 1);
    REQUIRE(s.problems.size() == 1);
    CHECK(s.problems[0].find("audio.buses.music.volume") != std::string::npos);
    s.run("audio.buses.speech = Bus {}");
    s.turn();
    CHECK(s.get("audio.buses.speech.volume").number() == 0.5);
    CHECK(kept.empty());
    s.run("interface:prefer('audio.volume', 0.75)");
    REQUIRE(kept.size() == 1);
    CHECK(kept[0] == "audio.volume = 0.75");
}

TEST_CASE("a setting of an earlier run whose path leads to no property is void") {
    Screen s;
    s.interface.begin_with("audio", Value(1));
    s.interface.begin_with("game.x.y", Value(1));
    s.run("game.spot = vec(1, 2)");
    s.interface.begin_with("game.spot.x", Value(5));
    s.turn(2);
    REQUIRE(s.problems.size() == 2);
    CHECK(s.problems[0].find("expected the path of a property") != std::string::npos);
    CHECK(s.get("game.spot").vec2() == Vec2(1, 2));
}

}  // namespace preference_test
