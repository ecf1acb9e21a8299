#include <iostream>

#include "catch.h"
#include "scenes.h"

namespace ellipse_test {

using namespace scenes;

namespace {

constexpr double pi = 3.14159265358979323846;

Body add_ellipse(World& world, float a, float b, const Vec2& at, float angle = 0.0f,
                 const ShapeDef& surface = {}) {
    Body body = world.create_body({.position = at, .angle = angle});
    body.add(Ellipse{a, b}, surface);
    return body;
}

/// Half the height of an ellipse that is turned.
double height(double a, double b, double angle) {
    return std::sqrt(std::pow(a * std::sin(angle), 2) + std::pow(b * std::cos(angle), 2));
}

/// Seconds of a full swing, from the zero crossings of the angle. `amplitude` gets the amplitude of
/// the last half swing (rad).
double measured_period(World& world, Body body, int swings, double& amplitude) {
    double last = double(body.angle()), first = -1.0, latest = 0.0;
    int crossings = 0;
    amplitude = 0.0;
    for (int i = 1; crossings <= 2 * swings && i < 6000; ++i) {
        world.step(frame);
        const double angle = double(body.angle());
        if ((last < 0) != (angle < 0)) {
            latest = double(frame) * (double(i - 1) + last / (last - angle));
            if (first < 0) first = latest;
            if (++crossings == 2 * swings) amplitude = 0.0;
        }
        amplitude = std::max(amplitude, std::fabs(angle));
        last = angle;
    }
    return (latest - first) / double(swings);
}

/// Seconds of a full swing of an ellipse that rolls without slipping. Its energy is
/// ½(I + m·r²)·θ'² + m·g·h(θ), where r is the distance from the contact to the center. The integral
/// of a quarter period is taken over φ with θ = θ₀·sin φ, which removes the singularity at θ₀.
double rocking_period(double a, double b, double g, double start) {
    const double inertia = 0.25 * (a * a + b * b);
    double sum = 0.0;
    const int n = 4000;
    for (int i = 0; i < n; ++i) {
        const double phi = 0.5 * pi * (i + 0.5) / n, theta = start * std::sin(phi);
        const double h = height(a, b, theta);
        const double slope = (a * a - b * b) * std::sin(theta) * std::cos(theta) / h;
        const double squared = h * h + slope * slope;
        const double drop = height(a, b, start) - h;
        sum +=
            start * std::cos(phi) * std::sqrt((inertia + squared) / (2 * g * drop)) * 0.5 * pi / n;
    }
    return 4.0 * sum;
}

}  // namespace

TEST_CASE("an ellipse has the area and the mass and the inertia of an ellipse") {
    World world;
    Body body = world.create_body();
    Shape shape = body.add(Ellipse{2.0f, 0.5f, {3, 1}, 0.7f}, {.density = 3.0f});
    REQUIRE(shape.area() == Approx(pi));
    REQUIRE(body.mass() == Approx(3 * pi));
    REQUIRE(body.inertia() == Approx(3 * pi * (4 + 0.25) / 4));
    REQUIRE((body.center() - Vec2(3, 1)).length() < 1e-5);
    const double c = std::cos(0.7), s = std::sin(0.7);
    const Aabb box = shape.aabb();
    REQUIRE(box.max.x == Approx(3 + std::sqrt(4 * c * c + 0.25 * s * s)));
    REQUIRE(box.max.y == Approx(1 + std::sqrt(4 * s * s + 0.25 * c * c)));
    shape.set_radius_x(1.0f);
    REQUIRE(body.mass() == Approx(1.5 * pi));
    shape.set_radius_y(1.0f);
    shape.set_angle(0.0f);
    REQUIRE(body.inertia() == Approx(1.5 * pi));
    REQUIRE_THROWS_AS(shape.set_radius_x(0.0f), std::invalid_argument);
    REQUIRE_THROWS_AS(shape.set_radius_y(-1.0f), std::invalid_argument);
    REQUIRE_THROWS_AS(shape.radius(), std::invalid_argument);
    REQUIRE(shape.vertices().empty());
}

TEST_CASE("an ellipse rests at its analytic height at every angle of its shape") {
    for (const float angle : {0.0f, 0.3f, 1.0f, 1.5707963f, 2.5f}) {
        World world({.sleeping = false});
        add_floor(world);
        Body body = world.create_body(
            {.position = {0, float(height(1.0, 0.4, double(angle)))}, .locked_rotation = true});
        body.add(Ellipse{1.0f, 0.4f, {0, 0}, angle}, {.friction = 0.0f});
        run(world, 2.0f);
        INFO(angle);
        REQUIRE(double(body.position().y) == Approx(height(1.0, 0.4, double(angle))).margin(0.002));
    }
}

TEST_CASE("an ellipse rocks with its analytic period") {
    const auto [a, b] = GENERATE(std::pair{1.0, 0.5}, std::pair{0.6, 0.5}, std::pair{2.0, 0.4});
    const double start = GENERATE(0.05, 0.2);
    World world({.sleeping = false});
    add_floor(world, 50.0f, {.friction = 10.0f});
    Body body = add_ellipse(world, float(a), float(b), {0, float(height(a, b, start))},
                            float(start), {.friction = 10.0f});
    double amplitude = 0.0;
    const double period = measured_period(world, body, 5, amplitude);
    const double expected = rocking_period(a, b, 10.0, start);
    std::cout << "ellipse " << a << " x " << b << " from " << start << " rad: period " << period
              << " s, analytic " << expected << " s (" << 100 * (period / expected - 1)
              << " %), amplitude after five swings " << amplitude << '\n';
    CHECK(period == Approx(expected).epsilon(0.02));
    CHECK(amplitude < 1.05 * start);
    CHECK(amplitude > 0.8 * start);
}

TEST_CASE("a round ellipse rolls down a slope like a disc") {
    World world({.sleeping = false});
    const float slope = 0.3f;
    Body ground = world.create_body({.type = BodyType::static_body, .angle = -slope});
    ground.add(Box{.width = 400, .height = 1, .center = {0, -0.5f}});
    Body body =
        add_ellipse(world, 0.5f, 0.5f, Vec2(0.5f * std::sin(slope), 0.5f * std::cos(slope)));
    run(world, 2.0f);
    const double expected = 2.0 / 3.0 * 10.0 * std::sin(double(slope)) * 2.0;
    REQUIRE(double(body.velocity().length()) == Approx(expected).epsilon(0.01));
    REQUIRE(double(-body.angular_velocity()) == Approx(expected / 0.5).epsilon(0.01));
}

TEST_CASE("an ellipse that rolls keeps its energy") {
    World world({.sleeping = false});
    add_floor(world, 50.0f, {.friction = 2.0f});
    Body body = add_ellipse(world, 0.6f, 0.45f, {-20, 0.45f}, 0.0f, {.friction = 2.0f});
    body.set_velocity({3.0f, 0});
    body.set_angular_velocity(-3.0f / 0.45f);
    const auto energy = [&] {
        return double(body.kinetic_energy()) +
               double(body.mass()) * 10.0 * double(body.position().y);
    };
    const double before = energy();
    run(world, 5.0f);
    std::cout << "rolling ellipse: energy changed by " << 100 * (energy() / before - 1)
              << " % in 5 s\n";
    REQUIRE(energy() == Approx(before).epsilon(0.05));
}

TEST_CASE("ellipses can be stacked and carry a plank") {
    World world({.sleeping = false});
    add_floor(world);
    std::vector<Body> flat;
    for (int i = 0; i < 5; ++i)
        flat.push_back(add_ellipse(world, 1.0f, 0.25f, {0, 0.25f + 0.5f * float(i)}));
    Body left = add_ellipse(world, 0.5f, 0.3f, {4.5f, 0.3f});
    add_ellipse(world, 0.5f, 0.3f, {6.5f, 0.3f});
    Body plank = world.create_body({.position = {5.5f, 0.7f}});
    plank.add(Box{.width = 4, .height = 0.2f});
    run(world, 6.0f);
    for (size_t i = 0; i < flat.size(); ++i) {
        INFO(i);
        CHECK(flat[i].position().y == Approx(0.25 + 0.5 * double(i)).margin(0.02));
        CHECK(std::fabs(flat[i].angle()) < 0.05f);
    }
    CHECK(plank.position().y == Approx(0.7f).margin(0.01));
    CHECK(left.velocity().length() < 0.01f);
}

TEST_CASE("ellipses of all sizes collide with every kind of shape") {
    World world({.bounds = Aabb{{-8, 0}, {8, 60}}});
    std::vector<Body> bodies;
    for (int i = 0; i < 120; ++i) {
        Body body =
            world.create_body({.position = {float(i % 8) * 1.8f - 6.3f, 1.5f + 1.5f * float(i / 8)},
                               .angle = float(i)});
        switch (i % 8) {
            case 0:
                body.add(Circle{.radius = 0.5f});
                break;
            case 1:
                body.add(Box{});
                break;
            case 2:
                body.add(Segment{{-0.5f, 0}, {0.5f, 0}, 0.2f});
                break;
            case 3:
                body.add(Polygon{{{-0.5f, -0.4f}, {0.5f, -0.4f}, {0, 0.6f}}, 0.05f});
                break;
            case 4:
                body.add(Concave{{{0, 0}, {1, 0}, {1, 0.4f}, {0.4f, 0.4f}, {0.4f, 1}, {0, 1}}});
                break;
            default:
                body.add(Ellipse{0.3f + 0.1f * float(i % 5), 0.2f + 0.05f * float(i % 7)});
                break;
        }
        bodies.push_back(body);
    }
    Body ground = world.create_body({.type = BodyType::static_body});
    ground.add(Chain{{{-8, 2}, {-4, 0.3f}, {0, 1}, {4, 0.3f}, {8, 2}}});
    run(world, 15.0f);
    double energy = 0.0;
    float deepest = 0.0f;
    for (Body body : bodies) energy += double(body.kinetic_energy());
    for (const Contact& contact : world.contacts())
        for (int k = 0; k < contact.point_count; ++k)
            deepest = std::min(deepest, contact.points[size_t(k)].separation);
    std::cout << "pile with ellipses: energy " << energy << " J, deepest overlap " << -deepest
              << " m\n";
    CHECK(energy < 1.0);
    CHECK(deepest > -0.02f);
    REQUIRE_FALSE(world.validate());
}

TEST_CASE("all queries about an ellipse are exact") {
    World world;
    Body body =
        world.create_body({.type = BodyType::static_body, .position = {1, 2}, .angle = 0.5f});
    Shape shape = body.add(Ellipse{2.0f, 0.7f});
    const double c = std::cos(0.5), s = std::sin(0.5);
    // A point of the rim, in the world.
    const auto rim = [&](double t) {
        const double x = 2.0 * std::cos(t), y = 0.7 * std::sin(t);
        return Vec2(float(1 + c * x - s * y), float(2 + s * x + c * y));
    };
    const auto normal = [&](double t) {
        const double x = std::cos(t) / 2.0, y = std::sin(t) / 0.7;
        return Vec2(float(c * x - s * y), float(s * x + c * y)).normalized();
    };
    for (double t = 0.1; t < 6.2; t += 0.37) {
        INFO(t);
        const Vec2 outside = rim(t) + 1.5f * normal(t);
        const auto near = world.closest(outside, 10.0f);
        REQUIRE(near);
        CHECK(near->distance == Approx(1.5f).epsilon(1e-4));
        CHECK((near->point - Position(rim(t))).length() < 1e-4f);
        CHECK((near->normal - normal(t)).length() < 1e-3f);
        CHECK(shape.contains(rim(t) - 0.001f * normal(t)));
        CHECK_FALSE(shape.contains(rim(t) + 0.001f * normal(t)));
        const auto hit = world.cast_ray(outside, rim(t) - 0.2f * normal(t));
        REQUIRE(hit);
        CHECK((hit->point - Position(rim(t))).length() < 1e-4f);
        CHECK((hit->normal - normal(t)).length() < 1e-3f);
        const auto swept =
            world.cast_shape(Circle{.radius = 0.5f}, {outside, 0}, -1.2f * normal(t));
        REQUIRE(swept);
        CHECK(swept->fraction == Approx(1.0f / 1.2f).epsilon(1e-3));
        CHECK(world.query_overlap(Box{.width = 0.2f, .height = 0.2f}, {rim(t), 0}).size() == 1);
        CHECK(world.query_overlap(Circle{.radius = 1.49f}, {outside, 0}).empty());
        CHECK(world.query_overlap(Circle{.radius = 1.51f}, {outside, 0}).size() == 1);
        // Two ellipses, rim to rim.
        Body other =
            world.create_body({.type = BodyType::static_body, .position = outside + normal(t)});
        Shape disc = other.add(Ellipse{1.0f, 1.0f});
        CHECK(distance(shape, disc).distance == Approx(1.5f).epsilon(1e-4));
        CHECK(distance(disc, shape).distance == Approx(1.5f).epsilon(1e-4));
        other.destroy();
    }
    REQUIRE_FALSE(world.cast_ray({1, 2}, {9, 9}));  // from inside
}

TEST_CASE("an ellipse half under water is lifted by half its area") {
    World world({.gravity = {0, -10}, .sleeping = false});
    BuoyancyField water;
    water.level = 0.0f;
    water.density = 2.0f;
    water.drag = 2.0f;
    world.create_field({.force = water});
    Body body = add_ellipse(world, 1.5f, 0.5f, {0, 0.1f}, 0.0f);
    run(world, 20.0f);
    REQUIRE(body.position().y == Approx(0.0f).margin(0.01));
    REQUIRE(std::fabs(body.angle()) < 0.05f);
}

TEST_CASE("very thin and very small ellipses keep a valid state") {
    World world({.bounds = Aabb{{-50, 0}, {50, 200}}});
    for (int i = 0; i < 60; ++i) {
        const float a = std::pow(10.0f, float(i % 6) - 4.0f),
                    b = std::pow(10.0f, float(i % 5) - 4.0f);
        Body body = world.create_body({.position = {float(i % 10) - 5, 1.0f + float(i / 10)},
                                       .angle = float(i),
                                       .velocity = {float(i % 3) * 30, 0}});
        body.add(Ellipse{a, b}, {.restitution = 0.3f});
    }
    run(world, 3.0f);
    REQUIRE_FALSE(world.validate());
}

}  // namespace ellipse_test
