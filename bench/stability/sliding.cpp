// Sliding and rolling, compared with the analytic result.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "stability/trial.h"

namespace fettle::bench {
namespace {

constexpr double sliding_gravity = 10;
constexpr double slope = 20 * std::numbers::pi / 180;

/// A fixed plank whose top surface passes through the origin and descends towards +x at the angle
/// `slope`.
SceneBody plank(float friction) {
    constexpr double half_thickness = 1;
    SceneBody body = body_of(Motion::fixed,
                             {static_cast<float>(-half_thickness * std::sin(slope)),
                              static_cast<float>(-half_thickness * std::cos(slope))},
                             BoxShape{{200, static_cast<float>(half_thickness)}});
    body.angle = static_cast<float>(-slope);
    body.shapes[0].friction = friction;
    return body;
}

/// A point above the origin at distance `height` from the surface of the plank.
Point above_plank(double height) {
    return {static_cast<float>(height * std::sin(slope)),
            static_cast<float>(height * std::cos(slope))};
}

/// Distance moved down the plank, m.
double descent(const Engine& engine, std::size_t body, Point from) {
    const Point now = engine.motion(body).position;
    return (static_cast<double>(now.x) - from.x) * std::cos(slope) -
           (static_cast<double>(now.y) - from.y) * std::sin(slope);
}

/// The distance that a box with friction μ slides down the plank in two seconds.
double slide(const EngineKind& kind, double friction) {
    Scene scene{.name = "sliding", .sleeping = false};
    scene.bodies.push_back(plank(static_cast<float>(friction)));
    SceneBody box = dynamic_box(above_plank(0.5), 0.5f);
    box.angle = static_cast<float>(-slope);
    box.shapes[0].friction = static_cast<float>(friction);
    scene.bodies.push_back(box);
    const auto engine = kind.make(scene);
    run_for(*engine, 2);
    return descent(*engine, 1, box.position);
}

/// The largest upward speed of a body that slides over forty flush tiles at 5 m/s, m/s.
double kick(const EngineKind& kind, Geometry geometry) {
    Scene scene{.name = "tiles", .sleeping = false};
    for (int i = 0; i < 40; ++i)
        scene.bodies.push_back(fixed_box({static_cast<float>(i), -0.5f}, {0.5f, 0.5f}));
    scene.bodies.push_back(body_of(Motion::dynamic, {3, 0.5f}, std::move(geometry)));
    scene.bodies.back().velocity = {5, 0};
    for (SceneBody& body : scene.bodies) body.shapes[0].friction = 0;
    const auto engine = kind.make(scene);
    double fastest = 0;
    for (int step = 0; step < 360; ++step) {
        engine->step();
        fastest = std::max(fastest,
                           static_cast<double>(engine->motion(scene.bodies.size() - 1).velocity.y));
    }
    return fastest;
}

}  // namespace

std::vector<Figure> tiles_trial(const EngineKind& kind) {
    return {{"kick of a box", 1000 * kick(kind, BoxShape{{0.5f, 0.5f}}), "mm/s", below(50)},
            {"kick of a circle", 1000 * kick(kind, CircleShape{0.5f}), "mm/s", below(50)}};
}

/// A disc rolls with the acceleration g sin θ / (1 + I/(m r²)) = ⅔ g sin θ.
std::vector<Figure> rolling_trial(const EngineKind& kind) {
    Scene scene{.name = "rolling", .sleeping = false};
    scene.bodies.push_back(plank(1));
    scene.bodies.push_back(body_of(Motion::dynamic, above_plank(0.5), CircleShape{0.5f}));
    scene.bodies.back().shapes[0].friction = 1;
    const auto engine = kind.make(scene);
    // The difference of two distances excludes the first contact.
    run_for(*engine, 1);
    const double first = descent(*engine, 1, scene.bodies[1].position);
    run_for(*engine, 1);
    const double second = descent(*engine, 1, scene.bodies[1].position) - first;
    const double acceleration = second - first;  // s(2) - 2 s(1), over 1 s²
    const double analytic = sliding_gravity * std::sin(slope) * 2 / 3;
    return {{"acceleration off by", 100 * std::abs(acceleration / analytic - 1), "%", below(1)}};
}

/// With 5 % more friction than tan θ a box must stay; with 5 % less it must slide with g (sin θ - μ
/// cos θ).
std::vector<Figure> sliding_trial(const EngineKind& kind) {
    const double limit = std::tan(slope);
    const double held = slide(kind, 1.05 * limit);
    const double slid = slide(kind, 0.95 * limit);
    const double analytic =
        0.5 * sliding_gravity * (std::sin(slope) - 0.95 * limit * std::cos(slope)) * 2 * 2;
    return {{"creep when held", 1000 * std::abs(held) / 2, "mm/s", below(5)},
            {"slide off by", 100 * std::abs(slid / analytic - 1), "%", below(10)}};
}

}  // namespace fettle::bench
