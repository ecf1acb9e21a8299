#pragma once

#include <broad_phase/bucket.h>
#include <collision/batch.h>
#include <constraints/wide_contact.h>

namespace fettle::physics::detail {

/// What is computed on many lanes at a time, for one instruction set. The passes of the solver are
/// those of `ContactSolver`, operation by operation, so the result depends neither on the width nor
/// on the machine.
struct WideKernels {
    /// Of contacts whose bodies and friction are set.
    void (*prepare)(const PrepareStep&, std::span<const ContactLanes>, WideContact*);
    /// `near`: distance that counts as touching, m.
    void (*store)(const WideContact*, std::span<ContactLanes>, float near);
    void (*warm_start)(const WideStep&);
    void (*solve_biased)(const WideStep&);
    void (*relax)(const WideStep&);
    /// Returns the pairs that `collide` has to do, a bit each.
    uint32_t (*collide)(const ConvexArrays&, const CollisionBatch&);
    FindOverlaps overlaps;
    int width;  ///< lanes at a time
};

extern const WideKernels wide_kernels_baseline;
#if defined(__x86_64__)
extern const WideKernels wide_kernels_avx2;
extern const WideKernels wide_kernels_avx512;
#endif

/// The widest that this machine has, of at most so many lanes (tests compare them).
const WideKernels& wide_kernels(int most = lanes);

}  // namespace fettle::physics::detail
