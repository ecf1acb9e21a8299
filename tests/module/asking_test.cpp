// Questions of modules in shared objects to functions of the program, and the descriptions of their
// fields.

#include <catch.h>

#include <fettle/property/acceptance.h>
#include <fettle/property/question.h>

#include "weather.h"

namespace asking_test {

using namespace fettle;
using namespace fettle::module::testing;
using property::Handle;
using property::Question;
using property::Type;
using property::Value;

namespace {

struct Game {
    module::Plugins plugins;
    property::Tree tree;
    module::Plugin& module = plugins.open(built("harbor"));
    Handle north;
    Game() {
        module.attach(tree);
        north = tree.create(tree.class_named("Harbor"), tree.root(), "north");
    }
    void step() {
        module.step(1.0 / 60);
        module.report(tree);
        tree.barrier();
    }
    double level() const { return tree.get(north, "level").number(); }
};

}  // namespace

TEST_CASE("a handler answers a question of a module within the step") {
    Game game;
    game.step();
    const double before = game.level();
    CHECK(before > 0);
    std::vector<std::int64_t> tides;
    auto connection = game.tree.on(game.north, *game.tree.class_of(game.north).event("rising"),
                                   [&](const property::Occurrence& o) {
                                       tides.push_back(o.record.get("tide").integer());
                                       Question::current()->answer(1, -0.25);
                                   });
    game.step();
    CHECK(tides.size() == 1);
    CHECK(game.level() == before - 0.25);
    connection.stop();
    game.step();
    CHECK(game.level() > before - 0.25);
    CHECK(tides.size() == 1);
}

TEST_CASE("a handler cannot change the fixed fields of a question of a module") {
    Game game;
    std::vector<std::string> refused;
    game.tree.on_handler_error(
        [&](const property::HandlerError& error) { refused.push_back(error.message); });
    const auto connection =
        game.tree.on(game.north, *game.tree.class_of(game.north).event("rising"),
                     [&](const property::Occurrence&) { Question::current()->answer(0, 7); });
    game.step();
    game.tree.barrier();
    REQUIRE(refused.size() == 1);
    INFO(refused[0]);
    CHECK(refused[0].find("tide") != std::string::npos);
    CHECK(game.level() > 0);
}

TEST_CASE("a method of a module calls a function that decides which instances count") {
    Game game;
    std::vector<Handle> ships;
    for (const char* name : {"anna", "berta", "carla"})
        ships.push_back(game.tree.create(game.tree.class_named("Harbor"), game.north, name));
    const auto listed = [&] {
        return std::get<Value>(game.tree.call(game.north, "ships", {Value(true)})).list();
    };
    CHECK(listed().size() == 3);
    {
        const property::Acceptance acceptance(game.tree, "ships",
                                              [&](Handle ship) { return ship != ships[1]; });
        CHECK(listed() == property::List{Value(ships[0]), Value(ships[2])});
    }
    CHECK(listed().size() == 3);
}

TEST_CASE("the host gets the allowed values of a property or a field of a module") {
    Game game;
    const property::Class& harbor = game.tree.class_named("Harbor");
    CHECK(harbor.property("pilot")->nullable);
    CHECK(harbor.property("pilot")->reference_class == "Object");
    CHECK(harbor.property("berths")->element == Type::reference);
    CHECK(harbor.property("berths")->reference_class == "Harbor");
    const property::Field& ships = harbor.method("ships")->returns.at(0);
    CHECK(ships.element == Type::reference);
    CHECK(ships.reference_class == "Object");
    CHECK_FALSE(ships.nullable);
    const property::Field& ship = harbor.event("docked")->fields.at(0);
    CHECK(ship.nullable);
    CHECK(ship.reference_class == "Harbor");
    game.tree.set(game.north, "pilot", game.north);
    CHECK(game.tree.get(game.north, "pilot") == Value(game.north));
    game.tree.set(game.north, "pilot", Value());
    CHECK(game.tree.get(game.north, "pilot").is_nil());
}

TEST_CASE("a module with the older and smaller structure of fields still loads") {
    Game game;
    const property::Class& harbor = game.tree.class_named("Harbor");
    const property::Field& accept = harbor.method("ships")->parameters.at(0);
    CHECK(accept.name == "accept");
    CHECK(accept.doc == "Which ones count.");
    CHECK(accept.element == Type::nil);
    CHECK(accept.reference_class.empty());
    REQUIRE(harbor.event("rising")->fields.size() == 2);
    CHECK(harbor.event("rising")->fields[1].unit == "m");
}

#ifdef FETTLE_PHYSICS_PLUGIN
TEST_CASE("a handler of before_solve lets a body through a platform of a loaded physics module") {
    module::Plugins plugins;
    property::Tree tree;
    module::Plugin& physics = plugins.open(FETTLE_PHYSICS_PLUGIN);
    physics.attach(tree);
    const Handle world = tree.child(tree.root(), "world");
    const auto box = [&](double y, const char* type) {
        const Handle body = tree.create(tree.class_named("Body"), world);
        tree.set(body, "type", type);
        tree.set(body, "position", property::Vec2(0, y));
        tree.create(tree.class_named("Box"), body);
        return body;
    };
    const Handle crate = box(3, "dynamic"), platform = box(1, "static");
    const property::Event& event = *tree.class_of(platform).event("before_solve");
    const bool lets_through = GENERATE(false, true);
    int calls = 0;
    const auto connection = tree.on(platform, event, [&](const property::Occurrence& o) {
        ++calls;
        CHECK(o.record.get("other") == Value(crate));
        for (std::size_t i = 0; i < event.fields.size(); ++i)
            if (event.fields[i].name == "enabled") Question::current()->answer(i, !lets_through);
    });
    for (int i = 0; i < 90; ++i) {
        physics.step(1.0 / 60);
        physics.report(tree);
        tree.barrier();
    }
    CHECK(calls > 2);
    CHECK((tree.get(crate, "position").vec2().y < 0) == lets_through);
}
#endif

}  // namespace asking_test
