// `fettle package`: one file, a folder, and what is refused.

#include <catch.h>

#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>

#include "program.h"

namespace package_test {

using namespace program_test;

namespace fs = std::filesystem;

namespace {

/// A game with a module, a scene, an image and random numbers.
void write_game(const Folder& folder) {
    folder.write(
        "game/main.lua",
        "local part = require('parts.wall') part.build(world) "
        "scene.load('crate.json', world, 'crate') "
        "world.picture = Sprite { image = 'art/hero.tga' } "
        "for i = 1, 20 do world:add(Body { position = vec(random() * 4, i), Circle { } }) end "
        "print(world.picture.columns)");
    folder.write("game/parts/wall.lua",
                 "local part = {} function part.build(w) w.floor = Body { type = 'static', "
                 "position = vec(0, -2), Box { width = 20, height = 2 } } end return part");
    folder.write("game/crate.json",
                 R"({"fettle_scene": 1, "class": "Body", "children": [{"class": "Circle"}]})");
    // An uncompressed TGA file of one pixel.
    std::string pixel(18, '\0');
    pixel[2] = 2, pixel[12] = 1, pixel[14] = 1, pixel[16] = 32;
    folder.write("game/art/hero.tga", pixel + std::string("\x10\x20\x30\xff", 4));
    folder.write("game/game.json",
                 R"({"name": "Cave of Lamps", "id": "org.example.cave", "version": "1.2"})");
    folder.write("game/tests/one.lua", "test('x', function() end)");
}

Outcome hash(const Folder& folder, const std::string& game) {
    return fettle(folder, {"run", game, "--headless", "--steps", "90", "--hash"});
}

}  // namespace

TEST_CASE("an archive of a game runs as its folder does") {
    const Folder folder;
    write_game(folder);
    const std::string game = (folder / "game").string();
    const std::string archive = (folder / "cave.fettle").string();
    const Outcome made = fettle(folder, {"package", game, "--file", archive});
    INFO(made.out << made.err);
    REQUIRE(made.status == 0);
    const Outcome before = hash(folder, game), packed = hash(folder, archive);
    INFO(before.err << packed.err);
    CHECK(before.status == 0);
    CHECK(packed.status == 0);
    CHECK_FALSE(before.out.empty());
    CHECK(packed.out == before.out);
    const std::string first = folder.text("cave.fettle");
    REQUIRE(fettle(folder, {"package", game, "--file", archive}).status == 0);
    CHECK(folder.text("cave.fettle") == first);
    CHECK(contains(fettle(folder, {"where", archive}).out, "org.example.cave/saves"));
}

TEST_CASE("a game with a script that does not compile is not packed") {
    const Folder folder;
    folder.write("game/main.lua", "require('enemy')");
    folder.write("game/enemy.lua", "local speed = 3\nlocal t = { a = 1 b = 2 }\n");
    const Outcome packed = fettle(
        folder, {"package", (folder / "game").string(), "--file", (folder / "a.fettle").string()});
    CHECK(packed.status != 0);
    CHECK(contains(packed.err, "enemy.lua:2: '}' expected near 'b'"));
    CHECK(contains(packed.err, "nothing was made"));
    CHECK_FALSE(std::filesystem::exists(folder / "a.fettle"));
}

TEST_CASE("errors in an archive have their places and unknown files their nearest names") {
    const Folder folder;
    folder.write("game/main.lua", "local name = 'art/hero' require('part')(name .. '.tgaa')");
    folder.write("game/part.lua",
                 "return function(name)\n  world.x = Sprite { image = name }\nend");
    folder.write("game/art/hero.tgaa", "");
    folder.write("game/art/hero.tga", "no image");
    REQUIRE(fettle(folder, {"package", (folder / "game").string(), "--file",
                            (folder / "a.fettle").string()})
                .status == 0);
    const Outcome ran = fettle(folder, {"run", (folder / "a.fettle").string(), "--headless",
                                        "--steps", "1", "--eval", "scene.load('art/hero.tg')"});
    CHECK(ran.status == 1);
    CHECK(contains(ran.err, "there is no file \"art/hero.tg\""));
}

TEST_CASE("a game that would not run elsewhere is not packaged") {
    const auto [script, message] = GENERATE(table<std::string, std::string>({
        {"world.a = Sprite { image = 'art/Hero.png' }",
         "main.lua:1: \"art/Hero.png\": the file is called \"art/hero.png\""},
        {"\nlocal a = \"art/heroo.png\"",
         "main.lua:2: \"art/heroo.png\": there is no such file (did you mean \"art/hero.png\"?)"},
        {"local a = [[/home/me/x.ogg]]", "\"/home/me/x.ogg\": an absolute path"},
        {"require('parts.none')", "\"parts.none\" (parts/none.lua): there is no such file"},
        {"require \"Part\"", "\"Part\" (Part.lua): the file is called \"part.lua\""},
        {"local a = 'C:/x.png'", "an absolute path"},
    }));
    CAPTURE(script);
    const Folder folder;
    folder.write("game/main.lua", script);
    folder.write("game/part.lua", "");
    folder.write("game/art/hero.png", "");
    const Outcome refused = fettle(
        folder, {"package", (folder / "game").string(), "--file", (folder / "a.fettle").string()});
    INFO(refused.err);
    CHECK(refused.status == 3);
    CHECK(contains(refused.err, message));
    CHECK_FALSE(fs::exists(folder / "a.fettle"));
}

TEST_CASE("a package has no sources of pictures and no files that game json excludes") {
    const Folder folder;
    folder.write("game/main.lua", "world.a = Sprite { image = 'art/hero.png' }");
    folder.write("game/game.json",
                 R"({"package": {"exclude": ["art/drafts", "*.wav", "notes?.md"]}})");
    for (const char* name :
         {"art/hero.png", "art/hero.psd", "art/hero.aseprite", "art/drafts/old.png", "a.wav",
          "sounds/b.wav", "sounds/c.ogg", "notes1.md", "notes.md", "main.lua~", "tests/a.lua",
          "levels/tests/a.json", ".git/config", "Thumbs.db"})
        folder.write("game/" + std::string(name), "{}");
    const std::string game = (folder / "game").string(), file = (folder / "a.fettle").string();
    const Outcome packed = fettle(folder, {"package", game, "--file", file});
    INFO(packed.err);
    REQUIRE(packed.status == 0);
    CHECK(contains(packed.out,
                   "left out: Thumbs.db, a.wav, art/drafts/, art/hero.aseprite, art/hero.psd, "
                   "main.lua~, notes1.md, sounds/b.wav, tests/\n"));
    CHECK(contains(packed.out, "a.fettle: 6 files"));
    folder.write("game/main.lua", "world.a = Sprite { image = 'art/drafts/old.png' }");
    const Outcome refused = fettle(folder, {"package", game, "--file", file});
    CHECK(refused.status == 3);
    CHECK(contains(refused.err, "\"art/drafts/old.png\": packages leave art/drafts/ out"));
    folder.write("game/game.json", R"({"package": {"exlude": []}})");
    CHECK(contains(fettle(folder, {"package", game, "--file", file}).err,
                   "package.exlude: there is no such setting (did you mean \"exclude\"?)"));
}

TEST_CASE(
    "packages of the complete games leave out the scripts that make their pictures and music") {
    const Folder folder;
    const std::string name = GENERATE(as<std::string>{}, "amber", "lantern", "russet");
    const Outcome packed =
        fettle(folder, {"package", "scripts/" + name, "--file", (folder / "a.fettle").string()});
    INFO(packed.err);
    CHECK(packed.status == 0);
    CHECK(contains(packed.out, "left out: draw_art.py, "));
}

TEST_CASE("comments and files that the game makes do not stop a package") {
    const Folder folder;
    folder.write("game/main.lua",
                 "-- 'none.png'\n--[[ \"none.ogg\" ]]\nscene.save('mine.json', world) "
                 "local a = 'made.json' local b = 'it is not a name .png at all?'");
    const std::string game = (folder / "game").string(), file = (folder / "a.fettle").string();
    CHECK(fettle(folder, {"package", game, "--file", file}).status == 3);
    CHECK(fettle(folder, {"package", game, "--file", file, "--made", "made.json"}).status == 0);
}

TEST_CASE("parts of names and keys of tables do not stop a package") {
    const Folder folder;
    folder.write("game/main.lua",
                 "local dir = 'art/' local sizes = { ['b.png'] = 1 } "
                 "print(dir .. 'a.png', 'art/' .. 'a.png', 'c.png' .. dir, sizes['b.png'], "
                 "'https://example.org/d.png', [[e]] .. [[f.png]])");
    const std::string game = (folder / "game").string(),
                      file = (folder / "my game.fettle").string();
    const Outcome made = fettle(folder, {"package", game, "--file", file});
    INFO(made.err);
    CHECK(made.status == 0);
    CHECK(contains(made.out, "Play it with fettle run '" + file + "'"));
    folder.write("game/main.lua", "local list = { 'a.png' }");
    CHECK(fettle(folder, {"package", game, "--file", file}).status == 3);
}

TEST_CASE("a package inside of the game is not packed again") {
    const Folder folder;
    write_game(folder);
    folder.write("game/out/bin/fettle", "");
    folder.write("game/out/share/fettle/fonts/a.ttf", "");
    folder.write("game/bin/notes.json", "{}");
    const Outcome made = fettle(
        folder, {"package", (folder / "game").string(), "--file", (folder / "a.fettle").string()});
    INFO(made.out << made.err);
    CHECK(contains(made.out, "left out: out/, tests/"));
    CHECK(contains(made.out, "6 files"));
}

TEST_CASE("a game that is one file is packed without what is beside it") {
    const Folder folder;
    write_game(folder);
    folder.write("game/alone.lua", "print('here')");
    std::filesystem::create_symlink("nowhere", folder / "game/link");
    const std::string file = (folder / "a.fettle").string();
    const Outcome alone =
        fettle(folder, {"package", (folder / "game/alone.lua").string(), "--file", file});
    INFO(alone.out << alone.err);
    CHECK(contains(alone.out, "1 file."));
    const Outcome more =
        fettle(folder, {"package", (folder / "game/main.lua").string(), "--file", file});
    CHECK(more.status == 3);
    CHECK(contains(more.err,
                   "\"art/hero.tga\": the package of a game that is one file has that "
                   "file only; a game with more files is a folder with main.lua"));
}

TEST_CASE("a package has names in UTF-8 and none that its reader refuses") {
    const Folder folder;
    write_game(folder);
    folder.write("game/art/höhle.txt", "");
    const std::string game = (folder / "game").string(), file = (folder / "a.fettle").string();
    REQUIRE(fettle(folder, {"package", game, "--file", file}).status == 0);
    const std::string zip = folder.text("a.fettle");
    // Bit 11 of the flags in the header of a file: its name is in UTF-8.
    CHECK((static_cast<unsigned char>(zip[7]) & 8) != 0);
    folder.write("game/back\\slash.txt", "");
    const Outcome made = fettle(folder, {"package", game, "--file", file});
    CHECK(made.status == 3);
    CHECK(contains(made.err, "no file of a game may be called \"back\\\\slash.txt\""));
    CHECK(folder.text("a.fettle") == zip);
}

TEST_CASE("a damaged archive and one with strange names are refused") {
    const Folder folder;
    folder.write("no.fettle", "this is not an archive");
    const Outcome none = hash(folder, (folder / "no.fettle").string());
    CHECK(none.status == 3);
    CHECK(contains(none.err, "is not an archive of a game, or it is damaged"));
    write_game(folder);
    folder.write("game/more.lua", "print(2)");
    const std::string archive = (folder / "cave.fettle").string();
    REQUIRE(fettle(folder, {"package", (folder / "game").string(), "--file", archive}).status == 0);
    std::string bytes = folder.text("cave.fettle");
    const auto renamed = [bytes](const std::string& from, const std::string& to) {
        std::string all = bytes;
        for (std::size_t at = all.find(from); at != std::string::npos; at = all.find(from, at + 1))
            all.replace(at, from.size(), to);
        return all;
    };
    folder.write("evil.fettle", renamed("art/hero.tga", "../../her.tg"));
    const Outcome evil = hash(folder, (folder / "evil.fettle").string());
    CHECK(evil.status == 3);
    CHECK(contains(evil.err, "a file \"../../her.tg\", a name that no game may have"));
    folder.write("twice.fettle", renamed("more.lua", "main.lua"));
    CHECK(contains(hash(folder, (folder / "twice.fettle").string()).err, "two files \"main.lua\""));
    // The size of the file, in the list at the end of the archive.
    bytes.replace(bytes.rfind("art/hero.tga") - 22, 4, std::string("\0\0\0\x50", 4));
    folder.write("large.fettle", bytes);
    const Outcome large = hash(folder, (folder / "large.fettle").string());
    CHECK(large.status == 3);
    CHECK(contains(large.err, "\"art/hero.tga\" has 1342177280 bytes"));
    folder.write("short.fettle", folder.text("cave.fettle").substr(0, 400));
    CHECK(hash(folder, (folder / "short.fettle").string()).status == 3);
}

TEST_CASE("a folder for linux runs without anything else") {
    const Folder folder;
    write_game(folder);
    const std::string game = (folder / "game").string(), to = (folder / "shipped").string();
    const Outcome made = fettle(folder, {"package", game, "--linux", to});
    INFO(made.out << made.err);
    REQUIRE(made.status == 0);
    CHECK(fettle(folder, {"package", game, "--linux", to}).status == 3);  // not twice
    const std::string expected = hash(folder, game).out;
    const fs::path own = folder / "shipped/cave-of-lamps";
    REQUIRE(::access(own.c_str(), X_OK) == 0);
    if (::geteuid() != 0) {
        WARN("skipped: only root can change the root folder");
        return;
    }
#ifdef FETTLE_SANITIZED
    WARN("skipped: this program needs the libraries of the sanitizers as well");
    return;
#endif
    // A root folder with a shell, and the libraries that the system itself brings.
    const std::string script = R"sh(set -e
root="$1"; mkdir -p "$root"/bin "$root"/game
cp -a "$2" "$root"/game/out
copy() { mkdir -p "$root$(dirname "$1")"; cp -L "$1" "$root$1"; }
copy /bin/sh
cp -L "$(command -v dirname)" "$(command -v readlink)" "$root"/bin/
for each in /bin/sh "$(command -v readlink)" "$2"/bin/fettle; do
    ldd "$each" | sed -n 's/.*=> \(\/[^ ]*\).*/\1/p; s/^[[:space:]]*\(\/[^ ]*\) (.*/\1/p'
done | sort -u | while read library; do
    case "$(basename "$library")" in
    ld-linux*|libc.so*|libm.so*|libdl.so*|libpthread.so*|librt.so*|libgcc_s*|libstdc++*|libGL*|libX11.so*|libxcb*|libXau*|libXdmcp*|libbsd*|libmd*|libselinux*|libpcre*)
        copy "$library" ;;
    esac
done
PATH=/bin:/sbin:/usr/sbin chroot "$root" /game/out/cave-of-lamps --headless --steps 90 --hash
)sh";
    folder.write("chroot.sh", script);
    const std::string output = (folder / "result").string();
    const std::string command = "sh " + quoted((folder / "chroot.sh").string()) + " " +
                                quoted((folder / "root").string()) + " " + quoted(to) + " > " +
                                quoted(output) + " 2>&1";
    const int status = std::system(command.c_str());
    INFO(folder.text("result"));
    CHECK(status == 0);
    CHECK(folder.text("result") == expected);
}

