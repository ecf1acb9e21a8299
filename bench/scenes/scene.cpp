#include "scenes/scene.h"

namespace fettle::bench {

Point Scene::anchor_a(const SceneJoint& joint) const {
    const Point origin = bodies[joint.body_a].position;
    return {joint.anchor.x - origin.x, joint.anchor.y - origin.y};
}

Point Scene::anchor_b(const SceneJoint& joint) const {
    const Point origin = bodies[joint.body_b].position;
    return {joint.anchor.x - origin.x, joint.anchor.y - origin.y};
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
