// The kernels for every machine of this architecture: four lanes at a time.
#define FETTLE_LANES 4

#include <wide/kernels_here.h>

namespace fettle::physics::detail {

const WideKernels wide_kernels_baseline = kernels_here;

}  // namespace fettle::physics::detail
