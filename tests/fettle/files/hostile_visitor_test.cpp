// A hostile game, a full disk and unusual arguments: the program reports the problem in one line
// and ends, and it neither reads nor writes anything outside of the folder of the game.

#include <catch.h>
#include <sys/stat.h>

#include <fstream>

#include "program.h"

namespace hostile_visitor_test {

using namespace program_test;
namespace fs = std::filesystem;

namespace {

Outcome play(const Folder& folder, const std::string& game, std::vector<std::string> more = {},
             const std::string& before = {}) {
    std::vector<std::string> all = {"run", (folder / game).string(), "--headless", "--steps", "3"};
    all.insert(all.end(), more.begin(), more.end());
    return fettle(folder, all, before);
}

// The address sanitizer reserves more address space than any limit allows.
#ifdef __SANITIZE_ADDRESS__
constexpr bool memory_can_be_limited = false;
#else
constexpr bool memory_can_be_limited = true;
#endif
/// A shell command that limits the address space of the commands after it, in KiB.
std::string limited_memory(int kibibytes) {
    return memory_can_be_limited ? "ulimit -v " + std::to_string(kibibytes) + "; " : "";
}

std::size_t lines(const std::string& text) {
    return static_cast<std::size_t>(std::count(text.begin(), text.end(), '\n'));
}

void pipe_at(const fs::path& where) {
    fs::create_directories(where.parent_path());
    REQUIRE(::mkfifo(where.c_str(), 0666) == 0);
}

}  // namespace

// --- The command line

TEST_CASE("an invalid argument is reported in one line with the expected form") {
    const Folder folder;
    const std::string game = folder.write("a.lua", "print('played')");
    struct Wrong {
        std::vector<std::string> arguments;
        std::string reported;
    };
    const std::string number = "expected a whole number from ";
    const std::vector<Wrong> all = {
        {{"brew", "x"},
         "\"brew\" is not a command; there are run, test, new, where, package, repl, docs"},
        {{"rnu", game},
         "\"rnu\" is not a command; there are run, test, new, where, package, repl, docs (did you "
         "mean \"run\"?)"},
        {{""}, "\"\" is not a command"},
        {{game}, "\"" + game + "\" is not a command; fettle run " + game + " plays a game"},
        {{"\x1b[31m"}, "\"\\x1b[31m\" is not a command"},
        {{"--steps", "3"}, "\"--steps\" is not an option of fettle"},
        {{"run", game, "--stesp", "3"},
         "\"--stesp\" is not an option of run (did you mean \"--steps\"?)"},
        {{"run", game, "more"}, "\"more\" is one argument too many"},
        {{"run", ""}, "path: expected a folder with main.lua, or a .lua file, got an empty text"},
        {{"run", game, "--steps"}, "--steps: it takes one value, once"},
        {{"run", game, "--steps", "1", "--steps", "2"}, "--steps: it takes one value, once"},
        {{"docs"}, "folder is required"},
        {{"docs", ""}, "folder: expected a folder, got an empty text"},
    };
    for (const Wrong& each : all) {
        const Outcome run = fettle(folder, each.arguments);
        INFO(each.reported << "\n" << run.err);
        CHECK(run.status == 2);
        CHECK(run.out.empty());
        CHECK(run.err.starts_with("fettle: " + each.reported));
        CHECK(lines(run.err) == 1);
        CHECK(run.err.size() < 200);
    }
    const std::vector<std::string> no_numbers = {"",
                                                 "-1",
                                                 "1e20",
                                                 "1e3",
                                                 "many",
                                                 "nan",
                                                 "inf",
                                                 "0x10",
                                                 "3.5",
                                                 " 3",
                                                 "3 ",
                                                 "+3",
                                                 "-",
                                                 "٣",
                                                 std::string(400, '9'),
                                                 "18446744073709551616"};
    for (const char* const option : {"--steps", "--seed"})
        for (const std::string& text : no_numbers) {
            const Outcome run = fettle(folder, {"run", game, "--headless", option, text});
            INFO(option << " " << text << "\n" << run.err);
            CHECK(run.status == 2);
            CHECK(run.err.starts_with(std::string("fettle: ") + option + ": " + number));
            CHECK(lines(run.err) == 1);
            CHECK(run.err.size() < 250);
        }
    for (const char* const option : {"--at", "--console"})
        for (const char* const text : {"", "3", ":", "3:", "0:x", "-1:x", "x:y", "1e3:x", ":x"}) {
            const Outcome run =
                fettle(folder, {"run", game, "--headless", "--steps", "1", option, text});
            INFO(option << " " << text << "\n" << run.err);
            CHECK(run.status == 2);
            CHECK(run.err.starts_with(std::string("fettle: ") + option + ": expected "));
            CHECK(lines(run.err) == 1);
        }
    for (const char* const option :
         {"--eval", "--module", "--screenshot", "--record", "--replay"}) {
        const Outcome run = fettle(folder, {"run", game, "--headless", "--steps", "1", option, ""});
        INFO(option << "\n" << run.err);
        CHECK(run.status == 2);
        CHECK(run.err.starts_with(std::string("fettle: ") + option + ": expected "));
        CHECK(lines(run.err) == 1);
    }
    CHECK(fettle(folder, {"run", game, "--headless", "--steps", "1", "--screenshot", "a.txt"})
              .status == 2);
}

// --- Control characters

TEST_CASE("control characters in messages are escaped") {
    const Folder folder;
    const std::string evil = "\x1b]0;owned\x07\x1b[31m\xc2\x9b\xff";
    folder.write("main.lua", "error('" + evil + "')");
    const Outcome run = play(folder, "main.lua");
    CHECK(run.status == 1);
    CHECK(contains(run.err, "\\x1b]0;owned\\x07\\x1b[31m\\xc2\\x9b\\xff"));
    CHECK_FALSE(contains(run.err, "\x1b"));
    const Outcome missing = play(folder, "no\x1b[2J\ngame.lua");
    CHECK(missing.status == 3);
    CHECK(contains(missing.err, "no\\x1b[2J\\ngame.lua: there is no such file or folder\n"));
    CHECK(lines(missing.err) == 1);
    // The output of a game into a pipe is not changed.
    folder.write("print.lua", "print('" + evil + "')");
    CHECK(play(folder, "print.lua").out == evil + "\n");
}

TEST_CASE("the output of a game to a terminal contains no control characters") {
    const Folder folder;
    folder.write("print.lua", "print('a\\27[31mb', 'tab\\tend') print('two\\nlines')");
    // `script` gives the program a terminal; it turns each line end into two characters.
    const std::string command =
        "script -qec " +
        quoted(quoted(FETTLE_PROGRAM) + " run " + quoted((folder / "print.lua").string()) +
               " --headless --steps 1") +
        " /dev/null >" + quoted((folder / "out").string()) + " 2>/dev/null </dev/null";
    if (std::system("command -v script >/dev/null") != 0) {
        WARN("script is not here: nothing is tested");
        return;
    }
    CHECK(std::system(command.c_str()) == 0);
    CHECK(folder.text("out") == "a\\x1b[31mb\ttab\tend\r\ntwo\r\nlines\r\n");
}

// --- Special files

TEST_CASE("pipes and folders in the place of files of a game are refused at once") {
    const std::string limited = "timeout 20 ";
    const auto refused = [&](const char* name, const std::string& reported,
                             const std::string& script) {
        const Folder folder;
        if (std::string(name) != "main.lua") folder.write("game/main.lua", script);
        pipe_at(folder / ("game/" + std::string(name)));
        const Outcome run = play(folder, "game", {}, limited);
        INFO(name << "\n" << run.out << run.err);
        CHECK(run.status != 124);
        CHECK(contains(run.err + run.out, reported));
        return run.status;
    };
    CHECK(refused("main.lua", "main.lua: expected a file with a script, found a pipe", "") == 3);
    CHECK(refused("modules.json", "modules.json: could not be read: it is a pipe", "") == 3);
    CHECK(refused("main.tweaks.json", "main.tweaks.json: could not be read: it is a pipe", "") ==
          0);
    CHECK(refused(".fettle",
                  ".fettle: expected a folder for the journal of tweaks, but it is a pipe",
                  "") == 0);
    CHECK(refused(".fettle/main.tweaks.sqlite", "cannot be used: it is a pipe", "") == 0);
    CHECK(refused("level.json", "level.json: could not be read: it is a pipe",
                  "scene.load('level.json')") == 1);
    CHECK(refused("level.json", "level.json: could not be read: it is a pipe",
                  "scene.save('level.json', Object {})") == 1);
    CHECK(refused("more.lua", "more.lua: could not be read: it is a pipe", "require 'more'") == 1);
    CHECK(refused("other.lua", "", "quit()") == 0);
    const Folder folder;
    folder.write("odd/main.lua/inside.txt", "");
    const Outcome odd = play(folder, "odd", {}, limited);
    CHECK(odd.status == 3);
    CHECK(contains(odd.err, "main.lua: expected a file with a script, found a folder"));
    folder.write("game/main.lua", "");
    pipe_at(folder / "pipe.png");
    for (const char* const option : {"--record", "--replay", "--module", "--screenshot"}) {
        const Outcome run = play(folder, "game", {option, (folder / "pipe.png").string()}, limited);
        INFO(option << "\n" << run.err);
        CHECK((run.status == 3 || run.status == 2));
        CHECK((contains(run.err, "found a pipe") || contains(run.err, "needs a display")));
    }
    // A run without --steps searches the scripts for a word.
    pipe_at(folder / "game/pipe.lua");
    CHECK(fettle(folder, {"run", (folder / "game").string(), "--headless"}, limited).status == 2);
}

TEST_CASE("huge and deeply nested files are refused without being read") {
    const Folder folder;
    const auto huge = [&](const char* name) {
        folder.write(name, "x");
        fs::resize_file(folder / name, std::uintmax_t{10} << 30);
    };
    const std::string small_memory = limited_memory(2'000'000);
    huge("main.lua");
    Outcome run = play(folder, "main.lua", {}, small_memory);
    CHECK(run.status == 3);
    CHECK(contains(run.err, "main.lua: could not be read: it is larger than 64 MB"));
    huge("game/level.json");
    folder.write("game/main.lua", "scene.load('level.json')");
    run = play(folder, "game", {}, small_memory);
    CHECK(run.status == 1);
    CHECK(contains(run.err, "level.json: could not be read: it is larger than 64 MB"));
    folder.write("game/main.lua", "");
    huge("game/modules.json");
    CHECK(play(folder, "game", {}, small_memory).status == 3);
    for (const char bracket : {'[', '{'}) {
        folder.write("game/modules.json", std::string(5'000'000, bracket));
        run = play(folder, "game", {}, small_memory);
        CHECK(run.status == 3);
        CHECK(contains(run.err, "modules.json:1:"));
    }
}

// --- Links

TEST_CASE("links in a game that lead out of its folder are refused") {
    const Folder folder;
    folder.write("outside/secret.lua", "print('read')");
    folder.write("outside/secret.json", "{\"fettle_scene\": 1, \"class\": \"Object\"}");
    folder.write("outside/main.tweaks.json", "{\"fettle_tweaks\": 1}");
    folder.write("game/main.lua", R"(
        game.o = Object {} game.o.x = 1
        for _, f in ipairs{"link.json", "sub/secret.json", "../outside/secret.json"} do
            print(pcall(scene.load, f)) print(pcall(scene.save, f, game.o))
        end
        print(pcall(require, "link")) print(pcall(require, "sub.secret"))
        edit("x", function() game.o.x = 2 end) keep("**"))");
    fs::create_symlink(folder / "outside/secret.lua", folder / "game/link.lua");
    fs::create_symlink(folder / "outside/secret.json", folder / "game/link.json");
    fs::create_symlink(folder / "outside", folder / "game/sub");
    fs::create_symlink(folder / "outside/main.tweaks.json", folder / "game/main.tweaks.json");
    const Outcome run = play(folder, "game");
    INFO(run.out << run.err);
    CHECK(run.status == 0);
    CHECK_FALSE(contains(run.out, "true"));
    CHECK_FALSE(contains(run.out, "read\n"));
    CHECK(contains(run.out, "leads out of the game's folder"));
    CHECK(folder.text("outside/main.tweaks.json") == "{\"fettle_tweaks\": 1}");
    CHECK(folder.text("outside/secret.json") == "{\"fettle_scene\": 1, \"class\": \"Object\"}");
}

TEST_CASE(
    "a main lua that is a link out of its folder is refused unless the link itself is named") {
    const Folder folder;
    folder.write("real/main.lua", "print(require('beside'))");
    folder.write("real/beside.lua", "return 'beside the file'");
    fs::create_directory(folder / "game");
    fs::create_symlink(folder / "real/main.lua", folder / "game/main.lua");
    const Outcome refused = play(folder, "game");
    CHECK(refused.status == 3);
    CHECK(
        contains(refused.err, "game/main.lua: is a link that leads out of the game's folder, to "));
    const Outcome named = play(folder, "game/main.lua");
    INFO(named.err);
    CHECK(named.status == 0);
    CHECK(named.out == "beside the file\n");
    fs::create_symlink(folder / "nowhere.lua", folder / "dangling.lua");
    CHECK(contains(play(folder, "dangling.lua").err, "dangling.lua: this link leads nowhere"));
}

TEST_CASE("saving a scene replaces only regular files") {
    const Folder folder;
    const std::string script =
        "for _, f in ipairs{'main.lua', 'modules.json', 'notes.json', "
        "'main.tweaks.json', '.x.json', 'game.json'} do "
        "print(pcall(scene.save, f, Object {})) end";
    folder.write("game/main.lua", script);
    folder.write("game/modules.json", "{\"modules\": []}");
    folder.write("game/notes.json", "[1, 2]");
    const Outcome run = play(folder, "game");
    INFO(run.out << run.err);
    CHECK(lines(run.out) == 6);
    CHECK_FALSE(contains(run.out, "true"));
    CHECK(folder.text("game/main.lua") == script);
    CHECK(folder.text("game/modules.json") == "{\"modules\": []}");
    CHECK(folder.text("game/notes.json") == "[1, 2]");
    const Outcome record = play(folder, "game", {"--record", (folder / "game/main.lua").string()});
    CHECK(record.status == 3);
    CHECK(contains(record.err,
                   "main.lua: this file is not a recording, and is not overwritten by one"));
    CHECK(folder.text("game/main.lua") == script);
}

// --- Full disk

TEST_CASE("on a full disk every message names the file") {
    const Folder folder;
    folder.write("game/main.lua",
                 "game.o = Object {} game.o.x = ('x'):rep(100000)\n"
                 "print(pcall(scene.save, 'level.json', game.o)) save_game('slot')\n"
                 "edit('y', function() game.o.y = ('y'):rep(100000) end) keep('**')");
    const Outcome run = play(folder, "game", {}, "ulimit -f 8; ");
    INFO(run.out << run.err);
    CHECK(run.status == 0);
    const std::string why = "a file may not become that large here (File too large)";
    CHECK(contains(run.out, "level.json: could not be written: " + why));
    CHECK(contains(run.out, "main.tweaks.json: could not be written: " + why));
    CHECK(contains(run.err, "the game was not saved: "));
    CHECK(contains(run.err, "slot.sqlite: could not be written: " + why));
    CHECK(contains(
        run.err, "tweaks cannot be journaled: " + (folder / "game/.fettle").string() + ": " + why));
    CHECK(contains(run.err, "1 tweak is lost, since it could not be journaled: "));
    CHECK_FALSE(contains(run.err, "I/O error"));
    for (const auto& each : fs::recursive_directory_iterator(folder / ""))
        CHECK_FALSE(contains(each.path().filename().string(), ".tmp"));
    const Outcome recorded = fettle(folder,
                                    {"run", (folder / "game").string(), "--headless", "--steps",
                                     "300", "--record", (folder / "rec").string()},
                                    "ulimit -f 8; ");
    CHECK(recorded.status == 3);
    CHECK(contains(recorded.err, "rec: the recording ends here: "));
}

TEST_CASE("output that cannot be written is reported") {
    if (!fs::exists("/dev/full")) return;
    const Folder folder;
    folder.write("main.lua", "print('hello')");
    const std::string command = "env -u DISPLAY " + quoted(FETTLE_PROGRAM) + " run " +
                                quoted((folder / "main.lua").string()) +
                                " --headless --steps 1 >/dev/full 2>" +
                                quoted((folder / "err").string());
    CHECK(WEXITSTATUS(std::system(command.c_str())) == 3);
    CHECK(contains(folder.text("err"),
                   "not all of what was printed could be written: No space left"));
}

// --- No memory

TEST_CASE("out of memory is reported with its place and limit", "[long]") {
    const Folder folder;
    folder.write("table.lua", "local t = {}\nfor i = 1, 1e9 do t[i] = ('x'):rep(1000) .. i end");
    const Outcome table = play(folder, "table.lua");
    CHECK(table.status == 1);
    CHECK(contains(table.err, "table.lua:2: not enough memory: "));
    CHECK(contains(table.err, "the scripts of a game may use 512 MB"));
    folder.write("text.lua", "local s = ('x'):rep(100)\nlocal t = s:rep(1e7)");
    const Outcome text = play(folder, "text.lua");
    CHECK(text.status == 1);
    CHECK(contains(text.err, "text.lua:2: "));
    CHECK(contains(text.err, "512 MB"));
    if (!memory_can_be_limited) return;
    folder.write("tree.lua",
                 "game.o = Object {}\nfor i = 1, 1e9 do game.o['p' .. i] = ('x'):rep(100000) end");
    const Outcome tree = play(folder, "tree.lua", {}, limited_memory(600'000));
    INFO(tree.err);
    CHECK(tree.status == 1);
    CHECK(contains(tree.err, "tree.lua:2: "));
    CHECK(contains(tree.err, "not enough memory: "));
    CHECK(contains(tree.err, "the system has none to give"));
    CHECK_FALSE(contains(tree.err, "std::"));
}

}  // namespace hostile_visitor_test
