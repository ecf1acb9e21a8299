// A hosted world and a world of the bare library make the same steps with the same bits.

#include <memory>
#include <optional>
#include <vector>

#include "catch.h"
#include "comma_locale.h"
#include "game.h"
#include "last_words.h"

namespace hosting_test {

using namespace fettle::physics_module::testing;
using namespace fettle;

namespace {

constexpr int base = 8;

void bare_pyramid(physics::World& world) {
    physics::Body ground =
        world.create_body({.type = physics::BodyType::static_body, .position = {0, -1}});
    ground.add(physics::Box{.width = 100, .height = 2});
    for (int i = 0; i < base; ++i)
        for (int j = i; j < base; ++j)
            world
                .create_body({.position = {0.5f * static_cast<float>(i + 1) +
                                               static_cast<float>(j - i) - base / 2,
                                           static_cast<float>(2 * i + 1) / 2}})
                .add(physics::Box{});
}

void hosted_pyramid(Game& game, Handle world) {
    const Handle ground = game.make("Body", world, {{"type", "static"}, {"position", Vec2(0, -1)}});
    game.make("Box", ground, {{"width", 100}, {"height", 2}});
    for (int i = 0; i < base; ++i)
        for (int j = i; j < base; ++j) {
            const Vec2 at(0.5 * (i + 1) + (j - i) - base / 2, (2.0 * i + 1) / 2);
            game.make("Box", game.make("Body", world, {{"position", at}}));
        }
}

}  // namespace

TEST_CASE_METHOD(Game, "a class that derives from a class of the module leaves the rows to it") {
    property::ClassDescriptor own{.name = "Own", .base = "Body"};
    own.lifecycle.create = [](void*, property::Tree&, Handle) -> property::Row { return 12345; };
    for (const char* inherited : {"Body", "Circle", "World", "Shape", "Joint", "DistanceJoint"}) {
        own.base = inherited;
        CAPTURE(inherited);
        CHECK_THROWS_WITH(tree.define(own),
                          contains("class Own: `lifecycle`: it inherits the property"));
    }
    own.base = "Body";
    own.lifecycle = {};
    tree.define(own);
    const Handle made = make("Own", world(), {{"position", Vec2(1, 2)}});
    CHECK(tree.get(made, "position") == property::Value(Vec2(1, 2)));
}

TEST_CASE_METHOD(Game, "the hosted loop and the bare library end in the same bits") {
    physics::World bare;
    bare_pyramid(bare);
    hosted_pyramid(*this, world());
    for (int i = 0; i < 200; ++i) {
        bare.step(static_cast<float>(1.0 / 60));
        step();
        REQUIRE(physics.hash() == bare.hash());
    }
}

TEST_CASE_METHOD(Game, "watchers and handlers do not change the simulation") {
    physics::World bare;
    bare_pyramid(bare);
    hosted_pyramid(*this, world());
    const property::Class& of = tree.class_named("Body");
    int calls = 0;
    for (const property::Event* event : of.events())
        tree.on(of, *event, [&](const property::Occurrence&) { ++calls; });
    tree.watch_pattern("world.**", [&](const property::Change&) { ++calls; });
    for (int i = 0; i < 100; ++i) {
        bare.step(static_cast<float>(1.0 / 60));
        step();
        REQUIRE(physics.hash() == bare.hash());
    }
    CHECK(calls > 1000);
}

TEST_CASE_METHOD(Game, "an edit by path during a run equals the edit of the library") {
    physics::World bare;
    bare_pyramid(bare);
    hosted_pyramid(*this, world());
    for (int i = 0; i < 60; ++i) {
        if (i == 30) {
            bare.bodies().at(20).set_velocity({5, 3});
            property::set(tree, "world.body_21.velocity", Vec2(5, 3));
        }
        bare.step(static_cast<float>(1.0 / 60));
        step();
        REQUIRE(physics.hash() == bare.hash());
    }
}

TEST_CASE_METHOD(Game, "bodies built detached and placed later move like those built in place") {
    Game in_place;
    hosted_pyramid(in_place, in_place.world());
    const Handle group = make("Object", {}, "group");
    hosted_pyramid(*this, group);
    tree.move(group, world(), "group");
    for (int i = 0; i < 60; ++i) {
        in_place.step();
        step();
        REQUIRE(physics.hash() == in_place.physics.hash());
    }
}

TEST_CASE_METHOD(Game, "the hash distinguishes several worlds") {
    const Handle second = make("World", tree.root(), "second");
    hosted_pyramid(*this, second);
    step(3);
    const std::uint64_t both = physics.hash();
    body("Circle", {0, 10});
    CHECK(physics.hash() != both);
}

TEST_CASE_METHOD(Game, "statistics describe the last step") {
    floor();
    body("Box", {0, 0.5});
    step(5);
    CHECK(property::get(tree, "world.step.steps") == 5);
    CHECK(property::get(tree, "world.step.bodies") == 2);
    CHECK(property::get(tree, "world.step.awake_bodies") == 1);
    CHECK(property::get(tree, "world.step.touching") == 1);
    CHECK(property::get(tree, "world.step.total_ms").number() >= 0);
    CHECK_THROWS_AS(property::set(tree, "world.step.bodies", 7), property::Error);
}

TEST_CASE_METHOD(
    Game, "the objects of an instance are found from C++ and the instance from its objects") {
    const Handle crate = body("Box", {0, 5});
    physics.body(crate).set_velocity({1, 2});
    CHECK(vec(crate, "velocity") == Vec2(1, 2));
    CHECK(physics.handle(physics.body(crate)) == crate);
    CHECK(physics.handle(physics.shape(shape_of(crate))) == shape_of(crate));
    CHECK(&physics.world(crate) == &physics.world(world()));
    CHECK_THROWS_WITH(physics.body(world()), contains("expected a Body"));
    tree.destroy(crate);
    CHECK_THROWS_AS(physics.body(crate), property::Error);
}

TEST_CASE("messages of physics have a point in every locale of the program") {
    const CommaLocale comma;
    if (!comma.there()) return;
    physics::World world;
    physics::Body body = world.create_body();
    CHECK_THROWS_WITH(body.add(physics::Circle{.radius = -1.5f}),
                      contains("radius = -1.5: expected a number from 1e-05 to"));
    CHECK_THROWS_WITH(body.add(physics::Circle{.radius = 1000000.1f}),
                      contains("radius = 1000000.12: "));
    CHECK_THROWS_WITH(body.add(physics::Concave{{{0, 0}, {2.5f, 2.5f}, {2.5f, 0}, {0, 2.5f}}}),
                      contains("(1.25, 1.25)"));
}

TEST_CASE("physics can be attached only once") {
    Game game;
    CHECK_THROWS_AS(game.physics.attach(game.tree), std::logic_error);
}

TEST_CASE("a physics module that was never attached reports this") {
    fettle::physics_module::PhysicsModule module;
    const auto says_so = [](const auto& call) {
        REQUIRE_THROWS_WITH(call(), contains("physics is attached to no tree"));
    };
    fettle::property::Tree tree;
    says_so([&] { module.step(0.1); });
    says_so([&] { module.report(tree); });
    says_so([&] { module.hash(); });
    says_so([&] { module.world(tree.root()); });
    says_so([&] { module.body(tree.root()); });
    says_so([&] { module.shape(tree.root()); });
    REQUIRE_FALSE(module.handle(fettle::physics::Body()));
    REQUIRE_FALSE(module.handle(fettle::physics::Shape()));
    module.attach(tree);
    module.step(0.1);
}

TEST_CASE("a physics module whose tree has ended reports this") {
    fettle::physics_module::PhysicsModule module;
    std::optional<property::Tree> tree(std::in_place);
    module.attach(*tree);
    const property::Handle world = tree->child(tree->root(), "world");
    property::Tree another;
    tree.reset();
    const auto says_so = [](const auto& call) {
        REQUIRE_THROWS_WITH(call(),
                            contains("the tree that physics was attached to was destroyed"));
    };
    says_so([&] { module.step(0.1); });
    says_so([&] { module.report(another); });
    says_so([&] { module.hash(); });
    says_so([&] { module.world(world); });
    says_so([&] { module.body(world); });
    says_so([&] { module.shape(world); });
    says_so([&] { module.on_problem({}); });
    CHECK_THROWS_WITH(module.attach(another), contains("attached to a tree already"));
}

TEST_CASE("the length of a step that is refused is reported with few digits") {
    Game game;
    CHECK_THROWS_WITH(game.physics.step(1e300),
                      contains("dt = 1e+300:") || contains("dt = 1e300:"));
    CHECK_THROWS_WITH(game.physics.step(-0.5), contains("dt = -0.5:"));
    CHECK_THROWS_WITH(game.physics.step(1e300), contains("from 0 to 3.4e38 s"));
}

TEST_CASE("destroying physics in the middle of a step or a query ends the program with a message") {
    const bool in_step = GENERATE(true, false);
    const std::string words = termination_message([&] {
        property::Tree tree;
        auto physics = std::make_unique<physics_module::PhysicsModule>();
        physics->attach(tree);
        const Handle world = tree.child(tree.root(), "world");
        for (const Vec2 at : {Vec2(0, 0), Vec2(0, 0.5)}) {
            const Handle body = tree.create(tree.class_named("Body"), world);
            tree.set(body, "position", at);
            tree.create(tree.class_named("Circle"), body);
        }
        if (in_step) {
            physics->world(world).set_before_solve([&](physics::ContactEdit&) { physics.reset(); });
            physics->step(1.0 / 60);
        } else {
            (void)physics->world(world).query_point(
                {0, 0}, {.accept = [&](const physics::Shape&) { return physics.reset(), true; }});
        }
    });
    CHECK_THAT(words, contains("which must not do so (see physics_module.h)"));
}

TEST_CASE("a tree takes physics once only and the message says so") {
    const bool ended = GENERATE(false, true);
    property::Tree tree;
    std::optional<physics_module::PhysicsModule> first(std::in_place);
    first->attach(tree);
    if (ended) first.reset();
    physics_module::PhysicsModule second;
    CHECK_THROWS_WITH(second.attach(tree), contains("a tree takes physics once only, also when the "
                                                    "first has ended: make another tree"));
    property::Tree another;
    second.attach(another);
    CHECK(another.child(another.root(), "world"));
}

TEST_CASE("physics that ends before its tree takes its instances with it") {
    const bool watched = GENERATE(false, true);
    property::Tree tree;
    std::optional<physics_module::PhysicsModule> physics(std::in_place);
    physics->attach(tree);
    tree.define({.name = "Crate", .base = "Body"});
    const auto make = [&](const char* of, Handle parent) {
        return tree.create(tree.class_named(of), parent);
    };
    const Handle world = tree.child(tree.root(), "world"), group = make("Object", tree.root());
    const Handle body = make("Body", world), crate = make("Crate", make("World", group));
    const std::vector<Handle> all = {world,
                                     body,
                                     crate,
                                     make("Circle", body),
                                     make("Box", crate),
                                     make("RevoluteJoint", world),
                                     make("Wind", world),
                                     make("Body", {}),
                                     make("Polygon", {}),
                                     make("Body", group)};
    std::vector<property::Connection> watchers;
    int reports = 0;
    if (watched) {
        watchers.push_back(tree.watch(body, "position", [](const property::Change&) {}));
        watchers.push_back(tree.watch_deleted(tree.object_class(),
                                              [&](const property::Existence&) { ++reports; }));
    }
    const property::Snapshot before = tree.snapshot();
    physics->step(0.1);
    physics->report(tree);
    tree.barrier();
    physics.reset();
    tree.barrier();
    CHECK(reports >= (watched ? 10 : 0));
    for (const Handle gone : all) CHECK_FALSE(tree.alive(gone));
    CHECK(tree.children(tree.root()) == std::vector<Handle>{group});
    CHECK(tree.children(group).empty());
    CHECK(tree.size() == 2);
    CHECK(tree.parts().empty());
    for (const char* of : {"World", "Body", "Crate", "Circle", "WeldJoint", "Drag"})
        CHECK_THROWS_WITH(tree.create(tree.class_named(of), tree.root()),
                          contains("it can have no instances any more"));
    CHECK_THROWS(tree.restore(before));
    tree.restore(tree.snapshot());
    tree.barrier();
}

}  // namespace hosting_test
