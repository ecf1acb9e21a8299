#include <state/limits.h>
#include <step/impact.h>

#include <algorithm>

// Continuous collision: what happens to a body that moved far compared with its thickness. Fixed
// shapes stop it at once, on the thread that finishes it. Moving bodies and sensors come after all
// bodies have their poses.

namespace fettle::physics::detail {
namespace {

/// Puts the body back to where a fixed shape stopped it. It keeps its velocity, and the next step
/// finds an ordinary contact.
void stop_at_fixed(const FinishInput& in, FastBody& fast, FinishedPiece& piece) {
    Motion& motion = fast.motion;
    motion.until = time_of_impact_with_fixed(in, fast.body, motion, 0.0f);
    if (motion.until >= 1.0f) return;
    follow_motion(in, fast.body, motion, piece);
    motion.angle = -motion.until * motion.turn;
}

/// True if the body moves far compared with its thickness, seen from a body that moves on its own,
/// and may reach it.
bool is_fast_beside(const BodyRecord& body, const Motion& motion, const DrivenBody& driven) {
    const V2 apart = body.center - driven.motion.center(1.0f);
    const V2 shift = motion.velocity - driven.motion.velocity - cross(driven.motion.turn, apart);
    const float way = length(shift) +
                      std::fabs(motion.turn - driven.motion.turn) * (body.extent - body.thickness);
    return way > near_motion(body) &&
           length(apart) < body.extent + driven.extent + length(motion.velocity) +
                               length(driven.motion.velocity) + speculative_margin;
}

/// True if the motion must be compared with those of moving bodies.
bool may_meet_moving(const FinishInput& in, const FastBody& fast) {
    const BodyRecord& record = in.objects.bodies[fast.body];
    const std::vector<DrivenBody>& driven = in.scratch.driven_bodies;
    if (in.bodies.bullets || record.mobility == Mobility::kinematic) return true;
    if (in.objects.kinematic_bodies > driven.size()) return true;  // some stand still
    return std::ranges::any_of(driven, [&](const DrivenBody& other) {
        return is_fast_beside(record, fast.motion, other);
    });
}

}  // namespace

void stop_or_list(const FinishInput& in, FastBody fast, FinishedPiece& piece) {
    const bool dynamic = in.objects.bodies[fast.body].mobility == Mobility::dynamic;
    if (dynamic && !in.filter) stop_at_fixed(in, fast, piece);
    fast.meets_moving = may_meet_moving(in, fast);
    if (in.filter || fast.meets_moving || in.objects.sensors > 0) piece.fast.push_back(fast);
}

void list_driven_bodies(const FinishInput& in) {
    in.scratch.driven_bodies.clear();
    if (!in.bodies.driven) return;
    for (size_t i = 0; i < in.active.awake_bodies.size(); ++i) {
        const SolverBody& b = in.bodies.solver_bodies[i + 1];
        if (b.inverse_mass > 0.0f) continue;
        const uint32_t slot = in.active.awake_bodies[i];
        const BodyRecord& record = in.objects.bodies[slot];
        if (record.mobility != Mobility::kinematic) continue;
        const V2 shift = shift_of(b);
        in.scratch.driven_bodies.push_back(
            {slot, motion_to(record.center + shift, shift, turn_of(b)), record.extent});
    }
}

void stop_fast_bodies(const FinishInput& in) {
    FinishedPiece& piece = in.scratch.finished.front();
    for (FastBody& fast : in.scratch.fast_bodies) {
        if (!in.filter || in.objects.bodies[fast.body].mobility != Mobility::dynamic) continue;
        piece.clear();
        stop_at_fixed(in, fast, piece);
        follow_placed(in, piece);
    }
    meet_moving_bodies(in);
    if (in.objects.sensors > 0) report_crossings(in);
}

}  // namespace fettle::physics::detail
