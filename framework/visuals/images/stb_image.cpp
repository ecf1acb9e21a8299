// Decodes image files with stb_image. Its code is in this source only.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <stdexcept>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_ONLY_BMP
#define STBI_ONLY_TGA
#define STBI_NO_STDIO
#define STBI_FAILURE_USERMSG  // sentences as reasons
#define STBI_MAX_DIMENSIONS 16384
#include <stb/stb_image.h>

#include <images/decoding.h>

namespace fettle::visuals {
namespace {

constexpr std::int64_t most_pixels = 8192 * 8192;

/// Filtering mixes the colors of neighbors, also of those that are transparent and usually black.
/// So transparent pixels get the mean color of their visible neighbors.
void spread_colors(Pixels& image) {
    const int width = static_cast<int>(image.width), height = static_cast<int>(image.height);
    const std::vector<std::uint8_t> before = image.rgba;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const std::size_t at =
                4 * (static_cast<std::size_t>(y) * image.width + static_cast<std::size_t>(x));
            if (before[at + 3] != 0) continue;
            unsigned sum[3] = {0, 0, 0}, count = 0;
            for (int v = std::max(y - 1, 0); v <= std::min(y + 1, height - 1); ++v)
                for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width - 1); ++u) {
                    const std::size_t beside = 4 * (static_cast<std::size_t>(v) * image.width +
                                                    static_cast<std::size_t>(u));
                    if (before[beside + 3] == 0) continue;
                    ++count;
                    for (std::size_t c = 0; c < 3; ++c) sum[c] += before[beside + c];
                }
            for (std::size_t c = 0; c < 3 && count > 0; ++c)
                image.rgba[at + c] = static_cast<std::uint8_t>(sum[c] / count);
        }
}

std::string why_unreadable(std::string_view file) {
    if (file.empty()) return "the file is empty";
    const std::string reason = stbi_failure_reason();
    if (reason.starts_with("Image not of any known type")) return "it is in none of these formats";
    if (reason.find("too large") != std::string::npos) return "it is too large";
    // It also calls a format unsupported if a damaged PNG has a chunk that it does not know.
    const bool unsupported = reason.find("not supported") != std::string::npos &&
                             reason.find("chunk") == std::string::npos;
    return unsupported ? reason : "it is cut off or damaged";
}

}  // namespace

Pixels decode(std::string_view file) {
    int width = 0, height = 0, channels = 0;
    const auto* const bytes = reinterpret_cast<const stbi_uc*>(file.data());
    const int size = static_cast<int>(std::min<std::size_t>(file.size(), 1u << 30));
    if (stbi_info_from_memory(bytes, size, &width, &height, &channels) != 0 &&
        static_cast<std::int64_t>(width) * height > most_pixels)
        throw std::runtime_error("has " + std::to_string(width) + " x " + std::to_string(height) +
                                 " pixels, and an image may have " + std::to_string(most_pixels) +
                                 " (8192 x 8192)");
    const std::unique_ptr<stbi_uc, decltype(&std::free)> read(
        stbi_load_from_memory(bytes, size, &width, &height, &channels, 4), &std::free);
    if (read == nullptr)
        throw std::runtime_error("cannot be read as PNG, JPEG, BMP or TGA: " +
                                 why_unreadable(file));
    Pixels image{static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height), {}};
    image.rgba.assign(read.get(), read.get() + std::size_t{image.width} * image.height * 4);
    spread_colors(image);
    return image;
}

void Pixels::clear(property::Color color) {
    const auto byte = [](float share) {
        return static_cast<std::uint8_t>(std::lround(255 * share));
    };
    const std::array<std::uint8_t, 3> wanted{byte(color.r), byte(color.g), byte(color.b)};
    for (std::size_t i = 0; i + 3 < rgba.size(); i += 4)
        if (std::equal(wanted.begin(), wanted.end(), rgba.begin() + static_cast<std::ptrdiff_t>(i)))
            std::fill_n(rgba.begin() + static_cast<std::ptrdiff_t>(i), 4, std::uint8_t{0});
}

Pixels checkerboard() {
    constexpr std::uint32_t side = 32, square = 8;
    Pixels image{side, side, {}};
    for (std::uint32_t y = 0; y < side; ++y)
        for (std::uint32_t x = 0; x < side; ++x) {
            const std::uint8_t light = (x / square + y / square) % 2 == 0 ? 255 : 40;
            image.rgba.insert(image.rgba.end(), {light, 0, light, 255});
        }
    return image;
}

}  // namespace fettle::visuals