TEST_CASE("a package needs an argument for what to make") {
    const Folder folder;
    folder.write("game/main.lua", "");
    const std::string game = (folder / "game").string();
    CHECK(fettle(folder, {"package", game}).status == 2);
    CHECK(fettle(folder, {"package", game, "--file", "x.zip"}).status == 2);
}

TEST_CASE("a package brings the native modules of its game along") {
#ifdef __SANITIZE_ADDRESS__
    return;  // a module is larger there than a file of a game may be
#endif
    const Folder folder;
    folder.write("game/main.lua", "world.ball = Body { Circle {} } print(modules.physics.file)");
    folder.write("game/modules.json", R"({"modules": ["physics"]})");
    folder.write("game/game.json", R"({"name": "Game With Wheels"})");
    const std::string game = (folder / "game").string();
    const std::string to = (folder / "made").string();
    const Outcome made = fettle(folder, {"package", game, "--linux", to});
    INFO(made.out << made.err);
    REQUIRE(made.status == 0);
    CHECK(fs::exists(to + "/game/physics.so"));
    CHECK_FALSE(fs::exists(to + "/lib/physics.so"));
    const std::string output = (folder / "result").string();
    const std::string command =
        quoted(to + "/game-with-wheels") + " --headless --steps 2 > " + quoted(output) + " 2>&1";
    const int status = std::system(command.c_str());
    INFO(folder.text("result"));
    CHECK(status == 0);
    CHECK(folder.text("result") == to + "/game/physics.so\n");
}

