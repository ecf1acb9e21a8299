#include <functional>

#include "catch.h"
#include "scenes.h"

namespace live_test {

using namespace scenes;

// An edit takes effect in the next step, also on bodies that rest or sleep.

namespace {

/// A box asleep on a floor.
struct Resting {
    World world;
    Body floor, box;

    Resting() {
        floor = add_floor(world);
        box = add_box(world, {0, 0.5f});
        run(world, 3.0f);
        REQUIRE_FALSE(box.awake());
    }
    Shape shape() const { return box.shapes()[0]; }
};

}  // namespace

TEST_CASE("friction of a sleeping body on a slope set to 0 makes it slide") {
    World world;
    Slope slope = add_slope(world, 0.3f, 0.8f);
    run(world, 3.0f);
    REQUIRE_FALSE(slope.box.awake());
    const Position start = slope.box.position();
    SECTION("of the body") {
        slope.box.shapes()[0].set_friction(0.0f);
    }
    SECTION("of the slope") {
        slope.ground.shapes()[0].set_friction(0.0f);
    }
    REQUIRE(slope.box.awake());
    run(world, 1.0f);
    const float expected = 0.5f * 10.0f * std::sin(0.3f);
    REQUIRE((slope.box.position() - start).dot(slope.down) == Approx(expected).epsilon(0.05));
}

TEST_CASE("friction of a resting body that is awake set to 0 makes it slide") {
    World world({.sleeping = false});
    Slope slope = add_slope(world, 0.3f, 0.8f);
    run(world, 2.0f);
    slope.box.shapes()[0].set_friction(0.0f);
    run(world, 0.5f);
    REQUIRE(slope.box.velocity().dot(slope.down) > 1.0f);
}

TEST_CASE("a change of gravity wakes all sleeping bodies") {
    Resting scene;
    scene.world.set_gravity({0, 5});
    REQUIRE(scene.box.awake());
    run(scene.world, 1.0f);
    REQUIRE(scene.box.position().y > 2.0f);
}

TEST_CASE("a body that rested on a support that is deleted or moved or changed falls") {
    Resting scene;
    SECTION("deleted") {
        scene.floor.destroy();
    }
    SECTION("teleported") {
        scene.floor.set_position({0, -50});
    }
    SECTION("shape destroyed") {
        scene.floor.shapes()[0].destroy();
    }
    SECTION("shape detached") {
        scene.floor.shapes()[0].detach();
    }
    SECTION("made narrow") {
        scene.floor.shapes()[0].set_width(1.0f);
        scene.floor.shapes()[0].set_center({20, 0});
    }
    SECTION("turned away") {
        scene.floor.set_angle(1.5f);
    }
    SECTION("made a sensor") {
        scene.floor.shapes()[0].set_sensor(true);
    }
    SECTION("filtered out") {
        scene.floor.shapes()[0].set_mask(0);
    }
    SECTION("box filtered out") {
        scene.shape().set_category(0);
    }
    SECTION("same negative group") {
        scene.floor.shapes()[0].set_group(-3);
        scene.shape().set_group(-3);
    }
    SECTION("support becomes dynamic") {
        scene.floor.set_type(BodyType::dynamic_body);
    }
    run(scene.world, 1.0f);
    REQUIRE(scene.box.position().y < -1.0f);
    REQUIRE_FALSE(scene.world.validate());
}

TEST_CASE("every kind of edit wakes a sleeping body") {
    Resting scene;
    Body box = scene.box;
    const std::vector<std::pair<const char*, std::function<void()>>> edits = {
        {"position",
         [&] {
             box.set_position({0, 0.6f});
         }},
        {"angle", [&] { box.set_angle(0.1f); }},
        {"velocity",
         [&] {
             box.set_velocity({0, 1});
         }},
        {"angular velocity", [&] { box.set_angular_velocity(1); }},
        {"force",
         [&] {
             box.set_force({0, 1});
         }},
        {"no force",
         [&] {
             box.set_force({0, 0});
         }},
        {"torque", [&] { box.set_torque(0.1f); }},
        {"no torque", [&] { box.set_torque(0); }},
        {"applied force",
         [&] {
             box.apply_force({0, 1});
         }},
        {"impulse",
         [&] {
             box.apply_impulse({0, 1});
         }},
        {"angular impulse", [&] { box.apply_angular_impulse(0.1f); }},
        {"gravity scale", [&] { box.set_gravity_scale(1.1f); }},
        {"damping", [&] { box.set_linear_damping(0.1f); }},
        {"angular damping", [&] { box.set_angular_damping(0.1f); }},
        {"locked x", [&] { box.set_locked_x(false); }},
        {"locked y", [&] { box.set_locked_y(false); }},
        {"locked rotation", [&] { box.set_locked_rotation(false); }},
        {"mass", [&] { box.set_mass(3.0f); }},
        {"mass computed again", [&] { box.set_mass(std::nullopt); }},
        {"inertia", [&] { box.set_inertia(1.0f); }},
        {"center", [&] { box.set_center(Vec2(0, 0.1f)); }},
        {"density", [&] { scene.shape().set_density(2.0f); }},
        {"restitution", [&] { scene.shape().set_restitution(0.5f); }},
        {"restitution of the floor", [&] { scene.floor.shapes()[0].set_restitution(0.2f); }},
        {"rolling resistance", [&] { scene.shape().set_rolling_resistance(0.1f); }},
        {"surface speed", [&] { scene.floor.shapes()[0].set_surface_speed(0.0f); }},
        {"width", [&] { scene.shape().set_width(1.2f); }},
        {"mask", [&] { scene.shape().set_mask(1); }},
        {"geometry", [&] { scene.shape().set_geometry(Circle{.radius = 0.5f}); }},
        {"another shape", [&] { box.add(Circle{.radius = 0.1f}); }},
        {"a mouse",
         [&] {
             scene.world.create_mouse_joint({.body = box.id(), .target = {0, 1}, .max_force = 1})
                 .destroy();
         }},
        {"awake", [&] { box.set_awake(true); }},
        {"may not sleep", [&] { box.set_can_sleep(false); }},
    };
    for (const auto& [name, edit] : edits) {
        INFO(name);
        box.set_can_sleep(true);
        for (int i = 0; i < 600 && box.awake(); ++i) scene.world.step(frame);
        REQUIRE_FALSE(box.awake());
        edit();
        REQUIRE(box.awake());
        REQUIRE_FALSE(scene.world.validate());
    }
}

TEST_CASE("waking one wakes the island it sleeps in and not its neighbors") {
    World world;
    add_floor(world);
    Body low = add_box(world, {0, 0.5f}), high = add_box(world, {0, 1.5f}),
         apart = add_box(world, {5, 0.5f});
    run(world, 3.0f);
    REQUIRE_FALSE(low.awake());
    REQUIRE_FALSE(apart.awake());
    high.set_awake(true);
    REQUIRE(low.awake());
    REQUIRE_FALSE(apart.awake());
}

TEST_CASE("a sleeping body that is hit wakes") {
    Resting scene;
    Body ball = add_ball(scene.world, {-5, 0.5f});
    ball.set_velocity({8, 0});
    run(scene.world, 1.5f);
    REQUIRE(scene.box.position().x > 0.05f);
}

TEST_CASE("a kinematic platform that starts to move wakes bodies that sleep on it") {
    World world;
    Body platform = world.create_body({.type = BodyType::kinematic_body});
    platform.add(Box{.width = 10, .height = 1});
    Body box = add_box(world, {0, 1});
    run(world, 3.0f);
    REQUIRE_FALSE(box.awake());
    platform.set_velocity({0, 1});
    run(world, 3.0f);
    REQUIRE(box.awake());
    REQUIRE(box.position().y == Approx(4.0f).margin(0.05));
}

TEST_CASE("a body becomes static and kinematic and dynamic again while it falls") {
    World world;
    Body ball = add_ball(world, {0, 50});
    run(world, 0.5f);
    ball.set_type(BodyType::static_body);
    const Position there = ball.position();
    run(world, 0.5f);
    REQUIRE(ball.position() == there);
    ball.set_type(BodyType::kinematic_body);
    ball.set_velocity({1, 0});
    run(world, 1.0f);
    REQUIRE(ball.position().x == Approx(1.0f).epsilon(1e-3));
    REQUIRE(ball.position().y == there.y);
    ball.set_type(BodyType::dynamic_body);
    run(world, 1.0f);
    REQUIRE(ball.position().y < there.y - 3.0f);
    REQUIRE_FALSE(world.validate());
}

TEST_CASE("a density changed under a seesaw tips it") {
    World world;
    add_floor(world);
    Body pivot = world.create_body({.type = BodyType::static_body, .position = {0, 0.5f}});
    pivot.add(Polygon{.vertices = {{-0.3f, -0.5f}, {0.3f, -0.5f}, {0, 0.5f}}});
    Body plank = world.create_body({.position = {0, 1.1f}});
    plank.add(Box{.width = 6, .height = 0.2f});
    Body left = add_box(world, {-2, 1.7f}), right = add_box(world, {2, 1.7f});
    run(world, 1.0f);
    right.shapes()[0].set_density(6.0f);
    run(world, 2.0f);
    REQUIRE(plank.angle() < -0.1f);
    REQUIRE(left.position().y > right.position().y + 0.5f);
}

TEST_CASE("a radius edited on a resting ball lifts it") {
    World world;
    add_floor(world);
    Body ball = add_ball(world, {0, 0.5f});
    run(world, 3.0f);
    REQUIRE_FALSE(ball.awake());
    ball.shapes()[0].set_radius(0.6f);
    run(world, 2.0f);
    REQUIRE(ball.position().y == Approx(0.6f).margin(0.01));
    REQUIRE(ball.mass() == Approx(3.14159f * 0.36f));
}

TEST_CASE(
    "a vertex added to a rotated polygon moves no other vertex and updates all derived values") {
    World world({.gravity = {0, 0}});
    Body body = world.create_body({.position = {3, 2}, .angle = 0.8f});
    Shape shape = body.add(Polygon{.vertices = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}});
    const auto before = shape.world_vertices();
    const float mass = body.mass(), inertia = body.inertia();
    const uint32_t rebuilds = shape.rebuilds();
    for (int i = 1; i <= 10; ++i) shape.add_vertex({1.0f + 0.2f * float(i), 0});
    REQUIRE(shape.rebuilds() <= rebuilds + 10);
    const auto after = shape.world_vertices();
    REQUIRE(after.size() == 5);
    for (const Position& v : before) {
        float nearest = infinity;
        for (const Position& w : after) nearest = std::min(nearest, (w - v).length());
        REQUIRE(nearest < 1e-5f);
    }
    REQUIRE(body.mass() == Approx(mass + 2.0f));
    REQUIRE(body.inertia() > inertia);
    REQUIRE(body.center().x > 0.1f);
    REQUIRE(body.position() == Vec2(3, 2));
    const Position tip = body.world_point({3, 0});
    REQUIRE(shape.aabb().max.x >= tip.x - 1e-4f);
    REQUIRE(shape.contains(body.world_point({2.5f, 0})));
}

