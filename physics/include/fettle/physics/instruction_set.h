#pragma once

#include <fettle/physics/export.h>

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

/// How many 32-bit numbers the solver computes at a time on this machine: 16 with AVX-512, 8 with
/// AVX2, else 4. The results are the same bits with each width.
int simd_width();

}  // namespace fettle::physics

FETTLE_PHYSICS_END