TEST_CASE("a package replaces only a regular file and leaves the files beside it") {
    const Folder folder;
    folder.write("game/main.lua", "");
    const std::string game = (folder / "game").string();
    folder.write("made.new/mine", "a");
    fs::create_directories(folder / "b.deb");
    fs::create_directories(folder / "c.tar.gz");
    REQUIRE(::mkfifo((folder / "p.deb").c_str(), 0600) == 0);
    const Outcome made = fettle(folder, {"package", game, "--linux", (folder / "made/").string()});
    INFO(made.out << made.err);
    CHECK(made.status == 0);
    CHECK(contains(made.out, ": game-start in it starts the game"));  // "game" is a folder there
    CHECK(fs::exists(folder / "made/game/main.lua"));
    CHECK(fs::is_regular_file(folder / "made/game-start"));
    CHECK(folder.text("made.new/mine") == "a");
    for (const char* name : {"b.deb", "p.deb"})
        CHECK(contains(fettle(folder, {"package", game, "--deb", (folder / name).string()}).err,
                       "there is something already that is not a file, so nothing was made"));
    CHECK(contains(fettle(folder, {"package", game, "--linux", (folder / "c.tar.gz").string()}).err,
                   "there is something already that is not a file"));
    CHECK(fettle(folder, {"package", game, "--deb", (folder / "x").string()}).status == 2);
    // No temporary file is left: its name would begin with that of the package.
    for (const auto& each : fs::directory_iterator(folder / "")) {
        const std::string name = each.path().filename().string();
        CAPTURE(name);
        CHECK((name == "made.new" || !name.starts_with("made.")));
        CHECK_FALSE(contains(name, ".deb."));
        CHECK_FALSE(contains(name, ".gz."));
    }
}

