// Modules that behave differently in the game and in their trial, or that call the host wrongly.

#include <catch.h>

#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

#include "weather.h"

namespace moody_test {

using namespace fettle;
using namespace fettle::module::testing;
using property::Handle;
using property::Value;

namespace {

/// While it lives, the module refuses `what` in this process, but not in its trial.
class Refusing {
  public:
    explicit Refusing(const std::string& what) {
        setenv(name, (what + " " + std::to_string(getpid())).c_str(), 1);
    }
    ~Refusing() { unsetenv(name); }
    Refusing(const Refusing&) = delete;

  private:
    static constexpr const char* name = "FETTLE_TEST_MOODY";
};

struct Game {
    module::Plugins plugins;
    property::Tree tree;
    module::Plugin& moody = plugins.open(built("moody"));

    Game() {
        moody.on_print([](std::string_view) {});
    }
    Handle make(const char* name) {
        return tree.create(tree.class_named("Moody"), tree.root(), name);
    }
    Value call(Handle instance, const char* method) {
        return std::get<Value>(tree.call(instance, method, {}));
    }
};

std::string message_of(const std::function<void()>& action) {
    try {
        action();
    } catch (const std::exception& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("a reload that fails after its trial leaves instances without a module") {
    const std::string what = GENERATE("attach", "create");
    INFO(what);
    Game game;
    game.moody.attach(game.tree);
    const Handle one = game.make("one");
    game.tree.set(one, "mood", 5.0);
    {
        const Refusing refusing(what);
        const std::string message = message_of([&] { game.moody.reload(); });
        CHECK_THAT(message, contains("moody.so"));
        CHECK_THAT(message, contains(what == "attach" ? "no game today" : "no mood today"));
        CHECK_THAT(message, contains("not loaded any more"));
    }
    CHECK(game.tree.alive(one));
    CHECK(game.tree.get(one, "mood") == Value(7.0));  // its default
    CHECK_THROWS(game.tree.set(one, "mood", 3.0));
    CHECK_THROWS(game.tree.call(one, "speak", {}));
    CHECK_THROWS_WITH(game.make("two"), contains("not loaded any more"));
    game.moody.step(0.1);  // nothing is called
    game.moody.report(game.tree);
    CHECK(game.tree.children(game.tree.root()).size() == 1);
    const property::Snapshot snapshot = game.tree.snapshot();
    game.tree.restore(snapshot);
    // The next reload brings the module back.
    CHECK(game.moody.reload().instances == 1);
    game.tree.set(one, "mood", 3.0);
    CHECK(game.tree.get(one, "mood") == Value(3.0));
    CHECK(game.make("two"));
    game.moody.step(0.1);
    CHECK(game.tree.child(game.tree.root(), "born"));
}

TEST_CASE("a module that refuses to attach after its trial is not called any more") {
    Game game;
    {
        const Refusing refusing("attach");
        CHECK_THROWS_WITH(game.moody.attach(game.tree), contains("no game today"));
    }
    CHECK_THROWS_WITH(game.make("one"), contains("can have no instances any more"));
    game.moody.step(0.1);
    CHECK(game.tree.children(game.tree.root()).empty());
    CHECK_THROWS_WITH(game.moody.reload(), contains("attached to no tree"));
    property::Tree other;
    CHECK_THROWS_WITH(game.moody.attach(other), contains("moody is not loaded any more"));
}

TEST_CASE("a plugin that ends before its tree takes its instances with it") {
    const std::string name = GENERATE("moody", "harbor", "weather");
    INFO(name);
    property::Tree tree;
    auto plugin = module::Plugin::open(built(name));
    plugin->on_print([](std::string_view) {});
    const std::size_t before = tree.classes().size();
    plugin->attach(tree);
    REQUIRE(tree.classes().size() > before);
    const property::Class& of = *tree.classes()[before];
    const Handle one = tree.create(of, tree.root(), "one");
    const Handle loose = tree.create(of);
    plugin.reset();
    CHECK_FALSE(tree.alive(one));
    CHECK_FALSE(tree.alive(loose));
    CHECK(tree.children(tree.root()).empty());
    CHECK(tree.parts().empty());
    CHECK_THROWS_WITH(tree.create(of), contains("can have no instances any more"));
    tree.restore(tree.snapshot());
}

TEST_CASE("output of a module in its trial is not printed") {
    const TemporaryFolder folder;
    const auto file = folder.path / "printed.txt";
    const auto lines = [&] {
        std::ifstream in(file);
        std::vector<std::string> all;
        for (std::string line; std::getline(in, line);) all.push_back(line);
        return all;
    };
    Game game;
    game.moody.on_print(
        [&](std::string_view line) { std::ofstream(file, std::ios::app) << line << std::endl; });
    game.moody.attach(game.tree);
    CHECK(lines() == std::vector<std::string>{"attached"});
    game.moody.reload();
    CHECK(lines() == std::vector<std::string>{"attached", "attached"});
}

TEST_CASE("the receiver of what a module prints may replace itself") {
    Game game;
    game.moody.attach(game.tree);
    const Handle one = game.make("one");
    auto held = std::make_shared<int>();
    const std::weak_ptr<int> life = held;
    bool lived = false;
    game.moody.on_print([held = std::move(held), &game, &life, &lived](std::string_view) {
        const std::weak_ptr<int>& watched = life;
        bool& result = lived;
        game.moody.on_print([](std::string_view) {});
        result = !watched.expired();
    });
    game.tree.call(one, "speak", {});
    CHECK(lived);
    CHECK(life.expired());
}

TEST_CASE("a module is not reloaded while one of its functions runs") {
    Game game;
    game.moody.attach(game.tree);
    const Handle one = game.make("one");
    std::string refused;
    game.moody.on_print(
        [&](std::string_view) { refused = message_of([&] { game.moody.reload(); }); });
    game.tree.call(one, "speak", {});
    CHECK_THAT(refused, contains("moody cannot be reloaded while one of its functions runs"));
    game.moody.on_print([](std::string_view) {});
    CHECK(game.moody.reload().instances == 1);
}

TEST_CASE("null pointers and foreign tags from a module are refused") {
    Game game;
    game.moody.attach(game.tree);
    CHECK(game.call(game.make("one"), "misuse") == Value(16));
}

TEST_CASE("records without fields from a module are refused") {
    Game game;
    game.moody.attach(game.tree);
    const Handle one = game.make("one");
    CHECK_THROWS_WITH(game.tree.call(one, "list", {}), contains("records without fields"));
}

}  // namespace moody_test
