#pragma once

#include <joints/rail.h>

namespace fettle::physics::detail {

struct WheelData {
    uint32_t joint = 0;  ///< record of what all joints have
    RailSettings rail = {.axis = {0.0f, 1.0f}, .hertz = 4.0f, .damping_ratio = 0.7f};
    float motor_speed = 0.0f, max_motor_torque = 0.0f;
    struct Impulses {
        RailImpulses rail;
        float motor = 0.0f;
        void scale(float s) { rail.scale(s), motor *= s; }
    } impulses;
};

/// A wheel (b) that turns freely or by a motor and is sprung along an axis of a.
struct WheelConstraint {
    using Data = WheelData;

    JointEnds ends;
    Data::Impulses impulses;
    Rail rail;
    float motor_speed = 0.0f, greatest_motor = 0.0f, angular_mass = 0.0f;
    bool driven = false;

    void prepare(const Data& data, const JointFrame& frame, const JointStep& step,
                 const SolverBody& a, const SolverBody& b);
    void warm_start(SolverBody& a, SolverBody& b) const;
    void solve(SolverBody& a, SolverBody& b, const JointStep& step);
    void relax(SolverBody& a, SolverBody& b, const JointStep& step);
    V2 push() const { return rail.force(impulses.rail); }
    float twist() const { return impulses.motor; }

  private:
    void drive(SolverBody& a, SolverBody& b);
};

}  // namespace fettle::physics::detail
