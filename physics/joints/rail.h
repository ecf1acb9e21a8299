#pragma once

#include <joints/free_rows.h>
#include <joints/joint_handle.h>

// A line on body a, and a point of body b that slides along it: the common part of prismatic,
// wheel, groove and pin-slot joints. The axis u and its perpendicular n rotate with body a. With d
// = p_b - p_a and R = r_a + d, the arm from the center of a to the anchor of b:
//
//     s = u·d,   ṡ = u·(v_b - v_a) + (r_b×u)·ω_b - (R×u)·ω_a      translation
//     C = n·d,   Ċ = n·(v_b - v_a) + (r_b×n)·ω_b - (R×n)·ω_a      across, to be 0
//
// since u̇ = ω_a×u adds ω_a·(u×d) to the difference of the anchors' velocities; this extends the
// arm of a to b. The effective mass of a row is 1 / (uᵀ(M_a⁻¹ + M_b⁻¹)u + I_a⁻¹(R×u)² +
// I_b⁻¹(r_b×u)²).

namespace fettle::physics::detail {

struct RailSettings {
    Vec2 axis = {1.0f, 0.0f};  ///< in the coordinates of body a, with any length except 0
    CoordinateSettings along;

    void check() const {
        check_direction("axis", axis);
        along.check(CoordinateSettings::of_translation);
    }
    bool gives_energy() const { return along.gives_energy(); }
    float separation(const JointPlace& place) const {
        const Vec2 direction = rotate(place.a, normalized(axis)), gap = place.gap();
        return length({cross(direction, gap), along.limits.beyond(dot(direction, gap))});
    }
};

struct RailImpulses {
    float across = 0.0f;
    CoordinateImpulses along;
    void scale(float s) { across *= s, along.scale(s); }
};

struct RailReaction {
    float across = 0.0f, turning = 0.0f;
};

struct Rail {
    Vec2 start_axis;
    Line along, across;
    float translation = 0.0f;  ///< of b along the axis
    float offset = 0.0f;       ///< of b across the axis: held at 0
    Coordinate coordinate;     ///< the translation

    void prepare(const RailSettings& settings, RailImpulses& impulses, JointEnds& ends,
                 const JointFrame& frame, const JointStep& step, const SolverBody& a,
                 const SolverBody& b) {
        start_axis = rotate(frame.a, normalized(settings.axis));
        follow(ends, a, b);
        coordinate.prepare(settings.along, impulses.along, step.h, ends.spring_mass(a, b),
                           along.mass, ends.joints);
    }
    /// Rotates levers and directions with the bodies.
    void follow(JointEnds& ends, const SolverBody& a, const SolverBody& b) {
        ends.follow(a, b);
        const Vec2 axis = turned(start_axis, a.turn), normal = {-axis.y, axis.x};
        const Vec2 gap = ends.gap(a, b);
        translation = dot(axis, gap);
        offset = dot(normal, gap);
        along.set_direction(ends, axis, ends.lever_a + gap, a, b);
        across.set_direction(ends, normal, ends.lever_a + gap, a, b);
    }
    void warm_start(const RailImpulses& impulses, const JointEnds& ends, SolverBody& a,
                    SolverBody& b) const {
        along.push(ends, a, b, impulses.along.sum());
        across.push(ends, a, b, impulses.across);
    }
    /// The first part of a pass, before the rigid rows. Closes what is far beyond a limit.
    template <bool biased>
    void solve_alone(RailImpulses& impulses, const JointEnds& ends, SolverBody& a, SolverBody& b,
                     const JointStep& step) {
        if (biased && coordinate.limited)
            translation = close_beyond_limits(ends, coordinate.limits, a, b, along.direction,
                                              translation, step);
        coordinate.solve_alone<biased>(
            impulses.along, along.mass, translation, [&] { return along.velocity(a, b); },
            [&](float p) { along.push(ends, a, b, p); });
    }
    FreeSlide free_slide(const JointEnds& ends, const SolverBody& a, const SolverBody& b,
                         bool holds_angle) const {
        return FreeSlide::make(ends, along, across, a, b, holds_angle);
    }
    /// The parts of the impulses of the rigid rows that are reactions to the motor, the limits and
    /// the spring.
    RailReaction reaction(const RailImpulses& impulses, const JointEnds& ends, const SolverBody& a,
                          const SolverBody& b, bool holds_angle) const {
        if (!coordinate.has_reactions(impulses.along)) return {};
        const FreeSlide free = free_slide(ends, a, b, holds_angle);
        const float sum = impulses.along.sum();
        return {sum * free.across, sum * free.turning};
    }
    /// The last part of a pass, after the rigid rows. `twist`: impulse of the row that holds the
    /// angle, if there is one.
    template <bool biased>
    void solve_bounds(RailImpulses& impulses, const JointEnds& ends, SolverBody& a, SolverBody& b,
                      const JointStep& step, float* twist = nullptr) const {
        if (!coordinate.bounded) return;
        if (!coordinate.is_bounded<biased>(impulses.along, translation, along.velocity(a, b), step))
            return;
        const FreeSlide free = free_slide(ends, a, b, twist != nullptr);
        coordinate.solve_bounds<biased>(
            impulses.along, free.mass, translation, step, step.greatest_length_gap,
            [&] { return along.velocity(a, b); },
            [&](float p) {
                along.push(ends, a, b, p);
                across.push(ends, a, b, p * free.across);
                impulses.across += p * free.across;
                if (twist == nullptr) return;
                detail::twist(a, b, p * free.turning);
                *twist += p * free.turning;
            });
    }
    /// `reaction`: the part of the impulse across that is a `RailReaction`.
    template <bool biased>
    void solve_across(RailImpulses& impulses, float reaction, const JointEnds& ends, SolverBody& a,
                      SolverBody& b, const JointStep& step) const {
        const float error = biased ? close_wide_gap(ends, a, b, step) : offset;
        across.push(ends, a, b,
                    push_rigid<biased>(impulses.across, across.mass, across.velocity(a, b), error,
                                       step.softness(error), reaction));
    }
    /// A pass over all rows of a rail whose bodies turn freely.
    template <bool biased>
    void solve_turning(RailImpulses& impulses, const JointEnds& ends, SolverBody& a, SolverBody& b,
                       const JointStep& step) {
        solve_alone<biased>(impulses, ends, a, b, step);
        RailReaction to_bounds;
        if (biased) to_bounds = reaction(impulses, ends, a, b, false);
        solve_across<biased>(impulses, to_bounds.across, ends, a, b, step);
        solve_bounds<biased>(impulses, ends, a, b, step);
    }
    /// Closes a wide gap across the axis; returns the remaining offset.
    float close_wide_gap(const JointEnds& ends, SolverBody& a, SolverBody& b,
                         const JointStep& step) const {
        return ends.close_wide_gap(a, b, across.direction, offset, step);
    }
    void write_rows(RailImpulses& impulses, const JointEnds& ends, RowWriter& rows) const {
        coordinate.write_rows(impulses.along, bounded_place(ends, coordinate.limits, translation),
                              along.jacobian(ends), rows);
        rows.hold(across.jacobian(ends), offset, impulses.across);
    }
    bool moves_bodies(const SolverBody& a, const SolverBody& b) const {
        return coordinate.moves_bodies(along.velocity(a, b));
    }
    Drive drive(const RailImpulses& impulses) {
        if (!coordinate.drives) return {};
        return {&coordinate.motor.greatest, impulses.along.motor, along.direction, false,
                coordinate.limited};
    }
    Vec2 force(const RailImpulses& impulses) const {
        return impulses.along.sum() * along.direction + impulses.across * across.direction;
    }
};

/// A rail without a row about the angle.
struct SlotConstraint {
    struct Impulses {
        RailImpulses rail;
        void scale(float s) { rail.scale(s); }
    };

