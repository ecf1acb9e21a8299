// Names that are kept while other tweaks wait: those of this run, those of earlier runs, and what a
// kept deletion removed.

#include "catch.h"
#include "game_folder.h"
#include "tweak_run.h"

namespace kept_names_test {

using namespace scene_test;

namespace {

const char* const level =
    "{\n"
    "  \"fettle_scene\": 1,\n"
    "  \"class\": \"Object\",\n"
    "  \"name\": \"level\",\n"
    "  \"children\": [\n"
    "    {\"class\": \"Object\", \"name\": \"b\", \"children\": [\n"
    "      {\"class\": \"Thing\", \"name\": \"c\", \"properties\": {\"number\": 0.5}}\n"
    "    ]},\n"
    "    {\"class\": \"Thing\", \"name\": \"d\"},\n"
    "    {\"class\": \"Thing\", \"name\": \"e\"}\n"
    "  ]\n"
    "}\n";

struct Level : GameFolder {
    Level() { write("level.json", level); }
};

struct Loaded : Run {
    explicit Loaded(const GameFolder& folder) : Run(folder) { load(folder, "level.json"); }
    void number(const std::string& path, double value) {
        person([&] { tree.set(at(path), "number", value); });
    }
    void rename(const std::string& path, const std::string& name) {
        person([&] { tree.rename(at(path), name); });
    }
    void kept(const std::string& pattern) {
        const TweakReport report = tweaks->keep(pattern);
        CAPTURE(pattern);
        CHECK(report.problems == std::vector<std::string>());
        CHECK(report.count == 1);
    }
};

/// The number of the part when the game begins again.
double number_in(const GameFolder& folder) {
    Loaded next(folder);
    CHECK(next.lines() == std::vector<std::string>());
    const Handle part = next.at("world.level.x.c");
    return part ? next.tree.get(part, "number").number() : -1;
}

}  // namespace

TEST_CASE("a value is kept in a later run after the new name above it was kept") {
    const Level folder;
    {
        Loaded run(folder);
        run.number("world.level.b.c", 2);
        run.rename("world.level.b", "x");
        run.kept("world.level.b");
    }
    Loaded(folder).kept("**");
    CHECK(number_in(folder) == 2);
}

TEST_CASE("a value of an earlier run is kept after the new name above it was kept") {
    const bool in_the_same_run = GENERATE(false, true);
    CAPTURE(in_the_same_run);
    const Level folder;
    {
        Loaded run(folder);
        run.number("world.level.b.c", 2);
        run.rename("world.level.b", "x");
    }
    {
        Loaded run(folder);
        run.kept("world.level.b");
        if (in_the_same_run) run.kept("**");
    }
    if (!in_the_same_run) Loaded(folder).kept("**");
    CHECK(number_in(folder) == 2);
}

TEST_CASE("a value of an earlier run is kept after a name that a later run gave was kept") {
    const Level folder;
    Loaded(folder).number("world.level.b.c", 2);
    {
        Loaded run(folder);
        run.rename("world.level.b", "x");
        run.kept("world.level.*");
        CHECK(run.lines().front().find("earlier world.level.x.c.number: ") == 0);
    }
    Loaded(folder).kept("**");
    CHECK(number_in(folder) == 2);
}

TEST_CASE("an undone deletion returns to its place although its neighbor was renamed meanwhile") {
    const Level folder;
    Loaded run(folder);
    run.person([&] { run.tree.destroy(run.at("world.level.d")); });
    run.kept("**");
    run.rename("world.level.b", "x");
    run.kept("**");
    (void)run.tree.undo();
    (void)run.tree.undo();
    run.barrier();
    CHECK(run.tweaks->keep("**").problems == std::vector<std::string>());
    CHECK(folder.text("level.json") == level);
}

TEST_CASE("a kept deletion is unchanged when another instance of that name is renamed") {
    const Level folder;
    Loaded run(folder);
    run.person([&] { run.tree.destroy(run.at("world.level.e")); });
    run.kept("**");
    run.rename("world.level.d", "e");
    run.kept("**");
    run.rename("world.level.e", "f");
    run.kept("**");
    for (int i = 0; i < 3; ++i) (void)run.tree.undo();
    run.barrier();
    CHECK(run.tweaks->keep("**").problems == std::vector<std::string>());
    CHECK(folder.text("level.json") == level);
}

TEST_CASE("a part that the file of kept tweaks moves stays its own when a script is loaded again") {
    const Level folder;
    Run run(folder);
    std::vector<SceneInstance> instances;
    load_scene(run.tree, folder / "level.json", run.world, {}, nullptr, &instances);
    run.tweaks->scene_loaded(folder / "level.json", instances);
    run.person([&] { run.tree.move(run.at("world.level.d"), run.at("world.level.b"), "d"); });
    CHECK(run.tweaks->keep("**").problems == std::vector<std::string>());
    run.tweaks->scene_loaded(folder / "level.json", instances);  // for the living instances
    run.person([&] { run.tree.set(run.at("world.level.b.d"), "number", 7); });
    const TweakReport report = run.tweaks->keep("**");
    CHECK(report.problems == std::vector<std::string>());
    CHECK(report.notes == std::vector<std::string>());
    CHECK(folder.text("level.json") == level);
    CHECK(folder.text("main.tweaks.json").find("\"world.level.b.d.number\": 7") !=
          std::string::npos);
}

TEST_CASE("the function for warnings may keep tweaks while kept ones are applied") {
    const GameFolder folder;
    const std::string section = GENERATE(
        as<std::string>{},
        R"("values": {"world.a.number": "no number", "world.b.number": "none", "world.c.numbr": 1})",
        R"("values": {"world.nobody.number": 1, "world.noone.number": 2})",
        R"("deleted": ["world.nobody", "world.noone"])",
        R"("moved": {"world.nobody": "world.a", "world.noone": "world.b"})",
        R"("created": {"world.nobody.x": {"class": "Nothing"}, "world.noone.y": {"class": "No"}})");
    CAPTURE(section);
    folder.write("main.tweaks.json", "{\"fettle_tweaks\": 1, " + section + "}");
    SceneWorld scene;
    for (const char* name : {"a", "b", "c"}) scene.add("Thing", name);
    std::unique_ptr<Tweaks> tweaks;
    std::vector<std::string> reported;
    tweaks = std::make_unique<Tweaks>(scene.tree, folder.path(), [&](const std::string& text) {
        reported.push_back(text);
        if (tweaks) (void)tweaks->keep("**");
    });
    {
        const Tree::CauseScope scope(scene.tree, Writer::console);
        scene.tree.set(scene.tree.child(scene.world, "c"), "number", 3.0);
    }
    tweaks->game_loaded();
    CHECK(reported.size() >= 2);
}

}  // namespace kept_names_test
