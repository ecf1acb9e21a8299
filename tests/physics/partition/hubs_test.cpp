// Hubs, on which many lighter bodies lie: their copies, and that a hub moves like one body.

#include <partition/hubs.h>

#include <algorithm>
#include <random>
#include <vector>

#include "catch.h"
#include "scenes.h"
#include "world_inside.h"

namespace hubs_test {

using namespace scenes;
using namespace fettle::physics::detail;

namespace {

bool has_hub(World& world) {
    return !WorldInside::of(world).hubs.empty();
}

/// Two solver bodies besides the one that does not move: a hub, and one that is much lighter.
std::vector<SolverBody> hub_and_light() {
    std::vector<SolverBody> bodies(3);
    bodies[1] = {{3, 1}, 0.5f, 0.001f, {0.1f, 0.2f}, 0.3f, 0.0002f};
    bodies[2] = {{0, 0}, 0.0f, 1.0f, {}, 0.0f, 6.0f};
    return bodies;
}

/// A raft of 50 m and 5 t, with `count` boxes of half a meter in rows on it.
struct Raft {
    Body raft;
    std::vector<Body> boxes;

    Raft(World& world, int count, const Vec2& at) {
        raft = world.create_body({.position = at});
        raft.add(Box{.width = 50, .height = 1}, {.density = 100});
        for (int i = 0; i < count; ++i) {
            const float x = 0.6f * float(i % 64) - 18.9f, y = 0.75f + 0.5f * float(i / 64);
            boxes.push_back(world.create_body({.position = at + Vec2(x, y)}));
            boxes.back().add(Box{.width = 0.5f, .height = 0.5f});
        }
    }
};

struct Momentum {
    Vec2 linear = {0, 0};
    float angular = 0.0f;  ///< about the origin

