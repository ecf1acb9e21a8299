// Shapes of bodies as games use them, thin and thick.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "wild/generator/sketch.h"

namespace fettle::bench::wild {
namespace {

Vec2 at_angle(float radius, double angle) {
    return tidy(Vec2{float(radius * std::cos(angle)), float(radius * std::sin(angle))});
}

/// A shape is at least 2 cm thick, and 50 times as long at most.
float thickness(Random& random, float size) {
    const float share = random.one_of({1.0f, 0.7f, 0.5f, 0.3f, 0.2f, 0.1f, 0.05f, 0.02f});
    return std::max(tidy(size * share), 0.02f);
}

Polygon polygon(Random& random, float size) {
    const int corners = random.chance(0.1) ? random.whole(9, 24) : random.whole(3, 8);
    const bool regular = random.chance(0.5);
    Polygon drawn;
    for (int i = 0; i < corners; ++i) {
        const double angle =
            2 * std::numbers::pi * (i + (regular ? 0.0f : random.number(0, 0.7f))) / corners;
        drawn.vertices.push_back(at_angle(size / 2, angle));
    }
    if (random.chance(0.3)) drawn.rounding = tidy(random.number(0.01f, 0.2f) * size);
    return drawn;
}

Concave star(Random& random, float size) {
    const int tips = random.whole(4, 8);
    const float inner = random.number(0.2f, 0.6f);
    Concave drawn;
    for (int i = 0; i < 2 * tips; ++i)
        drawn.vertices.push_back(
            at_angle(size / 2 * (i % 2 ? inner : 1), std::numbers::pi * i / tips));
    return drawn;
}

/// An L or a U of arms with the same thickness.
Concave angle_iron(Random& random, float size) {
    const float h = size / 2, t = std::max(0.03f, tidy(size * random.number(0.05f, 0.4f)));
    if (random.chance(0.5))
        return {{{-h, -h}, {h, -h}, {h, -h + t}, {-h + t, -h + t}, {-h + t, h}, {-h, h}}};
    return {{{-h, -h},
             {h, -h},
             {h, h},
             {h - t, h},
             {h - t, -h + t},
             {-h + t, -h + t},
             {-h + t, h},
             {-h, h}}};
}

}  // namespace

Geometry random_geometry(Random& random, float size, bool concave) {
    switch (random.whole(0, concave ? 8 : 6)) {
        case 0:
            return Circle{.radius = size / 2};
        case 1:
            return Box{.width = size, .height = size};
        case 2:
            return Box{.width = size, .height = thickness(random, size)};
        case 3: {
            Box box{.width = size, .height = thickness(random, size)};
            box.rounding = tidy(random.number(0, 0.5f) * box.height);
            return box;
        }
        case 4: {
            const float radius = std::min(thickness(random, size), 0.8f * size) / 2;
            return Segment{{radius - size / 2, 0}, {size / 2 - radius, 0}, radius};
        }
        case 5:
            return polygon(random, size);
        case 6:
            return Ellipse{.radius_x = size / 2, .radius_y = thickness(random, size) / 2};
        case 7:
            return star(random, size);
        default:
            return angle_iron(random, size);
    }
}

void random_shapes(Sketch& sketch, BodyPlan& body, float size) {
    Random& random = sketch.random;
    if (!random.chance(0.15)) {
        body.shapes.push_back({random_geometry(random, size, true), sketch.surface()});
        return;
    }
    const ShapeDef surface = sketch.surface();
    const float h = size / 2, t = std::max(0.05f, tidy(0.2f * size));
    switch (random.whole(0, 2)) {
        case 0:  // a dumbbell
            body.shapes = {{Box{.width = size, .height = t / 2}, surface},
                           {Circle{.radius = t, .center = {-h, 0}}, surface},
                           {Circle{.radius = t, .center = {h, 0}}, surface}};
            break;
        case 1:  // a hammer
            body.shapes = {{Box{.width = size, .height = t / 2}, surface},
                           {Box{.width = t, .height = 2 * t, .center = {h, 0}}, surface}};
            break;
        default:  // a cross
            body.shapes = {{Box{.width = size, .height = t}, surface},
                           {Box{.width = t, .height = size}, surface}};
    }
}

}  // namespace fettle::bench::wild
