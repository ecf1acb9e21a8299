#include <checks/arguments.h>
#include <contacts/border.h>
#include <distance/distance.h>
#include <forms/form_access.h>
#include <geometry/kept_list.h>
#include <queries/query_lock.h>
#include <world/world_data.h>

#include <span>
#include <stdexcept>

// Queries with shapes and distances. The query shape may be of any world. If it is detached, its
// coordinates are those of the queried world.

namespace fettle::physics {

using namespace detail;

namespace {

/// A solid shape at its position.
struct Placed {
    Solid form;
    Position center;
    Box4 box;
};

/// Adds the shape itself, or its parts.
void add_placed(WorldData& data, uint32_t shape, std::vector<Placed>& all) {
    data.read_all();
    if (data.forms[shape].kind == FormKind::border)
        throw std::invalid_argument("expected a shape of a body, got the bounds of a world");
    const uint32_t body = data.forms[shape].body;
    const Position center = body == none ? Position{} : data.bodies[body].center;
    data.for_each_solid(shape, [&](uint32_t solid) {
        all.push_back({data.solid(solid), center, data.boxes[solid]});
    });
}

/// Locks one world while the other is refreshed: a callback of the user must neither edit nor
/// destroy it.
template <class Read>
void with_other_locked(const WorldData& read, const WorldData& other, Read read_it) {
    std::optional<WorldLock> lock;
    if (&read != &other) lock.emplace(other.self, WorldLock::During::query, in_refresh);
    read_it();
    if (lock) lock->finish();
}

/// Adds the parts of the query shape. Updates the queried world as well.
void add_probes(WorldData& queried, WorldData& from, uint32_t shape, std::vector<Placed>& probes) {
    with_other_locked(from, queried, [&] { add_placed(from, shape, probes); });
    with_other_locked(queried, from, [&] { queried.read_all(); });
}

/// The fraction of its motion after which a moving shape meets the border.
float meets_border(const Placed& probe, Vec2 motion, const BorderPlane& plane) {
    const auto before =
        float(dot(plane.normal, probe.center) - reach(probe.form, -plane.normal) - plane.depth);
    const float speed = dot(plane.normal, motion);
    if (before <= 0.0f) return 0.0f;
    return speed < 0.0f ? -before / speed : 2.0f;
}

}  // namespace

namespace detail {

bool is_accepted(const WorldData& data, const QueryFilter& filter, uint32_t shape) {
    const ShapeDef& surface = data.shapes[shape].surface;
    if (surface.sensor && !filter.sensors) return false;
    const bool same_group = filter.group != 0 && surface.group == filter.group;
    if (same_group && filter.group < 0) return false;
    if (!same_group &&
        ((surface.mask & filter.category) == 0 || (surface.category & filter.mask) == 0))
        return false;
    if (!filter.accept) return true;
    const bool accepts = filter.accept(Shape(data.self.link->world, data.shape_id(shape)));
    if (data.self.orphaned()) data.self.throw_orphaned();
    return accepts;
}

}  // namespace detail

Separation distance(const Shape& a, const Shape& b) {
    Separation nearest;
    nearest.distance = infinity;
    WorldData &of_a = a.live(), &of_b = b.live();
    const uint32_t shape_a = a.index(), shape_b = b.index();
    KeptList<Placed> parts_a, parts_b;
    with_other_locked(of_a, of_b, [&] { add_placed(of_a, shape_a, *parts_a); });
    with_other_locked(of_b, of_a, [&] { add_placed(of_b, shape_b, *parts_b); });
    for (const Placed& pa : *parts_a) {
        for (const Placed& pb : *parts_b) {
            const Nearest found = nearest_points(pa.form, pb.form, pb.center - pa.center);
            if (found.distance >= nearest.distance) continue;
            nearest = {found.distance, pa.center + found.on_a, pa.center + found.on_b,
                       found.normal};
        }
    }
    return nearest;
}

namespace {

/// What a query searches for: convex parts, and the body whose own shapes are left out.
struct Sought {
    std::span<const Placed> parts;
    uint32_t body = none;
};

/// Calls `search(sought)` with a shape of any world. Its own world is locked like the other one.
template <class Search>
void search_for(WorldData& data, WorldData& from, uint32_t shape, const QueryFilter& filter,
                bool visits, Search search) {
    KeptList<Placed> parts;
    add_probes(data, from, shape, *parts);
    QueryLock lock(from, filter, visits);
    search(Sought{*parts, &from == &data ? data.forms[shape].body : none});
    lock.finish();
}

/// The same with a geometry that is in no world.
template <class Search>
void search_for(WorldData& data, const Form& form, const Pose& pose, Search search) {
    const PosedForm at(FormAccess::data(form), check_pose("pose", pose));
    data.read_all();
    KeptList<Placed> parts;
    for (const Solid& solid : at.solids())
        parts->push_back({solid, at.center(), box_around(at.center(), box_of(solid))});
    search(Sought{*parts});
}

/// Calls `report(shape)` for each shape that overlaps another one, once, until it returns false.
void find_overlaps(WorldData& data, const Sought& sought, const QueryFilter& filter, bool visits,
                   auto&& report) {
    QueryLock lock(data, filter, visits);
    FoundShapes found;
    bool going = true;
    for (const Placed& probe : sought.parts) {
        auto visit = [&](uint32_t other) {
            const uint32_t owner = data.forms[other].body;
            if (!going || owner == sought.body || !is_accepted(data, filter, other)) return;
            const Vec2 offset = data.bodies[owner].center - probe.center;
            if (nearest_points(probe.form, data.solid(other), offset).distance <= 0.0f &&
                found.add(data.shape_id(other)))
                going = report(Shape(data.self.link->world, data.shape_id(other)));
        };
        data.moving_tree.query(probe.box, visit);
        data.fixed_tree.query(probe.box, visit);
    }
    lock.finish();
}

/// The first shape that the parts meet along `d`.
std::optional<RayHit> cast_parts(WorldData& data, const Sought& sought, Vec2 d,
                                 const QueryFilter& filter) {
    QueryLock lock(data, filter);
    World* const self = data.self.link->world;
    std::optional<RayHit> first;
    float nearest = 1.0f;
    for (const Placed& probe : sought.parts) {
        const Box4 swept = unite(probe.box, {probe.box.low + d, probe.box.high + d});
        auto visit = [&](uint32_t other) {
            const uint32_t owner = data.forms[other].body;
            if (owner == sought.body || !is_accepted(data, filter, other)) return;
            const Position center = data.bodies[owner].center;
            const Solid obstacle = data.solid(other);
            constexpr float gap = 1e-4f;
            const Sweep sweep = {probe.form, {.from = probe.center, .velocity = d}};
            const float t = time_of_impact(sweep, {obstacle, at_rest(center)}, gap);
            if (t >= nearest) return;
            nearest = t;
            const Nearest touch =
                nearest_points(probe.form, obstacle, center - (probe.center + t * d));
            const Vec2 normal = length(touch.normal) > 0.0f ? -touch.normal : -normalized(d);
            first = RayHit{Shape(self, data.shape_id(other)), probe.center + t * d + touch.on_b,
                           normal, t};
        };
        data.fixed_tree.query(swept, visit);
        data.moving_tree.query(swept, visit);
        for (uint32_t side = 0; data.settings.bounds && side < border_sides; ++side) {
            const BorderPlane plane = border_plane(*data.settings.bounds, side);
            const float t = meets_border(probe, d, plane);
            if (t >= nearest || !is_accepted(data, filter, side)) continue;
            nearest = t;
            const Position center = probe.center + t * d;
            const auto apart = float(dot(plane.normal, center) - plane.depth);
            const Position point = center - apart * plane.normal;
            first = RayHit{Shape(self, data.shape_id(side)), point, plane.normal, t};
        }
    }
    lock.finish();
    return first;
}

}  // namespace

std::vector<Shape> World::query_overlap(const Shape& shape, const QueryFilter& filter) const {
    std::vector<Shape> all;
    search_for(*data_, shape.live(), shape.index(), filter, false, [&](const Sought& sought) {
        find_overlaps(*data_, sought, filter, false, to_list(all));
    });
    return all;
}

std::vector<Shape> World::query_overlap(const Form& form, const Pose& pose,
                                        const QueryFilter& filter) const {
    std::vector<Shape> all;
    search_for(*data_, form, pose, [&](const Sought& sought) {
        find_overlaps(*data_, sought, filter, false, to_list(all));
    });
    return all;
}

void World::visit_overlap(const Shape& shape, Visitor<Shape> visitor,
                          const QueryFilter& filter) const {
    search_for(*data_, shape.live(), shape.index(), filter, true, [&](const Sought& sought) {
        find_overlaps(*data_, sought, filter, true, to_visitor(*data_, visitor));
    });
}

void World::visit_overlap(const Form& form, const Pose& pose, Visitor<Shape> visitor,
                          const QueryFilter& filter) const {
    search_for(*data_, form, pose, [&](const Sought& sought) {
        find_overlaps(*data_, sought, filter, true, to_visitor(*data_, visitor));
    });
}

std::optional<RayHit> World::cast_shape(const Shape& shape, const Vec2& motion,
                                        const QueryFilter& filter) const {
    check_coordinates("motion", motion);
    std::optional<RayHit> first;
    search_for(*data_, shape.live(), shape.index(), filter, false,
               [&](const Sought& sought) { first = cast_parts(*data_, sought, motion, filter); });
    return first;
}

std::optional<RayHit> World::cast_shape(const Form& form, const Pose& pose, const Vec2& motion,
                                        const QueryFilter& filter) const {
    check_coordinates("motion", motion);
    std::optional<RayHit> first;
    search_for(*data_, form, pose,
               [&](const Sought& sought) { first = cast_parts(*data_, sought, motion, filter); });
    return first;
}

std::optional<PointHit> World::closest(const Position& point, float reach,
                                       const QueryFilter& filter) const {
    check_coordinates("point", point);
    check_range("reach", reach, 0.0f, infinity);
    WorldData& data = *data_;
    data.read_all();
    QueryLock lock(data, filter);
    const Position p = point;
    const PointForm probe;
    std::optional<PointHit> best;
    // Searches in growing boxes until no shape outside the box can be nearer.
    const float farthest = min(reach, 4.0f * greatest_coordinate);
    for (float half = min(1.0f, farthest);; half = min(4.0f * half, farthest)) {
        auto visit = [&](uint32_t shape) {
            if (!is_accepted(data, filter, shape)) return;
            const Vec2 offset = data.bodies[data.forms[shape].body].center - p;
            const Nearest near = nearest_points(probe.form(), data.solid(shape), offset);
            if (near.distance > farthest || (best && near.distance >= best->distance)) return;
            const Position place = near.distance > 0.0f ? p + near.on_b : p;
            best =
                PointHit{Shape(self(), data.shape_id(shape)), place, -near.normal, near.distance};
        };
        const Box4 box = box_around(p, {{-half, -half}, {half, half}});
        data.fixed_tree.query(box, visit);
        data.moving_tree.query(box, visit);
        if ((best && best->distance <= half) || half >= farthest) break;
    }
    lock.finish();
    return best;
}

}  // namespace fettle::physics
