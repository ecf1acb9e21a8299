#include <unordered_set>

#include "catch.h"
#include "saved_worlds.h"
#include "scenes.h"

namespace event_switches_test {

// Which touches are reported and passed to before-solve, ids of contacts, and ignored pairs.

using namespace scenes;

namespace {

struct Heard {
    int begins = 0, ends = 0, persists = 0, sensor_begins = 0, sensor_ends = 0;

    void listen(const World& world) {
        const Events& events = world.events();
        begins += int(events.contact_begin.size());
        ends += int(events.contact_end.size());
        persists += int(events.contact_persist.size());
        sensor_begins += int(events.sensor_begin.size());
        sensor_ends += int(events.sensor_end.size());
    }
    void run(World& world, int steps) {
        for (int i = 0; i < steps; ++i) {
            world.step(frame);
            listen(world);
        }
    }
};

/// A flat chain of several segments, over which a ball rolls.
Body add_ground(World& world) {
    Body ground = world.create_body({.type = BodyType::static_body});
    ground.add(Chain{.points = {{-20, 0}, {-2, 0}, {-1, 0}, {0, 0}, {1, 0}, {20, 0}}});
    return ground;
}

}  // namespace

TEST_CASE("touches of a shape without contact events are not reported but can be read") {
    World world({.persist_events = true});
    add_floor(world);
    Body told = add_ball(world, {0, 0.6f}), silent = add_ball(world, {5, 0.6f});
    silent.shapes()[0].set_contact_events(false);
    Heard heard;
    heard.run(world, 30);
    REQUIRE(heard.begins == 1);
    REQUIRE(heard.persists > 10);
    REQUIRE(silent.is_touching());
    REQUIRE(silent.contacts().size() == 1);
    silent.set_position({5, 9});
    told.set_position({0, 9});
    heard.run(world, 2);
    REQUIRE(heard.ends == 1);
}

TEST_CASE("the end of a touch is reported exactly if its begin was reported") {
    for (const bool chain : {false, true}) {
        World world;
        if (chain)
            add_ground(world);
        else
            add_floor(world);
        Body ball = world.create_body({.position = {-5, 0.55f}});
        Shape shape = ball.add(Circle{});
        Heard heard;
        heard.run(world, 20);
        REQUIRE(heard.begins == 1);
        shape.set_contact_events(false);
        ball.set_velocity({7, 0});
        heard.run(world, 120);  // over all segments of the chain
        REQUIRE(ball.position().x > 1);
        REQUIRE(heard.begins == heard.ends + 1);
        ball.set_position({3, 9});
        heard.run(world, 2);
        REQUIRE(heard.begins == heard.ends);
        const int begins = heard.begins;
        ball.set_position({3, 0.7f});
        heard.run(world, 30);
        REQUIRE(ball.is_touching());
        shape.set_contact_events(true);
        heard.run(world, 5);
        ball.set_position({3, 9});
        heard.run(world, 2);
        REQUIRE(heard.begins == begins);
        REQUIRE(heard.ends == begins);
        REQUIRE_FALSE(world.validate());
    }
}

TEST_CASE("sensors report only shapes that agree") {
    World world({.gravity = {0, 0}});
    Body zone = world.create_body({.type = BodyType::static_body});
    Shape sensor = zone.add(Box{.width = 4, .height = 4}, {.sensor = true});
    Body told = add_ball(world, {0, 0});
    world.create_body({.position = {1, 1}}).add(Circle{}, {.sensor_events = false});
    Heard heard;
    heard.run(world, 3);
    REQUIRE(heard.sensor_begins == 1);
    told.set_position({50, 0});
    heard.run(world, 3);
    REQUIRE(heard.sensor_ends == 1);
    sensor.set_sensor_events(false);
    told.set_position({-60, 0});
    told.set_velocity({7000, 0});  // through the sensor within a step
    heard.run(world, 3);
    REQUIRE(told.position().x > 5);
    REQUIRE(heard.sensor_begins == 1);
}

TEST_CASE("before-solve is called only for shapes that both allow it") {
    World world;
    Body floor = add_floor(world);
    Body asked = add_box(world, {0, 0.5f}), silent = add_box(world, {5, 0.5f});
    silent.shapes()[0].set_before_solve(false);
    int calls = 0;
    world.set_before_solve([&](ContactEdit& contact) {
        ++calls;
        REQUIRE(contact.shape_a.body() != silent);
        REQUIRE(contact.shape_b.body() != silent);
    });
    run(world, 0.2f);
    REQUIRE(calls > 5);
    floor.shapes()[0].set_before_solve(false);
    calls = 0;
    run(world, 0.2f);
    REQUIRE(calls == 0);
    REQUIRE(asked.is_touching());
}

TEST_CASE("a material is a number of the host that a restored world has too") {
    World world;
    Body body = world.create_body();
    Shape ice = body.add(Circle{}, {.material = 65535}), wood = body.add(Box{});
    wood.set_material(12);
    World restored;
    restored.restore(saved(world));
    REQUIRE(restored.shape(ice.id()).material() == 65535);
    REQUIRE(restored.shape(wood.id()).material() == 12);
}

TEST_CASE("the id of a contact is the same in all events and finds the contact") {
    World world({.persist_events = true});
    add_floor(world);
    Body box = add_box(world, {0, 0.6f}), other = add_box(world, {5, 0.6f});
    std::unordered_set<ContactId> began;
    for (int i = 0; i < 30; ++i) {
        world.step(frame);
        for (const auto& event : world.events().contact_begin) began.insert(event.id());
        for (const auto& event : world.events().contact_persist)
            REQUIRE(began.contains(event.id()));
    }
    REQUIRE(began.size() == 2);
    for (const ContactId& id : began) {
        REQUIRE(world.is_touching(id));
        const std::vector<Contact> contacts = world.contacts_of(id);
        REQUIRE(contacts.size() == 1);
        REQUIRE(contacts[0].id() == id);
        REQUIRE(contacts[0].point_count == 2);
    }
    REQUIRE_FALSE(world.is_touching(ContactId::of(box.shapes()[0].id(), other.shapes()[0].id())));
    box.set_position({0, 20});
    world.step(frame);
    const ContactId ended = world.events().contact_end.at(0).id();
    REQUIRE(began.contains(ended));
    REQUIRE_FALSE(world.is_touching(ended));
    box.destroy();
    REQUIRE_FALSE(world.is_touching(ended));
    REQUIRE(world.contacts_of(ended).empty());
    REQUIRE_FALSE(world.is_touching({}));
}

TEST_CASE("an ignored pair has no contact until it has separated") {
    for (const bool by_callback : {false, true}) {
        World world;
        Body ground = add_ground(world);
        Body ball = add_ball(world, {0.5f, 0.7f});
        run(world, 0.3f);
        REQUIRE(ball.is_touching());
        const Shape of_ground = ground.shapes()[0], of_ball = ball.shapes()[0];
        int calls = 0;
        if (by_callback)
            world.set_before_solve([&](ContactEdit& contact) {
                contact.ignored = true;
                ++calls;
            });
        else
            world.ignore_until_separated(of_ball, of_ground);
        world.step(frame);
        REQUIRE_FALSE(ball.is_touching());
        World restored;
        restored.restore(saved(world));
        world.set_before_solve({});
        for (World* each : {&world, &restored}) {
            run(*each, 0.1f);
            REQUIRE_FALSE(each->body(ball.id()).is_touching());
            run(*each, 0.5f);
            REQUIRE(each->body(ball.id()).position().y < -1);
        }
        REQUIRE(world.hash() == restored.hash());
        REQUIRE(calls == (by_callback ? 1 : 0));
        ball.set_position({0.5f, 1.5f});
        ball.set_velocity({0, 0});
        run(world, 1.0f);
        REQUIRE(ball.is_touching());
        REQUIRE(ball.position().y > 0.3f);
        REQUIRE_FALSE(world.validate());
    }
}

TEST_CASE("ignoring shapes that are apart or gone has no effect") {
    World world;
    Body floor = add_floor(world);
    Body ball = add_ball(world, {0, 3});
    world.ignore_until_separated(ball.shapes()[0], floor.shapes()[0]);
    run(world, 1.5f);
    REQUIRE(ball.position().y == Approx(0.5).margin(0.02));
    REQUIRE_THROWS_WITH(world.ignore_until_separated(ball.shapes()[0], ball.shapes()[0]),
                        contains("two shapes"));
    REQUIRE_THROWS(world.ignore_until_separated(ball.shapes()[0], Shape()));
    world.ignore_until_separated(ball.shapes()[0], floor.shapes()[0]);
    ball.destroy();
    Body next = add_ball(world, {0, 0.5f});
    run(world, 0.5f);
    REQUIRE(next.is_touching());
    REQUIRE_FALSE(world.validate());
}

}  // namespace event_switches_test
