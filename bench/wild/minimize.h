#pragma once
// Makes a failing plan smaller while it still fails in the same way.

#include <functional>

#include "wild/plans/plan.h"

namespace fettle::bench::wild {

/// Whether a plan still fails.
using Fails = std::function<bool(const WorldPlan&)>;

/// Removes bodies, joints, fields, edits, shapes and steps, and then simplifies the rest: its
/// settings, sizes and numbers.
WorldPlan minimized(WorldPlan plan, const Fails& fails);

}  // namespace fettle::bench::wild
