// Chains and ellipses: bodies that slide over seams, and bodies that rock.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "stability/trial.h"

namespace fettle::bench {
namespace {

constexpr double gravity = 10;

/// The largest upward speed of a body that slides along a level chain at `speed`, m/s.
double kick(const EngineKind& kind, const Geometry& geometry, float speed) {
    Scene scene{.name = "seams", .sleeping = false};
    SceneBody ground{.motion = Motion::fixed};
    ChainShape chain;
    for (int i = 0; i <= 400; ++i) chain.points.push_back({0.37f * static_cast<float>(i) - 20, 0});
    ground.shapes.push_back({.geometry = chain, .friction = 0});
    scene.bodies.push_back(ground);
    SceneBody slider = body_of(Motion::dynamic, {-10, 0.5f}, geometry);
    slider.shapes[0].friction = 0;
    scene.bodies.push_back(slider);
    const auto engine = kind.make(scene);
    run_for(*engine, 1);
    engine->set_velocity(1, {speed, 0});
    double fastest = 0;
    for (int step = 0; step < 150; ++step) {
        engine->step();
        fastest = std::max(fastest, static_cast<double>(engine->motion(1).velocity.y));
    }
    return fastest;
}

double worst_kick(const EngineKind& kind, const Geometry& geometry) {
    double worst = 0;
    for (const float speed : {0.5f, 2.0f, 7.0f, 15.0f, 30.0f})
        worst = std::max(worst, kick(kind, geometry, speed));
    return worst;
}

/// The height of the center of an ellipse on the ground at an angle.
double height(double a, double b, double angle) {
    return std::hypot(a * std::sin(angle), b * std::cos(angle));
}

/// The period of an ellipse that rocks without slipping: ½(I + r²)·θ'² = g·(h₀ - h). r is the
/// distance from the contact to the center, I the moment of inertia for unit mass; a quarter of the
/// period is ∫ dθ/θ'.
double analytic_period(double a, double b, double start) {
    constexpr int parts = 4000;
    double sum = 0;
    for (int i = 0; i < parts; ++i) {
        const double phi = 0.5 * std::numbers::pi * (i + 0.5) / parts;
        const double angle = start * std::sin(phi), h = height(a, b, angle);
        const double along = (a * a - b * b) * std::sin(angle) * std::cos(angle) / h;
        const double inertia = 0.25 * (a * a + b * b) + h * h + along * along;
        const double fallen = height(a, b, start) - h;
        sum += start * std::cos(phi) * std::sqrt(inertia / (2 * gravity * fallen));
    }
    return 4 * sum * 0.5 * std::numbers::pi / parts;
}

}  // namespace

std::vector<Figure> seams_trial(const EngineKind& kind) {
    const SegmentShape capsule{{-0.5f, 0}, {0.5f, 0}, 0.5f};
    return {{"kick of a box", 1000 * worst_kick(kind, BoxShape{}), "mm/s", below(10)},
            {"kick of a circle", 1000 * worst_kick(kind, CircleShape{}), "mm/s", below(10)},
            {"kick of a capsule", 1000 * worst_kick(kind, capsule), "mm/s", below(10)}};
}

/// An ellipse twice as wide as high, released at 0.2 rad; five swings.
std::vector<Figure> ellipse_trial(const EngineKind& kind) {
    if (kind.name != "fettle" && kind.name != "hosted") return {};  // others have no ellipses
    constexpr double a = 1, b = 0.5, start = 0.2;
    Scene scene{.name = "ellipse", .sleeping = false};
    scene.bodies.push_back(fixed_box({0, -1}, {20, 1}));
    scene.bodies.push_back(body_of(Motion::dynamic, {0, static_cast<float>(height(a, b, start))},
                                   EllipseShape{{static_cast<float>(a), static_cast<float>(b)}}));
    scene.bodies[1].angle = static_cast<float>(start);
    for (SceneBody& body : scene.bodies) body.shapes[0].friction = 10;
    const auto engine = kind.make(scene);
    double last = start, first = 0, latest = 0, amplitude = 0;
    for (int step = 1, crossings = 0; crossings < 11 && step < 3600; ++step) {
        engine->step();
        const auto angle = static_cast<double>(engine->motion(1).angle);
        if ((angle < 0) != (last < 0)) {
            latest = static_cast<double>(time_step) * (step - 1 + last / (last - angle));
            if (crossings++ == 0) first = latest;
            if (crossings == 10) amplitude = 0;
        }
        amplitude = std::max(amplitude, std::abs(angle));
        last = angle;
    }
    const double period = (latest - first) / 5;
    return {
        {"period off by", 100 * std::abs(period / analytic_period(a, b, start) - 1), "%", below(2)},
        {"amplitude after five swings", 100 * amplitude / start, "%", {.note = "near 100"}}};
}

}  // namespace fettle::bench
