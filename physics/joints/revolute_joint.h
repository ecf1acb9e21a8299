#pragma once

#include <fettle/physics/types.h>
#include <joints/joint_constraint.h>

namespace fettle::physics::detail {

struct RevoluteData {
    uint32_t joint = 0;  ///< record of what all joints have
    float reference_angle = 0.0f;
    float lower_angle = -infinity, upper_angle = infinity;
    float motor_speed = 0.0f, max_motor_torque = 0.0f;
    float hertz = 0.0f, damping_ratio = 0.0f, target_angle = 0.0f;
    struct Impulses {
        V2 point;
        float spring = 0.0f, motor = 0.0f, lower = 0.0f, upper = 0.0f;
        void scale(float s) {
            point = s * point;
            spring *= s, motor *= s, lower *= s, upper *= s;
        }
    } impulses;
};

/// Holds two points together and lets the bodies turn, freely or as limits, a motor and a spring
/// allow.
struct RevoluteConstraint {
    using Data = RevoluteData;

    JointEnds ends;
    Data::Impulses impulses;
    PointMass mass;  ///< of the levers as they are: bodies turn between the two passes only
    float angular_mass = 0.0f;
    float reference = 0.0f, lower = 0.0f, upper = 0.0f, target = 0.0f;
    float motor_speed = 0.0f, greatest_motor = 0.0f;
    bool springy = false, driven = false, limited = false;
    Spring spring;

    void prepare(const Data& data, const JointFrame& frame, const JointStep& step,
                 const SolverBody& a, const SolverBody& b);
    void warm_start(SolverBody& a, SolverBody& b) const;
    void solve(SolverBody& a, SolverBody& b, const JointStep& step);
    void relax(SolverBody& a, SolverBody& b, const JointStep& step);
    V2 push() const { return impulses.point; }
    float twist() const {
        return impulses.spring + impulses.motor + impulses.lower - impulses.upper;
    }

  private:
    template <bool biased>
    void solve_angle(SolverBody& a, SolverBody& b, const JointStep& step);
};

}  // namespace fettle::physics::detail
