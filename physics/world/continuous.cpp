#include <collision/piece.h>
#include <collision/probe.h>
#include <collision/sweep.h>
#include <contacts/border.h>
#include <geometry/trigonometry.h>
#include <world/world_data.h>

// Continuous collision. A body that moved far for its thickness may have passed through something
// thin. If the core of one of its shapes (a disc of half the thickness round the centroid) met an
// obstacle on the way, the body is put back to where the shape itself arrived; it keeps its
// velocity, and the next step finds an ordinary contact. Asking for the core keeps bodies that
// slide over a floor of many pieces from being stopped at every seam.

namespace fettle::physics::detail {
namespace {

/// Arrives this close, m: within the reach of a speculative contact.
constexpr float arrival_gap = 0.25f * speculative_margin;

/// Where a disc arrives.
Probe cast_disc(const Solid& obstacle, float radius, V2 from, V2 way) {
    if (obstacle.kind == FormKind::ellipse) {
        const Sweep disc = {{{&from, nullptr, nullptr, 1, radius}}, {}, way, 0.0f, 0.0f};
        const float t = time_of_impact(disc, obstacle, {}, 1e-4f * radius);
        return {t < 1.0f && t > 0.0f ? t : 2.0f, {}};
    }
    if (obstacle.kind == FormKind::piece) {
        // From behind, everything passes.
        const Piece piece(obstacle);
        if (piece.one_sided() && (!piece.faces(from) || dot(obstacle.form.normals[0], way) >= 0.0f))
            return {};
    }
    Solid grown = obstacle;
    grown.form.radius += radius;
    if (obstacle.kind == FormKind::piece) grown.kind = FormKind::convex;
    return cast_segment(grown, from, way);
}

}  // namespace

/// How far shape `s` gets before obstacle `o`, as a fraction of the motion.
float WorldData::sweep_shape(const FastBody& fast, uint32_t s, uint32_t o, V2 centroid,
                             float core) const {
    const BodyRecord& record = bodies[fast.body];
    if (forms[o].kind == FormKind::border) {
        const BorderPlane plane = border_plane(*settings.bounds, o);
        const V2 start_centroid = centroid - fast.shift;
        const float before = dot(plane.normal, start_centroid) - plane.depth - core;
        const float after = dot(plane.normal, centroid) - plane.depth - core;
        if (before <= 0.0f || after >= 0.0f) return 1.0f;
        // Where the farthest vertex arrives, turning left aside.
        const float ahead =
            reach(solid(s), -plane.normal) + dot(plane.normal, centroid - record.center);
        const float arrival = (before + core - ahead - arrival_gap) / (before - after);
        return clamp(arrival, 0.0f, before / (before - after));
    }
    const Solid obstacle = solid(o);
    const V2 center = bodies[forms[o].body].center;
    const Rotation back = rotation_of(-double(fast.turn));
    const V2 start_centroid = fast.start + rotate(back, centroid - record.center);
    const Probe probe =
        cast_disc(obstacle, core, start_centroid - center, centroid - start_centroid);
    if (probe.fraction > 1.0f) return 1.0f;
    const Sweep sweep = {solid(s), fast.start, fast.shift, fast.turn, record.extent};
    const float arrival = time_of_impact(sweep, obstacle, center, arrival_gap);
    // Touching from the start: its contacts hold it, but not beyond where the core would enter.
    return arrival > 0.0f ? min(arrival, probe.fraction) : probe.fraction;
}

/// By a callback. Where there is none the pairs may be ending meanwhile (finish_bodies).
bool WorldData::is_disabled(uint32_t shape, uint32_t other) const {
    if (!self.see_contacts()) return false;
    const uint32_t contact = pairs.find(shape, other);
    return contact != PairSet::absent && contacts[contact].disabled;
}

float WorldData::limit_motion(const FastBody& fast) const {
    const BodyRecord& record = bodies[fast.body];
    const Rotation q = {states[fast.body].cosine, states[fast.body].sine};
    float limit = 1.0f;
    for (uint32_t s = record.first_shape; s != none; s = shapes[s].next) {
        if (shapes[s].surface.sensor || !is_solid(s)) continue;
        const V2 centroid = record.center + rotate(q, shapes[s].centroid - record.local_center);
        const Box4 start = {boxes[s].low - fast.shift, boxes[s].high - fast.shift};
        const Box4 swept = grow(unite(boxes[s], start), speculative_margin);
        auto meet = [&](uint32_t other) {
            if (shapes[other].surface.sensor || !may_collide(s, other)) return;
            if (is_disabled(s, other)) return;
            limit = min(limit, sweep_shape(fast, s, other, centroid, 0.5f * record.thickness));
        };
        fixed_tree.query(swept, meet);
        if (record.bullet) {
            moving_tree.query(swept, [&](uint32_t other) {
                if (!bodies[forms[other].body].bullet) meet(other);
            });
        }
        for (uint32_t side = 0; settings.bounds && side < 4; ++side) {
            if (overlap(swept, fat_boxes[side])) meet(side);
        }
    }
    return limit;
}

/// Puts it back to where it arrived.
void WorldData::stop_body(const FastBody& fast, FinishedPiece& piece) {
    const float limit = limit_motion(fast);
    if (limit >= 1.0f) return;
    BodyRecord& record = bodies[fast.body];
    BodyState& state = states[fast.body];
    const float back = (1.0f - limit) * fast.turn;
    record.center = fast.start + limit * fast.shift;
    state.angle = bounded(state.angle - back, greatest_coordinate);
    const Rotation q = rotation_of(double(state.angle) + double(record.angle_rest));
    state.cosine = q.c;
    state.sine = q.s;
    state.position =
        to_vec2(bounded(record.center - rotate(q, record.local_center), greatest_coordinate));
    finish_shapes(fast.body, q, piece);
}

/// Only what is fixed stops it, which nobody moves meanwhile: that any thread may find out. What
/// may meet a bullet or asks the caller has to wait.
void WorldData::stop_or_list(const FastBody& fast, FinishedPiece& piece) {
    if (bodies[fast.body].bullet || self.filter)
        piece.fast.push_back(fast);
    else
        stop_body(fast, piece);
}

void WorldData::stop_fast_bodies() {
    // Bullets last: those they may hit are where they will stay.
    for (const bool bullets : {false, true}) {
        for (const FastBody& fast : fast_bodies) {
            if (bodies[fast.body].bullet != bullets) continue;
            FinishedPiece& piece = finished.front();
            piece.clear();
            stop_body(fast, piece);
            for (const int32_t leaf : piece.placed) moving_tree.follow(leaf);
            moved_shapes.insert(moved_shapes.end(), piece.moved.begin(), piece.moved.end());
            statistics.moved_proxies += uint32_t(piece.placed.size());
        }
    }
}

}  // namespace fettle::physics::detail
