// The settings of a game in game.json, as the program uses them.

#include <catch.h>

#include "program.h"

namespace game_json_test {

using namespace program_test;

namespace {

/// Runs a game with this game.json and prints what the chunk says.
Outcome run_with(const Folder& folder, const std::string& settings, const std::string& chunk,
                 std::vector<std::string> more = {}) {
    folder.write("main.lua", "");
    folder.write("game.json", settings);
    std::vector<std::string> arguments = {
        "run", folder.write("main.lua", ""), "--headless", "--steps", "3", "--eval", chunk};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return fettle(folder, arguments);
}

}  // namespace

TEST_CASE("the window of a headless run has the size that game.json sets") {
    const Folder folder;
    const Outcome run = run_with(
        folder,
        R"({"name": "Marbles", "window": {"size": [640, 480], "resizable": false, "vsync": false}})",
        "local w = view.window print(w.title, w.size, view.screen, w.fullscreen, w.resizable, "
        "w.vsync, w.cursor_visible)");
    INFO(run.err);
    CHECK(run.status == 0);
    CHECK(run.out == "Marbles\tvec(640, 480)\tvec(640, 480)\tfalse\tfalse\tfalse\ttrue\n");
}

TEST_CASE("the size of the window is that of the screen unless it is fullscreen") {
    const Folder folder;
    const Outcome run = run_with(
        folder, "{}",
        "view.window.size = vec(800, 600) print(view.screen) view.window.fullscreen = true "
        "view.window.size = vec(400, 300) print(view.screen) print(pcall(function() "
        "view.window.size = vec(0, 3) end)) print(pcall(function() view.window.size = vec(1.5, 3) "
        "end))");
    INFO(run.out << run.err);
    CHECK(run.status == 0);
    CHECK(contains(run.out, "vec(800, 600)\nvec(800, 600)\nfalse"));
    CHECK(contains(run.out, "pixels are whole numbers"));
}

TEST_CASE("the seed of game.json is that of random unless the command line has one") {
    const Folder folder;
    const std::string chunk = "print(random())";
    const Outcome seven = run_with(folder, R"({"seed": 7})", chunk);
    const Outcome none = run_with(folder, "{}", chunk);
    CHECK(seven.out != none.out);
    CHECK(run_with(folder, "{}", chunk, {"--seed", "7"}).out == seven.out);
    CHECK(run_with(folder, R"({"seed": 7})", chunk, {"--seed", "0"}).out == none.out);
    // Only a run in a window has other numbers each time: tests/window/test_pictures_test.cpp.
    CHECK(run_with(folder, R"({"seed": "random"})", chunk).out == none.out);
    CHECK(run_with(folder, R"({"seed": "random"})", chunk, {"--seed", "7"}).out == seven.out);
}

TEST_CASE("game.json sets whether images are smooth unless an instance sets it") {
    const Folder folder;
    const std::string chunk =
        "Coin = class('Coin', Sprite) {} print(Sprite {}.smooth, Coin {}.smooth, Emitter "
        "{}.smooth, Tilemap {}.smooth, Sprite { smooth = true }.smooth)";
    CHECK(run_with(folder, R"({"smooth": false})", chunk).out ==
          "false\tfalse\tfalse\tfalse\ttrue\n");
    CHECK(run_with(folder, R"({"smooth": true})", chunk).out == "true\ttrue\ttrue\ttrue\ttrue\n");
    CHECK(run_with(folder, "{}", chunk).out == "true\ttrue\ttrue\tfalse\ttrue\n");
}

TEST_CASE("a mistake in game.json ends the program with its place") {
    const Folder folder;
    const Outcome run = run_with(folder, "{\n  \"consle\": \"off\"\n}", "print(1)");
    CHECK(run.status == 3);
    CHECK(contains(run.err,
                   "game.json:2:3: consle: there is no such setting (did you mean "
                   "\"console\"?)"));
    CHECK(run.out.empty());
    CHECK(contains(run_with(folder, R"({"title": "A"})", "print(1)").err,
                   "game.json:1:11: title: belongs into \"window\": { }"));
    const Outcome icon = run_with(folder, R"({"icon": "hreo.png"})", "print(1)");
    CHECK(icon.status == 3);
    CHECK(contains(icon.err, "game.json:1:10: icon: there is no file \"hreo.png\""));
}

TEST_CASE("a game without a console refuses commands for it") {
    const Folder folder;
    const std::vector<std::string> command = {"--console", "2:1 + 1"};
    CHECK(contains(run_with(folder, "{}", "local a", command).out, "2"));
    CHECK(contains(run_with(folder, R"({"console": "developer"})", "local a", command).out, "2"));
    const Outcome off = run_with(folder, R"({"console": "off"})", "local a", command);
    CHECK(off.status == 3);
    CHECK(contains(off.err, "this game has no console"));
}

TEST_CASE("saves of a game with an id are found from any folder of the game") {
    const Folder folder;
    const std::string id = R"({"id": "org.example.saved"})";
    folder.write("one/game.json", id);
    folder.write("two/game.json", id);
    folder.write("three/game.json", "{}");
    const auto run = [&](const std::string& name, const std::string& chunk) {
        return fettle(folder, {"run", folder.write(name + "/main.lua", ""), "--headless", "--steps",
                               "3", "--at", chunk});
    };
    REQUIRE(run("one", "2:save_game('a')").status == 0);
    CHECK(run("two", "2:print(#saves(), saves()[1].problem)").out == "1\tnil\n");
    CHECK(run("three", "2:print(#saves())").out == "0\n");
}

TEST_CASE("a replay has the settings of the recorded run and notices others") {
    const Folder folder;
    const std::string recording = (folder / "a.recording").string();
    REQUIRE(run_with(folder, R"({"seed": 5, "name": "Marbles"})",
                     "game.o = Object {} game.o.r = random() game.o.t = view.window.title",
                     {"--record", recording})
                .status == 0);
    const Outcome same = fettle(folder, {"run", "--replay", recording, "--headless"});
    INFO(same.err);
    CHECK(same.status == 0);
    folder.write("game.json", R"({"seed": 6, "name": "Marbles"})");
    const Outcome other = fettle(folder, {"run", "--replay", recording, "--headless"});
    CHECK(other.status == 3);
    CHECK(contains(other.err, "game.json differs"));
}

}  // namespace game_json_test
