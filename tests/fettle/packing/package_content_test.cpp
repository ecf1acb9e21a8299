// `fettle package` checks what the game contains, and names what is changed.

#include <catch.h>

#include "program.h"

namespace package_content_test {

using namespace program_test;

namespace {

Outcome package(const Folder& folder, const std::string& option = "--file",
                const std::string& target = "out.fettle") {
    return fettle(folder,
                  {"package", (folder / "game").string(), option, (folder / target).string()});
}

}  // namespace

TEST_CASE("a scene that cannot be loaded is not packed") {
    const auto [scene, message] = GENERATE(table<std::string, std::string>({
        {R"({"fettle_scene": 1, "class": "Hero",})", "s.json:1:37: "},
        {R"({"fettle_scene": 1, "class": "Nope"})", "s.json:1:30: no class is called \"Nope\""},
        {R"({"fettle_scene": 1, "class": "Hero", "properties": {"mass": "abc"}})",
         "s.json:1:61: hero.mass: expected a number"},
        {R"({"fettle_scene": 1, "class": "Link", "properties": {"to": ".none"}})",
         "refers to \".none\", which does not exist"},
        {R"({"fettle_scene": 1, "class": "Hero", "properties": {"mass": {"is": "1 +"}}})",
         "s.json:1:"},
        {R"({"fettle_scene": 1, "class": "Hero", "properties": {"mass": 3}})", ""},
        {R"({"fettle_scene": 1, "class": "Later"})", ""},
    }));
    const Folder folder;
    folder.write("game/main.lua",
                 "Hero = class('Hero', Body) { } Link = class('Link', Object) { to = Object } "
                 "function later() class('Later', Object) { } end print('loading')");
    folder.write("game/s.json", scene);
    const Outcome made = package(folder);
    INFO(scene << made.out << made.err);
    CHECK(made.status == (message.empty() ? 0 : 3));
    CHECK(contains(made.err, message));
    CHECK_FALSE(contains(made.out, "loading"));
}

TEST_CASE("a debian package needs the libc of its libraries and shows the icon of the game") {
    if (std::system("command -v dpkg-deb >/dev/null") != 0) {
        WARN("dpkg-deb is not here: nothing is tested");
        return;
    }
    const Folder folder;
    folder.write("game/main.lua", "");
    folder.write("game/art/icon.bmp", "BM");
    folder.write("game/game.json", R"({"name": "Cave", "icon": "art/icon.bmp"})");
    const Outcome made = package(folder, "--deb", "cave.deb");
    INFO(made.err);
    REQUIRE(made.status == 0);
    const std::string deb = quoted((folder / "cave.deb").string());
    const auto read = [&](const std::string& command) {
        const std::string to = (folder / "read").string();
        CHECK(std::system((command + " >" + quoted(to)).c_str()) == 0);
        return folder.text("read");
    };
    CHECK(read("dpkg-deb -f " + deb + " Depends").starts_with("libc6 (>= 2."));
    CHECK(contains(
        read("dpkg-deb --fsys-tarfile " + deb + " | tar -xO ./usr/share/applications/cave.desktop"),
        "\nIcon=/usr/lib/cave/game/art/icon.bmp\n"));
}

TEST_CASE("a game with scenes that cannot be loaded itself is not packed") {
    const Folder folder;
    folder.write("game/main.lua", "error('no luck', 0)");
    folder.write("game/s.json", R"({"fettle_scene": 1, "class": "Object"})");
    const Outcome made = package(folder);
    INFO(made.err);
    CHECK(made.status == 3);
    CHECK(contains(made.err, "no luck"));
}

TEST_CASE("a template that a map names and that is missing is noticed") {
    const Folder folder;
    folder.write("game/main.lua", "");
    folder.write("game/level.tmj", R"({"layers": [{"objects": [{"template": "coin.tx"}]}]})");
    const Outcome made = package(folder);
    INFO(made.err);
    CHECK(made.status == 3);
    CHECK(contains(made.err, "level.tmj:1: \"coin.tx\": there is no such file"));
}

TEST_CASE("names and versions that a debian package cannot have are changed with a note") {
    const auto [settings, id, note] = GENERATE(table<std::string, std::string, std::string>({
        {R"({"name": "球", "id": "org.example.ball", "version": "1.0"})", "org-example-ball",
         "note: the files of \"球\" are called org-example-ball there"},
        {R"({"name": "fettle", "version": "1.0"})", "fettle-game", "are called fettle-game there"},
        {R"({"name": "Cave", "version": "1.0-beta_2"})", "cave",
         "note: the version \"1.0-beta_2\" is 1.0~beta.2 there"},
        {R"({"name": "Cave", "version": "1.0"})", "cave", ""},
    }));
    const Folder folder;
    folder.write("game/main.lua", "");
    folder.write("game/game.json", settings);
    const Outcome made = package(folder, "--linux", "made");
    INFO(made.out << made.err);
    CHECK(made.status == 0);
    CHECK(contains(made.out, ": " + id + " in it starts the game"));
    CHECK(contains(made.out, note));
    CHECK(contains(made.out, "note:") == !note.empty());
}

TEST_CASE("an archive with another compression names the method") {
    const Folder folder;
    // One file, main.lua, said to be compressed by method 12.
    const auto two = [](unsigned n) { return std::string{char(n & 255), char(n >> 8)}; };
    const auto four = [&](unsigned n) { return two(n & 65535) + two(n >> 16); };
    const std::string name = "main.lua", content = "BZh9";
    const std::string fields = two(20) + two(0) + two(12) + four(0) + four(0) +
                               four(unsigned(content.size())) + four(unsigned(content.size())) +
                               two(unsigned(name.size())) + two(0);
    const std::string local = "PK\x03\x04" + fields + name + content;
    const std::string central =
        "PK\x01\x02" + two(20) + fields + two(0) + two(0) + two(0) + four(0) + four(0) + name;
    folder.write("x.fettle", local + central + "PK\x05\x06" + two(0) + two(0) + two(1) + two(1) +
                                 four(unsigned(central.size())) + four(unsigned(local.size())) +
                                 two(0));
    const Outcome run =
        fettle(folder, {"run", (folder / "x.fettle").string(), "--headless", "--steps", "1"});
    INFO(run.err);
    CHECK(run.status == 3);
    CHECK(contains(run.err, "\"main.lua\" is compressed by bzip2, expected deflate"));
}

TEST_CASE("modules that are not there have their nearest name") {
    const Folder folder;
    std::filesystem::create_directories(folder / "game");
    std::filesystem::copy_file(FETTLE_TEST_MODULES "/weather.so", folder / "game/weather.so");
    std::filesystem::copy_file(FETTLE_TEST_MODULES "/same_class.so", folder / "game/sky.so");
    folder.write("game/main.lua", "");
    const auto [modules, message] = GENERATE(table<std::string, std::string>({
        {R"({"modules": ["./wether.so"]})",
         "wether.so: there is no such file (did you mean \"weather.so\"?)"},
        {R"({"modules": ["wether"]})", "(did you mean \"weather\"?)"},
        {R"({"modules": [""]})", "a module: expected a file or a name, got an empty text"},
        {R"({"modules": ["./weather.so", "./sky.so"]})",
         "there is a class \"Cloud\" already, in the module weather"},
    }));
    folder.write("game/modules.json", modules);
    const Outcome run =
        fettle(folder, {"run", (folder / "game").string(), "--headless", "--steps", "1"});
    INFO(run.err);
    CHECK(run.status != 0);
    CHECK(contains(run.err, message));
}

TEST_CASE("settings in a file of another case or behind a broken link are an error") {
    const Folder folder;
    folder.write("game/main.lua", "");
    const auto run = [&] {
        return fettle(folder, {"run", (folder / "game").string(), "--headless", "--steps", "1"});
    };
    folder.write("game/Game.json", "{}");
    const Outcome other = run();
    CHECK(other.status == 3);
    CHECK(contains(other.err, "Game.json: expected the name game.json, in lower case"));
    std::filesystem::remove(folder / "game/Game.json");
    std::filesystem::create_symlink("nowhere", folder / "game/game.json");
    const Outcome link = run();
    CHECK(link.status == 3);
    CHECK(contains(link.err, "game.json: this link leads nowhere"));
    std::filesystem::remove(folder / "game/game.json");
    folder.write("game/game.json", "{\n\"icon\": \"main.lua\"}");
    const Outcome icon = run();
    CHECK(icon.status == 3);
    CHECK(contains(icon.err,
                   "game.json:2:9: icon: expected an image (.png, .jpg, .jpeg, .bmp or .tga)"));
}

TEST_CASE("a packed game has the edits that were kept") {
    const Folder folder;
    folder.write("game/main.lua", "world.ball = Body { mass = 2 }");
    REQUIRE(fettle(folder, {"run", (folder / "game").string(), "--headless", "--steps", "3",
                            "--console", "1:world.ball.mass = 5", "--console", "2:keep('**')"})
                .status == 0);
    REQUIRE(std::filesystem::exists(folder / "game/main.tweaks.json"));
    const Outcome made = package(folder, "--file", "game.fettle");
    INFO(made.out << made.err);
    REQUIRE(made.status == 0);
    const Outcome run = fettle(folder, {"run", (folder / "game.fettle").string(), "--headless",
                                        "--steps", "3", "--at", "2:print(world.ball.mass)"});
    INFO(run.out << run.err);
    CHECK(contains(run.out, "5"));
}

TEST_CASE("a packed game of one file has the edits that were kept, which must be JSON") {
    const Folder folder;
    folder.write("solo.lua", "world.ball = Body { mass = 2 }");
    folder.write("solo.tweaks.json", R"({"fettle_tweaks": 1, "values": {"world.ball.mass": 5}})");
    const auto pack = [&] {
        return fettle(folder, {"package", (folder / "solo.lua").string(), "--file",
                               (folder / "solo.fettle").string()});
    };
    REQUIRE(pack().status == 0);
    const Outcome run = fettle(folder, {"run", (folder / "solo.fettle").string(), "--headless",
                                        "--steps", "3", "--at", "2:print(world.ball.mass)"});
    INFO(run.out << run.err);
    CHECK(contains(run.out, "5"));
    folder.write("solo.tweaks.json", R"({"fettle_tweaks": 1, "values": )");
    const Outcome broken = pack();
    INFO(broken.out << broken.err);
    CHECK(broken.status != 0);
    CHECK(contains(broken.err, "main.tweaks.json: is not JSON"));
}

}  // namespace package_content_test
