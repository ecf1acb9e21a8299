#pragma once

#include <checks/arguments.h>
#include <constraints/joint_rows.h>
#include <solver/joints/direct_row.h>

// Parts of several types of joints: settings, and the constraints along one free coordinate (an
// angle or a translation). These are a spring to a target, a motor that drives a velocity with a
// maximum force (or torque), and limits, q - lower >= 0 and upper - q >= 0.

namespace fettle::physics::detail {

/// A row along a direction that rotates with a body, or with a line between two bodies.
struct Line {
    Vec2 direction;
    float lever_a = 0.0f, lever_b = 0.0f, mass = 0.0f;

    /// `arm_a`: from the center of mass of a to the point where the row pushes.
    void set_direction(const JointEnds& ends, Vec2 towards, Vec2 arm_a, const SolverBody& a,
                       const SolverBody& b) {
        direction = towards;
        lever_a = cross(arm_a, towards);
        lever_b = cross(ends.lever_b, towards);
        mass = inverse_or_zero(ends.inverse_along(towards) + a.inverse_inertia * lever_a * lever_a +
                               b.inverse_inertia * lever_b * lever_b);
    }
    float velocity(const SolverBody& a, const SolverBody& b) const {
        return dot(direction, b.velocity - a.velocity) +
               (lever_b * b.angular_velocity - lever_a * a.angular_velocity);
    }
    void push(const JointEnds& ends, SolverBody& a, SolverBody& b, float p) const {
        a.velocity = a.velocity - p * scaled(ends.inverse_a, direction);
        a.angular_velocity -= a.inverse_inertia * lever_a * p;
        b.velocity = b.velocity + p * scaled(ends.inverse_b, direction);
        b.angular_velocity += b.inverse_inertia * lever_b * p;
    }
    Jacobian jacobian(const JointEnds& ends) const {
        return Jacobian::along(ends, direction, lever_a, lever_b);
    }
};

inline void check(const Stiffness& stiffness) {
    check_not_negative("hertz", stiffness.hertz);
    check_not_negative("damping_ratio", stiffness.damping_ratio);
}

struct Limits {
    float lower = -infinity, upper = infinity;

    bool any() const { return lower > -infinity || upper < infinity; }
    /// If the limits cross, the upper one is used.
    Limits in_order() const { return {min(lower, upper), upper}; }
    /// The value itself, if it is within the limits, which are in order.
    float nearest(float value) const { return clamp(value, lower, upper); }
    /// How far a value is outside of the limits; if they cross, the upper one is used.
    float beyond(float value) const {
        return max(0.0f, max(min(lower, upper) - value, value - upper));
    }
};

/// A distance or a translation, or a place nearer to the limits if an obstacle keeps the joint from
/// coming there: `JointEnds::greatest_error`.
inline float bounded_place(const JointEnds& ends, const Limits& limits, float place) {
    const float allowed = limits.nearest(place);
    return allowed + ends.bounded_error(place - allowed);
}

/// Moves two bodies that are far beyond a limit along `direction`; returns the remaining place.
inline float close_beyond_limits(const JointEnds& ends, const Limits& limits, SolverBody& a,
                                 SolverBody& b, Vec2 direction, float place,
                                 const JointStep& step) {
    const float allowed = limits.nearest(place);
    const float error = ends.bounded_error(place - allowed);
    return allowed + ends.close_wide_gap(a, b, direction, error, step);
}

/// True if a velocity has the direction of the speed of a motor. The threshold is small, because a
/// body that accelerates slowly moves, too.
inline bool follows(float velocity, float speed) {
    return velocity * speed > 0.01f * speed * speed;
}

struct Motor {
    float speed = 0.0f;
    float greatest = 0.0f;  ///< N or N m; in a step, an impulse

