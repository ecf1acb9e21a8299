#include "catch.h"
#include "scenes.h"

namespace distance_joint_test {

using namespace scenes;

namespace {

constexpr float pi = 3.14159265f;

/// Seconds between passes through `value() == 0` upwards, the mean over `passes`.
template <class Value>
float period(World& world, int passes, Value value) {
    float before = value(), first = -1.0f, last = -1.0f;
    int seen = 0;
    for (int i = 1; i < 60 * 120 && seen <= passes; ++i) {
        world.step(frame);
        const float now = value();
        if (before < 0.0f && now >= 0.0f) {
            last = (float(i) - now / (now - before)) * frame;
            if (seen++ == 0) first = last;
        }
        before = now;
    }
    REQUIRE(seen == passes + 1);
    return (last - first) / float(passes);
}

DistanceJoint hang(World& world, const Body& ball, const Vec2& from) {
    return world.create_distance_joint({.body_b = ball.id(), .anchor_a = from});
}

}  // namespace

TEST_CASE("a pendulum on a rod swings with its period and keeps its energy") {
    World world;
    const float length = 2.0f, angle = 0.1f;
    Body ball = add_ball(world, {length * std::sin(angle), -length * std::cos(angle)}, 0.1f);
    ball.set_inertia(infinity);  // a point mass: it does not turn
    const DistanceJoint rod = hang(world, ball, {0, 0});
    REQUIRE(rod.length() == Approx(length));
    const float expected = 2 * pi * std::sqrt(length / 10.0f) * (1 + angle * angle / 16);
    REQUIRE(period(world, 10, [&] { return ball.position().x; }) == Approx(expected).epsilon(0.01));
    float widest = 0.0f;
    for (int i = 0; i < 240; ++i) {
        world.step(frame);
        widest = std::max<float>(widest, std::fabs(ball.position().x));
    }
    REQUIRE(widest == Approx(length * std::sin(angle)).epsilon(0.03));
}

TEST_CASE("a rod keeps its length under load and in a fast swing") {
    World world;
    Body ball = add_ball(world, {3, 0}, 0.5f, {.density = 100.0f});
    const DistanceJoint rod = hang(world, ball, {0, 0});
    for (int i = 0; i < 300; ++i) {
        world.step(frame);
        REQUIRE(rod.distance() == Approx(3.0f).epsilon(0.005));
    }
    // Half a swing from level to level and back keeps the height.
    float highest = -3.0f;
    for (int i = 0; i < 300; ++i) {
        world.step(frame);
        highest = std::max<float>(highest, ball.position().y);
    }
    REQUIRE(highest > -0.25f);
    REQUIRE(highest < 0.05f);
}

TEST_CASE("a rod follows its length as the rope of a winch does") {
    for (const float speed : {1.0f, 4.0f}) {
        World world;
        Body ball = add_ball(world, {0, -9}, 0.2f);
        DistanceJoint rod = hang(world, ball, {0, 0});
        for (int i = 0; i < 120; ++i) {
            rod.set_length(rod.length() - speed * frame);
            world.step(frame);
            REQUIRE(rod.distance() == Approx(rod.length()).margin(0.1f * speed));
        }
    }
    World world({.gravity = {0, 0}});  // and one that is set at once comes there soon
    Body ball = add_ball(world, {0, -9}, 0.2f);
    DistanceJoint rod = hang(world, ball, {0, 0});
    rod.set_length(6);
    run(world, 1.0f);
    REQUIRE(rod.distance() == Approx(6).margin(0.02));
    REQUIRE(ball.velocity().length() < 0.1f);
}

TEST_CASE("a rod reports the force that it holds with") {
    World world;
    Body ball = add_ball(world, {0, -2}, 0.5f, {.density = 5.0f});
    const DistanceJoint rod = hang(world, ball, {0, 0});
    run(world, 2.0f);
    REQUIRE(rod.force().y == Approx(10.0f * ball.mass()).epsilon(0.01));
    REQUIRE(std::fabs(rod.force().x) < 0.01f * ball.mass());
    REQUIRE(rod.torque() == 0.0f);
}

TEST_CASE("a rope is slack below its length and taut at it") {
    World world;
    Body ball = add_ball(world, {0, -1}, 0.2f);
    DistanceJoint rope = hang(world, ball, {0, 0});
    rope.set_hertz(0.0f);
    rope.set_max_length(3.0f);
    for (int i = 0; i < 20; ++i) {
        world.step(frame);
        const float time = float(i + 1) * frame;
        REQUIRE(ball.position().y == Approx(-1 - 5 * time * time).epsilon(0.02));
        REQUIRE(rope.force().length() == 0.0f);
    }
    run(world, 3.0f);
    REQUIRE(rope.distance() == Approx(3.0f).epsilon(0.005));
    REQUIRE(rope.force().y == Approx(10.0f * ball.mass()).epsilon(0.01));
    ball.set_position({1, -1});
    REQUIRE(rope.distance() < 1.5f);
    world.step(frame);
    REQUIRE(rope.force().length() == 0.0f);
}

TEST_CASE("a minimal length keeps two bodies apart that gravity presses together") {
    World world;
    Body low = add_ball(world, {0, 0}, 0.1f), high = add_ball(world, {0, 2}, 0.1f);
    low.set_type(BodyType::static_body);
    high.set_locked_x(true);
    DistanceJoint prop =
        world.create_distance_joint({.body_a = low.id(), .body_b = high.id(), .collide = true});
    prop.set_hertz(0.0f);
    prop.set_min_length(1.0f);
    run(world, 2.0f);
    REQUIRE(prop.distance() == Approx(1.0f).epsilon(0.005));
    prop.set_min_length(1.5f);
    run(world, 2.0f);
    REQUIRE(prop.distance() == Approx(1.5f).epsilon(0.005));
    prop.set_max_length(0.5f);  // counts where they cross
    run(world, 2.0f);
    REQUIRE(prop.distance() == Approx(0.5f).epsilon(0.01));
}

TEST_CASE("a spring swings with its frequency and its damping") {
    World world({.gravity = {0, 0}, .sleeping = false});
    Body ball = add_ball(world, {0, -2.1f}, 0.2f);
    DistanceJoint spring = hang(world, ball, {0, 0});
    spring.set_length(2.0f);
    for (const float hertz : {0.5f, 2.0f, 5.0f}) {
        ball.set_position({0, -2.1f});
        ball.set_velocity({0, 0});
        spring.set_hertz(hertz);
        const float measured = period(world, 5, [&] { return ball.position().y + 2.0f; });
        INFO(hertz);
        REQUIRE(measured == Approx(1.0f / hertz).epsilon(0.01));
        float widest = 0.0f;
        for (int i = 0; i < 240; ++i) {
            world.step(frame);
            widest = std::max<float>(widest, std::fabs(ball.position().y + 2.0f));
        }
        REQUIRE(widest == Approx(0.1f).epsilon(0.1));  // undamped keeps its energy
    }
    // Amplitudes a period apart differ by exp(-2πζ/√(1-ζ²)).
    spring.set_hertz(1.0f);
    spring.set_damping_ratio(0.1f);
    ball.set_position({0, -2.1f});
    ball.set_velocity({0, 0});
    run(world, 1.0f / std::sqrt(0.99f));
    REQUIRE(-(ball.position().y + 2.0f) ==
            Approx(0.1f * std::exp(-2 * pi * 0.1f / std::sqrt(0.99f))).epsilon(0.03));
}

TEST_CASE("a spring of any stiffness stays where it is") {
    World world({.sleeping = false});
    Body ball = add_ball(world, {0.5f, -2}, 0.2f);
    DistanceJoint spring = hang(world, ball, {0, 0});
    for (const float hertz : {20.0f, 80.0f, 1000.0f, 1e6f, 1e30f}) {
        spring.set_hertz(hertz);
        run(world, 1.0f);
        INFO(hertz);
        REQUIRE(spring.distance() == Approx(std::sqrt(4.25f)).epsilon(0.02));
    }
}

TEST_CASE("a cradle whose balls touch swings for a minute without fading") {
    World world({.sleeping = false});
    std::vector<Body> balls;
    const float length = 4.0f, aside = 0.5f;
    for (int i = 0; i < 5; ++i) {
        balls.push_back(
            add_ball(world, {float(i), -length}, 0.5f, {.friction = 0, .restitution = 1}));
        hang(world, balls.back(), {float(i), 0});
    }
    balls[0].set_position({-length * std::sin(aside), -length * std::cos(aside)});
    const auto energy = [&] {
        float sum = 0.0f;
        for (Body ball : balls)
            sum += ball.kinetic_energy() + 10.0f * ball.mass() * (ball.position().y + length);
        return sum;
    };
    const float before = energy();
    run(world, 50.0f);
    float reached = 0.0f, moved = 0.0f;
    for (int i = 0; i < 600; ++i) {
        world.step(frame);
        reached = std::max<float>(reached, balls[4].position().x - 4.0f);
        moved = std::max<float>(moved, std::fabs(balls[2].position().x - 2.0f));
    }
    REQUIRE(energy() == Approx(before).epsilon(0.02));
    REQUIRE(reached == Approx(length * std::sin(aside)).epsilon(0.03));
    REQUIRE(moved < 0.1f);
}

TEST_CASE("an elastic cradle passes the impact on to the last ball") {
    World world({.sleeping = false});
    std::vector<Body> balls;
    const float length = 4.0f, aside = 0.5f, pitch = 1.025f;
    for (int i = 0; i < 5; ++i) {
        const float x = pitch * float(i);
        balls.push_back(add_ball(world, {x, -length}, 0.5f, {.friction = 0, .restitution = 1}));
        hang(world, balls.back(), {x, 0});
    }
    balls[0].set_position({-length * std::sin(aside), -length * std::cos(aside)});
    float reached = 0.0f, moved = 0.0f;
    for (int i = 0; i < 120; ++i) {
        world.step(frame);
        reached = std::max<float>(reached, balls[4].position().x - 4 * pitch);
        moved = std::max<float>(moved, std::fabs(balls[2].position().x - 2 * pitch));
    }
    REQUIRE(reached == Approx(length * std::sin(aside)).epsilon(0.03));
    REQUIRE(moved < 0.15f);
}

}  // namespace distance_joint_test
