// Joints with limits, motors and loads: ragdolls come to rest, motors stop at limits, what moves
// slowly on its own stays awake, and nothing elsewhere in the world changes how a net hangs.
// FETTLE_SEEDS=n: n worlds of each family.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <vector>

#include "catch.h"
#include "family.h"

namespace joint_family_test {

using namespace fettle::physics;
using families::Random;
using families::seeds_or;

namespace {

struct Bone {
    Body body;
    float half, angle;
};

/// A tree of bones of different sizes, with limits and friction in every joint.
void add_ragdoll(World& world, Vec2 at, Random& random, int group, std::vector<Body>& bodies) {
    std::vector<Bone> bones;
    const int count = int(random(6, 16));
    for (int i = 0; i < count; ++i) {
        const float half = random(0.08f, 0.25f);
        float angle = random(-3.14f, 3.14f), end = 0.0f;
        Position place = at;
        const Bone* const parent = i == 0 ? nullptr : &bones[size_t(std::max(0, i - 5))];
        if (parent != nullptr) {
            end = parent == &bones[0] && random(0, 1) < 0.5f ? -1.0f : 1.0f;
            angle = parent->angle + random(-1.2f, 1.2f) + (end < 0.0f ? 3.14159f : 0.0f);
            const auto along = [](float turn) { return Vec2(std::cos(turn), std::sin(turn)); };
            place = parent->body.position() + end * parent->half * along(parent->angle) +
                    half * along(angle);
        }
        Body body = world.create_body({.position = place, .angle = angle});
        body.add(Segment{{-half, 0}, {half, 0}, random(0.04f, 0.1f)},
                 {.friction = 0.4f, .group = -group});
        if (parent != nullptr) {
            RevoluteJoint joint = world.create_revolute_joint({.body_a = parent->body.id(),
                                                               .body_b = body.id(),
                                                               .anchor_a = {end * parent->half, 0},
                                                               .anchor_b = {-half, 0}});
            joint.set_lower_angle(-0.5f);
            joint.set_upper_angle(0.5f);
            joint.set_max_motor_torque(random(0.1f, 5));
        }
        bones.push_back({body, half, angle});
        bodies.push_back(body);
    }
}

/// Time until all bodies sleep, s; `limit` if they never do.
float time_to_rest(int ragdolls, unsigned seed, float limit) {
    Random random{std::mt19937(seed)};
    World world;
    Body ground = world.create_body({.type = BodyType::static_body});
    if (seed % 2 == 0) {
        ground.add(Box{.width = 60, .height = 2, .center = {0, -1}});
    } else {
        Chain chain;
        for (int i = -30; i <= 30; ++i) chain.points.emplace_back(float(i), random(-0.1f, 0.1f));
        ground.add(chain);
    }
    std::vector<Body> bodies;
    for (int i = 0; i < ragdolls; ++i)
        add_ragdoll(world, {3.0f * float(i % 5) - 6, 1 + random(0, 3) + 4.0f * float(i / 5)},
                    random, i + 1, bodies);
    for (float time = 0.0f; time < limit; time += 1.0f / 60) {
        world.step(1.0f / 60);
        if (std::ranges::none_of(bodies, &Body::awake)) return time;
    }
    return limit;
}

}  // namespace

TEST_CASE("ragdolls with limits and friction come to rest") {
    std::vector<float> times;
    unsigned never = 0;
    const unsigned seeds = seeds_or(50);
    for (unsigned seed = 0; seed < seeds; ++seed) {
        times.push_back(time_to_rest(1, seed, 12));
        never += times.back() >= 12;
    }
    std::ranges::sort(times);
    std::printf("ragdolls: half rest after %.2f s, nine of ten after %.2f s, %u of %u never\n",
                double(times[times.size() / 2]), double(times[times.size() * 9 / 10]), never,
                seeds);
    CHECK(times[times.size() / 2] < 3);
    CHECK(times[times.size() * 9 / 10] < 6);
    CHECK(never <= 1 + seeds / 40);
}

TEST_CASE("a motor stops at the limit of its own joint") {
    for (unsigned seed = 0; seed < seeds_or(50); ++seed) {
        Random random{std::mt19937(seed)};
        const Solver solver = seed % 3 == 0 ? Solver::direct : Solver::soft_step;
        World world({.gravity = {0, random(-10, 0)}, .solver = solver});
        const float limit = random(0.2f, 1), speed = random(0.1f, 5);
        const float strength = std::pow(10.0f, random(2, 6));
        Body body = world.create_body({});
        body.add(Box{.width = random(0.2f, 2)});
        float end = 0.0f;
        if (seed % 2 == 0) {
            auto joint = world.create_prismatic_joint({.body_b = body.id()});
            joint.set_axis({1, 0});
            joint.set_upper_translation(limit);
            joint.set_motor_speed(speed);
            joint.set_max_motor_force(strength);
            for (int i = 0; i < 900; ++i) world.step(1.0f / 60);
            end = joint.translation();
        } else {
            auto joint = world.create_revolute_joint({.body_b = body.id()});
            joint.set_lower_angle(-limit);
            joint.set_motor_speed(-speed);
            joint.set_max_motor_torque(strength);
            for (int i = 0; i < 900; ++i) world.step(1.0f / 60);
            end = -joint.angle();
        }
        INFO("seed " << seed << ", strength " << strength);
        CHECK(end == Approx(limit).margin(0.005));
    }
}

TEST_CASE("a body that moves slowly on its own stays awake") {
    for (unsigned seed = 0; seed < seeds_or(20); ++seed) {
        Random random{std::mt19937(seed)};
        const float speed = random(0.002f, 0.04f);
        World world;
        Body lift = world.create_body({.type = BodyType::kinematic_body, .velocity = {0, speed}});
        lift.add(Box{});
        Body passenger = world.create_body({.position = {0, 1}});
        passenger.add(Box{});
        Body dial = world.create_body({.position = {5, 0}});
        dial.add(Box{.width = 2, .height = 0.2f});
        auto motor = world.create_revolute_joint({.body_b = dial.id(), .anchor_a = {5, 0}});
        motor.set_motor_speed(speed);
        motor.set_max_motor_torque(1000);
        Body belt = world.create_body({.type = BodyType::static_body, .position = {20, 0}});
        belt.add(Box{.width = 10}, {.surface_speed = -speed});
        Body parcel = world.create_body({.position = {20, 1}});
        parcel.add(Box{});
        for (int i = 0; i < 600; ++i) world.step(1.0f / 60);
        INFO("seed " << seed << ", speed " << speed);
        CHECK(lift.position().y == Approx(10 * speed).epsilon(0.02));
        CHECK(passenger.position().y == Approx(1 + 10 * speed).margin(0.01));
        CHECK(dial.angle() == Approx(10 * speed).epsilon(0.02));
        CHECK(parcel.position().x == Approx(20 + 10 * speed).margin(0.002));
    }
}

TEST_CASE("a motor that an obstacle or a limit stops lets its body sleep") {
    World world;
    Body arm = world.create_body({});
    arm.add(Box{.width = 2, .height = 0.2f});
    auto joint = world.create_revolute_joint({.body_b = arm.id()});
    joint.set_upper_angle(0.5f);
    joint.set_motor_speed(1);
    joint.set_max_motor_torque(1000);
    for (int i = 0; i < 300; ++i) world.step(1.0f / 60);
    CHECK_FALSE(arm.awake());
    CHECK(joint.angle() == Approx(0.5).margin(0.005));
}

TEST_CASE("a heavy load elsewhere does not change a net") {
    for (unsigned seed = 0; seed < seeds_or(5); ++seed) {
        std::vector<Vec2> places[2];
        for (const bool heavy : {false, true}) {
            World world({.sleeping = false});
            std::vector<Body> nodes;
            const int width = 4 + int(seed % 20);
            const auto tie = [&](size_t a, size_t b, Vec2 anchor) {
                world.create_revolute_joint({.body_a = nodes[a].id(),
                                             .body_b = nodes[b].id(),
                                             .anchor_a = anchor,
                                             .anchor_b = -anchor});
            };
            for (int i = 0; i < width * width; ++i) {
                const int x = i % width, y = i / width;
                nodes.push_back(world.create_body({.position = {float(x), -float(y)}}));
                nodes.back().add(Circle{0.4f}, {.group = -1});
                if (x > 0) tie(size_t(i) - 1, size_t(i), {0.5f, 0});
                if (y > 0) tie(size_t(i - width), size_t(i), {0, -0.5f});
            }
            world.create_revolute_joint({.body_b = nodes[0].id()});
            if (heavy) {
                Body light = world.create_body({.position = {1000, 0}});
                Body load = world.create_body({.position = {1001, 0}});
                light.add(Circle{0.2f});
                load.add(Circle{});
                load.set_mass((11 + float(seed)) * light.mass());
                world.create_revolute_joint({.body_b = light.id(), .anchor_a = {1000, 0}});
                world.create_revolute_joint({.body_a = light.id(),
                                             .body_b = load.id(),
                                             .anchor_a = {0.5f, 0},
                                             .anchor_b = {-0.5f, 0}});
            }
            for (int i = 0; i < 120; ++i) world.step(1.0f / 60);
            for (const Body& node : nodes) places[heavy].push_back(Vec2(node.position()));
        }
        CHECK(places[0] == places[1]);
    }
}

TEST_CASE("a heavy load hardly stretches the chain on which it hangs") {
    float worst = 0.0f;
    for (unsigned seed = 0; seed < seeds_or(10); ++seed) {
        Random random{std::mt19937(seed)};
        World world({.sleeping = false});
        const int links = int(random(10, 40));
        const float half = random(0.1f, 0.4f);
        // Beyond this, short links swing faster than the sub-steps can follow.
        const float ratio = std::min(std::pow(10.0f, random(1, 3)), 3000 * half);
        Body above;
        for (int i = 0; i < links; ++i) {
            Body link = world.create_body({.position = {0, -half * float(2 * i + 1)}});
            link.add(Box{.width = random(0.3f, 0.4f) * half, .height = 2 * half}, {.group = -1});
            world.create_revolute_joint({.body_a = i > 0 ? above.id() : BodyId(),
                                         .body_b = link.id(),
                                         .anchor_a = {0, i > 0 ? -half : 0},
                                         .anchor_b = {0, half}});
            above = link;
        }
        const float length = 2 * half * float(links);
        Body load = world.create_body({.position = {0, -length}});
        load.add(Circle{}, {.group = -1});
        load.set_mass(ratio * above.mass());
        world.create_revolute_joint(
            {.body_a = above.id(), .body_b = load.id(), .anchor_a = {0, -half}});
        for (int i = 0; i < 900; ++i) world.step(1.0f / 60);
        const float stretch = -load.position().y / length - 1;
        worst = std::max(worst, stretch);
        INFO("seed " << seed << ": " << links << " links of " << 2 * half << " m under " << ratio);
        CHECK(stretch < 0.03f);
        CHECK(load.velocity().length() < 0.05f);
    }
    std::printf("loads of 10 to 1000 : 1 stretch a chain by at most %.1f %%\n",
                100 * double(worst));
}

/// A figure falls upright. Returns how high its highest part gets after that, m.
float rise_of_figure(unsigned seed) {
    Random random{std::mt19937(seed)};
    World world;
    Body ground = world.create_body({.type = BodyType::static_body});
    ground.add(Box{.width = 60, .height = 2, .center = {0, -1}});
    const Vec2 at(random(-5, 5), random(6, 21));
    std::vector<Body> parts;
    const auto add = [&](Vec2 place, Vec2 half, float radius) {
        parts.push_back(world.create_body({.position = at + place}));
        parts.back().add(Segment{.from = -half, .to = half, .rounding = radius});
        return parts.back();
    };
    const auto pin = [&](Body a, Body b, Vec2 anchor_a, Vec2 anchor_b) {
        world.create_revolute_joint(
            {.body_a = a.id(), .body_b = b.id(), .anchor_a = anchor_a, .anchor_b = anchor_b});
    };
    const Body torso = add({0, 0}, {0, 0.225f}, 0.12f);
    pin(torso, add({0, 0.5f}, {0, 0.04f}, 0.1f), {0, 0.4f}, {0, -0.1f});
    for (const float side : {-1.0f, 1.0f}) {
        const Body thigh = add({0.08f * side, -0.475f}, {0, 0.15f}, 0.07f);
        pin(torso, thigh, {0.08f * side, -0.275f}, {0, 0.2f});
        const Body shin = add({0.08f * side, -0.875f}, {0, 0.15f}, 0.06f);
        pin(thigh, shin, {0, -0.2f}, {0, 0.2f});
        const Body arm = add({0.3f * side, 0.12f}, {0.1f, -0.05f * side}, 0.05f);
        pin(torso, arm, {0.15f * side, 0.195f}, {-0.15f * side, 0.075f});
    }
    float top = 0;
    bool landed = false;
    for (int step = 0; step < 300; ++step) {
        world.step(1.0f / 60);
        float high = 0;
        for (const Body& part : parts) {
            landed = landed || part.position().y < 0.3f;
            high = std::max<float>(high, part.position().y);
        }
        if (landed) top = std::max(top, high);
    }
    return top;
}

TEST_CASE("figures that fall hard hardly spring up") {
    const unsigned seeds = seeds_or(60);
    double sum = 0;
    float most = 0;
    for (unsigned seed = 0; seed < seeds; ++seed) {
        const float top = rise_of_figure(seed);
        sum += double(top) / seeds;
        most = std::max(most, top);
    }
    std::printf("figures 1.6 m high get %.2f m high after a fall, at most %.2f\n", sum,
                double(most));
    CHECK(sum < 2.6);
    CHECK(most < 4);
}

TEST_CASE("a crate below a hook hardly stretches the chain that lifts it") {
    float worst = 0;
    for (unsigned seed = 0; seed < seeds_or(20); ++seed) {
        Random random{std::mt19937(seed)};
        World world;
        Body trolley = world.create_body({.type = BodyType::kinematic_body, .position = {0, 20}});
        const int links = int(random(5, 20));
        const float length = 0.5f * float(links);
        Body above = trolley;
        Vec2 end = {};
        for (int i = 0; i < links; ++i) {
            Body link = world.create_body({.position = {0, 20 - 0.25f - 0.5f * float(i)}});
            link.add(Box{.width = 0.1f, .height = 0.5f});
            world.create_revolute_joint({.body_a = above.id(),
                                         .body_b = link.id(),
                                         .anchor_a = end,
                                         .anchor_b = {0, 0.25f}});
            above = link;
            end = {0, -0.25f};
        }
        Body hook = world.create_body({.position = {0, 20 - length - 0.2f}});
        hook.add(Box{.width = 1, .height = 0.4f}, {.density = 4});
        world.create_revolute_joint(
            {.body_a = above.id(), .body_b = hook.id(), .anchor_a = end, .anchor_b = {0, 0.2f}});
        Body crate = world.create_body({.position = {0, 20 - length - 0.9f}});
        crate.add(Box{.width = 1.5f, .height = 1}, {.density = random(5, 25)});
        world.create_weld_joint({.body_a = hook.id(),
                                 .body_b = crate.id(),
                                 .anchor_a = {0, -0.2f},
                                 .anchor_b = {0, 0.5f}});
        for (int step = 0; step < 900; ++step) {
            const float time = float(step) / 60;
            trolley.set_velocity({0, step < 450 ? 2 * std::sin(3 * time) : 0});
            world.step(1.0f / 60);
            const float now = (hook.position() - trolley.position()).length() - 0.2f;
            worst = std::max(worst, now / length - 1);
        }
    }
    std::printf("a crane stretches by %.4f of the length of its chain\n", worst);
    CHECK(worst < 0.05f);
}

}  // namespace joint_family_test