TEST_CASE("ten vertices set in a row cost one rebuild") {
    World world;
    Body body = world.create_body();
    Shape shape = body.add(Polygon{.vertices = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}});
    REQUIRE(body.mass() == Approx(4.0f));
    const uint32_t shape_before = shape.rebuilds(), body_before = body.rebuilds();
    for (int i = 1; i <= 10; ++i) {
        const std::vector<Vec2> points = {
            {-1, -1}, {1, -1}, {1.0f + 0.2f * float(i), 0}, {1, 1}, {-1, 1}};
        shape.set_vertices(points);
    }
    REQUIRE(body.mass() == Approx(6.0f));
    REQUIRE(shape.rebuilds() == shape_before + 1);
    REQUIRE(body.rebuilds() == body_before + 1);
}

TEST_CASE("a sensor lets a ball through and stops it when it is made solid") {
    World world;
    Body gate = world.create_body({.type = BodyType::static_body});
    Shape shape = gate.add(Box{.width = 10, .height = 1}, {.sensor = true});
    Body ball = add_ball(world, {0, 3});
    run(world, 1.5f);
    REQUIRE(ball.position().y < -1.0f);
    ball.set_pose({{0, 3}, 0});
    ball.set_velocity({0, 0});
    shape.set_sensor(false);
    run(world, 2.0f);
    REQUIRE(ball.position().y == Approx(1.0f).margin(0.02));
}

