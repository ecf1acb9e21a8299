// The kernels for AVX-512: sixteen lanes at a time. Compiled for that instruction set; no code of
// this file may run before `wide_kernels` has detected it on the machine.
#if defined(__x86_64__)
#define FETTLE_LANES 16

#include <wide/kernels_here.h>

namespace fettle::physics::detail {

const WideKernels wide_kernels_avx512 = kernels_here;

}  // namespace fettle::physics::detail
#endif
