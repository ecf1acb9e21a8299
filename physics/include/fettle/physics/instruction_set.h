#pragma once

#include <fettle/physics/export.h>

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

/// How many numbers of 32 bits the solver computes with at a time on this machine: 16 with
/// AVX-512, 8 with AVX2, else 4. Results are the same bits either way.
int simd_width();

}  // namespace fettle::physics

FETTLE_PHYSICS_END
