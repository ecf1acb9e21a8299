// Ragdolls fall on five floors, column by column. When there are forty columns, the oldest is
// removed and falls again. The dimensions of a doll are those of `scripts/ragdoll`.

#include <numbers>

#include "scenes/catalogue.h"

namespace fettle::bench {
namespace {

struct Bone {
    int parent;  // index of the bone; -1: none
    float y, low, high, radius;
    float pivot, lower, upper;  // m, half turns
    float friction;             // of the pin, as a share of 0.05 N m
    float reference = 0;        // half turns
    float damping = 0;
    bool foot = false;
};

constexpr Bone bones[] = {
    {-1, 0.95f, -0.02f, 0.02f, 0.095f, 0, 0, 0, 0},
    {0, 1.2f, -0.135f, 0.135f, 0.09f, 1.0f, -0.25f, 0, 0.5f},
    {1, 1.475f, -0.038f, 0.039f, 0.075f, 1.4f, -0.3f, 0.1f, 0.25f, 0, 0.1f},
    {0, 0.775f, -0.125f, 0.125f, 0.06f, 0.9f, -0.05f, 0.4f, 1},
    {3, 0.475f, -0.155f, 0.125f, 0.045f, 0.625f, -0.5f, -0.02f, 0.5f, 0, 0, true},
    {0, 0.775f, -0.125f, 0.125f, 0.06f, 0.9f, -0.05f, 0.4f, 1},
    {5, 0.475f, -0.155f, 0.125f, 0.045f, 0.625f, -0.5f, -0.02f, 0.5f, 0, 0, true},
    {1, 1.225f, -0.125f, 0.125f, 0.035f, 1.35f, -0.1f, 0.8f, 0.5f},
    {7, 0.975f, -0.125f, 0.125f, 0.03f, 1.1f, -0.2f, 0.3f, 0.1f, 0.25f, 0.1f},
    {1, 1.225f, -0.125f, 0.125f, 0.035f, 1.35f, -0.1f, 0.8f, 0.5f},
    {9, 0.975f, -0.125f, 0.125f, 0.03f, 1.1f, -0.2f, 0.3f, 0.1f, 0.25f, 0.1f},
};

SceneShape skin(const Bone& bone, std::int32_t group) {
    return {.geometry = SegmentShape{{0, bone.low}, {0, bone.high}, bone.radius},
            .friction = 0.2f,
            .category = 2,
            .mask = 3,
            .group = group};
}

SceneShape foot(std::int32_t group) {
    const PolygonShape sole{
        {{-0.03f, -0.185f}, {0.11f, -0.185f}, {0.11f, -0.16f}, {-0.03f, -0.14f}}, 0.015f};
    return {.geometry = sole, .friction = 0.05f, .category = 2, .mask = 1, .group = group};
}

/// A doll with its feet at `place`. `number`: its index in the group.
void add_doll(SceneGroup& to, Point place, int number) {
    constexpr auto half_turn = static_cast<float>(std::numbers::pi);
    const std::size_t first = to.bodies.size();
    for (const Bone& bone : bones) {
        SceneBody body{.position = {place.x, place.y + bone.y}};
        body.linear_damping = bone.damping;
        body.shapes.push_back(skin(bone, -(number + 1)));
        if (bone.foot) body.shapes.push_back(foot(-(number + 1)));
        const std::size_t self = to.bodies.size();
        to.bodies.push_back(std::move(body));
        if (bone.parent < 0) continue;
        to.joints.push_back({.body_a = first + static_cast<std::size_t>(bone.parent),
                             .body_b = self,
                             .anchor = {place.x, place.y + bone.pivot},
                             .motor_torque = 0.05f * bone.friction,
                             .reference = bone.reference * half_turn,
                             .lower = bone.lower * half_turn,
                             .upper = bone.upper * half_turn,
                             .hertz = 5,
                             .damping_ratio = 0.5f});
    }
}

}  // namespace

Scene rain() {
    constexpr int columns = 40, rows = 5, dolls = 5, interval = 8;
    Scene scene{.name = "rain", .steps = 1000};
    // Box2D's revolute joints have no springs, and Chipmunk's have no friction.
    scene.peers.emplace();
    for (int row = 0; row < rows; ++row) {
        SceneBody floor{.motion = Motion::fixed};
        for (int i = 0; i <= 500; ++i) {
            const Point center = {-125 + 0.5f * static_cast<float>(i),
                                  45 * static_cast<float>(row)};
            floor.shapes.push_back({.geometry = BoxShape{{0.25f, 0.25f}, center}});
        }
        scene.bodies.push_back(std::move(floor));
    }
    for (int c = 0; c < columns; ++c) {
        SceneGroup& group = scene.groups.emplace_back();
        for (int row = 0; row < rows; ++row) {
            for (int n = 0; n < dolls; ++n) {
                const float x = -125 + 6.25f * (static_cast<float>(c) + 0.5f);
                add_doll(group,
                         {x + 0.5f * static_cast<float>(n), 40 + 45 * static_cast<float>(row)}, n);
            }
        }
    }
    for (int i = 0; i * interval < scene.steps; ++i)
        scene.arrivals.push_back({i * interval, static_cast<std::size_t>(i % columns)});
    return scene;
}

}  // namespace fettle::bench