    JointEnds ends;
    Impulses impulses;
    Rail rail;

    void warm_start(SolverBody& a, SolverBody& b) const {
        rail.warm_start(impulses.rail, ends, a, b);
    }
    template <bool biased>
    void pass(SolverBody& a, SolverBody& b, const JointStep& step) {
        rail.follow(ends, a, b);
        rail.solve_turning<biased>(impulses.rail, ends, a, b, step);
    }
    void write_rows(RowWriter& rows, const SolverBody& a, const SolverBody& b) {
        rail.follow(ends, a, b);
        rail.write_rows(impulses.rail, ends, rows);
    }
    JointLoad load() const { return {rail.force(impulses.rail), 0.0f}; }
    bool moves_bodies(const SolverBody& a, const SolverBody& b) const {
        return rail.moves_bodies(a, b);
    }
    Drive drive() { return rail.drive(impulses.rail); }
};

}  // namespace fettle::physics::detail

// Defines the properties of the handle of a joint on a rail. `Of`: beginning of the name of its
// type.
#define FETTLE_RAIL(Of)                                                        \
    FETTLE_JOINT_VECTOR(Of, axis, rail.axis)                                   \
    FETTLE_JOINT_NUMBER(Of, lower_translation, rail.along.limits.lower)        \
    FETTLE_JOINT_NUMBER(Of, upper_translation, rail.along.limits.upper)        \
    FETTLE_JOINT_NUMBER(Of, hertz, rail.along.stiffness.hertz)                 \
    FETTLE_JOINT_NUMBER(Of, damping_ratio, rail.along.stiffness.damping_ratio) \
    float Of##Joint::translation() const {                                     \
        return detail::translation_along(*this, axis());                       \
    }
// Defines the properties of a joint with a motor along the rail.
#define FETTLE_RAIL_MOTOR(Of)                                           \
    FETTLE_JOINT_NUMBER(Of, motor_speed, rail.along.motor.speed)        \
    FETTLE_JOINT_NUMBER(Of, max_motor_force, rail.along.motor.greatest) \
    FETTLE_JOINT_NUMBER(Of, target_translation, rail.along.target)      \
    FETTLE_JOINT_FORCE(Of, motor_force, rail.along.motor)
