// Scenes with stacks: load for the solver and the narrow phase, while the boxes hardly move.

#include "scenes/catalogue.h"

namespace fettle::bench {
namespace {

/// A pyramid of squares with half-extent 0.5 that stands on `ground`. `left`: position of its lower
/// left square.
void add_pyramid(Scene& scene, int base, float left, float ground) {
    constexpr float half = 0.5f;
    for (int i = 0; i < base; ++i) {
        const float y = ground + static_cast<float>(2 * i + 1) * half;
        for (int j = i; j < base; ++j) {
            const float x = left + static_cast<float>(i) * half + static_cast<float>(j - i);
            scene.bodies.push_back(dynamic_box({x, y}, half));
        }
    }
}

}  // namespace

Scene pyramid_of(int base) {
    Scene scene{.name = "pyramid", .sleeping = false};
    scene.bodies.push_back(fixed_box({0, -1}, {100, 1}));
    add_pyramid(scene, base, 0.5f - 0.5f * static_cast<float>(base), 0);
    return scene;
}

Scene large_pyramid() {
    Scene scene = pyramid_of(100);
    scene.name = "large_pyramid";
    scene.steps = 500;
    return scene;
}

Scene many_pyramids() {
    Scene scene = pyramids_of(400);
    scene.name = "many_pyramids";
    scene.steps = 200;
    return scene;
}

Scene pyramids_of(int count) {
    Scene scene{.name = "pyramids", .sleeping = false};
    constexpr int base = 10;
    constexpr int columns = 20;
    constexpr float pitch = 11;
    constexpr float reach = 110;
    for (int r = 0; r * columns < count; ++r) {
        const float ground = pitch * static_cast<float>(r);
        scene.bodies.push_back(
            body_of(Motion::fixed, {}, SegmentShape{{-reach, ground}, {reach, ground}}));
        for (int c = 0; c < columns && r * columns + c < count; ++c) {
            const float center = -reach + pitch * static_cast<float>(c) + 1;
            add_pyramid(scene, base, center, ground);
        }
    }
    return scene;
}

}  // namespace fettle::bench
