// Saved worlds: restored in place they go on bit for bit, and damaged bytes change nothing.

#include "saved_worlds.h"

#include <state/records.h>

#include <algorithm>
#include <array>
#include <bit>
#include <functional>
#include <limits>
#include <map>

namespace snapshot_test {

using namespace scenes;

namespace {

std::vector<uint64_t> hashes(World& world, int steps) {
    std::vector<uint64_t> all;
    for (int i = 0; i < steps; ++i) {
        world.step(frame);
        all.push_back(world.hash());
    }
    return all;
}

/// Saves after `before` steps, goes on, changes the world by `meddle`, restores it, goes on again:
/// both futures must be the same.
void check_restored(World& world, int before, int after,
                    const std::function<void(World&)>& meddle = {}) {
    for (int i = 0; i < before; ++i) world.step(frame);
    const auto bytes = saved(world);
    const auto expected = hashes(world, after);
    if (meddle) {
        meddle(world);
        for (int i = 0; i < 30; ++i) world.step(frame);
    }
    world.restore(bytes);
    REQUIRE_FALSE(world.validate());
    REQUIRE((saved(world) == bytes));
    REQUIRE(hashes(world, after) == expected);
    // And once more, into a world that has never seen any of it.
    World other;
    other.restore(bytes);
    REQUIRE(hashes(other, after) == expected);
    REQUIRE_FALSE(other.validate());
}

void build_stack(World& world) {
    add_floor(world);
    for (int i = 0; i < 10; ++i) add_box(world, {0.02f * float(i % 3), 0.5f + 1.01f * float(i)});
}

void build_tumbler(World& world) {
    Body drum = world.create_body({.position = {0, 10}});
    for (const Vec2& side : {Vec2(10, 0), Vec2(-10, 0)})
        drum.add(Box{.width = 1, .height = 20, .center = side}, {.density = 50});
    for (const Vec2& side : {Vec2(0, 10), Vec2(0, -10)})
        drum.add(Box{.width = 20, .height = 1, .center = side}, {.density = 50});
    RevoluteJoint hinge =
        world.create_revolute_joint({.body_b = drum.id(), .anchor_a = {0, 10}, .anchor_b = {0, 0}});
    hinge.set_motor_speed(0.43f);
    hinge.set_max_motor_torque(1e8f);
    for (int i = 0; i < 12; ++i)
        for (int k = 0; k < 12; ++k)
            add_box(world, {-5 + 0.8f * float(i), 4 + 0.8f * float(k)}, 0.5f);
    Body bob = add_ball(world, {3, 22});
    DistanceJoint rope =
        world.create_distance_joint({.body_b = bob.id(), .anchor_a = {0, 25}, .anchor_b = {0, 0}});
    rope.set_hertz(2);
    world.create_mouse_joint({.body = bob.id(), .target = {5, 22}});
}

void build_compounds(World& world) {
    add_floor(world);
    for (int i = 0; i < 40; ++i) {
        Body body = world.create_body(
            {.position = {float(i % 8) * 1.5f - 6, 2 + float(i / 8) * 2.3f}, .angle = 0.1f});
        body.add(Polygon{.vertices = {{-1, 0}, {0.5f, 1}, {0, 2}}, .rounding = 0.02f});
        body.add(Polygon{.vertices = {{1, 0}, {-0.5f, 1}, {0, 2}}}, {.restitution = 0.4f});
        if (i % 3 == 0) body.add(Circle{.radius = 0.3f}, {.rolling_resistance = 0.1f});
        if (i % 5 == 0) body.add(Segment{.from = {-1, 0}, .to = {1, 0}, .rounding = 0.1f});
    }
}

/// One of each type of joint, all of them moving, and one that is about to break.
void build_machine(World& world) {
    auto wheel = [&](float x, float y) {
        Body body = add_ball(world, {x, y}, 0.4f);
        world.create_revolute_joint({.body_b = body.id(), .anchor_a = {x, y}});
        return body;
    };
    Body driver = wheel(0, 0), driven = wheel(1, 0), pawl = wheel(3, 0);
    driver.set_torque(0.3f);
    pawl.set_torque(0.2f);
    world.create_gear_joint({.body_a = driver.id(), .body_b = driven.id()}).set_ratio(-0.7f);
    world.create_ratchet_joint({.body_b = pawl.id()}).set_tooth(0.4f);
    Body slider = add_box(world, {6, 0}), pin = add_ball(world, {9, 0}),
         ring = add_ball(world, {12, 0});
    PrismaticJoint rail = world.create_prismatic_joint({.body_b = slider.id(), .anchor_a = {6, 0}});
    rail.set_hertz(1.0f);
    rail.set_target_translation(1.0f);
    world.create_pin_slot_joint({.body_b = pin.id(), .anchor_a = {9, 0}}).set_axis({1, -1});
    world.create_groove_joint({.body_b = ring.id(), .anchor_a = {12, 0}}).set_end({14, -2});
    Body beam = add_box(world, {0, 6}, 0.5f), left = add_box(world, {-3, 6}),
         right = add_box(world, {3, 6});
    world
        .create_weld_joint({.body_a = beam.id(),
                            .body_b = left.id(),
                            .anchor_a = {-1.5f, 0},
                            .anchor_b = {1.5f, 0}})
        .set_angular_hertz(3.0f);
    MotorJoint motor = world.create_motor_joint({.body_b = beam.id(), .anchor_a = {0, 6}});
    motor.set_max_force(60.0f);
    motor.set_linear_velocity({0, 1});
    PulleyJoint pulley = world.create_pulley_joint({.body_a = beam.id(), .body_b = right.id()});
    pulley.set_ground_a({0, 12});
    pulley.set_ground_b({3, 12});
    pulley.set_length(12.0f);
    Body cart = add_box(world, {-8, 1}), roll = add_ball(world, {-8, 0.3f}, 0.3f);
    world.create_wheel_joint({.body_a = cart.id(), .body_b = roll.id(), .anchor_a = {0, -0.7f}})
        .set_max_motor_torque(1.0f);
    DistanceJoint thread = world.create_distance_joint({.body_b = left.id(), .anchor_a = {-3, 9}});
    thread.set_break_force(9.0f);
    world.create_field({.force = BuoyancyField{.level = -1.0f}});
    world.create_field({.force = WindField{}, .region = Aabb{{-12, -2}, {-4, 8}}});
    world.create_field({.force = AttractorField{.center = {7, 3}, .strength = 3.0f}});
    world.create_field({.force = DragField{.linear = 0.2f}}).destroy();
    world.set_friction_mix(MixRule::average);
}

}  // namespace

TEST_CASE("a restored stack goes on bit for bit") {
    World world;
    build_stack(world);
    check_restored(world, 40, 200);
}

TEST_CASE("a restored tumbler with joints goes on bit for bit") {
    World world;
    build_tumbler(world);
    check_restored(world, 120, 240);
}

TEST_CASE("a restored machine of all types of joints goes on bit for bit") {
    World world({.bounds = Aabb{{-20, -4}, {20, 20}}});
    build_machine(world);
    check_restored(world, 3, 300, [](World& changed) {
        for (Joint& joint : changed.joints()) {
            joint.set_broken(!joint.broken());
            joint.set_anchor_b({0.3f, 0.1f});
        }
        changed.joints().back().destroy();
        changed.fields().front().destroy();
        changed.create_field({.force = DragField{.linear = 3.0f}});
    });
    bool broke = false;
    for (const Joint& joint : world.joints()) broke |= joint.broken();
    REQUIRE(broke);
}

TEST_CASE("restored compounds go on bit for bit") {
    World world;
    build_compounds(world);
    check_restored(world, 90, 240);
}

TEST_CASE("restored sleeping bodies stay asleep and wake as in the original world") {
    World world;
    build_stack(world);
    run(world, 6.0f);
    REQUIRE(world.statistics().awake_bodies == 0);
    add_ball(world, {0.3f, 30.0f});  // comes down on them later
    check_restored(world, 10, 400);
}

TEST_CASE("bodies made and deleted since make no difference to a restored world") {
    World world({.bounds = Aabb{{-20, 0}, {20, 60}}});
    build_compounds(world);
    check_restored(world, 60, 200, [](World& w) {
        auto bodies = w.bodies();
        for (size_t i = 1; i < bodies.size(); i += 2) bodies[i].destroy();
        for (int i = 0; i < 70; ++i) add_ball(w, {float(i % 7), 20 + float(i)});
        w.set_gravity({3, -5});
    });
}

TEST_CASE("fast bodies and bullets go on bit for bit") {
    World world({.bounds = Aabb{{-20, 0}, {20, 60}}, .bounds_restitution = 1.0f});
    build_stack(world);
    for (int i = 0; i < 6; ++i) {
        Body ball = add_ball(world, {-15, 5 + float(i)}, 0.2f, {.restitution = 1});
        ball.set_bullet(i % 2 == 0);
        ball.set_velocity({150, 10});
    }
    check_restored(world, 20, 200);
}

TEST_CASE("edits that wait for the next step are part of a saved world") {
    World world;
    build_compounds(world);
    run(world, 1.0f);
    world.bodies()[3].shapes()[0].set_vertices(std::vector<Vec2>{{0, 0}, {2, 0}, {0, 1}});
    world.bodies()[5].set_position({0, 12});
    world.bodies()[7].apply_force({100, 0});
    world.bodies()[9].set_mass(infinity);
    check_restored(world, 0, 120);
}

TEST_CASE(
    "a restore makes handles to living objects valid again and later handles invalid forever") {
    World world;
    add_floor(world);
    Body kept = add_ball(world, {0, 5});
    Body lost = add_box(world, {3, 5});
    Shape part = lost.shapes()[0];
    const auto bytes = saved(world);

    lost.destroy();
    Body later = add_ball(world, {6, 5});  // in the slot of `lost`
    REQUIRE(later.index() == lost.index());
    run(world, 0.5f);
    world.restore(bytes);
    REQUIRE(kept.is_valid());
    REQUIRE(lost.is_valid());
    REQUIRE(part.is_valid());
    REQUIRE(part.body() == lost);
    REQUIRE_FALSE(later.is_valid());

    Body other = add_ball(world, {6, 5});
    REQUIRE(other.id() != later.id());
    REQUIRE_FALSE(later.is_valid());
    lost.destroy();
    Body again = add_ball(world, {6, 5});
    REQUIRE(again.index() == later.index());
    REQUIRE_FALSE(later.is_valid());
    REQUIRE_FALSE(lost.is_valid());
}

TEST_CASE("assigning an older world does not give its generations twice") {
    World world;
    const World before = world.clone();
    Body first = add_ball(world, {0, 0});
    world.restore(before);
    Body second = add_ball(world, {0, 0});
    REQUIRE(second.is_valid());
    REQUIRE_FALSE(first.is_valid());
}

TEST_CASE("bytes that end early or are not a saved world change nothing") {
    World world;
    build_tumbler(world);
    run(world, 1.0f);
    const auto bytes = saved(world);
    World target;
    build_stack(target);
    run(target, 0.3f);
    const auto before = saved(target);
    for (size_t size = 0; size < bytes.size(); size += 1 + size / 9) {
        const std::span<const std::byte> part(bytes.data(), size);
        REQUIRE_THROWS_AS(target.restore(part), std::invalid_argument);
    }
    auto longer = bytes;
    longer.push_back(std::byte{0});
    REQUIRE_THROWS_AS(target.restore(longer), std::invalid_argument);
    auto other = bytes;
    other[4] = std::byte{99};
    REQUIRE_THROWS_AS(target.restore(other), std::invalid_argument);
    REQUIRE((saved(target) == before));
    run(target, 0.3f);
    REQUIRE_FALSE(target.validate());
}

TEST_CASE("flipped bits are refused or leave a world that can be stepped") {
    World world({.bounds = Aabb{{-20, 0}, {20, 60}}});
    build_tumbler(world);
    build_stack(world);
    run(world, 1.0f);
    check_flipped_bits(saved(world), 1, 400, [](World&) {});
}

TEST_CASE(
    "a saved world in which two bodies share a list of shapes or contacts or joints is refused") {
    constexpr uint64_t mark = 0xfe77'1e00'b0d1'e500;
    World world;
    add_floor(world);
    for (const uint64_t i : {0, 1}) {
        const float x = 0.9f * static_cast<float>(i);
        Body ball = world.create_body({.position = {x, 0.4f}, .user_data = mark + i});
        ball.add(Circle{.radius = 0.5f});
        world.create_revolute_joint({.body_b = ball.id(), .anchor_a = {x, 0.4f}});
    }
    run(world, 0.2f);
    const auto bytes = saved(world);
    World target;
    REQUIRE_NOTHROW(target.restore(bytes));
    const size_t first = place_of(mark, bytes), second = place_of(mark + 1, bytes);
    using detail::BodyRecord;
    const size_t own = place_in<BodyRecord>([](BodyRecord& body) { body.user_data = 1; });
    const auto refuses_shared = [&](uint32_t detail::BodyLists::*member, const char* what) {
        INFO(what);
        auto damaged = bytes;
        const size_t at = place_in<BodyRecord>([&](BodyRecord& body) { body.lists.*member = 0; }) -
                          own;  // may wrap
        std::memcpy(&damaged[second + at], &bytes[first + at], sizeof(uint32_t));
        REQUIRE((damaged != bytes));
        detail::write_checksum(damaged);
        REQUIRE_THROWS_WITH(target.restore(damaged), contains(what));
    };
    refuses_shared(&detail::BodyLists::first_shape, "is listed in another body");
    refuses_shared(&detail::BodyLists::first_contact, "has a broken list of contacts");
    refuses_shared(&detail::BodyLists::first_joint, "has a broken list of joints");
    run(target, 0.2f);
    REQUIRE_FALSE(target.validate());
}

TEST_CASE("a saved shape with another number of vertices than its type has is refused") {
    constexpr uint64_t mark = 0xfe77'1e00'5e17'1ce5;
    World world;
    add_ball(world, {0, 3}, 0.5f, {.user_data = mark});
    auto bytes = saved(world);
    World target;
    REQUIRE_NOTHROW(target.restore(bytes));
    using detail::ShapeRecord;
    const size_t own = place_in<ShapeRecord>([](ShapeRecord& s) { s.surface.user_data = 1; });
    const size_t type = place_in<ShapeRecord>([](ShapeRecord& s) { s.type = ShapeType::box; });
    bytes[place_of(mark, bytes) - own + type] = static_cast<std::byte>(ShapeType::box);
    detail::write_checksum(bytes);
    REQUIRE_THROWS_WITH(target.restore(bytes), contains("the form of a shape"));
}

TEST_CASE("a saved world whose awake shape has no proxy in the broad phase is refused") {
    constexpr uint64_t mark = 0xfe77'1e00'5ca1'ab1e;
    World world;
    add_floor(world);
    Body ball = add_ball(world, {0, 3}, 0.5f, {.user_data = mark});
    run(world, 0.2f);
    REQUIRE(ball.awake());
    auto bytes = saved(world);
    World target;
    REQUIRE_NOTHROW(target.restore(bytes));
    using detail::ShapeRecord;
    const size_t own = place_in<ShapeRecord>([](ShapeRecord& s) { s.surface.user_data = 1; });
    const size_t at = place_of(mark, bytes) - own +
                      place_in<ShapeRecord>([](ShapeRecord& shape) { shape.proxy = 0; });
    int32_t proxy = -1;
    std::memcpy(&proxy, &bytes[at], sizeof proxy);
    REQUIRE(proxy >= 0);
    proxy = -1;
    std::memcpy(&bytes[at], &proxy, sizeof proxy);
    detail::write_checksum(bytes);
    REQUIRE_THROWS_WITH(target.restore(bytes), contains("the proxy of an awake shape"));
    run(target, 0.2f);
    REQUIRE_FALSE(target.validate());
}

TEST_CASE("a saved world is refused where the flag of an optional is not a bool") {
    World world({.bounds = Aabb{{-20, 0}, {20, 60}}});
    Body ball = world.create_body({.position = {0, 3}, .mass = 5.0f});
    ball.add(Circle{});
    run(world, 0.2f);
    auto bytes = saved(world);
    World target;
    REQUIRE_NOTHROW(target.restore(bytes));
    // The settings are the first thing behind the header.
    std::byte& flag = bytes[sizeof(detail::SavedHeader) +
                            place_in<WorldDef>([](WorldDef& def) { def.bounds = Aabb(); })];
    REQUIRE(flag == std::byte{1});
    flag = std::byte{2};
    detail::write_checksum(bytes);
    REQUIRE_THROWS_WITH(target.restore(bytes), contains("a flag is neither 0 nor 1"));
    REQUIRE(target.hash() == world.hash());
}

TEST_CASE("a saved world with a number that no setter takes is refused") {
    World world;
    Body ball = add_ball(world, {0, 3}, 0.5f);
    RevoluteJoint hinge = world.create_revolute_joint({.body_b = ball.id(), .anchor_a = {0, 5}});
    float distinct = 0.37125f;
    std::map<std::string, float> numbers;
    const auto given = [&](const char* name) { return numbers[name] = distinct += 0.0625f; };
    ball.shapes()[0].set_density(given("density"));
    ball.set_torque(given("torque"));
    ball.set_linear_damping(given("linear_damping"));
    ball.shapes()[0].set_friction(given("friction"));
    hinge.set_break_force(given("break_force"));
    hinge.set_break_torque(given("break_torque"));
    hinge.set_lower_angle(-given("upper_angle"));
    numbers["lower_angle"] = -numbers["upper_angle"];
    hinge.set_upper_angle(given("upper_angle"));
    hinge.set_motor_speed(given("motor_speed"));
    hinge.set_max_motor_torque(given("max_motor_torque"));
    hinge.set_hertz(given("hertz"));
    hinge.set_damping_ratio(given("damping_ratio"));
    hinge.set_target_angle(given("target_angle"));
    const auto bytes = saved(world);
    World target;
    REQUIRE_NOTHROW(target.restore(bytes));
    for (const auto& [name, number] : numbers) {
        CAPTURE(name);
        const auto pattern = std::bit_cast<std::array<std::byte, sizeof number>>(number);
        const auto place = std::search(bytes.begin(), bytes.end(), pattern.begin(), pattern.end());
        REQUIRE((place != bytes.end()));
        auto damaged = bytes;
        const float nan = std::numeric_limits<float>::quiet_NaN();
        std::memcpy(&damaged[size_t(place - bytes.begin())], &nan, sizeof nan);
        detail::write_checksum(damaged);
        CHECK_THROWS_WITH(target.restore(damaged), contains("damaged"));
        CHECK(target.hash() == world.hash());
    }
}

TEST_CASE("a saved field whose flags are not bools is refused") {
    constexpr uint64_t mark = 0xfe77'1e00'f1e1'd000;
    World world;
    world.create_field({.force = WindField{}, .region = Aabb{{-2, 0}, {2, 6}}, .user_data = mark});
    world.create_field({}).destroy();
    const auto bytes = saved(world);
    World target;
    REQUIRE_NOTHROW(target.restore(bytes));
    const size_t begin =
        place_of(mark, bytes) - place_in<FieldDef>([](FieldDef& field) { field.user_data = 1; });
    for (const size_t flag : {place_in<FieldDef>([](FieldDef& field) { field.enabled = false; }),
                              place_in<FieldDef>([](FieldDef& field) { field.region = Aabb(); })}) {
        auto damaged = bytes;
        REQUIRE(damaged[begin + flag] == std::byte{1});
        damaged[begin + flag] = std::byte{3};
        detail::write_checksum(damaged);
        REQUIRE_THROWS_WITH(target.restore(damaged), contains("a flag is neither 0 nor 1"));
        // The same in the free slot behind it, of which there is a list.
        damaged = bytes;
        damaged[begin + detail::encoded_size<detail::FieldRecord>() + flag] = std::byte{16};
        detail::write_checksum(damaged);
        REQUIRE_THROWS_WITH(target.restore(damaged), contains("a flag is neither 0 nor 1"));
    }
}

TEST_CASE("a saved joint of no type is refused") {
    constexpr uint64_t mark = 0xfe77'1e00'0707'7000;
    World world;
    Body ball = add_ball(world, {0, 3});
    world.create_distance_joint({.body_b = ball.id(), .user_data = mark});
    using detail::JointRecord;
    const size_t own = place_in<JointRecord>([](JointRecord& joint) { joint.user_data = 1; });
    const size_t place =
        place_in<JointRecord>([](JointRecord& joint) { joint.type = JointType::distance; });
    const auto with_type = [&](unsigned type) {
        auto bytes = saved(world);
        bytes[place_of(mark, bytes) - own + place] = std::byte(type);
        detail::write_checksum(bytes);
        return bytes;
    };
    World target;
    REQUIRE_NOTHROW(target.restore(with_type(unsigned(JointType::distance))));
    for (const unsigned type : {unsigned(detail::joint_type_count), 97u, 255u})
        REQUIRE_THROWS_WITH(target.restore(with_type(type)), contains("a joint"));
}

TEST_CASE("any motion of bodies at the greatest angle can be saved") {
    World world({.gravity = {0, 0}});
    Body wall = world.create_body({.type = BodyType::static_body});
    wall.add(Box{.width = 1, .height = 2000});
    std::vector<Body> fast;
    for (int i = 0; i < 200; ++i) {
        // Each turns back by another part of a turn when the wall stops it.
        Body body = world.create_body({.position = {-3, float(4 * i - 400)},
                                       .angle = 1e8f,
                                       .velocity = {200, 0},
                                       .angular_velocity = -150.0f - 2.0f * float(i),
                                       .bullet = i % 2 == 0});
        body.add(Box{.width = 0.1f, .height = 1});
        fast.push_back(body);
    }
    for (int step = 0; step < 4; ++step) {
        world.step(frame);
        for (const Body& body : fast) REQUIRE(std::fabs(body.angle()) <= 1e8f);
        World other;
        CHECK_NOTHROW(other.restore(saved(world)));
    }
}

}  // namespace snapshot_test
