#pragma once

#include <fettle/physics/types.h>
#include <joints/joint_constraint.h>

namespace fettle::physics::detail {

struct WeldData {
    uint32_t joint = 0;  ///< record of what all joints have
    float reference_angle = 0.0f;
    float hertz = infinity, damping_ratio = 0.0f;
    float angular_hertz = infinity, angular_damping_ratio = 0.0f;
    struct Impulses {
        V2 point;
        float angle = 0.0f;
        void scale(float s) { point = s * point, angle *= s; }
    } impulses;
};

/// Holds two bodies together at a point and an angle, rigidly or as a spring.
struct WeldConstraint {
    using Data = WeldData;

    JointEnds ends;
    Data::Impulses impulses;
    float reference = 0.0f, angular_mass = 0.0f;
    bool rigid_point = true, rigid_angle = true, springy_point = false, springy_angle = false;
    Spring point_spring, angle_spring;

    void prepare(const Data& data, const JointFrame& frame, const JointStep& step,
                 const SolverBody& a, const SolverBody& b);
    void warm_start(SolverBody& a, SolverBody& b) const;
    void solve(SolverBody& a, SolverBody& b, const JointStep& step);
    void relax(SolverBody& a, SolverBody& b, const JointStep& step);
    V2 push() const { return impulses.point; }
    float twist() const { return impulses.angle; }

  private:
    template <bool biased>
    void solve_rigid(SolverBody& a, SolverBody& b, const JointStep& step);
    void solve_springs(SolverBody& a, SolverBody& b);
    void apply(SolverBody& a, SolverBody& b, V2 point, float angle);
};

}  // namespace fettle::physics::detail
