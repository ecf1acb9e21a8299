// Saved games with the program: one run saves, another one loads and continues.

#include <catch.h>

#include <fstream>

#include "program.h"

namespace saves_test {

using namespace program_test;
namespace fs = std::filesystem;

namespace {

const char* const game = R"lua(
world.floor = Body { type = "static", position = vec(0, -1), Box { width = 40, height = 2 } }
for i = 1, 12 do
    world["ball" .. i] = Body { position = vec(random() * 4 - 2, 2 * i), angular_velocity = i,
        Circle { radius = 0.4, restitution = 0.5, friction = 0.3 } }
end
world.score = 0
world.double = formula(function() return world.score * 2 end)
function step() world.score = world.score + 1 end
)lua";

/// The only file below the folder whose name has this ending.
fs::path file_of(const Folder& folder, const std::string& ending) {
    fs::path found;
    for (const auto& each : fs::recursive_directory_iterator(folder / ""))
        if (each.path().string().ends_with(ending)) {
            CHECK(found.empty());
            found = each.path();
        }
    return found;
}

}  // namespace

TEST_CASE("a saved game continues in another run as if it had never stopped") {
    const Folder folder;
    const std::string file = folder.write("main.lua", game);
    const Outcome whole = fettle(folder, {"run", file, "--headless", "--steps", "180", "--hash",
                                          "--at", "61:save_game('half way')"});
    INFO(whole.err);
    REQUIRE(whole.status == 0);
    REQUIRE(whole.out.size() == 17);
    const Outcome rest =
        fettle(folder, {"run", file, "--headless", "--steps", "120", "--seed", "99", "--hash",
                        "--eval", "world.floor.position = vec(5, 5) load_game('half way')", "--at",
                        "2:print(time.step, world.score, world.double, world.floor.position.x)"});
    INFO(rest.err);
    CHECK(rest.status == 0);
    CHECK(rest.out == "61\t61\t122\t0.0\n" + whole.out);
}

TEST_CASE("saved games are listed and deleted by their slots") {
    const Folder folder;
    const std::string file = folder.write("main.lua", game);
    const Outcome run = fettle(
        folder,
        {"run", file, "--headless", "--steps", "9", "--at", "2:save_game('b') save_game('a')",
         "--at", "4:for _, s in ipairs(saves()) do print(s.slot, s.step, s.picture, s.problem) end",
         "--at", "5:delete_save('a') print(#saves(), saves()[1].slot)", "--at",
         "6:print(pcall(load_game, 'bb'))", "--at", "7:print(pcall(save_game, '../b'))"});
    INFO(run.err);
    CHECK(run.status == 0);
    CHECK(contains(run.out, "a\t1\tnil\tnil\nb\t1\tnil\tnil\n1\tb\n"));
    CHECK(contains(run.out, "there is no saved game \"bb\" (did you mean \"b\"?)"));
    CHECK(contains(run.out, "is not a name of a slot"));
}

TEST_CASE("loading a game reports which handlers its file could not hold") {
    const Folder folder;
    const std::string file = folder.write("main.lua", R"lua(
class("Stays", Button) {}
function Stays:pressed() print("stays") end
function start() world.box = Body { Circle {} } world.box:watch("position", function() end) end
function open() game.menu = Panel { Button { name = "save", pressed = function() end },
    Button { name = "quit", pressed = function() end }, Stays { name = "stays" } } end
)lua");
    const Outcome run =
        fettle(folder, {"run", file, "--headless", "--steps", "9", "--at",
                        "2:open() save_game('a')", "--at", "4:game.menu:delete() load_game('a')"});
    CHECK(run.status == 0);
    CHECK(contains(run.err,
                   "the saved game \"a\": menu.save and 1 more: the functions that were "
                   "given to them as handlers are gone"));
    // Instances that exist in both moments keep their handlers.
    const Outcome kept = fettle(folder, {"run", file, "--headless", "--steps", "9", "--at",
                                         "2:save_game('b')", "--at", "4:load_game('b')"});
    CHECK(kept.err == "");
    const Outcome other =
        fettle(folder, {"run", file, "--headless", "--steps", "9", "--at", "2:load_game('a')"});
    CHECK(contains(other.err, "menu.save and 1 more"));
}

