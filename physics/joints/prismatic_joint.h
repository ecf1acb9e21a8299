#pragma once

#include <joints/rail.h>

namespace fettle::physics::detail {

struct PrismaticData {
    uint32_t joint = 0;  ///< record of what all joints have
    RailSettings rail;
    float reference_angle = 0.0f;
    struct Impulses {
        RailImpulses rail;
        float angle = 0.0f;
        void scale(float s) { rail.scale(s), angle *= s; }
    } impulses;
};

/// Lets b slide along an axis of a without turning.
struct PrismaticConstraint {
    using Data = PrismaticData;

    JointEnds ends;
    Data::Impulses impulses;
    Rail rail;
    float reference = 0.0f;

    void prepare(const Data& data, const JointFrame& frame, const JointStep& step,
                 const SolverBody& a, const SolverBody& b);
    void warm_start(SolverBody& a, SolverBody& b) const;
    void solve(SolverBody& a, SolverBody& b, const JointStep& step);
    void relax(SolverBody& a, SolverBody& b, const JointStep& step);
    V2 push() const { return rail.force(impulses.rail); }
    float twist() const { return impulses.angle; }

  private:
    template <bool biased>
    void solve_block(SolverBody& a, SolverBody& b, const JointStep& step);
};

}  // namespace fettle::physics::detail
