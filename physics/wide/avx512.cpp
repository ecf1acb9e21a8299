// The solver's passes for machines with AVX-512: sixteen lanes at a time. Compiled for that
// instruction set; nothing here may run before `wide_kernels` has seen that the machine has it.
#if defined(__x86_64__)
#define FETTLE_LANES 16

#include <broad_phase/wide_overlap.h>
#include <collision/wide_collide.h>
#include <solver/wide_passes.h>
#include <solver/wide_prepare.h>
#include <wide/kernels.h>

namespace fettle::physics::detail {

const WideKernels wide_kernels_avx512 = {prepare_contacts, store_contacts, warm_start,
                                         solve_biased,     relax,          collide_batch,
                                         find_overlaps,    width};

}  // namespace fettle::physics::detail
#endif
