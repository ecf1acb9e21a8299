#pragma once
// The input bytes of a fuzzer as text.

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace fettle::fuzz {

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

}  // namespace fettle::fuzz
