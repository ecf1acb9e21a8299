#pragma once

#include <fettle/physics/types.h>
#include <joints/joint_constraint.h>

namespace fettle::physics::detail {

struct MotorData {
    uint32_t joint = 0;  ///< record of what all joints have
    V2 linear_velocity;  ///< of anchor b against a, in the coordinates of body a
    float angular_velocity = 0.0f;
    float max_force = 0.0f, max_torque = 0.0f;
    V2 linear_offset;  ///< of anchor b from anchor a, in the coordinates of body a
    float angular_offset = 0.0f;
    float hertz = 0.0f, damping_ratio = 1.0f;
    struct Impulses {
        V2 force;
        float torque = 0.0f;
        void scale(float s) { force = s * force, torque *= s; }
    } impulses;
};

/// Drives b against a with a force and a torque that have a limit.
struct MotorConstraint {
    using Data = MotorData;

    JointEnds ends;
    Data::Impulses impulses;
    V2 speed, offset;  ///< when the step began, world axes
    float turn_speed = 0.0f, angle = 0.0f, angular_mass = 0.0f;
    float greatest_force = 0.0f, greatest_torque = 0.0f;
    bool springy = false;
    Spring spring;

    void prepare(const Data& data, const JointFrame& frame, const JointStep& step,
                 const SolverBody& a, const SolverBody& b);
    void warm_start(SolverBody& a, SolverBody& b) const;
    void solve(SolverBody& a, SolverBody& b, const JointStep& step);
    void relax(SolverBody& a, SolverBody& b, const JointStep& step);
    V2 push() const { return impulses.force; }
    float twist() const { return impulses.torque; }
    V2 follow(const SolverBody& a, const SolverBody& b);

  private:
    void drive(SolverBody& a, SolverBody& b, bool springs);
};

}  // namespace fettle::physics::detail
