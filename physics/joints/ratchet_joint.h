#pragma once

#include <fettle/physics/types.h>
#include <joints/joint_constraint.h>

namespace fettle::physics::detail {

struct RatchetData {
    uint32_t joint = 0;  ///< record of what all joints have
    float tooth = 0.0f;  ///< rad; its sign is the way that b may turn
    bool backwards = false;
    float reference_angle = 0.0f;
    struct Impulses {
        float pawl = 0.0f;
        float caught = 0.0f;   ///< the tooth that the pawl is behind, rad
        bool engaged = false;  ///< it is behind one
        void scale(float s) { pawl *= s; }
    } impulses;
};

/// Lets b turn against a one way.
struct RatchetConstraint {
    using Data = RatchetData;

    JointEnds ends;
    Data::Impulses impulses;
    float way = 1.0f, reference = 0.0f, mass = 0.0f;

    void prepare(const Data& data, const JointFrame& frame, const JointStep& step,
                 const SolverBody& a, const SolverBody& b);
    void warm_start(SolverBody& a, SolverBody& b) const {
        detail::twist(a, b, way * impulses.pawl);
    }
    void solve(SolverBody& a, SolverBody& b, const JointStep& step) { hold<true>(a, b, step); }
    void relax(SolverBody& a, SolverBody& b, const JointStep& step) { hold<false>(a, b, step); }
    V2 push() const { return {}; }
    float twist() const { return way * impulses.pawl; }

  private:
    template <bool biased>
    void hold(SolverBody& a, SolverBody& b, const JointStep& step);
};

}  // namespace fettle::physics::detail
