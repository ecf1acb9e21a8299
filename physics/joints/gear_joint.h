#pragma once

#include <fettle/physics/types.h>
#include <joints/joint_constraint.h>

namespace fettle::physics::detail {

struct GearData {
    uint32_t joint = 0;  ///< record of what all joints have
    float ratio = 1.0f, phase = 0.0f;
    struct Impulses {
        float angle = 0.0f;
        void scale(float s) { angle *= s; }
    } impulses;
};

/// Turns b with a, by a ratio.
struct GearConstraint {
    using Data = GearData;

    JointEnds ends;
    Data::Impulses impulses;
    float ratio = 1.0f, mass = 0.0f;
    float start = 0.0f;  ///< C when the step began

    void prepare(const Data& data, const JointFrame& frame, const JointStep& step,
                 const SolverBody& a, const SolverBody& b);
    void warm_start(SolverBody& a, SolverBody& b) const { mesh(a, b, impulses.angle); }
    void solve(SolverBody& a, SolverBody& b, const JointStep& step);
    void relax(SolverBody& a, SolverBody& b, const JointStep& step);
    V2 push() const { return {}; }
    float twist() const { return impulses.angle; }

  private:
    void mesh(SolverBody& a, SolverBody& b, float p) const;
    template <bool biased>
    void hold(SolverBody& a, SolverBody& b, const JointStep& step);
};

}  // namespace fettle::physics::detail
