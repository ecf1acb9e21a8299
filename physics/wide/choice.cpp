// The choice of the kernels for this machine.

#include <wide/kernels.h>

namespace fettle::physics::detail {

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