TEST_CASE("gravity scale edited on a sleeping body takes effect") {
    Resting scene;
    scene.box.set_gravity_scale(-1.0f);
    run(scene.world, 1.0f);
    REQUIRE(scene.box.position().y > 3.0f);
}

TEST_CASE("sleeping switched off wakes all bodies and none falls asleep again") {
    Resting scene;
    scene.world.set_sleeping(false);
    REQUIRE(scene.box.awake());
    run(scene.world, 3.0f);
    REQUIRE(scene.box.awake());
    scene.world.set_sleeping(true);
    run(scene.world, 3.0f);
    REQUIRE_FALSE(scene.box.awake());
}

TEST_CASE("sleeping bodies and contacts cost nothing in a step") {
    World world;
    add_floor(world);
    for (int i = 0; i < 20; ++i) add_box(world, {float(i) * 2.0f - 20.0f, 0.5f});
    run(world, 3.0f);
    REQUIRE(world.statistics().awake_bodies == 0);
    REQUIRE(world.statistics().awake_contacts == 0);
    REQUIRE(world.statistics().islands == 20);
    REQUIRE(world.contacts().size() == 20);
    REQUIRE(world.bodies()[5].contacts().size() == 1);
}

TEST_CASE("a sleeping stack keeps its force on a platform that another body keeps awake") {
    World world;
    Body platform = world.create_body({.type = BodyType::kinematic_body});
    platform.add(Box{.width = 12, .height = 1, .center = {0, -0.5f}});
    world.create_body({.position = {3, 0.5f}, .can_sleep = false}).add(Box{});
    Body lowest = add_box(world, {-2, 0.5f});
    add_box(world, {-2, 1.5f});
    add_box(world, {-2, 2.5f});
    run(world, 8.0f);
    REQUIRE_FALSE(lowest.awake());
    float force = 0;
    for (const Contact& contact : lowest.contacts())
        if (contact.body_a == platform.id() || contact.body_b == platform.id())
            force += contact.normal_force;
    CHECK(force == Approx(3 * 10 * lowest.mass()).epsilon(0.05));
    lowest.set_awake(true);
    run(world, 0.1f);
    CHECK(lowest.velocity().length() < 0.02f);
}

