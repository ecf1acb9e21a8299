// The solver's passes eight lanes at a time. This file alone is compiled for AVX2 and is only
// called where there is AVX2.
#if defined(__x86_64__)
#define FETTLE_LANES 8

#include <broad_phase/wide_overlap.h>
#include <collision/wide_collide.h>
#include <solver/wide_passes.h>
#include <solver/wide_prepare.h>
#include <wide/kernels.h>

namespace fettle::physics::detail {

const WideKernels wide_kernels_avx2 = {prepare_contacts, store_contacts, warm_start,
                                       solve_biased,     relax,          collide_batch,
                                       find_overlaps,    width};

}  // namespace fettle::physics::detail
#endif
