// A moment of a game in one file.

#include <catch.h>

#include <fstream>
#include <string_view>

#include "program.h"

namespace moment_test {

using namespace program_test;

namespace fs = std::filesystem;

namespace {

constexpr const char* game_text =
    "world.floor = Body { type = 'static', position = vec(0, -1), Box { width = 20, height = 2 } } "
    "for i = 1, 8 do world:add(Body { position = vec(random() * 4, i), Circle {} }) end "
    "function step(dt) world.body_3.velocity = world.body_3.velocity + vec(random() * 0.1, 0) end";

Outcome share(const Folder& folder, const std::string& game, const std::string& name) {
    return fettle(folder, {"run", game, "--headless", "--steps", "60", "--hash",  //
                           "--console", "59:world.body_2.mass = 7",               //
                           "--console", "60:share '" + name + "'"});
}

/// The file that the run says it wrote.
fs::path file_in(const std::string& out) {
    constexpr std::string_view before = " is in ";
    const std::size_t begin = out.find(before), end = out.find("; fettle run", begin);
    if (begin == std::string::npos || end == std::string::npos) return {};
    return out.substr(begin + before.size(), end - begin - before.size());
}

std::string last_line(const std::string& out) {
    return out.substr(out.rfind('\n', out.size() - 2) + 1);
}

}  // namespace

TEST_CASE("a shared moment opens at its step and continues like the game") {
    const Folder folder;
    const std::string game = folder.write("game/main.lua", game_text);
    const Outcome shared = share(folder, (folder / "game").string(), "fall");
    INFO(shared.out << shared.err);
    REQUIRE(shared.status == 0);
    const fs::path file = file_in(shared.out);
    REQUIRE(fs::exists(file));
    CHECK(file.filename() == "fall.fettle");
    // The game itself is in the file.
    fs::remove_all(folder / "game");
    const Outcome opened =
        fettle(folder, {"run", file.string(), "--headless", "--steps", "1", "--hash",  //
                        "--at", "1:print(time.step, world.body_2.mass)"});
    INFO(opened.out << opened.err);
    CHECK(opened.status == 0);
    CHECK(contains(opened.out, "59\t7.0"));
    CHECK(contains(opened.err, "this is step 59 of a shared moment, with these edits:"));
    CHECK(contains(opened.err, "world.body_2.mass: "));
    // The shared run made one step after the moment, as the opened one did.
    CHECK(last_line(opened.out) == last_line(shared.out));
}

TEST_CASE("a moment can be shared again from a moment") {
    const Folder folder;
    folder.write("game/main.lua", game_text);
    const fs::path first = file_in(share(folder, (folder / "game").string(), "one").out);
    REQUIRE(fs::exists(first));
    const Outcome again = fettle(folder, {"run", first.string(), "--headless", "--steps", "40",
                                          "--console", "40:share 'two'"});
    INFO(again.out << again.err);
    const fs::path second = file_in(again.out);
    REQUIRE(fs::exists(second));
    const Outcome opened = fettle(folder, {"run", second.string(), "--headless", "--steps", "1",
                                           "--at", "1:print(time.step)"});
    CHECK(contains(opened.out, "98"));
}

TEST_CASE("a moment is not shared under a path or from a sandbox or by a script") {
    const Folder folder;
    const std::string game = folder.write("game/main.lua", game_text);
    for (const char* name : {"../out", "a/b", "", "a.fettle"}) {
        const Outcome refused = share(folder, game, name);
        INFO(name << refused.out);
        CHECK(contains(refused.out, "expected a name of letters"));
        CHECK(file_in(refused.out).empty());
    }
    CHECK(contains(share(folder, game, std::string(65, 'x')).out,
                   "the name has 65 characters; a name has at most 64"));
    const Outcome sandboxed =
        fettle(folder, {"run", game, "--headless", "--sandbox", "--steps", "5",  //
                        "--console", "3:share 'x'"});
    CHECK(contains(sandboxed.out, "this run writes no files"));
    const std::string own = folder.write(
        "own/main.lua", "function step() if time.step == 3 then share('mine') end end");
    const Outcome by_script = fettle(folder, {"run", own, "--headless", "--steps", "5"});
    CHECK(contains(by_script.err, "only a command of the console"));
}

TEST_CASE("edits in a shared moment are not kept") {
    const Folder folder;
    folder.write("game/main.lua", game_text);
    const Outcome shared = share(folder, (folder / "game").string(), "fall");
    const fs::path file = file_in(shared.out);
    REQUIRE(fs::exists(file));
    const Outcome opened =
        fettle(folder, {"run", file.string(), "--headless", "--steps", "9",  //
                        "--console", "3:world.body_1.mass = 9", "--console", "5:keep **"});
    INFO(opened.out << opened.err);
    CHECK(contains(opened.out, "keep: this game is one file, fall.fettle, which no run changes"));
    CHECK_FALSE(contains(opened.out, "kept"));
    const Outcome where = fettle(folder, {"where", file.string()});
    INFO(where.out << where.err);
    CHECK(contains(where.out, "tweaks       none: a game in an archive (.fettle) keeps no tweaks"));
}

TEST_CASE("a damaged moment is refused with its file and the reason") {
    const Folder folder;
    folder.write("game/main.lua", game_text);
    const fs::path file = file_in(share(folder, (folder / "game").string(), "fall").out);
    REQUIRE(fs::exists(file));
    const fs::path unpacked = folder / "unpacked";
    const auto shell = [](const std::string& command) { return std::system(command.c_str()); };
    if (shell("python3 -c 'import zipfile' 2>/dev/null") != 0) return;
    const std::string script =
        folder.write("damage.py",
                     "import sys, zipfile\n"
                     "a = zipfile.ZipFile(sys.argv[1]); b = zipfile.ZipFile(sys.argv[2], 'w')\n"
                     "for n in a.namelist():\n"
                     "    d = a.read(n)\n"
                     "    if n == '.moment/state': d = d[:100] + bytes([d[100] ^ 1]) + d[101:]\n"
                     "    if n == sys.argv[3]: continue\n"
                     "    b.writestr(n, d)\n"
                     "b.close()\n");
    const std::string bad = (folder / "bad.fettle").string();
    REQUIRE(shell("python3 " + quoted(script) + " " + quoted(file.string()) + " " + quoted(bad) +
                  " none") == 0);
    const Outcome damaged = fettle(folder, {"run", bad, "--headless", "--steps", "1"});
    CHECK(damaged.status != 0);
    CHECK(contains(damaged.err, "bad.fettle: its moment cannot be opened: "));
    REQUIRE(shell("python3 " + quoted(script) + " " + quoted(file.string()) + " " + quoted(bad) +
                  " .moment/state") == 0);
    const Outcome missing = fettle(folder, {"run", bad, "--headless", "--steps", "1"});
    CHECK(contains(missing.err, "its moment cannot be opened: .moment/state is missing"));
}

}  // namespace moment_test
