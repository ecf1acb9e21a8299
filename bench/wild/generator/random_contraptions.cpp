// Contraptions of several bodies and joints, as games build them.

#include <cmath>
#include <vector>

#include "wild/generator/sketch.h"

namespace fettle::bench::wild {
namespace {

/// Joined links from `from` along `step`; returns the last one. The world holds the first.
int random_links(Sketch& sketch, const Vec2& from, const Vec2& step, int count, float thickness) {
    const float length = step.length(), angle = std::atan2(step.y, step.x);
    const bool capsules = sketch.random.chance(0.5);
    const Geometry link =
        capsules ? Geometry(Segment{{-0.45f * length, 0}, {0.45f * length, 0}, thickness / 2})
                 : Geometry(Box{.width = 0.95f * length, .height = thickness});
    const ShapeDef surface = sketch.surface();
    int last = the_world;
    for (int i = 0; i < count; ++i) {
        const int next =
            sketch.add({.def = {.position = from + (float(i) + 0.5f) * step, .angle = angle},
                        .shapes = {{link, surface}}});
        sketch.joint(JointType::revolute, last, next, from + float(i) * step);
        last = next;
    }
    return last;
}

/// A rope of links, or of balls at distances, with a load at its end.
void random_rope(Sketch& sketch, float x) {
    Random& random = sketch.random;
    const int count = random.whole(3, 12);
    const Vec2 from{x, 9}, step = random.chance(0.5) ? Vec2{0, -0.4f} : Vec2{0.4f, 0};
    const Vec2 end = from + float(count) * step;
    int last = the_world;
    if (random.chance(0.6)) {
        last = random_links(sketch, from, step, count, 0.1f);
    } else {
        for (int i = 0; i < count; ++i) {
            const int next = sketch.dynamic(from + float(i + 1) * step, Circle{.radius = 0.1f});
            sketch
                .joint(JointType::distance, last, next, from + float(i) * step,
                       from + float(i + 1) * step)
                .set({"set_length", {0.4f, 0}});
            last = next;
        }
    }
    const Vec2 below = end + step.normalized() * 0.45f;
    const int load = sketch.dynamic(below, Box{.width = 0.7f, .height = 0.7f});
    sketch.joint(JointType::revolute, last, load, end);
}

void random_bridge(Sketch& sketch, float x) {
    const int count = sketch.random.whole(4, 10);
    const float step = 5.0f / float(count);
    const Vec2 from{x - 2.5f, 4};
    const int last = random_links(sketch, from, {step, 0}, count, 0.15f);
    sketch.joint(JointType::revolute, last, the_world, {x + 2.5f, 4});
    for (int i = sketch.random.whole(0, 2); i > 0; --i)
        sketch.dynamic({x + sketch.random.number(-1, 1), 5 + float(i)},
                       random_geometry(sketch.random, 0.6f, true));
}

/// A trunk with a head, arms and legs, all in one group that does not collide with itself.
void random_ragdoll(Sketch& sketch, float x) {
    Random& random = sketch.random;
    const float y = random.number(1.1f, 6);
    const float friction = random.one_of({0.0f, 0.03f, 1.0f});
    ShapeDef surface = sketch.surface();
    surface.group = -1 - int(sketch.plan.bodies.size());
    const auto bone = [&](const Vec2& from, const Vec2& to, float radius) {
        const Vec2 middle = (from + to) / 2;
        const Vec2 half = (to - from) / 2;
        return sketch.add({.def = {.position = Vec2{x, y} + middle, .angular_damping = friction},
                           .shapes = {{Segment{-half, half, radius}, surface}}});
    };
    const auto hinge = [&](int a, int b, const Vec2& at, float lower, float upper) {
        JointPlan& joint = sketch.joint(JointType::revolute, a, b, Vec2{x, y} + at);
        joint.set({"set_lower_angle", {lower, 0}});
        joint.set({"set_upper_angle", {upper, 0}});
        if (friction > 0) joint.set({"set_max_motor_torque", {friction, 0}});
    };
    const int trunk = bone({0, 0}, {0, 0.45f}, 0.12f);
    const int head = bone({0, 0.68f}, {0, 0.72f}, 0.1f);
    hinge(trunk, head, {0, 0.58f}, -0.5f, 0.5f);
    for (const float side : {-1.0f, 1.0f}) {
        const int thigh = bone({side * 0.08f, -0.1f}, {side * 0.08f, -0.4f}, 0.07f);
        const int shin = bone({side * 0.08f, -0.5f}, {side * 0.08f, -0.8f}, 0.06f);
        const int arm = bone({side * 0.2f, 0.4f}, {side * 0.4f, 0.3f}, 0.05f);
        const int hand = bone({side * 0.45f, 0.3f}, {side * 0.7f, 0.3f}, 0.04f);
        hinge(trunk, thigh, {side * 0.08f, -0.05f}, -1, 1);
        hinge(thigh, shin, {side * 0.08f, -0.45f}, side > 0 ? -2.0f : 0.0f, side > 0 ? 0.0f : 2.0f);
        hinge(trunk, arm, {side * 0.15f, 0.42f}, -2, 2);
        hinge(arm, hand, {side * 0.42f, 0.3f}, -2, 2);
    }
}

void random_car(Sketch& sketch, float x) {
    Random& random = sketch.random;
    const int body = sketch.dynamic({x, 0.8f}, Box{.width = 2, .height = 0.4f, .rounding = 0.1f});
    for (const float side : {-1.0f, 1.0f}) {
        const Vec2 axle{x + 0.7f * side, 0.45f};
        const int wheel = sketch.dynamic(axle, Circle{.radius = 0.35f});
        sketch.body(wheel).shapes[0].def.friction = 1;
        JointPlan& joint = sketch.joint(JointType::wheel, body, wheel, axle);
        joint.set({"set_hertz", {random.one_of({2.0f, 4.0f, 8.0f}), 0}});
        joint.set({"set_lower_translation", {-0.2f, 0}});
        joint.set({"set_upper_translation", {0.2f, 0}});
        if (!sketch.calm) {
            joint.set({"set_motor_speed", {-random.number(0, 20), 0}});
            joint.set({"set_max_motor_torque", {random.one_of({0.0f, 2.0f, 10.0f}), 0}});
        }
    }
}

void random_seesaw(Sketch& sketch, float x) {
    const int plank = sketch.dynamic({x, 0.6f}, Box{.width = 4, .height = 0.15f});
    JointPlan& pin = sketch.joint(JointType::revolute, the_world, plank, {x, 0.6f});
    pin.set({"set_lower_angle", {-0.2f, 0}});
    pin.set({"set_upper_angle", {0.2f, 0}});
    sketch.dynamic({x - 1.5f, 1}, Box{.width = 0.5f, .height = 0.5f});
    sketch.dynamic({x + 1.5f, sketch.random.number(2, 8)}, Box{.width = 0.7f, .height = 0.7f});
}

/// A row of two to six boards, each welded to the next.
void random_welded(Sketch& sketch, float x) {
    Random& random = sketch.random;
    const float y = random.number(2, 6);
    const int count = random.whole(2, 6);
    int last = the_world;
    for (int i = 0; i < count; ++i) {
        const int next =
            sketch.dynamic({x + 0.5f * float(i), y}, Box{.width = 0.5f, .height = 0.2f});
        if (last != the_world) {
            JointPlan& weld =
                sketch.joint(JointType::weld, last, next, {x + 0.5f * float(i) - 0.25f, y});
            if (!sketch.calm && random.chance(0.2)) {
                weld.set({"set_hertz", {random.number(2, 10), 0}});
                weld.set({"set_angular_hertz", {random.number(2, 10), 0}});
            }
        }
        last = next;
    }
}

/// A soft body: a ring of balls that springs connect.
void random_soft(Sketch& sketch, float x) {
    const int count = 8;
    const float radius = 0.8f, y = sketch.random.number(2, 5);
    std::vector<int> ring;
    for (int i = 0; i < count; ++i) {
        const float angle = 2 * 3.14159265f * float(i) / count;
        ring.push_back(sketch.dynamic({x + radius * std::cos(angle), y + radius * std::sin(angle)},
                                      Circle{.radius = 0.15f}));
    }
    const float hertz = sketch.random.number(3, 12);
    for (int i = 0; i < count; ++i)
        for (const int reach : {1, 2, 4}) {
            const int a = ring[std::size_t(i)], b = ring[std::size_t((i + reach) % count)];
            const Vec2 from = sketch.body(a).def.position, to = sketch.body(b).def.position;
            JointPlan& spring = sketch.joint(JointType::distance, a, b, from, to);
            spring.collide = true;
            spring.set({"set_length", {(to - from).length(), 0}});
            spring.set({"set_hertz", {hertz, 0}});
            spring.set({"set_damping_ratio", {0.3f, 0}});
        }
}

/// Two meshed wheels. A motor may turn the small one, and a ratchet may hold the large one.
void random_gears(Sketch& sketch, float x) {
    Random& random = sketch.random;
    ShapeDef none = sketch.surface();
    none.mask = 0;
    const auto wheel = [&](const Vec2& axle, float radius) {
        const int made =
            sketch.add({.def = {.position = axle}, .shapes = {{Circle{.radius = radius}, none}}});
        JointPlan& pin = sketch.joint(JointType::revolute, the_world, made, axle);
        if (radius < 0.5f && random.chance(0.5)) {
            pin.set({"set_motor_speed", {random.number(-6, 6), 0}});
            pin.set({"set_max_motor_torque", {5, 0}});
        }
        return made;
    };
    const int large = wheel({x, 5}, 0.8f), small = wheel({x + 1.2f, 5}, 0.4f);
    JointPlan& gear = sketch.joint(JointType::gear, large, small, {x, 5});
    gear.set({"set_ratio", {-2, 0}});
    if (random.chance(0.4))
        sketch.joint(JointType::ratchet, the_world, large, {x, 5})
            .set({"set_tooth", {random.number(0, 0.5f), 0}});
}

void random_pulley(Sketch& sketch, float x) {
    Random& random = sketch.random;
    const int a = sketch.dynamic({x - 1, 4}, Box{.width = 0.6f, .height = 0.6f});
    const int b =
        sketch.dynamic({x + 1, 4}, Box{.width = random.number(0.3f, 0.9f), .height = 0.6f});
    JointPlan& pulley = sketch.joint(JointType::pulley, a, b, {x - 1, 4.3f}, {x + 1, 4.3f});
    pulley.set({"set_ground_a", {x - 1, 9}});
    pulley.set({"set_ground_b", {x + 1, 9}});
    pulley.set({"set_length", {2 * 4.7f, 0}});
}

/// Pendulums side by side, the first of which is raised.
void random_cradle(Sketch& sketch, float x) {
    const ShapeDef surface{.friction = 0, .restitution = 1};
    const int count = sketch.random.whole(2, 5);
    for (int i = 0; i < count; ++i) {
        const Vec2 hook{x + 0.4f * float(i), 7};
        const Vec2 ball = i == 0 ? hook + Vec2{-1.5f, 0} : hook + Vec2{0, -1.5f};
        const int body =
            sketch.add({.def = {.position = ball}, .shapes = {{Circle{.radius = 0.2f}, surface}}});
        if (sketch.random.chance(0.5))
            sketch.joint(JointType::revolute, the_world, body, hook);
        else
            sketch.joint(JointType::distance, the_world, body, hook, ball)
                .set({"set_length", {1.5f, 0}});
    }
}

}  // namespace

void random_contraption(Sketch& sketch, float x) {
    switch (sketch.random.whole(0, sketch.calm ? 4 : 10)) {
        case 0:
            return random_bridge(sketch, x);
        case 1:
            return random_ragdoll(sketch, x);
        case 2:
            return random_welded(sketch, x);
        case 3:
            return random_seesaw(sketch, x);
        case 4:
            return random_car(sketch, x);
        case 5:
            return random_rope(sketch, x);
        case 6:
            return random_soft(sketch, x);
        case 7:
            return random_gears(sketch, x);
        case 8:
            return random_pulley(sketch, x);
        case 9:
            return random_cradle(sketch, x);
        default:
            return random_joint_of_any_type(sketch, x);
    }
}

}  // namespace fettle::bench::wild
