#pragma once
// A surface that textured triangles are drawn on in pixels: enough for an immediate-mode user
// interface, free of the window library.

#include <cstdint>
#include <span>

namespace fettle::app {

struct SurfaceVertex {
    float x, y;               // pixels from the top left
    float u, v;               // 0 to 1
    std::uint8_t r, g, b, a;  // straight alpha
};

struct ClipRectangle {
    float left, top, width, height;  // pixels
};

class Surface {
  public:
    using Texture = std::uint32_t;  // 0: none, plain color

    virtual ~Surface() = default;
    virtual float width() const = 0;  // pixels
    virtual float height() const = 0;
    /// `rgba`: width * height * 4 bytes, rows from the top.
    virtual Texture create_texture(unsigned width, unsigned height, const std::uint8_t* rgba) = 0;
    virtual void update_texture(Texture texture, unsigned x, unsigned y, unsigned width,
                                unsigned height, const std::uint8_t* rgba) = 0;
    virtual void destroy_texture(Texture texture) = 0;
    virtual void triangles(std::span<const SurfaceVertex> vertices,
                           std::span<const std::uint16_t> indices, Texture texture,
                           const ClipRectangle& clip) = 0;
};

}  // namespace fettle::app
