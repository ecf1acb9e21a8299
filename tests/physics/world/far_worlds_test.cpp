// With FETTLE_PHYSICS_DOUBLE, a scene far from the origin behaves as it does at the origin.

#include "catch.h"

#include <fettle/physics/mover.h>
#include <fettle/physics/physics.h>

#ifdef FETTLE_PHYSICS_DOUBLE

#include <cmath>
#include <functional>
#include <vector>

namespace far_worlds_test {
namespace {

using namespace fettle::physics;

constexpr float dt = 1.0f / 60;
/// 10⁷ m from the origin, and no multiple of what a float resolves there.
constexpr Position far_away = {10000000.3, -10000000.7};

/// Builds a scene around a point.
using Build = std::function<void(World&, const Position& origin)>;

World built(const Build& build, const Position& origin) {
    World world;
    build(world, origin);
    return world;
}
void run(World& world, int steps) {
    for (int i = 0; i < steps; ++i) world.step(dt);
}

/// The largest difference between the places (m) and the angles (rad) of the bodies of a scene that
/// runs at the origin and far away.
float difference(const Build& build, int steps) {
    World near = built(build, {}), far = built(build, far_away);
    run(near, steps);
    run(far, steps);
    const std::vector<Body> here = near.bodies(), there = far.bodies();
    REQUIRE(here.size() == there.size());
    float most = 0.0f;
    for (size_t i = 0; i < here.size(); ++i) {
        const Vec2 a = here[i].position() - Position(), b = there[i].position() - far_away;
        most = std::max({most, (a - b).length(), std::fabs(here[i].angle() - there[i].angle())});
    }
    return most;
}

Body ground(World& world, const Position& origin) {
    Body body = world.create_body({.type = BodyType::static_body, .position = origin});
    body.add(Box{.width = 200, .height = 2, .center = {0, -1}});
    return body;
}
Body box(World& world, const Position& at, float size = 1.0f) {
    Body body = world.create_body({.position = at});
    body.add(Box{.width = size, .height = size}, {.friction = 0.6f});
    return body;
}

void stack(World& world, const Position& origin) {
    ground(world, origin);
    for (int i = 0; i < 12; ++i) box(world, origin + Vec2(0.0f, 0.5f + 1.0f * float(i)));
}

/// A trunk with four limbs, with limits.
void ragdoll(World& world, const Position& origin) {
    ground(world, origin);
    Body trunk = world.create_body({.position = origin + Vec2(0, 2), .angle = 0.4f});
    trunk.add(Segment{{0, -0.4f}, {0, 0.4f}, 0.15f});
    for (int i = 0; i < 4; ++i) {
        const Vec2 at(i % 2 == 0 ? -0.15f : 0.15f, i < 2 ? 0.4f : -0.4f);
        Body limb = world.create_body({.position = trunk.world_point(at)});
        limb.add(Segment{{0, 0}, {at.x * 2, -0.5f}, 0.06f});
        world.create_revolute_joint({.body_a = trunk.id(),
                                     .body_b = limb.id(),
                                     .anchor_a = at,
                                     .lower_angle = -1.0f,
                                     .upper_angle = 1.0f,
                                     .max_motor_torque = 0.5f});
    }
}

void car(World& world, const Position& origin) {
    ground(world, origin);
    Body chassis = world.create_body({.position = origin + Vec2(0, 1)});
    chassis.add(Box{.width = 2, .height = 0.5f});
    for (const float x : {-0.8f, 0.8f}) {
        Body wheel = world.create_body({.position = origin + Vec2(x, 0.4f)});
        wheel.add(Circle{.radius = 0.4f}, {.friction = 1});
        world.create_wheel_joint({.body_a = chassis.id(),
                                  .body_b = wheel.id(),
                                  .anchor_a = Vec2(x, -0.6f),
                                  .hertz = 4,
                                  .damping_ratio = 0.7f,
                                  .motor_speed = -6,
                                  .max_motor_torque = 20});
    }
}

/// Every joint, some of them tied to the world.
void joints(World& world, const Position& origin) {
    const auto hung = [&](float x) { return box(world, origin + Vec2(x, -1.0f), 0.5f); };
    const auto at = [&](float x) { return origin + Vec2(x, 0.0f); };
    world.create_revolute_joint(
        {.body_b = hung(0).id(), .anchor_a = at(0), .anchor_b = Vec2(0.3f, 1)});
    world.create_distance_joint(
        {.body_b = hung(5).id(), .anchor_a = at(5.5f), .length = 1.2f, .hertz = 2});
    world.create_prismatic_joint({.body_b = hung(10).id(),
                                  .anchor_a = at(10),
                                  .axis = {1, 1},
                                  .lower_translation = -2,
                                  .upper_translation = 2});
    world.create_wheel_joint({.body_b = hung(15).id(), .anchor_a = at(15), .hertz = 1});
    world.create_weld_joint({.body_b = hung(20).id(), .anchor_a = at(20), .hertz = 3});
    world.create_mouse_joint({.body = hung(25).id(), .target = at(26), .max_force = 1000});
    world.create_groove_joint(
        {.body_b = hung(30).id(), .anchor_a = at(29.5f), .end = at(31) + Vec2(0, -1)});
    world.create_pulley_joint({.body_a = hung(35).id(),
                               .body_b = box(world, at(37) + Vec2(0, -2)).id(),
                               .ground_a = at(35),
                               .ground_b = at(37)});
    Body post = world.create_body({.type = BodyType::static_body, .position = at(40)});
    world.create_pin_slot_joint({.body_a = post.id(), .body_b = hung(40).id(), .axis = {1, -1}});
    world.create_motor_joint({.body_a = post.id(),
                              .body_b = hung(45).id(),
                              .max_force = 200,
                              .max_torque = 200,
                              .linear_offset = {4, 1}});
}

void bullets(World& world, const Position& origin) {
    Body wall = world.create_body({.type = BodyType::static_body, .position = origin});
    wall.add(Box{.width = 0.05f, .height = 20});
    Body door = world.create_body({.type = BodyType::kinematic_body,
                                   .position = origin + Vec2(-6, 0),
                                   .angular_velocity = 3});
    door.add(Box{.width = 0.05f, .height = 4});
    for (int i = 0; i < 8; ++i) {
        Body shot = world.create_body({.position = origin + Vec2(-20, float(i) - 4),
                                       .velocity = {400, 0},
                                       .bullet = i % 2 == 0});
        shot.add(Circle{.radius = 0.05f}, {.restitution = 0.3f});
    }
}

void chain(World& world, const Position& origin) {
    Body hills = world.create_body({.type = BodyType::static_body, .position = origin});
    std::vector<Vec2> points;
    for (int i = 40; i >= -40; --i)
        points.push_back({0.5f * float(i), 0.02f * float(i * i) * 0.25f});
    hills.add(Chain{.points = points});
    for (int i = 0; i < 6; ++i) {
        Body ball = world.create_body({.position = origin + Vec2(3.0f * float(i) - 8.0f, 4)});
        if (i % 2 == 0)
            ball.add(Circle{.radius = 0.3f});
        else
            ball.add(Ellipse{.radius_x = 0.5f, .radius_y = 0.3f});
    }
}

}  // namespace

TEST_CASE("a stack far away rests and sleeps as at the origin") {
    World far = built(stack, far_away);
    run(far, 300);
    const std::vector<Body> boxes = far.bodies();
    for (size_t i = 1; i < boxes.size(); ++i) {
        CHECK_FALSE(boxes[i].awake());
        const Vec2 place = boxes[i].position() - (far_away + Vec2(0, float(i) - 0.5f));
        CHECK(std::fabs(place.x) < 0.001f);
        CHECK(std::fabs(place.y) < 0.03f);
    }
    CHECK(difference(stack, 300) < 1e-4f);
}

TEST_CASE("ragdolls and cars and joints and chains far away move as at the origin") {
    CHECK(difference(ragdoll, 25) < 1e-3f);
    CHECK(difference(car, 120) < 1e-3f);
    CHECK(difference(joints, 60) < 1e-3f);
    CHECK(difference(chain, 60) < 1e-3f);
    // And they come to rest.
    World world = built(ragdoll, far_away);
    run(world, 1200);
    for (const Body& body : world.bodies())
        CHECK((body.type() == BodyType::static_body || !body.awake()));
}

TEST_CASE("fast bodies far away are stopped as at the origin") {
    CHECK(difference(bullets, 30) < 1e-3f);
    World world = built(bullets, far_away);
    run(world, 30);
    for (const Body& body : world.bodies())
        if (body.type() == BodyType::dynamic_body) CHECK((body.position() - far_away).x < 0.0f);
}

TEST_CASE("bounds far away hold bodies") {
    World world({.bounds = Aabb{far_away + Vec2(-5, 0), far_away + Vec2(5, 10)}});
    Body resting = box(world, far_away + Vec2(0, 2));
    Body ball = world.create_body({.position = far_away + Vec2(2, 3), .velocity = {300, 100}});
    ball.add(Circle{.radius = 0.2f});
    Body round = world.create_body({.position = far_away + Vec2(-3, 3)});
    round.add(Ellipse{.radius_x = 0.5f, .radius_y = 0.25f});
    Vec2 touched = {-1, -1};
    for (int i = 0; i < 300; ++i) {
        world.step(dt);
        for (const ContactBeginEvent& event : world.events().contact_begin)
            if (event.body_b == resting.id()) touched = event.point - far_away;
    }
    CHECK((resting.position() - far_away).y == Approx(0.5f).margin(0.01));
    CHECK((round.position() - far_away).y == Approx(0.25f).margin(0.01));
    CHECK((ball.position() - far_away).within({-5, 0}, {5, 10}));
    CHECK(touched.y == Approx(0).margin(0.03));
    CHECK(std::fabs(touched.x) < 0.6f);
    CHECK_FALSE(resting.awake());
    const std::vector<Contact> contacts = resting.contacts();
    REQUIRE(contacts.size() == 1);
    CHECK((contacts[0].points[0].point - far_away).y == Approx(0).margin(0.01));
}

TEST_CASE("queries far away answer to the millimeter") {
    World world;
    Body post = world.create_body({.type = BodyType::static_body, .position = far_away});
    const Shape shape = post.add(Box{.width = 0.02f, .height = 0.02f});
    const auto at = [](float x, float y) { return far_away + Vec2(x, y); };
    CHECK(world.query_point(at(0.009f, 0)).size() == 1);
    CHECK(world.query_point(at(0.011f, 0)).empty());
    CHECK(world.query_aabb({at(0.011f, -1), at(1, 1)}).empty());
    CHECK(world.query_aabb({at(0.009f, -1), at(1, 1)}).size() == 1);
    CHECK(shape.contains(at(0, 0.009f)));
    CHECK_FALSE(shape.contains(at(0, 0.011f)));
    for (int i = 0; i < 16; ++i) {
        const float turn = 0.39f * float(i);
        const Position from = at(7 * std::cos(turn), 7 * std::sin(turn));
        const auto hit = world.cast_ray(from, far_away + 0.5f * (far_away - from));
        REQUIRE(hit);
        CHECK((hit->point - far_away).length() < 0.0145f);
        CHECK((hit->point - far_away).length() > 0.0099f);
        const auto swept = world.cast_shape(Circle{.radius = 0.5f}, {from, 0}, far_away - from);
        REQUIRE(swept);
        CHECK(swept->fraction * 7 == Approx(6.49f).margin(0.01));
        CHECK((swept->point - far_away).length() < 0.0145f);
    }
    CHECK_FALSE(world.cast_ray(at(-3, 0.011f), at(3, 0.011f)));
    CHECK(world.query_overlap(Circle{.radius = 0.5f}, {at(0.509f, 0), 0}).size() == 1);
    CHECK(world.query_overlap(Circle{.radius = 0.5f}, {at(0.511f, 0), 0}).empty());
    const auto nearest = world.closest(at(3, 0));
    REQUIRE(nearest);
    CHECK(nearest->distance == Approx(2.99f).epsilon(1e-5));
    CHECK((nearest->point - far_away).x == Approx(0.01f).epsilon(1e-3));
}

TEST_CASE("fields and explosions far away act as at the origin") {
    const Build fields = [](World& world, const Position& origin) {
        world.create_field({.force = BuoyancyField{.level = origin.y},
                            .region = Aabb{origin + Vec2(-5, -5), origin + Vec2(0, 5)}});
        world.create_field(
            {.force = AttractorField{.center = origin + Vec2(20, 0), .strength = 30}});
        for (int i = 0; i < 4; ++i) box(world, origin + Vec2(float(3 * i) - 4, 1));
        world.explode(origin + Vec2(-1, 0), 4, 2);
    };
    CHECK(difference(fields, 60) < 1e-3f);
}

TEST_CASE("a mover walks far away as at the origin") {
    const auto walk = [](const Position& origin, bool pushes) {
        World world;
        Body floor = ground(world, origin);
        floor.add(Box{.width = 4, .height = 0.4f, .center = {4, 0}});
        floor.add(Polygon{{{6, 0}, {10, 0}, {10, 2}}});
        if (pushes) box(world, origin + Vec2(-3, 0.5f), 0.5f);
        Mover mover(MoverDef{}, origin + Vec2(-5, 1));
        Vec2 velocity = {3, 0};
        for (int i = 0; i < 240; ++i) {
            velocity = {3, mover.on_ground() ? 0.0f : velocity.y - 10 * dt};
            velocity.y = mover.move(world, velocity, dt).velocity.y;
            world.step(dt);
        }
        return mover.position() - origin;
    };
    const Vec2 near = walk({}, false), far = walk(far_away, false);
    CHECK((near - far).length() < 1e-3f);
    CHECK(far.x > 5.0f);
    CHECK(far.y > 0.1f);
    CHECK((walk({}, true) - walk(far_away, true)).length() < 0.02f);
}

TEST_CASE("a world far away is saved and cloned and repeated bit for bit") {
    World world = built(ragdoll, far_away);
    run(world, 30);
    std::vector<std::byte> saved;
    world.save(saved);
    World restored;
    restored.restore(saved);
    World clone = world.clone(), again = built(ragdoll, far_away);
    run(again, 30);
    for (World* other : {&restored, &clone, &again}) {
        REQUIRE(other->hash() == world.hash());
        run(*other, 60);
    }
    run(world, 60);
    for (const World* other : {&restored, &clone, &again}) CHECK(other->hash() == world.hash());
}

TEST_CASE("the hash of a world distinguishes places that a float does not") {
    const auto hash_at = [](double x) {
        World world;
        world.create_body({.position = {x, 0.0}});
        return world.hash();
    };
    CHECK(hash_at(1e7) != hash_at(1e7 + 0.01));
}

TEST_CASE("a message about a point far away has its digits") {
    World world;
    CHECK_THROWS_WITH(world.set_bounds(Aabb{{1e7 + 0.25, 0}, {1e7, 1}}), contains("10000000.25"));
}

}  // namespace far_worlds_test

#endif
