#include <fettle/physics/host_access.h>
#include <algorithm>
#include <map>
#include <utility>

#include "catch.h"
#include "scenes.h"

namespace callback_test {

using namespace scenes;

namespace {

/// A platform that bodies may jump up through.
struct OneWay {
    World world{{.sleeping = false}};
    Body platform = world.create_body({.type = BodyType::static_body, .position = {0, 2}});
    Shape top = platform.add(Box{.width = 10, .height = 0.2f});
    int calls = 0;

    OneWay() {
        add_floor(world);
        world.set_before_solve([this](ContactEdit& contact) {
            ++calls;
            if (contact.shape_a != top && contact.shape_b != top) return;
            const float up = contact.shape_a == top ? contact.normal.y : -contact.normal.y;
            const Shape other = contact.shape_a == top ? contact.shape_b : contact.shape_a;
            if (up < 0.5f || other.body().velocity().y > 0.01f) contact.enabled = false;
        });
    }
};

}  // namespace

TEST_CASE("a body jumps up through a one way platform and lands on it") {
    OneWay scene;
    Body ball = add_ball(scene.world, {0, 0.5f}, 0.3f);
    ball.set_velocity({0, 9});
    bool touched_below = false;
    float highest = 0.0f;
    for (int i = 0; i < 240; ++i) {
        scene.world.step(frame);
        highest = std::max<float>(highest, ball.position().y);
        touched_below |= highest < 2.3f && ball.is_touching() && i > 10;
        REQUIRE_FALSE(scene.world.validate());
    }
    REQUIRE_FALSE(touched_below);
    REQUIRE(highest > 3.0f);
    REQUIRE(ball.position().y == Approx(2.4f).margin(0.01));
    REQUIRE(scene.calls > 100);
    scene.world.set_before_solve({});
    Body other = add_ball(scene.world, {2, 0.5f}, 0.3f);
    other.set_velocity({0, 9});
    run(scene.world, 1.0f);
    REQUIRE(other.position().y < 1.8f);  // solid now
}

TEST_CASE("a fast body is not stopped at a contact that a callback disables") {
    OneWay scene;
    Body ball = add_ball(scene.world, {0, 0.6f}, 0.1f);
    ball.set_velocity({0, 60});
    run(scene.world, 0.1f);
    REQUIRE(ball.position().y > 4.0f);
}

TEST_CASE("a mixing function gets both shapes and the point and sets the friction of a contact") {
    World world({.sleeping = false});
    Body floor = add_floor(world);
    Body left = add_box(world, {-5, 0.5f}), right = add_box(world, {5, 0.5f});
    int wrong = 0;
    world.set_mixing([&](ContactEdit& contact) {
        wrong += contact.shape_a.body() != floor && contact.shape_b.body() != floor;
        wrong += std::fabs(contact.point.y) > 0.02f;
        wrong += std::fabs(contact.friction - 0.6f) > 1e-6f;  // what the rule has mixed
        contact.friction = contact.point.x < 0 ? 0.0f : 1.0f;
    });
    left.set_velocity({-4, 0});
    right.set_velocity({4, 0});
    run(world, 1.0f);
    REQUIRE(wrong == 0);
    REQUIRE(left.velocity().x == Approx(-4.0f).epsilon(1e-3));
    REQUIRE(std::fabs(right.velocity().x) < 1e-5f);
    world.set_mixing({});
    run(world, 1.0f);
    REQUIRE(std::fabs(left.velocity().x) < 1e-5f);
}

TEST_CASE("a change of a contact by a callback holds for one step") {
    World world({.sleeping = false});
    add_floor(world);
    Body box = add_box(world, {0, 0.5f});
    bool icy = true;
    world.set_before_solve([&](ContactEdit& contact) {
        if (icy) contact.friction = 0.0f;
    });
    box.set_velocity({3, 0});
    run(world, 0.5f);
    REQUIRE(box.velocity().x == Approx(3.0f).epsilon(1e-3));
    icy = false;
    run(world, 1.0f);
    REQUIRE(std::fabs(box.velocity().x) < 1e-5f);
}

TEST_CASE("a mixing function may make a contact bounce") {
    World world({.sleeping = false});
    add_floor(world);
    Body ball = add_ball(world, {0, 3});
    world.set_mixing([&](ContactEdit& contact) { contact.restitution = 0.5f; });
    float highest = 0.0f;
    for (int i = 0; i < 120; ++i) {
        world.step(frame);
        if (ball.velocity().y > 0) highest = std::max<float>(highest, ball.position().y);
    }
    REQUIRE(highest == Approx(0.5f + 2.5f * 0.25f).epsilon(0.08));
}

TEST_CASE("mixing rules compute what their names say and act on resting contacts") {
    for (const auto& [rule, expected] :
         {std::pair(MixRule::average, 0.5f), std::pair(MixRule::minimum, 0.1f),
          std::pair(MixRule::maximum, 0.9f), std::pair(MixRule::multiply, 0.09f),
          std::pair(MixRule::geometric, 0.3f)}) {
        World world;
        add_floor(world, 50, {.friction = 0.9f, .restitution = 0.9f});
        Body box = add_box(world, {0, 0.5f}, 1.0f, {.friction = 0.1f, .restitution = 0.1f});
        world.set_restitution_mix(MixRule::minimum);
        run(world, 4.0f);
        REQUIRE_FALSE(box.awake());
        world.set_friction_mix(rule);
        world.set_restitution_mix(rule);
        REQUIRE(box.awake());
        REQUIRE(world.friction_mix() == rule);
        world.step(frame);
        REQUIRE(box.contacts().size() == 1);
        REQUIRE(box.contacts()[0].friction == Approx(expected));
        REQUIRE(box.contacts()[0].restitution == Approx(expected));
    }
}

TEST_CASE("a filter function decides which shapes collide and a new one acts on existing pairs") {
    World world;
    add_floor(world);
    Body ghost = add_box(world, {0, 0.5f}), solid = add_box(world, {5, 0.5f});
    run(world, 3.0f);
    REQUIRE_FALSE(ghost.awake());
    world.set_filter(
        [&](const Shape& a, const Shape& b) { return a.body() != ghost && b.body() != ghost; });
    run(world, 1.0f);
    REQUIRE(ghost.position().y < -2.0f);
    REQUIRE(solid.position().y == Approx(0.5f).margin(0.01));
    REQUIRE_FALSE(world.validate());
    ghost.set_position({0, 3});
    ghost.set_velocity({0, 0});
    world.set_filter({});
    run(world, 2.0f);
    REQUIRE(ghost.position().y == Approx(0.5f).margin(0.01));
}

TEST_CASE("a filter is asked once about two shapes while they are near each other") {
    World world({.sleeping = false});
    add_floor(world);
    Body ball = world.create_body({.position = {0, 0.4f}});  // is pushed out
    ball.add(Circle{});
    Body pusher = world.create_body(
        {.type = BodyType::kinematic_body, .position = {8, 0.5f}, .velocity = {4, 0}});
    pusher.add(Box{});
    Body crate = add_box(world, {9, 0.5f});
    Body sensor = world.create_body({.type = BodyType::static_body, .position = {12, 0.5f}});
    sensor.add(Box{.width = 2}, {.sensor = true});
    std::map<std::pair<BodyId, BodyId>, int> calls;
    world.set_filter([&](const Shape& a, const Shape& b) {
        ++calls[std::minmax(a.body().id(), b.body().id())];
        return true;
    });
    for (int i = 0; i < 30; ++i) world.step(frame);
    REQUIRE(crate.position().x > 10.5f);
    REQUIRE(calls.size() == 4);  // two with the floor, pusher and crate, crate and sensor
    for (const auto& [pair, count] : calls) CHECK(count == 1);
}

TEST_CASE("a touch that lasts is reported in every step after its first") {
    World world({.sleeping = false, .persist_events = true});
    add_floor(world);
    add_box(world, {0, 0.5f});
    world.step(frame);
    REQUIRE(world.events().contact_begin.size() == 1);
    REQUIRE(world.events().contact_persist.empty());
    for (int i = 0; i < 60; ++i) {
        world.step(frame);
        REQUIRE(world.events().contact_persist.size() == 1);
    }
    const ContactPersistEvent& event = world.events().contact_persist[0];
    REQUIRE(event.impulse == Approx(10.0f * frame).epsilon(0.01));
    REQUIRE(std::fabs(event.point.y) < 0.01f);
    world.set_persist_events(false);
    world.step(frame);
    REQUIRE(world.events().contact_persist.empty());
}

TEST_CASE("callbacks that only count change no result and are not saved") {
    auto build = [](World& world) {
        add_floor(world);
        for (int i = 0; i < 30; ++i) add_box(world, {0.3f * float(i % 5), 1 + 1.1f * float(i)});
    };
    World plain, observed;
    build(plain);
    build(observed);
    int calls = 0;
    observed.set_before_solve([&](ContactEdit&) { ++calls; });
    observed.set_mixing([&](ContactEdit&) { ++calls; });
    observed.set_filter([&](const Shape&, const Shape&) { return ++calls > 0; });
    for (int i = 0; i < 300; ++i) {
        plain.step(frame);
        observed.step(frame);
        REQUIRE(plain.hash() == observed.hash());
    }
    REQUIRE(calls > 1000);
    std::vector<std::byte> bytes;
    observed.save(bytes);
    observed.restore(bytes);
    calls = 0;
    observed.step(frame);
    World copy = observed.clone();
    const int before = calls;
    copy.step(frame);
    REQUIRE(before > 0);
    REQUIRE(calls == before);
}

TEST_CASE("in a contact a body locked on one axis has its mass along the other axis only") {
    // A ball of 1 kg strikes the 45° slope of a body that can move only along x. Along the normal
    // n = (1, 1)/√2, the effective mass of the body is m_x / n_x² = 2 kg and that of the ball 1 kg.
    World world({.gravity = {0, 0}, .sleeping = false, .restitution_threshold = 0.0f});
    Body box = world.create_body({.locked_y = true, .locked_rotation = true});
    box.add(Polygon{.vertices = {{-2, -2}, {2, -2}, {-2, 2}}}, {.friction = 0, .restitution = 1});
    box.set_mass(1.0f);
    box.set_center(Vec2(0, 0));
    Body ball = add_ball(world, {1, 1}, 0.5f, {.friction = 0, .restitution = 1});
    ball.set_mass(1.0f);
    const float s = std::sqrt(0.5f);
    ball.set_velocity({-4 * s, -4 * s});
    run(world, 1.0f);
    // k = 1/1 + n_x²/1 = 1.5; impulse = 2 v / k.
    const float impulse = 2 * 4.0f / 1.5f;
    REQUIRE(box.velocity().x == Approx(-impulse * s).epsilon(0.01));
    REQUIRE(box.velocity().y == 0.0f);
    REQUIRE(ball.velocity().x == Approx((impulse - 4) * s).epsilon(0.01));
    // The energy is kept; it would not be if the mass along y counted too.
    const float energy =
        0.5f * ball.velocity().length_squared() + 0.5f * box.velocity().length_squared();
    REQUIRE(energy == Approx(8.0f).epsilon(0.01));
}

TEST_CASE("a force on a sleeping body wakes it and one on a static body is forgotten") {
    World world;
    add_floor(world);
    Body box = add_box(world, {0, 0.5f});
    run(world, 3.0f);
    REQUIRE_FALSE(box.awake());
    box.apply_force({60, 0});
    REQUIRE(box.awake());
    world.step(frame);
    REQUIRE(box.velocity().x > 0.5f);
    REQUIRE(box.applied_force().length() == 0.0f);
    box.set_type(BodyType::static_body);
    for (int i = 0; i < 100; ++i) box.apply_force({0, 1000});
    world.step(frame);
    box.set_type(BodyType::dynamic_body);
    world.step(frame);
    REQUIRE(box.velocity().y < 0.1f);
    // A force acts on a body that was made dynamic just before.
    box.set_type(BodyType::static_body);
    box.set_type(BodyType::dynamic_body);
    box.apply_force({0, 120});
    world.step(frame);
    REQUIRE(box.velocity().y > 1.0f);
}

namespace {

/// A comb: a flat top over three teeth. It has several convex pieces.
Concave comb() {
    return {{{-3, 0},
             {-3, -1},
             {-2, -1},
             {-2, -0.3f},
             {-0.5f, -0.3f},
             {-0.5f, -1},
             {0.5f, -1},
             {0.5f, -0.3f},
             {2, -0.3f},
             {2, -1},
             {3, -1},
             {3, 0}}};
}

}  // namespace

TEST_CASE("before_solve is called once for two shapes however many of their pieces touch") {
    World world({.sleeping = false});
    Body platform = world.create_body({.type = BodyType::static_body});
    Shape top = platform.add(comb());
    Body plank = world.create_body({.position = {0, 0.1f}});
    Shape wood = plank.add(Box{.width = 6, .height = 0.2f});
    Body ball = add_ball(world, {1.2f, 0.7f});
    bool open = false;
    int on_platform = 0, on_plank = 0;
    float impulse = 0.0f;
    world.set_before_solve([&](ContactEdit& contact) {
        if (contact.shape_a == top || contact.shape_b == top) {
            ++on_platform;
            impulse = contact.impulse;
            CHECK(contact.separation < 0.01f);
            contact.enabled = !open;
        } else {
            ++on_plank;
        }
    });
    size_t parts = 0;
    for (int i = 0; i < 120; ++i) {
        on_platform = on_plank = 0;
        world.step(frame);
        parts = std::max(parts, world.contacts().size());
        if (i < 10) continue;
        REQUIRE(on_platform == 1);
        REQUIRE(on_plank == 1);
    }
    REQUIRE(parts > 2);
    REQUIRE(impulse == Approx((plank.mass() + ball.mass()) * 10.0f * frame).epsilon(0.05));
    REQUIRE(wood.is_touching());
    // The answer applies to all pieces.
    open = true;
    world.step(frame);
    REQUIRE(world.events().contact_end.size() == 1);
    run(world, 0.5f);
    REQUIRE(plank.position().y < -0.5f);
    open = false;
    REQUIRE_FALSE(world.validate());
}

TEST_CASE("after a step with more sub-steps a callback gets the impulse of that whole step") {
    World world({.sleeping = false});
    add_floor(world);
    Body box = world.create_body({.position = {0, 0.5f}});
    box.add(Box{});
    float impulse = 0.0f;
    world.set_before_solve([&](ContactEdit& contact) { impulse = contact.impulse; });
    REQUIRE(world.last_substeps() == 0);
    run(world, 1.0f);
    REQUIRE(world.last_substeps() == world.substeps());
    const float length = 8 * frame;
    world.step(length);
    REQUIRE(world.last_substeps() == 4 * world.substeps());
    world.step(length);
    REQUIRE(impulse == Approx(box.mass() * 10.0f * length).epsilon(0.1));
}

TEST_CASE("mixing is called for every piece and values that before_solve does not set stay mixed") {
    World world({.sleeping = false});
    Body ground = world.create_body({.type = BodyType::static_body});
    ground.add(Chain{{{-20, 0}, {0, 0}, {20, 0}}});
    Body plank = world.create_body({.position = {0, 0.1f}});
    plank.add(Box{.width = 4, .height = 0.2f});
    int mixed = 0, solved = 0;
    world.set_mixing([&](ContactEdit& contact) {
        ++mixed;
        contact.friction = contact.point.x < 0 ? 0.0f : 0.8f;
    });
    float all = -1.0f;
    world.set_before_solve([&](ContactEdit& contact) {
        ++solved;
        if (all >= 0) contact.friction = all;
    });
    run(world, 0.5f);
    mixed = solved = 0;
    world.step(frame);
    REQUIRE(mixed == 2);
    REQUIRE(solved == 1);
    const auto frictions = [&] {
        std::vector<float> values;
        for (const Contact& contact : plank.contacts()) values.push_back(contact.friction);
        std::sort(values.begin(), values.end());
        return values;
    };
    REQUIRE(frictions() == std::vector<float>{0.0f, 0.8f});
    all = 0.3f;
    world.step(frame);
    REQUIRE(frictions() == std::vector<float>{0.3f, 0.3f});
}

TEST_CASE("two shapes of several pieces have one touch whatever the order of the pieces") {
    World world({.sleeping = false});
    Body lower = world.create_body({.type = BodyType::static_body});
    // Later `a` gets more pieces than it had when `b` was made, so the pieces of both are mixed.
    Shape a = lower.add(Concave{{{-1, 0}, {-1, -1}, {0, -0.5f}, {1, -1}, {1, 0}}});
    Body upper = world.create_body({.position = {0, 1.2f}});
    Shape b = upper.add(comb());
    world.step(frame);
    a.set_vertices(comb().vertices);
    int calls = 0;
    world.set_before_solve([&](ContactEdit& contact) {
        ++calls;
        const bool up = contact.shape_a == a;
        REQUIRE((up ? contact.shape_b : contact.shape_a) == b);
        REQUIRE((up ? contact.normal.y : -contact.normal.y) > 0.9f);
    });
    size_t begun = 0, ended = 0, parts = 0;
    for (int i = 0; i < 60; ++i) {
        calls = 0;
        world.step(frame);
        parts = std::max(parts, world.contacts().size());
        begun += world.events().contact_begin.size();
        ended += world.events().contact_end.size();
        REQUIRE(calls <= 1);
    }
    REQUIRE(calls == 1);
    REQUIRE(parts > 2);
    REQUIRE(begun == 1);
    REQUIRE(ended == 0);
}

TEST_CASE("an edit of a filter changes nothing if a refresh callback throws") {
    World world;
    add_floor(world);
    Body ball = add_ball(world, {0, 0.5f});
    Shape shape = ball.shapes()[0];
    run(world, 0.5f);
    REQUIRE(ball.is_touching());
    world.set_filter([](const Shape&, const Shape&) { return true; });
    bool throwing = true;
    HostAccess::on_refresh(world, [&](const Refresh&) {
        if (throwing) throw std::runtime_error("not now");
    });
    shape.set_density(2);  // values are out of date: reading them calls the callback first
    const auto mask = shape.mask();
    REQUIRE_THROWS_WITH(shape.set_category(8), contains("not now"));
    REQUIRE_THROWS_WITH(shape.set_mask(0), contains("not now"));
    REQUIRE_THROWS_WITH(shape.set_group(-1), contains("not now"));
    REQUIRE_THROWS_WITH(world.set_filter([](const Shape&, const Shape&) { return false; }),
                        contains("not now"));
    REQUIRE(shape.category() == 1);
    REQUIRE(shape.mask() == mask);
    REQUIRE(shape.group() == 0);
    throwing = false;
    run(world, 0.1f);
    REQUIRE(ball.is_touching());
    shape.set_mask(0);
    world.step(frame);
    REQUIRE_FALSE(ball.is_touching());
}

}  // namespace callback_test
