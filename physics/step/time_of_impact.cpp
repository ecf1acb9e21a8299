#include <collision/collide_solids.h>
#include <collision/outline_piece.h>
#include <contacts/border.h>
#include <distance/distance.h>
#include <distance/shape_core.h>
#include <geometry/trigonometry.h>
#include <state/limits.h>
#include <step/time_of_impact.h>

#include <algorithm>
#include <vector>

namespace fettle::physics::detail {
namespace {

/// Distance from the obstacle at arrival, m; within the range of a speculative contact.
constexpr float arrival_gap = 0.25f * speculative_margin;

/// Depths of the cores of a shape, in inner radii. If the first core touches an obstacle already,
/// the body may move on until the next core touches it. It would stand still otherwise.
constexpr float core_depths[] = {0.5f, 0.75f};

/// The least depth of a core, m. Resting contacts overlap by less.
constexpr float least_depth = 0.25f * speculative_margin;

/// Distance at which the centroid of a shape stops before an obstacle, m. On the surface, rounding
/// could put it behind.
constexpr float centroid_gap = 0.0001f;

/// An arc is followed in chords of this angle, rad.
constexpr float chord_turn = 0.05f;

/// Distance from a kinematic body at arrival, m: the normal must be that of the impact.
constexpr float hit_gap = 0.0005f;

/// A body that slides is stopped by what it would get into by more than this, in inner radii.
constexpr float blocked_share = 0.25f;

/// A shape that is nearer to an obstacle than this at the start of a step had a contact in it, m.
constexpr float contact_gap = 0.5f * speculative_margin;

/// An obstacle; computes when a shape or its core reaches it.
class Obstacle {
  public:
    Obstacle(const FinishInput& in, uint32_t obstacle, const Motion& motion, float now)
        : now_(now), is_border_(in.objects.forms[obstacle].kind == FormKind::border) {
        if (is_border_) {
            plane_ = border_plane(*in.settings.bounds, obstacle);
            return;
        }
        const BodyRecord& body = in.objects.bodies[in.objects.forms[obstacle].body];
        obstacle_ = {solid_of(in.objects, in.columns, obstacle), motion, body.extent};
    }

