// The motion of a mover in one step: sliding, climbing steps, staying on the ground.

#include <mover/moving.h>

#include <algorithm>
#include <cmath>

namespace fettle::physics::detail {
namespace {

constexpr int most_slides = 6;

/// The heights of a step and of the floor are known to this, m.
constexpr float step_tolerance = 0.0005f;

}  // namespace

/// The bounds of the planes around it. For a walking mover a slope that is too steep is also a
/// vertical wall, so that running into it does not lift it.
std::vector<Bound> Moving::bounds(Vec2 motion, bool with_distance) const {
    std::vector<Bound> all;
    const float most = 0.5f * capsule_.radius, skin = settings_.skin;
    for (const Plane& plane : planes_) {
        // At a distance between half the skin and the skin, the mover stays where it is: if each
        // step pushed it back to the skin, it would move to and fro.
        // A dynamic body that is not ground, such as a ball, is stopped by the mover's own body. So
        // it does not push the mover.
        const bool stopped = obstacles_.stops(plane) && cosine(plane) < settings_.least_cosine;
        const float nearest = stopped ? -0.5f * skin : 0.5f * skin;
        float least = 0.0f;
        if (with_distance && plane.separation > skin) least = skin - plane.separation;
        if (with_distance && plane.separation < nearest)
            least = min(nearest - plane.separation, min(most, obstacles_.most_push_out(plane)));
        if (!with_distance) {
            // Dynamic bodies give way to a mover; others take it along.
            least = dot(plane.normal, obstacles_.velocity_at(plane));
            if (obstacles_[plane.obstacle].dynamic) least = min(0.0f, least);
        }
        all.push_back({plane.normal, least});
        if (!settings_.walks || !is_steep(plane)) continue;
        const Vec2 aside = normalized(lateral(plane.normal));
        // The edge of a platform that the mover leaves goes on with the velocity of the platform.
        float slope = 0.0f;
        if (!with_distance && !obstacles_[plane.obstacle].dynamic)
            slope = dot(aside, obstacles_.velocity_at(plane));
        if (dot(aside, motion) < slope) all.push_back({aside, slope});
    }
    return all;
}

/// A mover that overlaps a dynamic body or another mover between others waits until they give way.
float Moving::evasion() const {
    const auto gives_way = [this](const Plane& plane) {
        const Obstacle& obstacle = obstacles_[plane.obstacle];
        return (obstacle.dynamic || obstacle.of_mover) && plane.separation < 0.0f;
    };
    return std::any_of(planes_.begin(), planes_.end(), gives_way) ? least_evasion : most_evasion;
}

void Moving::record_hits(Vec2 motion) {
    for (const Plane& plane : planes_) {
        const float into = -dot(plane.normal, motion);
        if (into <= 1e-6f || into <= plane.separation - settings_.skin) continue;
        const float up = cosine(plane);
        if (up < -0.3f)
            ceiling = plane;
        else if (up < settings_.least_cosine)
            wall = plane;
        if (up < settings_.least_cosine) blocked_ = plane.normal;
        const Obstacle& obstacle = obstacles_[plane.obstacle];
        if (!obstacle.dynamic || up >= settings_.least_cosine) continue;
        const auto same = [&](const Push& push) { return push.body == obstacle.body; };
        const auto known = std::find_if(pushes.begin(), pushes.end(), same);
        if (known == pushes.end())
            pushes.push_back({obstacle.body, plane.point, plane.normal, plane.separation});
        else
            *known = {obstacle.body, plane.point, plane.normal, plane.separation};
    }
}

void Moving::slide(Vec2 motion) {
    const float reach = settings_.skin + min(1e-3f, 0.1f * settings_.skin);
    uint32_t kept = none;
    for (int round = 0; round < most_slides; ++round) {
        obstacles_.planes_at(position, reach, kept, planes_);
        record_hits(motion);
        const Vec2 allowed = allowed_motion(motion, bounds(motion, true), evasion());
        const float t = obstacles_.cast(position, allowed, 0.25f * settings_.skin, kept);
        position = position + t * allowed;
        if (t >= 1.0f) return;
        motion = (1.0f - t) * allowed;
        if (length(motion) < 1e-5f) return;
    }
}

void Moving::find_pushed(Vec2 motion) {
    obstacles_.planes_at(position, settings_.skin, none, planes_);
    std::erase_if(planes_,
                  [this](const Plane& plane) { return !obstacles_[plane.obstacle].leads; });
    record_hits(motion);
}

void Moving::advance(Vec2 motion, Vec2 ridden) {
    const Position start = position;
    const std::optional<Plane> wall_before = wall;
    blocked_ = {};
    // First with the ground, as far as nothing is in the way. Before that, it overlaps ground that
    // rises, and the seams between its tiles seem to be corners.
    uint32_t hit = none;
    const float t = obstacles_.cast(position, ridden, 0.25f * settings_.skin, hit, false);
    position = position + t * ridden;
    slide(motion - t * ridden);
    if (settings_.step_height <= 0.0f) return;
    const Vec2 aside = lateral(motion);
    const float wanted = length(aside);
    if (wanted < 1e-5f) return;
    const float made = dot(position - start, (1.0f / wanted) * aside);
    // Ground that moves makes the way shorter, too, but there is no step.
    const bool blocked = dot(blocked_, aside) < 0.0f;
    if (made < 0.9f * wanted && blocked)
        step_up(start, aside);
    else if (wall && !wall_before && will_step_up(aside))
        wall.reset();  // It has just reached a step, which the next part of the motion climbs.
}

/// True if it would climb a step from its position, which does not change.
bool Moving::will_step_up(Vec2 motion) {
    const Position here = position;
    const std::optional<Plane> step_before = step;
    const bool will = step_up(here, motion);
    put_back(here);
    step = step_before;
    return will;
}

/// Up, forward and down again: a step if there is ground that is higher. False if there is none.
bool Moving::step_up(const Position& start, Vec2 motion) {
    const Position slid = position;
    const Vec2 up = capsule_.up;
    const float wanted = length(motion), gap = 0.5f * settings_.skin;
    const Vec2 ahead = (1.0f / wanted) * motion;
    uint32_t hit = none;
    const auto go = [&](Vec2 by) {
        const float t = obstacles_.cast(position, by, gap, hit);
        position = position + t * by;
        return t;
    };
    put_back(start);
    if (!has_room()) {  // What is inside of an obstacle would climb out of it.
        put_back(slid);
        return false;
    }
    const auto below = ground();
    const Position floor = start - (below ? below->separation : 0.0f) * up;
    // Above the step it keeps the gap, too.
    const float most = settings_.step_height + settings_.skin;
    const float lift = go(most * up) * most;
    // It stands up to a skin away from the step. A shorter way would not lead above it.
    const float way = max(wanted, settings_.skin);
    const float forward = go(way * ahead) * way;
    const float down = lift + settings_.skin;
    const float t = go(-down * up);
    const float progress = forward - dot(slid - start, ahead);
    const auto reached = t < 1.0f && hit != none ? obstacles_.plane(hit, position) : std::nullopt;
    if (lift > settings_.skin && progress > 0.05f * wanted && reached &&
        dot(position - start, up) > 1e-4f && walkable(*reached, floor, motion) &&
        !obstacles_[hit].dynamic) {
        step = reached;
        return true;
    }
    put_back(slid);
    return false;
}

/// A plane not higher than a step above the floor that is not too steep, or the edge of one towards
/// which the mover goes: the capsule is round and touches the edge of a step before it stands on
/// it.
bool Moving::walkable(const Plane& plane, const Position& floor, Vec2 motion) {
    const float height = dot(plane.point - floor, capsule_.up);
    if (height > settings_.step_height + step_tolerance) return false;
    if (cosine(plane) >= settings_.least_cosine) return true;
    const Vec2 aside = lateral(plane.normal);
    if (cosine(plane) <= 0.01f || dot(aside, motion) >= 0.0f) return false;
    const Vec2 inwards = normalized(-aside);
    const Position above = plane.point + 0.02f * inwards + 0.05f * capsule_.up;
    const auto normal = obstacles_.ray(above, -0.1f * capsule_.up);
    return normal && dot(*normal, capsule_.up) >= settings_.least_cosine;
}

std::optional<Plane> Moving::ground() {
    obstacles_.planes_at(position, 2.0f * settings_.skin, none, planes_);
    std::optional<Plane> best, support;
    std::vector<Bound> all;
    for (const Plane& plane : planes_) {
        all.push_back({plane.normal, 0.0f});
        if (cosine(plane) > 0.1f && (!support || cosine(plane) > cosine(*support))) support = plane;
        if (cosine(plane) < settings_.least_cosine) continue;
        if (!best || cosine(plane) > cosine(*best)) best = plane;
    }
    if (best || !support) return best;
    // It is between two steep slopes, and cannot sink.
    if (dot(allowed_motion(-capsule_.up, all), capsule_.up) > -0.05f) {
        support->normal = capsule_.up;
        return support;
    }
    return std::nullopt;
}

bool Moving::follow(uint32_t carrier, float reach) {
    if (carrier == none || obstacles_.data().bodies[carrier].mobility == Mobility::fixed)
        return false;
    const std::optional<Plane> below =
        obstacles_.floor_of(carrier, position, reach, settings_.least_cosine);
    if (!below) return false;
    if (below->separation <= settings_.skin) return true;
    const Position start = position;
    const Vec2 motion = -(below->separation - settings_.skin) * below->normal;
    uint32_t hit = none;
    position = position + obstacles_.cast(position, motion, 0.25f * settings_.skin, hit) * motion;
    if (ground()) return true;
    put_back(start);
    return false;
}

bool Moving::snap_to_ground(float reach) {
    if (!has_room()) return false;
    const Position start = position;
    const auto gives_way = [this](const Plane& plane) {
        return obstacles_[plane.obstacle].dynamic && cosine(plane) > 0.01f;
    };
    Vec2 motion = -reach * capsule_.up;
    uint32_t kept = none;
    for (int round = 0; round < most_slides && length(motion) > 1e-5f; ++round) {
        // It may slide off the edge that it is leaving, but not down the ground below it, and not
        // down a ball or a crate that rolls or tips away: from these it falls.
        obstacles_.planes_at(position, settings_.skin, kept, planes_);
        if (std::any_of(planes_.begin(), planes_.end(), gives_way)) break;
        const Vec2 allowed = allowed_motion(motion, bounds(motion, true));
        const float t = obstacles_.cast(position, allowed, 0.25f * settings_.skin, kept);
        position = position + t * allowed;
        if (ground()) return true;
        motion = (1.0f - t) * allowed;
    }
    put_back(start);
    return false;
}

bool Moving::has_room() {
    obstacles_.planes_at(position, 0.0f, none, planes_);
    return planes_.empty() || planes_.front().separation > -0.1f * capsule_.radius;
}

Vec2 Moving::driven(Vec2 velocity, float dt) {
    constexpr float share = 0.25f, fastest = 3.0f;  // of an overlap in a step; m/s
    obstacles_.planes_at(position, 1.5f * settings_.skin, none, planes_);
    std::vector<Bound> all;
    for (const Plane& plane : planes_) {
        if (obstacles_[plane.obstacle].dynamic) continue;
        const float overlap = max(0.0f, 0.5f * settings_.skin - plane.separation);
        all.push_back({plane.normal, dot(plane.normal, obstacles_.velocity_at(plane)) +
                                         min(share * overlap / dt, fastest)});
    }
    return allowed_motion(velocity, all, least_evasion);
}

Vec2 Moving::clipped(Vec2 velocity) {
    obstacles_.planes_at(position, 1.5f * settings_.skin, none, planes_);
    return allowed_motion(velocity, bounds(velocity, false), least_evasion);
}

}  // namespace fettle::physics::detail
