#include <collision/piece.h>
#include <contacts/border.h>
#include <distance/core.h>
#include <distance/distance.h>
#include <geometry/trigonometry.h>
#include <state/limits.h>
#include <step/finish.h>

// Continuous collision. A body that moved far compared with its thickness may have passed through a
// thin obstacle. The core of a shape is the part that is deeper than half of its inner radius. If
// the core met an obstacle on the way, the body is moved back to the point where the shape itself
// arrived. It keeps its velocity, and the next step finds an ordinary contact. Only the core
// counts, so that bodies that slide over a floor of many pieces are not stopped at every seam.

namespace fettle::physics::detail {
namespace {

/// Distance from the obstacle at arrival, m; within the range of a speculative contact.
constexpr float arrival_gap = 0.25f * speculative_margin;

/// Depths of the cores of a shape, in inner radii. If the first core touches an obstacle already,
/// the body may move on until the next core touches it. It would stand still otherwise.
constexpr float core_depths[] = {0.5f, 0.75f};

/// The least depth of a core, m. Resting contacts overlap by less.
constexpr float least_depth = 0.25f * speculative_margin;

/// The time of impact of a shape, or of a core of it, with one obstacle.
class Impact {
  public:
    Impact(const FinishInput& in, const FastBody& fast, uint32_t obstacle)
        : in_(in), fast_(fast), is_border_(in.objects.forms[obstacle].kind == FormKind::border) {
        if (is_border_) {
            plane_ = border_plane(*in.settings.bounds, obstacle);
        } else {
            solid_ = solid_of(in.objects, in.columns, obstacle);
            center_ = in.objects.bodies[in.objects.forms[obstacle].body].center;
        }
    }

    float of(const Solid& shape, float gap) const {
        const Sweep sweep = {shape, fast_.start, fast_.shift, fast_.turn,
                             in_.objects.bodies[fast_.body].extent};
        return is_border_ ? time_of_impact(sweep, plane_.normal, plane_.depth, gap)
                          : time_of_impact(sweep, solid_, center_, gap);
    }
    /// The same for a point that moves from `start` to `end`.
    float of_point(V2 start, V2 end) const {
        if (is_border_) {
            const float before = dot(plane_.normal, start) - plane_.depth;
            const float after = dot(plane_.normal, end) - plane_.depth;
            return before > 0.0f && after < 0.0f ? before / (before - after) : 1.0f;
        }
        return min(cast_segment(solid_, start - center_, end - start).fraction, 1.0f);
    }
    /// A segment of a chain stops nothing that comes from behind it.
    bool is_from_behind(V2 start) const {
        return !is_border_ && solid_.kind == FormKind::piece &&
               !Piece(solid_).faces(start - center_);
    }

  private:
    const FinishInput& in_;
    const FastBody& fast_;
    bool is_border_;
    BorderPlane plane_;
    Solid solid_ = {};
    V2 center_;
};

/// The fraction of the motion that shape `s` reaches before obstacle `o`. `centroid`: of the shape
/// at the end of the motion.
float sweep_shape(const FinishInput& in, const FastBody& fast, uint32_t s, uint32_t o,
                  V2 centroid) {
    const V2 from_center = centroid - in.objects.bodies[fast.body].center;
    const V2 start = fast.start + rotate(rotation_of(-double(fast.turn)), from_center);
    const Impact impact(in, fast, o);
    if (impact.is_from_behind(start)) return 1.0f;
    const Solid shape = solid_of(in.objects, in.columns, s);
    const float inner = inner_radius(shape, from_center);
    const float gap = min(arrival_gap, 0.05f * inner);
    for (const float part : core_depths) {
        const float depth = max(part * inner, least_depth);
        if (depth >= inner) break;
        const Core core(shape, from_center, depth);
        const float entry = impact.of(core.solid(), gap);
        if (entry >= 1.0f) return 1.0f;
        if (!(entry > 0.0f)) continue;
        const float arrival = impact.of(shape, arrival_gap);
        // If the shapes touch at the start, the contacts hold the shape, but it must not go beyond
        // the entry of the core.
        return arrival > 0.0f ? min(arrival, entry) : entry;
    }
    // A thick body may have thin pieces.
    if (shape.kind == FormKind::piece && inner < least_depth) return 1.0f;
    return impact.of_point(start, centroid);
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
            limit = min(limit, sweep_shape(in, fast, s, other, centroid));
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
