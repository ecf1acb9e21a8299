// Failed operations leave nothing: constructors, adding, moving, replacing, copying and loading.

#include "catch.h"

#include <algorithm>
#include <fstream>
#include <stdexcept>

#include "playing.h"
#include "temporary_folder.h"

namespace constructors_test {

using namespace fettle;
using namespace fettle::app;
using property::Handle;

namespace {

/// All instances, including detached ones, with their values.
std::string everything(property::Tree& tree, const std::vector<Handle>& tops) {
    std::string all;
    for (const Handle top : tops) {
        if (!tree.alive(top)) {
            all += "gone\n";
            continue;
        }
        tree.each_below(top, [&](Handle handle) {
            all += tree.path(handle) + " " + tree.name(handle) + " " +
                   std::to_string(handle.index) + "\n";
            for (const property::Property* p : tree.properties(handle))
                if (!p->read_only) all += "  " + p->name + tree.text(tree.peek(handle, *p)) + "\n";
        });
    }
    return all;
}

struct Rig : Playing {
    Rig()
        : Playing(R"(
            world.ball = Body { position = vec(1, 2), Circle {} }
            world.note = Object {}
            c = Circle { radius = 0.25 }
            d = Body { position = vec(3, 4), velocity = vec(1, 1), Box {}, Box {} }
            d.box_2.color = color("red")
            e = Object { Object {} }
            Ball = class("Ball", Body) { lives = 3 }
        )") {
        tops.push_back(tree.root());
        for (const char* name : {"c", "d", "e"})
            tops.push_back(runtime->evaluate(name).result.reference());
        play(2);
    }
    /// Checks that the chunk raises and changes nothing, that no instance is left, and that steps,
    /// going back and saving still work.
    void check_refused(const std::string& chunk) {
        INFO(chunk);
        const std::string before = everything(tree, tops);
        const std::size_t size = tree.size();
        const auto done = runtime->evaluate("pcall(function() " + chunk + " end)");
        REQUIRE(done.ok);
        INFO(done.lines.front());
        CHECK(done.lines.front().starts_with("false"));
        CHECK(tree.size() == size);
        CHECK(everything(tree, tops) == before);
        CHECK_FALSE(physics.world(property::resolve(tree, "world").instance).validate());
        const auto saved = property::Snapshot::from_bytes(tree.snapshot().to_bytes());
        CHECK_NOTHROW(tree.check(saved));
        play(2);
        time().go_to(services.clock.step - 1);
        time().go_to(services.clock.step + 1);
        play(1);
        tree.restore(saved);
        CHECK(everything(tree, tops) == before);
        play(1);
    }
    std::vector<Handle> tops;
};

}  // namespace

TEST_CASE_METHOD(Rig, "a constructor that raises leaves nothing and its children are unchanged") {
    for (const char* chunk : {
             "Body { c, mass = 'x' }",
             "Body { c, d, mass = -1 }",
             "Body { hull = c, d, 7 }",
             "Body { hull = c, mass = 0/0 }",
             "Body { c, c }",
             "Body { c, world.ball }",
             "Body { c, Chain { closed = true } }",
             "Body { c, Ball { lives = 'many' } }",
             "World { d, gravity = 1 }",
             "World { first = d, d }",
             "World { step = d, bounds = { vec(0, 0), vec(0, 0) } }",
             "Object { e, Object { d, c, x = function() end } }",
             "Ball { c, lives = 1.5 }",
             "Ball { c, livse = 1 }",
             "world.new = Body { Chain { closed = true } }",
             "world:add(Body { c, friction = formula(1) })",
             "Body { c, [1.5] = 2 }",
             "Body { velocity = vec(1, 0), type = 'static', c }",
             "Body { c, class = 'Ball' }",
             "Body { c, position = function() end }",
             "Body { c, delete = 1 }",
             "DistanceJoint { body_a = c, d }",
         })
        check_refused(chunk);
}

TEST_CASE_METHOD(Rig, "an instance that is refused a place stays in its place") {
    for (const char* chunk : {
             "world:add(d, 'gravity')",
             "world:add(d, 'raycast')",
             "world:add(d, 'ball')",
             "world.ball:add(world)",
             "world.gravity = d",
             "world.raycast = d",
             "world.gravty = d",
             "world.ball = 3",
             "world.ball = world.note",
             "world.ball:move(world.ball.circle)",
             "world.ball:move(world, 'note')",
             "d:move(world, 'gravity')",
             "world.ball.name = 'note'",
             "world.ball.name = ''",
             "world.ball.name = 'gravity'",
             "world.ball.parent = world.ball.circle",
             "game.world = world.ball",
             "world.step:move(world.ball)",
             "world.step.name = 'steps'",
             "world.step:delete()",
             "world.step = nil",
             "world.step = e",
             "time:delete()",
             "game.time = nil",
             "game.time = e",
             "time:move(world)",
             "time:clone()",
             "game:clone()",
             "game:delete()",
             "world:children():add('mass', 1)",
         })
        check_refused(chunk);
}

