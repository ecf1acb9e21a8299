// Structures that must stay upright.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "stability/trial.h"

namespace fettle::bench {
namespace {

constexpr double pi = std::numbers::pi;

Scene on_ground(std::string name, bool sleeping) {
    Scene scene{.name = std::move(name), .sleeping = sleeping};
    scene.bodies.push_back(fixed_box({0, -1}, {100, 1}));
    return scene;
}

/// The largest distance of a body from its initial position, m.
double farthest_move(const Engine& engine, const Scene& scene) {
    double farthest = 0;
    for (const std::size_t i : dynamic_bodies(scene)) {
        const Point now = engine.motion(i).position;
        const Point then = scene.bodies[i].position;
        farthest = std::max(farthest, std::hypot(static_cast<double>(now.x) - then.x,
                                                 static_cast<double>(now.y) - then.y));
    }
    return farthest;
}

// Cards of 2 mm × 40 cm. Half-extents, m.
constexpr double card_length = 0.2;
constexpr double card_thickness = 0.001;

SceneBody card(double x, double y, double angle) {
    SceneBody body{.position = {static_cast<float>(x), static_cast<float>(y)},
                   .angle = static_cast<float>(angle)};
    body.shapes.push_back({.geometry = BoxShape{{static_cast<float>(card_thickness),
                                                 static_cast<float>(card_length)}},
                           .friction = 0.7f});
    return body;
}

/// Two cards that lean on each other, on ground at (`x`, `y`). Returns the height of their top.
double add_tent(Scene& scene, double x, double y) {
    constexpr double lean = 25 * pi / 180;  // from upright
    const double offset = card_length * std::sin(lean) + card_thickness * std::cos(lean);
    const double half_height = card_length * std::cos(lean) + card_thickness * std::sin(lean);
    scene.bodies.push_back(card(x - offset, y + half_height, -lean));
    scene.bodies.push_back(card(x + offset, y + half_height, lean));
    return y + 2 * half_height;
}

/// Places flat cards between the tops of neighboring tents; they are `pitch` apart, beginning at
/// `left`. The cards are longer than `pitch`, so every other card lies on the ends of its
/// neighbors. Returns the ground heights for the next level of tents: the height of the middle of
/// each card.
std::vector<double> add_floor(Scene& scene, double left, double pitch,
                              const std::vector<double>& tops) {
    std::vector<double> middles(tops.size() - 1);
    std::vector<double> heights = tops;  // of the surface under each next card
    for (const std::size_t first : {0u, 1u}) {
        for (std::size_t i = first; i + 1 < tops.size(); i += 2) {
            const double tilt = std::atan2(heights[i + 1] - heights[i], pitch);
            const double middle = 0.5 * (heights[i] + heights[i + 1]) + card_thickness;
            scene.bodies.push_back(
                card(left + pitch * (static_cast<double>(i) + 0.5), middle, 0.5 * pi + tilt));
            middles[i] = middle + card_thickness;
            if (first == 1) continue;
            heights[i] += 2 * card_thickness;
            heights[i + 1] += 2 * card_thickness;
        }
    }
    return middles;
}

constexpr int chain_links = 30;
constexpr float chain_link = 0.5f, chain_ball = 0.5f;  // length, radius, m
constexpr double chain_length = chain_links * static_cast<double>(chain_link);

}  // namespace

Scene stack_of(int boxes) {
    Scene scene = on_ground("stack", false);
    for (int i = 0; i < boxes; ++i)
        scene.bodies.push_back(dynamic_box({0, 0.5f + static_cast<float>(i)}, 0.5f));
    return scene;
}

Scene chain_under(double mass_ratio) {
    Scene scene{.name = "chain", .sleeping = false};
    scene.bodies.push_back({.motion = Motion::fixed});
    constexpr float half_width = 0.05f;
    for (int i = 0; i < chain_links; ++i) {
        const float top = -chain_link * static_cast<float>(i);
        scene.bodies.push_back(body_of(Motion::dynamic, {0, top - 0.5f * chain_link},
                                       BoxShape{{half_width, 0.5f * chain_link}}));
        scene.joints.push_back({.body_a = scene.bodies.size() - 2,
                                .body_b = scene.bodies.size() - 1,
                                .anchor = {0, top}});
    }
    const float end = -chain_link * chain_links;
    SceneBody ball = body_of(Motion::dynamic, {0, end - chain_ball}, CircleShape{chain_ball});
    const double link_mass = static_cast<double>(chain_link) * 2 * static_cast<double>(half_width);
    ball.shapes[0].density =
        static_cast<float>(mass_ratio * link_mass / (pi * chain_ball * chain_ball));
    scene.bodies.push_back(ball);
    scene.joints.push_back(
        {.body_a = scene.bodies.size() - 2, .body_b = scene.bodies.size() - 1, .anchor = {0, end}});
    return scene;
}

/// Twelve boxes of one meter, sleeping disabled. Jitter: RMS speed in the sixth second.
std::vector<Figure> stack_trial(const EngineKind& kind) {
    const Scene scene = stack_of(12);
    const auto engine = kind.make(scene);
    run_for(*engine, 5);
    const double jitter = rms_speed(*engine, dynamic_bodies(scene), 60);
    return {{"jitter", 1000 * jitter, "mm/s", below(1)},
            {"farthest move", 1000 * farthest_move(*engine, scene), "mm", below(50)}};
}

/// Five levels of cards; the tents lean 25° from upright.
std::vector<Figure> card_house_trial(const EngineKind& kind) {
    Scene scene = on_ground("card_house", false);
    scene.bodies[0].shapes[0].friction = 0.7f;
    constexpr double pitch = 0.35;
    std::vector<double> grounds(5, 0.0);
    double left = -2 * pitch;
    while (!grounds.empty()) {
        std::vector<double> tops;
        for (std::size_t i = 0; i < grounds.size(); ++i)
            tops.push_back(add_tent(scene, left + pitch * static_cast<double>(i), grounds[i]));
        grounds = add_floor(scene, left, pitch, tops);
        left += 0.5 * pitch;
    }
    const auto engine = kind.make(scene);
    run_for(*engine, 10);
    return {
        {"farthest move in 10 s", 1000 * farthest_move(*engine, scene), "mm", below(50, "stands")}};
}

/// Seventeen wedges of a half ring with radii 9 and 11 m.
std::vector<Figure> arch_trial(const EngineKind& kind) {
    Scene scene = on_ground("arch", false);
    constexpr int blocks = 17;
    constexpr double inner = 9, outer = 11, middle = 10;
    for (int i = 0; i < blocks; ++i) {
        const double from = pi * i / blocks, to = pi * (i + 1) / blocks,
                     between = 0.5 * (from + to);
        const Point center = {static_cast<float>(middle * std::cos(between)),
                              static_cast<float>(middle * std::sin(between))};
        PolygonShape wedge;
        for (const auto& [radius, angle] : {std::pair{inner, from}, std::pair{outer, from},
                                            std::pair{outer, to}, std::pair{inner, to}}) {
            wedge.vertices.push_back({static_cast<float>(radius * std::cos(angle)) - center.x,
                                      static_cast<float>(radius * std::sin(angle)) - center.y});
        }
        scene.bodies.push_back(body_of(Motion::dynamic, center, wedge));
    }
    const auto engine = kind.make(scene);
    run_for(*engine, 10);
    return {{"farthest move in 10 s", 1000 * farthest_move(*engine, scene), "mm",
             below(100, "stands")}};
}

/// Fifteen upright slabs one meter apart; the first is pushed over. A slab has fallen when it leans
/// by more than 45°.
std::vector<Figure> domino_trial(const EngineKind& kind) {
    Scene scene = on_ground("domino", true);
    constexpr int count = 15;
    for (int i = 0; i < count; ++i) {
        scene.bodies.push_back(
            body_of(Motion::dynamic, {static_cast<float>(i) - 7, 0.5f}, BoxShape{{0.125f, 0.5f}}));
    }
    scene.bodies[1].velocity = {0.8f, 0};
    scene.bodies[1].angular_velocity = -4.5f;
    const auto engine = kind.make(scene);
    const auto slabs = dynamic_bodies(scene);
    std::vector<int> fell(slabs.size(), -1);
    for (int step = 0; step < 900; ++step) {
        engine->step();
        for (std::size_t i = 0; i < slabs.size(); ++i) {
            if (fell[i] < 0 && std::abs(engine->motion(slabs[i]).angle) > 0.25 * pi) fell[i] = step;
        }
    }
    int in_order = 0;
    while (in_order < count && fell[static_cast<std::size_t>(in_order)] >= 0 &&
           (in_order == 0 || fell[static_cast<std::size_t>(in_order)] >=
                                 fell[static_cast<std::size_t>(in_order) - 1])) {
        ++in_order;
    }
    return {{"fallen in order", static_cast<double>(in_order), "of 15", exactly(15)}};
}

/// A box of 300 kg on a box of 1 kg, each one meter high. Figure: the deeper of the overlaps below
/// and above the light box.
std::vector<Figure> overload_trial(const EngineKind& kind) {
    Scene scene = on_ground("overload", false);
    scene.bodies.push_back(dynamic_box({0, 0.5f}, 0.5f));
    scene.bodies.push_back(dynamic_box({0, 1.5f}, 0.5f));
    scene.bodies[2].shapes[0].density = 300;
    const auto engine = kind.make(scene);
    run_for(*engine, 5);
    const double light = static_cast<double>(engine->motion(1).position.y);
    const double heavy = static_cast<double>(engine->motion(2).position.y);
    const double deepest = std::max({0.0, 0.5 - light, 1.0 - (heavy - light)});
    return {{"deepest overlap", 100 * deepest, "%", below(5)}};
}

/// The stretch of thirty links under a ball with a hundred times the mass of a link.
std::vector<Figure> chain_trial(const EngineKind& kind) {
    const Scene scene = chain_under(100);
    const auto engine = kind.make(scene);
    run_for(*engine, 5);
    const double low = static_cast<double>(engine->motion(scene.bodies.size() - 1).position.y);
    const double stretch = -chain_length - static_cast<double>(chain_ball) - low;
    return {{"stretch", 100 * stretch / chain_length, "%", below(2)}};
}

}  // namespace fettle::bench
