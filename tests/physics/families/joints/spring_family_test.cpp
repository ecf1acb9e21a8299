// Rows and nets of springs of any stiffness. FETTLE_SEEDS=n: n worlds of each family.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>
#include <vector>

#include "catch.h"
#include "family.h"

namespace spring_family_test {

using namespace fettle::physics;
using families::Random;
using families::seeds_or;

namespace {

constexpr float dt = 1.0f / 60;

/// A row of balls on springs between two fixed ends, 6 m apart, without contacts.
struct Row {
    World world;
    std::vector<Body> bodies;
    std::vector<double> stiffness, lengths;  ///< of the springs

    Row(Random& random, float hertz, float damping_ratio, float rest_share, Vec2 gravity)
        : world({.gravity = gravity, .sleeping = false}) {
        const int springs = int(random(5, 24));
        const float length = 6.0f / float(springs);
        for (int i = 0; i <= springs; ++i) {
            const bool end = i == 0 || i == springs;
            const Vec2 aside = {random(-0.2f, 0.2f) * length, random(-0.2f, 0.2f) * length};
            const Vec2 at = {float(i) * length, 0.0f};
            bodies.push_back(
                world.create_body({.type = end ? BodyType::static_body : BodyType::dynamic_body,
                                   .position = end ? at : at + aside}));
            bodies.back().add(Circle{0.3f * length}, {.density = random(1, 4), .mask = 0});
        }
        for (size_t i = 0; i + 1 < bodies.size(); ++i) {
            world.create_distance_joint({.body_a = bodies[i].id(),
                                         .body_b = bodies[i + 1].id(),
                                         .length = rest_share * length,
                                         .hertz = hertz,
                                         .damping_ratio = damping_ratio});
            const double turn = 6.2831853 * double(hertz);
            stiffness.push_back(turn * turn / (inverse_mass(i) + inverse_mass(i + 1)));
            lengths.push_back(double(rest_share * length));
        }
    }
    double inverse_mass(size_t i) const {
        return bodies[i].type() == BodyType::static_body ? 0.0 : 1.0 / double(bodies[i].mass());
    }
    /// Without gravity, J.
    double energy() const {
        double sum = 0.0;
        for (const Body& body : bodies)
            if (body.type() == BodyType::dynamic_body) sum += double(body.kinetic_energy());
        for (size_t i = 0; i < stiffness.size(); ++i) {
            const double error =
                double((bodies[i + 1].position() - bodies[i].position()).length()) - lengths[i];
            sum += 0.5 * stiffness[i] * error * error;
        }
        return sum;
    }
};

}  // namespace

TEST_CASE("rows of springs without damping keep their energy even when they swing across") {
    double least = 1.0, most = 1.0;
    for (unsigned seed = 0; seed < seeds_or(50); ++seed) {
        Random random{std::mt19937(seed)};
        Row row(random, random(1, 10), 0.0f, random(0.3f, 1.2f), {});
        const double before = row.energy();
        for (int i = 0; i < 480; ++i) row.world.step(dt);
        least = std::min(least, row.energy() / before);
        most = std::max(most, row.energy() / before);
    }
    std::printf("rows of springs have %.3f to %.3f of their energy after 8 s\n", least, most);
    CHECK(least > 0.8);
    CHECK(most < 1.2);
}

TEST_CASE("rows of springs of any stiffness come to rest") {
    float worst = 0.0f;
    for (unsigned seed = 0; seed < seeds_or(50); ++seed) {
        Random random{std::mt19937(seed)};
        const float hertz = 10.0f * std::pow(50.0f, random(0, 1));
        Row row(random, hertz, random(0.1f, 1), random(0.5f, 1), {0, -10});
        // Springs do not damp what swings across them.
        for (Body& body : row.bodies) body.set_linear_damping(1.0f);
        for (int i = 0; i < 1200; ++i) row.world.step(dt);
        float fastest = 0.0f;
        for (const Body& body : row.bodies) fastest = std::max(fastest, body.velocity().length());
        worst = std::max(worst, fastest);
    }
    std::printf("rows of springs of 10 to 500 Hz: at most %.3f m/s after 20 s\n", double(worst));
    CHECK(worst < 0.05f);
}

/// Joints that are stiffer than the sub-steps can follow would throw a net apart.
TEST_CASE("nets of joints of any stiffness hang still") {
    float worst = 0.0f;
    for (unsigned seed = 0; seed < seeds_or(20); ++seed) {
        Random random{std::mt19937(seed)};
        const float hertz = 30.0f * std::pow(100.0f, random(0, 1));
        const float damping_ratio = random(0.5f, 10);
        const int size = int(random(5, 25)), substeps = int(random(2, 9));
        World world({.substeps = substeps, .sleeping = false});
        std::vector<Body> knots;
        const auto join = [&](const Body& from, const Body& to, Vec2 offset) {
            world.create_revolute_joint({.body_a = from.id(),
                                         .body_b = to.id(),
                                         .anchor_a = offset,
                                         .constraint_hertz = hertz,
                                         .constraint_damping_ratio = damping_ratio});
        };
        for (int y = 0; y < size; ++y) {
            for (int x = 0; x < size; ++x) {
                const bool held = y == 0 && (x % 5 == 0 || x + 1 == size);
                knots.push_back(world.create_body(
                    {.type = held ? BodyType::static_body : BodyType::dynamic_body,
                     .position = {float(x), -float(y)}}));
                knots.back().add(Circle{0.3f});
                const size_t here = knots.size() - 1;
                if (x > 0) join(knots[here - 1], knots[here], {1, 0});
                if (y > 0) join(knots[here - size_t(size)], knots[here], {0, -1});
            }
        }
        for (int i = 0; i < 600; ++i) world.step(dt);
        for (const Body& knot : knots) worst = std::max(worst, knot.velocity().length());
    }
    std::printf("nets of joints of 30 to 3000 Hz: at most %.3f m/s after 10 s\n", double(worst));
    CHECK(worst < 0.5f);
}

/// Bars that turn fast on the end of a soft weld, or of a motor joint with stiffness: the lever of
/// the spring turns with them.
TEST_CASE("a spring at the end of a bar that turns gives it no energy") {
    double most = 0.0;
    for (unsigned seed = 0; seed < seeds_or(50); ++seed) {
        Random random{std::mt19937(seed)};
        World world({.gravity = {}, .sleeping = false});
        const float length = random(0.5f, 2), speed = random(5, 30), hertz = random(2, 8);
        Body bar = world.create_body({.angular_velocity = speed});
        bar.add(Box{.width = length, .height = 0.2f});
        const Vec2 anchor = {random(0.2f, 0.5f) * length, 0.0f};
        if (seed % 2 == 0)
            world.create_weld_joint({.body_b = bar.id(),
                                     .anchor_a = anchor,
                                     .anchor_b = anchor,
                                     .hertz = hertz,
                                     .angular_hertz = 0.0f});
        else
            world.create_motor_joint({.body_b = bar.id(),
                                      .anchor_a = anchor,
                                      .anchor_b = anchor,
                                      .max_force = 1e6f,
                                      .hertz = hertz,
                                      .damping_ratio = 0.0f});
        double early = 0.0, late = 0.0;
        for (int i = 0; i < 1200; ++i) {
            world.step(dt);
            double& energy = i < 300 ? early : late;
            energy = std::max(energy, double(bar.kinetic_energy()));
        }
        most = std::max(most, late / early);
    }
    std::printf("bars on springs have at most %.3f times the energy after 5 to 20 s\n", most);
    CHECK(most < 1.5);
}

}  // namespace spring_family_test
