// Scenes with joints: a grid of joints, and motors that turn a drum and a rotor.

#include <cmath>
#include <limits>
#include <numbers>

#include "scenes/catalogue.h"

namespace fettle::bench {

Scene joint_grid() {
    constexpr int side = 100;
    Scene scene{.name = "joint_grid", .steps = 500, .sleeping = false};
    for (int k = 0; k < side; ++k) {
        for (int i = 0; i < side; ++i) {
            const bool held = i == 0 && 47 <= k && k <= 53;
            const auto x = static_cast<float>(k);
            const auto y = static_cast<float>(-i);
            SceneBody body =
                body_of(held ? Motion::fixed : Motion::dynamic, {x, y}, CircleShape{0.4f});
            body.shapes[0].category = 2;
            body.shapes[0].mask = static_cast<std::uint16_t>(~2u);
            const std::size_t self = scene.bodies.size();
            scene.bodies.push_back(body);
            if (i > 0) scene.joints.push_back({self - 1, self, {x, y + 0.5f}});
            // No joint is necessary between two fixed bodies.
            if (k > 0 && !(held && scene.bodies[self - side].motion == Motion::fixed))
                scene.joints.push_back({self - side, self, {x - 0.5f, y}});
        }
    }
    return scene;
}

Scene tumbler() {
    Scene scene{.name = "tumbler", .steps = 750};
    scene.bodies.push_back({.motion = Motion::fixed});
    SceneBody drum{.position = {0, 10}};
    for (const float side : {-10.0f, 10.0f}) {
        drum.shapes.push_back({.geometry = BoxShape{{0.5f, 10}, {side, 0}}, .density = 50});
        drum.shapes.push_back({.geometry = BoxShape{{10, 0.5f}, {0, side}}, .density = 50});
    }
    scene.bodies.push_back(drum);
    scene.joints.push_back({.body_a = 0,
                            .body_b = 1,
                            .anchor = {0, 10},
                            .motor_speed = static_cast<float>(25 * std::numbers::pi / 180),
                            .motor_torque = 1e8f});
    for (int i = 0; i < 45; ++i) {
        for (int j = 0; j < 45; ++j) {
            scene.bodies.push_back(dynamic_box(
                {-9 + 0.4f * static_cast<float>(i), 1 + 0.4f * static_cast<float>(j)}, 0.125f));
        }
    }
    return scene;
}

Scene spinner() {
    constexpr int corners = 360, count = 6076;
    constexpr float radius = 40;
    Scene scene{.name = "spinner", .steps = 500};
    // Box2D has no rounded polygons.
    scene.peers = {{"chipmunk"}};
    SceneBody ring{.motion = Motion::fixed};
    const auto corner = [](int i) {
        const double angle = 2 * std::numbers::pi * i / corners;
        return Point{radius * static_cast<float>(std::cos(angle)),
                     32 + radius * static_cast<float>(std::sin(angle))};
    };
    // Counter-clockwise, so that the chain is solid outside and holds the bodies inside.
    ChainShape chain;
    chain.closed = true;
    for (int i = 0; i < corners; ++i) chain.points.push_back(corner(i));
    ring.shapes.push_back({.geometry = chain, .friction = 0.1f});
    scene.bodies.push_back(ring);
    SceneBody rotor{.position = {0, 12}, .can_sleep = false};
    rotor.shapes.push_back(
        {.geometry = BoxShape{.half = {0.4f, 20}, .rounding = 0.2f}, .friction = 0});
    scene.bodies.push_back(rotor);
    scene.joints.push_back({.body_a = 0,
                            .body_b = 1,
                            .anchor = {0, 12},
                            .motor_speed = 5,
                            .motor_torque = std::numeric_limits<float>::max()});
    for (int i = 0; i < count; ++i) {
        const Point place = {-23 + 0.5f * static_cast<float>(i % 92),
                             2 + 0.5f * static_cast<float>(i / 92)};
        const Geometry geometry = i % 3 == 0
                                      ? Geometry(SegmentShape{{-0.25f, 0}, {0.25f, 0}, 0.25f})
                                  : i % 3 == 1 ? Geometry(CircleShape{0.35f})
                                               : Geometry(BoxShape{{0.35f, 0.35f}});
        SceneBody body = body_of(Motion::dynamic, place, geometry);
        body.shapes[0].density = 0.25f;
        body.shapes[0].friction = 0.1f;
        body.shapes[0].restitution = 0.1f;
        scene.bodies.push_back(body);
    }
    return scene;
}

}  // namespace fettle::bench
