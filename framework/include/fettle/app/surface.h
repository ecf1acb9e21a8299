#pragma once
// A surface for textured triangles in pixels: enough for an immediate-mode user interface,
// independent of the window library.

#include <cstdint>
#include <span>
#include <string_view>

#include <fettle/app/export.h>

FETTLE_APP_BEGIN

namespace fettle::app {

/// A corner of a triangle.
struct SurfaceVertex {
    float x, y;               // pixels from the top left
    float u, v;               // 0 to 1
    std::uint8_t r, g, b, a;  // straight alpha
};

/// Red, green, blue and opacity, 0 to 255.
struct SurfaceColor {
    std::uint8_t r = 255, g = 255, b = 255, a = 255;  ///< white
};

/// The font of a text.
enum class Face : std::uint8_t { plain, bold, monospace };

/// A rectangle outside of which nothing is drawn.
struct ClipRectangle {
    float left, top, width, height;  // pixels
};

/// The functions that a window must have to draw the console and other layers.
class Surface {
  public:
    using Texture = std::uint32_t;  // 0: no texture, plain color

    virtual ~Surface() = default;
    virtual float width() const = 0;   // pixels
    virtual float height() const = 0;  ///< pixels
    /// `rgba`: width * height * 4 bytes, rows from the top.
    virtual Texture create_texture(unsigned width, unsigned height, const std::uint8_t* rgba) = 0;
    /// Replaces a part of a texture.
    virtual void update_texture(Texture texture, unsigned x, unsigned y, unsigned width,
                                unsigned height, const std::uint8_t* rgba) = 0;
    /// The texture is used no more.
    virtual void destroy_texture(Texture texture) = 0;
    /// Draws triangles: three indices of vertices each.
    virtual void triangles(std::span<const SurfaceVertex> vertices,
                           std::span<const std::uint16_t> indices, Texture texture,
                           const ClipRectangle& clip) = 0;

    /// Draws one line of UTF-8 text, its top left corner at x, y, in a font `size` pixels high.
    /// Returns its width in pixels; with `color.a` 0 the text is only measured. A surface without a
    /// font draws nothing and returns 0.
    virtual float text(float x, float y, std::string_view line, float size, SurfaceColor color,
                       Face face) {
        (void)x, (void)y, (void)line, (void)size, (void)color, (void)face;
        return 0;
    }
};

}  // namespace fettle::app

FETTLE_APP_END
