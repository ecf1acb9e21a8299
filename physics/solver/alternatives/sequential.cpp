#include <solver/joints/joint_passes.h>
#include <solver/motion.h>
#include <solver/solvers.h>

#include <algorithm>

// The method of a student project of 2008: bodies move, contacts are found, and then each contact
// is corrected by itself, once, the worst first (after I. Millington, "Game Physics Engine
// Development", 2007, ch. 7 and 14: impulses, then overlaps, in order of severity). Contacts of
// shapes that are near but do not touch are included, so that a body that is pushed into a neighbor
// is corrected in the same pass.
//
// In each sub-step, with h its length, s the separation and v the relative velocity of a point:
//
// 1. Velocities change by the forces. 2. Points in order of s + h·v_n, their separation after the
// move (in the project, the depth, because it moved bodies first). A point that would overlap gets
// the impulse after which v_n = -s/h, or v_n = -e·v_n if it bounces, and friction up to μ times
// that impulse. 3. Bodies move. 4. Points in order of s: half of each overlap is removed by a shift
// along the normal, which the two bodies share by their inverse masses. Last, bodies that still
// overlap a body that does not yield are moved out of it: with the push speed at most, but always
// by as much as the sub-step has pressed them in.
//
// There is no iteration and no warm start: a push that arrives at a point that was already
// processed has an effect only in the next sub-step. So stacks of more than a few boxes tremble and
// sink. Both points of a manifold are separate contacts. Joints, which the project did not have,
// are solved as in the soft step.

namespace fettle::physics::detail {
namespace {

/// A point of a contact, and its place in the order of a pass.
struct QueuedPoint {
    float severity;  ///< separation, m; the deepest come first
    float before;    ///< separation at the beginning of the sub-step, m
    uint32_t constraint;
    uint32_t point;

    friend bool operator<(const QueuedPoint& a, const QueuedPoint& b) {
        if (a.severity != b.severity) return a.severity < b.severity;
        return a.constraint != b.constraint ? a.constraint < b.constraint : a.point < b.point;
    }
};

struct ContactGap {
    float separation;
    float velocity;
};

class SequentialPass {
  public:
    SequentialPass(const SolverInput& input, float h)
        : input_(input),
          constraints_(input.contacts.serial.constraints),
          extras_(input.contacts.serial.extras),
          bodies_(input.bodies.solver_bodies),
          h_(h) {
        for (uint32_t i = 0; i < constraints_.size(); ++i) {
            for (uint32_t k = 0; k < constraints_[i].count; ++k)
                queue_.push_back({0.0f, 0.0f, i, k});
        }
    }

    void resolve_velocities() {
        follow_curved_contacts(input_);
        for (ContactConstraint& c : constraints_) {
            for (ConstraintPoint& p : c.points) p.normal_impulse = p.tangent_impulse = 0.0f;
        }
        for (ContactExtra& extra : extras_) extra.rolling_impulse = 0.0f;
        for (QueuedPoint& queued : queue_) {
            const ContactGap gap = gap_of(queued);
            queued.severity = bounded(gap.separation + h_ * gap.velocity, 1e30f);
            queued.before = gap.separation;
        }
        std::sort(queue_.begin(), queue_.end());
        for (const QueuedPoint& queued : queue_) bounce(queued);
        for (const ContactConstraint& c : constraints_)
            if (c.extra != 0) extras_[c.extra - 1].record(c);
    }

    void remove_overlaps() {
        follow_curved_contacts(input_);
        for (QueuedPoint& queued : queue_)
            queued.severity = bounded(gap_of(queued).separation, 1e30f);
        std::sort(queue_.begin(), queue_.end());
        const float push = h_ * input_.settings.push_speed;
        for (const QueuedPoint& queued : queue_) push_apart(queued, 0.5f, push);
        // A body that does not move does not yield. Without this, other bodies press a body on the
        // ground further in than half of its overlap is removed, and a heap sinks through. A light
        // body under a heavy load is pressed in faster than with the push speed.
        for (const QueuedPoint& queued : queue_) {
            if (constraints_[queued.constraint].fixed == 0) continue;
            const float pressed = min(queued.before, 0.0f) - gap_of(queued).separation;
            push_apart(queued, 1.0f, max(push, pressed));
        }
    }

  private:
    ContactGap gap_of(const QueuedPoint& queued) const {
        const ContactConstraint& c = constraints_[queued.constraint];
        const ConstraintPoint& p = c.points[queued.point];
        const SolverBody &a = bodies_[c.a], &b = bodies_[c.b];
        const float opened = dot(c.normal, b.shift - a.shift) +
                             (p.normal_lever_b * b.turn - p.normal_lever_a * a.turn);
        const float velocity =
            dot(c.normal, b.velocity - a.velocity) +
            (p.normal_lever_b * b.angular_velocity - p.normal_lever_a * a.angular_velocity);
        if (c.extra == 0) return {p.separation + opened, velocity};
        const Corner& corner = extras_[c.extra - 1].corner;
        if (corner.distance == 0.0f) return {p.separation + opened, velocity};
        const CornerPath path =
            path_around(corner, c.normal, a, b, PairMotion(a, b), opened, velocity, h_);
        return {p.separation + opened + path.gap, velocity + path.opening / h_};
    }

