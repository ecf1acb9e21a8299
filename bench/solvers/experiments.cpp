#include "solvers/experiments.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "measure/timing.h"
#include "scenes/catalogue.h"
#include "stability/trial.h"

namespace fettle::bench {
namespace {

/// One curve per solver.
template <class Fill>
std::vector<Curve> curves(Fill&& fill) {
    std::vector<Curve> all;
    for (const SolverKind& kind : solver_kinds()) {
        Curve& curve = all.emplace_back();
        curve.name = kind.name;
        fill(kind, curve);
    }
    return all;
}

/// How far a body is below the height at which it should be, m.
double sunk_by(const Engine& engine, std::size_t body, double supposed) {
    return supposed - static_cast<double>(engine.motion(body).position.y);
}

/// A rod of two meters that is released from the horizontal.
Scene pendulum() {
    Scene scene{.name = "pendulum", .sleeping = false};
    scene.bodies.push_back({.motion = Motion::fixed});
    scene.bodies.push_back(body_of(Motion::dynamic, {2, 0}, CircleShape{0.2f}));
    scene.joints.push_back({.body_a = 0, .body_b = 1, .anchor = {0, 0}});
    return scene;
}

}  // namespace

std::span<const SolverKind> solver_kinds() {
    static constexpr std::array<SolverKind, 3> kinds = {{
        {"soft_step", physics::Solver::soft_step},
        {"sequential", physics::Solver::sequential},
        {"direct", physics::Solver::direct},
    }};
    return kinds;
}

EngineKind engine_of(const SolverKind& kind, int substeps) {
    return {kind.name,
            [solver = kind.solver, substeps](const Scene& scene) {
                return make_fettle(scene, solver, substeps);
            },
            ""};
}

double step_time(Engine& engine, int steps) {
    for (int i = 0; i < 10; ++i) engine.step();
    std::vector<double> ms;
    for (int i = 0; i < steps; ++i) {
        const ThreadClock clock;
        engine.step();
        ms.push_back(clock.elapsed_ms());
    }
    return median(ms);
}

Plot jitter_plot() {
    Plot plot{.title = "A stack of twelve boxes: does it come to rest?",
              .x_label = "time, s",
              .y_label = "RMS speed, m/s",
              .y_logarithmic = true};
    plot.curves = curves([](const SolverKind& kind, Curve& curve) {
        const Scene scene = stack_of(12);
        const auto engine = engine_of(kind).make(scene);
        const auto boxes = dynamic_bodies(scene);
        for (int i = 0; i < 60; ++i) {
            const double speed = rms_speed(*engine, boxes, 6);
            curve.x.push_back(0.1 * (i + 1));
            curve.y.push_back(std::max(speed, 1e-8));
        }
    });
    return plot;
}

Plot load_plot() {
    Plot plot{.title = "A box under 300 times its weight: how far it sinks in",
              .x_label = "sub-steps of a step",
              .y_label = "deepest overlap, m",
              .x_logarithmic = true,
              .y_logarithmic = true,
              .points = true};
    plot.curves = curves([](const SolverKind& kind, Curve& curve) {
        for (const int substeps : {1, 2, 4, 8, 16, 32}) {
            Scene scene = stack_of(2);
            scene.bodies[2].shapes[0].density = 300;
            const auto engine = engine_of(kind, substeps).make(scene);
            run_for(*engine, 5);
            const double overlap = std::max(sunk_by(*engine, 1, 0.5),
                                            sunk_by(*engine, 2, 1.5) - sunk_by(*engine, 1, 0.5));
            curve.x.push_back(substeps);
            curve.y.push_back(std::max(overlap, 1e-7));
        }
    });
    return plot;
}

Plot chain_plot() {
    Plot plot{.title = "A chain of thirty links under a load: how far it stretches",
              .x_label = "mass of the load over that of a link",
              .y_label = "stretch, %",
              .x_logarithmic = true,
              .y_logarithmic = true,
              .points = true};
    plot.curves = curves([](const SolverKind& kind, Curve& curve) {
        for (const double ratio : {1.0, 10.0, 100.0, 1000.0}) {
            const Scene scene = chain_under(ratio);
            const auto engine = engine_of(kind).make(scene);
            run_for(*engine, 5);
            const std::size_t ball = scene.bodies.size() - 1;
            const double stretch = sunk_by(*engine, ball, -15.5) / 15;
            curve.x.push_back(ratio);
            curve.y.push_back(std::clamp(100 * stretch, 1e-5, 1e4));
        }
    });
    return plot;
}

Plot energy_plot() {
    // J/kg, from the horizontal to the lowest point, 2 m below it.
    constexpr double swing = 20;
    Plot plot{.title = "A pendulum: what is left of its energy",
              .x_label = "time, s",
              .y_label = "energy, % of the swing"};
    plot.curves = curves([](const SolverKind& kind, Curve& curve) {
        const auto engine = engine_of(kind).make(pendulum());
        for (int i = 0; i < 60; ++i) {
            run_for(*engine, 0.5);
            const BodyMotion ball = engine->motion(1);
            const double speed = std::hypot(ball.velocity.x, ball.velocity.y);
            // A disc with a radius of 20 cm on a rigid rod rotates with the rod.
            const double spin = static_cast<double>(ball.angular_velocity);
            const double energy = 0.5 * speed * speed + 0.25 * 0.04 * spin * spin +
                                  10 * static_cast<double>(ball.position.y);
            curve.x.push_back(0.5 * (i + 1));
            curve.y.push_back(100 * (1 + energy / swing));
        }
    });
    return plot;
}

Plot cost_plot() {
    Plot plot{.title = "A step of a pyramid: what it costs",
              .x_label = "boxes",
              .y_label = "time of a step, ms",
              .x_logarithmic = true,
              .y_logarithmic = true,
              .points = true};
    plot.curves = curves([](const SolverKind& kind, Curve& curve) {
        for (const int rows : {2, 4, 7, 12, 20, 31}) {
            const Scene scene = pyramid_of(rows);
            const auto engine = engine_of(kind).make(scene);
            curve.x.push_back(0.5 * rows * (rows + 1));
            curve.y.push_back(step_time(*engine, rows > 15 ? 10 : 40));
        }
    });
    return plot;
}

std::span<const Experiment> experiments() {
    static constexpr std::array<Experiment, 5> all = {{{"jitter", jitter_plot},
                                                       {"load", load_plot},
                                                       {"chain", chain_plot},
                                                       {"energy", energy_plot},
                                                       {"cost", cost_plot}}};
    return all;
}

}  // namespace fettle::bench
