#include <fettle/physics/instruction_set.h>

#include <string_view>

#include <solver/wide_contact.h>

namespace fettle::physics {

int simd_width() {
    return std::string_view(detail::wide_kernels(false).name) == "avx2" ? 8 : 4;
}

}  // namespace fettle::physics
