#pragma once
// By how much joints fail to hold their bodies together, computed from the poses of the bodies.

#include <optional>

#include "wild/plans/running_world.h"

namespace fettle::bench::wild {

struct Gap {
    float length = 0;  // m
    float angle = 0;   // rad
};

/// The error of the rigid parts of a joint. Springs and motors may give way, so they have no gap.
/// nullopt if one of the bodies does not exist.
std::optional<Gap> gap_of(const JointPlan& joint, const std::vector<BodyNow>& bodies);

/// The places of both anchors.
struct Anchors {
    Vec2 a = {}, b = {};
};
Anchors anchors_of(const JointPlan& joint, const std::vector<BodyNow>& bodies);

}  // namespace fettle::bench::wild
