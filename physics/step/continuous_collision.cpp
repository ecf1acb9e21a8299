#include <state/limits.h>
#include <step/time_of_impact.h>

#include <algorithm>

// Continuous collision: what happens to a body that moved far compared with its thickness. Fixed
// shapes stop it at once, on the thread that finishes it. Moving bodies and sensors come after all
// bodies have their poses.

namespace fettle::physics::detail {
namespace {

/// Boxes of a driven body are in groups, each after a box around the group.
constexpr uint32_t boxes_of_group = 8;

/// A body whose centroid is at an obstacle moves along it, and turns, but does not go farther. The
/// contact of a thin body that turns fast cannot stop it, because the part that touches moves away.
void slide_along(Impact impact, Motion& motion, Vec2& velocity) {
    motion.velocity = motion.velocity + impact.back;
    const Vec2 normal = normalized(impact.back);
    velocity = velocity - min(dot(velocity, normal), 0.0f) * normal;
}

/// Puts the body back to where a fixed shape stopped it. It keeps the velocity with which it
/// arrived, and the next step finds an ordinary contact.
void stop_at_fixed(const FinishInput& in, FastBody& fast, FinishedPiece& piece) {
    Motion& motion = fast.motion;
    Impact impact = time_of_impact_with_fixed(in, fast.body, motion, 0.0f);
    if (impact.time >= 1.0f) return;
    for (int obstacles = 0; obstacles < 2 && length_squared(impact.back) > 0.0f; ++obstacles) {
        slide_along(impact, motion, in.columns.states[fast.body].velocity);
        impact = time_of_impact_with_fixed(in, fast.body, motion, 0.0f);
    }
    motion.until = impact.time;
    undo_forces(in, fast.body, 1.0f - motion.until);
    follow_motion(in, fast.body, motion, piece);
    motion.angle = -motion.until * motion.turn;
    fast.joined = in.objects.bodies[fast.body].lists.first_joint != none;
}

/// True if the body moves far, seen from a kinematic body, and may reach it: compared with its
/// thickness, since a kinematic body that moves searches for what it hits. `path`: a box around the
/// body on its way.
bool is_fast_beside(const FinishInput& in, const BodyRecord& body, const Motion& motion,
                    const Box4& path, const DrivenBody& driven) {
    if (!overlap(path, driven.box)) return false;
    const Vec2 apart = body.center - driven.motion.center(1.0f);
    const Vec2 shift = motion.velocity - driven.motion.velocity - cross(driven.motion.turn, apart);
    const float way = way_of(body, shift, motion.turn - driven.motion.turn);
    const bool stands = driven.motion.velocity == Vec2{} && driven.motion.turn == 0.0f;
    if (!(way > (stands ? least_hit_motion(body) : near_motion(body)))) return false;
    const Box4* const boxes = in.scratch.driven_boxes.data() + driven.first_box;
    for (uint32_t i = 0; i < driven.boxes; i += 1 + boxes_of_group) {
        if (!overlap(path, boxes[i])) continue;
        const uint32_t last = std::min(i + 1 + boxes_of_group, driven.boxes);
        for (uint32_t k = i + 1; k < last; ++k)
            if (overlap(path, boxes[k])) return true;
    }
    return false;
}

void list_driven_body(const FinishInput& in, uint32_t body, const SolverBody& b) {
    const BodyRecord& record = in.objects.bodies[body];
    const Vec2 shift = shift_of(b);
    const float turn = turn_of(b);
    const float chord = min(std::fabs(turn), 2.0f) * record.extent;
    DrivenBody driven;
    driven.body = body;
    driven.motion = motion_to(record.center + shift, shift, turn);
    std::vector<Box4>& boxes = in.scratch.driven_boxes;
    driven.first_box = uint32_t(boxes.size());
    for (uint32_t s = record.lists.first_shape; s != none; s = in.objects.shapes[s].next) {
        if (!in.objects.is_solid(s) || in.objects.shapes[s].surface.sensor) continue;
        if (driven.boxes % (1 + boxes_of_group) == 0) {
            boxes.push_back(no_box);
            ++driven.boxes;
        }
        const Box4& box = in.boxes.boxes[s];
        boxes.push_back(grow(unite(box, {box.low + shift, box.high + shift}), chord));
        ++driven.boxes;
        Box4& around = boxes[driven.first_box +
                             (driven.boxes - 1) / (1 + boxes_of_group) * (1 + boxes_of_group)];
        around = unite(around, boxes.back());
        driven.box = unite(driven.box, boxes.back());
    }
    in.scratch.driven_bodies.push_back(driven);
}

/// A box around the body on its way. It is larger than those of its shapes, but computed faster.
Box4 path_of(const BodyRecord& body, Vec2 shift) {
    const Position start = body.center - shift, end = body.center;
    return grow(unite(box_of(start, start), box_of(end, end)), body.extent + speculative_margin);
}

bool may_meet_fixed(const FinishInput& in, const Box4& path) {
    if (in.settings.bounds) {
        for (uint32_t side = 0; side < border_sides; ++side)
            if (overlap(path, in.boxes.fat_boxes[side])) return true;
    }
    return in.boxes.fixed_tree.meets(path);
}

/// True if the motion must be compared with those of moving bodies. `far`: it is far compared with
/// the thickness of the body.
bool may_meet_moving(const FinishInput& in, const BodyRecord& record, const Motion& motion,
                     const Box4& path, bool far) {
    const std::vector<DrivenBody>& driven = in.scratch.driven_bodies;
    if (record.mobility == Mobility::kinematic) return true;
    if (far && in.objects.bullets > 0) return true;
    if (in.objects.kinematic_bodies > driven.size()) return true;  // some stand still
    return std::any_of(driven.begin(), driven.end(), [&](const DrivenBody& other) {
        return is_fast_beside(in, record, motion, path, other);
    });
}

}  // namespace

void stop_or_list(const FinishInput& in, uint32_t body, Vec2 shift, float turn,
                  FinishedPiece& piece) {
    const BodyRecord& record = in.objects.bodies[body];
    const Box4 path = path_of(record, shift);
    FastBody fast;
    fast.body = body;
    fast.motion = motion_to(record.center, shift, turn);
    const bool dynamic = record.mobility == Mobility::dynamic;
    // A bullet stops where its surface meets a body: inside of it, the normal would be another one.
    const float near = record.flags.bullet ? least_hit_motion(record) : near_motion(record);
    const bool far = !dynamic || way_of(record, fast.motion) > near;
    fast.meets_moving = may_meet_moving(in, record, fast.motion, path, far);
    if (dynamic && !in.filter && may_meet_fixed(in, path)) stop_at_fixed(in, fast, piece);
    if (in.filter || fast.meets_moving || fast.joined || (far && in.objects.sensors > 0))
        piece.fast.push_back(fast);
}

void list_driven_bodies(const FinishInput& in) {
    in.scratch.driven_bodies.clear();
    in.scratch.driven_boxes.clear();
    if (!in.bodies.driven) return;
    for (size_t i = 0; i < in.active.awake_bodies.size(); ++i) {
        const SolverBody& b = in.bodies.solver_bodies[i + 1];
        if (b.inverse_mass > 0.0f) continue;
        const uint32_t slot = in.active.awake_bodies[i];
        if (in.objects.bodies[slot].mobility != Mobility::kinematic) continue;
        list_driven_body(in, slot, b);
    }
}

void stop_fast_bodies(const FinishInput& in) {
    if (in.active.awake_bodies.empty()) return;
    FinishedPiece& piece = in.scratch.finished.front();
    for (FastBody& fast : in.scratch.fast_bodies) {
        if (!in.filter || in.objects.bodies[fast.body].mobility != Mobility::dynamic) continue;
        piece.clear();
        stop_at_fixed(in, fast, piece);
        follow_placed(in, piece);
    }
    put_back_joined(in);
    meet_moving_bodies(in);
    if (in.objects.sensors > 0) report_crossings(in);
}

}  // namespace fettle::physics::detail
