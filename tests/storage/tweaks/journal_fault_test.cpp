// A journal of tweaks that cannot be written or read: the game continues, the problem is reported,
// and existing files are unchanged.

#include <fstream>

#include <sqlite3.h>

#include "catch.h"
#include "file_faults.h"
#include "tweak_run.h"

namespace journal_fault_test {

using namespace scene_test;
namespace fs = std::filesystem;

namespace {

using Lines = std::vector<std::string>;

void sql(const fs::path& file, const char* text) {
    sqlite3* database = nullptr;
    REQUIRE(sqlite3_open(file.c_str(), &database) == SQLITE_OK);
    CHECK(sqlite3_exec(database, text, nullptr, nullptr, nullptr) == SQLITE_OK);
    sqlite3_close(database);
}

std::string bytes(const fs::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

/// Makes a journal with one tweak.
void one_tweak(const GameFolder& folder) {
    Run run(folder);
    const Handle a = run.add("Thing", "a");
    run.person([&] { run.tree.set(a, "number", 2.0); });
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

const fs::perms read_only = fs::perms(0555);

const char* const name = ".fettle/main.tweaks.sqlite";

}  // namespace

TEST_CASE("two runs of one game use the journal at the same time") {
    const GameFolder folder;
    Run one(folder), two(folder);
    const Handle a = one.add("Thing", "a"), b = two.add("Thing", "b");
    for (int i = 1; i <= 50; ++i) {
        one.person([&] { one.tree.set(a, "number", static_cast<double>(i)); });
        two.person([&] { two.tree.set(b, "number", static_cast<double>(-i)); });
    }
    CHECK(one.lines() == Lines{"world.a.number: 0 → 50"});
    CHECK(two.lines() == Lines{"world.b.number: 0 → -50"});
    CHECK(one.reported.empty());
    CHECK(two.reported.empty());
    CHECK(Run(folder).lines() ==
          Lines{"earlier world.a.number: 0 → 50", "earlier world.b.number: 0 → -50"});
}

TEST_CASE("a run does not wait for another one and commits later") {
    const GameFolder folder;
    one_tweak(folder);
    Run run(folder);
    const Handle b = run.add("Thing", "b");
    sqlite3* other = nullptr;
    REQUIRE(sqlite3_open((folder / name).c_str(), &other) == SQLITE_OK);
    REQUIRE(sqlite3_exec(other, "BEGIN IMMEDIATE", nullptr, nullptr, nullptr) == SQLITE_OK);
    run.person([&] { run.tree.set(b, "number", 3.0); });
    CHECK(run.lines().back() == "world.b.number: 0 → 3 not yet");
    sqlite3_exec(other, "ROLLBACK", nullptr, nullptr, nullptr);
    sqlite3_close(other);
    run.barrier();
    CHECK(run.lines().back() == "world.b.number: 0 → 3");
    CHECK(run.reported.empty());
}

TEST_CASE("a damaged journal is reported and left unchanged and another one is written") {
    const GameFolder folder;
    one_tweak(folder);
    std::string damaged = bytes(folder / name);
    const int how = GENERATE(0, 1, 2);
    if (how == 0) damaged = "this is not a database";
    if (how == 1) damaged.resize(damaged.size() / 2);
    if (how == 2)
        for (std::size_t i = 4096; i < damaged.size(); ++i) damaged[i] = '\xff';
    std::ofstream(folder / name, std::ios::binary) << damaged;
    {
        Run run(folder);
        INFO(how);
        REQUIRE(run.reported.size() == 1);
        CHECK(has(run.reported[0], "main.tweaks.sqlite: this journal of tweaks cannot be used: "));
        CHECK(has(run.reported[0], "left as it is"));
        const Handle b = run.add("Thing", "b");
        run.person([&] { run.tree.set(b, "number", 3.0); });
        CHECK(run.lines() == Lines{"world.b.number: 0 → 3"});
    }
    CHECK(bytes(folder / name) == damaged);
    CHECK(fs::exists(folder / ".fettle/main.tweaks.2.sqlite"));
    CHECK(Run(folder).lines() == Lines{"earlier world.b.number: 0 → 3"});
}

TEST_CASE("a journal of a newer version or of another program is reported and left unchanged") {
    const GameFolder folder;
    one_tweak(folder);
    const bool newer = GENERATE(true, false);
    sql(folder / name, newer ? "PRAGMA user_version = 2" : "PRAGMA application_id = 7");
    const std::string before = bytes(folder / name);
    Run run(folder);
    REQUIRE(run.reported.size() == 1);
    CHECK(has(run.reported[0], newer ? "written by a newer Fettle (version 2" : "another program"));
    const Handle b = run.add("Thing", "b");
    run.person([&] { run.tree.set(b, "number", 3.0); });
    CHECK(run.lines() == Lines{"world.b.number: 0 → 3"});
    CHECK(bytes(folder / name) == before);
}

TEST_CASE("if the folder of the game is read-only the journal is in the folder of the user") {
    const GameFolder folder;
    fs::permissions(folder.path(), read_only);
    const Nobody nobody;
    {
        Run run(folder);
        const Handle a = run.add("Thing", "a");
        run.person([&] { run.tree.set(a, "number", 2.0); });
        CHECK(run.lines() == Lines{"world.a.number: 0 → 2"});
        REQUIRE(run.reported.size() == 1);
        CHECK(has(run.reported[0], "tweaks are journaled in " + folder.user().string()));
        CHECK(has(run.reported[0], "Permission denied"));
    }
    CHECK(Run(folder).lines() == Lines{"earlier world.a.number: 0 → 2"});
}

TEST_CASE("tweaks in a folder that became read-only are still found") {
    const GameFolder folder;
    one_tweak(folder);
    fs::permissions(folder / ".fettle", read_only);
    fs::permissions(folder.path(), read_only);
    {
        const Nobody nobody;
        Run run(folder);
        CHECK(run.lines() == Lines{"earlier world.a.number: 0 → 2"});
        const Handle a = run.add("Thing", "a");
        run.person([&] { run.tree.set(a, "number", 3.0); });
        CHECK(run.lines().back() == "world.a.number: 0 → 3");
        CHECK_FALSE(fs::exists(folder / ".fettle/main.tweaks.sqlite-wal"));
    }
    fs::permissions(folder / ".fettle", fs::perms::all);
}

TEST_CASE("on a full disk tweaks wait and are journaled when there is room again") {
    const GameFolder folder;
    one_tweak(folder);
    Run run(folder);
    const Handle b = run.add("Thing", "b");
    {
        const SmallFiles full(100);
        run.person([&] { run.tree.set_or_add(b, "text", std::string(100'000, 'x')); });
        REQUIRE(run.reported.size() == 1);
        CHECK(has(run.reported[0], "tweaks cannot be journaled: "));
        CHECK(has(run.reported[0], "those that wait (1)"));
        run.person([&] { run.tree.set(b, "number", 3.0); });
        run.barrier();
        CHECK(run.reported.size() == 1);
        CHECK(run.lines().back() == "world.b.number: 0 → 3 not yet");
        CHECK(run.tree.get(b, "number") == Value(3.0));
    }
    run.person([&] { run.tree.set(b, "flag", true); });
    CHECK(run.reported.back() == "tweaks are journaled again");
    CHECK(Run(folder).tweaks->open_earlier() == 4);
}

TEST_CASE("a full disk from the start does not stop a game") {
    const GameFolder folder;
    Run run(folder);
    const Handle a = run.add("Thing", "a");
    {
        const SmallFiles full(100);
        run.person([&] { run.tree.set(a, "number", 2.0); });
        CHECK_FALSE(run.reported.empty());
        CHECK(run.lines() == Lines{"world.a.number: 0 → 2 not yet"});
    }
    run.person([&] { run.tree.set(a, "number", 3.0); });
    CHECK(run.lines() == Lines{"world.a.number: 0 → 3"});
    CHECK(Run(folder).lines() == Lines{"earlier world.a.number: 0 → 3"});
}

TEST_CASE("a journal that is removed while the game runs is written again") {
    const GameFolder folder;
    Run run(folder);
    const Handle a = run.add("Thing", "a");
    run.person([&] { run.tree.set(a, "number", 2.0); });
    fs::remove_all(folder / ".fettle");
    run.person([&] { run.tree.set(a, "flag", true); });
    CHECK(Run(folder).lines() ==
          Lines{"earlier world.a.number: 0 → 2", "earlier world.a.flag: false → true"});
}

TEST_CASE("keeping on a full disk leaves the file unchanged and the tweak open") {
    const GameFolder folder;
    const std::string text =
        "{\n  \"fettle_scene\": 1,\n  \"class\": \"Thing\",\n  \"name\": \"a\"\n}\n";
    folder.write("level.json", text);
    Run run(folder);
    run.load(folder, "level.json");
    run.person([&] { run.tree.set(run.at("world.a"), "number", 2.0); });
    {
        const SmallFiles full(20);
        const TweakReport report = run.tweaks->keep("**");
        CHECK(report.count == 0);
        REQUIRE(report.problems.size() == 1);
        CHECK(has(report.problems[0], "level.json: could not be written"));
    }
    CHECK(folder.text("level.json") == text);
    CHECK(run.tweaks->keep("**").count == 1);
}

}  // namespace journal_fault_test
