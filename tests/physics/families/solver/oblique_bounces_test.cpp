// Impacts with friction and restitution: the corner of a box or a polygon on a face, flat boxes,
// balls with a spin, any two bodies. Friction turns a body that is hit beside its center, so both
// need to be right together.

#include <fettle/physics/physics.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "catch.h"
#include "family.h"

namespace oblique_bounces_test {

using namespace fettle::physics;
using families::Random;
using families::seeds_or;
using families::turned;

namespace {

const float rates[] = {30, 60, 144, 240};

double motion_of(const std::vector<Body>& bodies) {
    double sum = 0;
    for (const Body& body : bodies)
        if (body.type() == BodyType::dynamic_body)
            sum += 0.5 * double(body.mass() * body.velocity().length_squared() +
                                body.inertia() * body.angular_velocity() * body.angular_velocity());
    return sum;
}

/// The velocity of a place of a body; `arm`: from its center.
Vec2 velocity_at(const Body& body, Vec2 arm) {
    const float turn = body.angular_velocity();
    return body.velocity() + Vec2{-turn * arm.y, turn * arm.x};
}

/// A box, a plank or a polygon, by its corners around the center.
std::vector<Vec2> random_corners(Random& random, unsigned kind) {
    std::vector<Vec2> corners;
    if (kind % 3 == 2) {
        const int count = int(random(3, 8));
        const float radius = random(0.3f, 0.8f);
        for (int i = 0; i < count; ++i)
            corners.push_back(radius * turned(6.2831853f * float(i) / float(count)));
        return corners;
    }
    const float x = random(0.15f, 0.5f), y = kind % 3 == 0 ? random(0.15f, 0.5f) : 0.2f * x;
    return {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
}

void add_any_form(Body body, Random& random, const ShapeDef& surface) {
    const auto kind = unsigned(random(0, 4));
    if (kind == 3)
        body.add(Circle{random(0.2f, 0.5f)}, surface);
    else
        body.add(Polygon{.vertices = random_corners(random, kind)}, surface);
}

}  // namespace

TEST_CASE("a corner that hits a face follows the laws of restitution and of friction") {
    double worst = 0;
    unsigned hits = 0;
    for (unsigned seed = 0; seed < seeds_or(1200); ++seed) {
        Random random{std::mt19937(seed)};
        const float rate = rates[seed % 4], dt = 1 / rate;
        const ShapeDef surface = {.friction = random(0, 1.2f), .restitution = random(0.05f, 0.95f)};
        World world({.gravity = {0, 0}});
        const bool free = seed % 8 >= 4;
        Body floor =
            world.create_body({.type = free ? BodyType::dynamic_body : BodyType::static_body,
                               .position = {0, -0.5f}});
        floor.add(Box{.width = 20, .height = 1}, surface);
        if (free) floor.set_mass(random(1, 20));
        const std::vector<Vec2> corners = random_corners(random, seed);
        const float speed = random(3, 12), angle = random(0, 6.28f);
        Body body = world.create_body({.position = {0, random(1, 1.5f)},
                                       .angle = angle,
                                       .velocity = {random(-6, 6), -speed},
                                       .angular_velocity = random(-2, 2)});
        body.add(Polygon{.vertices = corners}, surface);
        const Vec2 before = body.velocity();
        Vec2 arm_a, arm_b, v_before;
        bool clear = true;
        for (int i = 0; i < int(rate); ++i) {
            // The corners, by height.
            std::vector<Vec2> arms;
            const Vec2 x = turned(body.angle()), y = {-x.y, x.x};
            for (const Vec2 c : corners) arms.push_back(c.x * x + c.y * y);
            std::sort(arms.begin(), arms.end(), [](Vec2 a, Vec2 b) { return a.y < b.y; });
            clear = arms[1].y - arms[0].y > 3 * speed * dt;
            arm_b = arms[0];
            arm_a = {body.position().x + arm_b.x, 0.5f};
            v_before = velocity_at(body, arm_b);
            world.step(dt);
            if ((body.velocity() - before).length() > 0.1f) break;
        }
        if (!clear || v_before.y > -1.5f) continue;
        ++hits;
        const Vec2 v_after = velocity_at(body, arm_b) - velocity_at(floor, arm_a);
        const Vec2 impulse = body.mass() * (body.velocity() - before);
        const float wanted = -surface.restitution * v_before.y;
        INFO("seed " << seed << ", restitution " << surface.restitution << ", friction "
                     << surface.friction);
        CHECK(std::fabs(v_after.y - wanted) < 0.01f * speed);
        worst = std::max(worst, double(std::fabs(v_after.y - wanted) / speed));
        const float greatest = surface.friction * impulse.y;
        CHECK(std::fabs(impulse.x) < 1.001f * greatest + 0.001f);
        if (std::fabs(impulse.x) > 0.99f * greatest)
            CHECK(v_after.x * impulse.x <= 0.01f);
        else if (surface.restitution < 0.7f)
            CHECK(std::fabs(v_after.x) < 0.03f * v_before.length());
    }
    std::printf("corners: %u hits, the speed differs from the restitution by %.4f at most\n", hits,
                worst);
    CHECK(hits > seeds_or(1200) / 4);
}

TEST_CASE("a flat box that lands with sideways speed leaves without a spin") {
    for (unsigned seed = 0; seed < seeds_or(200); ++seed) {
        Random random{std::mt19937(seed)};
        const float rate = rates[seed % 4];
        const ShapeDef surface = {.friction = random(0, 0.8f), .restitution = random(0.1f, 1)};
        World world({.gravity = {0, 0}});
        world.create_body({.type = BodyType::static_body})
            .add(Box{.width = 40, .height = 1, .center = {0, -0.5f}}, surface);
        const float speed = random(3, 10), sideways = random(-8, 8);
        Body box =
            world.create_body({.position = {0, random(1, 2)}, .velocity = {sideways, -speed}});
        // The whole impulse of friction goes through the box, not beside it.
        box.add(Box{.width = random(0.8f, 1.5f), .height = random(0.3f, 0.8f)}, surface);
        for (int i = 0; i < int(rate) && box.velocity().y < 0; ++i) world.step(1 / rate);
        world.step(1 / rate);
        INFO("seed " << seed << ", restitution " << surface.restitution);
        CHECK(box.velocity().y == Approx(surface.restitution * speed).epsilon(0.01));
        CHECK(std::fabs(box.angular_velocity()) < 0.02f);
        const float most = surface.friction * (1 + surface.restitution) * speed;
        const float left = std::max(std::fabs(sideways) - most, 0.0f);
        CHECK(std::fabs(box.velocity().x) == Approx(left).margin(0.02));
    }
}

TEST_CASE("a ball with a spin bounces by Coulomb's law") {
    for (unsigned seed = 0; seed < seeds_or(200); ++seed) {
        Random random{std::mt19937(seed)};
        const float rate = rates[seed % 4], radius = random(0.2f, 0.5f);
        const ShapeDef surface = {.friction = random(0, 1), .restitution = random(0.1f, 1)};
        World world({.gravity = {0, 0}});
        Body floor = world.create_body(
            {.type = seed % 3 == 1 ? BodyType::kinematic_body : BodyType::static_body});
        if (seed % 3 == 2)
            floor.add(Chain{.points = {{-40, 0}, {-10, 0}, {0, 0}, {10, 0}, {40, 0}}}, surface);
        else
            floor.add(Box{.width = 80, .height = 1, .center = {0, -0.5f}}, surface);
        const float speed = random(2, 12), sideways = random(-8, 8), spin = random(-20, 20);
        Body ball = world.create_body({.position = {0, radius + random(0.5f, 1)},
                                       .velocity = {sideways, -speed},
                                       .angular_velocity = spin});
        ball.add(Circle{radius}, surface);
        for (int i = 0; i < int(rate) && ball.velocity().y < 0; ++i) world.step(1 / rate);
        const float slip = sideways + spin * radius;
        const float change =
            std::min(std::fabs(slip) / 3, surface.friction * (1 + surface.restitution) * speed);
        INFO("seed " << seed << ", restitution " << surface.restitution);
        CHECK(ball.velocity().y == Approx(surface.restitution * speed).epsilon(0.01));
        CHECK(ball.velocity().x == Approx(sideways - std::copysign(change, slip)).margin(0.01));
        CHECK(ball.angular_velocity() * radius ==
              Approx(spin * radius - std::copysign(2 * change, slip)).margin(0.02));
    }
}

TEST_CASE("friction adds no energy to an elastic impact") {
    double most = 0;
    for (unsigned seed = 0; seed < seeds_or(1000); ++seed) {
        Random random{std::mt19937(seed)};
        const float rate = rates[seed % 4];
        const ShapeDef surface = {.friction = random(0, 2), .restitution = 1};
        World world({.gravity = {0, 0}});
        Body a =
            world.create_body({.type = seed % 3 ? BodyType::dynamic_body : BodyType::static_body});
        a.set_angle(random(0, 6.28f));
        add_any_form(a, random, surface);
        if (seed % 3) {
            a.set_velocity({random(-2, 2), random(-2, 2)});
            a.set_angular_velocity(random(-10, 10));
        }
        const Vec2 from = turned(random(0, 6.28f));
        const float speed = random(2, 12);
        Body b = world.create_body({.position = 3 * from,
                                    .angle = random(0, 6.28f),
                                    .velocity = -speed * from + Vec2{random(-2, 2), random(-2, 2)},
                                    .angular_velocity = random(-10, 10)});
        add_any_form(b, random, surface);
        const double before = motion_of({a, b});
        for (int i = 0; i < int(1.2f * rate); ++i) world.step(1 / rate);
        const double kept = motion_of({a, b}) / before;
        INFO("seed " << seed << ", friction " << surface.friction);
        CHECK(kept < 1.001);
        most = std::max(most, kept);
    }
    std::printf("elastic impacts with friction keep at most %.4f of the energy\n", most);
}

TEST_CASE("a gas of boxes with friction gains no energy") {
    for (unsigned seed = 0; seed < seeds_or(8); ++seed) {
        Random random{std::mt19937(seed)};
        const ShapeDef surface = {.friction = random(0.1f, 1), .restitution = 1};
        World world({.gravity = {0, 0}});
        Body room = world.create_body({.type = BodyType::static_body});
        for (const float side : {-1.0f, 1.0f}) {
            room.add(Box{.width = 24, .height = 2, .center = {0, 11 * side}}, surface);
            room.add(Box{.width = 2, .height = 24, .center = {11 * side, 0}}, surface);
        }
        std::vector<Body> bodies;
        for (int i = 0; i < 36; ++i) {
            const Vec2 place = {-7.5f + 3 * float(i % 6), -7.5f + 3 * float(i / 6)};
            bodies.push_back(
                world.create_body({.position = place, .velocity = {random(-5, 5), random(-5, 5)}}));
            add_any_form(bodies.back(), random, surface);
        }
        double last = motion_of(bodies);
        for (int i = 0; i < 600; ++i) {
            world.step(1.0f / 60);
            const double now = motion_of(bodies);
            INFO("seed " << seed << ", step " << i);
            CHECK(now < 1.005 * last);
            last = now;
        }
        CHECK(last > 0);
    }
}

TEST_CASE("two welded boxes bounce as one body does") {
    double sum = 0;
    const unsigned count = seeds_or(200);
    for (unsigned seed = 0; seed < count; ++seed) {
        Vec2 velocity[2];
        float speed = 0;
        for (const bool welded : {false, true}) {
            Random random{std::mt19937(seed)};
            const float rate = seed % 2 ? 60 : 240;
            const ShapeDef surface = {.friction = 0, .restitution = random(0.3f, 1)};
            World world({.gravity = {0, 0}});
            world.create_body({.type = BodyType::static_body})
                .add(Box{.width = 40, .height = 1, .center = {0, -0.5f}}, surface);
            const float width = random(0.3f, 1), height = random(0.2f, 0.8f);
            const float angle = random(0, 6.28f);
            speed = random(2, 10);
            const Vec2 start = {random(-5, 5), -speed}, middle = {0, 2.5f};
            const Vec2 along = turned(angle);
            std::vector<Body> bodies;
            for (const float side : {-0.5f, 0.5f}) {
                const Vec2 place = welded ? middle + side * width * along : middle;
                if (welded || bodies.empty())
                    bodies.push_back(
                        world.create_body({.position = place, .angle = angle, .velocity = start}));
                const Vec2 center = {welded ? 0 : side * width, 0};
                bodies.back().add(Box{.width = width, .height = height, .center = center}, surface);
            }
            if (welded)
                world.create_weld_joint({.body_a = bodies[0].id(),
                                         .body_b = bodies[1].id(),
                                         .anchor_a = {0.5f * width, 0},
                                         .anchor_b = {-0.5f * width, 0}});
            for (int i = 0; i < int((2.5f / speed + 0.05f) * rate); ++i) world.step(1 / rate);
            velocity[welded] = bodies[0].velocity();
            if (welded) velocity[1] = 0.5f * (velocity[1] + bodies[1].velocity());
        }
        sum += double((velocity[1] - velocity[0]).length() / speed);
    }
    std::printf("welded boxes: %.3f of the speed from that of one body in the mean\n", sum / count);
    CHECK(sum / count < 0.02);
}

}  // namespace oblique_bounces_test
