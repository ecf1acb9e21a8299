// A drum that turns and tumbles the bodies inside it.

#include <cmath>
#include <numbers>

#include "scenes/catalogue.h"

namespace fettle::bench {
namespace {

constexpr double degree = std::numbers::pi / 180;

Point on_circle(double radius, double angle) {
    return {static_cast<float>(radius * std::cos(angle)),
            static_cast<float>(radius * std::sin(angle))};
}

/// A piece of a ring between two radii and two angles. Its sides are straight.
PolygonShape ring_piece(double inner, double outer, double from, double to) {
    return {{on_circle(inner, from), on_circle(outer, from), on_circle(outer, to),
             on_circle(inner, to)}};
}

}  // namespace

Scene washer() {
    Scene scene{.name = "washer", .steps = 500};
    SceneBody drum{.motion = Motion::kinematic,
                   .position = {0, 10},
                   .velocity = {0.001f, -0.002f},
                   .angular_velocity = static_cast<float>(25 * degree)};
    for (int i = 0; i < 36; ++i) {
        const double from = 10 * i * degree;
        const double to = 10 * (i + 1) * degree;
        drum.shapes.push_back({.geometry = ring_piece(16, 18, from - degree, to + degree)});
        if (i % 9 == 0) drum.shapes.push_back({.geometry = ring_piece(14, 16, from, to)});
    }
    scene.bodies.push_back(drum);

    for (int j = 0; j < 90; ++j) {
        for (int i = 0; i < 90; ++i) {
            SceneBody square = dynamic_box(
                {-9.9f + 0.21f * static_cast<float>(i), 0.1f + 0.21f * static_cast<float>(j)},
                0.1f);
            square.shapes[0].hit_events = true;
            scene.bodies.push_back(square);
        }
    }
    return scene;
}

}  // namespace fettle::bench
