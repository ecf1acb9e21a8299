// The solver's passes for what every machine of this architecture has: four lanes at a time.
#define FETTLE_LANES 4

#include <solver/wide_passes.h>

namespace fettle::physics::detail {

const WideKernels wide_kernels_baseline = {warm_start, solve_biased, relax, "baseline"};

const WideKernels& wide_kernels(bool baseline_only) {
#if defined(__x86_64__)
    static const bool has_avx2 = __builtin_cpu_supports("avx2");
    if (has_avx2 && !baseline_only) return wide_kernels_avx2;
#endif
    (void)baseline_only;
    return wide_kernels_baseline;
}

}  // namespace fettle::physics::detail
