#include "catch.h"
#include "scenes.h"

namespace joint_readings_test {

// Readings of a joint: its separation, and its load above a threshold. Also its own stiffness.

using namespace scenes;

TEST_CASE("separation is the distance to where a joint should hold") {
    World world({.gravity = {0, 0}});
    Body a = world.create_body({.type = BodyType::static_body});
    Body b = add_box(world, {3, 0});
    const JointDef ends = {.body_a = a.id(), .body_b = b.id()};
    const auto pin = world.create_revolute_joint(
        {.body_a = a.id(), .body_b = b.id(), .lower_angle = -0.5f, .upper_angle = 0.5f});
    CHECK(pin.separation() == Approx(3));
    CHECK(pin.angular_separation() == 0);
    const auto rod =
        world.create_distance_joint({.body_a = a.id(), .body_b = b.id(), .length = 2.5f});
    CHECK(rod.separation() == Approx(0.5f));
    const auto rope = world.create_distance_joint(
        {.body_a = a.id(), .body_b = b.id(), .max_length = 2, .hertz = 0});
    CHECK(rope.separation() == Approx(1));
    const auto spring = world.create_distance_joint(
        {.body_a = a.id(), .body_b = b.id(), .length = 1.0f, .hertz = 2});
    CHECK(spring.separation() == 0);
    const auto rail = world.create_prismatic_joint(
        {.body_a = a.id(), .body_b = b.id(), .axis = {0, 1}, .lower_translation = 4});
    CHECK(rail.separation() == Approx(5));
    const auto wheel = world.create_wheel_joint(ends);
    CHECK(wheel.separation() == Approx(3));
    const auto weld = world.create_weld_joint(ends);
    CHECK(weld.separation() == Approx(3));
    const auto groove =
        world.create_groove_joint({.body_a = a.id(), .body_b = b.id(), .end = {2, 0}});
    CHECK(groove.separation() == Approx(1));
    const auto slot =
        world.create_pin_slot_joint({.body_a = a.id(), .body_b = b.id(), .axis = {0, 1}});
    CHECK(slot.separation() == Approx(3));
    const auto pulley = world.create_pulley_joint({.body_a = a.id(),
                                                   .body_b = b.id(),
                                                   .ground_a = {0, 1},
                                                   .ground_b = {3, 1},
                                                   .length = 1.5f});
    CHECK(pulley.separation() == Approx(0.5f));
    const auto gear = world.create_gear_joint({.body_a = a.id(), .body_b = b.id(), .ratio = 2});
    const auto ratchet = world.create_ratchet_joint(ends);
    const auto limit = world.create_rotary_limit_joint(
        {.body_a = a.id(), .body_b = b.id(), .lower_angle = 0, .upper_angle = 0.2f});
    b.set_angle(0.75f);
    CHECK(pin.angular_separation() == Approx(0.25f));
    CHECK(rail.angular_separation() == Approx(0.75f));
    CHECK(weld.angular_separation() == Approx(0.75f));
    CHECK(gear.angular_separation() == Approx(0.75f));
    CHECK(limit.angular_separation() == Approx(0.55f));
    CHECK(ratchet.angular_separation() == 0);
    for (const Joint& joint : world.joints()) {
        Joint(joint).disconnect();
        CHECK(joint.separation() == 0);
        CHECK(joint.angular_separation() == 0);
    }
}

TEST_CASE("a load above the threshold is reported in every step and the joint holds") {
    World world({.sleeping = false});
    Body box = add_box(world, {0, 0});
    const auto rod =
        world.create_distance_joint({.body_b = box.id(), .anchor_a = {0, 2}, .report_force = 12});
    run(world, 2.0f);
    CHECK(world.events().joint_loaded.empty());
    box.set_force({0, -5});
    run(world, 1.0f);
    for (int i = 0; i < 3; ++i) {
        world.step(frame);
        REQUIRE(world.events().joint_loaded.size() == 1);
        const JointLoadEvent& event = world.events().joint_loaded[0];
        CHECK(event.joint == rod.id());
        CHECK((event.body_a == BodyId()));  // the world
        CHECK(event.body_b == box.id());
        CHECK(event.force.y == Approx(15).epsilon(0.01));
    }
    CHECK_FALSE(rod.broken());
    CHECK(world.events().joint_broke.empty());
    CHECK(box.position().y == Approx(0).margin(0.01));
}

TEST_CASE("a torque above the threshold is reported") {
    World world({.sleeping = false});
    Body beam = world.create_body({.position = {2, 0}});
    beam.add(Box{.width = 4, .height = 0.2f});
    WeldJoint weld = world.create_weld_joint({.body_b = beam.id(), .anchor_b = {-2, 0}});
    run(world, 1.0f);
    weld.set_report_torque(1.05f * weld.torque());
    world.step(frame);
    CHECK(world.events().joint_loaded.empty());
    weld.set_report_torque(0.95f * weld.torque());
    world.step(frame);
    CHECK(world.events().joint_loaded.size() == 1);
}

TEST_CASE("a threshold changes no motion") {
    uint64_t hashes[2];
    for (const bool reports : {false, true}) {
        World world;
        Body before = world.create_body({.type = BodyType::static_body});
        for (int i = 0; i < 8; ++i) {
            Body link = add_box(world, {1.0f + float(i), 0}, 0.5f);
            RevoluteJoint pin = world.create_revolute_joint({.body_a = before.id(),
                                                             .body_b = link.id(),
                                                             .anchor_a = {0.5f, 0},
                                                             .anchor_b = {-0.5f, 0}});
            if (reports) pin.set_report_force(1);
            before = link;
        }
        run(world, 3.0f);
        hashes[reports] = world.hash();
        CHECK(world.events().joint_loaded.empty() != reports);
    }
    CHECK(hashes[0] == hashes[1]);
}

TEST_CASE("a joint with a stiffness of its own yields by that stiffness") {
    // The sag under a load falls with the square of the frequency.
    float sag[2];
    for (const int i : {0, 1}) {
        World world({.sleeping = false});
        Body box = add_box(world, {0, 0});
        const auto pin = world.create_revolute_joint({.body_b = box.id(),
                                                      .constraint_hertz = i == 0 ? 2.0f : 4.0f,
                                                      .constraint_damping_ratio = 1});
        run(world, 5.0f);
        sag[i] = pin.separation();
    }
    CHECK(sag[0] == Approx(10.0f / (12.566f * 12.566f)).epsilon(0.3));
    CHECK(sag[0] / sag[1] == Approx(4).epsilon(0.25));
}

TEST_CASE("the stiffness of one joint does not change the others") {
    World world({.sleeping = false});
    Body soft = add_box(world, {0, 0}), firm = add_box(world, {5, 0});
    RevoluteJoint tuned = world.create_revolute_joint({.body_b = soft.id()});
    const auto usual = world.create_revolute_joint({.body_b = firm.id(), .anchor_a = {5, 0}});
    run(world, 1.0f);
    const float before = usual.separation();
    CHECK(tuned.separation() == Approx(before).margin(1e-5));
    tuned.set_constraint_hertz(3);
    run(world, 5.0f);
    CHECK(tuned.separation() > 10 * before);
    CHECK(usual.separation() == Approx(before).margin(1e-5));
    tuned.set_constraint_hertz(0);
    run(world, 3.0f);
    CHECK(tuned.separation() == Approx(before).margin(1e-5));
}

TEST_CASE("thresholds and stiffness are part of a saved world") {
    World world;
    Body box = add_box(world, {0, 0});
    const auto pin = world.create_revolute_joint({.body_b = box.id(),
                                                  .report_force = 3,
                                                  .report_torque = 4,
                                                  .constraint_hertz = 5,
                                                  .constraint_damping_ratio = 6});
    std::vector<std::byte> bytes;
    world.save(bytes);
    World other;
    other.restore(bytes);
    const Joint restored = other.joint(pin.id());
    CHECK(restored.report_force() == 3);
    CHECK(restored.report_torque() == 4);
    CHECK(restored.constraint_hertz() == 5);
    CHECK(restored.constraint_damping_ratio() == 6);
    run(world, 0.3f);
    run(other, 0.3f);
    CHECK(world.hash() == other.hash());
    CHECK(world.events().joint_loaded.size() == 1);
}

}  // namespace joint_readings_test
