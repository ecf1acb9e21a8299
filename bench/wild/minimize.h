#pragma once
// A plan that fails is made smaller while it still fails in the same way.

#include <functional>

#include "wild/plans/plan.h"

namespace fettle::bench::wild {

/// Whether a plan still fails.
using Fails = std::function<bool(const WorldPlan&)>;

/// Removes bodies, joints, fields, edits, shapes and steps, and then simplifies what is left: its
/// settings, sizes and numbers. `work`: it stops after this many steps, each counted once for each
/// body, in all calls of `fails` together.
WorldPlan minimized(WorldPlan plan, const Fails& fails, long long work = 4'000'000);

}  // namespace fettle::bench::wild
