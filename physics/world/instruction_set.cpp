#include <fettle/physics/instruction_set.h>
#include <wide/kernels.h>
#include <world/world_data.h>

namespace fettle::physics {

int simd_width() {
    return detail::wide_kernels().width;
}

void World::limit_simd_width(int most) {
    edit(__func__).most_lanes = most;
}

}  // namespace fettle::physics
