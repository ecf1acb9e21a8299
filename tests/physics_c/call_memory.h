#pragma once

#include <fettle_physics.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace random_arguments {

/// The memory that the pointers of a call point to. A call inside a callback must not write to that
/// of the outer call.
struct CallMemory {
    fettle_world* world = nullptr;  // made by the call
    fettle_owner* owner = nullptr;
    fettle_replay* replay = nullptr;
    fettle_segment_surface surfaces[16] = {};
    fettle_mover_plane planes[16] = {};
    fettle_vec2 points[16] = {};
    float numbers[16] = {};
    fettle_line_point line_points[16] = {};
    fettle_id ids[16] = {};
    fettle_world* worlds[16] = {};
    alignas(16) std::byte inputs[4][512] = {};
    uint32_t next = 0;
    /// All other results.
    std::vector<std::byte> scratch = std::vector<std::byte>(1 << 16);

    /// Results as they are now; of a long list only the beginning.
    struct Results {
        std::array<std::byte, 1024> begin;
        std::array<const void*, 3> made;
        friend bool operator==(const Results&, const Results&) = default;
    };
    Results results() const {
        Results now = {{}, {world, owner, replay}};
        std::copy_n(scratch.begin(), now.begin.size(), now.begin.begin());
        return now;
    }
};

}  // namespace random_arguments
