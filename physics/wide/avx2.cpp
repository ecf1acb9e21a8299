// The kernels for AVX2: eight lanes at a time. Only this file is compiled for AVX2, and it is
// called only if the machine has AVX2.
#if defined(__x86_64__)
#define FETTLE_LANES 8

#include <wide/kernels_here.h>

namespace fettle::physics::detail {

const WideKernels wide_kernels_avx2 = kernels_here;

}  // namespace fettle::physics::detail
#endif