    float time_of(const Sweep& shape, float gap) const {
        return is_border_ ? time_of_impact(shape, plane_.normal, plane_.depth, gap, now_)
                          : time_of_impact(shape, obstacle_, gap, now_);
    }
    bool is_beside(const Sweep& shape) const { return is_within(shape, contact_gap); }
    bool is_within(const Sweep& shape, float gap) const { return !(time_of(shape, gap) > now_); }
    /// The direction from the obstacle to the shape at time `t`; zero if they overlap.
    Vec2 direction_to(const Sweep& shape, float t) const {
        if (is_border_) return plane_.normal;
        return -direction_between(shape, obstacle_, t);
    }
    /// The same for a point that moves from `start` to `end`. A point that is in the obstacle
    /// already, but not deeper than `slip`, goes no deeper.
    Impact of_point(const Position& start, const Position& end, float slip) const {
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
    /// A segment of a chain stops nothing that comes from behind it.
    bool is_from_behind(const Position& start) const {
        return !is_border_ && obstacle_.shape.kind == FormKind::piece &&
               !OutlinePiece(obstacle_.shape).faces(from_obstacle(start, now_));
    }

  private:
    static float inwards(const Probe& hit, Vec2 way) { return max(-dot(hit.normal, way), 1e-9f); }
    /// True if a point that begins this way is at the obstacle already.
    static bool begins_at(const Probe& hit, Vec2 way) {
        return hit.fraction * inwards(hit, way) < 2.0f * centroid_gap;
    }
    /// `way`: of a point in the rest of the step, seen from the obstacle.
    Impact arrival(const Probe& hit, Vec2 way) const {
        if (!begins_at(hit, way)) return stop_before(hit, way, 0, 1);
        return {now_, inwards(hit, way) * hit.normal, from_frame(hit.normal, now_)};
    }
    /// A point stops before the obstacle on chord `i` of its way, which has this number of chords
    /// of equal duration.
    Impact stop_before(const Probe& hit, Vec2 chord, int i, int chords) const {
        const float fraction = max(hit.fraction - centroid_gap / inwards(hit, chord), 0.0f);
        const float time = now_ + (float(i) + fraction) / float(chords) * (1.0f - now_);
        return {time, {}, from_frame(hit.normal, time)};
    }

    /// Seen from an obstacle that turns, the way of a point is an arc. As one chord it would miss
    /// the obstacle, or meet it too late, when the point is already in it.
    Impact on_arc(const Position& start, const Position& end, int chords) const {
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

    /// The normal of the nearest side of the obstacle for a point in it, not deeper than `slip`;
    /// else zero.
    Vec2 way_out(Vec2 point, float slip) const {
        Solid disc;
        disc.form = {&point, nullptr, nullptr, 1, 0.0f};
        Manifold m;
        collide(obstacle_.shape, disc, {}, 0.0f, true, m);
        return m.count > 0 && m.points[0].separation >= -slip ? m.normal : Vec2{};
    }

    /// A direction in the frame of the obstacle, in world axes.
    Vec2 from_frame(Vec2 direction, float t) const {
        if (is_border_) return direction;
        return rotate(rotation_of(obstacle_.motion.rotation(t)), direction);
    }

    /// A place at a time, in the frame of the obstacle.
    Vec2 from_obstacle(const Position& place, float t) const {
        const Vec2 d = place - obstacle_.motion.center(t);
        return unrotate(rotation_of(obstacle_.motion.rotation(t)), d);
    }

    float now_;
    bool is_border_;
    BorderPlane plane_;
    Sweep obstacle_;
};

/// True if the body of the shape is kinematic.
bool is_driven(const FinishInput& in, uint32_t shape) {
    return in.objects.bodies[in.objects.forms[shape].body].mobility == Mobility::kinematic;
}

/// True if the body of the shape is dynamic or kinematic.
bool moves(const FinishInput& in, uint32_t shape) {
    return in.objects.bodies[in.objects.forms[shape].body].mobility != Mobility::fixed;
}

/// From the center of mass of the body to the centroid of the shape, m.
Vec2 centroid_of(const FinishInput& in, uint32_t s) {
    const uint32_t body = in.objects.forms[s].body;
    const BodyState& state = in.columns.states[body];
    return rotate({state.cosine, state.sine},
                  in.objects.shapes[s].centroid - in.objects.bodies[body].local_center);
}
Position centroid_at(const FinishInput& in, uint32_t s, const Motion& motion, float t) {
    return motion.center(t) + rotate(rotation_of(motion.rotation(t)), centroid_of(in, s));
}

/// True if the body had a contact at the beginning of the step.
bool had_contact(const FinishInput& in, const BodyRecord& body) {
    return in.objects.any_contact(body.lists.first_contact, none, [&](uint32_t contact) {
        const ContactRecord& c = in.objects.contacts[contact];
        return !c.sensor && c.manifold.count > 0;
    });
}

}  // namespace

Impact time_of_impact(const FinishInput& in, uint32_t s, const Motion& motion, uint32_t other,
                      const Motion& other_motion, float now) {
    const BodyRecord& body = in.objects.bodies[in.objects.forms[s].body];
    const Vec2 centroid = centroid_of(in, s);
    const auto place = [&](float t) { return centroid_at(in, s, motion, t); };
    const Obstacle obstacle(in, other, other_motion, now);
    if (obstacle.is_from_behind(place(now))) return {};
    const Solid shape = solid_of(in.objects, in.columns, s);
    const Sweep swept = {shape, motion, body.extent};
    const bool is_carried = is_driven(in, s) || is_driven(in, other);
    const float inner = inner_radius(shape, centroid);
    if (moves(in, other) && !obstacle.is_within(swept, speculative_margin)) {
        // The solver knew nothing of the two. Of a body that lies or slides on something, a core
        // counts that resting contacts do not reach.
        Impact impact;
        const float arrival = obstacle.time_of(swept, hit_gap);
        if (arrival >= 1.0f) return impact;
        const bool any = inner <= least_depth || !had_contact(in, body);
        const Core core(shape, centroid, any ? 0.0f : least_depth);
        if (any || obstacle.time_of({core.solid(), motion, body.extent}, hit_gap) < 1.0f)
            impact.time = arrival;
        return impact;
    }
    const float gap = min(arrival_gap, 0.05f * inner);
    for (const float part : core_depths) {
        const float depth = max(part * inner, least_depth);
        if (depth >= inner) break;
        const Core core(shape, centroid, depth);
        const Sweep swept_core = {core.solid(), motion, body.extent};
        const float entry = obstacle.time_of(swept_core, gap);
        if (entry >= 1.0f) return {};
        if (!(entry > now)) continue;
        const float arrival = obstacle.time_of(swept, arrival_gap);
        // If the shapes touch at the start, the contacts hold the shape, but it must not go beyond
        // the entry of the core.
        const bool slides = is_carried && obstacle.is_beside(swept);
        return {arrival > now ? min(arrival, entry) : entry,
                {},
                slides ? obstacle.direction_to(swept_core, entry) : Vec2{}};
    }
    // A thick body may have thin pieces.
    if (shape.kind == FormKind::piece && inner < least_depth) return {};
    // A body with its centroid in the obstacle already goes no deeper.
    const float slip = max(inner, least_depth);
    Impact impact = obstacle.of_point(place(now), place(1.0f), slip);
    if (impact.time < 1.0f && !(is_carried && obstacle.is_beside(swept))) impact.normal = {};
    return impact;
}

bool may_meet(const FinishInput& in, uint32_t shape, uint32_t other) {
    if (in.objects.shapes[shape].surface.sensor || in.objects.shapes[other].surface.sensor ||
        !may_collide(in.objects, in.filter, shape, other))
        return false;
    // If all contacts act, no contact is read, because pairs may be ending at the same time
    // (`finish_bodies`).
    if (!in.skips) return true;
    const uint32_t contact = in.boxes.pairs.find(shape, other);
    return contact == PairSet::absent || in.objects.contacts[contact].skipped == Skipped::no;
}

Box4 swept_box(const FinishInput& in, uint32_t shape, const Motion& motion, float now) {
    const BodyRecord& body = in.objects.bodies[in.objects.forms[shape].body];
    const Box4& box = in.boxes.boxes[shape];
    const Vec2 start = motion.center(now) - body.center, end = motion.center(1.0f) - body.center;
    const Box4 path = unite({box.low + start, box.high + start}, {box.low + end, box.high + end});
    // No point is farther than the chord from where it would be without the rotation.
    const float rotation = max(std::fabs(motion.angle + motion.turn * motion.passed(now)),
                               std::fabs(motion.angle + motion.turn * motion.passed(1.0f)));
    return grow(path, min(rotation, 2.0f) * body.extent + speculative_margin);
}

namespace {

/// Visits the shapes of a body, each with the fixed shapes on its way from `now` to 1.
void for_each_fixed_on_way(const FinishInput& in, uint32_t body, const Motion& motion, float now,
                           auto&& visit) {
    for_each_pushing(in.objects, body, [&](uint32_t s) {
        const Box4 swept = swept_box(in, s, motion, now);
        const auto meet = [&](uint32_t other) {
            if (may_meet(in, s, other)) visit(s, other);
        };
        in.boxes.fixed_tree.query(swept, meet);
        for (uint32_t side = 0; in.settings.bounds && side < 4; ++side)
            if (overlap(swept, in.boxes.fat_boxes[side])) meet(side);
    });
}

Motion motion_of_fixed(const FinishInput& in, uint32_t shape) {
    return at_rest(in.objects.bodies[in.objects.forms[shape].body].center);
}

}  // namespace

namespace {

/// The way of a body between fixed shapes.
class WayBetweenFixed {
  public:
    WayBetweenFixed(const FinishInput& in, uint32_t body, const Motion& motion, float now)
        : in_(in), record_(in.objects.bodies[body]), motion_(motion), now_(now) {
        for_each_fixed_on_way(in, body, motion, now, [&](uint32_t s, uint32_t other) {
            const float arrival = time_of(s, other, 0.0f, hit_gap);
            if (arrival < 1.0f) meetings_.push_back({s, other, arrival});
            first_ = min(first_, arrival);
        });
    }

