// A person edits a running game, and the script of the game changes: the edits stay unless the
// script changes the same value, and the list says what differs from the script.

#include <fettle/property/storage/tweaks.h>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "catch.h"
#include "playing.h"
#include "temporary_folder.h"

namespace edits_and_reload_test {

using namespace fettle;
using namespace fettle::app;
using property::Tweak;

namespace {

using Lines = std::vector<std::string>;

struct Game : TemporaryFolder {
    physics_module::PhysicsModule physics;
    property::Tree tree;
    Services services{tree};
    property::Tweaks tweaks;
    std::unique_ptr<script::Runtime> runtime;
    std::unique_ptr<Loop> loop;
    Lines errors;

    explicit Game(const std::string& script)
        : tweaks(tree, path, [this](const std::string& text) { errors.push_back(text); }) {
        physics.attach(tree);
        script::Options options;
        options.tweaks = &tweaks;
        runtime = std::make_unique<script::Runtime>(tree, options);
        loop = std::make_unique<Loop>(tree, *runtime, services);
        loop->add({.name = "physics",
                   .step = [this](double dt) { physics.step(dt); },
                   .report = [this] { physics.report(tree); },
                   .hash = [this] { return physics.hash(); }});
        loop->after_barrier([this] { tweaks.barrier(); });
        runtime->on_error(
            [this](const script::ScriptError& error) { errors.push_back(error.message); });
        write("main.lua", script);
        REQUIRE(runtime->load(path));
        tweaks.game_loaded();
        run(3);
    }
    ~Game() { CHECK(errors == Lines()); }
    void write(const std::string& name, const std::string& text) const {
        std::ofstream(path / name) << text;
    }
    void run(int steps) {
        for (int i = 0; i < steps; ++i) loop->turn();
    }
    void type(const std::string& command) {
        const auto answer = runtime->evaluate(command);
        INFO(command << ": " << (answer.error ? answer.error->message : ""));
        CHECK(answer.ok);
        run(1);
    }
    Lines change(const std::string& script) {
        write("main.lua", script);
        const script::Reloaded result = runtime->reload({"main.lua"});
        INFO((result.error ? result.error->message : ""));
        CHECK(result.done);
        run(1);
        return result.notes;
    }
    std::string value(const std::string& of) const { return tree.text(property::get(tree, of)); }
    Lines list() const {
        Lines all;
        for (const Tweak& each : tweaks.list())
            all.push_back(each.path + ": " + each.was + " → " + each.now +
                          (each.kept ? ", kept" : ""));
        return all;
    }
    std::string file(const std::string& name) const {
        std::ifstream file(path / name);
        return {std::istreambuf_iterator<char>(file), {}};
    }
};

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("an edit stays when the script changes another value") {
    Game game("world.gravity = vec(0, 0)\nworld.a = Body { mass = 2, angle = 1, Circle {} }");
    game.type("world.a.mass = 7");
    game.type("world.gravity = vec(1, 0)");
    game.type("world.a.gravity_scale is world.a.angle");
    CHECK(game.change("world.gravity = vec(0, 0)\n"
                      "world.a = Body { mass = 2, angle = 3, Circle {} }") == Lines());
    CHECK(game.value("world.a.mass") == "7");
    CHECK(game.value("world.gravity") == "vec(1, 0)");
    CHECK(game.value("world.a.gravity_scale") == game.value("world.a.angle"));
    CHECK(game.list() == Lines{"world.a.mass: 2 → 7 kg",
                               "world.gravity: vec(0, 0) → vec(1, 0) m/s²",
                               "world.a.gravity_scale: 1 → is world.a.angle"});
}

TEST_CASE("a script that changes an edited value replaces the edit and says so") {
    Game game("world.gravity = vec(0, 0) world.a = Body { mass = 2, Circle {} }");
    game.type("world.a.mass = 7");
    CHECK(game.change("world.gravity = vec(0, 0)\nworld.a = Body { mass = 3, Circle {} }") ==
          Lines{"main.lua:2 now gives world.a.mass 3 kg, in place of the edit 2 → 7 kg"});
    CHECK(game.value("world.a.mass") == "3");
    CHECK(game.list() == Lines());
    CHECK(game.tweaks.keep("**").count == 0);
    game.type("world.a.mass = 8");
    CHECK(game.list() == Lines{"world.a.mass: 3 → 8 kg"});
    game.type("undo()");
    CHECK(game.list() == Lines());
    game.type("redo()");
    CHECK(game.tweaks.keep("**").count == 1);
    CHECK(contains(game.file("main.tweaks.json"), "\"world.a.mass\": 8"));
    CHECK(contains(game.file("main.tweaks.json"), "\"world.a.mass\": 3"));
    // The file of kept values is read after the script in the next run, so it counts now, too.
    CHECK(game.change("world.gravity = vec(0, 0)\nworld.a = Body { mass = 4, Circle {} }") ==
          Lines{"main.lua:2 now gives world.a.mass 4 kg, but main.tweaks.json:4 still sets it"});
    CHECK(game.value("world.a.mass") == "8");
    CHECK(game.list() == Lines{"world.a.mass: 3 → 8 kg, kept"});
}

TEST_CASE("an edit that is written into the script is no edit any more") {
    Game game("world.a = Body { mass = 2, Circle {} } world.b = Body { Circle {} }");
    game.type("world.a.mass = 7");
    game.type("world.b.angle = 1");
    CHECK(game.change("world.a = Body { mass = 7, Circle {} }\nworld.b = Body { Circle {} }") ==
          Lines());
    CHECK(game.value("world.a.mass") == "7");
    CHECK(game.list() == Lines{"world.b.angle: 0 → 1 rad"});
    // Also at moments before the change.
    game.loop->timeline().go_to(4);
    game.run(1);
    CHECK(game.list() == Lines{"world.b.angle: 0 → 1 rad"});
    CHECK(game.tweaks.keep("**").count == 1);
    CHECK_FALSE(contains(game.file("main.tweaks.json"), "world.a"));
}

TEST_CASE("a formula that a person has given in place of one of the script stays") {
    const std::string script =
        "world.gravity = vec(0, 0) world.a = Body { angle = 2, Circle {} }\n"
        "world.a.gravity_scale = formula(function() return world.a.angle end)";
    Game game(script);
    game.type("world.a.gravity_scale is world.a.angle * 2");
    CHECK(game.change(script + "\n-- no other value") == Lines());
    CHECK(game.value("world.a.gravity_scale") == "4");
    CHECK(game.tweaks.keep("**").count == 1);
    CHECK(game.change(script) == Lines());
    CHECK(game.value("world.a.gravity_scale") == "4");
}

TEST_CASE("an edit of a value that a class gives starts from the new default") {
    const auto script = [](const std::string& lives) {
        return "Ball = class('Ball', Body) { lives = " + lives +
               " } world.a = Ball { Circle {} } world.b = Ball { Circle {} }"
               "function start() world.b.lives = 8 end";
    };
    Game game(script("3"));
    game.type("world.a.lives = 5");
    game.type("world.b.lives = 3");
    CHECK(game.change(script("4")) == Lines());
    CHECK(game.value("world.a.lives") == "5");
    CHECK(game.value("world.b.lives") == "3");
    CHECK(game.list()[0] == "world.a.lives: 4 → 5");
    CHECK(game.change(script("5")) == Lines());
    CHECK(game.list().size() == 1);
}

TEST_CASE("edits of what the script does not make any more are dropped") {
    const std::string a = "world.gravity = vec(0, 0) world.a = Body { Circle {} }\n";
    const std::string b = "world.b = Body { Circle {} }\n", c = "world.c = Body { Circle {} }\n";
    Game game(a + b + c);
    game.type("world.a.angle = 1");
    game.type("world.b.angle = 2");
    game.type("world.b.circle.radius = 2");
    game.type("world.c:delete()");
    CHECK(game.change(a) ==
          Lines{"the script does not make world.b any more, so 2 edits of it are dropped",
                "the script does not make world.c any more, so its edit is dropped"});
    CHECK(game.list() == Lines{"world.a.angle: 0 → 1 rad"});
    CHECK(game.change(a + b) == Lines());
    game.type("world.b.angle = 3");
    CHECK(game.list() == Lines{"world.a.angle: 0 → 1 rad", "world.b.angle: 0 → 3 rad"});
}

TEST_CASE("edits of an instance stay when the script gives it another class") {
    const auto script = [](const std::string& of, const std::string& mass) {
        return "Ball = class('Ball', Body) {}\nworld.gravity = vec(0, 0)\nworld.a = " + of +
               " { mass = " + mass + ", gravity_scale = 2, Circle {} }";
    };
    Game game(script("Body", "2"));
    game.type("world.a.mass = 7");
    game.type("world.a.gravity_scale = 3");
    game.type("world.a.circle.radius = 2");
    CHECK(game.change(script("Ball", "4")) ==
          Lines{"the script makes another world.a now, so an edit of it is dropped"});
    CHECK(game.value("world.a.mass") == "4");
    CHECK(game.value("world.a.gravity_scale") == "3");
    CHECK(game.value("world.a.circle.radius") == "2");
    CHECK(game.list() == Lines{"world.a.gravity_scale: 2 → 3", "world.a.circle.radius: 0.5 → 2 m"});
    game.type("world.a.gravity_scale = 2");
    CHECK(game.list() == Lines{"world.a.circle.radius: 0.5 → 2 m"});
}

TEST_CASE("what was kept in a scene file is not read as a change of that file") {
    Game game("function start() end");
    game.write(
        "level.json",
        "{\"fettle_scene\": 1, \"class\": \"Object\", \"name\": \"level\", \"children\": [\n"
        "{\"class\": \"Body\", \"name\": \"a\", \"properties\": {\"mass\": 2}, \"children\": ["
        "{\"class\": \"Circle\", \"name\": \"circle\"}]},\n"
        "{\"class\": \"Body\", \"name\": \"b\", \"children\": ["
        "{\"class\": \"Circle\", \"name\": \"circle\"}]}]}\n");
    const std::string script =
        "world.gravity = vec(0, 0) world.level = scene.load('level.json', world)";
    CHECK(game.change(script) == Lines());
    game.type("world.level.a.mass = 7");
    game.type("world.level.c = Body { Circle { radius = 2 } }");
    game.type("world.level.b.name = 'd'");
    const property::TweakReport kept = game.tweaks.keep("**");
    for (const std::string& problem : kept.problems) UNSCOPED_INFO(problem);
    CHECK(kept.count == 3);
    CHECK(contains(game.file("level.json"), "\"mass\": 7"));
    game.type("world.level.a.mass = 9");
    game.type("world.level.c.circle.radius = 3");
    game.type("world.level.d.angle = 1");
    game.runtime->run("world.level.c.gravity_scale = 3", "game");
    const Lines before = game.list();
    CHECK(game.change(script + " world.other = Object {}") == Lines());
    CHECK(game.value("world.level.a.mass") == "9");
    CHECK(game.value("world.level.c.circle.radius") == "3");
    CHECK(game.value("world.level.c.gravity_scale") == "3");
    CHECK(game.value("world.level.d.angle") == "1");
    CHECK(game.list() == before);
}

TEST_CASE("what a script gives when it is loaded again has its line as the writer") {
    Game game("world.gravity = vec(0, 0)\nworld.a = Body { mass = 2, Circle {} }");
    CHECK(game.change("world.gravity = vec(0, 1)\n\nworld.a = Body { mass = 3, Circle {} }") ==
          Lines());
    const auto writer = [&](const std::string& path, const std::string& name) {
        const property::Handle of = property::get(game.tree, path).reference();
        const property::Provenance last = game.tree.last_writer(of, *game.tree.find(of, name));
        return last.known && last.cause.writer == property::Writer::script;
    };
    CHECK(writer("world.a", "mass"));
    CHECK(writer("world", "gravity"));
}

}  // namespace edits_and_reload_test
