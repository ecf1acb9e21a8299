#pragma once
// A surface that draws in memory, so that pictures of the console can be viewed and compared
// without a window.

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <vector>

#include <fettle/app/surface.h>

namespace fettle::console::test {

using Pixel = std::array<std::uint8_t, 3>;

/// The pixel of an opaque color of the palette.
inline Pixel pixel_of(std::uint32_t color) {
    return {static_cast<std::uint8_t>(color), static_cast<std::uint8_t>(color >> 8),
            static_cast<std::uint8_t>(color >> 16)};
}

class RasterSurface : public app::Surface {
  public:
    RasterSurface(unsigned width, unsigned height, Pixel background = {52, 64, 82});

    float width() const override { return static_cast<float>(width_); }
    float height() const override { return static_cast<float>(height_); }
    Texture create_texture(unsigned width, unsigned height, const std::uint8_t* rgba) override;
    void update_texture(Texture texture, unsigned x, unsigned y, unsigned width, unsigned height,
                        const std::uint8_t* rgba) override;
    void destroy_texture(Texture texture) override { textures_.erase(texture); }
    void triangles(std::span<const app::SurfaceVertex> vertices,
                   std::span<const std::uint16_t> indices, Texture texture,
                   const app::ClipRectangle& clip) override;

    void clear();
    /// As a window does: its textures stay.
    void resize(unsigned width, unsigned height);
    /// Drawn at the first call: most tests do not read the pixels.
    const std::vector<Pixel>& pixels() const;
    std::size_t triangle_count() const { return triangle_count_; }
    std::size_t textures() const { return textures_.size(); }
    /// Number of triangles with an index or a texture that does not exist.
    std::size_t faults() const { return faults_; }
    /// Writes binary PPM.
    void save(const std::filesystem::path& file) const;

  private:
    struct Image {
        unsigned width, height;
        std::vector<std::uint8_t> rgba;
    };
    struct Call {
        std::vector<app::SurfaceVertex> corners;  // three for each triangle
        Texture texture;
        app::ClipRectangle clip;
    };
    void fill(const app::SurfaceVertex* corners, const Image* image,
              const app::ClipRectangle& clip) const;

    unsigned width_, height_;
    Pixel background_;
    std::vector<Call> calls_;
    mutable std::size_t painted_ = 0;  // number of calls that are drawn
    mutable std::vector<Pixel> pixels_;
    std::map<Texture, Image> textures_;
    Texture next_ = 1;
    std::size_t triangle_count_ = 0;
    std::size_t faults_ = 0;
};

}  // namespace fettle::console::test
