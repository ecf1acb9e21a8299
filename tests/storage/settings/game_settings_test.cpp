// The file game.json, and the settings of a player.

#include <catch.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include <fettle/property/storage/game_files.h>
#include <fettle/property/storage/game_settings.h>
#include <fettle/property/storage/tweaks.h>

#include "game_folder.h"

namespace game_settings_test {

using namespace fettle::property;
using scene_test::GameFolder;

namespace {

GameSettings settings(const std::string& text) {
    return game_settings(text, "game.json", "1.4.2");
}

std::string problem(const std::string& text) {
    try {
        settings(text);
    } catch (const SceneError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("all settings of a game are read") {
    const GameSettings all = settings(R"({
        // a comment
        "name": "Marbles", "id": "org.example.marbles", "version": "1.0", "author": "A. Author",
        "icon": "icon.png", "fettle": "1.4", "seed": 7, "console": "developer", "smooth": false,
        "window": { "title": "Roll", "size": [640, 480], "fullscreen": true, "resizable": false,
                    "vsync": false }
    })");
    CHECK(all.name == "Marbles");
    CHECK(all.id == "org.example.marbles");
    CHECK(all.version == "1.0");
    CHECK(all.author == "A. Author");
    CHECK(all.icon == "icon.png");
    CHECK(all.fettle == "1.4");
    CHECK(all.seed == 7u);
    CHECK(all.smooth == false);
    CHECK(all.console == ConsoleUse::developer);
    CHECK(all.title() == "Roll");
    CHECK(all.window.size == Vec2(640, 480));
    CHECK(all.window.fullscreen == true);
    CHECK(all.window.resizable == false);
    CHECK(all.window.vsync == false);
}

TEST_CASE("missing settings of a game are empty") {
    const GameSettings none = settings("{}");
    CHECK(none.id.empty());
    CHECK(none.console == ConsoleUse::on);
    CHECK_FALSE(none.seed);
    CHECK_FALSE(none.random_seed);
    const GameSettings random = settings(R"({"seed": "random"})");
    CHECK(random.random_seed);
    CHECK_FALSE(random.seed);
    CHECK_FALSE(none.smooth);
    CHECK_FALSE(none.window.size);
    CHECK(settings(R"({"name": "Marbles"})").title() == "Marbles");
    const GameFolder folder;
    GameFiles files;
    CHECK(read_game_settings(files, folder.path(), "1.0").name.empty());
}

TEST_CASE("an unknown setting is an error with line and nearest name") {
    CHECK(problem("{\n  \"nmae\": \"x\"\n}") ==
          "game.json:2:3: nmae: there is no such setting (did you mean \"name\"?)");
    CHECK(problem(R"({"window": {"titel": "x"}})") ==
          "game.json:1:13: window.titel: there is no such setting (did you mean \"title\"?)");
    CHECK(problem(R"({"": 1})") == "game.json:1:2: an empty key: there is no such setting");
}

TEST_CASE("a setting of another type is an error with its place") {
    const auto [text, message] = GENERATE(table<std::string, std::string>({
        {R"({"name": 3})", "1:10: name: expected a text, found "},
        {R"({"window": []})", "window: expected an object with settings"},
        {R"({"window": {"vsync": "yes"}})", "window.vsync: expected true or false"},
        {R"({"window": {"size": [640]}})", "window.size: expected width and height"},
        {R"({"window": {"size": [640, 0]}})", "window.size: expected width and height"},
        {R"({"window": {"size": [640, 4.5]}})", "window.size: expected width and height"},
        {R"({"seed": -1})",
         "seed: expected a whole number that is not negative, or \"random\", found"},
        {R"({"seed": "rand"})", "seed: expected a whole number that is not negative, or"},
        {R"({"console": "onn"})", "console: expected \"on\", \"developer\" or \"off\""},
        {R"({"id": "../other"})", "id: expected an id of 1 to 100 letters"},
        {R"({"id": ""})", "id: expected an id of 1 to 100 letters"},
        {R"({"id": ")" + std::string(101, 'a') + R"("})", "id: expected an id of 1 to 100 letters"},
        {R"({"id": ".."})", "id: expected an id of 1 to 100 letters"},
        {R"({"fettle": "new"})", "fettle: expected a version"},
        {R"([])", "1:1: expected an object with settings"},
        {R"({"name": "a", "name": "b"})", "name"},
        {R"({"name": )", "game.json:1:"},
    }));
    INFO(text);
    CHECK_THAT(problem(text), contains(message));
}

TEST_CASE("a game that was written for a newer version is refused") {
    CHECK(problem(R"({"fettle": "1.4.2"})").empty());
    CHECK(problem(R"({"fettle": "1"})").empty());
    CHECK(problem(R"({"fettle": "0.9.12"})").empty());
    CHECK_THAT(problem(R"({"fettle": "1.10"})"),
               contains("written for Fettle 1.10, and this is Fettle 1.4.2"));
    CHECK_FALSE(problem(R"({"fettle": "1.4.3"})").empty());
}

TEST_CASE("the folder of a player belongs to the id of the game") {
    const GameFolder data;
    ::setenv("XDG_DATA_HOME", data.path().c_str(), 1);
    CHECK(player_folder("/games/a", "org.example.a") == player_folder("/b/c", "org.example.a"));
    CHECK(player_folder("/games/a", "org.example.a") == data.path() / "fettle/games/org.example.a");
    CHECK(player_folder("/games/a", "") == user_folder("/games/a"));
}

TEST_CASE("a game whose folder has the longest name has a folder of its own for a player") {
    const GameFolder data;
    ::setenv("XDG_DATA_HOME", data.path().c_str(), 1);
    const std::string longest(254, 'n');
    const std::filesystem::path a = player_folder(data.path() / (longest + "a"), "");
    const std::filesystem::path b = player_folder(data.path() / (longest + "b"), "");
    CHECK(a != b);
    write_player_settings(a, {.fullscreen = true});
    CHECK(read_player_settings(a).fullscreen == true);
    CHECK_FALSE(read_player_settings(b).fullscreen);
}

TEST_CASE("writing the settings of a player keeps settings that this version does not have") {
    const GameFolder folder;
    CHECK_FALSE(read_player_settings(folder.path() / "none").fullscreen);
    write_player_settings(folder.path() / "player", {.fullscreen = true});
    CHECK(read_player_settings(folder.path() / "player").fullscreen == true);
    std::ofstream(folder.path() / "player/settings.json") << R"({"volume": 0.5, "fullscreen": 3})";
    CHECK_FALSE(read_player_settings(folder.path() / "player").fullscreen);
    write_player_settings(folder.path() / "player", {.fullscreen = false});
    CHECK(read_player_settings(folder.path() / "player").fullscreen == false);
    std::ifstream in(folder.path() / "player/settings.json");
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    CHECK_THAT(text, contains("\"volume\": 0.5"));
    std::ofstream(folder.path() / "player/settings.json") << "{ damaged";
    CHECK_FALSE(read_player_settings(folder.path() / "player").fullscreen);
}

TEST_CASE("an icon is an image and its place is known") {
    CHECK(settings("{\n\"icon\": \"icon.png\"}").icon_at == "game.json:2:9");
    CHECK(problem(R"({"icon": "main.lua"})") ==
          "game.json:1:10: icon: expected an image (.png, .jpg, .jpeg, .bmp or .tga), found a text "
          "(\"main.lua\")");
    CHECK(problem(R"({"window": {"size": [1]}})") ==
          "game.json:1:21: window.size: expected width and height from 1 to 16384 pixels, as in "
          "[1280, 800], found an array of 1");
}

}  // namespace game_settings_test
