#include <collision/piece.h>
#include <contacts/border.h>
#include <distance/distance.h>
#include <geometry/trigonometry.h>
#include <state/limits.h>
#include <step/finish.h>

// Continuous collision. A body that moved far compared with its thickness may have passed through a
// thin obstacle. The core of a shape is a disc of half the thickness around the centroid. If it met
// an obstacle on the way, the body is moved back to the point where the shape itself arrived. It
// keeps its velocity, and the next step finds an ordinary contact. Only the core counts, so that
// bodies that slide over a floor of many pieces are not stopped at every seam.

namespace fettle::physics::detail {
namespace {

/// Distance from the obstacle at arrival, m; within the range of a speculative contact.
constexpr float arrival_gap = 0.25f * speculative_margin;

/// Finds where a disc arrives at an obstacle.
Probe cast_disc(const Solid& obstacle, float radius, V2 from, V2 way) {
    if (obstacle.kind == FormKind::ellipse) {
        const Sweep disc = {{{&from, nullptr, nullptr, 1, radius}}, {}, way, 0.0f, 0.0f};
        const float t = time_of_impact(disc, obstacle, {}, 1e-4f * radius);
        return {t < 1.0f && t > 0.0f ? t : 2.0f, {}};
    }
    if (obstacle.kind == FormKind::piece) {
        // A one-sided segment stops nothing from behind.
        const Piece piece(obstacle);
        if (piece.one_sided() && (!piece.faces(from) || dot(obstacle.form.normals[0], way) >= 0.0f))
            return {};
    }
    Solid grown = obstacle;
    grown.form.radius += radius;
    if (obstacle.kind == FormKind::piece) grown.kind = FormKind::convex;
    return cast_segment(grown, from, way);
}

/// The fraction of the motion that shape `s` reaches before obstacle `o`.
float sweep_shape(const FinishInput& in, const FastBody& fast, uint32_t s, uint32_t o, V2 centroid,
                  float core) {
    const ObjectState& objects = in.objects;
    const BodyRecord& record = objects.bodies[fast.body];
    if (objects.forms[o].kind == FormKind::border) {
        const BorderPlane plane = border_plane(*in.settings.bounds, o);
        const V2 start_centroid = centroid - fast.shift;
        const float before = dot(plane.normal, start_centroid) - plane.depth - core;
        const float after = dot(plane.normal, centroid) - plane.depth - core;
        if (before <= 0.0f || after >= 0.0f) return 1.0f;
        // Arrival of the farthest vertex; the rotation is ignored.
        const float ahead = reach(solid_of(objects, in.columns, s), -plane.normal) +
                            dot(plane.normal, centroid - record.center);
        const float arrival = (before + core - ahead - arrival_gap) / (before - after);
        return clamp(arrival, 0.0f, before / (before - after));
    }
    const Solid obstacle = solid_of(objects, in.columns, o);
    const V2 center = objects.bodies[objects.forms[o].body].center;
    const Rotation back = rotation_of(-double(fast.turn));
    const V2 start_centroid = fast.start + rotate(back, centroid - record.center);
    const Probe probe =
        cast_disc(obstacle, core, start_centroid - center, centroid - start_centroid);
    if (probe.fraction > 1.0f) return 1.0f;
    const Sweep sweep = {solid_of(objects, in.columns, s), fast.start, fast.shift, fast.turn,
                         record.extent};
    const float arrival = time_of_impact(sweep, obstacle, center, arrival_gap);
    // If the shapes touch at the start, the contacts hold the shape, but it must not go beyond the
    // entry of the core.
    return arrival > 0.0f ? min(arrival, probe.fraction) : probe.fraction;
}

/// True if a callback disabled the contact. Without callbacks nothing is read, because pairs may be
/// ending at the same time (`finish_bodies`).
bool is_disabled(const FinishInput& in, uint32_t shape, uint32_t other) {
    if (!in.callbacks) return false;
    const uint32_t contact = in.boxes.pairs.find(shape, other);
    return contact != PairSet::absent && in.objects.contacts[contact].disabled;
}

/// The fraction of its motion that the body reaches.
float limit_motion(const FinishInput& in, const FastBody& fast) {
    const ObjectState& objects = in.objects;
    const std::vector<ShapeRecord>& shapes = objects.shapes;
    const std::vector<Box4>& boxes = in.boxes.boxes;
    const BodyRecord& record = objects.bodies[fast.body];
    const BodyState& state = in.columns.states[fast.body];
    const Rotation q = {state.cosine, state.sine};
    float limit = 1.0f;
    for (uint32_t s = record.first_shape; s != none; s = shapes[s].next) {
        if (shapes[s].surface.sensor || !objects.is_solid(s)) continue;
        const V2 centroid = record.center + rotate(q, shapes[s].centroid - record.local_center);
        const Box4 start = {boxes[s].low - fast.shift, boxes[s].high - fast.shift};
        const Box4 swept = grow(unite(boxes[s], start), speculative_margin);
        auto meet = [&](uint32_t other) {
            if (shapes[other].surface.sensor || !may_collide(objects, in.filter, s, other)) return;
            if (is_disabled(in, s, other)) return;
            limit = min(limit, sweep_shape(in, fast, s, other, centroid, 0.5f * record.thickness));
        };
        in.boxes.fixed_tree.query(swept, meet);
        if (record.bullet) {
            in.boxes.moving_tree.query(swept, [&](uint32_t other) {
                if (!objects.bodies[objects.forms[other].body].bullet) meet(other);
            });
        }
        for (uint32_t side = 0; in.settings.bounds && side < 4; ++side) {
            if (overlap(swept, in.boxes.fat_boxes[side])) meet(side);
        }
    }
    return limit;
}

/// Moves the body back to the pose of its arrival.
void stop_body(const FinishInput& in, const FastBody& fast, FinishedPiece& piece) {
    const float limit = limit_motion(in, fast);
    if (limit >= 1.0f) return;
    BodyRecord& record = in.objects.bodies[fast.body];
    BodyState& state = in.columns.states[fast.body];
    const float back = (1.0f - limit) * fast.turn;
    record.center = fast.start + limit * fast.shift;
    state.angle = bounded(state.angle - back, greatest_coordinate);
    const Rotation q = rotation_of(double(state.angle) + double(record.angle_rest));
    state.cosine = q.c;
    state.sine = q.s;
    state.position =
        to_vec2(bounded(record.center - rotate(q, record.local_center), greatest_coordinate));
    finish_shapes(in, fast.body, q, piece);
}

}  // namespace

void stop_or_list(const FinishInput& in, const FastBody& fast, FinishedPiece& piece) {
    if (in.objects.bodies[fast.body].bullet || in.filter)
        piece.fast.push_back(fast);
    else
        stop_body(in, fast, piece);
}

void stop_fast_bodies(const FinishInput& in) {
    // Bullets are last, so that the bodies that they may hit have their final poses.
    for (const bool bullets : {false, true}) {
        for (const FastBody& fast : in.scratch.fast_bodies) {
            if (in.objects.bodies[fast.body].bullet != bullets) continue;
            FinishedPiece& piece = in.scratch.finished.front();
            piece.clear();
            stop_body(in, fast, piece);
            for (const int32_t leaf : piece.placed) in.boxes.moving_tree.follow(leaf);
            std::vector<uint32_t>& moved = in.boxes.moved_shapes;
            moved.insert(moved.end(), piece.moved.begin(), piece.moved.end());
            in.statistics.moved_proxies += uint32_t(piece.placed.size());
        }
    }
}

}  // namespace fettle::physics::detail
