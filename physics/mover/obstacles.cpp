// The obstacles of a mover: shapes near it, as planes and along a motion.

#include <collision/ellipse.h>
#include <collision/outline_piece.h>
#include <contacts/border.h>
#include <contacts/contact_list.h>
#include <distance/distance.h>
#include <geometry/trigonometry.h>
#include <mover/obstacles.h>
#include <world/world_data.h>

#include <algorithm>
#include <cmath>

namespace fettle::physics::detail {
namespace {

/// A one-sided obstacle acts on a mover in front of it: the cosine of the angle between the
/// direction to the mover and the front is at least this.
constexpr float least_front = 0.05f;

/// A body that is not fixed pushes a mover that it overlaps out with this speed, m/s, besides its
/// own. The whole overlap in one step would throw a mover that is crushed or lies below a crate.
constexpr float push_out_speed = 3.0f;

/// A body moves by at most this in a step, m.
constexpr float farthest = 1000.0f;

/// True if a corner of one can be flush with a side of the other throughout the step.
bool move_alike(const Obstacle& a, const Obstacle& b) {
    if (a.body == b.body) return true;
    return !a.dynamic && !b.dynamic && length_squared(a.shift) == 0.0f &&
           length_squared(b.shift) == 0.0f;
}

}  // namespace

const MoverBody* mover_of(const WorldData& data, uint32_t body) {
    if (data.bodies[body].mobility != Mobility::kinematic) return nullptr;
    const std::vector<MoverBody>& all = data.mover_bodies;
    const auto found = std::lower_bound(all.begin(), all.end(), body, is_before);
    return found != all.end() && found->body == data.body_id(body) ? &*found : nullptr;
}

Capsule::Capsule(const MoverDef& def, float tall)
    : up(normalized(def.up)), radius(def.radius), height(max(tall, 2.0f * def.radius)) {
    ends_[0] = radius * up;
    ends_[1] = (height - radius) * up;
    normals_[0] = right_perp(up);
    normals_[1] = -normals_[0];
    if (height - 2.0f * radius < 1e-4f) count_ = 1;
}

Solid Capsule::solid(float thick) const {
    return {{ends_, normals_, offsets_, count_, thick}};
}

float Capsule::lowest(Vec2 direction) const {
    return min(dot(direction, ends_[0]), dot(direction, ends_[1])) - radius;
}

float turn_of(const BodyState& state, float dt) {
    return clamp(dt * state.angular_velocity, -1.5f, 1.5f);
}

Vec2 velocity_of(const WorldData& data, uint32_t body, const Position& point) {
    const BodyState& state = data.states[body];
    return state.velocity + cross(state.angular_velocity, point - data.bodies[body].center);
}

Vec2 motion_of(const WorldData& data, uint32_t body, const Position& point, float dt) {
    // The body of another mover that has not moved yet goes on as this mover wants, not as fast as
    // it was pushed out of something.
    const MoverBody* const mover = mover_of(data, body);
    if (mover != nullptr && mover->old) return bounded(dt * mover->velocity, farthest);
    const BodyState& state = data.states[body];
    const Vec2 arm = point - data.bodies[body].center;
    const Vec2 turned = rotate(rotation_of(turn_of(state, dt)), arm);
    return bounded(dt * state.velocity, farthest) + (turned - arm);
}

Obstacles::Obstacles(const World& world, const MoverDef& def, const Capsule& capsule)
    : data_(MoverWorld::of(world)), def_(def), capsule_(capsule) {
    filter_.category = def.category;
    filter_.mask = def.mask;
    filter_.group = def.group;
}

void Obstacles::find(Box4 box, const Position& position, uint32_t carrier, float dt,
                     std::optional<ShapeId> left_out) {
    all_.clear();
    time_ = part_ = 0.0f;
    dt_ = dt;
    data_.read_all();
    float fastest = 0.0f;
    const bool any = dt > 0.0f && data_.kinematic_bodies > 0;
    for (uint32_t i = 1; any && i < data_.bodies.size(); ++i) {
        const BodyRecord& body = data_.bodies[i];
        if (data_.body_generations[i] == 0 || body.mobility != Mobility::kinematic) continue;
        const BodyState& state = data_.states[i];
        const float speed =
            length(state.velocity) + std::fabs(state.angular_velocity) * body.extent;
        fastest = max(fastest, min(dt * speed, farthest));
    }
    box = grow(box, fastest);
    const uint32_t self = def_.body.index;
    has_body_ = self != 0 && self < data_.bodies.size() && data_.body_generations[self] != 0 &&
                data_.body_id(self) == def_.body;
    const auto visit = [&](uint32_t shape) {
        if (!overlap(data_.boxes[shape], box) || !is_accepted(data_, filter_, shape)) return;
        const uint32_t body = data_.forms[shape].body;
        if (body == none || data_.body_id(body) == def_.body) return;
        if (has_body_ && (joint_forbids_contact(data_, self, body) || stands_on_it(body))) return;
        if (left_out && data_.shape_id(data_.named_shape(shape)) == *left_out) return;
        add(shape, position, carrier, dt);
    };
    data_.fixed_tree.query(box, visit);
    data_.moving_tree.query(box, visit);
    for (uint32_t side = 0; data_.settings.bounds && side < border_sides; ++side) {
        if (!is_accepted(data_, filter_, side)) continue;
        const BorderPlane border = border_plane(*data_.settings.bounds, side);
        Obstacle& made = all_.emplace_back();
        made.border = true;
        made.shape = side;
        made.body = 0;
        made.front = border.normal;
        made.depth = border.depth;
    }
}

/// True for the body of a mover that stands on the body of this mover. If it gave way to what it
/// carries along, both would become ever faster.
bool Obstacles::stands_on_it(uint32_t body) const {
    const MoverBody* const mover = mover_of(data_, body);
    return mover != nullptr && mover->ground == def_.body;
}

void Obstacles::add(uint32_t shape, const Position& position, uint32_t carrier, float dt) {
    Obstacle& made = all_.emplace_back();
    made.solid = data_.solid(shape);
    made.shape = shape;
    made.body = data_.forms[shape].body;
    const BodyRecord& body = data_.bodies[made.body];
    made.center = body.center;
    made.dynamic = body.mobility == Mobility::dynamic;
    made.of_mover = mover_of(data_, made.body) != nullptr;
    if (body.mobility != Mobility::fixed) {
        const Vec2 offset = made.center - position;
        const Nearest near = nearest_points(capsule_.solid(0.0f), made.solid, offset);
        // The ground takes the mover along: what is at rest on it stays at its distance from it.
        const Vec2 at = made.body == carrier ? near.on_a : near.on_b;
        made.shift = made.motion = motion_of(data_, made.body, position + at, dt);
        const bool lands = -dot(near.normal, capsule_.up) >= landing_cosine_;
        made.leads = made.dynamic && made.body != carrier && !lands;
        // A body that is pushed leads the mover, which stays in touch with it. One that comes
        // towards the mover is at rest, because the mover may stop it; but it stays above ground on
        // which it is going to land, as its own body would hit this ground with an infinite mass.
        if (made.leads) made.shift = max(0.0f, dot(made.shift, near.normal)) * near.normal;
    }
    if (made.solid.kind == FormKind::piece && made.solid.form.count == 2) {
        made.one_sided = true;
        made.front = made.solid.form.normals[0];
    } else if ((data_.shapes[shape].surface.category & def_.ledges) != 0) {
        made.one_sided = true;
        made.front = capsule_.up;
    }
}

void Obstacles::take_along(uint32_t body, Vec2 motion, const Position& position) {
    for (uint32_t i = 0; i < all_.size(); ++i) {
        if (all_[i].border || all_[i].body != body) continue;
        const std::optional<Plane> found = plane(i, position);
        if (!found || dot(found->normal, capsule_.up) <= 0.01f) continue;
        all_[i].shift = motion;
        all_[i].taken_along = true;
    }
}

void Obstacles::set_time(float time) {
    for (Obstacle& each : all_) each.clearance -= std::fabs(time - time_) * length(each.shift);
    part_ = std::fabs(time - time_);
    time_ = time;
}

void Obstacles::reduce_clearance(float distance) {
    for (Obstacle& each : all_) each.clearance -= distance;
}

float Obstacles::farthest_shift() const {
    float longest = 0.0f;
    for (const Obstacle& each : all_)
        if (!each.leads) longest = max(longest, length(each.shift));
    return longest;
}

/// The plane of an obstacle that contains a part of the capsule's line: that of the side through
/// which the distance out of the obstacle is least.
Plane Obstacles::deepest(const Obstacle& obstacle, Vec2 offset) const {
    const Solid& solid = obstacle.solid;
    const Convex& form = solid.form;
    const Convex line = capsule_.solid(0.0f).form;
    Plane plane{.normal = capsule_.up, .point = offset, .separation = -1e30f, .deep = true};
    const auto consider = [&](Vec2 normal, float offset_of_side) {
        float nearest = 1e30f;
        for (int i = 0; i < line.count; ++i)
            nearest = min(nearest, dot(normal, line.vertices[i] - offset));
        const float separation = nearest - offset_of_side;
        if (separation <= plane.separation) return;
        plane.separation = separation;
        plane.normal = normal;
    };
    if (solid.kind == FormKind::ellipse) {
        const EllipseForm ellipse = ellipse_of(form);
        const Vec2 out = normalized(capsule_.middle() - offset - ellipse.center);
        for (const Vec2 normal : {length_squared(out) > 0.0f ? out : capsule_.up, capsule_.up})
            consider(normal, dot(ellipse.center, normal) + ellipse.reach(normal));
    } else if (form.count == 1) {
        const Vec2 out = normalized(capsule_.middle() - offset - form.vertices[0]);
        for (const Vec2 normal : {length_squared(out) > 0.0f ? out : capsule_.up, capsule_.up})
            consider(normal, dot(form.vertices[0], normal) + form.radius);
    } else {
        const bool parts = solid.kind == FormKind::piece;
        for (int i = 0; i < form.count; ++i) {
            if (parts && OutlinePiece(solid).is_inner(i)) continue;
            const Vec2 normal = solid.kind == FormKind::large
                                    ? rotate(solid.rotation, form.normals[i])
                                    : form.normals[i];
            consider(normal, form.offsets[i] + form.radius);
        }
        if (plane.separation < -1e29f) consider(capsule_.up, reach(solid, capsule_.up));
    }
    plane.separation -= capsule_.radius;
    plane.point = plane.normal;
    return plane;
}

std::optional<Plane> Obstacles::plane(uint32_t index, const Position& position) const {
    const Obstacle& obstacle = all_[index];
    Plane plane;
    plane.obstacle = index;
    if (obstacle.border) {
        plane.normal = obstacle.front;
        plane.separation =
            dot(obstacle.front, position) + capsule_.lowest(obstacle.front) - obstacle.depth;
        plane.point =
            position + capsule_.lower() - (capsule_.radius + plane.separation) * obstacle.front;
        return plane;
    }
    const Vec2 offset = center(obstacle) - position;
    const Nearest near = nearest_points(capsule_.solid(0.0f), obstacle.solid, offset);
    if (near.distance > 0.0f) {
        plane.normal = -near.normal;
        plane.separation = near.distance - capsule_.radius;
        plane.point = position + near.on_b;
    } else {
        if (obstacle.one_sided) return std::nullopt;  // it is passing through
        plane = deepest(obstacle, offset);
        plane.obstacle = index;
        plane.point =
            position + capsule_.lower() - (capsule_.radius + plane.separation) * plane.normal;
    }
    if (obstacle.one_sided) {
        const float slop =
            def_.skin + max(0.0f, dot(obstacle.shift, plane.normal)) + 0.02f * capsule_.radius;
        if (plane.separation < -slop || dot(plane.normal, obstacle.front) < least_front)
            return std::nullopt;
    }
    return plane;
}

std::optional<Plane> Obstacles::floor_of(uint32_t body, const Position& position, float reach,
                                         float least_cosine) const {
    std::optional<Plane> nearest;
    for (uint32_t i = 0; i < all_.size(); ++i) {
        if (all_[i].border || all_[i].body != body || all_[i].clearance > reach) continue;
        const std::optional<Plane> found = plane(i, position);
        if (!found || dot(found->normal, capsule_.up) < least_cosine) continue;
        if (found->separation > (nearest ? nearest->separation : reach)) continue;
        nearest = found;
    }
    return nearest;
}

float Obstacles::most_push_out(const Plane& plane) const {
    const Obstacle& obstacle = all_[plane.obstacle];
    if (obstacle.border || data_.bodies[obstacle.body].mobility == Mobility::fixed) return 1e30f;
    return part_ * (max(0.0f, dot(obstacle.motion, plane.normal)) + dt_ * push_out_speed);
}

Vec2 Obstacles::velocity_at(const Plane& plane) const {
    const Obstacle& obstacle = all_[plane.obstacle];
    if (!obstacle.dynamic) return dt_ > 0.0f ? (1.0f / dt_) * obstacle.shift : Vec2{};
    return velocity_of(data_, obstacle.body, plane.point);
}

void Obstacles::planes_at(const Position& position, float reach, uint32_t kept,
                          std::vector<Plane>& planes) {
    planes.clear();
    for (uint32_t i = 0; i < all_.size(); ++i) {
        if (all_[i].clearance > reach) continue;
        const auto found = plane(i, position);
        if (found && found->separation > 0.0f) all_[i].clearance = found->separation;
        if (found && found->separation <= reach) planes.push_back(*found);
    }
    std::stable_sort(planes.begin(), planes.end(),
                     [](const Plane& a, const Plane& b) { return a.separation < b.separation; });
    const float flush = 0.1f * def_.skin;
    for (size_t i = 1; i < planes.size();) {
        bool hidden = false;
        for (size_t k = 0; k < i && !hidden && planes[i].obstacle != kept; ++k) {
            const Plane &near = planes[k], &far = planes[i];
            const bool same = dot(near.normal, far.normal) > 0.99999f;
            hidden = !near.deep && !far.deep && near.separation > -def_.skin &&
                     dot(near.normal, far.normal) > 0.3f &&
                     (same || dot(near.normal, far.point - near.point) < flush) &&
                     move_alike(all_[near.obstacle], all_[far.obstacle]);
        }
        if (hidden)
            planes.erase(planes.begin() + std::ptrdiff_t(i));
        else
            ++i;
    }
    constexpr size_t most = 16;
    if (planes.size() > most) planes.resize(most);
}

float Obstacles::cast(const Position& position, Vec2 motion, float gap, uint32_t& hit,
                      bool with_ground) {
    hit = none;
    float first = 1.0f;
    const float way = length(motion);
    if (!(way > 0.0f)) return first;
    for (uint32_t i = 0; i < all_.size(); ++i) {
        Obstacle& obstacle = all_[i];
        if (obstacle.clearance > way + gap || (obstacle.taken_along && !with_ground)) continue;
        const auto now = plane(i, position);
        if (!now) continue;
        if (now->separation > 0.0f) obstacle.clearance = now->separation;
        const float approach = -dot(now->normal, motion);
        if (now->separation - way > gap || approach <= 1e-5f * way) continue;
        if (now->deep) continue;  // only planes push it out
        float t = 0.0f;
        if (obstacle.border) {
            t = max(0.0f, now->separation - gap) / approach;
        } else if (now->separation > gap) {
            const Sweep sweep = {capsule_.solid(capsule_.radius),
                                 {.from = position, .velocity = motion}};
            t = time_of_impact(sweep, {obstacle.solid, at_rest(center(obstacle))}, gap);
        }
        if (t >= first) continue;
        first = t;
        hit = i;
    }
    reduce_clearance(first * way);
    return first;
}

std::optional<Vec2> Obstacles::ray(const Position& from, Vec2 motion) const {
    std::optional<Vec2> normal;
    float nearest = 1.0f;
    for (const Obstacle& obstacle : all_) {
        if (obstacle.border) continue;
        const Probe probe = cast_segment(obstacle.solid, from - center(obstacle), motion);
        if (probe.fraction > nearest) continue;
        nearest = probe.fraction;
        normal = probe.normal;
    }
    return normal;
}

}  // namespace fettle::physics::detail
