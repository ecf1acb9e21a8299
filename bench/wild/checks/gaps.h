#pragma once
// How far joints are from what they hold, computed from the poses of their bodies.

#include <optional>

#include "wild/plans/running_world.h"

namespace fettle::bench::wild {

struct Gap {
    float length = 0;  // m
    float angle = 0;   // rad
};

/// How far a joint is from what it holds rigidly: springs and motors may give way, so they have no
/// gap. None if one of its bodies does not exist.
std::optional<Gap> gap_of(const JointPlan& joint, const std::vector<BodyNow>& bodies);

/// The places of both anchors.
struct Anchors {
    Vec2 a = {}, b = {};
};
Anchors anchors_of(const JointPlan& joint, const std::vector<BodyNow>& bodies);

}  // namespace fettle::bench::wild
