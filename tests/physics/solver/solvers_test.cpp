#include <algorithm>

#include "catch.h"
#include "scenes.h"

namespace solvers_test {

// The three solvers: what all of them must do, what each is good at, and changing between them
// while a world runs.

using namespace scenes;

namespace {

Solver any_solver() {
    const Solver solver = GENERATE(Solver::soft_step, Solver::sequential, Solver::direct);
    UNSCOPED_INFO("solver " << int(solver));
    return solver;
}

/// Largest of the errors of a pendulum's length while it swings from the horizontal, m.
float worst_length_error(World& world, Body ball, float length, float seconds) {
    float worst = 0.0f;
    for (int i = 0; i < int(seconds / frame); ++i) {
        world.step(frame);
        worst = std::max(worst, std::fabs(Vec2(ball.position()).length() - length));
    }
    return worst;
}

}  // namespace

TEST_CASE("a box comes to rest on a floor and falls asleep under every solver") {
    const Solver solver = any_solver();
    World world({.solver = solver});
    add_floor(world);
    Body box = add_box(world, {0, 2});
    run(world, 4.0f);
    CHECK(box.position().y == Approx(0.5f).margin(0.01));
    CHECK(std::fabs(box.angle()) < 0.01f);
    CHECK_FALSE(box.awake());
    CHECK(box.contacts().size() == 1);
    REQUIRE_FALSE(world.validate());
}

TEST_CASE("the force of a contact carries the weight under every solver") {
    const Solver solver = any_solver();
    World world({.sleeping = false, .solver = solver});
    add_floor(world);
    Body ball = add_ball(world, {0, 0.5f});
    run(world, 2.0f);
    REQUIRE(world.contacts().size() == 1);
    CHECK(world.contacts()[0].normal_force == Approx(10.0f * ball.mass()).epsilon(0.05));
}

TEST_CASE("a ball bounces to the height its restitution allows under every solver") {
    const Solver solver = any_solver();
    World world({.solver = solver});
    add_floor(world);
    Body ball = add_ball(world, {0, 5.5f}, 0.5f, {.restitution = 0.8f, .hit_events = true});
    float highest = 0.0f, impulse = 0.0f;
    bool rising = false;
    for (int i = 0; i < 120; ++i) {
        world.step(frame);
        for (const auto& hit : world.events().contact_hit) impulse = std::max(impulse, hit.impulse);
        rising |= ball.velocity().y > 1.0f;
        if (rising) highest = std::max<float>(highest, ball.position().y);
    }
    // h = e²·5 m, and an impulse of m·(1 + e)·10 m/s
    CHECK(highest - 0.5f == Approx(3.2f).epsilon(0.06));
    CHECK(impulse == Approx(ball.mass() * 18.0f).epsilon(0.06));
}

TEST_CASE("a box slides or sticks on the right side of the angle of friction in every solver") {
    const Solver solver = any_solver();
    const float angle = 0.35f;
    for (const float share : {0.9f, 1.1f}) {
        World world({.solver = solver});
        Slope slope = add_slope(world, angle, share * std::tan(angle));
        run(world, 2.0f);
        const float way =
            (slope.box.position() - Position(-std::sin(angle), std::cos(angle))).dot(slope.down);
        if (share > 1.0f)
            CHECK(std::fabs(way) < 0.02f);
        else  // g·(sin θ - μ·cos θ)·t²/2
            CHECK(way == Approx(20.0f * 0.1f * std::sin(angle)).epsilon(0.05));
    }
}

TEST_CASE("a conveyor carries and rolling resistance stops in every solver") {
    const Solver solver = any_solver();
    World world({.solver = solver});
    add_floor(world, 50.0f, {.friction = 0.6f, .surface_speed = 0.0f});
    Body belt = world.create_body({.type = BodyType::static_body, .position = {0, 10}});
    belt.add(Box{.width = 100, .height = 1}, {.surface_speed = 2.0f});
    Body carried = add_box(world, {0, 11});
    Body wheel = world.create_body({.position = {0, 0.5f}, .velocity = {2, 0}});
    wheel.add(Circle{.radius = 0.5f}, {.rolling_resistance = 0.1f});
    run(world, 3.0f);
    CHECK(std::fabs(carried.velocity().x) == Approx(2.0f).epsilon(0.02));
    CHECK(std::fabs(wheel.velocity().x) < 0.05f);
}

TEST_CASE("a pendulum keeps its length under every solver") {
    const Solver solver = any_solver();
    World world({.sleeping = false, .solver = solver});
    Body ball = add_ball(world, {2, 0}, 0.2f);
    world.create_distance_joint({.body_b = ball.id()});
    CHECK(worst_length_error(world, ball, 2.0f, 5.0f) < 0.02f);
    const float energy = 0.5f * ball.velocity().length_squared() + 10.0f * ball.position().y;
    CHECK(std::fabs(energy) < 1.0f);  // of 20 J/kg between the top and the bottom
}

TEST_CASE("every type of joint does its work under every solver") {
    const Solver solver = any_solver();
    World world({.gravity = {0, 0}, .sleeping = false, .solver = solver});
    const auto free_box = [&](float x) {
        Body body = add_box(world, {x, 0}, 1.0f, {.mask = 0});
        body.set_velocity({1, 2});
        body.set_angular_velocity(1);
        return body;
    };
    const auto at = [](Body body) {
        return JointDef{.body_b = body.id(), .anchor_a = body.position()};
    };
    Body pinned = free_box(0), slider = free_box(10), wheel = free_box(20), welded = free_box(30),
         driven = free_box(40), grooved = free_box(50), pin = free_box(60), geared = free_box(70),
         ratcheted = free_box(80), dragged = free_box(90), lifted = free_box(100),
         weight = free_box(110);
    RevoluteJoint revolute = world.create_revolute_joint(at(pinned));
    revolute.set_motor_speed(-3);
    revolute.set_max_motor_torque(1000);
    PrismaticJoint prismatic = world.create_prismatic_joint(at(slider));
    prismatic.set_upper_translation(0.5f);
    prismatic.set_lower_translation(-0.5f);
    world.create_wheel_joint(at(wheel)).set_damping_ratio(1.0f);
    world.create_weld_joint(at(welded));
    MotorJoint motor = world.create_motor_joint(at(driven));
    motor.set_linear_velocity({0, -1});
    motor.set_max_force(100);
    motor.set_max_torque(100);
    GrooveJoint groove = world.create_groove_joint(at(grooved));
    groove.set_end({51, 0});
    world.create_pin_slot_joint(at(pin));
    GearJoint gear = world.create_gear_joint({.body_a = pinned.id(), .body_b = geared.id()});
    gear.set_ratio(-2);
    world.create_ratchet_joint(at(ratcheted));
    ratcheted.set_angular_velocity(-5);
    world.create_mouse_joint({.body = dragged.id(), .target = {91, 1}, .anchor = Vec2(0, 0)});
    PulleyJoint pulley = world.create_pulley_joint({.body_a = lifted.id(), .body_b = weight.id()});
    pulley.set_ground_a({100, 5});
    pulley.set_ground_b({110, 5});
    pulley.set_length(10);
    lifted.set_velocity({0, -3});
    weight.set_velocity({0, 0});
    run(world, 3.0f);

    CHECK((pinned.position() - Position(0, 0)).length() < 0.01f);
    CHECK(pinned.angular_velocity() == Approx(-3.0f).epsilon(0.02));
    CHECK(geared.angular_velocity() == Approx(6.0f).epsilon(0.02));
    CHECK(std::fabs(slider.position().y) < 0.01f);
    CHECK(std::fabs(slider.angle()) < 0.01f);
    CHECK(std::fabs(slider.position().x - 10.0f) < 0.51f);
    CHECK(std::fabs(wheel.position().x - 20.0f) < 0.01f);
    CHECK(std::fabs(wheel.position().y) < 0.2f);
    CHECK((welded.position() - Position(30, 0)).length() < 0.01f);
    CHECK(std::fabs(welded.angle()) < 0.01f);
    CHECK(driven.velocity().y == Approx(-1.0f).epsilon(0.02));
    CHECK(std::fabs(driven.angular_velocity()) < 0.02f);
    CHECK(grooved.position().x > 49.99f);
    CHECK(grooved.position().x < 51.01f);
    CHECK(std::fabs(grooved.position().y) < 0.01f);
    CHECK(std::fabs(pin.position().y) < 0.01f);
    CHECK(ratcheted.angular_velocity() > -0.01f);
    CHECK((dragged.position() - Position(91, 1)).length() < 0.3f);
    CHECK((lifted.position() - Position(100, 5)).length() +
              (weight.position() - Position(110, 5)).length() <
          10.05f);
    CHECK(weight.position().y > 0.5f);
    REQUIRE_FALSE(world.validate());
}

TEST_CASE("a joint breaks under its load in every solver") {
    const Solver solver = any_solver();
    World world({.solver = solver});
    Body strong = add_box(world, {0, 0}), weak = add_box(world, {5, 0});
    world.create_revolute_joint({.body_b = strong.id(), .anchor_b = {0, 0}}).set_break_force(12.0f);
    Joint breaks =
        world.create_revolute_joint({.body_b = weak.id(), .anchor_a = {5, 0}, .anchor_b = {0, 0}});
    breaks.set_break_force(8.0f);  // it weighs 10 N
    size_t reported = 0;
    for (int i = 0; i < 60; ++i) {
        world.step(frame);
        reported += world.events().joint_broke.size();
    }
    CHECK(reported == 1);
    CHECK(breaks.broken());
    CHECK(weak.position().y < -1.0f);
    CHECK(Vec2(strong.position()).length() < 0.01f);
}

TEST_CASE("locked axes and one-way platforms hold under every solver") {
    const Solver solver = any_solver();
    World world({.solver = solver});
    Body platform = world.create_body({.type = BodyType::static_body});
    platform.add(Box{.width = 10, .height = 0.2f});
    Body locked =
        world.create_body({.position = {0, 2}, .locked_x = true, .locked_rotation = true});
    locked.add(Box{});
    Body pusher = world.create_body({.position = {-2, 0.6f}, .velocity = {4, 0}});
    pusher.add(Box{});
    Body jumper = world.create_body({.position = {3, -1}, .velocity = {0, 8}});
    jumper.add(Circle{.radius = 0.3f});
    world.set_before_solve([&](ContactEdit& contact) {
        const Body other =
            contact.shape_a.body() == platform ? contact.shape_b.body() : contact.shape_a.body();
        if (other == jumper && other.velocity().y > 0.0f) contact.enabled = false;
    });
    run(world, 3.0f);
    CHECK(std::fabs(locked.position().x) < 1e-5f);
    CHECK(std::fabs(locked.angle()) < 1e-5f);
    CHECK(jumper.position().y == Approx(0.4f).margin(0.02));
}

TEST_CASE("an ellipse lies down on its flat side under every solver") {
    const Solver solver = any_solver();
    World world({.sleeping = false, .solver = solver});
    add_floor(world);
    Body egg = world.create_body({.position = {0, 1.2f}, .angle = 0.6f, .angular_damping = 1.0f});
    egg.add(Ellipse{.radius_x = 1.0f, .radius_y = 0.5f});
    run(world, 10.0f);
    CHECK(egg.position().y == Approx(0.5f).margin(0.02));
    CHECK(std::fabs(std::sin(egg.angle())) < 0.06f);
}

TEST_CASE("bullets stop at walls under every solver") {
    const Solver solver = any_solver();
    World world({.gravity = {0, 0}, .solver = solver});
    Body wall = world.create_body({.type = BodyType::static_body});
    wall.add(Segment{.from = {0, -50}, .to = {0, 50}});
    Body bullet = world.create_body({.position = {-7.3f, 0}, .velocity = {300, 0}, .bullet = true});
    bullet.add(Circle{.radius = 0.05f});
    run(world, 0.5f);
    CHECK(bullet.position().x < 0.1f);
}

TEST_CASE("the direct solver reports which problems it solved and which were too large for it") {
    World world({.gravity = {0, 0}, .sleeping = false, .solver = Solver::direct});
    add_floor(world);
    for (int i = 0; i < 3; ++i) add_box(world, {3.0f * float(i), 0.5f});
    world.step(frame);
    CHECK(world.statistics().direct_solves == 3 * 2 * 4);  // bodies, passes, sub-steps
    CHECK(world.statistics().direct_failures == 0);
    for (int i = 0; i < 600; ++i) add_ball(world, {float(i % 30), 5 + float(i / 30)}, 0.5001f);
    world.step(frame);
    CHECK(world.statistics().direct_failures == 2 * 4);
    world.set_solver(Solver::soft_step);
    world.step(frame);
    CHECK(world.statistics().direct_solves == 0);
    CHECK(world.statistics().direct_failures == 0);
}

TEST_CASE("the direct solver carries a thousand times the weight without sinking in") {
    World world({.substeps = 1, .sleeping = false, .solver = Solver::direct});
    add_floor(world);
    std::vector<Body> stack;
    for (int i = 0; i < 6; ++i) stack.push_back(add_box(world, {0, 0.5f + float(i)}));
    stack.push_back(add_box(world, {0, 6.5f}, 1.0f, {.density = 1000.0f}));
    run(world, 5.0f);
    for (size_t i = 0; i < stack.size(); ++i) {
        CHECK(stack[i].position().y == Approx(0.5f + float(i)).margin(1e-3));
        CHECK(stack[i].velocity().length() < 1e-4f);
    }
}

TEST_CASE("a chain under a heavy ball does not stretch in the direct solver") {
    World world({.sleeping = false, .solver = Solver::direct});
    BodyId last;
    Vec2 anchor = {};
    for (int i = 0; i < 30; ++i) {
        Body link = world.create_body({.position = {0, -0.25f - 0.5f * float(i)}});
        link.add(Box{.width = 0.1f, .height = 0.5f});
        world.create_revolute_joint(
            {.body_a = last, .body_b = link.id(), .anchor_a = anchor, .anchor_b = {0, 0.25f}});
        last = link.id();
        anchor = {0, -0.25f};
    }
    Body ball = world.create_body({.position = {0, -15.5f}, .mass = 5.0f});
    ball.add(Circle{});
    world.create_revolute_joint(
        {.body_a = last, .body_b = ball.id(), .anchor_a = anchor, .anchor_b = {0, 0.5f}});
    run(world, 5.0f);
    CHECK(ball.position().y == Approx(-15.5f).margin(1e-3));
}

TEST_CASE("a spring swings with its period in the direct solver") {
    World world({.gravity = {0, 0}, .sleeping = false, .solver = Solver::direct});
    Body ball = add_ball(world, {3, 0});
    DistanceJoint spring = world.create_distance_joint({.body_b = ball.id()});
    spring.set_length(2);
    spring.set_hertz(0.5f);
    float crossed = 0.0f, before = 1.0f;
    int crossings = 0;
    for (int i = 0; i < 600; ++i) {
        world.step(frame);
        const float now = ball.position().x - 2.0f;
        if (before < 0.0f && now >= 0.0f) {
            ++crossings;
            crossed = float(i + 1) * frame - frame * now / (now - before);
        }
        before = now;
    }
    // From rest at the far end, x = 2 is passed outwards at ¾, 1¾ … of a period of 2 s.
    REQUIRE(crossings == 5);
    CHECK(crossed == Approx(9.5f).epsilon(0.005));
}

TEST_CASE("the solver can be changed while a world runs and sleeping bodies wake") {
    World world;
    add_floor(world);
    std::vector<Body> stack;
    for (int i = 0; i < 3; ++i) stack.push_back(add_box(world, {0, 0.5f + float(i)}));
    run(world, 2.0f);
    REQUIRE_FALSE(stack[0].awake());
    for (const Solver solver : {Solver::direct, Solver::sequential, Solver::soft_step}) {
        world.set_solver(solver);
        CHECK(world.solver() == solver);
        CHECK(stack[0].awake());
        run(world, 2.0f);
        for (size_t i = 0; i < stack.size(); ++i)
            CHECK(stack[i].position().y == Approx(0.5f + float(i)).margin(0.02));
        REQUIRE_FALSE(world.validate());
    }
}

TEST_CASE("a restored world goes on under its solver bit for bit") {
    const Solver solver = any_solver();
    World world({.bounds = Aabb{{-4, 0}, {4, 30}}, .solver = solver});
    std::vector<Body> bodies;
    for (int i = 0; i < 30; ++i) {
        bodies.push_back(world.create_body(
            {.position = {float(i % 6) - 2.5f, 1 + float(i / 6)}, .angle = float(i)}));
        if (i % 2 == 0)
            bodies.back().add(Circle{.radius = 0.4f}, {.restitution = 0.3f});
        else
            bodies.back().add(Box{.width = 0.8f, .height = 0.5f});
        if (i % 5 == 4) {
            world.create_revolute_joint({.body_a = bodies[size_t(i) - 1].id(),
                                         .body_b = bodies.back().id(),
                                         .anchor_a = {0.5f, 0},
                                         .anchor_b = {-0.5f, 0}});
        }
    }
    run(world, 1.0f);
    std::vector<std::byte> saved;
    world.save(saved);
    run(world, 2.0f);
    const uint64_t expected = world.hash();
    World other;
    other.restore(saved);
    CHECK(other.solver() == solver);
    run(other, 2.0f);
    CHECK(other.hash() == expected);
    world.restore(saved);
    run(world, 2.0f);
    CHECK(world.hash() == expected);
}

TEST_CASE("a pyramid under the direct solver stands still from the first step") {
    World world({.sleeping = false, .solver = Solver::direct});
    add_floor(world);
    std::vector<Body> boxes;
    for (int row = 0; row < 20; ++row)
        for (int i = 0; i < 20 - row; ++i)
            boxes.push_back(add_box(world, {float(i) - 0.5f * float(19 - row), 0.5f + float(row)}));
    for (int i = 0; i < 10; ++i) {
        world.step(frame);
        CHECK(world.statistics().direct_failures == 0);
        CHECK(rms_speed(boxes) < 1e-5f);
    }
}

}  // namespace solvers_test
