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

namespace {

/// Two plates without contact, and joints between them whose anchors are beside the centers.
struct Pair {
    World world;
    Body a, b;
    JointDef ends;
    Vec2 axis;

    Pair(Random& random, Solver solver, bool meet)
        : world({.gravity = {0, 0}, .sleeping = false, .solver = solver}) {
        for (Body* body : {&a, &b}) {
            const Vec2 at = body == &a ? Vec2{0, 0} : Vec2{random(-1, 1), random(-1, 1)};
            const Vec2 velocity = {random(-3, 3), random(-3, 3)};
            *body = world.create_body(
                {.position = at, .velocity = velocity, .angular_velocity = random(-3, 3)});
            body->add(Box{.width = random(0.6f, 1), .height = 0.4f},
                      {.density = std::exp(random(-1, 3)), .mask = 0});
        }
        const Vec2 of_a = {random(-0.3f, 0.3f), random(-0.2f, 0.2f)};
        const Vec2 of_b = {random(-0.3f, 0.3f), random(-0.2f, 0.2f)};
        ends = {.body_a = a.id(),
                .body_b = b.id(),
                .anchor_a = of_a,
                .anchor_b = meet ? Vec2(b.local_point(a.world_point(of_a))) : of_b};
        const float aside = random(-1, 1);
        axis = {aside, 1};
    }
    template <class Def>
    Def spring(float hertz, float damping_ratio, bool with_axis = false) const {
        Def def = ends;
        def.hertz = hertz;
        def.damping_ratio = damping_ratio;
        if constexpr (requires { def.axis; })
            if (with_axis) def.axis = axis;
        return def;
    }
    void join(int kind, float hertz, float damping_ratio) {
        switch (kind) {
            case 0: {
                auto def = spring<DistanceJointDef>(hertz, damping_ratio);
                def.length = 0.7f;
                world.create_distance_joint(def);
                break;
            }
            case 1:
                world.create_prismatic_joint(spring<PrismaticJointDef>(hertz, damping_ratio, true));
                break;
            case 2:
                world.create_wheel_joint(spring<WheelJointDef>(hertz, damping_ratio, true));
                break;
            case 3:
                world.create_pin_slot_joint(spring<PinSlotJointDef>(hertz, damping_ratio, true));
                break;
            case 4: {
                auto def = spring<MotorJointDef>(hertz, damping_ratio);
                def.max_force = def.max_torque = INFINITY;
                world.create_motor_joint(def);
                break;
            }
            case 5:
                a.set_type(BodyType::static_body);
                world.create_mouse_joint({.body = b.id(),
                                          .target = a.world_point(ends.anchor_a),
                                          .anchor = ends.anchor_b,
                                          .hertz = hertz,
                                          .damping_ratio = damping_ratio});
                break;
            case 6: {
                auto def = spring<WeldJointDef>(hertz, damping_ratio);
                def.angular_hertz = 0;
                world.create_weld_joint(def);
                break;
            }
            default: {
                auto def = spring<WeldJointDef>(hertz, damping_ratio);
                def.angular_hertz = hertz;
                def.angular_damping_ratio = damping_ratio;
                world.create_weld_joint(def);
            }
        }
    }
    double energy() const { return double(a.kinetic_energy()) + double(b.kinetic_energy()); }
    /// Of the joint before the first step, J.
    double energy_of_spring(int kind, float hertz) const {
        const Vec2 gap = b.world_point(ends.anchor_b) - a.world_point(ends.anchor_a);
        double error = double(gap.length());
        if (kind == 0) error -= 0.7;
        const double of_a = kind == 5 ? 0.0 : 1.0 / double(a.mass());
        const double turn = 6.2831853 * double(hertz);
        return 0.5 * turn * turn / (of_a + 1.0 / double(b.mass())) * error * error;
    }
    /// About the origin, kg m²/s.
    double angular_momentum() const {
        double sum = 0.0;
        for (const Body& body : {a, b}) {
            const Vec2 at = body.world_center(), v = body.velocity();
            sum += double(body.inertia() * body.angular_velocity() +
                          body.mass() * (at.x * v.y - at.y * v.x));
        }
        return sum;
    }
};

}  // namespace

