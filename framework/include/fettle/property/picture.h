#pragma once
// Pixels that a painter can draw.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <fettle/property/export.h>
#include <fettle/property/value.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// An image in memory. Painters keep a copy, which they recognize by address and version.
class Picture {
  public:
    Picture() = default;
    /// `rgba`: rows from the top, four bytes a pixel. Missing bytes are 0; surplus ones are
    /// ignored.
    Picture(std::uint32_t width, std::uint32_t height, std::vector<std::uint8_t> rgba)
        : width_(width), height_(height), rgba_(std::move(rgba)) {
        rgba_.resize(std::size_t{width} * height * 4);
    }
    Picture(const Picture&) = delete;
    Picture& operator=(const Picture&) = delete;

    /// A picture of this kind, such as a glyph, is moved to whole pixels where it is drawn upright
    /// and in its own size, so that it is sharp.
    void keep_on_pixels() { on_pixels_ = true; }
    bool on_pixels() const { return on_pixels_; }
    std::uint32_t width() const { return width_; }
    std::uint32_t height() const { return height_; }
    const std::vector<std::uint8_t>& rgba() const { return rgba_; }
    /// Never the same for two pictures of a program, nor for one before and after a change.
    std::uint64_t version() const { return version_; }
    void replace(std::uint32_t width, std::uint32_t height, std::vector<std::uint8_t> rgba) {
        rgba.resize(std::size_t{width} * height * 4);
        width_ = width;
        height_ = height;
        rgba_ = std::move(rgba);
        version_ = next();
    }

  private:
    static std::uint64_t next() {
        static std::atomic<std::uint64_t> last{0};
        return ++last;
    }

    std::uint32_t width_ = 0, height_ = 0;
    std::vector<std::uint8_t> rgba_;
    std::uint64_t version_ = next();
    bool on_pixels_ = false;
};

/// A rectangle of pixels of a picture, from its top left corner.
struct PictureArea {
    double left = 0, top = 0, width = 0, height = 0;
};

/// How a color is combined with the picture below it: `normal` covers it, `add` makes it lighter,
/// `multiply` makes it darker.
enum class Blend : std::uint8_t { normal, add, multiply };

}  // namespace fettle::property

FETTLE_PROPERTY_END