    bool gives_energy() const { return greatest > 0.0f && speed != 0.0f; }
    bool moves_bodies(float velocity) const { return greatest > 0.0f && follows(velocity, speed); }
    /// Its speed, but not beyond a limit. If the motor were as fast there, the limit would have to
    /// hold its whole force, and would yield.
    float speed_within(const Limits& limits, float position, float inverse_h) const {
        return clamp(speed, min((limits.lower - position) * inverse_h, 0.0f),
                     max((limits.upper - position) * inverse_h, 0.0f));
    }
    /// The limit at which the motor holds its bodies: 1: the upper one, -1: the lower one; 0: it is
    /// on its way. What would be reached in a sub-step with `near_speed` counts as reached: arms of
    /// several strong motors would swing out of a narrower range again and again.
    int stopped_at(const Limits& limits, float position, float inverse_h) const {
        constexpr float near_speed = 10.0f;  // m/s or rad/s
        if (speed > 0.0f && (limits.upper - position) * inverse_h < near_speed) return 1;
        if (speed < 0.0f && (position - limits.lower) * inverse_h < near_speed) return -1;
        return 0;
    }
};

struct LimitImpulses {
    float lower = 0.0f, upper = 0.0f;
    void scale(float s) { lower *= s, upper *= s; }
    float sum() const { return lower - upper; }
};

/// Friction and a limit must not press against each other: the limit would yield to the friction. A
/// part of what both exert is taken from both, which changes no velocity; not all of it, because
/// some of it may come from an impact, which the next sub-step reverses.
inline void relieve(float& motor, LimitImpulses& limits) {
    constexpr float share = 0.25f;
    float& limit = motor > 0.0f ? limits.upper : limits.lower;
    const float both = share * min(std::abs(motor), limit);
    limit -= both;
    motor -= motor > 0.0f ? both : -both;
}

/// A motor at a limit, `end` as in `Motor::stopped_at`, is one rigid row that holds the place of
/// the limit: with any force against the motor, and with that of the motor to its side. If the
/// motor and the limit were two rows, they would press against each other, and several such joints
/// in a chain would never come to rest. Returns the change of the impulse along the coordinate.
template <bool biased>
float hold_at_limit(float& motor_impulse, LimitImpulses& impulses, const Motor& motor,
                    const Limits& limits, int end, float mass, float position, float velocity,
                    const JointStep& step, float greatest_gap) {
    const float sign = float(end);
    float& limit = end > 0 ? impulses.upper : impulses.lower;
    const float error = sign * (position - (end > 0 ? limits.upper : limits.lower));
    const float before = sign * motor_impulse - limit;
    float total = before;
    push_rigid<biased>(total, mass, sign * velocity, error,
                       step.softness_up_to(greatest_gap, error));
    total = min(total, motor.greatest);
    motor_impulse = sign * max(total, 0.0f);
    limit = max(-total, 0.0f);
    return sign * (total - before);
}

/// Solves the limits of a row, but not the one at `end`, as in `Motor::stopped_at`. `velocity()`
/// and `push(impulse)` are the functions of the row; `greatest_gap`: as in `push_limit`;
/// `greatest`: the impulse that a limit may exert.
template <bool biased, class Velocity, class Push>
void solve_limits(const Limits& limits, LimitImpulses& impulses, float mass, float position,
                  const JointStep& step, float greatest_gap, Velocity&& velocity, Push&& push,
                  int end = 0, float greatest = infinity) {
    if (limits.lower > -infinity && end >= 0)
        push(push_limit<biased>(impulses.lower, mass, velocity(), position - limits.lower, step,
                                greatest_gap, greatest));
    if (limits.upper < infinity && end <= 0)
        push(-push_limit<biased>(impulses.upper, mass, -velocity(), limits.upper - position, step,
                                 greatest_gap, greatest));
}

/// `greatest`: the impulse that a limit may exert.
inline void write_limits(const Limits& limits, LimitImpulses& impulses, float position,
                         const Jacobian& jacobian, float greatest, RowWriter& rows) {
    const auto limit = [&](const Jacobian& along, float room, float& impulse) {
        rows.limit(along, room, impulse).high = double(greatest);
    };
    if (limits.lower > -infinity) limit(jacobian, position - limits.lower, impulses.lower);
    if (limits.upper < infinity)
        limit(jacobian.opposite(), limits.upper - position, impulses.upper);
}

struct CoordinateSettings {
    Limits limits;
    Motor motor;
    Stiffness stiffness;
    float target = 0.0f;  ///< of the spring

    struct Names {
        const char *lower, *upper, *greatest, *target;
    };
    static constexpr Names of_angle = {"lower_angle", "upper_angle", "max_motor_torque",
                                       "target_angle"};
    bool gives_energy() const { return stiffness.is_spring() || motor.gives_energy(); }
    static constexpr Names of_translation = {"lower_translation", "upper_translation",
                                             "max_motor_force", "target_translation"};
    void check(const Names& names) const {
        check_limit(names.lower, limits.lower);
        check_limit(names.upper, limits.upper);
        check_finite("motor_speed", motor.speed);
        check_strength(names.greatest, motor.greatest);
        detail::check(stiffness);
        check_finite(names.target, target);
    }
};

/// The settings in the definition of a joint that slides along an axis with a motor.
template <class Def>
CoordinateSettings driven_translation(const Def& def) {
    return {{def.lower_translation, def.upper_translation},
            {def.motor_speed, def.max_motor_force},
            {def.hertz, def.damping_ratio},
            def.target_translation};
}

struct CoordinateImpulses {
    float spring = 0.0f, motor = 0.0f;
    LimitImpulses limits;
    void scale(float s) { spring *= s, motor *= s, limits.scale(s); }
    float sum() const { return spring + motor + limits.sum(); }
};

struct Coordinate {
    Limits limits;
    Motor motor;
    Spring spring;
    float target = 0.0f;
    bool springy = false, limited = false;
    bool driven = false;   ///< has a motor
    bool drives = false;   ///< the motor has a speed: it is more than friction
    bool bounded = false;  ///< has limits, or a motor that drives

