// Questions inside a step, and queries with shapes.

#include <fettle/property/question.h>

#include "catch.h"
#include "game.h"

namespace asking_test {

using namespace fettle::physics_module::testing;
using namespace fettle;
using property::Occurrence;
using property::Question;
using property::Record;

TEST_CASE_METHOD(Game, "a handler of before_solve lets a body through a platform") {
    const Handle crate = body("Box", {0, 3}), platform = body("Box", {0, 1}, "static");
    int calls = 0;
    const auto connection =
        tree.on(platform, *tree.class_of(platform).event("before_solve"), [&](const Occurrence& o) {
            ++calls;
            CHECK(o.record.get("other") == crate);
            CHECK(o.record.get("shape") == shape_of(platform));
            if (calls == 1) CHECK(o.record.get("normal").vec2().y == Approx(1));
            Question::current()->answer(9, false);
        });
    step(90);
    CHECK(calls > 2);
    CHECK(y(crate) < 0);
    CHECK(Question::current() == nullptr);
}

TEST_CASE_METHOD(Game, "an answer outside its range is refused and the mixed value is kept") {
    floor();
    const Handle crate = body("Box", {0, 0.5});
    std::vector<std::string> refused;
    const auto answer = [&](std::size_t field, Value value) {
        try {
            Question::current()->answer(field, value);
            refused.emplace_back("accepted");
        } catch (const property::Error& error) {
            refused.emplace_back(error.what());
        }
    };
    double friction = -1;
    const auto connection =
        tree.on(crate, *tree.class_of(crate).event("before_solve"), [&](const Occurrence& o) {
            if (!refused.empty()) return;
            friction = o.record.get("friction").number();
            answer(7, -5);
            answer(8, 1.5);
            answer(8, 1);
            CHECK(Question::current()->values()[7] == Value(friction));
        });
    step(2);
    REQUIRE(refused.size() == 3);
    CHECK(refused[0].find("before_solve: friction: expected a number of at least 0, got -5") !=
          std::string::npos);
    CHECK(refused[1].find("restitution: expected a number from 0 to 1, got 1.5") !=
          std::string::npos);
    CHECK(refused[2] == "accepted");
}

TEST_CASE_METHOD(Game, "a handler of a question may not write anything else") {
    floor();
    const Handle crate = body("Box", {0, 0.5});
    std::vector<std::string> refused;
    const auto attempt = [&](auto&& act) {
        try {
            act();
            refused.emplace_back("accepted");
        } catch (const std::exception& error) {
            refused.emplace_back(error.what());
        }
    };
    const auto connection =
        tree.on(crate, *tree.class_of(crate).event("before_solve"), [&](const Occurrence&) {
            if (!refused.empty()) return;
            attempt([&] { tree.set(crate, "mass", 3); });
            attempt([&] { tree.set(crate, "linear_damping", 0.5); });
            attempt([&] { tree.destroy(crate); });
            attempt([&] { tree.call(crate, "apply_impulse", {Vec2(0, 9)}); });
            attempt([&] { Question::current()->answer(3, Vec2(1, 1)); });
            attempt([&] { Question::current()->answer(7, "slippery"); });
            CHECK(tree.get(crate, "mass").number() == 1);  // reading is allowed
        });
    step(2);
    REQUIRE(refused.size() == 6);
    for (const std::string& message : refused) {
        INFO(message);
        CHECK(message.find("before_solve") != std::string::npos);
    }
    CHECK(refused[4].find("point") != std::string::npos);
    CHECK(refused[5].find("friction") != std::string::npos);
}

TEST_CASE_METHOD(Game, "a handler of mix_surfaces removes the friction of some contacts") {
    floor();
    const Handle left = body("Box", {-5, 0.5}), right = body("Box", {5, 0.5});
    const auto connection =
        tree.on(world(), *tree.class_of(world()).event("mix_surfaces"), [&](const Occurrence& o) {
            if (o.record.get("body") == left || o.record.get("other") == left)
                Question::current()->answer(8, 0);
        });
    set(left, "velocity", Vec2(-3, 0));
    set(right, "velocity", Vec2(3, 0));
    step(60);
    CHECK(vec(left, "velocity").x == Approx(-3).epsilon(1e-3));
    CHECK(vec(right, "velocity").x == Approx(0).margin(1e-3));
}

TEST_CASE_METHOD(Game, "a handler of filter_pair decides which shapes collide") {
    floor();
    const Handle ghost = body("Box", {0, 2}), crate = body("Box", {5, 2});
    auto connection =
        tree.on(world(), *tree.class_of(world()).event("filter_pair"), [&](const Occurrence& o) {
            if (o.record.get("body") == ghost || o.record.get("other") == ghost)
                Question::current()->answer(4, false);
        });
    step(120);
    CHECK(y(ghost) < -1);
    CHECK(y(crate) == Approx(0.5).margin(0.01));
    connection.stop();
    set(ghost, "position", Vec2(0, 2));
    set(ghost, "velocity", Vec2(0, 0));
    step(120);
    CHECK(y(ghost) == Approx(0.5).margin(0.01));
}

TEST_CASE_METHOD(Game, "a lasting contact is reported in every step with its impulse") {
    floor();
    const Handle crate = body("Box", {0, 0.5});
    int begun = 0, lasting = 0;
    double impulse = 0;
    const auto first = tree.on(crate, *tree.class_of(crate).event("contact_begin"),
                               [&](const Occurrence&) { ++begun; });
    const auto second =
        tree.on(crate, *tree.class_of(crate).event("contact_persist"), [&](const Occurrence& o) {
            ++lasting;
            impulse = o.record.get("impulse").number();
        });
    step(20);
    CHECK(begun == 1);
    CHECK(lasting == 19);
    CHECK(impulse == Approx(10.0 / 60).epsilon(0.02));
    CHECK(get(crate, "contact_force").number() == Approx(10).epsilon(0.02));
}

TEST_CASE_METHOD(Game, "a world finds the shapes that overlap a shape and those it would hit") {
    const Handle a = body("Box", {3, 0}), b = body("Box", {8, 0});
    const Handle probe = make("Circle", Handle{}, {{"radius", 1}, {"center", Vec2(2, 0)}});
    CHECK(std::get<Value>(tree.call(world(), "overlap", {probe})) == Value(List{a}));
    CHECK(std::get<Value>(tree.call(world(), "overlap", {a})) == Value(List{}));
    const Record hit = std::get<Record>(tree.call(world(), "shapecast", {a, Vec2(10, 0)}));
    CHECK(hit.get("body") == b);
    CHECK(hit.get("fraction").number() == Approx(0.4).margin(1e-3));
    const Record near = std::get<Record>(tree.call(world(), "closest", {Vec2(0, 0)}));
    CHECK(near.get("body") == a);
    CHECK(near.get("distance").number() == Approx(2.5));
    CHECK(std::get<Value>(tree.call(world(), "closest", {Vec2(0, 0), 2})).is_nil());
    const Record gap = std::get<Record>(tree.call(world(), "distance", {a, b}));
    CHECK(gap.get("distance").number() == Approx(4));
    CHECK(gap.get("point_b").vec2().x == Approx(7.5));
    CHECK_THROWS_WITH(tree.call(world(), "overlap", {world()}), contains("shape or a body"));
    const Vec2 before = vec(a, "velocity");
    tree.call(world(), "explode", {Vec2(0, 0), 5, 10});
    CHECK(vec(a, "velocity").x > before.x + 4);
    CHECK(vec(b, "velocity").x == 0);
}

TEST_CASE_METHOD(Game, "a field moves with its instance from world to world") {
    const Handle crate = body("Box", {0, 5});
    const Handle planet =
        make("Attractor", Handle{}, {{"center", Vec2(0, 100)}, {"falloff", 0}, {"strength", 30}});
    step(10);
    CHECK(vec(crate, "velocity").y < 0);
    tree.move(planet, world(), "planet");
    step(30);
    CHECK(vec(crate, "velocity").y > 0);
    CHECK(get(planet, "strength") == Value(30.0));
    tree.destroy(planet);
    const double rising = vec(crate, "velocity").y;
    step(10);
    CHECK(vec(crate, "velocity").y < rising);
}

TEST_CASE_METHOD(Game, "forces for the next step move with the body into another world") {
    const Handle crate = make("Body", Handle{}, {{"position", Vec2(0, 5)}});
    make("Box", crate);
    tree.call(crate, "apply_force", {Vec2(600, 0)});
    tree.move(crate, world(), "crate");
    step();
    CHECK(vec(crate, "velocity").x == Approx(10).epsilon(0.01));
    step();
    CHECK(vec(crate, "velocity").x == Approx(10).epsilon(0.01));
}

TEST_CASE_METHOD(Game, "the touches of a body are lists that can be watched") {
    const Handle ground = make("Body", world(), {{"type", "static"}});
    const Handle chain = make("Chain", ground);
    List points;
    for (int i = -8; i <= 8; ++i) points.push_back(Vec2(0.3 * i, 0));
    set(chain, "points", points);
    const Handle crate = body("Box", {0, 0.5});
    int reported = 0;
    tree.watch(crate, "contact_impulses", [&](const property::Change&) { ++reported; });
    step(30);
    // It is one touch, although several pieces of the chain touch.
    REQUIRE(get(crate, "contacts").list() == List{ground});
    REQUIRE(get(crate, "contact_shapes").list() == List{chain});
    REQUIRE(get(crate, "contact_points").list().size() == 1);
    CHECK(get(crate, "contact_points").list()[0].vec2().y == Approx(0).margin(0.01));
    CHECK(get(crate, "contact_normals").list()[0].vec2().y == Approx(-1));
    CHECK(get(crate, "contact_impulses").list()[0].number() == Approx(10.0 / 60).epsilon(0.05));
    CHECK(reported > 1);
    set(crate, "position", Vec2(0, 5));
    step(1);
    CHECK(get(crate, "contacts").list().empty());
    CHECK(get(crate, "contact_impulses").list().empty());
}

TEST_CASE_METHOD(Game, "a body lists the bodies that it touches with points and impulses") {
    const Handle ground = floor();
    const Handle crate = body("Box", {0, 0.5}), top = body("Box", {0, 1.5});
    step(30);
    const auto touches = std::get<std::vector<Record>>(tree.call(crate, "touches", {}));
    CHECK(tree.class_of(crate).method("touches")->many);
    REQUIRE(touches.size() == 2);
    for (const Record& touch : touches) {
        const bool below = touch.get("other") == ground;
        CHECK((below || touch.get("other") == top));
        CHECK(touch.get("shape") == shape_of(crate));
        CHECK(touch.get("normal").vec2().y == Approx(below ? -1 : 1));
        CHECK(touch.get("point").vec2().y == Approx(below ? 0 : 1).margin(0.01));
        CHECK(touch.get("impulse").number() == Approx((below ? 20.0 : 10.0) / 60).epsilon(0.05));
    }
}

}  // namespace asking_test
