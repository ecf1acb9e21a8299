// Keeping tweaks: a scene file changes only at the edited values; tweaks of instances of scripts
// are in a separate file.

#include <fettle/property/storage/game_files.h>
#include <fettle/property/storage/tweaks.h>

#include <functional>

#include "catch.h"
#include "game_folder.h"
#include "tweak_run.h"

namespace keep_test {

using namespace scene_test;

namespace {

const char* const level =
    "// The first level.\n"
    "{\n"
    "  \"fettle_scene\": 1,\n"
    "  \"class\": \"Object\",\n"
    "  \"name\": \"level\",\n"
    "  \"editor\": {\"zoom\": 2},          // not ours\n"
    "  \"children\": [\n"
    "    {\n"
    "      \"class\": \"Thing\",\n"
    "      \"name\": \"a\",                // the hero\n"
    "      \"properties\": {\n"
    "        \"number\": 0.50,            /* half */\n"
    "        \"kind\":   \"static\"         // heavy\n"
    "      }\n"
    "    },\n"
    "    { \"class\": \"Thing\", \"name\": \"b\", \"properties\": { \"flag\": true } },\n"
    "    {\n"
    "      \"class\": \"Note\",\n"
    "      \"name\": \"n\"\n"
    "    }\n"
    "  ]\n"
    "}\n";

/// The lines that differ, in the form of `diff`.
std::string changes(const std::string& before, const std::string& after) {
    const auto lines = [](const std::string& text) {
        std::vector<std::string> all;
        for (std::size_t at = 0; at < text.size();) {
            const std::size_t end = std::min(text.find('\n', at), text.size());
            all.push_back(text.substr(at, end - at));
            at = end + 1;
        }
        return all;
    };
    std::vector<std::string> a = lines(before), b = lines(after);
    while (!a.empty() && !b.empty() && a.back() == b.back()) a.pop_back(), b.pop_back();
    std::size_t same = 0;
    while (same < a.size() && same < b.size() && a[same] == b[same]) ++same;
    std::string out;
    for (std::size_t i = same; i < a.size(); ++i) out += "-" + a[i] + "\n";
    for (std::size_t i = same; i < b.size(); ++i) out += "+" + b[i] + "\n";
    return out;
}

/// Loads the level, edits it as a person and keeps everything; returns the changes of the file.
template <class F>
std::string kept(F edit, const std::string& text = level) {
    const GameFolder folder;
    folder.write("level.json", text);
    Run run(folder);
    run.load(folder, "level.json");
    run.person([&] { edit(run); });
    const TweakReport report = run.tweaks->keep("**");
    INFO((report.problems.empty() ? std::string() : report.problems[0]));
    CHECK(report.problems.empty());
    CHECK(Run(folder).lines().empty());
    CHECK_FALSE(std::filesystem::exists(folder / "main.tweaks.json"));
    // The next run loads the kept values.
    Run next(folder);
    next.load(folder, "level.json");
    CHECK(next.everything() == run.everything());
    return changes(text, folder.text("level.json"));
}

}  // namespace

TEST_CASE("keeping a value changes only that value in its scene file") {
    CHECK(kept([](Run& run) { run.tree.set(run.at("world.level.a"), "number", 7.0); }) ==
          "-        \"number\": 0.50,            /* half */\n"
          "+        \"number\": 7,            /* half */\n");
    CHECK(kept([](Run& run) { run.tree.set(run.at("world.level.b"), "flag", false); }) ==
          "-    { \"class\": \"Thing\", \"name\": \"b\", \"properties\": { \"flag\": true } },\n"
          "+    { \"class\": \"Thing\", \"name\": \"b\" },\n");
}

TEST_CASE("a property that is new in the file is inserted at its place in the order") {
    CHECK(kept([](Run& run) { run.tree.set(run.at("world.level.a"), "small", 0.1); }) ==
          "+        \"small\": 0.1,\n");
    CHECK(kept([](Run& run) { run.tree.set(run.at("world.level.a"), "mass", INFINITY); }) ==
          "-        \"kind\":   \"static\"         // heavy\n"
          "+        \"kind\":   \"static\",         // heavy\n"
          "+        \"mass\": \"inf\"\n");
    CHECK(kept([](Run& run) { run.tree.set(run.at("world.level.b"), "number", -0.0); }) ==
          "-    { \"class\": \"Thing\", \"name\": \"b\", \"properties\": { \"flag\": true } },\n"
          "+    { \"class\": \"Thing\", \"name\": \"b\", \"properties\": { \"number\": -0.0, "
          "\"flag\": true } },\n");
    CHECK(kept([](Run& run) { run.tree.set(run.at("world.level.n"), "text", "hi"); }) ==
          "-      \"name\": \"n\"\n"
          "+      \"name\": \"n\",\n"
          "+      \"properties\": {\n"
          "+        \"text\": \"hi\"\n"
          "+      }\n");
    CHECK(kept([](Run& run) {
              run.tree.set(run.at("world.level.n"), "target", run.at("world.level.a"));
          }).find("+        \"target\": \".a\"\n") != std::string::npos);
    CHECK(kept([](Run& run) { run.tree.set_or_add(run.at("world.level"), "lives", 3); }) ==
          "+  \"ad_hoc\": {\n+    \"lives\": 3\n+  },\n");
}

TEST_CASE("a value set back to its default is removed from the file") {
    CHECK(kept([](Run& run) {
              run.tree.reset(run.at("world.level.a"),
                             run.tree.property(run.at("world.level.a"), "number"));
          }) == "-        \"number\": 0.50,            /* half */\n");
    CHECK(kept([](Run& run) { run.tree.set(run.at("world.level.a"), "kind", "dynamic"); }) ==
          "-        \"number\": 0.50,            /* half */\n"
          "-        \"kind\":   \"static\"         // heavy\n"
          "+        \"number\": 0.50            /* half */\n");
}

TEST_CASE("created and deleted and renamed instances change only their own lines") {
    CHECK(kept([](Run& run) {
              const Handle made = run.tree.create(run.tree.class_named("Thing"), {}, "c");
              run.tree.set(made, "number", 2.0);
              run.tree.move(made, run.at("world.level"), "c");
          }) ==
          "+    },\n"
          "+    {\n"
          "+      \"class\": \"Thing\",\n"
          "+      \"name\": \"c\",\n"
          "+      \"properties\": {\n"
          "+        \"number\": 2\n"
          "+      }\n");
    CHECK(kept([](Run& run) { run.tree.destroy(run.at("world.level.b")); }) ==
          "-    { \"class\": \"Thing\", \"name\": \"b\", \"properties\": { \"flag\": true } },\n");
    CHECK(kept([](Run& run) { run.tree.rename(run.at("world.level.a"), "hero"); }) ==
          "-      \"name\": \"a\",                // the hero\n"
          "+      \"name\": \"hero\",                // the hero\n");
}

TEST_CASE("keeping many tweaks leaves the other text of the file") {
    std::string windows = level;
    for (std::size_t at = windows.find('\n'); at != std::string::npos;
         at = windows.find('\n', at + 2))
        windows.replace(at, 1, "\r\n");
    for (const std::string& text : {std::string(level), windows}) {
        const GameFolder folder;
        folder.write("level.json", text);
        Run run(folder);
        run.load(folder, "level.json");
        run.person([&] {
            for (const char* name : {"a", "b"}) {
                const Handle each = run.at("world.level." + std::string(name));
                run.tree.set(each, "number", 3.0);
                run.tree.set(each, "position", Vec2(1, 2));
                run.tree.set_or_add(each, "note", "hello");
                run.tree.create(run.tree.class_named("Thing"), each, "inner");
            }
        });
        CHECK(run.tweaks->keep("world.level").count == 8);
        const std::string now = folder.text("level.json");
        for (const char* part : {"// The first level.", "// not ours", "\"editor\": {\"zoom\": 2}",
                                 "/* half */", "// heavy", "// the hero"})
            CHECK(now.find(part) != std::string::npos);
        const bool mixed =
            text == windows && now.find("\r\n") != std::string::npos &&
            std::count(now.begin(), now.end(), '\n') != std::count(now.begin(), now.end(), '\r');
        CHECK_FALSE(mixed);
        Run next(folder);
        next.load(folder, "level.json");
        CHECK(next.everything() == run.everything());
    }
}

TEST_CASE("only the tweaks that match the pattern are kept") {
    const GameFolder folder;
    folder.write("level.json", level);
    Run run(folder);
    run.load(folder, "level.json");
    run.person([&] {
        run.tree.set(run.at("world.level.a"), "number", 7.0);
        run.tree.set(run.at("world.level.b"), "number", 8.0);
    });
    CHECK(run.tweaks->keep("world.nobody.*").count == 0);
    CHECK(run.tweaks->keep("world.level.b.*").count == 1);
    CHECK(run.lines() ==
          std::vector<std::string>{"world.level.a.number: 0.5 → 7",
                                   "world.level.b.number: 0 → 8 kept in level.json"});
    CHECK(Run(folder).lines() == std::vector<std::string>{"earlier world.level.a.number: 0.5 → 7"});
    CHECK_THROWS_AS(run.tweaks->keep("world..x"), Error);
    // The next run can keep the remaining tweaks even before it has loaded anything.
    Run next(folder);
    CHECK(next.tweaks->keep("**").files ==
          std::vector<std::string>{(folder / "level.json").string()});
    CHECK(folder.text("level.json").find("\"number\": 7,") != std::string::npos);
}

TEST_CASE("a scene file that cannot be edited keeps its text and the tweaks stay open") {
    const GameFolder folder;
    folder.write("level.json", level);
    Run run(folder);
    run.load(folder, "level.json");
    run.person([&] {
        run.tree.set(run.at("world.level.a"), "number", 7.0);
        run.tree.set(run.add("Thing", "own"), "number", 8.0);
    });
    const std::string broken = std::string(level).substr(0, 300);
    folder.write("level.json", broken);
    const TweakReport report = run.tweaks->keep("**.number");
    CHECK(report.count == 0);
    REQUIRE(report.problems.size() == 1);
    CHECK(report.problems[0].find("level.json:") != std::string::npos);
    CHECK(folder.text("level.json") == broken);
    CHECK(Run(folder).tweaks->open_earlier() == 2);
}

TEST_CASE(
    "a tweak of an instance of a script is kept by path and set when the instance is made again") {
    const GameFolder folder;
    {
        Run run(folder);
        const Handle a = run.add("Thing", "a"), b = run.add("Thing", "my b");
        run.person([&] {
            run.tree.set(a, "position", Vec2(1, INFINITY));
            run.tree.set_or_add(b, "lives", 3);
            run.tree.set(run.add("Note", "n"), "target", b);
        });
        CHECK(run.tweaks->keep("world").count == 3);
    }
    CHECK(folder.text("main.tweaks.json") ==
          "{\n"
          "  \"fettle_tweaks\": 1,\n"
          "  \"values\": {\n"
          "    \"world.a.position\": [1, \"inf\"],\n"
          "    \"world[\\\"my b\\\"].lives\": 3\n"
          "  },\n"
          "  \"created\": {\n"
          "    \"world.n\": {\n"
          "      \"fettle_scene\": 1,\n"
          "      \"class\": \"Note\",\n"
          "      \"name\": \"n\",\n"
          "      \"properties\": {\n"
          "        \"target\": \"world[\\\"my b\\\"]\"\n"
          "      }\n"
          "    }\n"
          "  }\n"
          "}\n");
    Run run(folder);
    const Handle a = run.add("Thing", "a");
    run.tweaks->placed(a);
    CHECK(run.tree.get(a, "position") == Value(Vec2(1, INFINITY)));
    run.tree.set(a, "position", Vec2(0, 0));  // the script initializes it
    const Handle b = run.add("Thing", "my b");
    run.tweaks->game_loaded();
    CHECK(run.tree.get(a, "position") == Value(Vec2(1, INFINITY)));
    CHECK(run.tree.get(b, "lives") == Value(3));
    REQUIRE(run.at("world.n"));
    CHECK(run.tree.get(run.at("world.n"), "target") == Value(b));
    CHECK(run.lines().empty());
    run.barrier();
    CHECK(run.lines().empty());

    // Another edit and another deletion change the same file.
    run.person([&] { run.tree.set(a, "position", Vec2(5, 5)); });
    run.person([&] { run.tree.destroy(run.at("world.n")); });
    run.person([&] { run.tree.destroy(b); });
    CHECK(run.tweaks->keep("**").problems.empty());
    CHECK(folder.text("main.tweaks.json") ==
          "{\n"
          "  \"fettle_tweaks\": 1,\n"
          "  \"values\": {\n"
          "    \"world.a.position\": [5, 5]\n"
          "  },\n"
          "  \"deleted\": [\n"
          "    \"world[\\\"my b\\\"]\"\n"
          "  ]\n"
          "}\n");
}

TEST_CASE("an invalid file of kept tweaks is reported and never overwritten") {
    const GameFolder folder;
    const std::string bad =
        GENERATE(as<std::string>{}, "{\"fettle_tweaks\": 1, \"values\": {\"world.a.number\": }}",
                 "{\"fettle_tweaks\": 2, \"values\": {}}", "{\"values\": {}}", "[]",
                 "{\"fettle_tweaks\": 1, \"values\": {\"world[3].a\": 1}}");
    folder.write("main.tweaks.json", bad);
    Run run(folder);
    REQUIRE(run.reported.size() == 1);
    CHECK(run.reported[0].find("main.tweaks.json:1:") != std::string::npos);
    const Handle a = run.add("Thing", "a");
    run.tweaks->game_loaded();
    run.person([&] { run.tree.set(a, "number", 2.0); });
    const TweakReport report = run.tweaks->keep("**");
    CHECK(report.count == 0);
    CHECK(report.problems.size() == 1);
    CHECK(folder.text("main.tweaks.json") == bad);
    CHECK(Run(folder).tweaks->open_earlier() == 1);
}

TEST_CASE("a kept value that no longer fits is reported with its place and the others are set") {
    const GameFolder folder;
    folder.write("main.tweaks.json",
                 "{\n  \"fettle_tweaks\": 1,\n  \"values\": {\n"
                 "    \"world.a.density\": -3,\n    \"world.a.number\": 4,\n"
                 "    \"world.a.nmber\": 4,\n    \"world.b.number\": 4\n  }\n}\n");
    Run run(folder);
    const Handle a = run.add("Thing", "a");
    run.tweaks->placed(a);
    run.tweaks->placed(a);
    CHECK(run.tree.get(a, "number") == Value(4.0));
    REQUIRE(run.reported.size() == 2);
    CHECK(run.reported[0].find("main.tweaks.json:4:24: world.a.density: ") != std::string::npos);
    CHECK(run.reported[1].find("main.tweaks.json:6:22: world.a") != std::string::npos);
}

TEST_CASE("kept tweaks without a target are reported with their place") {
    const GameFolder folder;
    folder.write("main.tweaks.json",
                 "{\n  \"fettle_tweaks\": 1,\n  \"values\": {\n"
                 "    \"world.a.number\": 4,\n    \"world.wal.number\": 4\n  },\n"
                 "  \"created\": {\n"
                 "    \"world.gone.lamp\": {\"fettle_scene\": 1, \"class\": \"Nothing\"},\n"
                 "    \"world.odd\": {\"fettle_scene\": 1, \"class\": \"Nothing\"}\n  },\n"
                 "  \"deleted\": [\"world.old\"]\n}\n");
    Run run(folder);
    const Handle a = run.add("Thing", "a");
    run.add("Thing", "wall");
    run.tweaks->game_loaded();
    CHECK(run.tree.get(a, "number") == Value(4.0));
    REQUIRE(run.reported.size() == 4);
    CHECK_THAT(run.reported[0],
               contains("main.tweaks.json:11:15: world.old: there is no world.old") &&
                   contains("nothing to delete"));
    CHECK_THAT(run.reported[1],
               contains("main.tweaks.json:8:5: world.gone.lamp: there is no world.gone"));
    CHECK_THAT(run.reported[2], contains("main.tweaks.json:9") && contains("Nothing"));
    CHECK_THAT(run.reported[3], contains("main.tweaks.json:5:5: world.wal.number: there is no "
                                         "world.wal") &&
                                    contains("\"wall\"") && contains("is set when"));
    // An instance that is made later gets its value.
    const Handle late = run.add("Thing", "wal");
    run.tweaks->placed(late);
    CHECK(run.tree.get(late, "number") == Value(4.0));
}

TEST_CASE("thousands of tweaks are kept and renamed and removed together") {
    const GameFolder folder;
    const int many = 3000;
    std::vector<Handle> made;
    Run run(folder);
    run.person([&] {
        for (int i = 0; i < many; ++i)
            made.push_back(run.add("Thing", ("t" + std::to_string(i)).c_str()));
    });
    CHECK(run.tweaks->keep("**").count == std::size_t(many));
    // Keeps them again, which replaces them; at last they are removed.
    run.person([&] {
        for (const Handle each : made) run.tree.set(each, "number", 7.0);
    });
    run.tweaks->keep("**");
    CHECK((folder.text("main.tweaks.json").find("world.t2999") != std::string::npos));
    // Renames the instances and back.
    for (const char* name : {"r", "t"}) {
        run.person([&] {
            for (int i = 0; i < many; ++i)
                run.tree.rename(made[std::size_t(i)], name + std::to_string(i));
        });
        CHECK(run.tweaks->keep("**").count == std::size_t(many));
    }
    run.person([&] {
        for (int i = 1; i < many; ++i) run.tree.destroy(made[std::size_t(i)]);
    });
    run.tweaks->keep("**");
    const std::string text = folder.text("main.tweaks.json");
    CHECK_THAT(text, contains("\"world.t0\": {") && contains("\"world.t0.number\": 7"));
    CHECK((text.find("world.t2999") == std::string::npos));
}

TEST_CASE("tweaks of earlier runs are the same after conversion to text") {
    const GameFolder folder;
    {
        Run run(folder);
        const Handle a = run.add("Thing", "a");
        const Handle wall = run.add("Thing", "wall");
        const Handle old = run.add("Thing", "old");
        run.barrier();
        run.person([&] {
            run.tree.set(a, "number", Value(2.5));
            run.tree.destroy(wall);
            run.tree.rename(old, "renamed");
            run.add("Thing", "lamp");
        });
    }
    std::vector<TweakWords> words;
    {
        Run run(folder);
        words = run.tweaks->earlier_in_words();
    }
    REQUIRE(words.size() == 4);
    const std::string journal = folder.text(".fettle/main.tweaks.sqlite");
    SceneWorld again;
    const Handle a = again.add("Thing", "a");
    again.add("Thing", "wall");
    again.add("Thing", "old");
    GameFiles files;
    files.stay_in_memory();
    Tweaks tweaks(again.tree, folder.path(), [](const std::string& text) { FAIL(text); },
                  {.files = &files, .earlier = words});
    CHECK(tweaks.open_earlier() == 4);
    CHECK(tweaks.earlier_in_words() == words);
    const auto person = [&](const std::function<void()>& edit) {
        const Tree::CauseScope scope(again.tree, Writer::console);
        edit();
        again.tree.barrier();
        tweaks.barrier();
    };
    person([&] { CHECK(tweaks.reapply("**").count == 4); });
    CHECK(again.tree.get(a, "number") == Value(2.5));
    CHECK_FALSE(again.tree.child(again.world, "wall"));
    CHECK(again.tree.child(again.world, "renamed"));
    CHECK(again.tree.child(again.world, "lamp"));
    // Tweaks that are made then can be kept, in memory.
    const TweakReport kept = tweaks.keep("world.a.*");
    CHECK(kept.count == 1);
    CHECK(files.read(folder / "main.tweaks.json").find("\"world.a.number\": 2.5") !=
          std::string::npos);
    CHECK_FALSE(std::filesystem::exists(folder / "main.tweaks.json"));
    CHECK(folder.text(".fettle/main.tweaks.sqlite") == journal);
    CHECK_THROWS_AS(Tweaks(again.tree, folder.path(), {}, {.earlier = {{{"value", "1"}}}}), Error);
}

TEST_CASE("the last writer of a kept value is the line of the file") {
    const GameFolder folder;
    folder.write("main.tweaks.json",
                 "{\n  \"fettle_tweaks\": 1,\n  \"values\": {\n    \"world.mark\": 2\n  }\n}\n");
    Run run(folder);
    run.tree.set_or_add(run.world, "mark", 1);
    run.tweaks->game_loaded();
    const auto writer = [&] {
        return run.tree.last_writer(run.world, *run.tree.find(run.world, "mark")).cause;
    };
    CHECK(run.tree.get(run.world, "mark") == Value(2));
    CHECK(writer().where == "main.tweaks.json:4");
    run.tree.set(run.world, "mark", Value(3));  // places are found for kept values only
    CHECK(writer().where.empty());
}

}  // namespace keep_test
