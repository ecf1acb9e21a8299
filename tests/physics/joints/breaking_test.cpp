#include "catch.h"
#include "scenes.h"

namespace breaking_test {

using namespace scenes;

TEST_CASE("a joint breaks at its force and not below") {
    World world({.sleeping = false});
    Body box = add_box(world, {0, 0});
    DistanceJoint rod = world.create_distance_joint({.body_b = box.id(), .anchor_a = {0, 2}});
    rod.set_break_force(12.0f);
    box.set_force({0, -1.9f});  // 11.9 N with its weight
    run(world, 3.0f);
    REQUIRE_FALSE(rod.broken());
    REQUIRE(world.events().joint_broke.empty());
    box.set_force({0, -2.1f});
    run(world, 0.5f);
    REQUIRE(rod.broken());
    REQUIRE(rod.is_valid());
    REQUIRE(box.velocity().y < -3.0f);
    REQUIRE(rod.force().length() == 0.0f);
}

TEST_CASE("a broken joint is reported with its load and can be repaired") {
    World world({.sleeping = false});
    Body beam = world.create_body({.position = {2, 0}});
    beam.add(Box{.width = 4, .height = 0.2f});
    WeldJoint weld = world.create_weld_joint({.body_b = beam.id(), .anchor_b = {-2, 0}});
    run(world, 1.0f);
    const float moment = weld.torque();
    weld.set_break_torque(1.05f * moment);
    run(world, 1.0f);
    REQUIRE_FALSE(weld.broken());
    weld.set_break_torque(0.95f * moment);
    world.step(frame);
    REQUIRE(world.events().joint_broke.size() == 1);
    const JointBreakEvent& event = world.events().joint_broke[0];
    REQUIRE(event.joint == weld.id());
    REQUIRE((event.body_a == BodyId()));  // the world
    REQUIRE(event.body_b == beam.id());
    REQUIRE(event.torque == Approx(moment).epsilon(0.01));
    REQUIRE(event.force.y == Approx(10.0f * beam.mass()).epsilon(0.01));
    world.step(frame);
    REQUIRE(world.events().joint_broke.empty());
    beam.set_pose({{2, 0}, 0});
    beam.set_velocity({0, 0});
    beam.set_angular_velocity(0);
    weld.set_break_torque(infinity);
    weld.set_broken(false);
    run(world, 1.0f);
    REQUIRE(std::fabs(beam.position().y) < 0.01f);
    REQUIRE_FALSE(world.validate());
}

TEST_CASE("an impact within one step breaks a joint that holds the weight forever") {
    World world({.sleeping = false});
    Body box = add_box(world, {0, 0});
    RevoluteJoint pin = world.create_revolute_joint({.body_b = box.id()});
    pin.set_break_force(30.0f);
    run(world, 2.0f);
    REQUIRE_FALSE(pin.broken());
    box.apply_impulse({2, 0});  // 120 N over a step
    world.step(frame);
    REQUIRE(pin.broken());
}

TEST_CASE("an impact that goes through a joint breaks it by its impulse") {
    // 4 kg at 10 m/s above the joint stop within a step: 2400 N.
    for (const float restitution : {0.0f, 0.5f}) {
        const float impulse = 4.0f * 10.0f * (1.0f + restitution);
        for (const float part : {0.9f, 1.1f}) {
            World world({.gravity = {0, 0}});
            Body ground = world.create_body({.type = BodyType::static_body});
            ground.add(Box{.width = 20, .height = 2, .center = {0, -1}},
                       {.restitution = restitution});
            Body low = add_box(world, {0, 0.501f}), high = add_box(world, {0, 1.501f});
            high.set_mass(4);
            for (Body body : {low, high}) body.set_velocity({0, -10});
            WeldJoint weld = world.create_weld_joint({.body_a = low.id(),
                                                      .body_b = high.id(),
                                                      .anchor_a = {0, 0.5f},
                                                      .anchor_b = {0, -0.5f}});
            weld.set_break_force(part * impulse / frame);
            float most = 0.0f;
            for (int i = 0; i < 10; ++i) {
                world.step(frame);
                for (const JointBreakEvent& event : world.events().joint_broke)
                    most = std::max(most, event.force.length());
            }
            CAPTURE(restitution, part, most * frame, impulse);
            CHECK(weld.broken() == (part < 1.0f));
        }
    }
}

TEST_CASE("the parts of a broken joint collide again") {
    World world({.gravity = {0, 0}, .sleeping = false});
    Body a = add_box(world, {0, 0}), b = add_box(world, {0.5f, 0});
    WeldJoint weld = world.create_weld_joint(
        {.body_a = a.id(), .body_b = b.id(), .anchor_a = {0.25f, 0}, .anchor_b = {-0.25f, 0}});
    run(world, 1.0f);
    REQUIRE((b.position() - a.position()).length() == Approx(0.5f).margin(0.01));
    weld.set_broken(true);
    run(world, 2.0f);
    REQUIRE((b.position() - a.position()).length() > 0.95f);
    REQUIRE_FALSE(world.validate());
}

TEST_CASE("a sleeping joint is not computed and carries its load at once when it wakes") {
    World world;
    add_floor(world);
    Body box = add_box(world, {0, 3});
    RevoluteJoint pin = world.create_revolute_joint(
        {.body_b = box.id(), .anchor_a = {0, 3.5f}, .anchor_b = {0, 0.5f}});
    run(world, 3.0f);
    REQUIRE_FALSE(box.awake());
    REQUIRE(pin.force().y == Approx(10.0f).epsilon(0.02));
    REQUIRE(world.statistics().awake_joints == 0);
    World twin = world.clone();
    box.set_awake(true);
    world.step(frame);
    REQUIRE(world.statistics().awake_joints == 1);
    REQUIRE(std::fabs(box.velocity().y) < 0.001f);  // warm started: it does not sag
    REQUIRE_FALSE(world.validate());
    REQUIRE_FALSE(twin.validate());
}

}  // namespace breaking_test
