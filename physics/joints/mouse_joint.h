#pragma once

#include <fettle/physics/types.h>
#include <joints/joint_constraint.h>

namespace fettle::physics::detail {

struct MouseData {
    uint32_t joint = 0;  ///< record of what all joints have
    float hertz = 5.0f, damping_ratio = 0.7f, max_force = infinity;
    struct Impulses {
        V2 pull;
        void scale(float s) { pull = s * pull; }
    } impulses;
};

/// Pulls a point of a body (b) softly towards a point of the world (a).
struct MouseConstraint {
    using Data = MouseData;

    JointEnds ends;
    Data::Impulses impulses;
    float greatest = 0.0f;
    Softness softness;
    PointMass mass;

    void prepare(const Data& data, const JointFrame& frame, const JointStep& step,
                 const SolverBody& a, const SolverBody& b);
    void warm_start(SolverBody& a, SolverBody& b) const;
    void solve(SolverBody& a, SolverBody& b, const JointStep& step);
    void relax(SolverBody&, SolverBody&, const JointStep&) {}
    V2 push() const { return impulses.pull; }
    float twist() const { return 0.0f; }
};

}  // namespace fettle::physics::detail