#ifdef FETTLE_TEST_MODULES
TEST_CASE("no package is made of a game with a module that exits or crashes") {
    const Folder folder;
    folder.write("game/main.lua", "");
    const std::string game = (folder / "game").string();
    const std::string to = (folder / "made").string();
    for (const char* module : {"exit_when_opened", "crash_when_opened"}) {
        CAPTURE(module);
        fs::copy_file(std::string(FETTLE_TEST_MODULES "/") + module + ".so", folder / "game/own.so",
                      fs::copy_options::overwrite_existing);
        folder.write("game/modules.json", R"({"modules": ["./own.so"]})");
        const Outcome made = fettle(folder, {"package", game, "--linux", to});
        CHECK(made.status == 3);
        CHECK(contains(made.err, "modules.json: \"./own.so\": it cannot be loaded: "));
        CHECK(contains(made.err, "while it was opened"));
        CHECK_FALSE(fs::exists(to));
    }
}
#endif

TEST_CASE("an archive names installed modules and brings no native code along") {
    const Folder folder;
    folder.write("game/main.lua", "print(modules.physics.file)");
    folder.write("game/modules.json", R"({"modules": ["physics"]})");
    const std::string game = (folder / "game").string();
    const std::string archive = (folder / "a.fettle").string();
    const Outcome made = fettle(folder, {"package", game, "--file", archive});
    INFO(made.err);
    REQUIRE(made.status == 0);
    const Outcome run = fettle(folder, {"run", archive, "--headless", "--steps", "1"});
    CHECK(run.status == 0);
    CHECK(contains(run.out, "physics.so"));
    folder.write("game/own.so", "");
    folder.write("game/modules.json", R"({"modules": ["own.so"]})");
    const Outcome native = fettle(folder, {"package", game, "--file", archive});
    CHECK(native.status == 3);
    CHECK(contains(native.err, "\"own.so\": an archive cannot bring native modules along"));
    const Outcome damaged =
        fettle(folder, {"package", game, "--linux", (folder / "none").string()});
    CHECK(damaged.status == 3);
    CHECK(contains(damaged.err, "\"own.so\": it cannot be loaded: "));
}

