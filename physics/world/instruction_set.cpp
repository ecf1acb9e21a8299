#include <fettle/physics/instruction_set.h>
#include <wide/kernels.h>

namespace fettle::physics {

int simd_width() {
    return detail::wide_kernels().width;
}

}  // namespace fettle::physics
