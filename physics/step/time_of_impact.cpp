#include <contacts/overlaps/overlaps.h>
#include <distance/shape_core.h>
#include <geometry/trigonometry.h>
#include <state/limits.h>
#include <step/obstacle.h>

namespace fettle::physics::detail {
namespace {

/// Distance from the obstacle at arrival, m; within the range of a speculative contact.
constexpr float arrival_gap = 0.25f * speculative_margin;

/// Depths of the cores of a shape, in inner radii. If the first core touches an obstacle already,
/// the body may move on until the next core touches it. It would stand still otherwise.
constexpr float core_depths[] = {0.5f, 0.75f};

/// True if the body of the shape is kinematic.
bool is_driven(const FinishInput& in, uint32_t shape) {
    return in.objects.bodies[in.objects.forms[shape].body].mobility == Mobility::kinematic;
}

/// True if the body of the shape is dynamic or kinematic.
bool moves(const FinishInput& in, uint32_t shape) {
    return in.objects.bodies[in.objects.forms[shape].body].mobility != Mobility::fixed;
}

/// True if the body had a contact at the beginning of the step.
bool had_contact(const FinishInput& in, const BodyRecord& body) {
    return in.objects.any_contact(body.lists.first_contact, none, [&](uint32_t contact) {
        const ContactRecord& c = in.objects.contacts[contact];
        return !c.sensor && c.manifold.count > 0;
    });
}

/// True if the body of the shape moves away from a fixed obstacle that it overlaps, and a contact
/// pushes it out of the body of the other shape in the same direction: it was crushed between them.
/// If this direction leads deeper into the other body at first, it must not be held there: its
/// velocity would grow while it stays.
bool is_leaving(const FinishInput& in, uint32_t shape, const Motion& motion, uint32_t other,
                const Motion& other_motion) {
    const uint32_t body = in.objects.forms[shape].body, from = in.objects.forms[other].body;
    bool leaves_fixed = false, leaves_other = false;
    in.objects.for_each_contact(body, [&](uint32_t contact) {
        const ContactRecord& c = in.objects.contacts[contact];
        if (!c.acts()) return;
        const uint32_t opposite = in.objects.other_body(contact, body);
        const ManifoldPoint& point = c.manifold.points[0];
        const bool is_a = c.body_a == body;
        Vec2 moved = motion.velocity + cross(motion.turn, is_a ? point.anchor_a : point.anchor_b);
        if (opposite == from)
            moved = moved - other_motion.velocity -
                    cross(other_motion.turn, is_a ? point.anchor_b : point.anchor_a);
        const bool leaves = dot(normal_towards(body, c), moved) > 0.0f;
        leaves_other |= leaves && opposite == from;
        leaves_fixed |= leaves && in.objects.bodies[opposite].mobility == Mobility::fixed &&
                        overlap_of(c.manifold) > 0.0f;
    });
    return leaves_fixed && leaves_other;
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
    if (moves(in, other) && is_leaving(in, s, motion, other, other_motion)) return {};
    // A body with its centroid in the obstacle already goes no deeper.
    const float slip = max(inner, least_depth);
    Impact impact = obstacle.of_point(place(now), place(1.0f), slip);
    if (impact.time < 1.0f && !(is_carried && obstacle.is_beside(swept))) impact.normal = {};
    return impact;
}

bool is_allowed(const FinishInput& in, uint32_t shape, uint32_t other) {
    if (!in.filter || in.boxes.pairs.find(shape, other) != PairSet::absent) return true;
    return in.filter(shape, other);
}

/// True if one of the shapes is a part of an outline, and another part of it passes through the
/// other body, which crushes it. Without this, the parts that are inside and have no contact would
/// stay where they are, although no force holds them.
bool passes_through(const FinishInput& in, uint32_t shape, uint32_t other) {
    const ObjectState& objects = in.objects;
    const auto is_part = [&](uint32_t slot) { return objects.shapes[slot].owner != none; };
    if (!is_part(shape) && !is_part(other)) return false;
    const uint32_t body = objects.forms[shape].body, opposite = objects.forms[other].body;
    return objects.any_contact(objects.bodies[body].lists.first_contact, none, [&](uint32_t i) {
        const ContactRecord& c = objects.contacts[i];
        return c.skipped == Skipped::crushed && objects.other_body(i, body) == opposite;
    });
}

bool may_meet(const FinishInput& in, uint32_t shape, uint32_t other) {
    if (in.objects.shapes[shape].surface.sensor || in.objects.shapes[other].surface.sensor ||
        !may_collide(in.objects, {}, shape, other) || !is_allowed(in, shape, other))
        return false;
    // If all contacts act, no contact is read, because pairs may be ending at the same time
    // (`finish_bodies`).
    if (!in.skips) return true;
    const uint32_t contact = in.boxes.pairs.find(shape, other);
    if (contact != PairSet::absent && in.objects.contacts[contact].skipped != Skipped::no)
        return false;
    return !passes_through(in, shape, other);
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
