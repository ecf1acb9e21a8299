#pragma once
// All kernels for the lanes and the instruction set that the including file is compiled for.

#include <broad_phase/wide_overlap.h>
#include <collision/wide_collide.h>
#include <constraints/wide_prepare.h>
#include <constraints/wide_solver.h>
#include <wide/kernels.h>

namespace fettle::physics::detail {

static constexpr WideKernels kernels_here = {prepare_contacts, store_contacts, warm_start,
                                             solve_biased,     relax,          collide_batch,
                                             find_overlaps,    width};

}  // namespace fettle::physics::detail
