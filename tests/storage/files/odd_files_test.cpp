// Pipes, folders, sockets, devices, links and huge files in place of the files of a game: each is
// refused at once with its name, and no call waits for it.

#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>

#include <fettle/property/storage/game_files.h>
#include <fettle/property/storage/saves.h>

#include <sqlite3.h>

#include "catch.h"
#include "tweak_run.h"

namespace odd_files_test {

using namespace scene_test;
namespace fs = std::filesystem;

namespace {

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

/// Creates an object of that kind, and returns the name that messages use for it.
std::string put(const std::string& kind, const fs::path& where) {
    fs::create_directories(where.parent_path());
    if (kind == "pipe") REQUIRE(::mkfifo(where.c_str(), 0666) == 0);
    if (kind == "folder") fs::create_directory(where);
    if (kind == "device") fs::create_symlink("/dev/zero", where);
    if (kind == "huge file") {
        std::ofstream(where) << "x";
        fs::resize_file(where, std::uintmax_t{10} << 30);
        return "larger than";
    }
    if (kind == "socket") {
        const int made = ::socket(AF_UNIX, SOCK_STREAM, 0);
        sockaddr_un address{};
        address.sun_family = AF_UNIX;
        const fs::path before = fs::current_path();
        fs::current_path(where.parent_path());  // the complete path may be too long for a socket
        std::strncpy(address.sun_path, where.filename().c_str(), sizeof address.sun_path - 1);
        REQUIRE(::bind(made, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0);
        fs::current_path(before);
        ::close(made);
    }
    return kind;
}

const auto kinds = {"pipe", "folder", "device", "socket", "huge file"};

template <class Act>
std::string refusal(Act act) {
    try {
        act();
        return "";
    } catch (const Error& error) {
        return error.what();
    }
}

}  // namespace

TEST_CASE("a path without a regular file is refused by name when it is read") {
    for (const std::string kind : kinds) {
        const GameFolder folder;
        const std::string called = put(kind, folder / "level.json");
        SceneWorld w;
        GameFiles files;
        CAPTURE(kind);
        for (const std::string& reported :
             {refusal([&] { load_scene(w.tree, folder / "level.json", w.world); }),
              refusal([&] { (void)files.read(folder / "level.json"); })}) {
            CHECK(reported.starts_with((folder / "level.json").string() + ": could not be read: "));
            CHECK(has(reported, called));
        }
    }
}

TEST_CASE(
    "a special file in place of a journal is reported at once and another journal is written") {
    for (const std::string kind : kinds)
        for (const char* const suffix : {"", "-wal", "-shm", "-journal"}) {
            const GameFolder folder;
            if (*suffix != 0) {
                Run run(folder);
                const Handle a = run.add("Thing", "a");
                run.person([&] { run.tree.set(a, "number", 2.0); });
            }
            const fs::path odd = folder / (std::string(".fettle/main.tweaks.sqlite") + suffix);
            fs::remove(odd);
            const std::string called = kind == "device" ? put(kind, odd),
                              std::string("link")       : put(kind, odd);
            CAPTURE(kind, suffix);
            Run run(folder);
            const Handle b = run.add("Thing", "b");
            run.person([&] { run.tree.set(b, "number", 3.0); });
            REQUIRE_FALSE(run.reported.empty());
            CHECK(has(run.reported[0], "this journal of tweaks cannot be used: "));
            CHECK(has(run.reported[0], called));
            CHECK(run.lines() == std::vector<std::string>{"world.b.number: 0 → 3"});
            CHECK(fs::exists(folder / ".fettle/main.tweaks.2.sqlite"));
        }
}

TEST_CASE("a special file in place of the kept tweaks is reported and never overwritten") {
    for (const std::string kind : kinds) {
        const GameFolder folder;
        const std::string called = put(kind, folder / "main.tweaks.json");
        CAPTURE(kind);
        Run run(folder);
        REQUIRE(run.reported.size() == 1);
        const bool link = kind == "device";  // a link that leads out
        CHECK(has(run.reported[0], link ? "leads out of the game's folder" : called));
        const Handle a = run.add("Thing", "a");
        run.person([&] { run.tree.set(a, "number", 2.0); });
        CHECK(run.tweaks->keep("**").problems.size() == 1);
        CHECK(run.tweaks->list().size() == 1);
    }
}

TEST_CASE("a special file in place of a saved game is reported and the others are listed") {
    for (const std::string kind : kinds) {
        const GameFolder folder;
        const Saves saves(folder.user() / "saves", "ball", "0.1.0");
        saves.save("good", 1, {});
        put(kind, folder.user() / "saves" / "odd.sqlite");
        CAPTURE(kind);
        CHECK_THROWS_AS(saves.load("odd"), FileError);
        const std::vector<SaveInfo> all = saves.list();
        REQUIRE(all.size() == 2);
        CHECK(all[0].problem.empty());
        CHECK_FALSE(all[1].problem.empty());
    }
}

// --- Links out of the game's folder

TEST_CASE("links that lead out of the folder of the game are neither read nor written") {
    const GameFolder folder;
    const fs::path outside = folder.path().parent_path() / "outside";
    fs::create_directory(outside);
    std::ofstream(outside / "level.json") << "{\"fettle_scene\": 1, \"class\": \"Object\"}";
    const std::uintmax_t size = fs::file_size(outside / "level.json");
    fs::create_symlink(outside / "level.json", folder / "link.json");
    fs::create_symlink(outside, folder / "sub");
    fs::create_symlink(outside / "new.json", folder / "dangling.json");
    fs::create_symlink("../outside/level.json", folder / "relative.json");
    GameFiles files;
    files.stay_below(folder.path());
    for (const char* const name :
         {"link.json", "sub/level.json", "relative.json", "../outside/level.json"}) {
        CAPTURE(name);
        CHECK(has(refusal([&] { (void)files.read(folder / name); }),
                  "outside of the game's folder") !=
              has(refusal([&] { (void)files.read(folder / name); }),
                  "leads out of the game's folder"));
        CHECK(refusal([&] { files.write(folder / name, "x"); }) != "");
        CHECK(refusal([&] { files.write_scene(folder / name, "x"); }) != "");
    }
    CHECK(refusal([&] { files.write(folder / "dangling.json", "x"); }) != "");
    CHECK(refusal([&] { files.write(folder / "sub/new.json", "x"); }) != "");
    CHECK_FALSE(fs::exists(outside / "new.json"));
    CHECK(fs::file_size(outside / "level.json") == size);
}

TEST_CASE("links within the folder of the game are followed") {
    const GameFolder folder;
    folder.write("levels/one.json", "one");
    fs::create_symlink("levels/one.json", folder / "start.json");
    fs::create_symlink(folder / "levels", folder / "old");
    GameFiles files;
    files.stay_below(folder.path());
    CHECK(files.read(folder / "start.json") == "one");
    CHECK(files.read(folder / "old/one.json") == "one");
    files.write(folder / "start.json", "two");
    CHECK(folder.text("levels/one.json") == "two");
    CHECK(fs::is_symlink(folder / "start.json"));
}

TEST_CASE("a link in place of the folder for journals is not followed") {
    const GameFolder folder;
    const fs::path outside = folder.path().parent_path() / "outside";
    fs::create_directory(outside);
    fs::create_symlink(outside, folder / ".fettle");
    Run run(folder);
    const Handle a = run.add("Thing", "a");
    run.person([&] { run.tree.set(a, "number", 2.0); });
    REQUIRE(run.reported.size() == 1);
    CHECK(has(run.reported[0],
              ".fettle: expected a folder for the journal of tweaks, but it is a link"));
    CHECK(fs::is_empty(outside));
    CHECK(run.lines() == std::vector<std::string>{"world.a.number: 0 → 2"});
    CHECK(run.tweaks->journal().string().starts_with(folder.user().string()));
}

// --- Files that a scene may replace

TEST_CASE("a scene replaces a scene or creates a file") {
    const GameFolder folder;
    const std::string scene = "{\"fettle_scene\": 1, \"class\": \"Object\"}";
    GameFiles files;
    files.stay_below(folder.path());
    files.write_scene(folder / "level.json", scene);
    files.write_scene(folder / "level.json", scene + "\n");
    CHECK(folder.text("level.json") == scene + "\n");
    for (const char* const text :
         {"print(1)", "{\"modules\": []}", "", "[]", "{\"fettle_scene\": 1",
          "{\"fettle_scene\": 2, \"class\": \"Object\"}",
          "\x7f"
          "ELF"}) {
        folder.write("other.json", text);
        CAPTURE(text);
        CHECK(has(refusal([&] { files.write_scene(folder / "other.json", scene); }),
                  "was not written: there is a "));
        CHECK(folder.text("other.json") == text);
    }
    for (const char* const name :
         {"main.lua", "new.lua", "modules.json", "game.json", "main.tweaks.json", "x.tweaks.json",
          "MAIN.LUA", "Game.json", ".hidden.json", ".fettle/level.json", "sub/.git/x.json",
          "evil.so", "save.sqlite"}) {
        CAPTURE(name);
        fs::remove(folder / name);
        CHECK(has(refusal([&] { files.write_scene(folder / name, scene); }), "was not written: "));
        CHECK_FALSE(fs::exists(folder / name));
    }
    fs::create_symlink(folder / "main.lua", folder / "link.json");
    folder.write("main.lua", scene);
    CHECK(
        has(refusal([&] { files.write_scene(folder / "link.json", scene); }), "was not written: "));
}

// --- Contents of a journal

TEST_CASE("a database with other tables than a journal is reported and left unchanged") {
    const std::string sql = GENERATE(
        as<std::string>{},
        "DROP TABLE tweaks; CREATE VIEW tweaks AS WITH RECURSIVE c(x) AS (SELECT 1 UNION ALL "
        "SELECT "
        "x+1 FROM c) SELECT x AS run, 1 AS number, 0 AS kind, 0 AS state, 'a' AS instance, 'b' AS "
        "property, '' AS was, '' AS now, '' AS was_text, '' AS now_text, 0 AS step, 0 AS time, '' "
        "AS "
        "file, '' AS inside, '' AS kept_in FROM c",
        "CREATE VIEW more AS SELECT 1", "CREATE TABLE more (x)",
        "CREATE INDEX more ON tweaks(step)",
        "CREATE TRIGGER more AFTER INSERT ON tweaks BEGIN DELETE FROM runs; END", "DROP TABLE runs",
        "ALTER TABLE tweaks ADD COLUMN more",
        "DROP TABLE tweaks; CREATE TABLE tweaks (run, number, kind, state, instance, property AS "
        "(hex(zeroblob(100000000))), was, now, was_text, now_text, step, time, file, inside, "
        "kept_in)");
    const GameFolder folder;
    {
        Run run(folder);
        const Handle a = run.add("Thing", "a");
        run.person([&] { run.tree.set(a, "number", 2.0); });
    }
    sqlite3* database = nullptr;
    REQUIRE(sqlite3_open((folder / ".fettle/main.tweaks.sqlite").c_str(), &database) == SQLITE_OK);
    INFO(sql);
    REQUIRE(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr) == SQLITE_OK);
    sqlite3_close(database);
    Run run(folder);
    REQUIRE(run.reported.size() == 1);
    INFO(run.reported[0]);
    CHECK(has(run.reported[0], "this journal of tweaks cannot be used: it "));
    CHECK(has(run.reported[0], "left as it is"));
    const Handle b = run.add("Thing", "b");
    run.person([&] { run.tree.set(b, "number", 3.0); });
    CHECK(run.lines() == std::vector<std::string>{"world.b.number: 0 → 3"});
    CHECK(Run(folder).lines() == std::vector<std::string>{"earlier world.b.number: 0 → 3"});
}

}  // namespace odd_files_test
