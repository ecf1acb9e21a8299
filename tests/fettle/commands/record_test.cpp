// `fettle run --record` and `--replay` as commands.

#include <catch.h>

#include <fstream>
#include <iterator>
#include <map>

#include "program.h"

namespace record_test {

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

TEST_CASE("breaks and searches and files of commands are replayed") {
    const Folder folder;
    const std::string path = folder.write("main.lua", game);
    folder.write("setup.lua", "world.body_5.mass = 4\nworld.body_6.mass = 5\n");
    const std::string file = (folder / "run.rec").string();
    const Outcome made =
        fettle(folder, {"run",        path,
                        "--headless", "--steps",
                        "120",        "--hash",
                        "--record",   file,                                                    //
                        "--console",  "10:break_when world.body_1.position.y < 2.5",           //
                        "--console",  "60:time.paused = false",                                //
                        "--console",  "62:plot world.body_2.position, world.body_3.velocity",  //
                        "--console",  "70:exec 'setup.lua'",                                   //
                        "--console",  "80:last_time world.body_1.position.y > 2.7",            //
                        "--console",  "90:time.paused = false",                                //
                        "--console",  "100:print(world.body_5.mass, world.body_6.mass)"});
    INFO(made.out << made.err);
    REQUIRE(made.status == 0);
    CHECK(contains(made.out, "  break at step "));
    CHECK(contains(made.out, "  last_time world.body_1.position.y > 2.7: true at step "));
    const Outcome again = fettle(folder, {"run", "--headless", "--hash", "--replay", file});
    INFO(again.out << again.err);
    CHECK(again.status == 0);
    CHECK(contains(again.out, " steps, each as it was recorded\n"));
    const auto hash = [](const std::string& out) {
        return out.substr(out.rfind('\n', out.size() - 2) + 1);
    };
    CHECK(hash(again.out) == hash(made.out));
}

TEST_CASE("a replay selects what was selected and its commands have the same results") {
    const Folder folder;
    const std::string path = folder.write("main.lua", game);
    const std::string file = (folder / "run.rec").string();
    const Outcome made =
        fettle(folder, {"run", path, "--headless", "--steps", "60", "--hash", "--record", file,  //
                        "--console", "10:selection { world.body_2, world.body_3 }",              //
                        "--console", "20:it.mass",                                               //
                        "--console", "25:it.mass = _ + 2",                                       //
                        "--console", "30:for _, b in ipairs(selection()) do b.velocity.x = 3 end"});
    INFO(made.out << made.err);
    REQUIRE(made.status == 0);
    CHECK(contains(read(file), "\nselected "));
    const Outcome again = fettle(folder, {"run", "--headless", "--hash", "--replay", file});
    INFO(again.out << again.err);
    CHECK(again.status == 0);
    CHECK(contains(again.out, "60 steps, each as it was recorded\n"));
}

TEST_CASE("a recording contains the commands typed into the console of a run") {
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

TEST_CASE("a replay writes nothing to the files of the game and has the same result as the run") {
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
                 "12:edit('more', function() ball.bounces = 1 end)",  //
                 "--at",
                 "15:drop_tweaks('**') save_game('late')",  //
                 "--at",
                 "35:save_game('early') delete_save('late')"});
    INFO(made.err);
    REQUIRE(made.status == 0);
    REQUIRE(read(folder / "ball.json") != scene);
    REQUIRE(fs::exists(folder / "copy.json"));
    REQUIRE(fs::exists(folder / "main.tweaks.json"));
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
    CHECK(again.out == "keep" + left + "kept 2 tweaks in ball.json, main.tweaks.json\n" +
                           "scene.save" + left + "dropped 1 tweak; its value stays as it is\n" +
                           "delete_save" + left + "40 steps, each as it was recorded\n" +
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
    CHECK(contains(other.err, "another version"));
    CHECK(contains(other.err, ": main.lua differs\n"));
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

TEST_CASE("a replay names the changed files of the game") {
    const Folder folder;
    const std::string path = folder.write("main.lua", R"(
        require("parts.helper")
        ball = scene.load("scenes/ball.json", world)
        every(0.1, function() scene.load("scenes/late.json", world) end)
    )");
    fs::create_directories(folder / "parts");
    fs::create_directories(folder / "scenes");
    const std::string scene = "{\"fettle_scene\": 1, \"class\": \"Body\"}\n";
    const std::string manifest = "{\"modules\": []}\n";
    folder.write("parts/helper.lua", "helped = true");
    folder.write("scenes/ball.json", scene);
    folder.write("scenes/late.json", scene);
    folder.write("modules.json", manifest);
    folder.write("readme.txt", "nothing");
    const std::string file = (folder / "run.rec").string();
    const Outcome made =
        fettle(folder, {"run", path, "--headless", "--steps", "30", "--record", file});
    REQUIRE(made.status == 0);
    const auto replay = [&] { return fettle(folder, {"run", "--headless", "--replay", file}); };
    // Files that the run does not read may change.
    folder.write("readme.txt", "something");
    folder.write("unused.lua", "error('never')");
    folder.write("scenes/unused.json", scene);
    CHECK(replay().status == 0);

    const auto changes = [&](const std::string& name, const std::string& good,
                             const std::string& changed, const std::string& how) {
        INFO(name);
        if (changed.empty())
            fs::remove(folder / name);
        else
            folder.write(name, changed);
        const Outcome run = replay();
        CHECK(run.status == 3);
        CHECK(contains(run.err, "another version of " + path + ": " + name + how + "\n"));
        if (good.empty())
            fs::remove(folder / name);
        else
            folder.write(name, good);
    };
    changes("parts/helper.lua", "helped = true", "helped = false", " differs");
    changes("scenes/ball.json", scene, scene + " ", " differs");
    changes("scenes/late.json", scene, scene + "\n", " differs");
    changes("scenes/late.json", scene, "", " is missing");
    changes("modules.json", manifest, "{\"modules\": [ ]}\n", " differs");
    changes("main.tweaks.json", "", "{\"fettle_tweaks\": 1}\n", " is new");
    CHECK(replay().status == 0);
    folder.write("scenes/ball.json", scene + " ");
    folder.write("scenes/late.json", scene + " ");
    CHECK(contains(replay().err, ": scenes/ball.json differs, scenes/late.json differs\n"));
}

TEST_CASE("a replay repeats the actions of the user on earlier tweaks") {
    const Folder folder;
    const std::string path = folder.write("main.lua", R"(
        ball = scene.load("ball.json", world)
        world.loose = Body { position = vec(5, 9), Circle {} }
        world.wall = Body { type = "static", position = vec(9, 0), Box {} }
        world.crate = Body { position = vec(-5, 9), Box {} }
        function step()
            if time.step == 30 then
                world.loose:delete()
                world.loose = Body { position = vec(5, 3), Circle {} }
                scene.load("ball.json", world, "second")
            end
        end
    )");
    folder.write("ball.json",
                 "{\"fettle_scene\": 1, \"class\": \"Body\", \"name\": \"ball\",\n"
                 "  \"children\": [{\"class\": \"Circle\"}]}\n");
    // An earlier run leaves tweaks of every kind.
    const Outcome earlier =
        fettle(folder, {"run", path, "--headless", "--steps", "5",                           //
                        "--console", "2:ball.gravity_scale = 0.5",                           //
                        "--console", "2:world.loose.mass = 7",                               //
                        "--console", "2:world.crate.angular_damping is ball.gravity_scale",  //
                        "--console", "3:world.wall = nil",                                   //
                        "--console", "3:world.lamp = Body { position = vec(0, 20), Circle {} }",
                        "--console", "4:world.crate.name = \"box\""});
    INFO(earlier.out << earlier.err);
    REQUIRE(earlier.status == 0);
    const std::string file = (folder / "run.rec").string();
    const Outcome made = fettle(folder, {"run",        path,
                                         "--headless", "--steps",
                                         "60",         "--hash",
                                         "--record",   file,                                    //
                                         "--console",  "5:reapply_tweaks(\"world.ball.*\")",    //
                                         "--console",  "8:reapply_tweaks(\"world.lamp\")",      //
                                         "--console",  "10:drop_tweaks(\"world.loose\")",       //
                                         "--console",  "12:reapply_tweaks(\"**\")",             //
                                         "--console",  "15:world.loose.linear_damping = 0.25",  //
                                         "--console",  "18:keep(\"**\")",                       //
                                         "--console",  "40:undo()"});
    INFO(made.out << made.err);
    REQUIRE(made.status == 0);
    CHECK(contains(made.out, "made again 1 tweak\n"));
    CHECK(contains(made.out, "dropped 1 tweak; its value stays as it is\n"));
    CHECK(contains(made.out, "kept "));
    REQUIRE(fs::exists(folder / "main.tweaks.json"));
    const std::string scene = folder.text("ball.json"), kept = folder.text("main.tweaks.json");
    REQUIRE(contains(scene, "gravity_scale"));
    REQUIRE(contains(kept, "linear_damping"));

    const auto last_line = [](const std::string& text) {
        return text.substr(text.rfind('\n', text.size() - 2) + 1);
    };
    for (int time = 0; time < 2; ++time) {
        const Outcome again = fettle(folder, {"run", "--headless", "--hash", "--replay", file});
        CHECK(again.err.empty());
        CHECK(again.status == 0);
        CHECK(contains(again.out, "60 steps, each as it was recorded\n"));
        CHECK(last_line(again.out) == last_line(made.out));
        CHECK(folder.text("ball.json") == scene);
        CHECK(folder.text("main.tweaks.json") == kept);
    }
    // Without these actions the run has another result.
    const Outcome without = fettle(folder, {"run", path, "--headless", "--steps", "60", "--hash"});
    CHECK(last_line(without.out) != last_line(made.out));
}

}  // namespace record_test
