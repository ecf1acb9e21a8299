// Tweaks in the journal of an earlier run that are damaged or forged: invalid ones are reported and
// ignored, and none of them makes a file unreadable.

#include <filesystem>

#include <sqlite3.h>

#include "catch.h"
#include "tweak_run.h"

namespace forged_tweaks_test {

using namespace scene_test;
namespace fs = std::filesystem;

namespace {

const char* const journal = ".fettle/main.tweaks.sqlite";

const char* const level =
    "{\n"
    "  \"fettle_scene\": 1,\n"
    "  \"class\": \"Object\",\n"
    "  \"name\": \"level\",\n"
    "  \"children\": [\n"
    "    {\n"
    "      \"class\": \"Thing\",\n"
    "      \"name\": \"a\",\n"
    "      \"properties\": {\n"
    "        \"density\": 2\n"
    "      }\n"
    "    },\n"
    "    { \"class\": \"Note\", \"name\": \"n\" }\n"
    "  ]\n"
    "}\n";

void change(const GameFolder& folder, const std::string& sql) {
    sqlite3* database = nullptr;
    REQUIRE(sqlite3_open((folder / journal).c_str(), &database) == SQLITE_OK);
    INFO(sql);
    CHECK(sqlite3_exec(database, sql.c_str(), nullptr, nullptr, nullptr) == SQLITE_OK);
    sqlite3_close(database);
}

/// A run that leaves one tweak of a thing in a scene file; `sql` then changes its row.
void leave(const GameFolder& folder, const std::string& sql) {
    folder.write("level.json", level);
    {
        Run run(folder);
        run.load(folder, "level.json");
        run.person([&] { run.tree.set(run.at("world.level.a"), "density", 3.0); });
    }
    change(folder, sql);
}

std::string value(const std::string& property, const std::string& json) {
    return "UPDATE tweaks SET property = '" + property + "', now = '{\"value\": " + json + "}'";
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

bool loads(const GameFolder& folder) {
    SceneWorld world;
    try {
        load_scene(world.tree, folder / "level.json", world.world);
        return true;
    } catch (const Error&) {
        return false;
    }
}

struct Forged {
    std::string sql;
    std::string reported;  // text in the report of `keep`
};

}  // namespace

TEST_CASE("a value that the class refuses is not kept in a scene file and stays open") {
    const std::vector<Forged> all = {
        {value("density", "\"abc\""), "world.level.a.density: expected a number from 0 to 1000"},
        {value("density", "-2"), "expected a number from 0"},
        {value("density", "1e9"), "expected a number from 0"},
        {value("density", "[1, 2]"), "expected a number from 0"},
        {value("kind", "\"statc\""), "expected one of"},
        {value("weight", "5"), "world.level.a.weight: it is read-only"},
        {value("name", "\"other\""), "is set by the keys and the place of the instance"},
        {value("tint", "\"no such color\""), "no color is called"},
        {value("lives", "{\"vec2\": [1]}"), "expected a vec2"},
        {value("lives", "{\"reference\": \"world.nobody\"}"), "does not exist"},
        {"UPDATE tweaks SET kind = 3, property = '', now = 'world.level.n'",
         "has two children called \"n\""},
        {"UPDATE tweaks SET kind = 1, property = '', instance = 'world.level.b', inside = '', now "
         "= "
         "'{\"fettle_scene\": 1, \"class\": \"Nobody\"}'",
         "no class is called \"Nobody\""},
        {"UPDATE tweaks SET kind = 1, property = '', instance = 'world.level.b', inside = '', now "
         "= "
         "'{\"fettle_scene\": 1, \"class\": \"Thing\", \"name\": \"b\", \"properties\": "
         "{\"density\": \"abc\"}}'",
         "expected a number from 0"},
        {"UPDATE tweaks SET kind = 1, property = '', instance = 'world.level.b', inside = '', now "
         "= "
         "'{\"fettle_scene\": 1, \"class\": \"Note\", \"name\": \"b\", \"properties\": "
         "{\"target\": \"world.nobody\"}}'",
         "refers to \"world.nobody\""},
        {"UPDATE tweaks SET kind = 1, property = '', instance = 'world.level.n', inside = '', now "
         "= "
         "'{\"fettle_scene\": 1, \"class\": \"Thing\", \"name\": \"n\"}'",
         "has two children called \"n\""},
        {"UPDATE tweaks SET kind = 1, property = '', instance = 'world.level.a.mass', inside = "
         "'[[\"a\", 0]]', now = '{\"fettle_scene\": 1, \"class\": \"Note\", \"name\": \"mass\"}'",
         "the name is one of a property"},
    };
    for (const Forged& forged : all) {
        const GameFolder folder;
        leave(folder, forged.sql);
        Run run(folder);
        run.load(folder, "level.json");
        CAPTURE(forged.sql, forged.reported);
        REQUIRE(run.tweaks->open_earlier() == 1);
        const TweakReport report = run.tweaks->keep("**");
        REQUIRE(report.problems.size() == 1);
        CHECK(has(report.problems[0], forged.reported));
        CHECK(report.count == 0);
        CHECK(folder.text("level.json") == level);
        CHECK(run.tweaks->open_earlier() == 1);
        CHECK(run.tweaks->drop("**").count == 1);
    }
}

TEST_CASE("valid tweaks are kept in spite of invalid ones") {
    const GameFolder folder;
    folder.write("level.json", level);
    {
        Run run(folder);
        run.load(folder, "level.json");
        for (const char* property : {"number", "density", "gain"})
            run.person([&] { run.tree.set(run.at("world.level.a"), property, 5.0); });
    }
    sqlite3* database = nullptr;
    REQUIRE(sqlite3_open((folder / journal).c_str(), &database) == SQLITE_OK);
    sqlite3_exec(database,
                 "UPDATE tweaks SET now = '{\"value\": \"abc\"}' WHERE property = 'density'",
                 nullptr, nullptr, nullptr);
    sqlite3_close(database);
    Run run(folder);
    run.load(folder, "level.json");
    const TweakReport report = run.tweaks->keep("**");
    CHECK(report.count == 2);
    REQUIRE(report.problems.size() == 1);
    CHECK(has(report.problems[0], "world.level.a.density: expected a number"));
    CHECK(has(folder.text("level.json"), "\"number\": 5"));
    CHECK(has(folder.text("level.json"), "\"density\": 2"));
    CHECK(loads(folder));
}

TEST_CASE("a value that the class refuses is not kept in the file of tweaks") {
    const GameFolder folder;
    leave(folder, "UPDATE tweaks SET file = '', inside = '', now = '{\"value\": \"abc\"}'");
    Run run(folder);
    run.load(folder, "level.json");
    const TweakReport report = run.tweaks->keep("**");
    REQUIRE(report.problems.size() == 1);
    CHECK(has(report.problems[0], "world.level.a.density: expected a number"));
    CHECK_FALSE(fs::exists(folder / "main.tweaks.json"));
}

TEST_CASE("an invalid row is reported and ignored and the others are unchanged") {
    const std::string sql = GENERATE(
        as<std::string>{}, "UPDATE tweaks SET kind = 77", "UPDATE tweaks SET kind = -1",
        "UPDATE tweaks SET instance = 'world..a'", "UPDATE tweaks SET instance = 'world[3]'",
        "UPDATE tweaks SET instance = x'00ff'", "UPDATE tweaks SET property = ''",
        "UPDATE tweaks SET now = 'rubbish'", "UPDATE tweaks SET now = '{\"value\": '",
        "UPDATE tweaks SET now = '{}'", "UPDATE tweaks SET inside = '[[3, \"a\"]]'",
        "UPDATE tweaks SET inside = '{'",
        "UPDATE tweaks SET kind = 1, now = '{\"fettle_scene\": 1'",
        "UPDATE tweaks SET kind = 2, instance = 'game'", "UPDATE tweaks SET kind = 3, now = 'game'",
        "UPDATE tweaks SET kind = 3, now = '..'",
        "UPDATE tweaks SET was_text = replace(hex(zeroblob(100000)), '0', 'x')");
    const GameFolder folder;
    leave(folder, sql);
    Run run(folder);
    INFO(sql);
    REQUIRE(run.reported.size() == 1);
    INFO(run.reported[0]);
    CHECK(has(run.reported[0],
              "1 row that an earlier run has left is not a tweak, and is left aside: "));
    CHECK(run.tweaks->open_earlier() == 0);
    const Handle b = run.add("Thing", "b");
    run.person([&] { run.tree.set(b, "number", 4.0); });
    CHECK(run.tweaks->keep("**").count == 1);
    CHECK(has(folder.text("main.tweaks.json"), "\"world.b.number\": 4"));
    // It can be dropped and is then not reported again.
    CHECK(run.tweaks->drop("**").count == 1);
    Run next(folder);
    CHECK(next.reported.empty());
    CHECK(next.tweaks->drop("**").count == 0);
}

TEST_CASE("several invalid rows are reported in one sentence") {
    const GameFolder folder;
    {
        Run run(folder);
        const Handle a = run.add("Thing", "a");
        run.person([&] { run.tree.set(a, "density", 3.0), run.tree.set(a, "number", 3.0); });
    }
    change(folder, "UPDATE tweaks SET now = '{}'");
    Run run(folder);
    REQUIRE(run.reported.size() == 1);
    CHECK(has(run.reported[0],
              "2 rows that earlier runs have left are not tweaks, and are left aside"));
    CHECK(has(run.reported[0], "drop_tweaks(\"**\") removes them"));
    CHECK(run.tweaks->drop("world.other.*").count == 0);
    CHECK(run.tweaks->drop("world.a.density").count == 1);
    CHECK(run.tweaks->drop("**").count == 1);
    CHECK(Run(folder).reported.empty());
}

TEST_CASE("every accepted edit can be kept with texts of any length") {
    const GameFolder folder;
    {
        Run run(folder);
        Handle at = run.add("Thing", "a");
        const std::string name = std::string(999, 'x');
        run.barrier();
        run.person([&] {
            CHECK_THROWS_AS(run.tree.set_or_add(at, name + "yy", Value(1.0)), Error);
            CHECK_THROWS_AS(run.add("Thing", at, name + "yy"), Error);
            CHECK_THROWS_AS(run.tree.rename(at, name + "yy"), Error);
        });
        for (int i = 0; i < 30; ++i) at = run.add("Thing", at, name + "y");
        run.barrier();
        run.person([&] { run.tree.set_or_add(at, name + "z", Value(1.0)); });
        run.person([&] {
            run.tree.set_formula(at, "number",
                                 {.function = [](const Tree&) { return Value(2.0); },
                                  .source = "2.0" + std::string(100'000, ' ') + "--"});
        });
    }
    Run run(folder);
    CHECK(run.reported.empty());
    CHECK(run.tweaks->open_earlier() == 2);
    CHECK(run.tweaks->keep("**").count == 2);
}

TEST_CASE("a tweak that is too large to be read again is not journaled and this is reported",
          "[long]") {
    const GameFolder folder;
    {
        Run run(folder);
        const Handle thing = run.add("Thing", "a");
        run.barrier();
        run.person([&] {
            run.tree.set_or_add(thing, "brief_text", Value("x"));
            run.tree.set_or_add(thing, "long_text", Value("x"));
        });
        CHECK(run.reported.empty());
        // A zero byte has six letters in JSON.
        run.person(
            [&] { run.tree.set_or_add(thing, "long_text", Value(std::string(12 << 20, '\0'))); });
        CHECK(run.reported ==
              std::vector<std::string>{
                  "the tweak of world.a.long_text is larger than 64 MB, so it cannot "
                  "be journaled; it is lost when the game ends"});
        REQUIRE(run.tweaks->list().size() == 2);
    }
    {
        Run run(folder);
        CHECK(run.reported.empty());
        REQUIRE(run.tweaks->list().size() == 1);
        CHECK(run.tweaks->list().front().path == "world.a.brief_text");
        // One that is small again is journaled.
        const Handle thing = run.add("Thing", "a");
        run.barrier();
        run.person(
            [&] { run.tree.set_or_add(thing, "long_text", Value(std::string(80 << 20, 'x'))); });
        run.person([&] { run.tree.set_or_add(thing, "long_text", Value("y")); });
        CHECK(run.reported.size() == 1);
    }
    CHECK(Run(folder).tweaks->list().size() == 2);
}

TEST_CASE(
    "a tweak that the file of kept tweaks cannot contain is reported and the others are kept") {
    const GameFolder folder;
    const int before = GENERATE(0, 1, 2);
    {
        Run run(folder);
        run.person([&] {
            for (const int i : {0, 1, 2}) {
                const std::string name = i == before ? "deep" : "t" + std::to_string(i);
                run.tree.set_or_add(run.world, name, Value(List{Value(1.0)}));
            }
        });
    }
    // As deep as a row may be, which is deeper than a value inside of a file may be.
    const std::string deep = std::string(999, '[') + std::string(999, ']');
    change(folder, "UPDATE tweaks SET now = '{\"value\": " + deep + "}' WHERE property = 'deep'");
    Run run(folder);
    const TweakReport report = run.tweaks->keep("**");
    CHECK(report.count == 2);
    CHECK(report.files.size() == 1);
    REQUIRE(report.problems.size() == 1);
    CHECK(has(report.problems[0], "world.deep: "));
    CHECK(has(folder.text("main.tweaks.json"), "\"world.t"));
    CHECK(Run(folder).tweaks->open_earlier() == 1);
}

TEST_CASE("a row with a file outside of the game is refused") {
    const GameFolder folder;
    const fs::path outside = folder.path().parent_path() / "outside.json";
    leave(folder, "UPDATE tweaks SET file = '" + outside.string() + "'");
    fs::copy_file(folder / "level.json", outside);
    Run run(folder);
    run.load(folder, "level.json");
    CHECK(run.tweaks->keep("**").files ==
          std::vector<std::string>{(folder / "main.tweaks.json").string()});
    CHECK(fs::file_size(outside) == std::string(level).size());
}

TEST_CASE("an unknown key in a file of kept tweaks is reported with the nearest one") {
    const GameFolder folder;
    folder.write("main.tweaks.json",
                 "{\n  \"fettle_tweaks\": 1,\n  \"valeus\": {\"world.a.number\": 3}\n}\n");
    Run run(folder);
    REQUIRE(run.reported.size() == 1);
    CHECK(has(run.reported[0], "main.tweaks.json:3:3: "));
    CHECK(has(run.reported[0], "no key \"valeus\" (did you mean \"values\"?)"));
}

TEST_CASE("a part of a value in the kept tweaks is named and so is a version of another type") {
    const GameFolder folder;
    folder.write("main.tweaks.json",
                 "{\n\"fettle_tweaks\": 1, \"values\": {\n\"world.t.position.x\": 7}}");
    {
        Run run(folder);
        run.add("Thing", "t");
        run.barrier();
        run.tweaks->game_loaded();
        REQUIRE(run.reported.size() == 1);
        CHECK(has(run.reported[0],
                  "world.t.position is a property: write its whole value, as in "
                  "\"world.t.position\": "));
    }
    folder.write("main.tweaks.json", "{\n\"fettle_tweaks\": \"1\"}");
    Run run(folder);
    REQUIRE(run.reported.size() == 1);
    CHECK(
        has(run.reported[0],
            "main.tweaks.json:2:18: no file of tweaks: \"fettle_tweaks\": expected the version of "
            "the format, which is a whole number, found a text"));
}

}  // namespace forged_tweaks_test
