#include <cmath>
#include <random>

#include "catch.h"
#include "scenes.h"
#include "thorough.h"

namespace event_test {

using namespace scenes;

TEST_CASE("a contact begins once and ends once") {
    World world;
    Body floor = add_floor(world);
    Body ball = add_ball(world, {0, 1.5f}, 0.5f);
    int begun = 0, ended = 0;
    auto count = [&] {
        begun += int(world.events().contact_begin.size());
        ended += int(world.events().contact_end.size());
    };
    for (int i = 0; i < 120; ++i) {
        world.step(frame);
        for (const auto& e : world.events().contact_begin) {
            REQUIRE((e.body_a == floor.id() || e.body_b == floor.id()));
            REQUIRE((e.body_a == ball.id() || e.body_b == ball.id()));
            REQUIRE(e.point.y == Approx(0.0f).margin(0.03));
            REQUIRE(std::fabs(e.normal.y) == Approx(1.0f));
        }
        count();
    }
    REQUIRE(begun == 1);
    REQUIRE(ended == 0);
    REQUIRE(ball.is_touching());
    ball.set_velocity({0, 5});
    for (int i = 0; i < 10; ++i) {
        world.step(frame);
        count();
    }
    REQUIRE(begun == 1);
    REQUIRE(ended == 1);
    REQUIRE_FALSE(ball.is_touching());
}

TEST_CASE("a bounce that is over within a step is reported with its begin and its end") {
    World world({.gravity = {0, 0}});
    add_floor(world, 50.0f, {.restitution = 1.0f});
    Body ball = add_ball(world, {0, 3}, 0.5f, {.restitution = 1.0f});
    ball.set_velocity({0, -7});
    int begun = 0, ended = 0;
    for (int i = 0; i < 60; ++i) {
        world.step(frame);
        begun += int(world.events().contact_begin.size());
        ended += int(world.events().contact_end.size());
    }
    REQUIRE(ball.velocity().y > 6.0f);
    REQUIRE(begun == 1);
    REQUIRE(ended == 1);
}

TEST_CASE("a touch that ends and begins again in one step has ended first") {
    World world;
    add_floor(world);
    Body ball = add_ball(world, {0, 0.5f}, 0.5f);
    bool touches = false;
    for (int i = 0; i < 60; ++i) {
        if (i == 30) {
            ball.set_enabled(false);
            ball.set_enabled(true);
        }
        world.step(frame);
        for (const ContactEndEvent& event : world.events().contact_end) {
            CAPTURE(i, event.body_a.index);
            CHECK(touches);
            touches = false;
        }
        for (const ContactBeginEvent& event : world.events().contact_begin) {
            CAPTURE(i, event.body_a.index);
            CHECK_FALSE(touches);
            touches = true;
        }
        if (i == 30) CHECK(world.events().contact_end.size() == 1);
        CHECK(touches == ball.is_touching());
    }
    CHECK(touches);
}

TEST_CASE("a hit of a shape with hit events reports its speed and impulse and point") {
    World world({.gravity = {0, 0}});
    add_floor(world);
    Body ball = add_ball(world, {0, 2}, 0.5f, {.hit_events = true});
    Body quiet = add_ball(world, {5, 2}, 0.5f);
    ball.set_velocity({0, -4});
    quiet.set_velocity({0, -4});
    std::vector<ContactHitEvent> hits;
    for (int i = 0; i < 60; ++i) {
        world.step(frame);
        for (const auto& e : world.events().contact_hit) hits.push_back(e);
    }
    REQUIRE(hits.size() == 1);
    REQUIRE(hits[0].speed == Approx(4.0f).epsilon(0.01));
    REQUIRE(hits[0].impulse == Approx(4.0f * ball.mass()).epsilon(0.05));
    REQUIRE(hits[0].point.x == Approx(0.0f).margin(0.01));
    world.set_hit_threshold(10.0f);
    ball.set_position({0, 2});
    ball.set_velocity({0, -4});
    for (int i = 0; i < 60; ++i) {
        world.step(frame);
        REQUIRE(world.events().contact_hit.empty());
    }
}

namespace {

/// The first impact of a body that falls on a fixed floor: as the events report it, and as it was.
struct Impact {
    int hits = 0, begins = 0;
    float speed = 0.0f, impulse = 0.0f, begin_speed = 0.0f, begin_impulse = 0.0f;
    float change = 0.0f;  ///< of the momentum
};
Impact impact_on_floor(const Geometry& geometry, float height, float speed, float restitution) {
    const ShapeDef surface = {.restitution = restitution, .hit_events = true};
    World world({.gravity = {0, 0}, .hit_threshold = 0.4f});
    add_floor(world, 50.0f, surface);
    Body body = world.create_body({.position = {0, height}, .velocity = {0, -speed}});
    body.add(geometry, surface);
    Impact impact;
    for (int i = 0; i < 240; ++i) {
        world.step(frame);
        for (const ContactHitEvent& hit : world.events().contact_hit) {
            ++impact.hits;
            impact.speed = hit.speed;
            impact.impulse = hit.impulse;
        }
        for (const auto& begin : world.events().contact_begin) {
            ++impact.begins;
            impact.begin_speed = begin.speed;
            impact.begin_impulse = begin.impulse;
        }
    }
    impact.change = body.mass() * (body.velocity().y + speed);
    return impact;
}

}  // namespace

// Nothing presses on the contact after the impact, so it is over before the step is.
TEST_CASE("an impact under forces is reported with the speed at which the shapes meet") {
    std::mt19937 engine(1);
    const auto random = [&](float low, float high) {
        return low + (high - low) * float(engine()) / 4294967296.0f;
    };
    for (int seed = 0; seed < 50; ++seed) {
        const float height = 0.01f * std::pow(200.0f, random(0, 1)), restitution = random(0, 0.8f);
        // The floor is above where gravity pulls upwards.
        const float up = random(0, 1) < 0.3f ? -1.0f : 1.0f, push = random(-5, 5);
        World world({.gravity = {0, -10 * up}, .hit_threshold = 0.1f});
        Body floor =
            world.create_body({.type = BodyType::static_body, .position = {0, -0.5f * up}});
        floor.add(Box{.width = 20});
        const float downwards = random(0, 3);
        Body body = world.create_body({.position = {0, (0.5f + height) * up},
                                       .velocity = {0, -downwards * up},
                                       .force = {0, push * up},
                                       .mass = 1.0f});
        const ShapeDef surface = {.restitution = restitution, .hit_events = true};
        if (random(0, 1) < 0.5f)
            body.add(Circle{}, surface);
        else
            body.add(Box{}, surface);
        const float speed = std::sqrt(downwards * downwards + 2 * (10 - push) * height);
        const float bounce = speed > world.restitution_threshold() ? restitution : 0.0f;
        float begin = 0, hit = 0, impulse = 0;
        for (int i = 0; i < 120 && begin == 0; ++i) {
            world.step(frame);
            for (const auto& e : world.events().contact_begin) begin = e.speed, impulse = e.impulse;
            for (const auto& e : world.events().contact_hit) hit = e.speed;
        }
        CAPTURE(seed, height, speed, restitution, push);
        // Speeds change by up to 0.06 m/s in a sub-step.
        CHECK(begin == Approx(speed).margin(0.05));
        CHECK(hit == Approx(begin));
        if (std::fabs(speed - world.restitution_threshold()) > 0.1f)
            CHECK(impulse == Approx((1 + bounce) * speed).margin(0.2));
    }
}

TEST_CASE("an impact without gravity is reported once as it is at any distance and speed") {
    const Geometry geometry =
        GENERATE(Geometry(Circle{.radius = 0.3f}), Geometry(Box{.width = 0.6f, .height = 0.6f}));
    const float restitution = GENERATE(0.0f, 0.5f, 1.0f);
    for (const float speed : {0.6f, 0.9f, 2.0f, 3.0f, 7.0f, 20.0f}) {
        for (int i = 0; i < 40; ++i) {
            if (!is_tested(size_t(i), 4)) continue;
            const float height = 0.35f + 0.013f * float(i);
            CAPTURE(restitution, speed, height);
            const Impact impact = impact_on_floor(geometry, height, speed, restitution);
            CHECK(impact.hits == 1);
            CHECK(impact.begins == 1);
            CHECK(impact.speed == Approx(speed).epsilon(0.01));
            CHECK(impact.begin_speed == Approx(speed).epsilon(0.01));
            CHECK(impact.impulse == Approx(impact.change).epsilon(0.05));
            CHECK(impact.begin_impulse == Approx(impact.change).epsilon(0.05));
        }
    }
}

TEST_CASE("a box that lands makes one hit at any height") {
    for (int i = 0; i < 60; ++i) {
        World world;
        add_floor(world);
        Body box = world.create_body({.position = {0, 0.35f + 0.03f * float(i)}});
        box.add(Box{.width = 0.6f, .height = 0.6f}, {.hit_events = true});
        box.set_velocity({0, -20.0f + 0.1f * float(i)});
        int hits = 0;
        for (int k = 0; k < 60; ++k) {
            world.step(frame);
            hits += int(world.events().contact_hit.size());
        }
        INFO("world " << i);
        CHECK(hits == 1);
    }
}

TEST_CASE("falling asleep and waking are reported") {
    World world;
    add_floor(world);
    Body box = add_box(world, {0, 0.5f});
    int slept = 0;
    for (int i = 0; i < 180; ++i) {
        world.step(frame);
        for (BodyId id : world.events().slept) slept += id == box.id();
    }
    REQUIRE(slept == 1);
    box.set_awake(true);
    world.step(frame);
    REQUIRE(world.events().woke == std::vector<BodyId>{box.id()});
    world.step(frame);
    REQUIRE(world.events().woke.empty());
}

TEST_CASE("a sensor reports bodies that enter and leave and pushes none") {
    World world;
    Body zone = world.create_body({.type = BodyType::static_body});
    Shape sensor = zone.add(Box{.width = 4, .height = 2}, {.sensor = true});
    Body ball = add_ball(world, {0, 4});
    int entered = 0, left = 0;
    for (int i = 0; i < 120; ++i) {
        world.step(frame);
        for (const auto& e : world.events().sensor_begin) {
            REQUIRE(e.sensor == sensor.id());
            REQUIRE(e.visitor_body == ball.id());
            ++entered;
        }
        left += int(world.events().sensor_end.size());
        REQUIRE(world.events().contact_begin.empty());
    }
    REQUIRE(entered == 1);
    REQUIRE(left == 1);
    REQUIRE(ball.velocity().y == Approx(-20.0f).epsilon(1e-3));
}

TEST_CASE("a static sensor that comes to a sleeping body reports it") {
    World world;
    add_floor(world);
    Body crate = add_box(world, {0, 0.5f});
    run(world, 3.0f);
    REQUIRE_FALSE(crate.awake());
    Body zone = world.create_body({.type = BodyType::static_body, .position = {0, 0.5f}});
    Shape sensor;
    SECTION("made there") {
        sensor = zone.add(Box{.width = 2, .height = 2}, {.sensor = true});
    }
    SECTION("moved there") {
        zone.set_position({0, 20});
        sensor = zone.add(Box{.width = 2, .height = 2}, {.sensor = true});
        world.step(frame);
        zone.set_position({0, 0.5f});
    }
    SECTION("switched on there") {
        sensor = zone.add(Box{.width = 2, .height = 2}, {.sensor = true, .mask = 0});
        world.step(frame);
        REQUIRE(world.events().sensor_begin.empty());
        sensor.set_mask(~uint64_t{0});
    }
    world.step(frame);
    REQUIRE(world.events().sensor_begin.size() == 1);
    CHECK(world.events().sensor_begin.front().sensor == sensor.id());
    run(world, 3.0f);
    CHECK_FALSE(crate.awake());
}

TEST_CASE("a sensor that does not fall reports kinematic bodies and no others that stand still") {
    for (const BodyType type : {BodyType::static_body, BodyType::kinematic_body}) {
        World world;
        Body zone = world.create_body({.type = type});
        Shape sensor = zone.add(Box{.width = 4, .height = 2}, {.sensor = true});
        Body lift = world.create_body(
            {.type = BodyType::kinematic_body, .position = {0, 4}, .velocity = {0, -5}});
        lift.add(Circle{.radius = 0.5f});
        // One on a path, as by a tween.
        Body led = world.create_body({.type = BodyType::kinematic_body, .position = {1, 4}});
        led.add(Circle{.radius = 0.25f});
        // Another one beside it: kinematic bodies do not touch each other.
        Body near = world.create_body({.type = BodyType::kinematic_body, .position = {0.9f, 4}});
        near.add(Circle{.radius = 0.25f});
        // Another thing that never moves, and another sensor.
        world.create_body({.type = BodyType::static_body}).add(Circle{.radius = 0.5f});
        lift.add(Circle{.radius = 0.1f}, {.sensor = true});
        std::vector<BodyId> entered, left;
        for (int i = 0; i < 120; ++i) {
            led.set_position({1, 4 - 0.1f * float(i)});
            world.step(frame);
            for (const auto& e : world.events().sensor_begin) {
                if (e.sensor != sensor.id()) continue;
                entered.push_back(e.visitor_body);
            }
            for (const auto& e : world.events().sensor_end)
                if (e.sensor == sensor.id()) left.push_back(e.visitor_body);
            REQUIRE(world.events().contact_begin.empty());
        }
        CHECK(std::count(entered.begin(), entered.end(), lift.id()) == 1);
        CHECK(std::count(left.begin(), left.end(), lift.id()) == 1);
        CHECK(std::count(entered.begin(), entered.end(), led.id()) == 1);
        CHECK(std::count(left.begin(), left.end(), led.id()) == 1);
        CHECK(entered.size() == 2);
        CHECK(left.size() == 2);
        REQUIRE_FALSE(world.validate());
    }
}

TEST_CASE("destroying a touching body ends its contacts with a dangling id") {
    World world;
    Body floor = add_floor(world);
    Body box = add_box(world, {0, 0.5f});
    run(world, 0.5f);
    const BodyId id = box.id();
    REQUIRE(floor.is_touching());
    box.destroy();
    REQUIRE_FALSE(floor.is_touching());
    world.step(frame);
    REQUIRE(world.events().contact_end.size() == 1);
    const auto& e = world.events().contact_end[0];
    REQUIRE((e.body_a == id || e.body_b == id));
    REQUIRE_FALSE(world.is_valid(id));
}

TEST_CASE("the contacts of a resting body carry its weight even when it sleeps") {
    World world;
    add_floor(world);
    Body box = add_box(world, {0, 0.5f}, 1.0f, {.density = 3.0f});
    run(world, 3.0f);
    REQUIRE_FALSE(box.awake());
    const auto contacts = box.contacts();
    REQUIRE(contacts.size() == 1);
    REQUIRE(contacts[0].point_count == 2);
    REQUIRE(contacts[0].normal_force == Approx(30.0f).epsilon(0.02));
    for (int k = 0; k < 2; ++k) {
        REQUIRE(std::fabs(contacts[0].points[size_t(k)].point.x) == Approx(0.5f).margin(0.01));
        REQUIRE(contacts[0].points[size_t(k)].point.y == Approx(0.0f).margin(0.01));
    }
}

}  // namespace event_test
