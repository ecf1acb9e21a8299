#include <fettle/physics/host_access.h>
#include <functional>
#include <memory>

#include "catch.h"
#include "every_method.h"

namespace handles_test {

// Handles and ids of no object, of a destroyed one, or of one in another world.

using namespace scenes;

namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

std::string message_of(const std::function<void()>& act) {
    try {
        act();
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "no error";
}

/// Every method of every handle says `what`.
void require_errors(Things& things, const std::string& what) {
    for (const Method& method : every_method()) {
        if (method.name.starts_with("World::")) continue;
        INFO(method.name);
        CHECK_THAT(message_of([&] { method.call(things); }), contains(what));
    }
    REQUIRE_FALSE(things.body.is_valid());
    REQUIRE_FALSE(things.circle.is_valid());
    REQUIRE_FALSE(things.joint.is_valid());
    REQUIRE_FALSE(things.field.is_valid());
}

using Create = std::function<void(World&, const JointDef&)>;

const std::vector<std::pair<std::string, Create>>& every_joint() {
    static const std::vector<std::pair<std::string, Create>> all = {
        {"distance", [](World& w, const JointDef& d) { w.create_distance_joint(d); }},
        {"revolute", [](World& w, const JointDef& d) { w.create_revolute_joint(d); }},
        {"prismatic", [](World& w, const JointDef& d) { w.create_prismatic_joint(d); }},
        {"wheel", [](World& w, const JointDef& d) { w.create_wheel_joint(d); }},
        {"weld", [](World& w, const JointDef& d) { w.create_weld_joint(d); }},
        {"motor", [](World& w, const JointDef& d) { w.create_motor_joint(d); }},
        {"pulley", [](World& w, const JointDef& d) { w.create_pulley_joint(d); }},
        {"gear", [](World& w, const JointDef& d) { w.create_gear_joint(d); }},
        {"groove", [](World& w, const JointDef& d) { w.create_groove_joint(d); }},
        {"pin slot", [](World& w, const JointDef& d) { w.create_pin_slot_joint(d); }},
        {"ratchet", [](World& w, const JointDef& d) { w.create_ratchet_joint(d); }},
        {"filter", [](World& w, const JointDef& d) { w.create_filter_joint(d); }},
        {"rotary limit", [](World& w, const JointDef& d) { w.create_rotary_limit_joint(d); }},
    };
    return all;
}

}  // namespace

TEST_CASE("every method of a default constructed handle reports that it names no object") {
    World world;
    Things nothing = {.world = world};
    require_errors(nothing, "names no");
    World* const no_world = nullptr;
    REQUIRE_THROWS_WITH(Body(no_world, {1, 5}).position(), contains("names no body"));
    REQUIRE_THROWS_WITH(Shape(no_world, {}).area(), contains("names no shape"));
}

TEST_CASE("every method of a stale handle reports that its object was destroyed") {
    World world;
    Things things = make_things(world);
    world.clear();
    require_errors(things, "was destroyed, or is of another world");
    Things later = make_things(world);  // in the same slots
    REQUIRE(later.body.is_valid());
    require_errors(things, "was destroyed, or is of another world");
}

TEST_CASE("every method of a handle reports that its world was destroyed") {
    auto world = std::make_unique<World>();
    Things things = make_things(*world);
    world.reset();
    require_errors(things, "does not exist any more: its world was destroyed");
    World later;  // it may be at the same address
    Things others = make_things(later);
    REQUIRE(others.body.is_valid());
    require_errors(things, "was destroyed");
}

TEST_CASE("a joint is not made of destroyed or missing bodies or of bodies of another world") {
    World world, other;
    Things things = make_things(world), others = make_things(other);
    Body gone = world.create_body();
    const BodyId stale = gone.id(), good = things.body.id(), foreign = others.third.id();
    gone.destroy();
    const uint32_t joints = world.joint_count();
    const auto refused = [&](const JointDef& def, const std::string& what) {
        for (const auto& [name, create] : every_joint()) {
            INFO(name << ": " << what);
            CHECK_THAT(message_of([&, &create = create] { create(world, def); }), contains(what));
        }
    };
    refused({.body_a = stale, .body_b = good}, "body_a: body");
    refused({.body_a = good, .body_b = stale}, "was destroyed, or is of another world");
    refused({.body_a = foreign, .body_b = good}, "body_a: body");
    refused({.body_a = good, .body_b = foreign}, "was destroyed, or is of another world");
    refused({.body_a = {7, 0}, .body_b = good}, "body_a: body 7 of generation 0");
    refused({.body_a = {123456, 78}, .body_b = good}, "body_a: body 123456");
    refused({}, "two different bodies");
    refused({.body_a = good, .body_b = good}, "two different bodies");
    const Vec2 wrong(not_a_number, 0);
    refused({.body_a = good, .body_b = things.third.id(), .anchor_a = wrong}, "anchor_a");
    refused({.body_a = good, .body_b = things.third.id(), .anchor_b = {infinity, 0}}, "anchor_b");
    REQUIRE_THROWS_WITH(world.create_mouse_joint({}), contains("body: a mouse joint drags a body"));
    REQUIRE_THROWS_WITH(world.create_mouse_joint({.body = stale}), contains("was destroyed"));
    REQUIRE_THROWS_WITH(world.create_mouse_joint({.body = foreign}), contains("of another world"));
    REQUIRE_THROWS_WITH(world.create_mouse_joint({.body = good, .target = wrong}),
                        contains("target"));
    REQUIRE_THROWS_WITH(world.create_mouse_joint({.body = good, .hertz = not_a_number}),
                        contains("hertz"));
    REQUIRE_THROWS_WITH(things.mouse.set_body({}), contains("drags a body"));
    for (const Body& body : {gone, others.third, Body(&world, foreign)}) {
        REQUIRE_THROWS(things.weld.set_body_a(body));
        REQUIRE_THROWS(things.gear.set_body_b(body));
        REQUIRE_THROWS(things.pulley.set_body_b(body));
        REQUIRE_THROWS(things.mouse.set_body(body));
        REQUIRE_THROWS(things.box.attach(body));
    }
    REQUIRE_THROWS_WITH(things.weld.set_body_a(others.third), contains("of the same world"));
    REQUIRE_THROWS_WITH(things.box.attach(others.third), contains("of the same world"));
    REQUIRE_THROWS_WITH(things.weld.set_body_a(things.weld.body_b()),
                        contains("a body other than the one at the other end"));
    REQUIRE(world.joint_count() == joints);
    REQUIRE_FALSE(world.validate());
    run(world, 0.2f);
}

TEST_CASE("an id of one world names nothing in any other") {
    World first;
    std::vector<Body> of_first;
    for (int i = 0; i < 50; ++i) of_first.push_back(add_ball(first, {float(i), 0}));
    World second, third;
    for (World* world : {&second, &third})
        for (int i = 0; i < 80; ++i) add_ball(*world, {float(i), 0});
    for (Body& body : of_first) {
        for (const World* world : {&second, &third}) {
            REQUIRE_FALSE(world->is_valid(body.id()));
            REQUIRE_FALSE(world->is_valid(body.shapes()[0].id()));
            REQUIRE_THROWS(world->body(body.id()).position());
        }
    }
    // A copy has the ids of what it was copied with, and none of what either makes later.
    World copy = first.clone();
    REQUIRE(copy.body(of_first[7].id()).position() == of_first[7].position());
    Body made = add_ball(first, {0, 9}), made_in_copy = add_ball(copy, {0, 9});
    REQUIRE(made.index() == made_in_copy.index());
    REQUIRE_FALSE(copy.is_valid(made.id()));
    REQUIRE_FALSE(first.is_valid(made_in_copy.id()));
    first.restore(copy);
    REQUIRE_FALSE(made.is_valid());
    REQUIRE(first.is_valid(made_in_copy.id()));
}

TEST_CASE("no restore lets two objects have the same slot and generation") {
    World world;
    const auto make = [](World& in) { return add_ball(in, {0, 0}); };
    Body old = make(world);
    const World early = world.clone();
    std::vector<std::byte> bytes;
    world.save(bytes);
    std::vector<BodyId> given = {old.id()};
    for (int round = 0; round < 20; ++round) {
        Body body = make(world);
        for (const BodyId& id : given) REQUIRE(body.id() != id);
        given.push_back(body.id());
        if (round % 3 == 0) world.restore(early);
        if (round % 3 == 1) world.restore(bytes);
        if (round % 3 == 2) {
            World other;
            other.restore(bytes);
            Body there = make(other);
            for (const BodyId& id : given) REQUIRE(there.id() != id);
            given.push_back(there.id());
            world.take(std::move(other));
            REQUIRE(world.is_valid(there.id()));
            REQUIRE(other.body_count() == 0);
            REQUIRE(make(other).is_valid());
            REQUIRE_FALSE(other.validate());
        }
        REQUIRE(old.is_valid());
    }
    world.take(std::move(world));
    REQUIRE(old.is_valid());
    REQUIRE_FALSE(world.validate());
}

TEST_CASE("the body that carries the bounds can be read and not edited") {
    World world({.bounds = Aabb{{-5, 0}, {5, 10}}});
    Body ball = add_ball(world, {0, 0.5f});
    world.step(frame);
    REQUIRE(world.contacts().size() == 1);
    const Contact contact = world.contacts()[0];
    const bool a_is_ball = contact.body_a == ball.id();
    Body border = world.body(a_is_ball ? contact.body_b : contact.body_a);
    Shape side = world.shape(a_is_ball ? contact.shape_b : contact.shape_a);
    REQUIRE(border.type() == BodyType::static_body);
    REQUIRE(side.type() == ShapeType::border);
    REQUIRE(side.body() == border);
    for (const Method& method : every_method()) {
        if (!method.edits || !method.name.starts_with("Body::") ||
            method.name == "Body::set_user_data")
            continue;
        Things things = {.world = world};
        things.body = border;
        INFO(method.name);
        CHECK_THAT(message_of([&] { method.call(things); }), contains("carries the bounds"));
    }
    REQUIRE_THROWS_WITH(side.destroy(), contains("set its bounds"));
    REQUIRE_THROWS_WITH(ball.shapes()[0].attach(border), contains("bounds of the world"));
    REQUIRE_THROWS_WITH(world.create_mouse_joint({.body = border.id()}), contains("bounds"));
    border.set_user_data(5);
    run(world, 0.5f);
    REQUIRE_FALSE(world.validate());
    REQUIRE(ball.position().y == Approx(0.5f).margin(0.01));
}

TEST_CASE("functions on shapes refuse destroyed shapes and shapes of another world") {
    World world, other;
    Things things = make_things(world);
    Shape gone = world.create_shape(Circle{}), foreign = other.create_shape(Circle{});
    const Shape disguised(&world, foreign.id());
    gone.destroy();
    for (const Shape& shape : {gone, Shape(), disguised}) {
        REQUIRE_THROWS_AS(distance(shape, things.circle), std::invalid_argument);
        REQUIRE_THROWS_AS(distance(things.circle, shape), std::invalid_argument);
        REQUIRE_THROWS_AS(world.query_overlap(shape), std::invalid_argument);
        REQUIRE_THROWS_AS(world.cast_shape(shape, {1, 0}), std::invalid_argument);
    }
}

TEST_CASE("an id of another world is refused in the same words by every function") {
    World world, other;
    Things things = make_things(world), others = make_things(other);
    const auto same_words = contains("was destroyed, or is of another world");
    REQUIRE_THROWS_WITH(world.body(others.body.id()).position(), same_words);
    REQUIRE_THROWS_WITH(world.shape(others.circle.id()).area(), same_words);
    REQUIRE_THROWS_WITH(world.ignore_until_separated(things.circle, others.circle), same_words);
    REQUIRE_THROWS_WITH(
        world.create_weld_joint({.body_a = things.body.id(), .body_b = others.body.id()}),
        same_words);
}

TEST_CASE("numbers that are not enumerators are refused") {
    World world;
    Body body = world.create_body();
    REQUIRE_THROWS_WITH(body.set_type(BodyType(7)), contains("type = 7"));
    REQUIRE_THROWS_WITH(world.create_body({.type = BodyType(3)}), contains("type = 3"));
    REQUIRE_THROWS_WITH(world.set_solver(Solver(9)), contains("solver = 9"));
    REQUIRE_THROWS_WITH(world.set_friction_mix(MixRule(5)), contains("friction_mix = 5"));
    REQUIRE_THROWS_WITH(world.set_restitution_mix(MixRule(99)), contains("restitution_mix"));
    REQUIRE_THROWS_WITH(World({.friction_mix = MixRule(77)}), contains("friction_mix"));
    REQUIRE_THROWS_WITH(World({.solver = Solver(77)}), contains("solver"));
    REQUIRE_THROWS_WITH(world.create_body({.center = Vec2(not_a_number, 0)}), contains("center"));
    REQUIRE_THROWS_WITH(world.create_body({.center = Vec2(0, not_a_number)}), contains("center"));
}

TEST_CASE("a MouseJoint handle of a joint of another type edits nothing") {
    World world;
    Things things = make_things(world);
    MouseJoint wrong = world.joint<MouseJoint>(things.wheel.id());
    const Position before = things.wheel.anchor_a();
    REQUIRE_THROWS_WITH(wrong.set_target({9, 9}), contains("expected a mouse joint, got a wheel"));
    REQUIRE_THROWS_WITH(wrong.set_anchor({9, 9}), contains("expected a mouse joint"));
    REQUIRE_THROWS_WITH(wrong.set_body(things.third), contains("expected a mouse joint"));
    REQUIRE(things.wheel.anchor_a() == before);
}

TEST_CASE("a mouse joint requires a body in every function that sets its bodies") {
    World world;
    Things things = make_things(world);
    Joint mouse = things.mouse;
    REQUIRE_THROWS_WITH(mouse.set_body_a(things.third), contains("body_a: a mouse joint"));
    REQUIRE_THROWS_WITH(mouse.set_body_b(Body()), contains("body: a mouse joint drags a body"));
    REQUIRE_THROWS_WITH(mouse.set_body_b(world.body({0, HostAccess::body_generation(world, 0)})),
                        contains("bounds of the world"));
    mouse.set_body_b(things.third);
    REQUIRE(things.mouse.body() == things.third);
}

TEST_CASE("writing to a slot that there is not is refused and writes nowhere") {
    World world;
    Body body = world.create_body();
    body.add(Circle{});
    world.step(0.01f);  // a body that was just made is refused, too
    const uint64_t before = world.hash();
    // Far behind the columns, so that a write there ends the program at once.
    for (const uint32_t slot : {1u << 28, ~0u}) {
        CHECK_FALSE(HostAccess::set_velocity(world, slot, {1, 1}));
        CHECK(HostAccess::write_velocity(world, slot, {1, 1}) == Written::refused);
        CHECK(HostAccess::write<BodyNumber::angular_velocity>(world, slot, 1) == Written::refused);
        CHECK(HostAccess::write<BodyNumber::torque>(world, slot, 1) == Written::refused);
        CHECK(HostAccess::write<BodyNumber::gravity_scale>(world, slot, 2) == Written::refused);
        CHECK(HostAccess::write<BodyNumber::linear_damping>(world, slot, 1) == Written::refused);
        CHECK(HostAccess::write<BodyNumber::angular_damping>(world, slot, 1) == Written::refused);
    }
    CHECK(world.hash() == before);
    CHECK(HostAccess::write_velocity(world, body.index(), {1, 1}) == Written::done);
}

TEST_CASE("reading a slot that there is not is an error") {
    World world;
    Body body = world.create_body({.position = {3, 4}});
    body.add(Circle{});
    const uint32_t slots = HostAccess::body_slots(world);
    CHECK(HostAccess::states(world).size() == slots);
    CHECK(HostAccess::previous_poses(world).size() == slots);
    CHECK(HostAccess::state(world, slots - 1).position == Position(3, 4));
    const auto message = contains("expected less than " + std::to_string(slots));
    for (const uint32_t slot : {slots, 1u << 28, ~0u}) {
        CHECK_THROWS_WITH(HostAccess::state(world, slot), message);
        CHECK_THROWS_WITH(HostAccess::previous(world, slot), message);
        CHECK_THROWS_WITH(HostAccess::mass(world, slot), message);
        CHECK_THROWS_WITH(HostAccess::velocity(world, slot), message);
        CHECK(HostAccess::body_generation(world, slot) == 0);
        CHECK(HostAccess::joint_generation(world, slot) == 0);
    }
    for (const uint32_t slot : {HostAccess::shape_slots(world), 1u << 28, ~0u})
        CHECK(HostAccess::shape_generation(world, slot) == 0);
}

TEST_CASE("a free slot can be read, and is not written") {
    World world;
    Body body = world.create_body(), other = world.create_body();
    for (Body each : {body, other}) each.add(Circle{});
    world.step(0.01f);
    const uint32_t slot = body.index();
    body.destroy();
    for (const bool stepped : {false, true}) {
        INFO(stepped);
        if (stepped) world.step(0.01f);
        CHECK(HostAccess::body_generation(world, slot) == 0);
        CHECK_FALSE(HostAccess::set_velocity(world, slot, {1, 1}));
        CHECK(HostAccess::write_velocity(world, slot, {1, 1}) == Written::refused);
        CHECK(HostAccess::write<BodyNumber::torque>(world, slot, 1) == Written::refused);
        CHECK_NOTHROW(HostAccess::mass(world, slot));
        CHECK_NOTHROW(HostAccess::velocity(world, slot));
        CHECK_FALSE(world.validate());
    }
}

TEST_CASE("messages contain counts as whole numbers") {
    World world;
    REQUIRE_THROWS_WITH(world.set_threads(2147483647),
                        "threads = 2147483647: expected a whole number from 1 to 64");
    REQUIRE_THROWS_WITH(world.set_substeps(-2147483647), contains("substeps = -2147483647"));
    for (const int width : {-1, 0, 3, 1 << 30})
        REQUIRE_THROWS_WITH(world.limit_simd_width(width),
                            contains("= " + std::to_string(width) + ": expected 4, 8 or 16"));
    for (const int width : {4, 8, 16}) REQUIRE_NOTHROW(world.limit_simd_width(width));
}
}  // namespace handles_test
