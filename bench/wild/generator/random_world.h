#pragma once
// Worlds as games make them, drawn from a seed: shapes, surfaces, supports, motions, joints, edits
// and lengths of steps in every combination.

#include <cstdint>

#include "wild/plans/plan.h"

namespace fettle::bench::wild {

/// Equal seeds give equal plans. `size`: 1 is the usual world of up to some fifty bodies and some
/// seconds; 0 is a smaller and shorter one, for quick tests.
WorldPlan random_world(std::uint64_t seed, int size = 1);

}  // namespace fettle::bench::wild
