// Overlap recovery and impacts.

#include <algorithm>
#include <cmath>

#include "stability/trial.h"

namespace fettle::bench {
namespace {

struct Motions {
    double x = 0, y = 0;  // momentum, kg m/s
    double energy = 0;    // J
};

}  // namespace

/// 625 circles that overlap at first, in a box without gravity; the box is 80 % full.
std::vector<Figure> confined_trial(const EngineKind& kind) {
    Scene scene{.name = "confined", .gravity = {0, 0}, .sleeping = false};
    constexpr float half = 10.5f;
    for (const float side : {-1.0f, 1.0f}) {
        scene.bodies.push_back(fixed_box({side * (half + 1), 0}, {1, half + 2}));
        scene.bodies.push_back(fixed_box({0, side * (half + 1)}, {half + 2, 1}));
    }
    for (int i = 0; i < 25; ++i) {
        for (int j = 0; j < 25; ++j) {
            scene.bodies.push_back(
                body_of(Motion::dynamic,
                        {0.72f * static_cast<float>(i - 12), 0.72f * static_cast<float>(j - 12)},
                        CircleShape{0.42f}));
        }
    }
    const auto engine = kind.make(scene);
    run_for(*engine, 20);
    const double speed = rms_speed(*engine, dynamic_bodies(scene), 60);
    return {{"RMS speed after 20 s", 1000 * speed, "mm/s", below(50, "at rest")}};
}

/// A box with a quarter of it inside the ground: its exit speed and its final position.
std::vector<Figure> overlap_trial(const EngineKind& kind) {
    Scene scene{.name = "overlap", .sleeping = false};
    scene.bodies.push_back(fixed_box({0, -1}, {20, 1}));
    scene.bodies.push_back(dynamic_box({0, 0.25f}, 0.5f));
    const auto engine = kind.make(scene);
    double fastest = 0, highest = 0;
    for (int step = 0; step < 180; ++step) {
        engine->step();
        const BodyMotion box = engine->motion(1);
        fastest = std::max(fastest, static_cast<double>(box.velocity.y));
        highest = std::max(highest, static_cast<double>(box.position.y));
    }
    return {{"fastest way out", fastest, "m/s", at_most(3)},
            {"thrown up", 1000 * std::max(0.0, highest - 0.5), "mm", below(100)}};
}

/// Balls of 10 cm at 300 m/s (five meters per step) against a line, and against a wall 10 cm thick.
std::vector<Figure> bullets_trial(const EngineKind& kind) {
    Scene scene{.name = "bullets", .gravity = {0, 0}};
    scene.bodies.push_back(body_of(Motion::fixed, {}, SegmentShape{{50, -100}, {50, -0.5f}}));
    scene.bodies.push_back(fixed_box({50, 50}, {0.05f, 50}));
    for (int i = -40; i < 40; ++i) {
        // The start distances differ, so that the impacts are spread over a step.
        SceneBody ball = body_of(Motion::dynamic,
                                 {-0.0625f * static_cast<float>(i), static_cast<float>(i) + 0.25f},
                                 CircleShape{0.05f});
        ball.velocity = {300, 0};
        ball.bullet = true;
        scene.bodies.push_back(ball);
    }
    const auto engine = kind.make(scene);
    run_for(*engine, 1);
    int through = 0;
    for (const std::size_t ball : dynamic_bodies(scene))
        through += engine->motion(ball).position.x > 50 ? 1 : 0;
    return {{"went through", static_cast<double>(through), "of 80", exactly(0)}};
}

/// Oblique frictionless collision of a ball with one three times as heavy; restitution 1.
std::vector<Figure> elastic_trial(const EngineKind& kind) {
    Scene scene{.name = "elastic", .gravity = {0, 0}};
    const auto add = [&](Point position, Point velocity, float density) {
        SceneBody ball = body_of(Motion::dynamic, position, CircleShape{0.5f});
        ball.velocity = velocity;
        ball.shapes[0].density = density;
        ball.shapes[0].friction = 0;
        ball.shapes[0].restitution = 1;
        scene.bodies.push_back(ball);
    };
    add({-3, 0}, {8, 0}, 1);
    add({3, 0.4f}, {-4, 0}, 3);
    const auto engine = kind.make(scene);
    const auto total = [&] {
        Motions sum;
        for (std::size_t i = 0; i < 2; ++i) {
            const double mass = static_cast<double>(scene.bodies[i].shapes[0].density);
            const Point v = engine->motion(i).velocity;
            sum.x += mass * static_cast<double>(v.x);
            sum.y += mass * static_cast<double>(v.y);
            sum.energy += 0.5 * mass * std::pow(std::hypot(v.x, v.y), 2);
        }
        return sum;
    };
    const Motions before = total();
    run_for(*engine, 2);
    const Motions after = total();
    const double scale = 1 * 8 + 3 * 4;  // kg m/s; sum of the magnitudes of momentum
    const double momentum = std::hypot(after.x - before.x, after.y - before.y) / scale;
    return {{"momentum lost", momentum, "of all", below(1e-5)},
            {"energy changed", 100 * std::abs(after.energy / before.energy - 1), "%", below(1)},
            {"deflected", static_cast<double>(engine->motion(0).velocity.y), "m/s", other_than(0)}};
}

}  // namespace fettle::bench