TEST_CASE("springs beside the centers of their bodies give them no energy") {
    const int kind = GENERATE(0, 1, 2, 3, 4, 5, 6, 7);
    const Solver solver = GENERATE(Solver::soft_step, Solver::direct);
    const float damping_ratio = GENERATE(0.0f, 0.3f);
    for (unsigned seed = 1; seed <= unsigned(seeds_or(5)); ++seed) {
        Random random{std::mt19937(seed)};
        Pair pair(random, solver, kind != 0 && kind != 4 && kind != 5);
        const float hertz = random(1, 3);
        pair.join(kind, hertz, damping_ratio);
        const double before = pair.energy() + pair.energy_of_spring(kind, hertz);
        double greatest = 0.0;
        for (int i = 0; i < 1200; ++i) {
            pair.world.step(dt);
            greatest = std::max(greatest, pair.energy());
        }
        INFO("kind " << kind << ", seed " << seed << ", " << hertz << " Hz");
        CHECK(greatest < 1.2 * before);
    }
}

TEST_CASE("a spring between two free bodies keeps their angular momentum") {
    const int kind = GENERATE(0, 1, 2, 3, 4, 6, 7);
    const float damping_ratio = GENERATE(0.0f, 0.5f);
    for (unsigned seed = 1; seed <= unsigned(seeds_or(4)); ++seed) {
        Random random{std::mt19937(seed)};
        Pair pair(random, Solver::soft_step, kind != 0 && kind != 4);
        const float hertz = random(1, 3);
        pair.join(kind, hertz, damping_ratio);
        const double before = pair.angular_momentum();
        for (int i = 0; i < 600; ++i) pair.world.step(dt);
        INFO("kind " << kind << ", seed " << seed << ", " << hertz << " Hz");
        CHECK(std::abs(pair.angular_momentum() - before) <
              0.01 * double(pair.a.mass() + pair.b.mass()));
    }
}

TEST_CASE("a hub on many springs comes to rest") {
    const int kind = GENERATE(0, 1, 2);
    const int count = GENERATE(5, 20, 60);
    const float hertz = GENERATE(3.0f, 10.0f, 30.0f);
    World world({.sleeping = false});
    Body ground = world.create_body({.type = BodyType::static_body});
    ground.add(Box{1, 1}, {.mask = 0});
    Body hub = world.create_body({});
    hub.add(Box{1, 1}, {.mask = 0});
    hub.set_velocity({1, 2});
    for (int i = 0; i < count; ++i) {
        const float angle = 6.2831853f * float(i) / float(count);
        const Vec2 at = {0.4f * std::cos(angle), 0.4f * std::sin(angle)};
        if (kind == 0)
            world.create_distance_joint({.body_a = ground.id(),
                                         .body_b = hub.id(),
                                         .anchor_a = 5.0f * at,
                                         .anchor_b = at,
                                         .hertz = hertz,
                                         .damping_ratio = 0.2f});
        else if (kind == 1)
            world.create_weld_joint({.body_a = ground.id(),
                                     .body_b = hub.id(),
                                     .anchor_a = at,
                                     .anchor_b = at,
                                     .hertz = hertz,
                                     .damping_ratio = 0.2f,
                                     .angular_hertz = 0});
        else
            world.create_mouse_joint({.body = hub.id(),
                                      .target = at,
                                      .anchor = at,
                                      .hertz = hertz,
                                      .damping_ratio = 0.2f});
    }
    float fastest = 0.0f;
    for (int i = 0; i < 600; ++i) {
        world.step(dt);
        fastest = std::max(fastest, hub.velocity().length());
    }
    INFO("kind " << kind << ", " << count << " springs of " << hertz << " Hz");
    CHECK(fastest < 5);
    CHECK(hub.velocity().length() < 0.1f);
}

}  // namespace spring_family_test
