// Bodies without joints, which fall, fly, stand in stacks and lie in piles.

#include <algorithm>

#include "wild/generator/sketch.h"

namespace fettle::bench::wild {
namespace {

void random_falling(Sketch& sketch, float x) {
    Random& random = sketch.random;
    for (int i = random.whole(1, 5); i > 0; --i) {
        BodyPlan body{.def = {.position = {x + random.number(-2, 2), random.number(2, 14)},
                              .angle = random.number(0, 6.28f)}};
        if (random.chance(0.5)) {
            body.def.velocity = {random.number(-10, 10), random.number(-30, 5)};
            body.def.angular_velocity = random.number(-50, 50);
        }
        random_shapes(sketch, body, random.number(0.2f, 2));
        sketch.add(std::move(body));
    }
}

void random_stack(Sketch& sketch, float x) {
    Random& random = sketch.random;
    const int count = random.whole(2, 15);
    const float width = random.number(0.5f, 1.5f), height = width * random.number(0.4f, 1);
    const float aside = random.one_of({0.0f, 0.0f, 0.01f, 0.02f});
    for (int i = 0; i < count; ++i)
        sketch.dynamic({x + random.number(-aside, aside), height * (float(i) + 0.5f)},
                       Box{.width = width, .height = height});
}

void random_pyramid(Sketch& sketch, float x) {
    const int rows = sketch.random.whole(2, 6);
    for (int row = 0; row < rows; ++row)
        for (int i = 0; i < rows - row; ++i)
            sketch.dynamic(
                {x + 0.55f * (float(i) - 0.5f * float(rows - row - 1)), 0.25f + 0.5f * float(row)},
                Box{.width = 0.5f, .height = 0.5f});
}

void random_pile(Sketch& sketch, float x) {
    Random& random = sketch.random;
    const float size = random.number(0.2f, 0.6f);
    const Geometry like = random_geometry(random, size, true);
    const bool all_alike = random.chance(0.6);
    const ShapeDef surface = sketch.surface();
    for (int i = random.whole(8, 30), k = 0; k < i; ++k)
        sketch.add({.def = {.position = {x + 1.1f * size * float(k % 5 - 2),
                                         size + 1.1f * size * float(k / 5)},
                            .angle = random.number(0, 3)},
                    .shapes = {{all_alike ? like : random_geometry(random, size, true), surface}}});
}

/// Posts and beams.
void random_house(Sketch& sketch, float x) {
    const int floors = sketch.random.whole(1, 4);
    for (int i = 0; i < floors; ++i) {
        const float y = 1.2f * float(i);
        for (const float side : {-1.0f, 1.0f})
            sketch.dynamic({x + 0.8f * side, y + 0.5f}, Box{.width = 0.2f, .height = 1});
        sketch.dynamic({x, y + 1.1f}, Box{.width = 2, .height = 0.2f});
    }
}

void random_dominoes(Sketch& sketch, float x) {
    for (int i = 0; i < 8; ++i)
        sketch.dynamic({x - 2 + 0.5f * float(i), 0.5f}, Box{.width = 0.1f, .height = 1});
    BodyPlan& first = sketch.body(int(sketch.plan.bodies.size()) - 8);
    first.def.angular_velocity = -2;
}

/// A fixed wall, a loose wall or a ball, and fast bodies that fly at it.
void random_shots(Sketch& sketch, float x) {
    Random& random = sketch.random;
    const int target = random.whole(0, 2);
    const float thickness = random.one_of({0.05f, 0.1f, 0.5f});
    if (target == 0)
        sketch.fixed({x + 2, 1.5f}, Box{.width = thickness, .height = 3});
    else if (target == 1)
        sketch.dynamic({x + 2, 1.5f}, Box{.width = std::max(thickness, 0.1f), .height = 3});
    else
        sketch.dynamic({x + 2, 0.5f}, Circle{});
    for (int i = random.whole(1, 3); i > 0; --i) {
        BodyPlan body{.def = {.position = {x - 2, random.number(0.5f, 2.5f)},
                              .velocity = {random.number(10, 200), random.number(-3, 3)},
                              .angular_velocity = random.number(-20, 20),
                              .bullet = random.chance(0.7)}};
        body.shapes = {
            {random_geometry(random, random.number(0.1f, 0.5f), false), sketch.surface()}};
        sketch.add(std::move(body));
    }
}

/// A sensor, and a body that crosses it.
void random_gate(Sketch& sketch, float x) {
    Random& random = sketch.random;
    const int gate = sketch.fixed({x + 1, 2}, Box{.width = random.number(0.3f, 1), .height = 4});
    sketch.body(gate).shapes[0].def = {.sensor = true};
    const float speed = random.one_of({3.0f, 20.0f, 60.0f, 300.0f});
    BodyPlan body{.def = {.position = {x - 2, 2}, .velocity = {speed, 0}, .gravity_scale = 0.1f}};
    random_shapes(sketch, body, random.number(0.2f, 1));
    sketch.add(std::move(body));
}

/// Balls in a row, the first of which hits the others.
void random_balls_in_a_row(Sketch& sketch, float x) {
    const ShapeDef surface{.friction = sketch.random.one_of({0.0f, 0.6f}), .restitution = 1};
    for (int i = 0; i < 5; ++i)
        sketch.add({.def = {.position = {x - 2 + (i > 0 ? 0.5f : 0.0f) + 0.4f * float(i), 0.2f}},
                    .shapes = {{Circle{.radius = 0.2f}, surface}}});
    sketch.body(int(sketch.plan.bodies.size()) - 5).def.velocity = {sketch.random.number(1, 8), 0};
}

}  // namespace

void random_loose_bodies(Sketch& sketch, float x) {
    switch (sketch.random.whole(0, sketch.calm ? 5 : 9)) {
        case 0:
            return random_stack(sketch, x);
        case 1:
            return random_pyramid(sketch, x);
        case 2:
            return random_pile(sketch, x);
        case 3:
            return random_house(sketch, x);
        case 4:
            return random_dominoes(sketch, x);
        case 5:
        case 6:
            return random_falling(sketch, x);
        case 7:
            return random_shots(sketch, x);
        case 8:
            return random_gate(sketch, x);
        default:
            return random_balls_in_a_row(sketch, x);
    }
}

}  // namespace fettle::bench::wild