    void add(const Body& body) {
        const Vec2 p = body.mass() * body.velocity(), c = Vec2(body.world_center());
        linear += p;
        angular += c.x * p.y - c.y * p.x + body.inertia() * body.angular_velocity();
    }
};

}  // namespace

TEST_CASE("impulses on the copies of a hub act on the hub in full") {
    for (const uint32_t strips : {1u, 2u, 8u}) {
        auto bodies = hub_and_light();
        const SolverBody before = bodies[1];
        Hubs hubs;
        hubs.begin(strips);
        hubs.add(1, 0.001f, bodies);
        std::vector<ActingContact> contacts(100);
        Vec2 impulse;
        float torque = 0.0f;
        std::mt19937 random(3);
        std::uniform_real_distribution<float> push(-1.0f, 1.0f);
        for (size_t i = 0; i < contacts.size(); ++i) {
            ActingContact& c = contacts[i];
            const auto strip = StripNode(strips + i % strips);
            c.end_a = i % 2 ? SolverEnd::of_hub(1) : SolverEnd(2, strip, true);
            c.end_b = i % 2 ? SolverEnd(2, strip, true) : SolverEnd::of_hub(1);
            c.node = node_of(c.end_a, c.end_b);
            hubs.choose_node(c, bodies);
            REQUIRE(c.hub == 1);
            REQUIRE(c.node == strip);
            hubs.choose_copy(c);
            const uint32_t copy = i % 2 ? c.a() : c.b();
            REQUIRE(copy > 2);
            REQUIRE(copy < bodies.size());
        }
        for (int pass = 0; pass < 3; ++pass) {
            hubs.write_copies({strips, 2 * strips}, bodies);
            for (size_t i = 0; i < contacts.size(); ++i) {
                const ActingContact& c = contacts[i];
                SolverBody& copy = bodies[i % 2 ? c.a() : c.b()];
                REQUIRE(copy.shift.x == before.shift.x);
                REQUIRE(copy.turn == before.turn);
                const Vec2 given = {push(random), push(random)};
                const float turned = push(random);
                copy.velocity = copy.velocity + copy.inverse_mass * given;
                copy.angular_velocity += copy.inverse_inertia * turned;
                impulse = impulse + given;
                torque += turned;
            }
            hubs.average_copies(bodies);
            const SolverBody& hub = bodies[1];
            CHECK(hub.velocity.x == Approx(before.velocity.x + before.inverse_mass * impulse.x));
            CHECK(hub.velocity.y == Approx(before.velocity.y + before.inverse_mass * impulse.y));
            CHECK(hub.angular_velocity ==
                  Approx(before.angular_velocity + before.inverse_inertia * torque));
        }
        // Without any impulse the hub stays the same to the last bit.
        const SolverBody still = bodies[1];
        hubs.write_copies({strips, 2 * strips}, bodies);
        hubs.average_copies(bodies);
        CHECK(bodies[1].velocity.x == still.velocity.x);
        CHECK(bodies[1].angular_velocity == still.angular_velocity);
    }
}

TEST_CASE("the contact of a body that is not much lighter acts on the hub itself") {
    auto bodies = hub_and_light();
    Hubs hubs;
    hubs.begin(4);
    hubs.add(1, 0.001f, bodies);
    bodies[2].inverse_mass = 0.01f;
    ActingContact c;
    c.end_a = SolverEnd::of_hub(1);
    c.end_b = SolverEnd(2, 5, true);
    c.node = node_of(c.end_a, c.end_b);
    hubs.choose_node(c, bodies);
    REQUIRE(c.hub == 0);
    REQUIRE(c.node == 1);
    // The same for a contact that is solved serially, or whose other body does not move.
    bodies[2].inverse_mass = 1.0f;
    c.serially = true;
    hubs.choose_node(c, bodies);
    REQUIRE(c.hub == 0);
    c.serially = false;
    c.end_b = SolverEnd(0, 0, false);
    c.node = node_of(c.end_a, c.end_b);
    hubs.choose_node(c, bodies);
    REQUIRE(c.hub == 0);
    REQUIRE(c.node == 1);
}

TEST_CASE("a raft hit by many bodies conserves momentum") {
    World world({.gravity = {0, 0}, .sleeping = false});
    Raft raft(world, 64 * 3, {5, 3});
    std::mt19937 random(11);
    std::uniform_real_distribution<float> side(-3.0f, 3.0f), down(-9.0f, -1.0f);
    for (Body& box : raft.boxes) box.set_velocity({side(random), down(random)});
    Momentum before;
    before.add(raft.raft);
    for (const Body& box : raft.boxes) before.add(box);
    int steps_with_hub = 0;
    for (int i = 0; i < 240; ++i) {
        world.step(frame);
        steps_with_hub += has_hub(world);
    }
    REQUIRE(steps_with_hub > 20);
    Momentum after;
    after.add(raft.raft);
    for (const Body& box : raft.boxes) after.add(box);
    const float scale = before.linear.length();
    CHECK((after.linear - before.linear).length() < 1e-3f * scale);
    CHECK(std::fabs(after.angular - before.angular) < 1e-2f * scale * 20.0f);
    CHECK(raft.raft.velocity().y < -0.03f);
}

TEST_CASE("light boxes and a heavy one rest on a raft as they do on the ground") {
    World world({.sleeping = false});
    add_floor(world);
    Raft raft(world, 64 * 5, {0, 0.5f});
    Body heavy = world.create_body({.position = {22.5f, 2}});
    heavy.add(Box{.width = 2, .height = 2}, {.density = 500});
    run(world, 4.0f);
    REQUIRE(has_hub(world));
    CHECK(raft.raft.velocity().length() < 1e-3f);
    CHECK(raft.raft.position().y == Approx(0.5f).margin(0.01));
    CHECK(heavy.velocity().length() < 1e-3f);
    CHECK(heavy.position().y == Approx(2.0f).margin(0.01));
    for (size_t i = 0; i < raft.boxes.size(); ++i) {
        const Position at = raft.boxes[i].position();
        INFO(i << ": " << at.x << " " << at.y);
        CHECK(raft.boxes[i].velocity().length() < 5e-3f);
        CHECK(at.y == Approx(1.25f + 0.5f * float(i / 64)).margin(0.03));
    }
    REQUIRE_FALSE(world.validate());
}

TEST_CASE("a raft on a spring sinks by the weight of the bodies on it") {
    // The raft rests on a spring, so the impulses of its copies in all sub-steps have to add up.
    World world({.sleeping = false});
    Raft raft(world, 64 * 2, {0, 0});
    Body ground = world.create_body({.type = BodyType::static_body});
    PrismaticJoint rail =
        world.create_prismatic_joint({.body_a = ground.id(), .body_b = raft.raft.id()});
    rail.set_axis({0, 1});
    rail.set_hertz(1.5f);
    rail.set_damping_ratio(1.0f);
    run(world, 6.0f);
    REQUIRE(has_hub(world));
    float mass = raft.raft.mass();
    for (const Body& box : raft.boxes) mass += box.mass();
    const float stiffness = raft.raft.mass() * std::pow(6.2831853f * 1.5f, 2.0f);
    CHECK(raft.raft.velocity().length() < 2e-3f);
    CHECK(raft.raft.position().y == Approx(-10.0f * mass / stiffness).epsilon(0.01));
}

}  // namespace hubs_test
