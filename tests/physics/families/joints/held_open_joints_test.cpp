// Limbs between the two bodies of a joint, which contacts then hold open. FETTLE_SEEDS=n: n worlds
// of each family.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

#include "catch.h"
#include "family.h"

namespace held_open_joints_test {

using namespace fettle::physics;
using families::Random;
using families::seeds_or;

namespace {

float widest_gap(const World& world) {
    float widest = 0.0f;
    for (const Joint& joint : world.joints())
        widest = std::max(widest, std::abs(joint.separation()));
    return widest;
}

float greatest_speed(const World& world) {
    float fastest = 0.0f;
    for (const Body& body : world.bodies()) fastest = std::max(fastest, body.velocity().length());
    return fastest;
}

/// Dolls of ten limbs that fall on each other in a pit.
struct Pile {
    World world;
    float dt;

    explicit Pile(unsigned seed) {
        Random random{std::mt19937(seed)};
        dt = seed % 4 == 3 ? 1.0f / 30 : 1.0f / 60;
        Body pit = world.create_body({.type = BodyType::static_body});
        pit.add(Box{.width = 20, .height = 2, .center = {0, -1}});
        const float half = random(1.2f, 4);
        for (const float side : {-1.0f, 1.0f})
            pit.add(Box{.width = 1, .height = 40, .center = {side * (half + 0.5f), 20}});
        const int dolls = int(random(5, 9));
        for (int i = 0; i < dolls; ++i) add_doll(random, 2 + 3 * float(i), -1 - i);
    }

  private:
    struct Doll {
        World& world;
        float size;
        Vec2 position, velocity;
        int group;

        Body limb(Vec2 at, float width, float length) {
            Body body = world.create_body({.position = position + size * at, .velocity = velocity});
            const Vec2 end = {0, size * (length - width) / 2};
            body.add(Segment{.from = -end, .to = end, .rounding = size * width / 2},
                     {.density = 5, .friction = 0.5f, .group = group});
            return body;
        }
        void hinge(Body a, Body b, Vec2 at, float lower, float upper) {
            const Vec2 place = position + size * at;
            world.create_revolute_joint({.body_a = a.id(),
                                         .body_b = b.id(),
                                         .anchor_a = a.local_point(place),
                                         .anchor_b = b.local_point(place),
                                         .lower_angle = lower,
                                         .upper_angle = upper,
                                         .max_motor_torque = 0.3f});
        }
    };

    void add_doll(Random& random, float height, int group) {
        const float size = random(0.7f, 1.2f), aside = random(-0.7f, 0.7f);
        Doll doll = {world, size, {aside, height}, {random(-3, 3), random(-20, -4)}, group};
        Body torso = doll.limb({0, 0}, 0.3f, 0.7f), head = doll.limb({0, 0.55f}, 0.24f, 0.28f);
        doll.hinge(torso, head, {0, 0.4f}, -0.5f, 0.5f);
        for (int side = 0; side < 2; ++side) {
            Body upper_arm = doll.limb({0, 0.08f}, 0.14f, 0.42f);
            Body forearm = doll.limb({0, -0.3f}, 0.12f, 0.4f);
            Body thigh = doll.limb({0, -0.6f}, 0.18f, 0.5f);
            Body shin = doll.limb({0, -1.05f}, 0.15f, 0.5f);
            doll.hinge(torso, upper_arm, {0, 0.27f}, -1.5f, 2.5f);
            doll.hinge(upper_arm, forearm, {0, -0.1f}, 0, 2.2f);
            doll.hinge(torso, thigh, {0, -0.38f}, -0.6f, 1.6f);
            doll.hinge(thigh, shin, {0, -0.82f}, -2.2f, 0);
        }
    }
};

/// Two limbs with a joint between their ends, which are apart by 60 to 120 % of the width of a
/// third limb between them, or of two side by side.
struct Knee {
    World world{{.gravity = {0, 0}}};
    Joint joint;
    std::vector<Body> between;

