// Queries with points, boxes and rays.

#include <checks/arguments.h>
#include <contacts/border.h>
#include <distance/distance.h>
#include <handles/live.h>
#include <queries/query_lock.h>

#include <algorithm>

namespace fettle::physics {

using namespace detail;

namespace {

bool shape_contains(const WorldData& data, uint32_t shape, const Position& point) {
    const uint32_t body = data.forms[shape].body;
    const Position center = body == none ? Position{} : data.bodies[body].center;
    return signed_distance(data.solid(shape), point - center) <= 0.0f;
}

/// Calls `report(shape)` for each shape of which a part is found, once, until it returns false.
template <class Report>
class Finding {
  public:
    Finding(WorldData& data, Report& report) : data_(data), report_(report) {}
    bool going() const { return going_; }
    void add(uint32_t solid) {
        const Shape shape(data_.self.link->world, data_.shape_id(solid));
        const bool parts = shape.type() == ShapeType::chain || shape.type() == ShapeType::concave;
        if (!parts || found_.add(shape.id())) going_ = report_(shape);
    }

  private:
    WorldData& data_;
    Report& report_;
    FoundShapes found_;
    bool going_ = true;
};

Probe ray_on_shape(const WorldData& data, uint32_t shape, const Position& from, Vec2 d) {
    const Position center = data.bodies[data.forms[shape].body].center;
    return cast_segment(data.solid(shape), from - center, d);
}

/// The border is solid outside: a ray that leaves the bounds ends there.
Probe cast_border(const BorderPlane& plane, const Position& from, Vec2 d) {
    const auto distance = float(dot(plane.normal, from) - plane.depth);
    const float speed = dot(plane.normal, d);
    if (distance < 0.0f || !(speed < 0.0f) || -distance / speed > 1.0f) return {};
    return {-distance / speed, plane.normal};
}

/// Calls `hit(shape, probe)` for every accepted shape that the ray enters; returns the new far end
/// of the ray.
void cast_all(const WorldData& data, const Position& from, const Position& to,
              const QueryFilter& filter, auto&& hit) {
    const Vec2 d = to - from;
    float far = 1.0f;
    auto visit = [&](uint32_t shape, float) {
        if (!is_accepted(data, filter, shape)) return far;
        const Probe probe = ray_on_shape(data, shape, from, d);
        if (probe.fraction <= far) far = hit(shape, probe, far);
        return far;
    };
    data.fixed_tree.cast(from, to, visit);
    data.moving_tree.cast(from, to, visit);
    for (uint32_t side = 0; data.settings.bounds && side < border_sides; ++side) {
        const Probe probe = cast_border(border_plane(*data.settings.bounds, side), from, d);
        if (probe.fraction <= far && is_accepted(data, filter, side)) far = hit(side, probe, far);
    }
}

}  // namespace

bool Shape::contains(const Position& world_point) const {
    FETTLE_REFRESHED_SHAPE(read_all())
    if (record.type == ShapeType::border) return false;
    bool inside = false;
    data.for_each_solid(id_.index,
                        [&](uint32_t s) { inside |= shape_contains(data, s, world_point); });
    return inside;
}

namespace {

void find_at(WorldData& data, const Position& point, const QueryFilter& filter, bool visits,
             auto&& report) {
    check_coordinates("point", point);
    data.read_all();
    QueryLock lock(data, filter, visits);
    Finding finding(data, report);
    auto visit = [&](uint32_t shape) {
        if (finding.going() && is_accepted(data, filter, shape) &&
            shape_contains(data, shape, point))
            finding.add(shape);
    };
    data.moving_tree.query(box_of(point, point), visit);
    data.fixed_tree.query(box_of(point, point), visit);
    lock.finish();
}

void find_in(WorldData& data, const Aabb& box, const QueryFilter& filter, bool visits,
             auto&& report) {
    check_coordinates("box.min", box.min);
    check_coordinates("box.max", box.max);
    data.read_all();
    QueryLock lock(data, filter, visits);
    const Position low = box.min.min(box.max), high = box.min.max(box.max);
    const Box4 area = box_of(low, high);
    const Position center = middle(low, high);
    const Vec2 half = high - center;
    const Vec2 corners[4] = {
        {-half.x, -half.y}, {half.x, -half.y}, {half.x, half.y}, {-half.x, half.y}};
    const Vec2 normals[4] = {{0.0f, -1.0f}, {1.0f, 0.0f}, {0.0f, 1.0f}, {-1.0f, 0.0f}};
    const float offsets[4] = {half.y, half.x, half.y, half.x};
    const Convex probe = {corners, normals, offsets, 4, 0.0f};
    Finding finding(data, report);
    auto visit = [&](uint32_t shape) {
        if (!finding.going() || !is_accepted(data, filter, shape) ||
            !overlap(data.boxes[shape], area))
            return;
        const Vec2 offset = data.bodies[data.forms[shape].body].center - center;
        if (nearest_points({probe}, data.solid(shape), offset).distance <= 0.0f) finding.add(shape);
    };
    data.moving_tree.query(area, visit);
    data.fixed_tree.query(area, visit);
    lock.finish();
}

}  // namespace

std::vector<Shape> World::query_point(const Position& point, const QueryFilter& filter) const {
    std::vector<Shape> found;
    find_at(*data_, point, filter, false, to_list(found));
    return found;
}

void World::visit_point(const Position& point, Visitor<Shape> visitor,
                        const QueryFilter& filter) const {
    find_at(*data_, point, filter, true, to_visitor(*data_, visitor));
}

std::vector<Shape> World::query_aabb(const Aabb& box, const QueryFilter& filter) const {
    std::vector<Shape> found;
    find_in(*data_, box, filter, false, to_list(found));
    return found;
}

void World::visit_aabb(const Aabb& box, Visitor<Shape> visitor, const QueryFilter& filter) const {
    find_in(*data_, box, filter, true, to_visitor(*data_, visitor));
}

namespace {

/// Casts a ray and calls `add(hit)` for each shape that it enters; `add` returns the new far end of
/// the ray.
void cast(WorldData& data, const Position& from, const Position& to, const QueryFilter& filter,
          bool visits, auto&& add) {
    check_coordinates("from", from);
    check_coordinates("to", to);
    data.read_all();
    QueryLock lock(data, filter, visits);
    cast_all(data, from, to, filter, [&](uint32_t shape, const Probe& probe, float far) {
        return add(RayHit{Shape(data.self.link->world, data.shape_id(shape)),
                          from + probe.fraction * (to - from), probe.normal, probe.fraction},
                   far);
    });
    lock.finish();
}

}  // namespace

std::optional<RayHit> World::cast_ray(const Position& from, const Position& to,
                                      const QueryFilter& filter) const {
    std::optional<RayHit> nearest;
    cast(*data_, from, to, filter, false, [&](const RayHit& hit, float) {
        nearest = hit;
        return hit.fraction;
    });
    return nearest;
}

std::vector<RayHit> World::cast_ray_all(const Position& from, const Position& to,
                                        const QueryFilter& filter) const {
    std::vector<RayHit> hits;
    cast(*data_, from, to, filter, false, [&](const RayHit& hit, float far) {
        hits.push_back(hit);
        return far;
    });
    std::stable_sort(hits.begin(), hits.end(),
                     [](const RayHit& a, const RayHit& b) { return a.fraction < b.fraction; });
    return hits;
}

void World::visit_ray(const Position& from, const Position& to, Visitor<RayHit> visitor,
                      const QueryFilter& filter) const {
    const WorldData& data = *data_;
    bool going = true;
    cast(*data_, from, to, filter, true, [&](const RayHit& hit, float far) {
        going = going && goes_on(data, visitor, hit);
        return going ? far : 0.0f;
    });
}

}  // namespace fettle::physics