    void apply(const ContactConstraint& c, Vec2 direction, float impulse, float lever_a,
               float lever_b) {
        SolverBody &a = bodies_[c.a], &b = bodies_[c.b];
        const Vec2 p = impulse * direction;
        a.velocity = a.velocity - Vec2{c.inverse_a.x * p.x, c.inverse_a.y * p.y};
        a.angular_velocity -= a.inverse_inertia * lever_a * impulse;
        b.velocity = b.velocity + Vec2{c.inverse_b.x * p.x, c.inverse_b.y * p.y};
        b.angular_velocity += b.inverse_inertia * lever_b * impulse;
    }

    void bounce(const QueuedPoint& queued) {
        ContactConstraint& c = constraints_[queued.constraint];
        ConstraintPoint& p = c.points[queued.point];
        ContactExtra* extra = c.extra != 0 ? &extras_[c.extra - 1] : nullptr;
        const ContactGap gap = gap_of(queued);
        // If the shapes are apart, the gap may close, but not more.
        const float excess = gap.velocity + max(gap.separation, 0.0f) / h_;
        if (!(excess < 0.0f)) return;
        const bool bounces =
            extra != nullptr && gap.velocity < -input_.settings.restitution_threshold;
        const float change =
            bounces ? max(-excess, -(1.0f + extra->restitution) * gap.velocity) : -excess;
        p.normal_impulse = p.normal_mass * change;
        apply(c, c.normal, p.normal_impulse, p.normal_lever_a, p.normal_lever_b);
        if (extra != nullptr) resist_rolling(c, *extra, p.normal_impulse);
        apply_friction(c, p, extra != nullptr ? extra->surface_speed : 0.0f);
    }

    /// Applies friction after the normal impulse, which has changed the rotation, too.
    void apply_friction(const ContactConstraint& c, ConstraintPoint& p, float surface_speed) {
        const SolverBody &a = bodies_[c.a], &b = bodies_[c.b];
        const Vec2 t = right_perp(c.normal);
        const float slip =
            dot(t, b.velocity - a.velocity) + surface_speed +
            (p.tangent_lever_b * b.angular_velocity - p.tangent_lever_a * a.angular_velocity);
        const float greatest = c.friction * p.normal_impulse;
        p.tangent_impulse = clamp(-p.tangent_mass * slip, -greatest, greatest);
        apply(c, t, p.tangent_impulse, p.tangent_lever_a, p.tangent_lever_b);
    }

    void resist_rolling(const ContactConstraint& c, ContactExtra& extra, float normal_impulse) {
        if (!(extra.rolling_resistance > 0.0f)) return;
        SolverBody &a = bodies_[c.a], &b = bodies_[c.b];
        const float greatest = extra.rolling_resistance * normal_impulse;
        const float impulse = clamp(-extra.rolling_mass * (b.angular_velocity - a.angular_velocity),
                                    -greatest, greatest);
        extra.rolling_impulse += impulse;
        a.angular_velocity -= a.inverse_inertia * impulse;
        b.angular_velocity += b.inverse_inertia * impulse;
    }

    /// `part`: of the overlap that is removed; `most`: the longest way, m.
    void push_apart(const QueuedPoint& queued, float part, float most) {
        const ContactConstraint& c = constraints_[queued.constraint];
        const float depth = -gap_of(queued).separation;
        if (!(depth > 0.0f)) return;
        const Vec2 n = c.normal;
        const float inverse = c.inverse_along(n);
        if (!(inverse > 0.0f)) return;
        const float way = min(part * depth, most) / inverse;
        SolverBody &a = bodies_[c.a], &b = bodies_[c.b];
        a.shift = a.shift - way * Vec2{c.inverse_a.x * n.x, c.inverse_a.y * n.y};
        b.shift = b.shift + way * Vec2{c.inverse_b.x * n.x, c.inverse_b.y * n.y};
    }

    const SolverInput& input_;
    std::span<ContactConstraint> constraints_;
    std::span<ContactExtra> extras_;
    std::span<SolverBody> bodies_;
    float h_;
    std::vector<QueuedPoint> queue_;
};

}  // namespace

void solve_sequentially(const SolverInput& input, const JointStep& joint_step) {
    const SolverBlocks& blocks = input.schedule.blocks;
    const StripNodes all = input.strips.all_nodes();
    std::vector<SolverBody>& bodies = input.bodies.solver_bodies;
    SequentialPass pass(input, joint_step.h);
    for (int substep = 0; substep < input.settings.substeps; ++substep) {
        apply_forces(input, joint_step.h);
        pass_joints(&JointKind::warm_start, input.joints, bodies, joint_step, all);
        pass.resolve_velocities();
        pass_joints(&JointKind::solve, input.joints, bodies, joint_step, all);
        zero_locked(input);
        integrate_positions(blocks.bodies_of(blocks[0]), bodies, joint_step.h);
        pass.remove_overlaps();
        pass_joints(&JointKind::relax, input.joints, bodies, joint_step, all);
        zero_locked(input);
        add_strains(input.joints);
    }
}

}  // namespace fettle::physics::detail
