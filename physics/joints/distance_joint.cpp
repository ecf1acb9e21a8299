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
// an impulse in one direction only. Motor: Ċ = speed with a limited force, unless it is a rod. The
// axis is computed in each pass, so that a pendulum follows its circle.

namespace fettle::physics {
namespace detail {

struct DistanceSettings {
    static constexpr JointType type = JointType::distance;
    float length = 1.0f;
    Limits limits = {0.0f, infinity};
    Stiffness stiffness = {infinity, 0.0f};
    float lower_spring_force = -infinity, upper_spring_force = infinity;  ///< N; positive pushes
    Motor motor;                                                          ///< of the distance

    void check() const {
        check_range("lower_spring_force", lower_spring_force, -infinity, 0.0f);
        check_range("upper_spring_force", upper_spring_force, 0.0f, infinity);
        check_finite("motor_speed", motor.speed);
        check_strength("max_motor_force", motor.greatest);
        check_not_negative("length", length);
        check_not_negative("min_length", limits.lower);
        check_strength("max_length", limits.upper);
        check_strength("hertz", stiffness.hertz);
        check_not_negative("damping_ratio", stiffness.damping_ratio);
    }
    bool gives_energy() const { return stiffness.is_spring() || motor.gives_energy(); }
};

struct DistanceImpulses {
    float along = 0.0f;  ///< impulse of the rod or the spring; positive pushes apart
    float motor = 0.0f;
    LimitImpulses limits;
    void scale(float s) { along *= s, motor *= s, limits.scale(s); }
    float sum() const { return along + motor + limits.lower - limits.upper; }
};

struct DistanceConstraint {
    using Settings = DistanceSettings;

    JointEnds ends;
    DistanceImpulses impulses;
    bool rigid = true, springy = false, limited = false, driven = false, weak = false;
    float least = 0.0f, most = 0.0f;  ///< impulses of a weak spring
    Motor motor;
    float length = 0.0f;
    Limits limits;
    Spring spring;
    Line line;            ///< from a to b
    float excess = 0.0f;  ///< at the start of the step, of the length: < 0 if it is too short

    static float separation(const Settings& settings, const JointPlace& place) {
        const Limits& limits = settings.limits;
        const float now = detail::length(place.gap());
        if (!settings.stiffness.is_rigid()) return limits.beyond(now);
        const Limits ordered = limits.in_order();
        return std::abs(now - clamp(settings.length, ordered.lower, ordered.upper));
    }
    static bool holds(const Settings& settings) { return settings.stiffness.is_rigid(); }
    void prepare(const Settings& settings, const JointFrame&, const JointStep& step,
                 const SolverBody& a, const SolverBody& b) {
        limits = settings.limits.in_order();
        rigid = settings.stiffness.is_rigid();
        springy = settings.stiffness.is_spring();
        length = rigid ? clamp(settings.length, limits.lower, limits.upper) : settings.length;
        if (rigid || !(limits.lower > 0.0f)) limits.lower = -infinity;
        if (rigid) limits.upper = infinity;
        limited = limits.any();
        driven = !rigid && settings.motor.greatest > 0.0f;
        motor = {settings.motor.speed, settings.motor.greatest * step.h};
        weak = settings.lower_spring_force > -infinity || settings.upper_spring_force < infinity;
        least = settings.lower_spring_force * step.h;
        most = settings.upper_spring_force * step.h;
        // A part that stops acting begins with impulse 0 when it acts again.
        if (!rigid && !springy) impulses.along = 0.0f;
        if (!limited) impulses.limits = {};
        if (!driven) impulses.motor = 0.0f;
        const float distance = follow(a, b);
        if (springy)
            spring = Spring::make(settings.stiffness, step.h, ends.spring_mass(a, b), line.mass,
                                  ends.joints);
        excess = rigid ? distance - length : distance - clamp(distance, limits.lower, limits.upper);
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
        line.set_direction(ends, axis, ends.lever_a, a, b);
        return distance;
    }

