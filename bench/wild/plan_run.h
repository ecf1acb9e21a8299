#pragma once
// Runs a plan once and finds all invariants that it violates.

#include <vector>

#include "wild/checks/check.h"

namespace fettle::bench::wild {

using MakeWorld = std::function<std::unique_ptr<RunningWorld>(const WorldPlan&)>;

struct PlanRun {
    std::vector<Finding> findings;  // at most one for each invariant
    long long steps = 0;
    double awake = 0;  // the time until the last body fell asleep, s
};

/// Exceptions are findings of the invariant `throws`. The run ends early if all invariants are
/// violated. Throws nothing.
PlanRun try_plan(const WorldPlan& plan, const MakeWorld& make, std::span<const Invariant> watched);

/// The invariants with these names; all if there are no names. The names `same` and `throws` are
/// valid although no table contains them. Throws std::invalid_argument for any other name.
std::vector<Invariant> invariants_named(const std::vector<std::string>& names);

}  // namespace fettle::bench::wild
