#pragma once
// Draws many small parts of a texture on the processor. A renderer of OpenGL in software takes
// about 0.8 microseconds for a quad however small it is, and this takes a tenth of that.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <draw/canvas_vertex.h>

namespace fettle::app {

/// The pixels of a texture in memory: rows from the top, four bytes each, not multiplied by their
/// opacity. At least two by two.
struct TexelRows {
    const std::uint8_t* rgba = nullptr;
    int width = 0, height = 0;
    bool smooth = false;  // texels are mixed, as OpenGL does it
    int gap = 0;          // unused texels between a row and the next
    std::ptrdiff_t row_length() const { return 4 * static_cast<std::ptrdiff_t>(width + gap); }
};

/// A rectangle of pixels of the target; `right` and `bottom` are the first ones beyond it.
struct PixelBox {
    int left = 0, top = 0, right = 0, bottom = 0;
    int width() const { return right - left; }
    int height() const { return bottom - top; }
};

class QuadRaster {
  public:
    /// Finds the pixels within `clip` that the quads reach. `corners`: four for each quad, top
    /// left, top right, bottom right, bottom left of a parallelogram.
    void measure(std::span<const CanvasVertex> corners, const PixelBox& clip);
    /// What `measure` has found.
    const PixelBox& box() const { return box_; }
    /// Whether a renderer of OpenGL in software would need more time for them.
    bool is_faster() const;
    /// Draws the quads that were measured over a transparent picture of the box. `adds`: colors are
    /// added; otherwise a quad covers those before it.
    void draw(std::span<const CanvasVertex> corners, const TexelRows& texels, bool adds);
    /// The picture: colors are multiplied by their opacity.
    const std::uint8_t* rgba() const { return pixels_.data(); }

  private:
    /// Where a pixel of a column is in the texture.
    struct Column {
        int offset = 0;  // bytes from the beginning of a row
        std::int16_t weight = 0;
    };
    /// Where a pixel of a row is in the texture, and how much of the texels to its right and below
    /// it has.
    struct Spot {
        int offset = 0;  // bytes
        std::int16_t across = 0, down = 0;
    };
    template <bool adds>
    void draw_all(std::span<const CanvasVertex> corners);
    template <bool adds>
    void draw_upright(const CanvasVertex* corners);
    template <bool adds>
    void draw_turned(const CanvasVertex* corners);

    PixelBox box_{};
    std::size_t count_ = 0;  // quads
    double area_ = 0;        // pixels of all boxes around a quad
    TexelRows texels_{};
    std::vector<std::uint8_t> pixels_{};
    std::vector<Column> columns_{};
    std::vector<Spot> spots_{};
};

}  // namespace fettle::app
