#include <checks/arguments.h>
#include <fettle/physics/instruction_set.h>
#include <wide/kernels.h>
#include <world/world_data.h>

namespace fettle::physics {

int simd_width() {
    return detail::wide_kernels().width;
}

void World::limit_simd_width(int most) {
    detail::WorldData& data = edit(__func__);
    data.most_lanes = detail::check_simd_width("most", most);
}

}  // namespace fettle::physics
