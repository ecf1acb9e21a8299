#include "wild/generator/random_world.h"

#include <algorithm>

#include "wild/generator/sketch.h"

namespace fettle::bench::wild {
namespace {

void random_settings(Sketch& sketch, int size) {
    Random& random = sketch.random;
    WorldPlan& plan = sketch.plan;
    const float hertz =
        random.chance(0.6) ? 60 : random.one_of({240.0f, 120.0f, 50.0f, 30.0f, 20.0f});
    plan.lengths = {1 / hertz};
    if (random.chance(0.15))  // a frame rate that wavers
        plan.lengths = {1.0f / 60, 1.0f / 58, 1.0f / 30, 1.0f / 60, 1.0f / 144, 1.0f / 20};
    float all = 0;
    for (const float length : plan.lengths) all += length;
    // The last event of a calm world is followed by the time in which it has to come to rest.
    const float seconds = size == 0 ? 1.5f : sketch.calm ? 12.0f : random.number(2, 6);
    plan.steps = int(seconds / all * float(plan.lengths.size()));
    if (random.chance(0.15)) plan.def.substeps = random.one_of({2, 3, 6, 8});
    if (random.chance(0.08)) plan.def.solver = random.one_of({Solver::sequential, Solver::direct});
    if (!sketch.calm && random.chance(0.1)) plan.def.sleeping = false;
}

/// Bodies without weight that meet in empty space, some of them joined.
void random_space(Sketch& sketch) {
    Random& random = sketch.random;
    sketch.plan.def.gravity = {0, 0};
    for (int i = random.whole(1, 4); i > 0; --i) {
        if (random.chance(0.3)) random_joint_of_any_type(sketch, random.number(-3, 3));
        BodyPlan body{.def = {.position = {random.number(-5, 5), random.number(0, 6)},
                              .velocity = {random.number(-8, 8), random.number(-8, 8)},
                              .angular_velocity = random.number(-10, 10)}};
        random_shapes(sketch, body, random.number(0.3f, 2));
        sketch.add(std::move(body));
    }
}

/// Seen from above: no weight, friction against the ground, walls around.
void random_top_down(Sketch& sketch) {
    Random& random = sketch.random;
    sketch.plan.def.gravity = {0, 0};
    sketch.plan.def.bounds = Aabb{{-10, -6}, {10, 6}};
    sketch.plan.def.bounds_restitution = random.one_of({0.0f, 0.8f, 1.0f});
    for (int i = random.whole(2, 12); i > 0; --i) {
        BodyPlan body{.def = {.position = {random.number(-9, 9), random.number(-5, 5)},
                              .velocity = {random.number(-15, 15), random.number(-15, 15)},
                              .linear_damping = random.one_of({0.0f, 0.5f, 2.0f}),
                              .angular_damping = 1,
                              .bullet = random.chance(0.2)}};
        random_shapes(sketch, body, random.number(0.2f, 1));
        sketch.add(std::move(body));
    }
}

/// Several parts side by side on one ground.
void random_level(Sketch& sketch, int size) {
    Random& random = sketch.random;
    random_ground(sketch);
    const int first = random.whole(0, 4);
    for (int i = random.whole(1, size == 0 ? 1 : 3); i > 0; --i) {
        const float x = 6.0f * float((first + i) % 5 - 2);
        const float kind = random.number(0, 1);
        if (kind < 0.5f)
            random_loose_bodies(sketch, x);
        else if (kind < 0.75f || sketch.calm)
            random_contraption(sketch, x);
        else
            random_driven_bodies(sketch, x);
    }
    if (!sketch.calm && random.chance(0.15)) random_fields(sketch);
}

/// A heap of boxes, large enough that several threads share a step. Only the default solver does.
void random_heap(Sketch& sketch) {
    random_ground(sketch);
    sketch.plan.def.solver = Solver::soft_step;
    sketch.plan.steps = 60;
    for (int i = 0; i < 1000; ++i)
        sketch.dynamic({0.52f * float(i % 40 - 20), 0.3f + 0.52f * float(i / 40)},
                       Box{.width = 0.5f, .height = 0.5f});
}

void random_arrivals(Sketch& sketch) {
    sketch.born = sketch.random.whole(1, std::max(1, sketch.plan.steps / 2));
    random_loose_bodies(sketch, 6.0f * float(sketch.random.whole(-2, 2)));
}

}  // namespace

WorldPlan random_world(std::uint64_t seed, int size) {
    Sketch sketch(seed);
    Random& random = sketch.random;
    sketch.calm = random.chance(0.3);
    random_settings(sketch, size);
    const float kind = random.number(0, 1);
    if (size > 0 && random.chance(0.01))
        random_heap(sketch);
    else if (sketch.calm || kind < 0.8f)
        random_level(sketch, size);
    else if (kind < 0.9f)
        random_space(sketch);
    else
        random_top_down(sketch);
    if (!sketch.calm && random.chance(0.4)) random_edits(sketch);
    if (!sketch.calm && random.chance(0.15)) random_arrivals(sketch);
    return std::move(sketch.plan);
}

}  // namespace fettle::bench::wild
