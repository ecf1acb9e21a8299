#pragma once
// The sketch to which the parts of the generator add: a plan, the random numbers, and the style of
// the world.

#include <cmath>
#include <utility>

#include "wild/generator/random.h"
#include "wild/plans/plan.h"

namespace fettle::bench::wild {

/// The nearest multiple of 0.001, which a printed world shows as it is.
inline float tidy(float number) {
    return std::round(number * 1000) / 1000;
}
inline Vec2 tidy(const Vec2& v) {
    return {tidy(v.x), tidy(v.y)};
}

struct Sketch {
    WorldPlan plan{};
    Random random;
    /// Nothing bounces, rolls without resistance or is driven, so that everything comes to rest.
    bool calm = false;
    /// The step before which new bodies and joints are made.
    int born = 0;

    explicit Sketch(std::uint64_t seed) : random(seed) { plan.seed = seed; }

    /// Returns its index.
    int add(BodyPlan body) {
        body.born = born;
        body.def.position = tidy(body.def.position);
        plan.bodies.push_back(std::move(body));
        return int(plan.bodies.size()) - 1;
    }
    int fixed(const Vec2& position, const Geometry& geometry) {
        return add({.def = {.type = BodyType::static_body, .position = position},
                    .shapes = {{geometry, ground_surface()}}});
    }
    int dynamic(const Vec2& position, const Geometry& geometry) {
        return add({.def = {.position = position}, .shapes = {{geometry, surface()}}});
    }
    /// A joint at a point of the world; of two bodies, or of the world and one body.
    JointPlan& joint(JointType type, int a, int b, const Vec2& at) {
        return joint(type, a, b, at, at);
    }
    JointPlan& joint(JointType type, int a, int b, const Vec2& at_a, const Vec2& at_b) {
        plan.joints.push_back({.type = type,
                               .a = a,
                               .b = b,
                               .anchor_a = anchor(a, at_a),
                               .anchor_b = anchor(b, at_b),
                               .born = born});
        return plan.joints.back();
    }
    /// The angle of b relative to a at the start.
    float angle_between(int a, int b) const { return angle_of(b) - angle_of(a); }
    BodyPlan& body(int index) { return plan.bodies[std::size_t(index)]; }

    ShapeDef surface() {
        ShapeDef def;
        def.friction =
            calm ? random.number(0.4f, 1) : random.one_of({0.0f, 0.2f, 0.6f, 0.6f, 1.0f, 2.0f});
        if (calm)
            def.rolling_resistance = 0.1f;
        else if (random.chance(0.25))
            def.restitution = random.one_of({0.1f, 0.3f, 0.5f, 0.8f, 1.0f});
        if (random.chance(0.2)) def.density = random.one_of({0.2f, 0.5f, 2.0f, 5.0f});
        if (random.chance(0.1)) def.rolling_resistance = random.number(0, 0.2f);
        return def;
    }
    ShapeDef ground_surface() {
        ShapeDef def;
        def.friction = calm ? 0.6f : random.one_of({0.0f, 0.3f, 0.6f, 0.6f, 1.0f});
        if (!calm && random.chance(0.1)) def.restitution = random.one_of({0.5f, 1.0f});
        if (!calm && random.chance(0.05)) def.surface_speed = random.number(-5, 5);
        return def;
    }

  private:
    float angle_of(int index) const {
        return index == the_world ? 0.0f : plan.bodies[std::size_t(index)].def.angle;
    }
    Vec2 anchor(int index, const Vec2& at) const {
        if (index == the_world) return tidy(at);
        const BodyDef& def = plan.bodies[std::size_t(index)].def;
        return tidy(local(at, def.position, def.angle));
    }
};

// The parts of the generator. `x` is the middle of the place that a part has, which is about 6 m
// wide.

Geometry random_geometry(Random& random, float size, bool concave);
/// Shapes of one body: one of any kind, or several.
void random_shapes(Sketch& sketch, BodyPlan& body, float size);

void random_ground(Sketch& sketch);
void random_loose_bodies(Sketch& sketch, float x);
void random_driven_bodies(Sketch& sketch, float x);
void random_contraption(Sketch& sketch, float x);
void random_joint_of_any_type(Sketch& sketch, float x);
void random_fields(Sketch& sketch);
void random_edits(Sketch& sketch);

}  // namespace fettle::bench::wild