TEST_CASE("loading a game reports which timers its file could not hold") {
    const Folder folder;
    const std::string file = folder.write("main.lua", R"lua(
every(5, print)
function later() world.box = Body {} after(3, function() print("once") end)
    world.box:every(1, function() end) end
)lua");
    const auto run = [&](const char* second, const char* fourth) {
        return fettle(folder, {"run", file, "--headless", "--steps", "9", "--at",
                               std::string("2:") + second, "--at", std::string("4:") + fourth});
    };
    const std::string told =
        "the saved game \"a\": 2 timers that the game had when it was saved ended, since a file "
        "holds no functions: main.lua:4, main.lua:3";
    const Outcome same = run("later() save_game('a')", "load_game('a')");
    INFO(same.err);
    CHECK(contains(same.err, told));
    CHECK(contains(run("print()", "load_game('a')").err, told));
    CHECK(run("save_game('b')", "load_game('b')").err == "");
}

TEST_CASE("timers that call a method of their owner go on after loading a game") {
    const Folder folder;
    const std::string file = folder.write("main.lua", R"lua(
Gun = class("Gun", Object) { shots = 0, burst = 0 }
Big = class("Big", Gun) {}
function Gun:fire() self.shots = self.shots + 1 end
function Gun:volley() self.burst = self.burst + 1 end
function Gun:ready() self:every(0.05, self.fire) self:after(0.2, self.volley) end
function Big:fire() self.shots = self.shots + 100 end
function step()
    if time.step == 26 then print(world.gun.shots, world.gun.burst, world.big.shots) end
end
)lua");
    const auto run = [&](const std::vector<std::string>& commands) {
        std::vector<std::string> arguments = {"run", file, "--headless", "--steps", "50"};
        for (const std::string& each : commands) arguments.insert(arguments.end(), {"--at", each});
        return fettle(folder, arguments);
    };
    const Outcome whole =
        run({"2:world.gun, world.big = Gun {}, Big {}", "7:save_game('a')", "40:load_game('a')"});
    INFO(whole.out << whole.err);
    CHECK(whole.err == "");
    CHECK(whole.out == "8\t1\t800\n");
    const Outcome again = run({"2:world.gun, world.big = Gun {}, Big {}", "20:load_game('a')"});
    INFO(again.out << again.err);
    CHECK(again.err == "");
    CHECK(again.out == whole.out);
    const Outcome other = run({"2:load_game('a')"});
    INFO(other.out << other.err);
    CHECK(other.err == "");
    CHECK(other.out == whole.out);
}

TEST_CASE("loading a game reports which coroutines its file could not hold") {
    const Folder folder;
    const std::string file = folder.write("main.lua", R"lua(
game:run(function() while true do wait(1) end end)
function later() world.lift = Body {}
    world.lift:run(function(lift) while true do wait(1) end end) end
)lua");
    const auto run = [&](const char* second, const char* fourth) {
        return fettle(folder, {"run", file, "--headless", "--steps", "9", "--at",
                               std::string("2:") + second, "--at", std::string("4:") + fourth});
    };
    const std::string told =
        "the saved game \"a\": 1 coroutine that waited when the game was saved did not go back, "
        "since a file holds no functions; what has begun in this run goes on where it was: "
        "main.lua:4";
    CHECK(contains(run("later() save_game('a')", "load_game('a')").err, told));
    CHECK(contains(run("print()", "load_game('a')").err, told));
    CHECK(run("save_game('b')", "load_game('b')").err == "");
}

TEST_CASE("a variable of a saved game that has another type now stays and is reported") {
    const Folder folder;
    const std::string file = folder.write("main.lua", "state('best', 3) best = 7");
    const std::vector<std::string> load = {
        "run",  file,           "--headless", "--steps", "9", "--at", "2:load_game('a')",
        "--at", "4:print(best)"};
    REQUIRE(fettle(folder, {"run", file, "--headless", "--steps", "4", "--at", "2:save_game('a')"})
                .status == 0);
    folder.write("main.lua", "state('best', 2.5)");
    const Outcome number = fettle(folder, load);
    CHECK(number.err == "");
    CHECK(number.out == "7\n");
    folder.write("main.lua", "state('best', {0, 0})");
    const Outcome list = fettle(folder, load);
    INFO(list.err);
    CHECK(list.out == "7\n");
    CHECK(contains(list.err,
                   "game.best is 7 (integer) from before, and state(\"best\", ...) "
                   "begins it as {0, 0} (list) now: the old value stays"));
}

