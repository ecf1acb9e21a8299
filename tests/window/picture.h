#pragma once
// What a virtual display shows, read from the file in which Xvfb keeps it, and kept as PNG.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace fettle::test {

struct Picture {
    unsigned width = 0, height = 0;
    std::vector<std::uint8_t> rgb;  // rows from the top

    /// Pixels that differ within a part of the picture.
    std::size_t difference(const Picture& other, unsigned left, unsigned top, unsigned right,
                           unsigned bottom) const;
    std::size_t difference(const Picture& other) const {
        return difference(other, 0, 0, width, height);
    }
    void save_png(const std::filesystem::path& file) const;
};

/// Throws std::runtime_error when the file is no X window dump with 32 bits a pixel.
Picture read_xwd(const std::filesystem::path& file);

}  // namespace fettle::test
