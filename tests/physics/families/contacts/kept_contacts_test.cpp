// Tall stacks and towers, and edits of their supports. A contact keeps its manifold while its
// bodies move little: even so, no stack may buckle, and every edit must take effect at once.
// FETTLE_SEEDS=n: n stacks of each kind.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <random>
#include <vector>

#include "catch.h"
#include "family.h"

namespace kept_contacts_test {

using namespace fettle::physics;
using families::Random;
using families::seeds_or;

namespace {

constexpr float frame = 1.0f / 60.0f;

Body add_ground(World& world, const ShapeDef& surface = {}) {
    Body ground = world.create_body({.type = BodyType::static_body});
    ground.add(Box{.width = 1000, .height = 2, .center = {0, -1}}, surface);
    return ground;
}

Body add_box(World& world, Vec2 position, Vec2 size, const ShapeDef& surface = {}) {
    Body box = world.create_body({.position = position});
    box.add(Box{.width = size.x, .height = size.y}, surface);
    return box;
}

struct Stack {
    int count;
    float aside;  ///< largest offset of a box from the middle, in heights of a box
    float height = 1.0f, width = 1.0f;
    float gravity = 10.0f, friction = 0.6f, density = 1.0f;
};

bool stands(const Stack& stack, unsigned seed, float seconds) {
    Random random{std::mt19937(seed)};
    World world({.gravity = {0, -stack.gravity}, .sleeping = false});
    const ShapeDef surface = {.density = stack.density, .friction = stack.friction};
    add_ground(world, surface);
    const float aside = stack.aside * stack.height;
    Body top;
    for (int i = 0; i < stack.count; ++i)
        top = add_box(world, {random(-aside, aside), (float(i) + 0.5f) * stack.height},
                      {stack.width, stack.height}, surface);
    const float least = 0.8f * float(stack.count) * stack.height;
    for (int i = 0; i < int(seconds / frame); ++i) {
        world.step(frame);
        if (!(top.position().y > least)) return false;
    }
    return true;
}

unsigned fallen(const Stack& stack, unsigned count, float seconds) {
    unsigned fell = 0;
    for (unsigned seed = 1; seed <= count; ++seed) fell += !stands(stack, seed, seconds);
    return fell;
}

/// Seconds until a tower sleeps. Each of its levels is a beam on posts.
float time_to_sleep(int storeys, int posts) {
    World world;
    add_ground(world);
    float y = 0.0f;
    for (int storey = 0; storey < storeys; ++storey) {
        for (int i = 0; i < posts; ++i)
            add_box(world, {float(i) - 0.5f * float(posts - 1), y + 0.5f}, {0.2f, 1.0f});
        add_box(world, {0.0f, y + 1.1f}, {float(posts) - 0.6f, 0.2f});
        y += 1.2f;
    }
    int steps = 0;
    for (; steps < 600 && world.statistics().awake_bodies + (steps == 0) > 0; ++steps)
        world.step(frame);
    return float(steps) * frame;
}

/// A box at rest on a box on the ground, awake or asleep. Both contacts keep their manifolds.
struct Resting {
    World world;
    Body ground = add_ground(world);
    Body lower = add_box(world, {0, 0.5f}, {1, 1});
    Body upper = add_box(world, {0, 1.5f}, {1, 1});