TEST_CASE("a button that closes its menu and saves leaves nothing of the menu in the save") {
    const Folder folder;
    const std::string file = folder.write("main.lua", R"lua(
game.menu = Panel { modal = true, Button { text = "Save", pressed = function()
    game.menu:delete()
    save_game("a")
end } }
)lua");
    const Outcome run =
        fettle(folder, {"run", file, "--headless", "--steps", "30", "--at",
                        "2:input.keys.enter = true", "--at", "4:input.keys.enter = false", "--at",
                        "8:load_game('a')", "--at", "12:print(game:has('menu'), interface.focus)"});
    CHECK(run.err == "");
    CHECK(run.out == "false\tnil\n");
}

TEST_CASE("a saved game that is damaged is refused and the game continues") {
    const Folder folder;
    const std::string file = folder.write("main.lua", game);
    REQUIRE(fettle(folder, {"run", file, "--headless", "--steps", "9", "--at", "2:save_game('a')"})
                .status == 0);
    const fs::path save = file_of(folder, "a.sqlite");
    REQUIRE_FALSE(save.empty());
    std::ifstream in(save, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(in), {}};
    bytes[bytes.size() / 2] ^= 1;
    std::ofstream(save, std::ios::binary) << bytes;
    const Outcome run = fettle(folder, {"run", file, "--headless", "--steps", "20", "--at",
                                        "5:print(pcall(load_game, 'a')) print(saves()[1].problem)",
                                        "--at", "20:print(world.score)"});
    INFO(run.err);
    CHECK(run.status == 0);
    CHECK(contains(run.out, "a.sqlite: cannot be loaded: it is damaged"));
    CHECK(run.out.ends_with("\n19\n"));
}

TEST_CASE("a save with other classes is refused and the game continues") {
    const Folder folder;
    const std::string file = folder.write("main.lua", game);
    REQUIRE(fettle(folder, {"run", file, "--headless", "--steps", "5", "--eval",
                            "Lamp = class('Lamp', Object) { lit = true } world.lamp = Lamp {}",
                            "--at", "2:save_game('a')"})
                .status == 0);
    const Outcome run =
        fettle(folder, {"run", file, "--headless", "--steps", "9", "--at",
                        "3:print(pcall(load_game, 'a'))", "--at", "9:print(world.score)"});
    INFO(run.out << run.err);
    CHECK(run.status == 0);
    CHECK(contains(run.out, "the saved game \"a\" cannot be loaded: "));
    CHECK(contains(run.out, "Lamp"));
    CHECK(run.out.ends_with("\n8\n"));
}

TEST_CASE(
    "a formula that uses a local variable is reported and the running game's formula is used after "
    "a load") {
    const Folder folder;
    const std::string file = folder.write("main.lua", R"(
        local factor = 2
        game.o = Object {}
        game.o.steps = 0
        game.o.double = formula(function() return game.o.steps * factor end)
        function step() game.o.steps = game.o.steps + 1 end
    )");
    const Outcome saved = fettle(folder, {"run", file, "--headless", "--steps", "9", "--at",
                                          "4:save_game('a')", "--at", "6:save_game('a')"});
    CHECK(saved.status == 0);
    const std::string reported = "o.double: its formula uses the local variable \"factor\"";
    CHECK(contains(saved.err, reported));
    CHECK(saved.err.find(reported) == saved.err.rfind(reported));
    const Outcome run =
        fettle(folder, {"run", file, "--headless", "--steps", "9", "--at", "2:load_game('a')",
                        "--at", "9:print(game.o.double / game.o.steps)"});
    INFO(run.out << run.err);
    CHECK(run.status == 0);
    CHECK(run.out == "2.0\n");
    const Outcome without =
        fettle(folder, {"run", file, "--headless", "--steps", "9", "--at",
                        "2:game.o.double = 0 load_game('a')", "--at", "9:print(game.o.double)"});
    CHECK(without.out == "10\n");
    CHECK(contains(without.err, "o.double: its formula was not saved"));
}

TEST_CASE("a save that cannot be written is reported and the older one stays") {
    const Folder folder;
    const std::string file = folder.write("main.lua", game);
    REQUIRE(fettle(folder, {"run", file, "--headless", "--steps", "5", "--at", "4:save_game('a')"})
                .status == 0);
    const Outcome full =
        fettle(folder,
               {"run", file, "--headless", "--steps", "9", "--at", "2:save_game('a')", "--at",
                "9:print(saves()[1].step, world.score)"},
               "trap '' XFSZ; ulimit -f 8; ");
    INFO(full.err);
    CHECK(full.status == 0);
    CHECK(full.out == "3\t8\n");
    CHECK(contains(full.err, "the game was not saved: "));
    CHECK(contains(full.err, "could not be written"));
}

}  // namespace saves_test
