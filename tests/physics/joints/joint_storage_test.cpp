#include "catch.h"
#include "scenes.h"

#include <functional>

namespace joint_storage_test {

// The common properties of all joints: bodies, sleep, filters, creation and destruction.

using namespace scenes;

namespace {

void fall_asleep(World& world, const Body& body) {
    for (int i = 0; i < 900 && body.awake(); ++i) world.step(frame);
    REQUIRE_FALSE(body.awake());
    REQUIRE_FALSE(world.validate());
}

}  // namespace

TEST_CASE("jointed bodies sleep and wake as one island") {
    World world;
    add_floor(world);
    Body left = add_box(world, {0, 0.5f}), right = add_box(world, {3, 0.5f}),
         apart = add_box(world, {9, 0.5f});
    DistanceJoint rod = world.create_distance_joint({.body_a = left.id(), .body_b = right.id()});
    fall_asleep(world, left);
    REQUIRE_FALSE(right.awake());
    left.set_awake(true);
    REQUIRE(right.awake());
    REQUIRE_FALSE(apart.awake());
    right.set_awake(false);
    REQUIRE_FALSE(left.awake());
    rod.set_enabled(false);
    REQUIRE(left.awake());
    right.set_awake(false);
    REQUIRE(left.awake());  // the disabled joint connects no islands
    REQUIRE_FALSE(world.validate());
}

TEST_CASE("a body that cannot sleep keeps the bodies joined to it awake") {
    World world;
    add_floor(world);
    Body left = add_box(world, {0, 0.5f}), right = add_box(world, {3, 0.5f});
    right.set_can_sleep(false);
    world.create_distance_joint({.body_a = left.id(), .body_b = right.id()});
    run(world, 3.0f);
    REQUIRE(left.awake());
}

TEST_CASE("a body that hangs on a kinematic body follows when that starts to move") {
    World world;
    Body hand = world.create_body({.type = BodyType::kinematic_body, .position = {0, 5}});
    Body ball = add_ball(world, {0, 3}, 0.3f);
    ball.set_linear_damping(2.0f);
    world.create_distance_joint({.body_a = hand.id(), .body_b = ball.id()});
    fall_asleep(world, ball);
    hand.set_velocity({0, 1});
    run(world, 1.0f);
    REQUIRE(ball.position().y == Approx(4.0f).margin(0.05));
    hand.set_velocity({0, 0});
    fall_asleep(world, ball);
    hand.set_position({0, 8});
    REQUIRE(ball.awake());
}

TEST_CASE("every edit of a joint wakes both bodies") {
    World world;
    add_floor(world);
    Body left = add_box(world, {0, 0.5f}), right = add_box(world, {3, 0.5f}),
         third = add_box(world, {6, 0.5f});
    DistanceJoint rod = world.create_distance_joint({.body_a = left.id(), .body_b = right.id()});
    const std::vector<std::pair<const char*, std::function<void()>>> edits = {
        {"length", [&] { rod.set_length(3.0f); }},
        {"min_length", [&] { rod.set_min_length(0.5f); }},
        {"max_length", [&] { rod.set_max_length(9.0f); }},
        {"hertz", [&] { rod.set_hertz(3.0f); }},
        {"damping_ratio", [&] { rod.set_damping_ratio(1.0f); }},
        {"anchor_a",
         [&] {
             rod.set_anchor_a({0, 0});
         }},
        {"anchor_b",
         [&] {
             rod.set_anchor_b({0, 0});
         }},
        {"collide", [&] { rod.set_collide(true); }},
        {"enabled", [&] { rod.set_enabled(true); }},
        {"body_b", [&] { rod.set_body_b(third); }},
        {"body_b again", [&] { rod.set_body_b(right); }},
        {"destroyed", [&] { rod.destroy(); }},
    };
    for (const auto& [name, edit] : edits) {
        INFO(name);
        fall_asleep(world, left);
        fall_asleep(world, right);
        edit();
        REQUIRE(left.awake());
        REQUIRE(right.awake());
        REQUIRE_FALSE(world.validate());
    }
}

TEST_CASE("jointed bodies pass through each other unless they are to collide") {
    World world({.gravity = {0, 0}});
    Body left = add_box(world, {0, 0}), right = add_box(world, {2, 0});
    DistanceJoint rope = world.create_distance_joint({.body_a = left.id(), .body_b = right.id()});
    rope.set_hertz(0.0f);
    right.set_velocity({-4, 0});
    run(world, 0.25f);
    REQUIRE(left.position().x == 0.0f);  // they overlap by now
    REQUIRE(world.contacts().empty());
    right.set_velocity({0, 0});
    rope.set_collide(true);
    run(world, 0.05f);
    REQUIRE(world.contacts().size() == 1);
    REQUIRE_FALSE(world.validate());
    rope.set_collide(false);
    REQUIRE(world.contacts().empty());
    rope.set_enabled(false);
    run(world, 0.05f);
    REQUIRE(world.contacts().size() == 1);
    rope.set_enabled(true);
    REQUIRE(world.contacts().empty());
    rope.destroy();
    run(world, 0.05f);
    REQUIRE(world.contacts().size() == 1);
    REQUIRE_FALSE(world.validate());
}

TEST_CASE("a joint to the world does not open its bounds") {
    World world({.bounds = Aabb{{-5, -5}, {5, 5}}});
    Body ball = add_ball(world, {0, 0});
    DistanceJoint rope = world.create_distance_joint({.body_b = ball.id()});
    rope.set_hertz(0.0f);
    run(world, 3.0f);
    REQUIRE(ball.position().y == Approx(-4.5f).margin(0.02));
}

TEST_CASE("creating and destroying joints does not change the others") {
    World world({.gravity = {0, 0}});
    std::vector<Body> bodies;
    for (int i = 0; i < 8; ++i) bodies.push_back(add_ball(world, {3.0f * float(i), 0}));
    std::vector<DistanceJoint> rods;
    std::vector<RevoluteJoint> pins;
    for (size_t i = 0; i + 1 < bodies.size(); ++i) {
        const JointDef def = {.body_a = bodies[i].id(), .body_b = bodies[i + 1].id()};
        rods.push_back(world.create_distance_joint(def));
        rods.back().set_length(float(i));
        pins.push_back(world.create_revolute_joint(def));
        pins.back().set_target_angle(float(i));
    }
    REQUIRE(world.joint_count() == 14);
    rods[2].destroy();
    bodies[5].destroy();  // with four joints
    REQUIRE(world.joint_count() == 9);
    REQUIRE_FALSE(world.validate());
    for (size_t i : {0, 1, 3, 6}) REQUIRE(rods[i].length() == float(i));
    for (size_t i : {0, 1, 2, 3, 6}) REQUIRE(pins[i].target_angle() == float(i));
    REQUIRE_FALSE(pins[4].is_valid());
    REQUIRE_THROWS_WITH(pins[4].angle(), contains("joint"));
    // A copy goes on alike.
    World copy = world.clone();
    run(world, 1.0f);
    run(copy, 1.0f);
    REQUIRE(world.hash() == copy.hash());
    world.clear();
    REQUIRE(world.joint_count() == 0);
    REQUIRE_FALSE(world.validate());
}

TEST_CASE("a dormant joint has no effect and acts like any other when it is connected") {
    const auto pendulum = [](World& world, bool wakes_later) {
        add_floor(world);
        Body left = add_box(world, {0, 3}), right = add_box(world, {2, 3});
        RevoluteJoint pin;
        if (wakes_later) {
            pin = world.joint<RevoluteJoint>(world.create_joint(JointType::revolute).id());
            pin.set_anchor_a({1, 0});
            pin.set_anchor_b({-1, 0});
            pin.set_hertz(1.0f);
            REQUIRE(pin.dormant());
            REQUIRE(pin.upper_angle() == infinity);
            REQUIRE_FALSE(world.validate());
            pin.connect(left, right);
        } else {
            pin = world.create_revolute_joint({.body_a = left.id(),
                                               .body_b = right.id(),
                                               .anchor_a = {1, 0},
                                               .anchor_b = {-1, 0}});
            pin.set_hertz(1.0f);
        }
        REQUIRE_FALSE(pin.dormant());
        return pin;
    };
    World one, other;
    RevoluteJoint pin = pendulum(one, false), later = pendulum(other, true);
    run(one, 2.0f);
    run(other, 2.0f);
    REQUIRE(one.hash() == other.hash());
    pin.destroy();
    later.disconnect();
    REQUIRE(later.dormant());
    REQUIRE(later.force() == Vec2(0, 0));
    run(one, 2.0f);
    run(other, 2.0f);
    REQUIRE(one.hash() == other.hash());
    REQUIRE(other.joint_count() == 1);
    REQUIRE(other.statistics().joints == 0);
    REQUIRE_FALSE(other.validate());
}

TEST_CASE("a dormant joint outlives bodies and is copied to other worlds and saves") {
    World world({.gravity = {0, 0}}), elsewhere;
    Body left = add_ball(world, {0, 0}), right = add_ball(world, {3, 0});
    world.create_distance_joint({.body_a = left.id(), .body_b = right.id()});
    MouseJoint mouse = world.joint<MouseJoint>(world.create_joint(JointType::mouse, 7).id());
    mouse.connect(Body(), left);
    mouse.set_hertz(2.0f);
    mouse.set_broken(true);
    REQUIRE(left.joints().size() == 2);
    REQUIRE(right.joints().size() == 1);
    mouse.disconnect();
    left.destroy();
    REQUIRE(world.joints() == std::vector<Joint>{mouse});
    std::vector<std::byte> bytes;
    world.save(bytes);
    World again;
    again.restore(bytes);
    for (const Joint& copy : {elsewhere.create_joint(mouse), again.joints().at(0)}) {
        REQUIRE(copy.dormant());
        REQUIRE(copy.broken());
        REQUIRE(copy.user_data() == 7);
        REQUIRE(copy.world().joint<MouseJoint>(copy.id()).hertz() == 2.0f);
        REQUIRE_FALSE(copy.world().validate());
    }
    REQUIRE_THROWS_WITH(mouse.connect(right, Body()), contains("a mouse joint has a target"));
    REQUIRE_THROWS_WITH(mouse.connect(Body(), Body()), contains("a mouse joint drags a body"));
    Joint weld = world.create_joint(JointType::weld);
    REQUIRE_THROWS_WITH(weld.connect(right, right), contains("two different bodies"));
    REQUIRE_THROWS_WITH(weld.connect(Body(), Body()), contains("two different bodies"));
    REQUIRE(weld.dormant());
    world.clear();
    REQUIRE(world.joint_count() == 0);
    REQUIRE_FALSE(world.validate());
}

TEST_CASE("joints refuse invalid values and then change nothing") {
    World world, elsewhere;
    Body ball = add_ball(world, {0, 0}), other = add_ball(world, {2, 0});
    Body stranger = add_ball(elsewhere, {0, 0});
    REQUIRE_THROWS_WITH(world.create_distance_joint({}), contains("two different bodies"));
    REQUIRE_THROWS_WITH(world.create_distance_joint({.body_a = ball.id(), .body_b = ball.id()}),
                        contains("two different bodies"));
    REQUIRE_THROWS(world.create_distance_joint({.body_a = {77, 3}, .body_b = ball.id()}));
    REQUIRE(world.joint_count() == 0);
    DistanceJoint rod = world.create_distance_joint({.body_a = ball.id(), .body_b = other.id()});
    REQUIRE_THROWS_WITH(rod.set_length(-1.0f), contains("length"));
    REQUIRE_THROWS_WITH(rod.set_max_length(std::nanf("")), contains("max_length"));
    REQUIRE_THROWS_WITH(rod.set_hertz(-1.0f), contains("hertz"));
    REQUIRE_THROWS_WITH(rod.set_body_a(other), contains("body_a"));
    REQUIRE_THROWS_WITH(rod.set_body_a(stranger), contains("same world"));
    REQUIRE_THROWS_WITH(rod.set_anchor_a({infinity, 0}), contains("anchor_a"));
    REQUIRE(rod.length() == 2.0f);
    REQUIRE(rod.body_a() == ball);
    REQUIRE_THROWS_WITH(world.joint<MouseJoint>(rod.id()).hertz(),
                        contains("expected a mouse joint, got a distance joint"));
    rod.set_body_a(Body());
    REQUIRE_FALSE(rod.body_a());
    REQUIRE(rod.world_anchor_a() == Vec2(0, 0));
}

}  // namespace joint_storage_test
