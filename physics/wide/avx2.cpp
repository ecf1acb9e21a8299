// The solver's passes eight lanes at a time. This file alone is compiled for AVX2 and is only
// called where there is AVX2.
#if defined(__x86_64__)
#define FETTLE_LANES 8

#include <wide/kernels_here.h>

namespace fettle::physics::detail {

const WideKernels wide_kernels_avx2 = kernels_here;

}  // namespace fettle::physics::detail
#endif
