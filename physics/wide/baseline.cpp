// The solver's passes for what every machine of this architecture has: four lanes at a time.
#define FETTLE_LANES 4

#include <broad_phase/wide_overlap.h>
#include <collision/wide_collide.h>
#include <solver/wide_passes.h>
#include <solver/wide_prepare.h>
#include <wide/kernels.h>

namespace fettle::physics::detail {

const WideKernels wide_kernels_baseline = {prepare_contacts, store_contacts, warm_start,
                                           solve_biased,     relax,          collide_batch,
                                           find_overlaps,    width};

const WideKernels& wide_kernels(int most) {
#if defined(__x86_64__)
    static const bool has_avx512 =
        __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
        __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("fma");
    static const bool has_avx2 = __builtin_cpu_supports("avx2");
    if (has_avx512 && most >= 16) return wide_kernels_avx512;
    if (has_avx2 && most >= 8) return wide_kernels_avx2;
#endif
    (void)most;
    return wide_kernels_baseline;
}

}  // namespace fettle::physics::detail
