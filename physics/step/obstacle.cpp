#include <collision/collide_solids.h>
#include <collision/outline_piece.h>
#include <geometry/trigonometry.h>
#include <step/obstacle.h>

namespace fettle::physics::detail {
namespace {

/// Distance at which the centroid of a shape stops before an obstacle, m. On the surface, rounding
/// could put it behind.
constexpr float centroid_gap = 0.0001f;

/// An arc is followed in chords of this angle, rad.
constexpr float chord_turn = 0.05f;

float inwards(const Probe& hit, Vec2 way) {
    return max(-dot(hit.normal, way), 1e-9f);
}
/// True if a point that begins this way is at the obstacle already.
bool begins_at(const Probe& hit, Vec2 way) {
    return hit.fraction * inwards(hit, way) < 2.0f * centroid_gap;
}

}  // namespace

Obstacle::Obstacle(const FinishInput& in, uint32_t obstacle, const Motion& motion, float now)
    : now_(now), is_border_(in.objects.forms[obstacle].kind == FormKind::border) {
    if (is_border_) {
        plane_ = border_plane(*in.settings.bounds, obstacle);
        return;
    }
    const BodyRecord& body = in.objects.bodies[in.objects.forms[obstacle].body];
    obstacle_ = {solid_of(in.objects, in.columns, obstacle), motion, body.extent};
}

Impact Obstacle::of_point(const Position& start, const Position& end, float slip) const {
    if (is_border_) {
        const auto before = float(dot(plane_.normal, start) - plane_.depth);
        const auto after = float(dot(plane_.normal, end) - plane_.depth);
        if (!(before > 0.0f && after < 0.0f)) return {};
        return arrival({before / (before - after), plane_.normal}, end - start);
    }
    const Vec2 from = from_obstacle(start, now_), way = from_obstacle(end, 1.0f) - from;
    const Probe hit = cast_segment(obstacle_.shape, from, way);
    if (hit.fraction >= 1.0f && slip > 0.0f) {
        const Vec2 out = way_out(from, slip);
        if (dot(out, way) < -centroid_gap) return arrival({0.0f, out}, way);
    }
    const float turn = std::fabs(obstacle_.motion.turn) * (1.0f - now_);
    if (turn > chord_turn) return on_arc(start, end, 1 + int(min(turn, 3.0f) / chord_turn));
    return hit.fraction < 1.0f ? arrival(hit, way) : Impact{};
}

bool Obstacle::is_from_behind(const Position& start) const {
    return !is_border_ && obstacle_.shape.kind == FormKind::piece &&
           !OutlinePiece(obstacle_.shape).faces(from_obstacle(start, now_));
}

Impact Obstacle::stop_before(const Probe& hit, Vec2 chord, int i, int chords) const {
    const float fraction = max(hit.fraction - centroid_gap / inwards(hit, chord), 0.0f);
    const float time = now_ + (float(i) + fraction) / float(chords) * (1.0f - now_);
    return {time, {}, from_frame(hit.normal, time)};
}

Impact Obstacle::on_arc(const Position& start, const Position& end, int chords) const {
    const Vec2 way = end - start;
    Vec2 from = from_obstacle(start, now_);
    for (int i = 0; i < chords; ++i) {
        const float part = float(i + 1) / float(chords);
        const Vec2 to = from_obstacle(start + part * way, now_ + part * (1.0f - now_));
        const Vec2 chord = to - from;
        const Probe hit = cast_segment(obstacle_.shape, from, chord);
        if (hit.fraction >= 1.0f) {
            from = to;
            continue;
        }
        if (i == 0 && begins_at(hit, chord))
            return arrival({0.0f, hit.normal}, from_obstacle(end, 1.0f) - from);
        return stop_before(hit, chord, i, chords);
    }
    return {};
}

PointGap gap_to_point(const Solid& shape, Vec2 point, float most) {
    Solid disc;
    disc.form = {&point, nullptr, nullptr, 1, 0.0f};
    Manifold m;
    collide(shape, disc, {}, most, true, m);
    return m.count > 0 ? PointGap{m.normal, m.points[0].separation} : PointGap{};
}

Vec2 Obstacle::way_out(Vec2 point, float slip) const {
    const PointGap gap = gap_to_point(obstacle_.shape, point, 0.0f);
    return gap.width >= -slip ? gap.out : Vec2{};
}

Impact Obstacle::arrival(const Probe& hit, Vec2 way) const {
    if (!begins_at(hit, way)) return stop_before(hit, way, 0, 1);
    return {now_, inwards(hit, way) * hit.normal, from_frame(hit.normal, now_)};
}

Vec2 centroid_of(const ObjectState& objects, const Columns& columns, uint32_t shape) {
    const uint32_t body = objects.forms[shape].body;
    const BodyState& state = columns.states[body];
    return rotate({state.cosine, state.sine},
                  objects.shapes[shape].centroid - objects.bodies[body].local_center);
}
Position centroid_at(const FinishInput& in, uint32_t shape, const Motion& motion, float t) {
    return motion.center(t) + rotate(rotation_of(motion.rotation(t)), centroid_of(in, shape));
}

}  // namespace fettle::physics::detail