    void warm_start(SolverBody& a, SolverBody& b) const { line.push(ends, a, b, impulses.sum()); }
    void solve(SolverBody& a, SolverBody& b, const JointStep& step) {
        const float distance = follow(a, b), error = distance - length;
        if (springy) {
            float change = spring.impulse(line.mass, line.velocity(a, b), error, impulses.along);
            if (weak) change = clamp(impulses.along + change, least, most) - impulses.along;
            impulses.along += change;
            line.push(ends, a, b, change);
        } else if (rigid) {
            hold<true>(a, b, ends.bounded_error(error), step);
        }
        limit<true>(a, b, distance, step);
    }
    void relax(SolverBody& a, SolverBody& b, const JointStep& step) {
        // A spring does not act here, but the next sub-step begins with its impulse.
        const float distance = follow(a, b);
        const bool moves = driven && stopped_at(distance, step) == 0;
        if (moves) {
            const float speed = motor.speed_within(limits, distance, step.inverse_h);
            line.push(ends, a, b,
                      push_motor(impulses.motor, line.mass, line.velocity(a, b), speed,
                                 motor.greatest, speed != motor.speed));
        }
        if (rigid) hold<false>(a, b, distance - length, step);
        limit<false>(a, b, distance, step);
        if (moves && limited) relieve(impulses.motor, impulses.limits);
    }
    void write_rows(RowWriter& rows, const SolverBody& a, const SolverBody& b) {
        const float distance = follow(a, b), error = distance - length;
        const Jacobian along = line.jacobian(ends);
        // Between an obstacle and a rod there may be no solution: the rod yields.
        const float greatest = ends.greatest_impulse(line.mass, float(rows.h()));
        if (springy) {
            DirectRow& row = rows.spring(along, spring, error, impulses.along);
            if (weak && rows.biased()) row.low = double(least), row.high = double(most);
        } else if (rigid) {
            DirectRow& row = rows.hold(along, ends.bounded_error(error), impulses.along);
            row.low = -double(greatest), row.high = double(greatest);
        }
        if (driven)
            rows.motor(along, motor.speed_within(limits, distance, 1.0f / float(rows.h())),
                       motor.greatest, impulses.motor);
        write_limits(limits, impulses.limits, bounded_place(ends, limits, distance), along,
                     greatest, rows);
    }
    JointLoad load() const { return {impulses.sum() * line.direction, 0.0f}; }
    bool moves_bodies(const SolverBody& a, const SolverBody& b) const {
        return driven && motor.moves_bodies(line.velocity(a, b));
    }
    Pull pull_now() const {
        const bool is_strained = std::abs(excess) > obstructed_gap;
        const bool pushes = is_strained ? excess < 0.0f : impulses.sum() > 0.0f;
        const Vec2 towards = pushes ? -line.direction : line.direction;
        return {is_strained, !rigid, pushes, {towards, -towards}};
    }
    Drive drive() {
        if (!driven || motor.speed == 0.0f) return {};
        return {&motor.greatest, impulses.motor, line.direction, false};
    }

  private:
    int stopped_at(float distance, const JointStep& step) const {
        return motor.stopped_at(limits, distance, step.inverse_h);
    }
    template <bool biased>
    void hold(SolverBody& a, SolverBody& b, float error, const JointStep& step) {
        if (biased) error = ends.close_wide_gap(a, b, line.direction, error, step);
        const float before = impulses.along;
        push_rigid<biased>(impulses.along, ends.share * line.mass, line.velocity(a, b), error,
                           step.length_softness(error));
        impulses.along = clamp(impulses.along, -ends.greatest_pull, ends.greatest_pull);
        line.push(ends, a, b, impulses.along - before);
    }
    template <bool biased>
    void limit(SolverBody& a, SolverBody& b, float distance, const JointStep& step) {
        if (biased && limited)
            distance = close_beyond_limits(ends, limits, a, b, line.direction, distance, step);
        const int end = driven ? stopped_at(distance, step) : 0;
        if (end != 0)
            line.push(ends, a, b,
                      hold_at_limit<biased>(impulses.motor, impulses.limits, motor, limits, end,
                                            line.mass, distance, line.velocity(a, b), step,
                                            step.greatest_length_gap));
        solve_limits<biased>(
            limits, impulses.limits, line.mass, distance, step, step.greatest_length_gap,
            [&] { return line.velocity(a, b); }, [&](float p) { line.push(ends, a, b, p); }, end,
            ends.greatest_pull);
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
FETTLE_JOINT_NUMBER(Distance, lower_spring_force, lower_spring_force)
FETTLE_JOINT_NUMBER(Distance, upper_spring_force, upper_spring_force)
FETTLE_JOINT_NUMBER(Distance, motor_speed, motor.speed)
FETTLE_JOINT_NUMBER(Distance, max_motor_force, motor.greatest)
FETTLE_JOINT_FORCE(Distance, motor_force, motor)

float DistanceJoint::distance() const {
    return gap_between(*this).length();
}

namespace {

void define(DistanceSettings& settings, const DistanceJointDef& def) {
    settings.length = def.length.value_or(settings.length);
    settings.limits = {def.min_length, def.max_length};
    settings.stiffness = {def.hertz, def.damping_ratio};
    settings.lower_spring_force = def.lower_spring_force;
    settings.upper_spring_force = def.upper_spring_force;
    settings.motor = {def.motor_speed, def.max_motor_force};
}

}  // namespace

FETTLE_CREATE_JOINT(Distance, create_distance_joint,
                    if (!def.length) joint.set_length(joint.distance()))

}  // namespace fettle::physics
