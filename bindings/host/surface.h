#pragma once

#include <fettle/app/surface.h>
#include <fettle_host.h>

#include <vector>

namespace fettle::host {

/// Collects the triangles of a layer, and keeps its textures.
class TriangleSurface : public app::Surface {
  public:
    void begin(float width, float height);
    /// The triangles that were drawn since `begin`.
    fettle_console_picture picture();

    float width() const override { return width_; }
    float height() const override { return height_; }
    Texture create_texture(unsigned width, unsigned height, const std::uint8_t* rgba) override;
    void update_texture(Texture texture, unsigned x, unsigned y, unsigned width, unsigned height,
                        const std::uint8_t* rgba) override;
    void destroy_texture(Texture texture) override;
    void triangles(std::span<const app::SurfaceVertex> vertices,
                   std::span<const std::uint16_t> indices, Texture texture,
                   const app::ClipRectangle& clip) override;

  private:
    struct Pixels {
        Texture id = 0;
        unsigned width = 0, height = 0;
        std::uint32_t version = 0;
        std::vector<std::uint8_t> rgba{};
    };
    void drop_unused();

    float width_ = 1, height_ = 1;
    std::vector<fettle_console_vertex> vertices_;
    std::vector<std::uint32_t> indices_;
    std::vector<fettle_console_command> commands_;
    std::vector<Pixels> textures_;
    std::vector<fettle_console_texture> returned_textures_;
    Texture last_ = 0;
    std::uint32_t version_ = 0;
};

}  // namespace fettle::host
