// Files of a game change while the program runs it.

#include <catch.h>

#include <csignal>
#include <thread>

#include "running_program.h"

namespace reload_run_test {

using namespace program_test;

namespace {

/// A headless run that follows its files. The script ends it.
struct Run {
    Folder folder;
    const std::string game = (folder / "game").string();

    RunningProgram begin(const std::vector<std::string>& more = {"--reload"}) {
        std::vector<std::string> arguments = {"run", game, "--headless", "--steps", "1000000000"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        return {folder, arguments};
    }
};

/// Lua that writes into the store what a reload did, where the test reads it.
const std::string tells =
    "function reloaded(files) store.files = files[1] store.mass = world.ball.mass "
    "store.played = world.ball.position.y < 0 quit() end ";

}  // namespace

TEST_CASE("a headless run follows its files if it is asked to") {
    Run run;
    run.folder.write("game/game.json", R"({"id": "org.example.reload"})");
    run.folder.write("game/main.lua",
                     tells +
                         "world.ball = Body { mass = 2, Circle { } } "
                         "after(1, function() scene.save('begun.json', world.ball) end)");
    RunningProgram program = run.begin();
    REQUIRE(program.makes("game/begun.json"));
    run.folder.write("game/main.lua", tells + "world.ball = Body { mass = 3, Circle { } }");
    const auto end = program.end();
    INFO(end.out << end.err);
    CHECK(end.status == 0);
    CHECK(contains(end.err, "reloaded main.lua in "));
    const std::string store =
        run.folder.text("user data/fettle/games/org.example.reload/store.json");
    CHECK(contains(store, "\"files\": \"main.lua\""));
    CHECK(contains(store, "\"mass\": 3"));
    CHECK(contains(store, "\"played\": true"));
}

TEST_CASE("a reload leaves the settings of the player") {
    Run run;
    run.folder.write("game/game.json", R"({"id": "org.example.settings"})");
    const std::string main = "audio.volume = 0.9 input.actions.jump = { 'space' } ";
    run.folder.write("game/main.lua",
                     main +
                         "after(0.5, function() interface:prefer('audio.volume', 0.25) "
                         "interface:prefer('input.actions.jump', { 'j' }) end) "
                         "after(1, function() scene.save('begun.json', Object { }) end)");
    RunningProgram program = run.begin();
    REQUIRE(program.makes("game/begun.json"));
    run.folder.write("game/main.lua",
                     main +
                         "function reloaded() after(0.1, function() store.volume = audio.volume "
                         "store.key = input.actions.jump[1] quit() end) end");
    const auto end = program.end();
    INFO(end.out << end.err);
    CHECK(end.status == 0);
    const std::string store =
        run.folder.text("user data/fettle/games/org.example.settings/store.json");
    CHECK(contains(store, "\"volume\": 0.25"));
    CHECK(contains(store, "\"key\": \"j\""));
}

TEST_CASE(
    "the top level of a changed file reads the layers and objects of the map that it places") {
    Run run;
    run.folder.write("game/game.json", R"({"id": "org.example.map"})");
    run.folder.write("game/level.json", R"({"type": "map", "orientation": "orthogonal",
        "width": 2, "height": 1, "tilewidth": 16, "tileheight": 16, "layers": [
        {"type": "tilelayer", "id": 1, "name": "ground", "width": 2, "height": 1, "data": [0, 0]},
        {"type": "objectgroup", "id": 2, "name": "things", "objects": [
            {"id": 1, "name": "start", "x": 16, "y": 0, "point": true},
            {"id": 2, "name": "coin", "x": 0, "y": 0, "point": true}]}]})");
    const std::string map =
        "world.level = Tilemap { map = 'level.json', pixels_per_unit = 16 } "
        "local level = world.level local things = level.things ";
    run.folder.write("game/main.lua",
                     map +
                         "world.ball = Body { position = things.start.position } "
                         "after(1, function() things.coin:delete() first = things.start "
                         "scene.save('begun.json', Object { }) end)");
    RunningProgram program = run.begin();
    REQUIRE(program.makes("game/begun.json"));
    run.folder.write("game/main.lua",
                     map +
                         "world.ball = Body { position = things.start.position + vec(0, 4) } "
                         "level.ground.opacity = 0.5 "
                         "function reloaded() store.same = things.start == first "
                         "store.things = #things:children() store.maps = #world:find(Tilemap) "
                         "store.opacity = world.level.ground.opacity "
                         "store.x = world.ball.position.x quit() end");
    const auto end = program.end();
    INFO(end.out << end.err);
    CHECK(end.status == 0);
    CHECK(contains(end.err, "reloaded main.lua in "));
    const std::string store = run.folder.text("user data/fettle/games/org.example.map/store.json");
    INFO(store);
    for (const char* const entry :
         {"\"same\": true", "\"things\": 1", "\"maps\": 1", "\"opacity\": 0.5", "\"x\": 1"})
        CHECK(contains(store, entry));
}

TEST_CASE("an error of a changed file is reported and the game goes on") {
    Run run;
    run.folder.write("game/main.lua",
                     "world.ball = Body { Circle { } } "
                     "after(1, function() scene.save('begun.json', world.ball) end)");
    RunningProgram program = run.begin();
    REQUIRE(program.makes("game/begun.json"));
    run.folder.write("game/main.lua", "world.ball = Body { mas = 3 }");
    REQUIRE(program.reports("Body has no property \"mas\""));
    run.folder.write("game/main.lua",
                     "world.ball = Body { Circle { } } function reloaded() quit() end");
    const auto end = program.end();
    INFO(end.out << end.err);
    CHECK(end.status == 0);
    CHECK(contains(end.err, "Body has no property \"mas\" (did you mean \"mass\"?)"));
    CHECK(contains(end.err, "reloaded main.lua in "));
}

TEST_CASE(
    "a changed image or setting that is invalid is reported as an error and not as reloaded") {
    Run run;
    const std::string head("\0\0\2\0\0\0\0\0\0\0\0\0\1\0\1\0\x20\0", 18);
    run.folder.write("game/hero.tga", head + "\x10\x20\x30\xff");
    run.folder.write("game/game.json", R"({"name": "Hero"})");
    run.folder.write("game/main.lua",
                     "world.hero = Sprite { image = 'hero.tga' } "
                     "after(1, function() scene.save('begun.json', world) end) "
                     "function reloaded(files) print('again: ' .. files[1]) "
                     "if #files == 1 and files[1] == 'hero.tga' then quit() end end");
    RunningProgram program = run.begin();
    REQUIRE(program.makes("game/begun.json"));
    const auto pause = [](int ms) { std::this_thread::sleep_for(std::chrono::milliseconds(ms)); };
    pause(500);  // until the run has noted the files that it has read
    run.folder.write("game/hero.tga", "no image");
    run.folder.write("game/game.json", R"({"nam": "Hero"})");
    REQUIRE(program.reports("\"hero.tga\": cannot be read as PNG"));
    REQUIRE(program.reports("(did you mean \"name\"?)"));
    run.folder.write("game/hero.tga", head + "\x40\x20\x30\xff");
    const auto end = program.end();
    INFO(end.out << end.err);
    CHECK(end.status == 0);
    CHECK(contains(end.err, "error in files: \"hero.tga\": cannot be read as PNG"));
    CHECK(contains(end.err, "(did you mean \"name\"?)"));
    CHECK(end.out == "again: hero.tga\n");
    CHECK_FALSE(contains(end.err, "reloaded game.json"));
}

TEST_CASE("files that are reloaded have their names whatever path the game was given by") {
    Run run;
    run.folder.write("game/main.lua",
                     "world.ball = Body { mass = 2 } "
                     "function reloaded(files) print(#files, files[1]) quit() end");
    const std::string relative = std::filesystem::relative(run.game).string();
    RunningProgram program(run.folder, {"run", relative, "--headless", "--steps", "1000000000",
                                        "--reload", "--at", "100:scene.save('begun.json', world)"});
    REQUIRE(program.makes("game/begun.json"));
    run.folder.write("game/main.tweaks.json", R"({"fettle_tweaks": 1, "values": {}})");
    const auto end = program.end();
    INFO(end.out << end.err);
    CHECK(end.status == 0);
    CHECK(contains(end.out, "1\tmain.tweaks.json\n"));
    CHECK(contains(end.err, "reloaded main.tweaks.json in "));
}

TEST_CASE("files that a run writes itself are not reloaded") {
    Run run;
    const std::string scene = R"({"fettle_scene": 1, "class": "Body", "properties": {"mass": )";
    run.folder.write("game/top.json", scene + "2}}");
    const std::string main =
        "world.ball = scene.load('top.json') world.box = Body {} "
        "function reloaded(files) print(table.concat(files, ' '), world.box.mass) "
        "if table.concat(files):find('main.lua') then quit() end end ";
    run.folder.write("game/main.lua", main);
    RunningProgram program(
        run.folder, {"run", run.game, "--headless", "--steps", "1000000000", "--reload",
                     "--console", "100:world.ball.mass = 5 world.box.mass = 6", "--console",
                     "101:keep('**')", "--console", "102:world.ball.mass = 7 world.box.mass = 8",
                     "--at", "103:after(0.1, function() scene.save('begun.json', world) end)"});
    REQUIRE(program.makes("game/begun.json"));
    run.folder.write("game/main.lua", main + "-- more");
    const auto end = program.end();
    INFO(end.out << end.err);
    CHECK(end.status == 0);
    CHECK(end.out.ends_with("\nmain.lua\t8.0\n"));
    CHECK_FALSE(contains(end.out, ".json\t"));
    CHECK(contains(end.err, "reloaded main.lua in "));
}

TEST_CASE("a changed scene is reported correctly and an error in it has its line") {
    Run run;
    const std::string scene = R"({"fettle_scene": 1, "class": "Body", "properties": {"mass": )";
    run.folder.write("game/top.json", scene + "2}}");
    run.folder.write("game/later.json", scene + "2}}");
    run.folder.write("game/main.lua",
                     "world.ball = scene.load('top.json') "
                     "function start() scene.load('later.json', world, 'later') end "
                     "after(1, function() scene.save('begun.json', world) end) "
                     "function reloaded(files) if files[1] == 'top.json' then "
                     "print(world.ball.mass, world.later.mass) quit() end end");
    RunningProgram program = run.begin();
    REQUIRE(program.makes("game/begun.json"));
    const auto pause = [](int ms) { std::this_thread::sleep_for(std::chrono::milliseconds(ms)); };
    pause(500);  // until the run has noted the files that it has read
    run.folder.write("game/later.json", "{ nonsense");
    REQUIRE(program.reports("later.json:1:"));
    run.folder.write("game/later.json", "{\n\"fettle_scene\": 1, \"class\": \"Bodi\"}");
    REQUIRE(program.reports("later.json:2:"));
    run.folder.write("game/later.json", scene + "30, \"positon\": [1, 2]}}");
    REQUIRE(program.reports("later.json has changed"));
    run.folder.write("game/top.json", scene + "30}}");
    const auto end = program.end();
    INFO(end.out << end.err);
    CHECK(end.status == 0);
    CHECK(end.out == "30.0\t2.0\n");
    CHECK(contains(end.err, "later.json:1:"));
    CHECK(contains(end.err, "later.json:2:"));
    CHECK(contains(end.err, "later.json has changed, and is there when the game loads it again"));
    CHECK(contains(end.err,
                   "later.json:1:65: body: Body has no property \"positon\" (did you mean "
                   "\"position\"?); kept as it is"));
    CHECK_FALSE(contains(end.err, "reloaded later.json"));
    CHECK(contains(end.err, "reloaded top.json in "));
}

TEST_CASE("a run without the option and a recorded run do not reload changed files") {
    Run run;
    run.folder.write("game/main.lua",
                     "local first = not store.again store.again = true "
                     "after(1, function() scene.save('begun.json', world) end) "
                     "after(1e9, function() end) function reloaded() quit(7) end");
    const std::vector<std::string> options =
        GENERATE(std::vector<std::string>{}, std::vector<std::string>{"--reload", "--record", "x"});
    std::vector<std::string> given;
    for (const std::string& each : options)
        given.push_back(each == "x" ? (run.folder / "run.recording").string() : each);
    RunningProgram program = run.begin(given);
    REQUIRE(program.makes("game/begun.json"));
    run.folder.write("game/main.lua", "function reloaded() quit(7) end");
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    program.send(SIGTERM);
    const auto end = program.end();
    CHECK(end.status == 128 + SIGTERM);
    CHECK_FALSE(contains(end.err, "reloaded"));
}

TEST_CASE("a game that deletes the world at its top level is loaded again while it runs") {
    Run run;
    run.folder.write("game/game.json", R"({"id": "org.example.no-world"})");
    const std::string top =
        "world.gravity = vec(0, -3) world.old = Body { Circle { } } world:delete() ";
    run.folder.write("game/main.lua",
                     top +
                         "game.place = World { gravity = vec(0, -4) } "
                         "after(1, function() scene.save('begun.json', Object { }) end)");
    RunningProgram program = run.begin();
    REQUIRE(program.makes("game/begun.json"));
    run.folder.write("game/main.lua",
                     top +
                         "game.place = World { gravity = vec(0, -5) } "
                         "function reloaded() store.world = game:has('world') "
                         "store.worlds = #game:find(World) store.bodies = #game:find(Body) "
                         "store.gravity = game.place.gravity.y quit() end");
    const auto end = program.end();
    INFO(end.out << end.err);
    CHECK(end.status == 0);
    const std::string store =
        run.folder.text("user data/fettle/games/org.example.no-world/store.json");
    CHECK(contains(store, "\"world\": false"));
    CHECK(contains(store, "\"worlds\": 1"));
    CHECK(contains(store, "\"bodies\": 0"));
    CHECK(contains(store, "\"gravity\": -5"));
}

TEST_CASE(
    "values for a world that the game has deleted since its start have no effect in a reload") {
    Run run;
    run.folder.write("game/game.json", R"({"id": "org.example.gone"})");
    run.folder.write(
        "game/main.lua",
        "world.gravity = vec(0, -3) "
        "after(1, function() world:delete() scene.save('begun.json', Object { }) end)");
    RunningProgram program = run.begin();
    REQUIRE(program.makes("game/begun.json"));
    run.folder.write("game/main.lua",
                     "world.gravity = vec(0, -5) world.ball = Body { Circle { } } "
                     "function reloaded() store.world = game:has('world') "
                     "store.bodies = #game:find(Body) quit() end");
    const auto end = program.end();
    INFO(end.out << end.err);
    CHECK(end.status == 0);
    const std::string store = run.folder.text("user data/fettle/games/org.example.gone/store.json");
    CHECK(contains(store, "\"world\": false"));
    CHECK(contains(store, "\"bodies\": 0"));
}

}  // namespace reload_run_test
