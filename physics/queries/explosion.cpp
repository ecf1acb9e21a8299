// An explosion: impulses on the dynamic bodies around a point.

#include <checks/arguments.h>
#include <distance/distance.h>
#include <queries/asking.h>
#include <world/world_data.h>

namespace fettle::physics {

using namespace detail;

void World::explode(const Vec2& point, float radius, float impulse, const QueryFilter& filter) {
    WorldData& data = edit(__func__);
    check_coordinates("point", point);
    check_range("radius", radius, 0.0f, greatest_coordinate);
    check_finite("impulse", impulse);
    data.read_all();
    struct Hit {
        uint32_t body;
        float distance;
        Vec2 at;
    };
    const Vec2 p = point;
    const PointForm asks;
    std::vector<Hit> hits;
    auto visit = [&](uint32_t shape) {
        const uint32_t body = data.forms[shape].body;
        if (data.bodies[body].mobility != Mobility::dynamic || !is_accepted(data, filter, shape))
            return;
        const Vec2 offset = data.bodies[body].center - p;
        const Nearest near = nearest_points(asks.form(), data.solid(shape), offset);
        if (near.distance >= radius) return;
        // If the point is inside a shape, the push acts at the center of mass.
        const Vec2 at = near.distance > 0.0f ? p + near.on_b : data.bodies[body].center;
        for (Hit& hit : hits) {
            if (hit.body != body) continue;
            if (near.distance < hit.distance) hit = {body, near.distance, at};
            return;
        }
        hits.push_back({body, near.distance, at});
    };
    Asking asking(data, filter);
    data.moving_tree.query({{p.x - radius, p.y - radius}, {p.x + radius, p.y + radius}}, visit);
    asking.finish();
    for (const Hit& hit : hits) {
        Vec2 direction = normalized(hit.at - p);
        if (length(direction) == 0.0f) direction = {0.0f, 1.0f};
        const float strength = impulse * (1.0f - hit.distance / radius);
        body(data.body_id(hit.body)).apply_impulse(strength * direction, hit.at);
    }
}

}  // namespace fettle::physics
