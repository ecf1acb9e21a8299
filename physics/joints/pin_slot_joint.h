#pragma once

#include <joints/rail.h>

namespace fettle::physics::detail {

struct PinSlotData {
    uint32_t joint = 0;  ///< record of what all joints have
    RailSettings rail;
    struct Impulses {
        RailImpulses rail;
        void scale(float s) { rail.scale(s); }
    } impulses;
};

/// What has an end at both sides: the groove is a slot from one point to another.
struct GrooveData {
    uint32_t joint = 0;
    V2 end = {1.0f, 0.0f};  ///< in the coordinates of body a; it begins at the anchor there
    PinSlotData::Impulses impulses;
};

/// A pin of b in a straight slot of a: slides and turns.
struct PinSlotConstraint {
    using Data = PinSlotData;

    JointEnds ends;
    Data::Impulses impulses;
    Rail rail;

    void prepare(const Data& data, const JointFrame& frame, const JointStep& step,
                 const SolverBody& a, const SolverBody& b);
    void warm_start(SolverBody& a, SolverBody& b) const;
    void solve(SolverBody& a, SolverBody& b, const JointStep& step);
    void relax(SolverBody& a, SolverBody& b, const JointStep& step);
    V2 push() const { return rail.force(impulses.rail); }
    float twist() const { return 0.0f; }
};

struct GrooveConstraint : PinSlotConstraint {
    using Data = GrooveData;
    void prepare(const Data& data, const JointFrame& frame, const JointStep& step,
                 const SolverBody& a, const SolverBody& b);
};

}  // namespace fettle::physics::detail