    Impact impact() {
        Impact first = {first_, {}, {}};
        if (first_ >= 1.0f || !is_beside()) return first;
        first.time = 1.0f;
        if (!(way_of(record_, motion_) > near_motion(record_))) return first;
        for (const auto& [s, other, arrival] : meetings_) {
            if (arrival < first.time && is_blocked(s, other, arrival)) first = {arrival, {}, {}};
            const Impact impact = time_of_impact(in_, s, motion_, other, motion_of(other), now_);
            if (impact.time < first.time) first = impact;
        }
        return first;
    }

  private:
    struct Meeting {
        uint32_t shape, other;
        float arrival;
    };

    Motion motion_of(uint32_t fixed) const { return motion_of_fixed(in_, fixed); }
    /// When the part of a shape that is deeper than `depth` gets as near as `gap`.
    float time_of(uint32_t s, uint32_t other, float depth, float gap) const {
        const Obstacle obstacle(in_, other, motion_of(other), now_);
        if (obstacle.is_from_behind(centroid_at(in_, s, motion_, now_))) return 1.0f;
        const Core core(solid_of(in_.objects, in_.columns, s), centroid_of(in_, s), depth);
        return obstacle.time_of({core.solid(), motion_, record_.extent}, gap);
    }
    /// True if the step may have solved a contact of the body with something fixed.
    bool is_beside() const {
        return std::any_of(meetings_.begin(), meetings_.end(), [&](const Meeting& m) {
            return !(time_of(m.shape, m.other, 0.0f, speculative_margin) > now_);
        });
    }
    /// True if a shape of a body that lies, slides or rolls on something would get deep into
    /// another obstacle: a wheel into a kerb. The seams of a floor do not count: they are met by no
    /// core that is deeper than what lies on the floor sinks in.
    bool is_blocked(uint32_t s, uint32_t other, float arrival) const {
        const Solid shape = solid_of(in_.objects, in_.columns, s);
        const float inner = inner_radius(shape, centroid_of(in_, s));
        const Obstacle obstacle(in_, other, motion_of(other), now_);
        if (!(arrival > now_)) return false;
        const Vec2 normal = obstacle.direction_to({shape, motion_, record_.extent}, arrival);
        const float deep = -dot(normal, motion_.velocity) * (1.0f - arrival);
        if (!(deep > blocked_share * inner)) return false;
        float depth = speculative_margin;
        while (depth < 0.5f * inner && lies_deeper(s, depth)) depth *= 2.0f;
        return depth < 0.5f * inner && time_of(s, other, depth, hit_gap) < 1.0f;
    }
    /// True if the shape is in something fixed by more than `depth` already.
    bool lies_deeper(uint32_t s, float depth) const {
        return std::any_of(meetings_.begin(), meetings_.end(), [&](const Meeting& m) {
            return m.shape == s && !(time_of(s, m.other, depth, hit_gap) > now_);
        });
    }

