// Every value that a tree accepts can be saved, loaded and copied: every property of every class is
// written, alone in the frame of a snapshot, and many at random.

#include "catch.h"

#include <cstdlib>

#include <fettle/property/error.h>
#include <fettle/property/storage/scene.h>

#include "every_class.h"
#include "thorough.h"

namespace round_trip_test {

using namespace fettle;
using namespace fettle::app;
using property::Handle;
using property::Property;
using property::Value;

namespace {

struct Subjects {
    std::vector<Handle> instances;
    explicit Subjects(Playing& game) {
        const Handle world = property::resolve(game.tree, "world").instance;
        game.tree.each_below(world, [&](Handle handle) { instances.push_back(handle); });
    }
};

bool is_written(const Property& property) {
    return !property.read_only && property.binding.kind != property::BindingKind::node &&
           property.name != "threads";  // it changes no result, and starts threads
}

/// False if the tree refuses the value.
bool write(property::Tree& tree, Handle instance, const Property& property, const Value& value) {
    try {
        tree.set(instance, property, value);
        return true;
    } catch (const property::Error&) {
        return false;
    }
}

std::vector<std::uint64_t> hashes(Playing& game, int steps) {
    std::vector<std::uint64_t> all;
    for (int i = 0; i < steps; ++i) {
        game.play(1);
        all.push_back(game.loop->hash());
    }
    return all;
}

/// A snapshot as bytes contains the edits since the last step, and the restored game continues like
/// the original.
void check_snapshot(Playing& game) {
    property::Snapshot taken;
    const auto bytes = game.tree.snapshot().to_bytes();
    REQUIRE_NOTHROW(taken = property::Snapshot::from_bytes(bytes));
    const auto before = all_values(game.tree);
    const auto expected = hashes(game, 3);
    REQUIRE_NOTHROW(game.tree.restore(property::Snapshot::from_bytes(bytes)));
    CHECK(all_values(game.tree) == before);
    CHECK(hashes(game, 3) == expected);
    CHECK_FALSE(game.physics.world(property::resolve(game.tree, "world").instance).validate());
}

}  // namespace

TEST_CASE("a snapshot contains an edit of any property in its frame") {
    Playing game(every_class);
    game.services.clock.rewind_limit = 0;
    game.play(5);
    const property::Snapshot awake = game.tree.snapshot();
    game.play(400);
    REQUIRE_FALSE(game.get("world.b.awake").boolean());
    const property::Snapshot asleep = game.tree.snapshot();
    const Subjects subjects(game);
    // Two cases of each property, of different classes if it is inherited: all would take a minute.
    std::map<std::pair<const Property*, const property::Class*>, int> of_class;
    std::map<const Property*, int> seen;
    std::vector<std::pair<Handle, const Property*>> cells;
    for (const Handle instance : subjects.instances)
        for (const Property* property : game.tree.properties(instance)) {
            const property::Class* of = &game.tree.class_of(instance);
            const int max_cases = of->name() == "Body" ? 2 : 1;  // the floor and a moving body
            if (is_written(*property) && ++of_class[{property, of}] <= max_cases &&
                ++seen[property] <= 2)
                cells.emplace_back(instance, property);
        }
    int written = 0;
    std::size_t tried = 0;
    for (const property::Snapshot* begin : {&awake, &asleep})
        for (const auto& [instance, property] : cells)
            for (const Value& value : values_for(*property, subjects.instances)) {
                if (!is_tested(tried++, 17)) continue;
                game.tree.restore(*begin);
                if (game.tree.peek(instance, *property) == value) continue;
                INFO(game.tree.path(instance, *property)
                     << " = " << game.tree.text(value)
                     << (begin == &asleep ? " asleep" : " awake"));
                if (!write(game.tree, instance, *property, value)) continue;
                ++written;
                check_snapshot(game);
            }
    CHECK(written > (thorough() ? 500 : 30));
}

TEST_CASE("a snapshot contains the effects of methods and moves in its frame") {
    Playing game(every_class);
    game.services.clock.rewind_limit = 0;
    game.play(5);
    const property::Snapshot begin = game.tree.snapshot();
    for (const char* chunk : {
             "world.floor.type = 'kinematic'",
             "world.floor.type = 'dynamic' world.floor.velocity = vec(1, 1)",
             "world.floor.mass = 3 world.floor.type = 'dynamic'",
             "world.a.type = 'static' world.a.type = 'dynamic'",
             "world.a.mass = math.huge",
             "world.a:delete()",
             "world.a.box:delete()",
             "world.a:add(Chain {})",
             "world.floor:add(Concave {}) world.floor.type = 'dynamic'",
             "world.rail.chain.points = {vec(0,0), vec(1,0), vec(1,1)} world.rail.chain.closed = "
             "true "
             "world.rail.type = 'kinematic'",
             "world.a:move(world.other)",
             "world.other.body:move(world)",
             "world.a:move(nil)",
             "world.a.box:move(world.b)",
             "world.b.awake = false",
             "world.b.awake = false world.b.type = 'static'",
             "world.a:apply_force(vec(1e38, 0)) for i = 1, 9 do world.a:apply_force(vec(3e38, "
             "3e38)) end",
             "world.a:apply_impulse(vec(3e38, 0)) world.a:apply_torque(3e38) "
             "world.a:apply_torque(3e38)",
             "world.a.box.density = 3e38 world.b.box.friction = 3e38 world.a.box.friction = 3e38",
             "world.distance_joint_1:delete()",
             "world.distance_joint_1.body_a = world.a",
             "world.distance_joint_1:move(world.other)",
             "world.weld_joint_1.broken = true",
             "world.bounds = {vec(-9, -9), vec(9, 9)}",
             "world.bounds = {vec(-9, -9), vec(9, 9)} world.bounds = nil",
             "world.sleeping = false",
             "world.other:delete()",
             "game.more = World {} game.more.it = Body { Circle {} } world.a:move(game.more)",
             "world.new = Body { type = 'static', Chain {} } world.new.type = 'dynamic'",
             "world.a.position = vec(1e8, 1e8) world.a.angle = 1e8",
             "loose.type = 'static' loose:move(world) loose.type = 'kinematic'",
             "local _ = world.floor.mass world.floor.type = 'dynamic' local _ = "
             "world.floor.box.aabb",
             "world.floor.type = 'dynamic' for _, b in ipairs(world:children(Body)) do b.awake = "
             "false end",
         }) {
        game.tree.restore(begin);
        INFO(chunk);
        const bool ran = game.runtime->run(chunk, "test");
        INFO((game.errors.empty() ? "" : game.errors.back()));
        REQUIRE(ran);
        check_snapshot(game);
    }
}

namespace {

/// Checks copies, files and snapshots of all instances.
void check_round_trips(Playing& game) {
    check_snapshot(game);
    const Handle world = property::resolve(game.tree, "world").instance;
    for (const Handle child : game.tree.children(world)) {
        if (!game.tree.class_of(child).creatable()) continue;
        const std::string path = game.tree.path(child);
        INFO(path);
        // A copy has the same text, except for names that the file does not contain for a copy.
        std::string text, again;
        REQUIRE_NOTHROW(text = property::scene_text(game.tree, child));
        Handle loaded;
        REQUIRE_NOTHROW(loaded = property::load_scene_text(game.tree, text, "scene", {}));
        game.tree.destroy(loaded);
        const bool copied =
            game.runtime->run("copy = game." + path + ":clone() copy:delete()", "copy");
        INFO((game.errors.empty() ? "" : game.errors.back()));
        CHECK(copied);
    }
    std::string text;
    REQUIRE_NOTHROW(text = property::scene_text(game.tree, world));
    Handle loaded;
    REQUIRE_NOTHROW(
        loaded = property::load_scene_text(game.tree, text, "scene", game.tree.root(), "twin"));
    CHECK(property::scene_text(game.tree, loaded).size() > 1000);
    const bool copied = game.runtime->run("game.third = world:clone()", "copy");
    INFO((game.errors.empty() ? "" : game.errors.back()));
    CHECK(copied);
}

}  // namespace

TEST_CASE("everything that a tree accepts can be copied and saved and loaded") {
    const char* wanted = std::getenv("FETTLE_ROUND_TRIPS");
    const int rounds = wanted != nullptr ? std::atoi(wanted) : 40;
    Playing game(every_class);
    game.services.clock.rewind_limit = 0;
    game.play(5);
    const property::Snapshot begin = game.tree.snapshot();
    const Subjects subjects(game);
    for (int round = 0; round < rounds; ++round) {
        game.tree.restore(begin);
        std::mt19937 random(static_cast<unsigned>(round));
        std::string done;
        for (int i = 0; i < 60; ++i) {
            const Handle instance = subjects.instances[random() % subjects.instances.size()];
            if (!game.tree.alive(instance)) continue;
            const auto properties = game.tree.properties(instance);
            const Property& property = *properties[random() % properties.size()];
            if (!is_written(property)) continue;
            const auto values = values_for(property, subjects.instances);
            const Value& value = values[random() % values.size()];
            const std::string what =
                game.tree.path(instance, property) + " = " + game.tree.text(value) + "\n";
            if (write(game.tree, instance, property, value)) done += what;
            if (random() % 30 == 0 && instance != subjects.instances.front()) {  // the world
                game.tree.destroy(instance);
                done += "delete that\n";
            }
        }
        if (round % 2 == 0) game.play(2);
        INFO("round " << round << "\n" << done);
        check_round_trips(game);
    }
}

TEST_CASE("a chain of two points cannot be closed but a file with three points closes it") {
    Playing game("world.b = Body { Chain {} }");
    CHECK_FALSE(game.runtime->run("world.b.chain.closed = true", "test"));
    CHECK(game.errors.back().find("world.b.chain.closed") != std::string::npos);
    CHECK(game.errors.back().find("at least three points") != std::string::npos);
    game.errors.clear();
    REQUIRE(game.runtime->run(R"(
        world.c = Body { Chain { closed = true, points = { vec(0, 0), vec(2, 0), vec(1, 1) } } }
        Loop = class("Loop", Chain) { closed = true, points = { vec(0, 0), vec(2, 0), vec(1, 1) } }
        world.d = Body { Loop {} }
        world.e = world.d:clone()
        assert(world.e.loop.closed and world.c:clone().chain.closed)
        assert(not pcall(function() world.c.chain.points = { vec(0, 0), vec(1, 0) } end))
        Bad = class("Bad", Chain) { closed = true }
        local ok, why = pcall(Bad)
        assert(not ok and why:find("Bad.closed", 1, true), why)
    )",
                              "test"));
    const Handle c = property::resolve(game.tree, "world.c").instance;
    const std::string text = property::scene_text(game.tree, c);
    const Handle loaded = property::load_scene_text(game.tree, text, "scene", {});
    CHECK(game.tree.get(game.tree.first_child(loaded), "closed") == Value(true));
}

}  // namespace round_trip_test
