// Reloading a module while its instances exist.

#include <catch.h>

#include "weather.h"

namespace reload_test {

using namespace fettle;
using namespace fettle::module::testing;
using property::Handle;
using property::Value;

namespace {

struct Game {
    ModuleFile file{"weather"};
    module::Plugins plugins;
    property::Tree tree;
    module::Plugin& weather = plugins.open(file.path());
    Handle front, low, loose;

    Game() {
        weather.attach(tree);
        const property::Class& cloud = tree.class_named("Cloud");
        front = tree.child(tree.root(), "front");
        low = tree.create(cloud, front, "low");
        loose = tree.create(cloud);
        tree.set(front, "water", 12.5);
        tree.set(front, "kind", "cirrus");
        tree.set(low, "height", 7);
        tree.set(low, "label", "fog");
        tree.set_or_add(low, "owner", "me");
        tree.set(loose, "water", 3.0);
    }
};

}  // namespace

TEST_CASE("instances survive a reload of their module") {
    Game game;
    const bool other = GENERATE(false, true);
    if (other) game.file.become("other_layout");
    const module::Reloaded reloaded = game.weather.reload();
    CHECK(reloaded.instances == 3);
    CHECK(game.tree.alive(game.front));
    CHECK(game.tree.get(game.front, "water") == Value(12.5));
    CHECK(game.tree.get(game.front, "kind") == Value("cirrus"));
    CHECK(game.tree.get(game.front, "height") == Value(100.0));
    CHECK(game.tree.get(game.low, "height") == Value(7.0));
    CHECK(game.tree.get(game.low, "label") == Value("fog"));
    CHECK(game.tree.get(game.low, "owner") == Value("me"));
    CHECK(game.tree.get(game.loose, "water") == Value(3.0));
    CHECK(game.tree.path(game.low) == "front.low");
    CHECK(game.tree.children(game.tree.root()).size() == 1);
}

TEST_CASE("a reloaded module computes with the memory of the new one") {
    Game game;
    game.file.become("other_layout");
    game.weather.reload();
    game.weather.step(0.5);
    CHECK(game.tree.get(game.front, "water") == Value(13.0));
    game.tree.call(game.front, "rain", {Value(1.0)});
    CHECK(game.tree.get(game.front, "water") == Value(12.0));
    game.tree.destroy(game.low);
    CHECK(game.tree.create(game.tree.class_named("Cloud"), game.front));
    // Reloads the first version again.
    game.file.become("weather");
    CHECK(game.weather.reload().instances == 3);
    CHECK(game.tree.get(game.front, "water") == Value(12.0));
}

TEST_CASE("watchers and formulas survive a reload of a module") {
    Game game;
    std::vector<double> seen;
    game.tree.watch(game.front, "water",
                    [&](const property::Change& c) { seen.push_back(c.new_value.number()); });
    const Handle front = game.front;
    game.tree.set_formula(game.low, "height", {.function = [front](const property::Tree& tree) {
                              return Value(tree.get(front, "water").number() * 2);
                          }});
    game.tree.barrier();
    game.file.become("other_layout");
    game.weather.reload();
    game.tree.barrier();
    CHECK(seen.empty());  // no change is reported outside the module
    game.weather.step(0.5);
    game.weather.report(game.tree);
    game.tree.barrier();
    CHECK(seen == std::vector<double>{13.0});
    CHECK(game.tree.get(game.low, "height") == Value(26.0));
}

TEST_CASE("a new module that fails leaves the old one in use") {
    Game game;
    for (const char* bad : {"crash_in_check", "fail_in_check", "retyped", "without_entry",
                            "newer_major", "missing_symbol", "same_class", "crash_when_opened"}) {
        game.file.become(bad);
        INFO(bad);
        CHECK_THROWS_AS(game.weather.reload(), module::LoadError);
        CHECK(game.tree.get(game.front, "water") == Value(12.5));
        CHECK(game.tree.get(game.low, "height") == Value(7.0));
    }
    game.weather.step(0.5);
    CHECK(game.tree.get(game.front, "water") == Value(13.0));
}

TEST_CASE("members that a new module adds or no longer has are reported") {
    Game game;
    game.file.become("other_layout");
    const module::Reloaded reloaded = game.weather.reload();
    const std::string later = " is new: it comes with the next start";
    CHECK(reloaded.notes == std::vector<std::string>{"Cloud.silver" + later,
                                                     "Cloud:survey() is gone",
                                                     "Cloud:hail()" + later, "Cloud.hailed" + later,
                                                     "Cloud: draw_over" + later});
}

#ifdef FETTLE_PHYSICS_PLUGIN
TEST_CASE("physics is reloaded with all worlds and bodies and goes on from there") {
    module::Plugins plugins;
    property::Tree tree;
    module::Plugin& physics = plugins.open(FETTLE_PHYSICS_PLUGIN);
    physics.attach(tree);
    const Handle world = tree.child(tree.root(), "world");
    const Handle mars = tree.create(tree.class_named("World"), tree.root(), "mars");
    tree.set(mars, "gravity", property::Vec2(0, -3.7));
    std::vector<Handle> balls;
    for (const Handle in : {world, mars}) {
        balls.push_back(tree.create(tree.class_named("Body"), in, "ball"));
        tree.create(tree.class_named("Circle"), balls.back());
        tree.set(balls.back(), "position", property::Vec2(1, 20));
    }
    const auto step = [&] {
        physics.step(1.0 / 60);
        physics.report(tree);
        tree.barrier();
    };
    for (int i = 0; i < 30; ++i) step();
    const Value position = tree.get(balls[1], "position"),
                velocity = tree.get(balls[0], "velocity");
    const module::Reloaded reloaded = physics.reload();
    CHECK(reloaded.instances == 6);
    CHECK(reloaded.notes.empty());
    CHECK(tree.child(tree.root(), "world") == world);
    CHECK(tree.get(balls[1], "position") == position);
    CHECK(tree.get(balls[0], "velocity") == velocity);
    for (int i = 0; i < 30; ++i) step();
    CHECK(tree.get(balls[0], "velocity").vec2().y < velocity.vec2().y - 4);
    CHECK(tree.get(balls[1], "position").vec2().y < position.vec2().y);
}
#endif

TEST_CASE("a module whose tree has ended is not reloaded") {
    module::Plugins plugins;
    module::Plugin& weather = plugins.open(built("weather"));
    {
        property::Tree tree;
        weather.attach(tree);
    }
    CHECK_THROWS_WITH(weather.reload(), contains("weather cannot be reloaded: its tree has ended"));
}

}  // namespace reload_test
