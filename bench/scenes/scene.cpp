#include "scenes/scene.h"

namespace fettle::bench {

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
