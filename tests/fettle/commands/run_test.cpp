// `fettle run` as a command: its output and its exit status.

#include <catch.h>

#include "program.h"

namespace run_test {

using namespace program_test;
namespace fs = std::filesystem;

TEST_CASE("a headless run makes its steps and ends with status 0") {
    const Folder folder;
    const std::string game = folder.write(
        "main.lua", "n = 0 function step() n = n + 1 end function update() n = n + 100 end");
    const Outcome run =
        fettle(folder, {"run", game, "--headless", "--steps", "3", "--at", "3:print(n)"});
    CHECK(run.status == 0);
    CHECK(run.out == "202\n");
    CHECK(run.err.empty());
}

TEST_CASE("a folder with main lua is a game") {
    const Folder folder;
    folder.write("my game/main.lua", "print('here')");
    const Outcome run =
        fettle(folder, {"run", (folder / "my game").string(), "--headless", "--steps", "1"});
    CHECK(run.status == 0);
    CHECK(run.out == "here\n");
}

TEST_CASE(
    "errors about names from other engines name the properties of pictures sounds and menus") {
    const auto [wrong, meant] = GENERATE(table<std::string, std::string>({
        {"Button { enabled = true }", "disabled"},
        {"Button { position = vec(1, 2) }", "offset"},
        {"Sprite { img = 'a.png' }", "image"},
        {"Sprite { color = color('red') }", "tint"},
        {"Sprite { width = 3 }", "size = vec(width, height)"},
        {"Sprite { fps = 8 }", "frames_per_second"},
        {"Layer { alpha = 0.5 }", "opacity"},
        {"Sound { src = 'a.ogg' }", "file"},
        {"Text { caption = 'a' }", "text"},
        {"Emitter { life = 2 }", "lifetime"},
        {"Sprite { file = 'a.png' }", "image"},
        {"Tilemap { file = 'a.tmj' }", "map"},
        {"Panel { background = 'red' }", "color"},
        {"input.mouse.x", "\"world\""},
    }));
    const Folder folder;
    const std::string game = folder.write("main.lua", "game.made = " + wrong);
    const Outcome run = fettle(folder, {"run", game, "--headless", "--steps", "1"});
    CHECK(run.status == 1);
    CHECK(contains(run.err, "(did you mean " + meant + "?)"));
}

TEST_CASE("one color where a list of colors is needed is reported with the list") {
    const Folder folder;
    const std::string main = folder.write("main.lua", "Emitter { color = 'red' }");
    CHECK(contains(fettle(folder, {"run", main, "--headless", "--steps", "1"}).err,
                   "got text \"red\" (write {\"red\"})"));
}

TEST_CASE("chunks run in the order they were given") {
    const Folder folder;
    const std::string game =
        folder.write("a.lua", "print('main') function start() print('start') end");
    const Outcome run =
        fettle(folder, {"run", game, "--headless", "--steps", "2",                    //
                        "--eval", "print('one', [[a,b]])", "--eval", "print('two')",  //
                        "--at", "1:print('at 1: ' .. time.step)",                     //
                        "--at", "2:print('at 2: ' .. time.step)"});
    CHECK(run.status == 0);
    CHECK(run.out == "main\nstart\none\ta,b\ntwo\nat 1: 0\nat 2: 1\n");
}

TEST_CASE("quit ends a headless run with its status") {
    const Folder folder;
    const std::string game =
        folder.write("a.lua", "function step() if time.step == 5 then quit(7) end end");
    const Outcome run = fettle(folder, {"run", game, "--headless"});
    CHECK(run.status == 7);
}

TEST_CASE("an uncaught error ends a headless run with 1 and its traceback") {
    const Folder folder;
    const std::string where =
        GENERATE("load", "start", "update", "step", "timer", "watcher", "eval", "at");
    const std::string bad = "function bad() local lives = 3; error('it broke') end ";
    std::string script = bad;
    std::vector<std::string> extra;
    if (where == "load") script += "bad()";
    if (where == "start") script += "function start() bad() end";
    if (where == "update") script += "function update() bad() end";
    if (where == "step") script += "function step() bad() end";
    if (where == "timer") script += "after(0.01, bad)";
    if (where == "watcher")
        script +=
            "game.o = Object {} game.o.n = 1 game.o:watch('n', bad) function update() game.o.n = 2 "
            "end";
    if (where == "eval") extra = {"--eval", "bad()"};
    if (where == "at") extra = {"--at", "2:bad()"};
    script += " function draw() end";
    std::vector<std::string> arguments{
        "run",  folder.write("main.lua", script), "--headless", "--steps", "5",
        "--at", "4:print('still running')"};
    arguments.insert(arguments.end(), extra.begin(), extra.end());
    const Outcome run = fettle(folder, arguments);
    INFO(where << "\n" << run.out << run.err);
    CHECK(run.status == 1);
    CHECK(contains(run.err, "it broke"));
    CHECK(contains(run.err, "main.lua:1"));
    CHECK(contains(run.err, "traceback"));
    CHECK(run.out.empty());
}

TEST_CASE("an error that many instances have is reported once with their number") {
    const Folder folder;
    const std::string bricks =
        "Brick = class('Brick', Object) {} "
        "for i = 1, 20 do world:add(Brick { props = { n = i } }) end ";
    const auto count = [](const std::string& text, const std::string& part) {
        int found = 0;
        for (std::size_t at = text.find(part); at != std::string::npos;
             at = text.find(part, at + 1))
            ++found;
        return found;
    };
    const auto [script, last] = GENERATE(table<std::string, std::string>({
        {"function Brick:ready() local lives = self.n .. {} end", "ready of world.brick_20"},
        {"function Brick:step() local lives = self.n .. {} end", "Brick:step of world.brick_20"},
        {"function Brick:ready() self.m = formula(function() return self.n .. {} end) end",
         "formula of world.brick_20.m"},
        {"function Brick:ready() return self.lifes end", "ready of world.brick_20"},
    }));
    const Outcome run = fettle(
        folder, {"run", folder.write("main.lua", bricks + script), "--headless", "--steps", "3"});
    INFO(script << "\n" << run.err);
    CHECK(count(run.err, "error in ") == 1);
    CHECK(contains(run.err, "world.brick_1"));
    CHECK(contains(run.err, "main.lua:1: the same error 19 more times, last in " + last));
}

TEST_CASE("a formula in error is reported once and the run continues") {
    const Folder folder;
    const std::string game =
        folder.write("main.lua",
                     "world.a = Body {} world.b = Body {}\n"
                     "world.a.mass = formula(function() error('formula broke') end)\n"
                     "world.b.mass = formula(function() return 0/0 end)\n");
    const Outcome run =
        fettle(folder, {"run", game, "--headless", "--steps", "20", "--at", "20:print('end')"});
    CHECK(run.status == 0);
    CHECK(run.out == "end\n");
    CHECK(run.err ==
          "error in formula of world.a.mass: main.lua:2: formula broke\n"
          "error in formula of world.b.mass: world.b.mass: expected a number of at least 1e-30 kg, "
          "got nan\n");
}

TEST_CASE("a script may begin with a byte order mark and compiled Lua is refused") {
    const Folder folder;
    folder.write("part.lua", "\xEF\xBB\xBFreturn 'part'");
    std::string game = folder.write("main.lua", "\xEF\xBB\xBFprint(require 'part')");
    Outcome run = fettle(folder, {"run", game, "--headless", "--steps", "1"});
    CHECK(run.status == 0);
    CHECK(run.out == "part\n");
    folder.write("part.lua", "\x1BLua");
    run = fettle(folder, {"run", game, "--headless", "--steps", "1"});
    CHECK_THAT(run.err, contains("part.lua: this is compiled Lua, which is not loaded"));
    game = folder.write("main.lua", "\x1BLuaT");
    run = fettle(folder, {"run", game, "--headless", "--steps", "1"});
    CHECK(run.status == 1);
    CHECK_THAT(run.err, contains("main.lua: this is compiled Lua, which is not loaded"));
}

TEST_CASE("the traceback of a timer function begins at the timer") {
    const Folder folder;
    const std::string game = folder.write("main.lua",
                                          "after(0, function() error('late') end)\n"
                                          "function start() print('started') end\n");
    const Outcome run = fettle(folder, {"run", game, "--headless", "--steps", "5"});
    CHECK_THAT(run.err, contains("main.lua:1: late"));
    CHECK_THAT(run.err, !contains("coroutine started from"));
}

TEST_CASE("a file that cannot be read is named and gives status 3") {
    const Folder folder;
    const Outcome missing =
        fettle(folder, {"run", (folder / "no.lua").string(), "--headless", "--steps", "1"});
    CHECK(missing.status == 3);
    CHECK(contains(missing.err, "no.lua"));
    fs::create_directory(folder / "empty");
    const Outcome empty =
        fettle(folder, {"run", (folder / "empty").string(), "--headless", "--steps", "1"});
    CHECK(empty.status == 3);
    CHECK(contains(empty.err, "main.lua"));
}

TEST_CASE("errors of the command line are explained and give status 2") {
    const Folder folder;
    const std::string game = folder.write("a.lua", "");
    const std::vector<std::vector<std::string>> wrong{
        {},
        {"fly"},
        {"run", game, "--headless"},
        {"run", game, "--headless", "--steps", "-1"},
        {"run", game, "--headless", "--steps", "many"},
        {"run", game, "--headless", "--steps", "1", "--at", "print(1)"},
        {"run", game, "--headless", "--steps", "1", "--at", "0:print(1)"},
        {"run", game, "--headless", "--steps", "1", "--record"},
        {"run", game, "--headless", "--steps", "1", "--sandpit"},
        {"run", game, "--headless", "--steps", "1", "--screenshot", (folder / "a.png").string()},
        {"run", game, "--steps", "1"},
    };
    for (const auto& arguments : wrong) {
        const Outcome run = fettle(folder, arguments);
        std::string all;
        for (const std::string& argument : arguments) all += argument + " ";
        INFO(all);
        CHECK(run.status == 2);
        CHECK_FALSE(run.err.empty());
    }
}

TEST_CASE("help and version end with status 0") {
    const Folder folder;
    const Outcome all = fettle(folder, {"--help"});
    CHECK(all.status == 0);
    CHECK(contains(all.out, "The guide: "));
    CHECK(contains(all.out, "guide/README.md"));
    const Outcome help = fettle(folder, {"run", "--help"});
    CHECK(help.status == 0);
    CHECK(contains(help.out, "--headless"));
    const Outcome version = fettle(folder, {"--version"});
    CHECK(version.status == 0);
    for (const char* part : {"fettle ", "module interface", "SIMD width", "SFML", "Lua ", "Eigen",
                             "Dear ImGui", "SQLite", "compiler"}) {
        INFO(part);
        CHECK(contains(version.out, part));
    }
}

TEST_CASE("the help of run names the limits of memory that a trusted game has") {
    const Folder folder;
    CHECK(contains(fettle(folder, {"run", "--help"}).out, "512 and 2048"));
}

TEST_CASE("the same run has the same hash and another seed gives another hash") {
    const Folder folder;
    const std::string game =
        folder.write("a.lua", "game.luck = 0 function step() game.luck = game.luck + random() end");
    const auto hash = [&](const std::string& seed) {
        const Outcome run =
            fettle(folder, {"run", game, "--headless", "--steps", "20", "--seed", seed, "--hash"});
        CHECK(run.status == 0);
        return run.out;
    };
    const std::string first = hash("1");
    CHECK(first.size() == 17);
    CHECK(first.find_first_not_of("0123456789abcdef\n") == std::string::npos);
    CHECK(hash("1") == first);
    CHECK(hash("2") != first);
}

TEST_CASE("a chunk for a step that is never made is reported") {
    const Folder folder;
    const std::string game = folder.write("a.lua", "");
    const Outcome run =
        fettle(folder, {"run", game, "--headless", "--steps", "3", "--at", "9:print(1)"});
    CHECK(run.status == 0);
    CHECK(contains(run.err, "--at 9"));
}

TEST_CASE("a paused headless run still ends and a chunk can end the pause") {
    const Folder folder;
    const std::string game = folder.write("a.lua", "time.paused = true");
    const Outcome run = fettle(folder, {"run", game, "--headless", "--steps", "10", "--at",
                                        "4:time.paused = false", "--at", "10:print(time.step)"});
    CHECK(run.status == 0);
    CHECK(run.out == "6\n");
}

TEST_CASE("an invalid module ends the run before its first step") {
    const Folder folder;
    const std::string game = folder.write("game/main.lua", "print('begun')");
    const auto run = [&](const std::vector<std::string>& more) {
        std::vector<std::string> all = {"run", game, "--headless", "--steps", "1"};
        all.insert(all.end(), more.begin(), more.end());
        const Outcome outcome = fettle(folder, all);
        CHECK(outcome.status == 3);
        CHECK(!contains(outcome.out, "begun"));
        return outcome.err;
    };
    CHECK(contains(run({"--module", "nowhere.so"}), "nowhere.so: there is no such file"));
    CHECK(contains(run({"--module", "nowhere"}), "module \"nowhere\": there is neither"));
    CHECK(contains(run({"--module", game}), "expected a shared object"));
    folder.write("game/modules.json", "{ \"modules\": [ 3 ] }");
    CHECK(contains(run({}), "modules.json:1:16: modules: expected a text, found an integer (3)"));
    folder.write("game/modules.json", "{ \"modules\": [ ");
    CHECK(contains(run({}), "modules.json:1:"));
    folder.write("game/modules.json", "{\n \"module\": [] }");
    CHECK(contains(run({}),
                   "modules.json:2:2: module: there is no such setting (did you mean "
                   "\"modules\"?)"));
    for (const char* const other : {"{}", "[]", "3"}) {
        folder.write("game/modules.json", other);
        CHECK(contains(run({}), "modules.json:1:1: expected { \"modules\": ["));
    }
    folder.write("game/modules.json", "{ \"modules\": 3 }");
    CHECK(contains(run({}), "modules.json:1:14: modules: expected a list of texts, found"));
    folder.write("game/modules.json", "{ \"modules\": [\n  \"nowhere\" ] }");
    CHECK(contains(run({}), "modules.json:2:3: module \"nowhere\": there is neither"));
    folder.write("game/modules.json", "{ \"modules\": [\n  \"./main.lua\" ] }");
    CHECK(contains(run({}), "modules.json:2:3: "));
}

TEST_CASE("chunks run at their step of the run even if the time of the game was set back") {
    const Folder folder;
    const std::string game = folder.write("a.lua", R"(
        function step()
            if time.step == 20 and not done then done = true rewind(0.25) end
        end)");
    const Outcome run = fettle(
        folder, {"run", game, "--headless", "--steps", "40", "--at", "5:print('at 5', time.step)",
                 "--at", "20:print('at 20', time.step)", "--at", "30:print('at 30', time.step)",
                 "--at", "41:print('never')", "--eval", "done = false"});
    CHECK(run.status == 0);
    CHECK(run.out == "at 5\t4\nat 20\t19\nat 30\t14\n");
    CHECK(run.err == "fettle: --at 41 was never reached: the run ended with its step 40\n");
}

TEST_CASE("missing files are reported also if nothing is drawn") {
    const Folder folder;
    folder.write("game/main.lua",
                 "game.title = Text { text = 'hi', font = 'a.ttf' }\n"
                 "world.hero = Body { look = Sprite { image = 'b.png' } }\n"
                 "game.smoke = Emitter { image = 'c.png' } view.effect = 'd.frag'\n"
                 "game.map = Tilemap { map = 'e.tmj' } Sprite { image = 'f.png' }");
    const Outcome run =
        fettle(folder, {"run", (folder / "game").string(), "--headless", "--steps", "2"});
    for (const char* what : {"error in files: title.font: there is no file \"a.ttf\"",
                             "error in files: world.hero.look.image: there is no file \"b.png\"",
                             "error in files: smoke.image: there is no file \"c.png\"",
                             "error in files: view.effect: there is no file \"d.frag\"",
                             "error in files: map.map: there is no file \"e.tmj\"",
                             "(detached sprite).image: there is no file \"f.png\""}) {
        CAPTURE(what, run.err);
        CHECK(contains(run.err, what));
    }
}

TEST_CASE("wrong arguments of a command name its own help") {
    const Folder folder;
    for (const std::string command : {"run", "test", "new", "where", "package", "repl", "docs"}) {
        INFO(command);
        for (const Outcome& done : {fettle(folder, {command, "--no-such-option", "nowhere"}),
                                    fettle(folder, {command, "nowhere", "a", "b", "c"})}) {
            CHECK(done.status == 2);
            CHECK(contains(done.err, "(fettle " + command + " --help tells more)"));
        }
    }
    const std::string of_run =
        fettle(folder, {"run", "nowhere", "--steps", "1", "--steps", "2"}).err;
    CHECK(contains(of_run, "(fettle run --help tells more)"));
    CHECK(contains(fettle(folder, {"rum"}).err, "(fettle --help tells more)"));
    CHECK(contains(fettle(folder, {}).err, "(fettle --help tells more)"));
}

}  // namespace run_test
