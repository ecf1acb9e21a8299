#pragma once

#include <fettle/physics/types.h>
#include <joints/joint_constraint.h>

namespace fettle::physics::detail {

struct PulleyData {
    uint32_t joint = 0;                                    ///< record of what all joints have
    V2 ground_a = {-1.0f, 1.0f}, ground_b = {1.0f, 1.0f};  ///< world
    float ratio = 1.0f;
    float length = 2.0f;  ///< of a's part and ratio times b's
    struct Impulses {
        float tension = 0.0f;
        void scale(float s) { tension *= s; }
    } impulses;
};

/// A rope from a over two wheels of the world to b.
struct PulleyConstraint {
    using Data = PulleyData;

    /// One side of the rope: from a wheel to a body.
    struct Side {
        V2 start;  ///< from the wheel to the center of mass when the step began
        V2 direction;
        float lever = 0.0f, length = 0.0f;
    };

    JointEnds ends;
    Data::Impulses impulses;
    Side side_a, side_b;
    float ratio = 1.0f, length = 0.0f, mass = 0.0f;

    void prepare(const Data& data, const JointFrame& frame, const JointStep& step,
                 const SolverBody& a, const SolverBody& b);
    void warm_start(SolverBody& a, SolverBody& b) const { pull(a, b, impulses.tension); }
    void solve(SolverBody& a, SolverBody& b, const JointStep& step) { hold<true>(a, b, step); }
    void relax(SolverBody& a, SolverBody& b, const JointStep& step) { hold<false>(a, b, step); }
    V2 push() const { return -(ratio * impulses.tension) * side_b.direction; }
    float twist() const { return 0.0f; }
    void follow(const SolverBody& a, const SolverBody& b);

  private:
    void pull(SolverBody& a, SolverBody& b, float tension) const;
    template <bool biased>
    void hold(SolverBody& a, SolverBody& b, const JointStep& step);
};

}  // namespace fettle::physics::detail