    explicit Resting(bool sleeping = false) : world({.sleeping = sleeping}) { run(90); }
    void run(int steps) {
        for (int i = 0; i < steps; ++i) world.step(frame);
    }
};

}  // namespace

TEST_CASE("tall stacks of boxes with small offsets stand") {
    CHECK(fallen({.count = 50, .aside = 0.02f}, seeds_or(4), 60) == 0);
    CHECK(fallen({.count = 100, .aside = 0.01f}, seeds_or(2), 60) == 0);
}

TEST_CASE("tall stacks with other sizes or gravity or surfaces stand") {
    const Stack kinds[] = {{.count = 50, .aside = 0.02f, .height = 0.3f, .width = 0.3f},
                           {.count = 50, .aside = 0.02f, .height = 2.0f, .width = 2.0f},
                           {.count = 50, .aside = 0.02f, .height = 0.5f, .width = 2.0f},
                           {.count = 50, .aside = 0.02f, .width = 0.5f},
                           {.count = 20, .aside = 0.02f, .width = 0.25f},
                           {.count = 50, .aside = 0.02f, .gravity = 20.0f},
                           {.count = 50, .aside = 0.02f, .gravity = 5.0f},
                           {.count = 50, .aside = 0.02f, .friction = 0.3f},
                           {.count = 50, .aside = 0.02f, .friction = 1.0f, .density = 20.0f}};
    for (const Stack& kind : kinds) {
        INFO(kind.height << " x " << kind.width << ", gravity " << kind.gravity << ", friction "
                         << kind.friction);
        CHECK(fallen(kind, seeds_or(1), 60) == 0);
    }
}

TEST_CASE("towers of posts and beams come to rest") {
    float worst = 0.0f;
    for (const auto& [storeys, posts] : {std::pair{5, 2}, {8, 2}, {12, 2}, {12, 4}, {12, 8}})
        worst = std::max(worst, time_to_sleep(storeys, posts));
    std::printf("towers of up to 12 storeys: asleep after %.2f s\n", double(worst));
    CHECK(worst < 1.9f);
}

TEST_CASE("an edit of a body or a shape changes a resting contact in the next step") {
    Resting scene(GENERATE(false, true));
    const float before = scene.upper.position().y;
    SECTION("a support moved down by less than the margin") {
        scene.ground.set_position({0, -0.01f});
        scene.run(60);
        CHECK(scene.upper.position().y == Approx(before - 0.01f).margin(1e-3));
    }
    SECTION("a support moved up") {
        scene.ground.set_position({0, 0.01f});
        scene.run(60);
        CHECK(scene.upper.position().y == Approx(before + 0.01f).margin(1e-3));
    }
    SECTION("a lower support shape") {
        scene.ground.shapes()[0].set_center({0, -1.01f});
        scene.run(60);
        CHECK(scene.upper.position().y == Approx(before - 0.01f).margin(1e-3));
    }
    SECTION("a smaller box below") {
        scene.lower.shapes()[0].set_height(0.98f);
        scene.run(60);
        CHECK(scene.upper.position().y == Approx(before - 0.02f).margin(1e-3));
    }
    SECTION("a narrower box below and another center of mass above") {
        scene.lower.shapes()[0].set_width(0.2f);
        scene.upper.add(Box{.width = 0.1f, .height = 0.1f, .center = {0.45f, 0.4f}},
                        {.density = 200.0f});
        scene.run(60);
        CHECK(std::fabs(scene.upper.angle()) > 0.3f);
    }
    SECTION("a support turned by an angle for which manifolds are kept") {
        scene.ground.shapes()[0].set_friction(0.0f);
        scene.ground.set_angle(0.02f);
        scene.run(60);
        CHECK(scene.lower.velocity().x == Approx(-10 * std::sin(0.02f)).epsilon(0.05));
    }
    SECTION("no friction and a belt") {
        scene.lower.shapes()[0].set_friction(0.0f);
        scene.ground.shapes()[0].set_surface_speed(1.0f);
        scene.upper.set_velocity({0.01f, 0});
        scene.run(1);
        CHECK(scene.upper.velocity().x == Approx(0.01f).epsilon(0.01));
    }
    SECTION("a sensor") {
        scene.lower.shapes()[0].set_sensor(true);
        scene.run(30);
        CHECK(scene.upper.position().y < before - 0.5f);
    }
    SECTION("a filter") {
        scene.lower.shapes()[0].set_mask(0);
        scene.run(30);
        CHECK(scene.lower.position().y < 0.0f);
    }
    SECTION("a joint of two bodies that do not collide") {
        MotorJoint joint = scene.world.create_motor_joint(
            {.body_a = scene.lower.id(), .body_b = scene.upper.id(), .collide = true});
        scene.run(1);
        CHECK(scene.upper.contacts().size() == 1);
        joint.set_collide(false);
        scene.run(1);
        CHECK(scene.upper.contacts().empty());
    }
    SECTION("another gravity") {
        scene.world.set_gravity({0, 10});
        scene.run(30);
        CHECK(scene.upper.position().y > before + 0.5f);
    }
    CHECK_FALSE(scene.world.validate());
}

TEST_CASE("a resting contact with bounds that move follows them") {
    World world({.sleeping = false});
    world.set_bounds(Aabb{{-10, 0}, {10, 10}});
    Body box = add_box(world, {0, 0.5f}, {1, 1});
    for (int i = 0; i < 60; ++i) world.step(frame);
    world.set_bounds(Aabb{{-10, -0.01f}, {10, 10}});
    for (int i = 0; i < 60; ++i) world.step(frame);
    CHECK(box.position().y == Approx(0.49f).margin(1e-3));
}

TEST_CASE("boxes on a large platform that rocks stay where they stand") {
    float worst = 0;
    for (unsigned seed = 0; seed < families::seeds_or(30); ++seed) {
        families::Random random{std::mt19937(seed)};
        World world({.sleeping = false});
        Body platform = world.create_body({.type = BodyType::kinematic_body});
        platform.add(Box{.width = 14, .height = 0.4f});
        const float at = random(-6, 6), width = random(0.4f, 0.8f), height = random(0.3f, 0.8f);
        Body box = world.create_body({.position = {at, 0.2f + 0.5f * height}});
        box.add(Box{.width = width, .height = height}, {.friction = 0.8f});
        const float turn = random(0.02f, 0.2f), rate = random(0.2f, 0.6f);
        for (int step = 0; step < 1800; ++step) {
            platform.set_angular_velocity(turn * rate * std::cos(rate * float(step) / 60));
            world.step(1.0f / 60);
            const float c = std::cos(platform.angle()), s = std::sin(platform.angle());
            worst =
                std::max<float>(worst, std::abs(c * box.position().x + s * box.position().y - at));
        }
    }
    INFO("the worst slips by " << worst << " m in 30 s");
    CHECK(worst < 0.015f);
}

TEST_CASE("kept contacts are part of a saved world and of a copy") {
    Resting scene;
    scene.upper.set_velocity({0.1f, 0});
    scene.run(3);
    World copy = scene.world.clone(), restored;
    std::vector<std::byte> saved;
    scene.world.save(saved);
    restored.restore(saved);
    for (int i = 0; i < 60; ++i) {
        for (World* world : {&scene.world, &copy, &restored}) world->step(frame);
        REQUIRE(copy.hash() == scene.world.hash());
        REQUIRE(restored.hash() == scene.world.hash());
    }
}

}  // namespace kept_contacts_test
