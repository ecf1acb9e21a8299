// Snapshots and the memory of modules in shared objects: after a restore, the game continues as it
// did before.

#include <catch.h>

#include <fettle/property/observer.h>
#include <fettle/property/snapshot.h>

#include "weather.h"

namespace snapshot_test {

using namespace fettle;
using namespace fettle::module::testing;
using property::Handle;
using property::Snapshot;
using property::Value;
using property::Vec2;

namespace {

/// A tree with one loaded test module.
struct Game {
    explicit Game(const std::filesystem::path& file) : module(plugins.open(file)) {
        module.attach(tree);
    }
    Handle make(const char* of, const char* name) {
        return tree.create(tree.class_named(of), tree.root(), name);
    }
    void step() {
        tree.set_step(tree.step() + 1);
        module.step(1.0 / 60);
        module.report(tree);
        tree.barrier();
    }
    std::vector<std::uint64_t> hashes(int steps) {
        std::vector<std::uint64_t> all;
        for (int i = 0; i < steps; ++i) {
            step();
            all.push_back(module.hash());
        }
        return all;
    }

    module::Plugins plugins;
    property::Tree tree;
    module::Plugin& module;
};

std::string message_of(const std::function<void()>& act) {
    try {
        act();
    } catch (const std::exception& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST_CASE("a snapshot restores memory that no property shows") {
    Game game(built("harbor"));
    game.make("Harbor", "north");
    game.make("Harbor", "south");
    for (int i = 0; i < 20; ++i) game.step();
    const Snapshot snapshot = game.tree.snapshot();
    const Value level = property::get(game.tree, "north.level");
    const auto expected = game.hashes(50);
    CHECK(property::get(game.tree, "north.level") != level);
    game.tree.restore(snapshot);
    CHECK(property::get(game.tree, "north.level") == level);
    CHECK(game.hashes(50) == expected);
    game.tree.restore(Snapshot::from_bytes(snapshot.to_bytes()));
    CHECK(game.hashes(50) == expected);
}

TEST_CASE("instances of a module made and deleted since a snapshot do not disturb a restore") {
    Game game(built("harbor"));
    const Handle north = game.make("Harbor", "north"), south = game.make("Harbor", "south");
    game.step();
    const Snapshot snapshot = game.tree.snapshot();
    const auto expected = game.hashes(30);
    game.tree.destroy(north);
    const Handle east = game.make("Harbor", "east");
    game.step();
    game.tree.restore(snapshot);
    CHECK(game.tree.alive(north));
    CHECK(game.tree.alive(south));
    CHECK_FALSE(game.tree.alive(east));
    CHECK(game.hashes(30) == expected);
}

TEST_CASE("bytes that a module refuses change nothing") {
    Game game(built("harbor"));
    game.make("Harbor", "north");
    game.step();
    std::vector<std::byte> bytes = game.tree.snapshot().to_bytes();
    game.step();
    const std::uint64_t before = game.module.hash();
    // The snapshot of a tree without the module.
    property::Tree other;
    CHECK(message_of([&] { game.tree.restore(other.snapshot()); }) != "");
    CHECK(game.module.hash() == before);
    bytes[bytes.size() / 2] ^= std::byte{1};
    CHECK(message_of([&] { game.tree.restore(Snapshot::from_bytes(bytes)); }) != "");
    CHECK(game.module.hash() == before);
}

TEST_CASE("a module without own saving is restored value by value") {
    Game game(built("weather"));
    property::set(game.tree, "front.water", 12.0);
    property::set(game.tree, "front.kind", "stratus");
    const Snapshot snapshot = game.tree.snapshot();
    const auto expected = game.hashes(40);
    property::set(game.tree, "front.kind", "cirrus");
    property::set(game.tree, "front.height", 3);
    game.tree.restore(snapshot);
    CHECK(property::get(game.tree, "front.kind") == Value("stratus"));
    CHECK(property::get(game.tree, "front.height") == Value(100.0));
    CHECK(game.hashes(40) == expected);
}

TEST_CASE("a snapshot from before a reload is restored by the names of properties") {
    const ModuleFile file("weather");
    Game game(file.path());
    property::set(game.tree, "front.water", 12.0);
    property::set(game.tree, "front.height", 7);
    const Snapshot snapshot = game.tree.snapshot();
    property::set(game.tree, "front.height", 9);
    file.become("other_layout");
    game.module.reload();
    CHECK(property::get(game.tree, "front.height") == Value(9.0));
    game.tree.restore(snapshot);
    CHECK(property::get(game.tree, "front.height") == Value(7.0));
    CHECK(property::get(game.tree, "front.water") == Value(12.0));
    CHECK(game.module.reload().instances == 1);
}

TEST_CASE("a module that saves its rows cannot be replaced by one that does not") {
    const ModuleFile file("harbor");
    Game game(file.path());
    game.make("Harbor", "north");
    game.step();
    const std::uint64_t before = game.module.hash();
    file.become("forgetful");
    CHECK(message_of([&] { game.module.reload(); }).find("`save` and `restore`") !=
          std::string::npos);
    CHECK(game.module.hash() == before);
    CHECK_FALSE(game.tree.snapshot().empty());
}

#ifdef FETTLE_PHYSICS_PLUGIN
TEST_CASE("loaded physics continues bit for bit from a snapshot") {
    Game game(FETTLE_PHYSICS_PLUGIN);
    const Handle world = game.tree.child(game.tree.root(), "world");
    const auto body = [&](const char* shape, const Vec2& position, const char* type) {
        const Handle made = game.tree.create(game.tree.class_named("Body"), world);
        game.tree.set(made, "type", type);
        game.tree.set(made, "position", position);
        game.tree.create(game.tree.class_named(shape), made);
        return made;
    };
    for (int i = -8; i < 9; ++i) body("Box", Vec2(i, -1), "static");
    for (int i = 0; i < 30; ++i)
        body(i % 2 == 0 ? "Box" : "Circle", Vec2(0.7 * (i % 6) - 2, 1 + i / 6), "dynamic");
    for (int i = 0; i < 45; ++i) game.step();
    const Snapshot snapshot = game.tree.snapshot();
    const auto expected = game.hashes(120);
    body("Circle", Vec2(0, 9), "dynamic");
    for (int i = 0; i < 10; ++i) game.step();
    game.tree.restore(snapshot);
    REQUIRE(game.hashes(120) == expected);
    game.tree.restore(Snapshot::from_bytes(snapshot.to_bytes()));
    REQUIRE(game.hashes(120) == expected);
}

TEST_CASE("loaded physics records the computations that reads cause and repeats them") {
    struct Report : property::Observer {
        void refreshing(property::SnapshotPart& part, std::uint64_t what) override {
            all.emplace_back(&part, what);
        }
        std::vector<std::pair<property::SnapshotPart*, std::uint64_t>> all;
    } reported;
    Game game(FETTLE_PHYSICS_PLUGIN);
    const Handle world = game.tree.child(game.tree.root(), "world");
    const Handle body = game.tree.create(game.tree.class_named("Body"), world, "ball");
    game.tree.create(game.tree.class_named("Circle"), body, "circle");
    game.step();
    game.tree.observe(reported);
    property::set(game.tree, "world.ball.circle.radius", 2.0);
    CHECK(reported.all.empty());
    const Value mass = property::get(game.tree, "world.ball.mass");
    REQUIRE(reported.all.size() == 1);
    CHECK(property::get(game.tree, "world.ball.mass") == mass);
    CHECK(reported.all.size() == 1);
    property::set(game.tree, "world.ball.circle.radius", 1.0);
    const auto [part, what] = reported.all[0];
    CHECK(part == &game.module);
    part->refresh(what);
    CHECK(property::get(game.tree, "world.ball.mass") != mass);
    CHECK(reported.all.size() == 1);
    part->refresh(~std::uint64_t{0});  // an unknown object
    game.tree.unobserve(reported);
}
#endif

}  // namespace snapshot_test
