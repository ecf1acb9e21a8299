#pragma once

#include <broad_phase/bucket.h>
#include <collision/batch.h>
#include <constraints/wide_contact.h>

namespace fettle::physics::detail {

/// Functions that compute many lanes at a time, for one instruction set. The passes of the solver
/// do exactly the same operations as `ContactSolver`, so the result depends neither on the width
/// nor on the machine.
struct WideKernels {
    /// Prepares contacts; their bodies and friction must be set.
    void (*prepare)(const PrepareStep&, std::span<const ContactLanes>, WideContact*);
    /// `near`: distance that counts as touching, m.
    void (*store)(const WideContact*, std::span<ContactLanes>, float near);
    void (*warm_start)(const WideStep&);
    void (*solve_biased)(const WideStep&);
    void (*relax)(const WideStep&);
    /// Returns the pairs that `collide` has to process, one bit each.
    uint32_t (*collide)(const ConvexArrays&, const CollisionBatch&);
    FindOverlaps overlaps;
    int width;  ///< lanes at a time
};

extern const WideKernels wide_kernels_baseline;
#if defined(__x86_64__)
extern const WideKernels wide_kernels_avx2;
extern const WideKernels wide_kernels_avx512;
#endif

/// The widest kernels of this machine with at most `most` lanes (tests compare them).
const WideKernels& wide_kernels(int most = group_size);

}  // namespace fettle::physics::detail