    /// `mass`: that of the spring, see `Spring::make`; `moved`: the one that an impulse along the
    /// coordinate moves, 0 if it has no effect; `joints`: as in `Spring::make`.
    void prepare(const CoordinateSettings& settings, CoordinateImpulses& impulses, float h,
                 float mass, float moved, uint32_t joints) {
        if (moved > 0.0f) {
            limits = settings.limits.in_order();
            springy = settings.stiffness.is_spring();
            driven = settings.motor.greatest > 0.0f;
            drives = driven && settings.motor.speed != 0.0f;
            limited = limits.any();
            bounded = limited || drives;
        }
        motor = {settings.motor.speed, settings.motor.greatest * h};
        target = settings.target;
        if (springy) spring = Spring::make(settings.stiffness, h, mass, moved, joints);
        // A part that stops acting begins with impulse 0 when it acts again.
        if (!springy) impulses.spring = 0.0f;
        if (!driven) impulses.motor = 0.0f;
        if (!limited) impulses.limits = {};
    }

    /// True if the motor moves the bodies, and neither a limit nor an obstacle stops it.
    bool moves_bodies(float velocity) const { return driven && motor.moves_bodies(velocity); }

    /// The first part of a pass, before the rigid rows of the joint: springs, in the biased pass,
    /// and friction, in the relax pass. Motors, like the friction of contacts, act in the relax
    /// pass only: in the biased pass they would work against the correction of positions.
    /// `velocity()` and `push(impulse)` are the functions of the coordinate.
    template <bool biased, class Velocity, class Push>
    void solve_alone(CoordinateImpulses& impulses, float mass, float position, Velocity&& velocity,
                     Push&& push) const {
        if (biased && springy) {
            const float change =
                spring.impulse(mass, velocity(), position - target, impulses.spring);
            impulses.spring += change;
            push(change);
        }
        if (!biased && driven && !drives)
            push(push_motor(impulses.motor, mass, velocity(), 0.0f, motor.greatest));
    }
    /// True if the rigid rows hold reactions to the limits or to the motor, and to the spring that
    /// pushes against them.
    bool has_reactions(const CoordinateImpulses& impulses) const {
        return bounded && (drives || impulses.limits.lower > 0.0f || impulses.limits.upper > 0.0f);
    }
    /// True if a pass changes impulses of the motor or of the limits.
    template <bool biased>
    bool is_bounded(const CoordinateImpulses& impulses, float position, float velocity,
                    const JointStep& step) const {
        if (drives && (!biased || motor.stopped_at(limits, position, step.inverse_h) != 0))
            return true;
        return limited && (impulses.limits.lower > 0.0f || impulses.limits.upper > 0.0f ||
                           velocity + (position - limits.lower) * step.inverse_h < 0.0f ||
                           (limits.upper - position) * step.inverse_h - velocity < 0.0f);
    }
    /// The last part of a pass, after the rigid rows, if `is_bounded`: the motor and the limits,
    /// with the mass that the rigid rows leave. `push` also gives the rigid rows their reaction:
    /// see free_rows.h.
    template <bool biased, class Velocity, class Push>
    void solve_bounds(CoordinateImpulses& impulses, float mass, float position,
                      const JointStep& step, float greatest_gap, Velocity&& velocity,
                      Push&& push) const {
        const int end = drives ? motor.stopped_at(limits, position, step.inverse_h) : 0;
        if (end != 0) {
            push(hold_at_limit<biased>(impulses.motor, impulses.limits, motor, limits, end, mass,
                                       position, velocity(), step, greatest_gap));
        } else if (!biased && drives) {
            const float speed = motor.speed_within(limits, position, step.inverse_h);
            push(push_motor(impulses.motor, mass, velocity(), speed, motor.greatest,
                            speed != motor.speed));
        }
        solve_limits<biased>(limits, impulses.limits, mass, position, step, greatest_gap, velocity,
                             push, end);
        if (!biased && end == 0 && driven && limited) relieve(impulses.motor, impulses.limits);
    }
    void write_rows(CoordinateImpulses& impulses, float position, const Jacobian& jacobian,
                    RowWriter& rows) const {
        if (springy) rows.spring(jacobian, spring, position - target, impulses.spring);
        if (driven) {
            const float speed = motor.speed_within(limits, position, 1.0f / float(rows.h()));
            rows.motor(jacobian, speed, motor.greatest, impulses.motor);
        }
        write_limits(limits, impulses.limits, position, jacobian, infinity, rows);
    }
};

}  // namespace fettle::physics::detail
