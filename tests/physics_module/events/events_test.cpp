// Events: reported to both parties, once, and only if there is a handler.

#include "catch.h"
#include "game.h"

namespace events_test {

using namespace fettle::physics_module::testing;
using namespace fettle;
using property::Occurrence;

namespace {

struct Listening : Game {
    std::vector<std::string> log;
    std::vector<Occurrence> seen;

    void listen(Handle to, const char* name) {
        const property::Event& event = *tree.class_of(to).event(name);
        tree.on(to, event, [this](const Occurrence& o) {
            const Value other = o.record.get("other");
            log.push_back(tree.name(o.instance) + " " + o.event->name +
                          (other.is_nil() ? "" : " " + tree.text(other)));
            seen.push_back(o);
        });
    }
};
using Log = std::vector<std::string>;

}  // namespace

TEST_CASE_METHOD(Listening,
                 "both bodies and both shapes get the event of a contact from their side") {
    const Handle ground = floor();
    const Handle ball = body("Circle", {0, 2});
    for (const Handle h : {ball, ground, shape_of(ball), shape_of(ground)})
        listen(h, "contact_begin");
    step(60);
    REQUIRE(seen.size() == 4);
    for (const Occurrence& o : seen) {
        const bool of_ball = o.instance == ball || o.instance == shape_of(ball);
        INFO(tree.path(o.instance));
        CHECK(o.record.get("other") == (of_ball ? ground : ball));
        CHECK(o.record.get("shape") == shape_of(of_ball ? ball : ground));
        CHECK(o.record.get("other_shape") == shape_of(of_ball ? ground : ball));
        CHECK((o.record.get("normal").vec2() - Vec2(0, of_ball ? -1 : 1)).length() < 1e-4);
        CHECK(o.record.get("point").vec2().y == Approx(0).margin(0.1));
        // From 1.5 m above the floor: v² = 2 g s.
        CHECK(o.record.get("speed").number() == Approx(5.48).margin(0.2));
        CHECK(o.record.get("impulse").number() ==
              Approx(o.record.get("speed").number() * number(ball, "mass")).epsilon(1e-4));
        CHECK(o.record.get("friction").number() == Approx(0.6));
        CHECK(o.record.get("restitution").number() == 0);
    }
}

TEST_CASE_METHOD(Listening, "a contact ends when the bodies part") {
    floor();
    const Handle ball = body("Circle", {0, 0.5});
    for (const char* name : {"contact_begin", "contact_end"}) listen(ball, name);
    step(5);
    set(ball, "position", Vec2(0, 10));
    step(3);
    CHECK(log == Log{"body_2 contact_begin world.body_1", "body_2 contact_end world.body_1"});
}

TEST_CASE_METHOD(Listening,
                 "the event of the end of a contact names a body that was deleted during it") {
    const Handle ground = floor();
    const Handle ball = body("Circle", {0, 0.5});
    step(5);
    listen(ground, "contact_end");
    const Handle circle = shape_of(ball);
    SECTION("the body") {
        tree.destroy(ball);
    }
    SECTION("only its shape") {
        tree.destroy(circle);
    }
    SECTION("it leaves the world") {
        tree.move(ball, {});
    }
    step();
    REQUIRE(seen.size() == 1);
    CHECK(seen[0].record.get("other") == ball);
    CHECK(seen[0].record.get("other_shape") == circle);
    step(3);
    CHECK(seen.size() == 1);
}

TEST_CASE_METHOD(Listening, "a handler may delete the instance of its event") {
    const Handle ground = floor();
    std::vector<Handle> balls;
    for (int i = 0; i < 10; ++i) balls.push_back(body("Circle", {2.0 * i - 10, 1}));
    const property::Event& begin = *tree.class_of(ground).event("contact_begin");
    int reported = 0;
    tree.on(ground, begin, [&](const Occurrence& o) {
        ++reported;
        tree.destroy(o.record.get("other").reference());
    });
    step(60);
    CHECK(reported == 10);
    for (const Handle ball : balls) CHECK_FALSE(tree.alive(ball));
    CHECK_FALSE(physics.world(world()).validate());
}

TEST_CASE_METHOD(Listening,
                 "hits are reported with speed and impulse and handlers of them wake no body") {
    floor();
    const Handle sleeper = body("Box", {10, 0.5});
    REQUIRE(falls_asleep(sleeper));
    const Handle ball = body("Circle", {0, 3});
    listen(ball, "contact_hit");
    step(90);
    REQUIRE(seen.size() == 1);
    CHECK(seen[0].record.get("speed").number() > 6);
    CHECK(seen[0].record.get("impulse").number() > 4);
    CHECK_FALSE(awake(sleeper));
    // Shapes made while a handler exists report, too.
    const Handle second = body("Circle", {5, 3});
    listen(second, "contact_hit");
    step(90);
    CHECK(seen.size() == 2);
}

TEST_CASE_METHOD(Listening, "a sensor and the shape in it both get the event") {
    const Handle gate = body("Box", {0, 0}, "static");
    tree.rename(gate, "gate");
    set(shape_of(gate), "sensor", true);
    const Handle ball = body("Circle", {0, 3});
    tree.rename(ball, "ball");
    for (const Handle h : {gate, ball})
        for (const char* name : {"sensor_begin", "sensor_end", "contact_begin"}) listen(h, name);
    step(90);
    CHECK(y(ball) < -3);
    std::sort(log.begin(), log.end());
    CHECK(log == Log{"ball sensor_begin world.gate", "ball sensor_end world.gate",
                     "gate sensor_begin world.ball", "gate sensor_end world.ball"});
}

TEST_CASE_METHOD(Listening, "a body reports when it falls asleep and when it wakes") {
    floor();
    const Handle ball = body("Circle", {0, 0.5});
    for (const char* name : {"slept", "woke"}) listen(ball, name);
    REQUIRE(falls_asleep(ball));
    set(ball, "velocity", Vec2(0, 1));
    step();
    CHECK(log == Log{"body_2 slept", "body_2 woke"});
}

TEST_CASE_METHOD(Listening, "the other side of a contact with the bounds is the world") {
    set(world(), "bounds", List{Vec2(-5, 0), Vec2(5, 10)});
    const Handle ball = body("Circle", {0, 2});
    listen(ball, "contact_begin");
    step(60);
    REQUIRE(seen.size() == 1);
    CHECK(seen[0].record.get("other") == world());
    CHECK(seen[0].record.get("other_shape").reference() == Handle{});
    CHECK((seen[0].record.get("normal").vec2() - Vec2(0, -1)).length() < 1e-4);
    CHECK(get(ball, "contacts").list() == List{world()});
    CHECK(y(ball) > 0.45);
}

TEST_CASE_METHOD(Listening,
                 "a handler of a class gets the events of every body until it is stopped") {
    floor();
    for (int i = 0; i < 4; ++i) body("Circle", {2.0 * i, 1});
    const property::Class& of = tree.class_named("Body");
    int calls = 0;
    auto connection = tree.on(of, *of.event("contact_begin"), [&](const Occurrence&) { ++calls; });
    step(60);
    CHECK(calls == 8);
    connection.stop();
    body("Circle", {-6, 1});
    step(60);
    CHECK(calls == 8);
}

TEST_CASE_METHOD(Listening, "a world that is stepped but not reported keeps no events") {
    const Handle ground = floor();
    listen(ground, "contact_end");
    const Handle ball = body("Circle", {0, 0.5});
    step(5);
    tree.destroy(ball);
    for (int i = 0; i < 3; ++i) physics.step(1.0 / 60);
    physics.report(tree);
    tree.barrier();
    CHECK(seen.empty());  // the event happened two steps before the reported one
}

TEST_CASE_METHOD(Listening,
                 "the event of a touch names its surface even if the touch is already over") {
    const Handle ground = floor();
    const Handle ball = body("Circle", {0, 0.5});
    set(shape_of(ball), "friction", 0.15);
    set(shape_of(ball), "restitution", 0.25);
    listen(ground, "contact_begin");
    physics.step(1.0 / 60);
    set(shape_of(ball), "mask", 0);
    physics.report(tree);
    tree.barrier();
    REQUIRE(seen.size() == 1);
    CHECK(seen[0].record.get("friction").number() == Approx(0.3));
    CHECK(seen[0].record.get("restitution").number() == Approx(0.25));
}

TEST_CASE_METHOD(Listening, "thousands of boxes on one floor each report every lasting touch") {
    const Handle ground = floor();
    set(shape_of(ground), "width", 8000);
    set(world(), "sleeping", false);
    constexpr int boxes = 4000;
    for (int i = 0; i < boxes; ++i) body("Box", {1.5 * (i - boxes / 2), 0.5});
    int reported = 0;
    tree.on(tree.class_named("Body"), *tree.class_named("Body").event("contact_persist"),
            [&](const Occurrence& o) {
                reported += o.record.get("friction").number() == Approx(0.6) ? 1 : -1000000;
            });
    step(5);
    reported = 0;
    step(20);  // a step took four seconds when every event searched for its contact
    CHECK(reported == 20 * 2 * boxes);
}

TEST_CASE_METHOD(
    Listening,
    "an event about a body that a handler deleted is reported once and only to the other body") {
    // Two balls hit a brick and a sensor in the same step; the first handler deletes both.
    set(world(), "gravity", Vec2(0, 0));
    const Handle brick = body("Box", {0, 0}, "static"), gate = body("Box", {0, 1}, "static");
    set(shape_of(brick), "width", 6);
    set(shape_of(gate), "width", 6);
    set(shape_of(gate), "sensor", true);
    int counted[2] = {0, 0};
    Handle balls[2];
    for (int i = 0; i < 2; ++i) {
        balls[i] = body("Circle", {4.0 * i - 2, 3});
        set(balls[i], "velocity", Vec2(0, -5));
        for (const char* name : {"sensor_begin", "sensor_end", "contact_begin", "contact_end"}) {
            const int by = std::string_view(name).ends_with("begin") ? 1 : -1;
            tree.on(balls[i], *tree.class_of(balls[i]).event(name),
                    [&, i, by](const Occurrence& o) {
                        const Value other = o.record.get("other");
                        log.push_back(o.event->name);
                        counted[i] += by;
                        if (by == 1) tree.destroy(other.reference());
                    });
        }
    }
    step(90);
    CHECK(log == Log{"sensor_begin", "sensor_end", "contact_begin", "contact_end"});
    CHECK(counted[0] == 0);
    CHECK(counted[1] == 0);
    CHECK_FALSE(physics.world(world()).validate());
}

}  // namespace events_test
