#pragma once

#include <fettle/physics/types.h>
#include <joints/joint_constraint.h>

namespace fettle::physics::detail {

struct DistanceData {
    uint32_t joint = 0;  ///< record of what all joints have
    float length = 1.0f, min_length = 0.0f, max_length = infinity;
    float hertz = infinity, damping_ratio = 0.0f;
    struct Impulses {
        float along = 0.0f;  ///< of the rod or the spring; positive pushes apart
        float lower = 0.0f, upper = 0.0f;
        void scale(float s) { along *= s, lower *= s, upper *= s; }
    } impulses;
};

/// Keeps two points at a distance (rod), pulls them there (spring), or between two (rope).
struct DistanceConstraint {
    using Data = DistanceData;

    JointEnds ends;
    Data::Impulses impulses;
    bool rigid = true, springy = false, limited = false;
    float length = 0.0f, lower = 0.0f, upper = 0.0f;
    Spring spring;
    V2 axis;  ///< from a to b
    float lever_a = 0.0f, lever_b = 0.0f, mass = 0.0f;

    void prepare(const Data& data, const JointFrame& frame, const JointStep& step,
                 const SolverBody& a, const SolverBody& b);
    void warm_start(SolverBody& a, SolverBody& b) const;
    void solve(SolverBody& a, SolverBody& b, const JointStep& step);
    void relax(SolverBody& a, SolverBody& b, const JointStep& step);
    V2 push() const { return (impulses.along + impulses.lower - impulses.upper) * axis; }
    float twist() const { return 0.0f; }
    float follow(const SolverBody& a, const SolverBody& b);

  private:
    float velocity(const SolverBody& a, const SolverBody& b) const;
    void push_along(SolverBody& a, SolverBody& b, float p) const;
    template <bool biased>
    void solve_limits(SolverBody& a, SolverBody& b, float distance, const JointStep& step);
};

}  // namespace fettle::physics::detail
