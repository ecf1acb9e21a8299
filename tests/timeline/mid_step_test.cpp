// Going back in the middle of a step is refused and damages neither the step nor the timeline.

#include <cmath>

#include "catch.h"
#include "playing.h"

namespace mid_step_test {

using namespace fettle;
using namespace fettle::app;

namespace {

constexpr const char* pile = R"(
    world.floor = Body { type = "static", Box { width = 9, height = 1 } }
    world.ball = Body { position = vec(0, 0.9), Circle { radius = 0.5 } }
)";

std::string message_of(const std::function<void()>& act) {
    try {
        act();
    } catch (const std::exception& error) {
        return error.what();
    }
    return {};
}

}  // namespace

TEST_CASE("going back in the middle of a step is refused and the timeline stays valid") {
    Playing game(pile);
    std::vector<std::string> refused;
    bool guest_goes = false;
    std::int64_t oldest = -1;
    const auto go_back = [&] {
        if (!refused.empty()) return;
        refused = {message_of([&] { game.time().rewind(0.1); }),
                   message_of([&] { game.time().go_to(3); }),
                   message_of([&] { game.time().go_near(3); }),
                   message_of([&] { game.time().clear(); }),
                   message_of([&] { game.loop->turn(); }),
                   message_of([&] {
                       game.tree.at_barrier([&] { game.time().rewind(0.1); });
                       game.tree.barrier();
                   })};
    };
    game.loop->add({.name = "guest", .step = [&](double) {
                        if (guest_goes) go_back();
                    }});
    game.play(90);
    oldest = game.time().oldest();
    SECTION("called by a physics world") {
        const auto world = game.tree.child(game.tree.root(), "world");
        game.tree.set(game.tree.child(world, "ball"), "position", property::Vec2(0.1, 0.9));
        game.physics.world(world).set_before_solve([&](physics::ContactEdit&) { go_back(); });
        game.play(1);
        game.physics.world(world).set_before_solve({});
    }
    SECTION("called by a module") {
        guest_goes = true;
        game.play(1);
    }
    REQUIRE(refused.size() == 6);
    for (const std::string& message : refused)
        CHECK_THAT(message, contains("in the middle of a step"));
    CHECK(game.time().oldest() == oldest);
    CHECK(game.time().newest() == 91);
    game.play(60);
    for (const int step : {30, 89, 90, 91, 92, 151}) game.check(step);
}

TEST_CASE("a step that ends with an exception does not block going back") {
    Playing game(pile);
    bool fails = false;
    game.loop->add({.name = "guest", .step = [&](double) {
                        if (std::exchange(fails, false)) throw std::runtime_error("guest");
                    }});
    game.play(30);
    fails = true;
    CHECK_THROWS_WITH(game.loop->turn(), "guest");
    game.check(12);
    game.time().clear();
    CHECK_FALSE(game.time().keeps());
}

TEST_CASE("going back in a handler is refused and the timeline stays") {
    Playing game(pile);
    game.play(30);
    std::string refusal;
    game.tree.set_or_add(game.tree.root(), "n", 0);
    game.tree.watch(game.tree.root(), "n", [&](const property::Change&) {
        refusal = message_of([&] { game.time().go_to(7); });
    });
    game.tree.set(game.tree.root(), "n", 1);
    game.tree.barrier();
    CHECK_THAT(refusal, contains("in a handler"));
    game.check(7);
}

TEST_CASE("rewinding by an invalid number is refused and by a negative one does nothing") {
    Playing game(pile);
    game.play(30);
    CHECK_THROWS_WITH(game.time().rewind(std::nan("")), contains("rewind: nan"));
    CHECK(game.services.clock.step == 30);
    game.time().rewind(-5);
    CHECK(game.services.clock.step == 30);
    game.time().rewind(INFINITY);
    CHECK(game.services.clock.step == 0);
    game.time().rewind(-1e300);
    CHECK(game.services.clock.step == 30);
}

TEST_CASE("a joint deleted after its body holds it again after undo") {
    Playing game(R"(
        world.a = Body { Circle {} }
        world.b = Body { position = vec(3, 0), Circle {} }
        world.j = RevoluteJoint { body_a = world.a, body_b = world.b }
    )");
    game.console("world.a:delete() world.j:delete()");
    game.console("undo()");
    CHECK(game.runtime->evaluate("world.j.body_a == world.a").result == property::Value(true));
    game.console("redo()");
    game.console("undo()");
    CHECK(game.runtime->evaluate("world.j.body_a == world.a").result == property::Value(true));
}

}  // namespace mid_step_test
