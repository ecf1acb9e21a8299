// Explosions: impulses on the dynamic bodies around a point.

#include <checks/arguments.h>
#include <distance/distance.h>
#include <queries/query_lock.h>
#include <world/world_data.h>

#include <algorithm>
#include <vector>

namespace fettle::physics {

using namespace detail;

void World::explode(const Position& point, float radius, float impulse, const QueryFilter& filter) {
    WorldData& data = edit(__func__);
    check_coordinates("point", point);
    check_range("radius", radius, 0.0f, greatest_coordinate);
    check_finite("impulse", impulse);
    data.read_all();
    struct Hit {
        uint32_t body;
        float distance;
        Position at;
    };
    const Position p = point;
    const PointForm probe;
    std::vector<Hit> hits;
    auto visit = [&](uint32_t shape) {
        const uint32_t body = data.forms[shape].body;
        if (data.bodies[body].mobility != Mobility::dynamic || !is_accepted(data, filter, shape))
            return;
        const Vec2 offset = data.bodies[body].center - p;
        const Nearest near = nearest_points(probe.form(), data.solid(shape), offset);
        if (near.distance >= radius) return;
        // If the point is inside a shape, the push acts at the center of mass.
        const Position at = near.distance > 0.0f ? p + near.on_b : data.bodies[body].center;
        for (Hit& hit : hits) {
            if (hit.body != body) continue;
            if (near.distance < hit.distance) hit = {body, near.distance, at};
            return;
        }
        hits.push_back({body, near.distance, at});
    };
    QueryLock lock(data, filter);
    data.moving_tree.query(box_around(p, {{-radius, -radius}, {radius, radius}}), visit);
    lock.finish();
    for (const Hit& hit : hits) {
        Vec2 direction = normalized(hit.at - p);
        if (length(direction) == 0.0f) direction = {0.0f, 1.0f};
        const float strength = impulse * (1.0f - hit.distance / radius);
        body(data.body_id(hit.body)).apply_impulse(strength * direction, hit.at);
    }
}

namespace {

/// A shape seen from the center of an explosion.
struct Target {
    uint32_t shape = none, body = none;
    Nearest nearest;
    float width = 0.0f;  ///< of its outline, across the direction to its nearest point, m
};

/// `shape`: not a part.
Target find_target(const WorldData& data, uint32_t shape, const Position& point) {
    const PointForm probe;
    Target target = {shape, data.forms[shape].body, {}, 0.0f};
    const Vec2 offset = data.bodies[target.body].center - point;
    target.nearest.distance = infinity;
    data.for_each_solid(shape, [&](uint32_t solid) {
        const Nearest near = nearest_points(probe.form(), data.solid(solid), offset);
        if (near.distance < target.nearest.distance) target.nearest = near;
    });
    // If the point is inside, the push acts at the center of mass and away from the point.
    if (!(target.nearest.distance > 0.0f)) {
        target.nearest.on_b = offset;
        target.nearest.normal = length(offset) > 1e-6f ? normalized(offset) : Vec2{0.0f, 1.0f};
    }
    const Vec2 across = right_perp(target.nearest.normal);
    float right = -infinity, left = -infinity;
    data.for_each_solid(shape, [&](uint32_t solid) {
        right = max(right, reach(data.solid(solid), across));
        left = max(left, reach(data.solid(solid), -across));
    });
    target.width = right + left;
    return target;
}

}  // namespace

void World::explode(const ExplosionDef& def, const QueryFilter& filter) {
    WorldData& data = edit(__func__);
    check_coordinates("point", def.point);
    check_range("radius", def.radius, 0.0f, greatest_coordinate);
    check_range("falloff", def.falloff, 0.0f, greatest_coordinate);
    check_finite("impulse_per_length", def.impulse_per_length);
    data.read_all();
    const Position p = def.point;
    const float far = def.radius + def.falloff;
    std::vector<Target> targets;
    auto visit = [&](uint32_t solid) {
        const uint32_t shape = data.shape_id(solid).index;  // a part stands for its outline
        const auto is_same = [&](const Target& target) { return target.shape == shape; };
        if (data.bodies[data.forms[solid].body].mobility != Mobility::dynamic ||
            std::any_of(targets.begin(), targets.end(), is_same) ||
            !is_accepted(data, filter, solid))
            return;
        const Target target = find_target(data, shape, p);
        if (target.nearest.distance <= far) targets.push_back(target);
    };
    QueryLock lock(data, filter);
    data.moving_tree.query(box_around(p, {{-far, -far}, {far, far}}), visit);
    lock.finish();
    for (const Target& target : targets) {
        const float beyond = max(target.nearest.distance - def.radius, 0.0f);
        const float share = def.falloff > 0.0f ? max(1.0f - beyond / def.falloff, 0.0f) : 1.0f;
        const float strength = share * def.impulse_per_length * target.width;
        const Vec2 impulse = bounded(strength * target.nearest.normal, 1e30f);
        body(data.body_id(target.body)).apply_impulse(impulse, p + target.nearest.on_b);
    }
}

}  // namespace fettle::physics
