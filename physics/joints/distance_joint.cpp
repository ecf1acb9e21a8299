#include <joints/coordinate.h>
#include <joints/joint_handle.h>
#include <joints/joint_types.h>

// A rod (with infinite stiffness), a spring, or a rope between two points.
//
// With d = p_b - p_a between the anchors and n = d/|d|, all rows have the same Jacobian:
//
//     C = |d| - length,   Ċ = n·(v_b + ω_b×r_b - v_a - ω_a×r_a),
//     K = m_a⁻¹ + m_b⁻¹ + I_a⁻¹·(r_a×n)² + I_b⁻¹·(r_b×n)²,   effective mass 1/K.
//
// Rod: C = 0, softly. Spring: a force along n. Limits: |d| - min >= 0 and max - |d| >= 0, each with
// an impulse in one direction only. The axis is computed in each pass, so that a pendulum follows
// its circle.

namespace fettle::physics {
namespace detail {

struct DistanceSettings {
    static constexpr JointType type = JointType::distance;
    float length = 1.0f;
    Limits limits = {0.0f, infinity};
    Stiffness stiffness = {infinity, 0.0f};

    void check() const {
        check_not_negative("length", length);
        check_not_negative("min_length", limits.lower);
        check_strength("max_length", limits.upper);
        check_stiffness("hertz", stiffness.hertz);
        check_not_negative("damping_ratio", stiffness.damping_ratio);
    }
};

struct DistanceConstraint {
    using Settings = DistanceSettings;
    struct Impulses {
        float along = 0.0f;  ///< impulse of the rod or the spring; positive pushes apart
        LimitImpulses limits;
        void scale(float s) { along *= s, limits.scale(s); }
        float sum() const { return along + limits.lower - limits.upper; }
    };

    JointEnds ends;
    Impulses impulses;
    bool rigid = true, springy = false, limited = false;
    float length = 0.0f;
    Limits limits;
    Spring spring;
    Line line;  ///< from a to b

    void prepare(const Settings& settings, const JointFrame&, const JointStep& step,
                 const SolverBody& a, const SolverBody& b) {
        limits = settings.limits.in_order();
        rigid = settings.stiffness.is_rigid();
        springy = settings.stiffness.is_spring();
        length = rigid ? clamp(settings.length, limits.lower, limits.upper) : settings.length;
        if (springy) spring = settings.stiffness.spring(step.h);
        if (rigid || !(limits.lower > 0.0f)) limits.lower = -infinity;
        if (rigid) limits.upper = infinity;
        limited = limits.any();
        // A part that stops acting begins with impulse 0 when it acts again.
        if (!rigid && !springy) impulses.along = 0.0f;
        if (!limited) impulses.limits = {};
        follow(a, b);
    }

    /// Rotates the levers and the axis with the bodies; returns the distance.
    float follow(const SolverBody& a, const SolverBody& b) {
        ends.follow(a, b);
        const Vec2 d = ends.gap(a, b);
        const float distance = detail::length(d);
        Vec2 axis = line.direction;
        // If the anchors coincide, the axis keeps its direction, or is arbitrary at first.
        if (distance > 1e-9f) axis = (1.0f / distance) * d;
        if (axis.x == 0.0f && axis.y == 0.0f) axis = {0.0f, 1.0f};
        line.aim(ends, axis, ends.lever_a, a, b);
        return distance;
    }

    void warm_start(SolverBody& a, SolverBody& b) const { line.push(ends, a, b, impulses.sum()); }
    void solve(SolverBody& a, SolverBody& b, const JointStep& step) {
        const float distance = follow(a, b), error = distance - length;
        if (springy) {
            const float change =
                spring.impulse(line.mass, line.velocity(a, b), error, impulses.along);
            impulses.along += change;
            line.push(ends, a, b, change);
        } else if (rigid) {
            hold<true>(a, b, error, step);
        }
        limit<true>(a, b, distance, step);
    }
    void relax(SolverBody& a, SolverBody& b, const JointStep& step) {
        if (!rigid && !limited) return;
        const float distance = follow(a, b);
        if (rigid) hold<false>(a, b, distance - length, step);
        limit<false>(a, b, distance, step);
    }
    void write_rows(RowWriter& rows, const SolverBody& a, const SolverBody& b) {
        const float distance = follow(a, b), error = distance - length;
        const Jacobian along = line.jacobian(ends);
        if (springy)
            rows.spring(along, spring, line.mass, error, impulses.along);
        else if (rigid)
            rows.hold(along, error, impulses.along);
        write_limits(limits, impulses.limits, distance, along, rows);
    }
    JointLoad load() const { return {impulses.sum() * line.direction, 0.0f}; }

  private:
    template <bool biased>
    void hold(SolverBody& a, SolverBody& b, float error, const JointStep& step) {
        line.push(ends, a, b,
                  push_rigid<biased>(impulses.along, line.mass, line.velocity(a, b), error, step));
    }
    template <bool biased>
    void limit(SolverBody& a, SolverBody& b, float distance, const JointStep& step) {
        solve_limits<biased>(
            limits, impulses.limits, line.mass, distance, step, [&] { return line.velocity(a, b); },
            [&](float p) { line.push(ends, a, b, p); });
    }
};

constinit const JointKind distance_joint = JointFunctions<DistanceConstraint>::kind("distance");

}  // namespace detail

using namespace detail;

FETTLE_JOINT_NUMBER(Distance, length, length)
FETTLE_JOINT_NUMBER(Distance, min_length, limits.lower)
FETTLE_JOINT_NUMBER(Distance, max_length, limits.upper)
FETTLE_JOINT_NUMBER(Distance, hertz, stiffness.hertz)
FETTLE_JOINT_NUMBER(Distance, damping_ratio, stiffness.damping_ratio)

float DistanceJoint::distance() const {
    return gap_between(*this).length();
}

FETTLE_CREATE_JOINT(Distance, create_distance_joint, joint.set_length(joint.distance()))

}  // namespace fettle::physics
