#include <collision/large_polygon.h>
#include <world/world_data.h>

// In the pool, the vertices of a large polygon are centered on the body's center of mass but not
// rotated. They change with an edit only, and a step costs them a bounding box.

namespace fettle::physics::detail {

void WorldData::place_large(uint32_t shape, Rotation q) {
    ShapeForm& form = forms[shape];
    V2 center, local_center;
    if (form.body != none) {
        center = bodies[form.body].center;
        local_center = bodies[form.body].local_center;
    }
    const V2 first = pool.local[form.begin] - local_center;
    if (pool.vertices[form.begin].x != first.x || pool.vertices[form.begin].y != first.y) {
        for (uint32_t i = form.begin; i < form.begin + form.count; ++i) {
            pool.vertices[i] = pool.local[i] - local_center;
            pool.directions[i] = pool.normals[i];
            pool.offsets[i] = dot(pool.normals[i], pool.vertices[i]);
        }
    }
    const Convex polygon = convex(shape);
    const auto reach = [&](V2 direction) {
        const V2 d = unrotate(q, direction);
        return dot(d, polygon.vertices[farthest_vertex(polygon, d)]);
    };
    form.center = center;
    const Box4 box = {{-reach({-1.0f, 0.0f}), -reach({0.0f, -1.0f})},
                      {reach({1.0f, 0.0f}), reach({0.0f, 1.0f})}};
    boxes[shape] = grow({center + box.low, center + box.high}, form.radius);
}

}  // namespace fettle::physics::detail
