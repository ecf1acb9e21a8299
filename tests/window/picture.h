#pragma once
// The picture of a virtual display, read from the file in which Xvfb stores it, and saved as PNG.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace fettle::test {

struct Picture {
    unsigned width = 0, height = 0;
    std::vector<std::uint8_t> rgb;  // rows from the top

    /// Number of pixels that differ within a part of the picture.
    std::size_t difference(const Picture& other, unsigned left, unsigned top, unsigned right,
                           unsigned bottom) const;
    std::size_t difference(const Picture& other) const {
        return difference(other, 0, 0, width, height);
    }
    void save_png(const std::filesystem::path& file) const;
};

/// Throws std::runtime_error if the file is not an X window dump with 32 bits per pixel.
Picture read_xwd(const std::filesystem::path& file);

}  // namespace fettle::test
