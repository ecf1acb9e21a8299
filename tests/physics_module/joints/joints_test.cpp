// Joints in the tree: before they act, while they act, and afterwards.

#include "catch.h"
#include "game.h"

namespace joints_test {

using namespace fettle::physics_module::testing;
using namespace fettle;

TEST_CASE_METHOD(Game, "a mouse joint holds the point of the body that is at its target") {
    const Handle crate = body("Box", {3, 5});
    const Handle joint = make("MouseJoint", world());
    set(joint, "body", crate);
    set(joint, "target", Vec2(3.4, 5.2));
    CHECK((vec(joint, "anchor") - Vec2(0.4, 0.2)).length() < 1e-5);
    step();
    CHECK((vec(joint, "anchor") - Vec2(0.4, 0.2)).length() < 1e-5);
    set(joint, "target", Vec2(0, 8));
    step(120);
    CHECK((vec(joint, "anchor") - Vec2(0.4, 0.2)).length() < 1e-5);
    const Value at = std::get<Value>(tree.call(crate, "to_world", {get(joint, "anchor")}));
    CHECK((at.vec2() - Vec2(0, 8)).length() < 0.2);
    CHECK(vec(joint, "force").y > 5);  // it carries 10 N
}

TEST_CASE_METHOD(Game, "an explicitly set anchor stays when the joint gets another body") {
    const Handle a = body("Box", {0, 5}), b = body("Box", {4, 5});
    const Handle joint = make("MouseJoint", world(), {{"body", a}, {"anchor", Vec2(0.5, 0.5)}});
    step();
    set(joint, "body", b);
    step();
    CHECK(vec(joint, "anchor") == Vec2(0.5, 0.5));
    set(joint, "target", Vec2(4, 5));
    set(joint, "anchor", Value());
    CHECK(vec(joint, "anchor") != Vec2(0.5, 0.5));
}

TEST_CASE_METHOD(Game, "a joint survives the deletion of its body and can get another") {
    const Handle a = body("Box", {0, 5}), b = body("Box", {4, 5});
    const Handle joint =
        make("MouseJoint", world(), {{"body", a}, {"target", Vec2(0, 9)}, {"anchor", Vec2(0, 0)}});
    step(30);
    REQUIRE(y(a) > 5);
    tree.destroy(a);
    CHECK(get(joint, "body").reference() == Handle{});
    CHECK(vec(joint, "force") == Vec2(0, 0));
    step(2);
    set(joint, "frequency", 3);
    set(joint, "target", Vec2(4, 9));
    set(joint, "body", b);
    step(60);
    CHECK(y(b) > 6);
    tree.destroy(joint);
    step(60);
    CHECK(y(b) < 6);
    CHECK(physics.world(world()).joint_count() == 0);
}

TEST_CASE_METHOD(Game, "the joints of a body act again when its deletion is undone") {
    for (const char* type : {"RevoluteJoint", "DistanceJoint", "WeldJoint", "PrismaticJoint"}) {
        INFO(type);
        const Handle ball = body("Circle", {0, 5});
        const Handle joint = make(type, world(), {{"body_b", ball}, {"anchor_a", Vec2(0, 5)}});
        step(10);
        const Vec2 before = vec(ball, "position");
        {
            const property::Tree::CauseScope cause(tree, property::Writer::console);
            tree.destroy(ball);
        }
        step(6);
        tree.undo();
        REQUIRE(tree.alive(ball));
        REQUIRE(get(joint, "body_b").reference() == ball);
        step(60);
        CHECK((vec(ball, "position") - before).length() < 1.5);
        tree.destroy(ball);
        tree.destroy(joint);
    }
}

TEST_CASE_METHOD(Game, "a joint acts only while it is in the world of its body") {
    const Handle crate = body("Box", {0, 5});
    const Handle joint = make("MouseJoint", world(), {{"body", crate}, {"target", Vec2(0, 5)}});
    const Handle second = make("World", tree.root(), "second");
    step(20);
    CHECK(y(crate) > 4.5);
    tree.move(crate, second);
    step(20);
    CHECK(y(crate) < 4.5);
    set(crate, "position", Vec2(0, 5));
    set(crate, "velocity", Vec2(0, 0));
    tree.move(joint, second);
    step(20);
    CHECK(y(crate) > 4.5);
    CHECK(get(joint, "body").reference() == crate);
    tree.destroy(second);
    CHECK_FALSE(tree.alive(joint));
    step();
}

TEST_CASE_METHOD(Game, "a joint made before its body has a world acts after the body entered one") {
    const Handle crate = make("Body", Handle{}, {{"position", Vec2(0, 5)}});
    make("Box", crate);
    const Handle joint = make("MouseJoint", crate, {{"body", crate}, {"target", Vec2(0, 5)}});
    step(5);
    tree.move(crate, world(), "crate");
    step(20);
    CHECK(y(crate) > 4.5);
    CHECK(vec(joint, "force").y > 5);
    CHECK_THROWS_WITH(set(joint, "body", joint), contains("Body"));
}

TEST_CASE_METHOD(Game, "a joint reports a load above its threshold and holds") {
    const Handle crate = body("Box", {0, 5});
    const Handle weld = make("WeldJoint", world(), {{"body_b", crate}, {"anchor_a", Vec2(0, 5)}});
    std::vector<double> loads;
    const auto connection = tree.on(weld, *tree.class_of(weld).event("loaded"),
                                    [&](const property::Occurrence& occurrence) {
                                        loads.push_back(occurrence.record.get("force").vec2().y);
                                    });
    step(2);
    CHECK(loads.empty());
    set(weld, "report_force", 9);
    step(3);
    REQUIRE(loads.size() == 3);
    CHECK(loads[2] == Approx(10).epsilon(0.05));
    CHECK(get(weld, "broken") == Value(false));
    CHECK(number(weld, "separation") < 0.01);
    CHECK(number(weld, "angular_separation") == 0);
}

TEST_CASE_METHOD(Game, "the bodies of a filter joint pass through each other") {
    floor();
    const Handle low = body("Box", {0, 0.5}), high = body("Box", {0, 3});
    const Handle filter = make("FilterJoint", world(), {{"body_a", low}, {"body_b", high}});
    step(120);
    CHECK(y(high) == Approx(0.5).margin(0.02));
    CHECK_FALSE(awake(high));
    tree.destroy(filter);
    step(60);
    CHECK((vec(high, "position") - vec(low, "position")).length() > 0.9);
}

TEST_CASE_METHOD(Game, "an explosion by surface pushes larger bodies with more impulse") {
    const Handle small = body("Box", {3, 5}), large = body("Box", {-4, 5});
    set(shape_of(large), "width", 2);
    set(shape_of(large), "height", 2);
    tree.call(world(), "explode_surfaces", {Vec2(0, 5), 2.4, 1, 6});
    CHECK(vec(small, "velocity").x * number(small, "mass") == Approx(6 * 0.9));
    CHECK(vec(large, "velocity").x * number(large, "mass") == Approx(-12 * 0.4));
}

TEST_CASE_METHOD(Game, "a joint that breaks reports its force and is broken in the tree too") {
    const Handle crate = body("Box", {0, 5});
    const Handle weld = make("WeldJoint", world(), {{"body_b", crate}, {"anchor_a", Vec2(0, 5)}});
    std::vector<double> loads;
    const auto connection = tree.on(weld, *tree.class_of(weld).event("broke"),
                                    [&](const property::Occurrence& occurrence) {
                                        loads.push_back(occurrence.record.get("force").vec2().y);
                                    });
    set(weld, "break_force", 9);
    step(2);
    REQUIRE(loads.size() == 1);
    CHECK(loads[0] == Approx(10).epsilon(0.05));
    CHECK(get(weld, "broken") == Value(true));
    step(20);
    CHECK(y(crate) < 4.7);
    set(weld, "break_force", std::numeric_limits<double>::infinity());
    set(crate, "position", Vec2(0, 5));
    set(crate, "velocity", Vec2(0, 0));
    set(weld, "broken", false);
    step(20);
    CHECK(y(crate) > 4.9);
    CHECK(loads.size() == 1);
}

TEST_CASE_METHOD(Game, "a joint refuses the same values whether it acts or not") {
    const Handle crate = body("Box", {0, 1});
    const Handle wheel = make("WheelJoint", world(), {{"body_b", crate}});
    const Handle waiting = make("WheelJoint", Handle{});
    step();
    const auto refusal = [&](Handle joint, const char* property, const Value& value) {
        try {
            set(joint, property, value);
        } catch (const property::Error& error) {
            const std::string text = error.what();
            return text.substr(text.find(": "));
        }
        return std::string("accepted");
    };
    CHECK(refusal(wheel, "axis", Vec2(0, 0)) == ": expected a direction, got no length");
    CHECK(refusal(waiting, "axis", Vec2(0, 0)) == ": expected a direction, got no length");
    CHECK_THAT(refusal(waiting, "anchor_a", Vec2(1e9, 0)),
               contains("expected a vec2 from -1e8 to 1e8 m, got vec(1"));
    CHECK(get(waiting, "axis") == Value(Vec2(0, 1)));
    CHECK(refusal(waiting, "axis", Vec2(3, 4)) == "accepted");
    CHECK(get(waiting, "axis") == Value(Vec2(3, 4)));
    // A value set for one joint does not affect another of its type.
    CHECK(get(make("WheelJoint", Handle{}), "axis") == Value(Vec2(0, 1)));
}

TEST_CASE_METHOD(
    Game, "the settings of a joint are stored in its world from the beginning and move with it") {
    const Handle crate = body("Box", {0, 5}), other = make("World", tree.root());
    const Handle joint = make("WheelJoint", world(), {{"hertz", 2}, {"break_force", 90}});
    const Handle steps = tree.child(world(), "step");
    physics::World& home = physics.world(world());
    const auto made = [](physics::World& in) {
        return in.joint<physics::WheelJoint>(in.joints().at(0).id());
    };
    step();
    REQUIRE(home.joints().size() == 1);
    CHECK(made(home).dormant());
    CHECK(made(home).hertz() == 2.0f);
    CHECK(get(steps, "joints") == Value(std::int64_t{0}));
    made(home).set_hertz(3.0f);
    CHECK(get(joint, "hertz") == Value(3.0));
    set(joint, "body_b", crate);
    CHECK(made(home).dormant());  // dormant until the next step
    step();
    CHECK_FALSE(made(home).dormant());
    CHECK(get(steps, "joints") == Value(std::int64_t{1}));
    for (const Handle to : {other, Handle{}, world()}) {
        tree.move(joint, to);
        CHECK(get(joint, "hertz") == Value(3.0));
        CHECK(get(joint, "break_force") == Value(90.0));
        CHECK(get(joint, "body_b").reference() == crate);
        step();
        CHECK(home.joints().size() == (to == world() ? 1 : 0));
    }
    CHECK_FALSE(made(home).dormant());
    tree.destroy(crate);
    CHECK(made(home).dormant());
    CHECK(get(joint, "hertz") == Value(3.0));
    CHECK_FALSE(home.validate());
}

TEST_CASE_METHOD(Game, "a body that is far away and has turned often moves to another world") {
    const Handle other = make("World", tree.root());
    const Handle crate = body("Box", {1e8, 0});
    set(crate, "center", Vec2(-5e7, 3));
    set(crate, "angle", 1e8);
    set(crate, "velocity", Vec2(9000, 0));
    set(crate, "angular_velocity", 900);
    step(30);
    for (const Handle to : {other, Handle{}, world()}) {
        REQUIRE_NOTHROW(tree.move(crate, to));
        CHECK(get(crate, "center") == Value(Vec2(-5e7, 3)));
        step();
    }
    CHECK_FALSE(physics.world(world()).validate());
}

}  // namespace joints_test
