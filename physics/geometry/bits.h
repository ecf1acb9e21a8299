#pragma once

#include <cstdint>
#include <cstring>

namespace fettle::physics::detail {

/// The bits of a number. Some of the standard libraries that Fettle is built with have no
/// std::bit_cast.
inline uint32_t bits_of(float number) {
    uint32_t bits;
    std::memcpy(&bits, &number, sizeof bits);
    return bits;
}

}  // namespace fettle::physics::detail
