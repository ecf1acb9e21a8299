// `fettle new` makes a game that runs and whose tests pass.

#include <catch.h>

#include <fstream>
#include <set>

#include "running_program.h"

namespace new_game_test {

using namespace program_test;
namespace fs = std::filesystem;

TEST_CASE("a game of every template runs and passes its tests") {
    const auto pattern = GENERATE(as<std::string>(), "empty", "physics", "platformer", "topdown");
    INFO(pattern);
    const Folder folder;
    const std::string game = (folder / "My \"Game\" 2").string();
    const Outcome made = fettle(folder, {"new", game, "--template", pattern});
    INFO(made.err);
    REQUIRE(made.status == 0);
    const std::string settings = folder.text("My \"Game\" 2/game.json");
    CHECK(contains(settings, R"("name": "My \"Game\" 2")"));
    CHECK(contains(settings, R"("id": "org.example.my-game-2-)"));
    CHECK(contains(folder.text("My \"Game\" 2/.editor/fettle.lua"), "---@class Body"));
    CHECK(contains(folder.text("My \"Game\" 2/.luarc.json"), ".editor"));
    const Outcome run = fettle(folder, {"run", game, "--headless", "--steps", "600"});
    INFO(run.out << run.err);
    CHECK(run.status == 0);
    CHECK(run.err.empty());
    const Outcome tests = fettle(folder, {"test", game});
    INFO(tests.out << tests.err);
    CHECK(tests.status == 0);
    CHECK(contains(tests.out, " 0 failed\n"));
}

TEST_CASE("a number that is changed in a game of a template changes the game that runs") {
    const auto pattern = GENERATE(as<std::string>(), "empty", "physics", "platformer", "topdown");
    INFO(pattern);
    const Folder folder;
    const std::string game = (folder / "game").string();
    REQUIRE(fettle(folder, {"new", game, "--template", pattern}).status == 0);
    std::string main = folder.text("game/main.lua");
    folder.write("game/main.lua",
                 main + "after(0.2, function() scene.save('begun.json', Object { }) end)");
    RunningProgram program(folder,
                           {"run", game, "--headless", "--reload", "--steps", "1000000000"});
    REQUIRE(program.makes("game/begun.json"));
    const std::size_t at = main.find("view.height = ");
    REQUIRE(at != std::string::npos);
    main.replace(at, main.find('\n', at) - at, "view.height = 7.5");
    folder.write("game/main.lua", main + "after(0.1, function() print(view.height) quit() end)");
    const auto end = program.end();
    INFO(end.err);
    CHECK(end.status == 0);
    CHECK(end.out == "7.5\n");
}

TEST_CASE("a name with a line break is refused and nothing is made") {
    const Folder folder;
    const Outcome made = fettle(folder, {"new", "a\nb"});
    CHECK(made.status == 2);
    CHECK(contains(made.err, "without line breaks"));
    CHECK_FALSE(std::filesystem::exists(folder / "a\nb"));
}

TEST_CASE("different names get different ids") {
    const Folder folder;
    std::set<std::string> ids;
    const std::vector<std::string> names = {"\u00e9",  "\u00e8",  "caf\u00e9", "cafe",
                                            "my game", "my-game", "my_game",   "My Game!"};
    for (const std::string& name : names) {
        CHECK(fettle(folder, {"new", (folder / name).string()}).status == 0);
        const std::string settings = folder.text(name + "/game.json");
        const std::size_t at = settings.find("org.example.");
        REQUIRE(at != std::string::npos);
        ids.insert(settings.substr(at, settings.find('"', at) - at));
    }
    CHECK(ids.size() == names.size());
    CHECK(ids.contains("org.example.cafe"));
    CHECK(ids.contains("org.example.my-game"));
}

TEST_CASE("a new game overwrites nothing") {
    const Folder folder;
    folder.write("there/notes.txt", "mine");
    const Outcome there = fettle(folder, {"new", (folder / "there").string()});
    CHECK(there.status == 3);
    CHECK(contains(there.err, "there is something already"));
    CHECK(folder.text("there/notes.txt") == "mine");
    CHECK_FALSE(fs::exists(folder / "there/main.lua"));
    fs::create_directory(folder / "empty");
    CHECK(fettle(folder, {"new", (folder / "empty").string()}).status == 0);
    // An existing folder is filled and not replaced: it may be the working folder of a shell.
    fs::create_directory(folder / "here");
    fs::create_directory_symlink("here", folder / "link");
    CHECK(fettle(folder, {"new", (folder / "link").string()}).status == 0);
    CHECK(fs::is_symlink(folder / "link"));
    CHECK(fs::exists(folder / "here" / "main.lua"));
    for (const auto& each : fs::directory_iterator(folder / "here"))  // no draft is left
        CHECK_FALSE(each.path().filename().string().starts_with("link."));
    CHECK(fs::exists(folder / "empty/main.lua"));
}

TEST_CASE("an unknown template is an error with the nearest name") {
    const Folder folder;
    const Outcome run =
        fettle(folder, {"new", (folder / "game").string(), "--template", "platfromer"});
    CHECK(run.status == 2);
    CHECK(contains(run.err, "there are empty, physics, platformer, topdown"));
    CHECK(contains(run.err, "did you mean \"platformer\"?"));
    CHECK_FALSE(fs::exists(folder / "game"));
    CHECK(fettle(folder, {"new"}).status == 2);
}

}  // namespace new_game_test