TEST_CASE("a scene that cannot be loaded leaves nothing") {
    const TemporaryFolder folder;
    std::ofstream(folder.path / "main.lua") << "";
    Rig rig;
    REQUIRE(rig.runtime->load(folder.path));
    for (
        const char* scene : {
            R"({"fettle_scene": 1, "class": "Body", "children": [{"class": "Chain", "properties": {"closed": true}}]})",
            R"({"fettle_scene": 1, "class": "Body", "children": [{"class": "Circle", "properties": {"radius": -1}}]})",
            R"({"fettle_scene": 1, "class": "Body", "children": [{"class": "Circle"}, {"class": "Nothing"}]})",
            R"({"fettle_scene": 1, "class": "World", "properties": {"bounds": [[0, 0], [0, 0]]}})",
        }) {
        std::ofstream(folder.path / "s.json") << scene;
        INFO(scene);
        rig.check_refused("scene.load('s.json', world)");
    }
}

namespace {

/// A module that refuses instances below a parent named "full".
struct Picky {
    property::Tree& tree;
    std::vector<Handle> placed;
    int below(Handle self) const { return int(std::count(placed.begin(), placed.end(), self)); }

    explicit Picky(property::Tree& in) : tree(in) {
        property::ClassDescriptor picky;
        picky.name = "Picky";
        picky.properties = {{.name = "size", .default_value = 1.0}};
        picky.lifecycle.context = this;
        picky.lifecycle.place = [](void* context, property::Tree& where, Handle self,
                                   property::Row row) {
            auto& module = *static_cast<Picky*>(context);
            for (Handle up = where.parent(self); up; up = where.parent(up))
                if (where.name(up) == "full") throw std::invalid_argument("there is no room");
            module.placed.push_back(self);
            return row;
        };
        tree.define(std::move(picky));
    }
};

}  // namespace

TEST_CASE("an instance that a module refuses a place stays complete in its place") {
    Playing game(
        "world.full = Object {} world.full.old = Object {} world.full.note = 5 "
        "world.gravity = vec(0, 0) world.sleeping = false");
    Picky module(game.tree);
    REQUIRE(game.runtime->run(R"(
        world.here = Picky { size = 3, Body { Circle {} }, Picky {} }
        loose = Body { Circle {}, Picky {} }
        world.first = Object {} world.last = Object {}
    )",
                              "test"));
    game.play(3);
    const std::vector<Handle> tops = {game.tree.root(),
                                      game.runtime->evaluate("loose").result.reference()};
    const std::string before = everything(game.tree, tops);
    const std::size_t size = game.tree.size();
    for (const char* chunk : {"world.here:move(world.full)", "world.full:add(loose)",
                              "world.full.old = loose", "world.full.note = loose",
                              "world.full.new = Picky {}", "world.full:add(world.here:clone())",
                              "world.here.parent = world.full", "loose:move(world.full, 'x')"}) {
        INFO(chunk);
        const auto done =
            game.runtime->evaluate("pcall(function() " + std::string(chunk) + " end)");
        REQUIRE(done.ok);
        INFO(done.lines.front());
        CHECK(done.lines.front().find("there is no room") != std::string::npos);
        // An instance that the chunk made for the place is detached: the garbage collector deletes
        // it.
        game.runtime->evaluate("for _ = 1, 200 do Object {} end collectgarbage()");
        CHECK(everything(game.tree, tops) == before);
        game.play(2);
        CHECK(everything(game.tree, tops).size() > 100);
        game.check(game.services.clock.step - 1);
        game.check(game.services.clock.step + 1);
        CHECK_NOTHROW(
            game.tree.check(property::Snapshot::from_bytes(game.tree.snapshot().to_bytes())));
        REQUIRE(everything(game.tree, tops) == before);
    }
    CHECK(game.tree.size() >= size);
}

TEST_CASE("an instance whose ready raises is created all the same") {
    Playing game(R"(
        Ball = class("Ball", Body) {}
        function Ball:ready() error("not today") end
        world.ball = Ball { Circle {} }
    )");
    game.loop->turn();
    REQUIRE(game.errors.size() == 1);
    game.errors.clear();
    CHECK(game.tree.alive(property::resolve(game.tree, "world.ball").instance));
    game.play(10);
    game.check(5);
    CHECK_NOTHROW(game.tree.check(property::Snapshot::from_bytes(game.tree.snapshot().to_bytes())));
}

TEST_CASE("a world can be copied with its contents") {
    Playing game(R"(
        world.a = Body { Circle {} } world.b = Body { position = vec(1, 0), Box {} }
        world.j = WeldJoint { body_a = world.a, body_b = world.b }
        world.note = Object {} world.note.of = world.a
        world.gone = Object {} world.note.dead = world.gone world.gone:delete()
        world.note.wrong = formula(function() return world.nobody.x end)
        game.twin = world:clone()
    )");
    game.play(3);
    CHECK(game.get("twin.note.of") ==
          property::Value(property::resolve(game.tree, "twin.a").instance));
    CHECK(game.get("twin.note.dead") == property::Value(Handle{}));
    CHECK(game.get("twin.step.bodies").integer() == 2);
    CHECK(game.get("twin.j.body_b") ==
          property::Value(property::resolve(game.tree, "twin.b").instance));
}

}  // namespace constructors_test
