#pragma once
// A plan that fails is made smaller while it still fails in the same way.

#include <functional>

#include "wild/plan.h"

namespace fettle::bench::wild {

/// Whether a plan still fails.
using Fails = std::function<bool(const WorldPlan&)>;

/// Removes bodies, joints, fields, edits, shapes and steps, and then simplifies what is left: its
/// settings, sizes and numbers. `tries` limits the number of calls of `fails`.
WorldPlan minimized(WorldPlan plan, const Fails& fails, int tries = 600);

}  // namespace fettle::bench::wild