TEST_CASE("a game in a sandbox is limited and plugs in nothing") {
    const Folder folder;
    folder.write("game/main.lua",
                 "local t = {} function step() t[#t + 1] = ('x'):rep(1e6) .. #t end");
    const std::string game = (folder / "game").string();
    const Outcome memory = fettle(
        folder, {"run", game, "--headless", "--steps", "1000", "--sandbox", "--memory", "32"});
    CHECK(memory.status == 1);
    CHECK(contains(memory.err, "main.lua:1: "));
    CHECK(contains(memory.err, "may use"));
    folder.write("game/main.lua", "function step() while true do end end");
    const Outcome endless =
        fettle(folder, {"run", game, "--headless", "--steps", "10", "--sandbox"});
    CHECK(endless.status == 1);
    CHECK(contains(endless.err, "main.lua:1: stopped: it ran"));
    folder.write("game/main.lua", "function step() for i = 1, 1e7 do world:add(Body { }) end end");
    const Outcome bodies =
        fettle(folder, {"run", game, "--headless", "--steps", "10", "--memory", "64"});
    CHECK(bodies.status == 1);
    CHECK(contains(bodies.err, "may add to it, 64 MB"));
    folder.write("game/modules.json", R"({"modules": ["wind"]})");
    const Outcome native = fettle(folder, {"run", game, "--headless", "--steps", "1", "--sandbox"});
    CHECK(native.status == 3);
    CHECK(contains(native.err, "cannot plug in native modules"));
}

}  // namespace package_test