    const FinishInput& in_;
    const BodyRecord& record_;
    const Motion& motion_;
    const float now_;
    std::vector<Meeting> meetings_;
    float first_ = 1.0f;
};

}  // namespace

Impact time_of_impact_with_fixed(const FinishInput& in, uint32_t body, const Motion& motion,
                                 float now) {
    return WayBetweenFixed(in, body, motion, now).impact();
}

namespace {
float greatest_speed_of(const FinishInput& in, const BodyRecord& body) {
    return min(in.settings.max_speed, in.objects.max_speed_of(body));
}
}  // namespace

void limit_speed(const FinishInput& in, uint32_t body) {
    Vec2& velocity = in.columns.states[body].velocity;
    const float most = greatest_speed_of(in, in.objects.bodies[body]), speed = length(velocity);
    if (speed > most) velocity = (most / speed) * velocity;
}

void undo_forces(const FinishInput& in, uint32_t body, float share) {
    const BodyRecord& record = in.objects.bodies[body];
    const SolverForce& force = in.bodies.solver_forces[record.solver_index];
    BodyState& state = in.columns.states[body];
    if (length(state.velocity) > 0.999f * greatest_speed_of(in, record)) return;
    const float substeps = share * float(in.substeps);
    if (!record.flags.locked_x) state.velocity.x -= substeps * force.change.x;
    if (!record.flags.locked_y) state.velocity.y -= substeps * force.change.y;
    if (!record.flags.locked_rotation) state.angular_velocity -= substeps * force.turn_change;
    for (VelocitySums& sums : in.sums)
        if (sums.solver_body == record.solver_index) sums.without_forces += share;
    limit_speed(in, body);
}

void follow_motion(const FinishInput& in, uint32_t body, const Motion& motion,
                   FinishedPiece& piece) {
    BodyRecord& record = in.objects.bodies[body];
    BodyState& state = in.columns.states[body];
    record.center = bounded(motion.center(1.0f), greatest_coordinate);
    state.angle = bounded(state.angle + float(motion.rotation(1.0f)), greatest_coordinate);
    const Rotation q = rotation_of(double(state.angle) + double(record.angle_rest));
    state.cosine = q.c;
    state.sine = q.s;
    state.position = bounded(record.center - rotate(q, record.local_center), greatest_coordinate);
    finish_shapes(in, body, q, piece);
}

}  // namespace fettle::physics::detail
