#pragma once

#include <fettle/physics/export.h>

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

/// Number of 32-bit values that the solver computes at a time on this machine: 16 with AVX-512, 8
/// with AVX2, otherwise 4. Results are equal bit for bit for all widths.
int simd_width();

}  // namespace fettle::physics

FETTLE_PHYSICS_END