TEST_CASE("the lists of what is awake do not contain stacks that were put to sleep") {
    constexpr size_t stacks = 40;
    World world;
    add_floor(world);
    std::vector<Body> lower;
    for (size_t i = 0; i < stacks; ++i) {
        const float x = float(i) * 2.0f - 40.0f;
        lower.push_back(add_box(world, {x, 0.5f}));
        Body upper = add_box(world, {x, 1.5f});
        world.create_weld_joint(
            {.body_a = lower.back().id(), .body_b = upper.id(), .anchor_a = {0, 1}});
    }
    run(world, 0.1f);
    for (size_t i = 0; i < stacks; ++i) {
        lower[(i * 7) % stacks].set_awake(false);
        std::vector<std::byte> bytes;
        world.save(bytes);
        World loaded;
        loaded.restore(bytes);  // checks these lists
        loaded.step(1.0f / 60.0f);
        const StepStatistics now = loaded.statistics();
        REQUIRE(now.awake_bodies == 2 * (stacks - 1 - i));
        REQUIRE(now.awake_joints == stacks - 1 - i);
        REQUIRE(now.islands == i + 1);
    }
    run(world, 0.1f);
    REQUIRE(world.statistics().awake_contacts == 0);
    for (Body& body : lower) body.set_awake(true);
    run(world, 0.1f);
    REQUIRE(world.statistics().awake_bodies == 2 * stacks);
    REQUIRE(world.statistics().awake_contacts == stacks);
}

TEST_CASE("a body put to sleep in the air stays there until woken") {
    World world;
    Body ball = add_ball(world, {0, 10});
    run(world, 0.2f);
    ball.set_awake(false);
    const Position there = ball.position();
    run(world, 1.0f);
    REQUIRE(ball.position() == there);
    ball.set_awake(true);
    run(world, 0.5f);
    REQUIRE(ball.position().y < there.y);
}

TEST_CASE("a body that was put to sleep on a floor wakes when the floor is removed") {
    World world;
    Body floor = add_floor(world);
    const bool created_asleep = GENERATE(true, false);
    Body ball = world.create_body({.position = {0, 0.5f}, .awake = !created_asleep});
    ball.add(Circle{.radius = 0.5f});
    Body above = world.create_body({.position = {0, 1.5f}, .awake = false});
    above.add(Circle{.radius = 0.5f});
    ball.set_awake(false);
    run(world, 0.2f);
    REQUIRE_FALSE(ball.awake());
    const int change = GENERATE(0, 1, 2);
    if (change == 0) floor.destroy();
    if (change == 1) floor.set_position({0, -9});
    if (change == 2) floor.set_enabled(false);
    run(world, 0.5f);
    REQUIRE(ball.position().y < 0.0f);
    REQUIRE(above.position().y < 1.0f);
}

TEST_CASE("a body created asleep waits until it is touched") {
    World world({.gravity = {0, 0}});
    Body sleeper = world.create_body({.position = {5, 0}, .awake = false});
    sleeper.add(Box{});
    REQUIRE_FALSE(sleeper.awake());
    run(world, 0.2f);
    REQUIRE_FALSE(sleeper.awake());
    Body ball = add_ball(world, {0, 0});
    ball.set_velocity({10, 0});
    run(world, 1.0f);
    REQUIRE(sleeper.position().x > 5.1f);
}

}  // namespace live_test
