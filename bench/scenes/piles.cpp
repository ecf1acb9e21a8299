// Scenes with falling and colliding bodies: contacts begin and end.

#include <cmath>
#include <numbers>

#include "scenes/catalogue.h"

namespace fettle::bench {

Scene smash() {
    Scene scene{.name = "smash", .steps = 300, .gravity = {0, 0}};
    SceneBody ram = dynamic_box({-20, 0}, 4);
    ram.velocity = {40, 0};
    ram.shapes[0].density = 8;
    scene.bodies.push_back(ram);
    for (int i = 0; i < 120; ++i) {
        for (int j = 0; j < 80; ++j) {
            SceneBody square = dynamic_box(
                {30 + 0.4f * static_cast<float>(i), 0.4f * static_cast<float>(j - 40)}, 0.2f);
            square.awake = false;
            scene.bodies.push_back(square);
        }
    }
    return scene;
}

Scene compounds() {
    Scene scene{.name = "compounds", .steps = 500};
    for (int i = 0; i < 81; ++i)
        scene.bodies.push_back(fixed_box({-40 + static_cast<float>(i), 0}, {0.55f, 0.5f}));
    for (const float x : {-40.0f, 40.0f}) {
        for (int i = 0; i < 100; ++i)
            scene.bodies.push_back(fixed_box({x, 1 + static_cast<float>(i)}, {0.5f, 0.55f}));
    }
    scene.bodies.push_back(body_of(Motion::fixed, {}, SegmentShape{{-800, -80}, {800, -80}}));

    const PolygonShape left{{{-1, 0}, {0.5f, 1}, {0, 2}}};
    const PolygonShape right{{{1, 0}, {0, 2}, {-0.5f, 1}}};
    for (int i = 0; i < 20; ++i) {
        for (int j = 0; j < 150; ++j) {
            const float shift = j % 2 == 0 ? 0.25f : -0.25f;
            SceneBody body{.position = {2 * static_cast<float>(i) - 19 + shift,
                                        2.25f * static_cast<float>(j) + 5.575f}};
            body.shapes.push_back({.geometry = left, .friction = 0.5f});
            body.shapes.push_back({.geometry = right, .friction = 0.5f});
            scene.bodies.push_back(body);
        }
    }
    return scene;
}

Scene junkyard() {
    Scene scene{.name = "junkyard", .steps = 800};
    for (int i = 0; i < 161; ++i)
        scene.bodies.push_back(fixed_box({-80 + static_cast<float>(i), 0}, {0.55f, 0.5f}));
    for (const float x : {-80.0f, 80.0f}) {
        for (int i = 0; i < 50; ++i)
            scene.bodies.push_back(fixed_box({x, 1 + static_cast<float>(i)}, {0.5f, 0.55f}));
    }

    SceneBody pusher = body_of(Motion::kinematic, {}, BoxShape{{2, 4}, {0, 4}});
    pusher.path = [](double time) {
        return Point{static_cast<float>(60 * std::sin(0.2 * time)), 0};
    };
    scene.bodies.push_back(pusher);

    // Five points on a circle, in their order around it.
    PolygonShape pentagon;
    for (const int n : {0, 2, 4, 1, 3}) {
        const double angle = n * std::numbers::pi * (std::sqrt(5.0) - 1);
        pentagon.vertices.push_back({static_cast<float>(0.25 * std::cos(angle)),
                                     static_cast<float>(0.25 * std::sin(angle))});
    }
    for (int i = 0; i < 200; ++i) {
        for (int j = 0; j < 40; ++j) {
            const float shift = j % 2 == 0 ? -0.1f : 0.1f;
            scene.bodies.push_back(body_of(
                Motion::dynamic,
                {0.375f * static_cast<float>(2 * i - 200) + shift, static_cast<float>(j) + 15},
                pentagon));
        }
    }
    return scene;
}

Scene crowd() {
    return crowd_of(100, 100);
}

namespace {

/// A bin whose floor is at height 0.
void add_bin(Scene& scene, float half_width, float height) {
    scene.bodies.push_back(fixed_box({0, -0.5f}, {half_width + 1, 0.5f}));
    for (const float side : {-1.0f, 1.0f})
        scene.bodies.push_back(fixed_box({side * (half_width + 0.5f), height}, {0.5f, height}));
}

}  // namespace

Scene crowd_of(int columns, int rows) {
    Scene scene{.name = "crowd", .steps = 300, .sleeping = false};
    constexpr float pitch = 0.6f;
    const float half_width = 0.5f * pitch * static_cast<float>(columns) + 0.2f;
    add_bin(scene, half_width, pitch * static_cast<float>(rows));
    for (int j = 0; j < rows; ++j) {
        const float shift = j % 2 == 0 ? -0.05f : 0.05f;
        for (int i = 0; i < columns; ++i) {
            const Point at = {pitch * (static_cast<float>(i) + 0.5f) - half_width + 0.2f + shift,
                              pitch * static_cast<float>(j) + 0.3f};
            scene.bodies.push_back((i + j) % 2 == 0
                                       ? dynamic_box(at, 0.25f)
                                       : body_of(Motion::dynamic, at, CircleShape{0.25f}));
        }
    }
    return scene;
}

Scene pile_of(int columns, int rows) {
    Scene scene{.name = "pile", .steps = 300, .sleeping = false};
    constexpr float pitch = 0.52f, half = 0.25f, shift = 0.13f;
    const float half_width = 0.5f * pitch * static_cast<float>(columns) + shift;
    add_bin(scene, half_width, pitch * static_cast<float>(rows));
    for (int j = 0; j < rows; ++j) {
        const float left =
            (j % 2 == 0 ? -shift : shift) + 0.5f * pitch * static_cast<float>(1 - columns);
        for (int i = 0; i < columns; ++i)
            scene.bodies.push_back(dynamic_box({left + pitch * static_cast<float>(i),
                                                half + (2 * half + 0.002f) * static_cast<float>(j)},
                                               half));
    }
    return scene;
}

}  // namespace fettle::bench
