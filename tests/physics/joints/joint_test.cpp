#include <algorithm>
#include <cmath>
#include <numbers>

#include "catch.h"
#include "scenes.h"

namespace joint_test {

using namespace scenes;

TEST_CASE("a mouse joint drags a body to its target and follows the target") {
    World world({.gravity = {0, 0}});
    Body box = add_box(world, {0, 0});
    MouseJoint mouse = world.create_mouse_joint({.body = box.id(), .target = {0, 0}});
    mouse.set_target({3, 4});
    run(world, 2.0f);
    REQUIRE((box.position() - Position(3, 4)).length() < 0.02f);
    mouse.destroy();
    REQUIRE_FALSE(mouse.is_valid());
    REQUIRE(world.joint_count() == 0);
}

TEST_CASE("a mouse joint beside the center hangs the body from its anchor") {
    World world;
    Body box = world.create_body({.position = {0, 5}, .angular_damping = 3.0f});
    box.add(Box{.width = 2, .height = 0.4f});
    MouseJoint mouse = world.create_mouse_joint({.body = box.id(), .target = {0.8f, 5}});
    REQUIRE(mouse.anchor().x == Approx(0.8f));
    run(world, 6.0f);
    // The center of mass hangs below the grip.
    REQUIRE(box.position().x == Approx(0.8f).margin(0.1));
    REQUIRE(box.position().y < 4.5f);
    REQUIRE(mouse.force().y == Approx(10.0f * box.mass()).epsilon(0.05));
}

TEST_CASE("a weak mouse cannot lift a heavy body and a strong one can") {
    World world;
    add_floor(world);
    Body box = add_box(world, {0, 0.5f}, 1.0f, {.density = 10.0f});
    MouseJoint mouse =
        world.create_mouse_joint({.body = box.id(), .target = {0, 0.5f}, .max_force = 50.0f});
    mouse.set_target({0, 5});
    run(world, 2.0f);
    REQUIRE(box.position().y < 0.6f);
    mouse.set_max_force(500.0f);
    run(world, 2.0f);
    REQUIRE(box.position().y > 4.0f);
    mouse.set_enabled(false);
    run(world, 2.0f);
    REQUIRE(box.position().y < 0.6f);
}

TEST_CASE("every property of a mouse joint has an effect at once and wakes its sleeping body") {
    World world;
    add_floor(world);
    Body box = add_box(world, {0, 0.5f}), other = add_box(world, {5, 0.5f});
    MouseJoint mouse = world.create_mouse_joint({.body = box.id(), .target = {0, 0.5f}});
    auto settle = [&] {
        for (int i = 0; i < 600 && (box.awake() || other.awake()); ++i) world.step(frame);
        REQUIRE_FALSE(box.awake());
    };
    settle();
    mouse.set_hertz(2.0f);
    REQUIRE(box.awake());
    REQUIRE(mouse.hertz() == 2.0f);
    settle();
    mouse.set_damping_ratio(1.0f);
    REQUIRE(box.awake());
    settle();
    mouse.set_anchor({0.1f, 0});
    REQUIRE(box.awake());
    settle();
    mouse.set_body(other);
    REQUIRE(box.awake());
    REQUIRE(other.awake());
    run(world, 3.0f);
    REQUIRE(other.position().x < 4.0f);
    REQUIRE(mouse.body() == other);
}

TEST_CASE("the joints of a body die with it") {
    World world;
    Body box = add_box(world, {0, 0});
    MouseJoint a = world.create_mouse_joint({.body = box.id()});
    MouseJoint b = world.create_mouse_joint({.body = box.id()});
    box.destroy();
    REQUIRE_FALSE(a.is_valid());
    REQUIRE_FALSE(b.is_valid());
    REQUIRE_THROWS_WITH(a.target(), contains("joint"));
    world.step(frame);
}

TEST_CASE("bodies do not fall asleep while a joint draws them together") {
    const float apart = GENERATE(0.5f, 3.0f, 12.0f), mass = GENERATE(1.0f, 30.0f);
    const bool falls = GENERATE(false, true);
    World world({.gravity = {0, falls ? -10.0f : 0.0f}});
    if (falls) add_floor(world, 100.0f);
    std::vector<Joint> joints;
    const auto pair = [&](auto join) {
        const float y = falls ? 0.5f : 4.0f * float(joints.size());
        const float x = falls ? 30.0f * float(joints.size()) : 0.0f;
        Body a = add_box(world, {x, y}), b = add_box(world, {x + 1 + apart, y});
        b.set_mass(mass);
        joints.push_back(join(JointDef{
            .body_a = a.id(), .body_b = b.id(), .anchor_a = {0.5f, 0}, .anchor_b = {-0.5f, 0}}));
    };
    pair([&](const JointDef& ends) { return world.create_revolute_joint(ends); });
    pair([&](const JointDef& ends) { return world.create_weld_joint(ends); });
    pair([&](const JointDef& ends) {
        PrismaticJointDef rail = ends;
        rail.axis = {0, 1};
        return world.create_prismatic_joint(rail);
    });
    for (int i = 0; i < 60 * 20; ++i) world.step(1.0f / 60);
    for (const Joint& joint : joints) CHECK(joint.separation() < 0.01f);
    for (const Body& body : world.bodies())
        if (body.type() == BodyType::dynamic_body) CHECK_FALSE(body.awake());
}

// Edits make gaps of meters. They close within a second, and leave no speed.
TEST_CASE("a joint between bodies that are meters apart soon holds them together") {
    const float apart = GENERATE(1.0f, 3.0f, 10.0f);
    World world({.gravity = {0, 0}});
    std::vector<Joint> joints;
    const auto pair = [&](auto join) {
        const float y = 4.0f * float(joints.size());
        Body a = add_box(world, {0, y}), b = add_box(world, {1 + apart, y});
        joints.push_back(join(JointDef{
            .body_a = a.id(), .body_b = b.id(), .anchor_a = {0.5f, 0}, .anchor_b = {-0.5f, 0}}));
    };
    pair([&](const JointDef& ends) { return world.create_revolute_joint(ends); });
    pair([&](const JointDef& ends) { return world.create_weld_joint(ends); });
    pair([&](const JointDef& ends) {
        DistanceJointDef rod = ends;
        rod.length = 0.1f;
        return world.create_distance_joint(rod);
    });
    const auto rail = [&](auto def) {
        def.axis = {0, 1};
        return def;
    };
    pair([&](const JointDef& ends) {
        return world.create_prismatic_joint(rail(PrismaticJointDef(ends)));
    });
    pair([&](const JointDef& ends) { return world.create_wheel_joint(rail(WheelJointDef(ends))); });
    for (int i = 0; i < 30; ++i) world.step(frame);
    for (const Joint& joint : joints) {
        CAPTURE(int(joint.type()));
        CHECK(joint.separation() < 0.01f);
        CHECK(joint.body_a().velocity().length() < 0.01f);
        CHECK(joint.body_b().velocity().length() < 0.01f);
    }
}

// A body that made whole turns while its joint did not act need not make them all back.
TEST_CASE("a joint that holds an angle counts no whole turns") {
    const float turned = GENERATE(0.5f, 3.0f, 6.0f, -20.0f, 60.0f);
    const bool soft = GENERATE(false, true);
    World world({.gravity = {0, 0}});
    Body welded = add_box(world, {0, 0}), sliding = add_box(world, {9, 0});
    WeldJoint weld =
        world.create_weld_joint({.body_b = welded.id(), .anchor_b = {0.2f, 0}, .enabled = false});
    PrismaticJoint rail = world.create_prismatic_joint(
        {.body_b = sliding.id(), .anchor_a = {9, 0}, .enabled = false, .axis = {0, 1}});
    if (soft) {
        weld.set_angular_hertz(3);
        weld.set_angular_damping_ratio(1);
    }
    weld.set_reference_angle(0);
    rail.set_reference_angle(0);
    welded.set_angle(turned);
    sliding.set_angle(turned);
    const float nearest = turned - std::remainder(turned, 2 * std::numbers::pi_v<float>);
    weld.set_enabled(true);
    rail.set_enabled(true);
    float fastest = 0;
    for (int i = 0; i < 120; ++i) {
        world.step(frame);
        fastest = std::max(fastest, std::abs(welded.angular_velocity()));
    }
    CHECK(fastest < 50);
    CHECK(welded.angle() == Approx(nearest).margin(0.02));
    CHECK(sliding.angle() == Approx(nearest).margin(0.02));
    CHECK(std::abs(weld.angle()) < 0.02f);
    CHECK(std::abs(rail.angle()) < 0.02f);
}

}  // namespace joint_test
