#include "scenes/scene.h"

#include <algorithm>

namespace fettle::bench {

bool Scene::runs_on(std::string_view engine) const {
    return !peers || engine == "fettle" || engine == "hosted" ||
           std::find(peers->begin(), peers->end(), engine) != peers->end();
}

Point local_anchor(const std::vector<SceneBody>& bodies, std::size_t body, Point anchor) {
    const Point origin = bodies[body].position;
    return {anchor.x - origin.x, anchor.y - origin.y};
}

Point Scene::anchor_a(const SceneJoint& joint) const {
    return local_anchor(bodies, joint.body_a, joint.anchor);
}

Point Scene::anchor_b(const SceneJoint& joint) const {
    return local_anchor(bodies, joint.body_b, joint.anchor);
}

SceneBody body_of(Motion motion, Point position, Geometry geometry) {
    SceneBody body{.motion = motion, .position = position};
    body.shapes.resize(1);
    body.shapes[0].geometry = std::move(geometry);
    return body;
}

SceneBody dynamic_box(Point position, float half) {
    return body_of(Motion::dynamic, position, BoxShape{{half, half}});
}

SceneBody fixed_box(Point position, Point half) {
    return body_of(Motion::fixed, position, BoxShape{half});
}

}  // namespace fettle::bench