    explicit Knee(unsigned seed) {
        Random random{std::mt19937(seed)};
        const float width = random(0.1f, 0.4f), length = width * random(2, 5);
        const bool welded = seed % 3 == 2;
        std::vector<Body> limbs;
        for (const float side : {-1.0f, 1.0f}) {
            Body body =
                world.create_body({.position = {side * (0.5f * length + random(0.3f, 0.6f) * width),
                                                random(-0.1f, 0.1f) * width}});
            body.add(Box{.width = length, .height = width}, {.density = random(0.5f, 2)});
            limbs.push_back(body);
        }
        const JointDef def = {.body_a = limbs[0].id(),
                              .body_b = limbs[1].id(),
                              .anchor_a = {0.5f * length, 0},
                              .anchor_b = {-0.5f * length, 0}};
        if (welded)
            joint = world.create_weld_joint(def);
        else
            joint = world.create_revolute_joint(def);
        const int count = seed % 2 == 0 ? 1 : 2;
        for (int i = 0; i < count; ++i) {
            Body body = world.create_body({.angle = random(-0.3f, 0.3f)});
            const float half = random(0.5f, 1.5f) * width, radius = 0.5f * width / float(count);
            body.set_position({count == 1 ? 0.0f : (float(i) - 0.5f) * width, 0});
            if (random(0, 1) < 0.5f)
                body.add(Segment{{0, -half}, {0, half}, radius}, {.density = random(0.5f, 2)});
            else
                body.add(Box{.width = 2 * radius, .height = 2 * half},
                         {.density = random(0.5f, 2)});
            between.push_back(body);
        }
    }
};

}  // namespace

TEST_CASE("piles of ragdolls come to rest, and their joints close") {
    unsigned restless = 0, open = 0;
    const unsigned seeds = seeds_or(80);
    for (unsigned seed = 0; seed < seeds; ++seed) {
        Pile pile(seed);
        for (float time = 0; time < 30; time += pile.dt) pile.world.step(pile.dt);
        float fastest = 0.0f;
        for (float time = 0; time < 5; time += pile.dt) {
            pile.world.step(pile.dt);
            fastest = std::max(fastest, greatest_speed(pile.world));
        }
        restless += fastest > 0.1f;
        open += widest_gap(pile.world) > 0.05f;
    }
    std::printf("piles of ragdolls: %u of %u move after 30 s, %u have a joint that is open\n",
                restless, seeds, open);
    CHECK(restless * 100 <= seeds);
    CHECK(open * 50 <= seeds);
}

TEST_CASE("a joint closes although a limb is between its bodies") {
    unsigned open = 0;
    const unsigned seeds = seeds_or(200);
    for (unsigned seed = 0; seed < seeds; ++seed) {
        Knee knee(seed);
        for (int step = 0; step < 300; ++step) knee.world.step(1.0f / 60);
        open += knee.joint.separation() > 0.01f;
    }
    std::printf("limbs in a joint: %u of %u joints stay open\n", open, seeds);
    CHECK(open * 50 <= seeds);
}

/// A ball lies on the joint between two planks of a rope bridge, or on that of a steep hammock.
TEST_CASE("a load does not fall through the joint on which it lies") {
    unsigned lost = 0;
    const unsigned seeds = seeds_or(100);
    for (unsigned seed = 0; seed < seeds; ++seed) {
        Random random{std::mt19937(seed)};
        World world;
        const int planks = 2 * int(random(1, 6));
        const float length = random(0.4f, 1), height = random(0.05f, 0.2f);
        const float slope = random(0.1f, 1.2f), density = random(0.5f, 2);
        Body before;
        Position end = {-0.5f * float(planks) * length * std::cos(slope), 0};
        for (int i = 0; i < planks; ++i) {
            const float angle = i < planks / 2 ? -slope : slope;
            const Vec2 along = 0.5f * length * families::turned(angle);
            Body plank = world.create_body({.position = end + along, .angle = angle});
            plank.add(Box{.width = length, .height = height}, {.density = density, .group = -1});
            RevoluteJointDef def{.body_b = plank.id(), .anchor_b = {-0.5f * length, 0}};
            def.anchor_a = before ? Position(Vec2{0.5f * length, 0}) : end;
            if (before) def.body_a = before.id();
            world.create_revolute_joint(def);
            before = plank;
            end = end + 2 * along;
        }
        world.create_revolute_joint(
            {.body_a = before.id(), .anchor_a = {0.5f * length, 0}, .anchor_b = end});
        const float radius = length * random(0.15f, 0.6f);
        const float lowest = -0.5f * float(planks) * length * std::sin(slope);
        Body ball = world.create_body(
            {.position = {0, lowest + (0.5f * height + radius) / std::cos(slope) + 0.01f}});
        const float mass = density * length * height * std::pow(300.0f, random(0, 1));
        ball.add(Circle{radius}, {.density = mass / (3.1416f * radius * radius)});
        for (int step = 0; step < 600; ++step) world.step(1.0f / 60);
        lost += ball.position().y < lowest - float(planks) * length;
    }
    std::printf("loads on joints: %u of %u fell through\n", lost, seeds);
    CHECK(lost * 200 <= seeds);
}

TEST_CASE("a pile of ragdolls has the same future on several threads and when restored") {
    for (unsigned seed = 0; seed < 8; ++seed) {
        Pile one(seed), two(seed);
        two.world.set_threads(2);
        for (int i = 0; i < 240; ++i) {
            if (i % 40 == 20) {
                std::vector<std::byte> bytes;
                two.world.save(bytes);
                for (int k = 0; k < 5; ++k) two.world.step(two.dt);
                two.world.restore(bytes);
            }
            one.world.step(one.dt);
            two.world.step(two.dt);
        }
        CHECK(one.world.hash() == two.world.hash());
    }
}

}  // namespace held_open_joints_test
