// `fettle run --record` and `--replay` as commands.

#include <catch.h>

#include <fstream>
#include <iterator>
#include <map>

#include "program.h"

using namespace program_test;
namespace fs = std::filesystem;

namespace {

constexpr const char* game = R"(
    for i = 1, 12 do world:add(Body { position = vec(i, 2 + i), Box {} }) end
    world.floor = Body { type = "static", position = vec(0, -1), Box { width = 60, height = 2 } }
    every(0.1, function() world.body_3:apply_impulse(vec(random(), 1)) end)
    function step() if time.step == 20 then world:add(Body { Circle {} }) end end
)";

std::string read(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

}  // namespace

TEST_CASE("a recorded run is replayed step by step") {
    const Folder folder;
    const std::string path = folder.write("main.lua", game);
    const std::string file = (folder / "run.rec").string();
    const Outcome made =
        fettle(folder, {"run", path, "--headless", "--steps", "60", "--seed", "7", "--hash", "--at",
                        "30:world.body_5.mass = 9", "--record", file});
    REQUIRE(made.status == 0);
    const Outcome again = fettle(folder, {"run", "--headless", "--hash", "--replay", file});
    CHECK(again.err.empty());
    CHECK(again.status == 0);
    CHECK(again.out == "60 steps, each as it was recorded\n" + made.out);
}

TEST_CASE("commands typed into the console of a run are part of its recording") {
    const Folder folder;
    const std::string path = folder.write("main.lua", game);
    const std::string file = (folder / "run.rec").string();
    const Outcome made =
        fettle(folder, {"run", path, "--headless", "--steps", "60", "--hash", "--record", file,  //
                        "--console", "20:world.body_5.gravity_scale is world.body_4.position.x",
                        "--console", "30:world.body_2.masss = 2", "--console", "40:rewind(0.25)",
                        "--console", "61:world.body_1.mass = 1"});
    CHECK(made.status == 0);
    CHECK(contains(made.out,
                   "› world.body_5.gravity_scale is world.body_4.position.x\n"
                   "  world.body_5.gravity_scale: is world.body_4.position.x = "));
    CHECK(contains(made.out, "› world.body_2.masss = 2\n✗ console:1: "));
    CHECK(made.err == "fettle: --console 61 was never reached: the run ended with its step 60\n");
    const Outcome again = fettle(folder, {"run", "--headless", "--hash", "--replay", file});
    CHECK(again.status == 0);
    CHECK(again.out == "60 steps, each as it was recorded\n" +
                           made.out.substr(made.out.rfind('\n', made.out.size() - 2) + 1));
}

TEST_CASE("a replay that differs ends with 1 and names the step") {
    const Folder folder;
    const std::string path = folder.write("main.lua", game);
    const fs::path file = folder / "run.rec";
    fettle(folder, {"run", path, "--headless", "--steps", "40", "--record", file.string()});
    std::string text = read(file);
    const std::size_t at = text.find("physics ", text.find("\nstep 17 ")) + 8;
    text[at] = text[at] == '0' ? '1' : '0';
    std::ofstream(file, std::ios::binary | std::ios::trunc) << text;
    const Outcome run = fettle(folder, {"run", "--headless", "--replay", file.string()});
    CHECK(run.status == 1);
    CHECK(run.err.find("step 17: physics differs") != std::string::npos);
}

TEST_CASE("a replay writes nothing to the files of the game and goes on as the run did") {
    const Folder folder;
    const std::string path = folder.write("main.lua", R"(
        ball = scene.load("ball.json", world)
        world.loose = Body { Circle {} }
        function step() if time.step == 30 then load_game("early") end end
    )");
    const std::string scene =
        "{\"fettle_scene\": 1, \"class\": \"Body\", \"name\": \"ball\",\n"
        "  \"children\": [{\"class\": \"Circle\"}]}\n";
    folder.write("ball.json", scene);
    const std::string file = (folder / "run.rec").string();
    const Outcome made = fettle(
        folder, {"run",
                 path,
                 "--headless",
                 "--steps",
                 "40",
                 "--hash",
                 "--record",
                 file,  //
                 "--at",
                 "5:edit('heavier', function() ball.mass = 5 world.loose.mass = 7 end)",  //
                 "--at",
                 "8:save_game('early')",  //
                 "--at",
                 "10:keep('world.**') scene.save('copy.json', ball) ball.gravity_scale = 2",  //
                 "--at",
                 "12:edit('more', function() ball.friction = 1 end)",  //
                 "--at",
                 "15:drop_tweaks('**') save_game('late')",  //
                 "--at",
                 "35:save_game('early') delete_save('late')"});
    INFO(made.err);
    REQUIRE(made.status == 0);
    REQUIRE(read(folder / "ball.json") != scene);
    REQUIRE(fs::exists(folder / "copy.json"));
    REQUIRE(fs::exists(folder / "main.tweaks.json"));
    // As they were before, or the game would be another one from its start.
    fs::remove(folder / "copy.json");
    fs::remove(folder / "main.tweaks.json");
    folder.write("ball.json", scene);
    fettle(folder, {"run", path, "--headless", "--steps", "1", "--eval",
                    "save_game('late') save_game('early')"});
    const auto contents = [&] {
        std::map<std::string, std::string> all;
        for (const auto& entry : fs::recursive_directory_iterator(folder / ""))
            if (entry.is_regular_file() && entry.path().filename() != "out" &&
                entry.path().filename() != "err")
                all[entry.path().string()] = read(entry.path());
        return all;
    };
    const auto before = contents();

    const Outcome again = fettle(folder, {"run", "--headless", "--hash", "--replay", file});
    CHECK(again.err.empty());
    CHECK(again.status == 0);
    const std::string left = ": nothing is written, since this is a replay of run.rec\n";
    CHECK(again.out == "keep" + left + "scene.save" + left + "drop_tweaks" + left + "delete_save" +
                           left + "40 steps, each as it was recorded\n" +
                           made.out.substr(made.out.rfind('\n', made.out.size() - 2) + 1));
    for (const auto& [name, text] : contents()) {
        INFO(name);
        CHECK(before.contains(name));
        CHECK((before.contains(name) && before.at(name) == text));
    }
}

TEST_CASE("recordings of another game and damaged ones end with 3") {
    const Folder folder;
    const std::string path = folder.write("main.lua", game);
    const fs::path file = folder / "run.rec";
    fettle(folder, {"run", path, "--headless", "--steps", "5", "--record", file.string()});
    const std::string good = read(file);
    folder.write("main.lua", std::string(game) + " -- changed");
    const Outcome other = fettle(folder, {"run", "--headless", "--replay", file.string()});
    CHECK(other.status == 3);
    CHECK(other.err.find("another version") != std::string::npos);
    folder.write("main.lua", game);
    for (const std::string& bad :
         {std::string("fettle-recording 9\n"), good.substr(0, 40), good + "rubbish\n"}) {
        std::ofstream(file, std::ios::binary | std::ios::trunc) << bad;
        const Outcome run = fettle(folder, {"run", "--headless", "--replay", file.string()});
        CHECK(run.status == 3);
        CHECK(run.err.find("run.rec") != std::string::npos);
    }
    CHECK(fettle(folder, {"run", "--headless", "--replay", "missing.rec"}).status == 3);
    CHECK(fettle(folder,
                 {"run", path, "--headless", "--steps", "1", "--record", "/nowhere/there.rec"})
              .status == 3);
}
