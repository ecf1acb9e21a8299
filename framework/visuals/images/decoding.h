#pragma once
// Pixels of image files.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <fettle/property/value.h>

namespace fettle::visuals {

struct Pixels {
    std::uint32_t width = 0, height = 0;
    std::vector<std::uint8_t> rgba{};

    /// Makes the pixels of a color transparent.
    void clear(property::Color color);
};

/// Decodes a PNG, JPEG, BMP or TGA file. Throws std::runtime_error with the reason.
Pixels decode(std::string_view file);
/// The picture that is shown in place of a missing or unreadable one.
Pixels checkerboard();

}  // namespace fettle::visuals
