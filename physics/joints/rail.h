#pragma once

#include <fettle/physics/types.h>
#include <joints/joint_constraint.h>

// A line that body a carries and a point of body b that slides along it: what prismatic, wheel,
// groove and pin-slot joints have in common.

namespace fettle::physics::detail {

/// A row along a direction that turns with body a.
struct Line {
    V2 direction;
    float lever_a = 0.0f, lever_b = 0.0f, mass = 0.0f;

    /// `arm`: from the center of mass of a to the anchor of b.
    void aim(const JointEnds& ends, V2 towards, V2 arm, const SolverBody& a, const SolverBody& b);
    float velocity(const SolverBody& a, const SolverBody& b) const {
        return dot(direction, b.velocity - a.velocity) +
               (lever_b * b.angular_velocity - lever_a * a.angular_velocity);
    }
    void push(const JointEnds& ends, SolverBody& a, SolverBody& b, float p) const;
};

struct RailSettings {
    V2 axis = {1.0f, 0.0f};  ///< in the coordinates of body a, of any length
    float lower = -infinity, upper = infinity;
    float motor_speed = 0.0f, max_motor_force = 0.0f;
    float hertz = 0.0f, damping_ratio = 0.0f, target = 0.0f;
};

struct RailImpulses {
    float across = 0.0f, spring = 0.0f, motor = 0.0f, lower = 0.0f, upper = 0.0f;
    void scale(float s) { across *= s, spring *= s, motor *= s, lower *= s, upper *= s; }
    float along() const { return spring + motor + lower - upper; }
};

struct Rail {
    V2 start_axis;
    Line along, across;
    float translation = 0.0f;  ///< of b along the axis
    float offset = 0.0f;       ///< of b across it: to be 0
    float lower = 0.0f, upper = 0.0f, motor_speed = 0.0f, greatest_motor = 0.0f, target = 0.0f;
    bool springy = false, driven = false, limited = false;
    Spring spring;

    void prepare(const RailSettings& settings, RailImpulses& impulses, JointEnds& ends,
                 const JointFrame& frame, const JointStep& step, const SolverBody& a,
                 const SolverBody& b);
    /// Turns levers and directions with the bodies.
    void follow(JointEnds& ends, const SolverBody& a, const SolverBody& b);
    void push_both(const RailImpulses& impulses, const JointEnds& ends, SolverBody& a,
                   SolverBody& b) const;
    template <bool biased>
    void solve_along(RailImpulses& impulses, const JointEnds& ends, SolverBody& a, SolverBody& b,
                     const JointStep& step) const;
    template <bool biased>
    void solve_across(RailImpulses& impulses, const JointEnds& ends, SolverBody& a, SolverBody& b,
                      const JointStep& step) const;
    bool acts_along() const { return springy || driven || limited; }
    V2 force(const RailImpulses& impulses) const {
        return impulses.along() * along.direction + impulses.across * across.direction;
    }
};

}  // namespace fettle::physics::detail
