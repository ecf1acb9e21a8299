#include <limits>
#include <memory>
#include <utility>

#include <fettle/physics/world.h>

#include "catch.h"
#include "game.h"

namespace owner_test {

// Objects in a hosted world are created and destroyed only by the tree; and a module is attached
// completely or not at all.

using fettle::physics_module::PhysicsModule;
using fettle::physics_module::testing::Game;
using fettle::property::ClassDescriptor;
using fettle::property::Error;
using fettle::property::Handle;
using fettle::property::Tree;
using fettle::property::Vec2;
namespace physics_library = fettle::physics;

TEST_CASE_METHOD(Game, "only the tree creates and destroys the objects of a hosted world") {
    const Handle crate = body("Box", {0, 5});
    const Handle other = body("Circle", {3, 5});
    const Handle joint = make("RevoluteJoint", world(), {{"body_a", crate}, {"body_b", other}});
    const Handle wind = make("Wind", world());
    step();
    physics_library::World& hosted = physics.world(world());
    REQUIRE(hosted.joints().size() == 1);
    const auto refused = [](const auto& act) {
        REQUIRE_THROWS_WITH(act(), contains("belongs to a property tree"));
    };
    refused([&] { physics.body(crate).destroy(); });
    refused([&] { physics.shape(shape_of(crate)).destroy(); });
    refused([&] { physics.shape(shape_of(crate)).detach(); });
    refused([&] { physics.shape(shape_of(crate)).attach(physics.body(other)); });
    refused([&] { physics.body(crate).set_user_data(0); });
    refused([&] { hosted.joints()[0].destroy(); });
    refused([&] { hosted.fields()[0].destroy(); });
    refused([&] { hosted.clear(); });
    refused([&] { hosted = physics_library::World(); });
    physics_library::World taken;
    refused([&] { taken.take(std::move(hosted)); });
    refused([&] { hosted.take(physics_library::World()); });
    std::vector<std::byte> bytes;
    hosted.save(bytes);
    refused([&] { hosted.restore(bytes); });
    refused([&] { hosted.create_body(); });
    refused([&] { physics.body(crate).add(physics_library::Box{}); });
    physics_library::Shape box = physics.shape(shape_of(crate));
    refused([&] { box.set_geometry(physics_library::Circle{.radius = 0.25f}); });
    REQUIRE_NOTHROW(box.set_geometry(physics_library::Box{.width = 2, .height = 1}));
    REQUIRE(number(shape_of(crate), "width") == 2);

    // Nothing has changed, and the game can continue.
    for (const Handle each : {crate, other})
        for (const auto* property : tree.properties(each))
            REQUIRE_NOTHROW(tree.get(each, *property));
    REQUIRE_FALSE(hosted.validate());
    const auto snapshot = tree.snapshot();
    const Handle mars = make("World", tree.root(), "mars");
    tree.move(crate, mars);
    make("Circle", other);
    tree.move(wind, mars);
    step();
    tree.restore(snapshot);
    step();
    tree.destroy(joint);
    step();
    REQUIRE(hosted.joints().empty());
    tree.destroy(crate);
    tree.destroy(wind);
    REQUIRE(hosted.body_count() == 1);
}

TEST_CASE_METHOD(
    Game, "an object deleted inside a function of its world leaves the world after the call") {
    const Handle ground = floor();
    const Handle crate = body("Box", {0, 0.5});
    const Handle ball = body("Circle", {0, 2});
    const Handle second = make("Circle", ball);
    const Handle joint = make("RevoluteJoint", world(), {{"body_a", ground}, {"body_b", crate}});
    const Handle wind = make("Wind", world());
    const Handle mars = make("World", tree.root(), "mars");
    step();
    physics_library::World& hosted = physics.world(world());
    const physics_library::Shape circle = physics.shape(second);
    const auto inside = [&](const auto& act) {
        bool called = false;
        physics_library::QueryFilter filter;
        filter.accept = [&](const physics_library::Shape&) {
            if (!std::exchange(called, true)) act();
            return true;
        };
        (void)hosted.cast_ray_all({0, 5}, {0, -5}, filter);
        REQUIRE(called);
    };
    inside([&] {
        for (const Handle gone : {joint, crate, second, wind}) tree.destroy(gone);
        // Other calls of the module in between lose no postponed deletion.
        REQUIRE_NOTHROW(physics.hash());
        REQUIRE_THROWS(physics.step(1.0 / 60));
        REQUIRE_THROWS(tree.snapshot());
        for (const Handle kept : {ball, shape_of(ball)})
            REQUIRE_THROWS_WITH(tree.move(kept, mars), contains("calls a function"));
        REQUIRE_FALSE(tree.alive(crate));
        REQUIRE(physics.handle(circle) == Handle{});
    });
    REQUIRE_FALSE(hosted.validate());
    const auto left = [&] {
        return std::vector<std::size_t>{hosted.body_count(), hosted.shapes().size(),
                                        hosted.joints().size(), hosted.fields().size()};
    };
    const std::vector<std::size_t> expected = {2, 2, 0, 0};
    REQUIRE(left() == expected);
    const auto snapshot = tree.snapshot();
    step();
    tree.restore(snapshot);
    step();
    REQUIRE(left() == expected);

    // The body of a shape that is gone moves to another world.
    const Handle third = make("Box", ball);
    inside([&] { tree.destroy(third); });
    tree.move(ball, mars);
    tree.move(ball, world());
    REQUIRE_FALSE(hosted.validate());
    REQUIRE_NOTHROW(tree.restore(tree.snapshot()));

    // And in a step.
    hosted.set_before_solve([&](physics_library::ContactEdit&) {
        if (tree.alive(ball)) tree.destroy(ball);
    });
    for (int i = 0; i < 120 && tree.alive(ball); ++i) step();
    REQUIRE_FALSE(tree.alive(ball));
    REQUIRE(hosted.body_count() == 1);
    REQUIRE_FALSE(hosted.validate());

    // The world itself.
    body("Box", {0, 0.5});
    REQUIRE_THROWS_WITH(inside([&] { tree.destroy(world()); }), contains("destroyed"));
    make("World", tree.root(), "world");
    const Handle fresh = body("Box", {0, 0.5});
    step();
    REQUIRE(tree.alive(fresh));
    REQUIRE(physics.world(world()).body_count() == 1);
}

TEST_CASE_METHOD(Game, "a callback that throws loses no event and no step of another world") {
    const Handle ground = floor();
    const Handle crate = body("Box", {0, 0.6});
    const Handle mars = make("World", tree.root(), "mars");
    int begins = 0;
    const auto begin = tree.on(crate, *tree.class_of(crate).event("contact_begin"),
                               [&](const fettle::property::Occurrence&) { ++begins; });
    physics.world(world()).set_before_solve(
        [](physics_library::ContactEdit&) { throw std::runtime_error("a callback of the host"); });
    int thrown = 0;
    for (int i = 0; i < 30; ++i) {
        try {
            physics.step(1.0 / 60);
        } catch (const std::runtime_error&) {
            ++thrown;
        }
        physics.report(tree);
        tree.barrier();
    }
    CHECK(thrown > 0);
    CHECK(begins == 1);
    CHECK(physics.world(mars).statistics().steps == 30);
    (void)ground;
}

TEST_CASE("a detached world also belongs to the tree") {
    Game game;
    const Handle loose = game.make("Body", {});
    const Handle shape = game.make("Circle", loose);
    REQUIRE_THROWS_WITH(game.physics.shape(shape).destroy(), contains("property tree"));
    REQUIRE_THROWS_WITH(game.physics.world(loose).clear(), contains("property tree"));
    game.tree.move(loose, game.world());
    REQUIRE(game.physics.world(game.world()).body_count() == 1);
}

TEST_CASE("physics that cannot be attached to a tree leaves nothing in it") {
    const auto refused = [](Tree& tree, PhysicsModule& module, const char* why) {
        const std::size_t classes = tree.classes().size(), parts = tree.parts().size();
        REQUIRE_THROWS_WITH(module.attach(tree), contains(why));
        REQUIRE_THROWS_WITH(module.step(0.1), contains("attached to no tree"));
        REQUIRE(tree.classes().size() == classes);
        REQUIRE(tree.parts().size() == parts);
        // Attaching to another tree succeeds.
        auto elsewhere = std::make_unique<Tree>();
        module.attach(*elsewhere);
        module.step(0.1);
    };
    {
        PhysicsModule module;
        Tree tree;
        tree.define({.name = "Body"});
        refused(tree, module, "has a class \"Body\" already");
    }
    const Game game;
    for (const auto* of : game.tree.classes()) {
        PhysicsModule module;
        Tree tree;
        if (tree.find_class(of->name()) != nullptr) continue;
        tree.define({.name = of->name()});
        refused(tree, module, ("has a class \"" + of->name() + "\" already").c_str());
    }
    {
        PhysicsModule module;
        Tree tree;
        tree.create(tree.object_class(), tree.root(), "world");
        refused(tree, module, "the root has a \"world\" already");
    }
    {
        PhysicsModule module;
        Tree tree;
        tree.set_or_add(tree.root(), "world", 1);
        refused(tree, module, "the root has a \"world\" already");
    }
    {
        PhysicsModule first, second;
        Tree tree;
        first.attach(tree);
        refused(tree, second, "already");
        first.step(0.1);
    }
}

TEST_CASE("physics reports only to its own tree and refuses an invalid time step") {
    Game game;
    Tree other;
    REQUIRE_THROWS_WITH(game.physics.report(other), contains("got another"));
    for (const double dt : {std::numeric_limits<double>::quiet_NaN(), -1.0, 1e300,
                            std::numeric_limits<double>::infinity()})
        REQUIRE_THROWS_WITH(game.physics.step(dt), contains("dt = "));
    REQUIRE_NOTHROW(game.physics.step(0));
}

}  // namespace owner_test
