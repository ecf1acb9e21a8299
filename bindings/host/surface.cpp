#include "surface.h"

#include <algorithm>

namespace fettle::host {

void TriangleSurface::begin(float width, float height) {
    width_ = width;
    height_ = height;
    vertices_.clear();
    indices_.clear();
    commands_.clear();
}

app::Surface::Texture TriangleSurface::create_texture(unsigned width, unsigned height,
                                                      const std::uint8_t* rgba) {
    const std::size_t bytes = std::size_t{4} * width * height;
    textures_.push_back({++last_, width, height, ++version_, {rgba, rgba + bytes}});
    return last_;
}

void TriangleSurface::update_texture(Texture texture, unsigned x, unsigned y, unsigned width,
                                     unsigned height, const std::uint8_t* rgba) {
    const auto found = std::ranges::find(textures_, texture, &Pixels::id);
    if (found == textures_.end()) return;
    for (unsigned row = 0; row < height; ++row)
        std::copy_n(
            rgba + std::size_t{4} * row * width, std::size_t{4} * width,
            found->rgba.begin() + static_cast<std::ptrdiff_t>(
                                      4 * (std::size_t{y + row} * found->width + std::size_t{x})));
    found->version = ++version_;
}

void TriangleSurface::destroy_texture(Texture texture) {
    std::erase_if(textures_, [&](const Pixels& each) { return each.id == texture; });
}

void TriangleSurface::triangles(std::span<const app::SurfaceVertex> vertices,
                                std::span<const std::uint16_t> indices, Texture texture,
                                const app::ClipRectangle& clip) {
    const auto first = static_cast<std::uint32_t>(vertices_.size());
    for (const app::SurfaceVertex& v : vertices)
        vertices_.push_back({v.x, v.y, v.u, v.v, v.r, v.g, v.b, v.a});
    commands_.push_back({texture,
                         static_cast<std::uint32_t>(indices_.size()),
                         static_cast<std::uint32_t>(indices.size()),
                         {clip.left, clip.top, clip.width, clip.height}});
    for (const std::uint16_t index : indices) indices_.push_back(first + index);
}

/// The console makes a new texture for each size of its font, and does not always destroy the old
/// one.
void TriangleSurface::drop_unused() {
    constexpr std::size_t kept = 8;
    for (std::size_t i = 0; i < textures_.size() && textures_.size() > kept;) {
        const bool used = std::ranges::find(commands_, textures_[i].id,
                                            &fettle_console_command::texture) != commands_.end();
        if (used)
            ++i;
        else
            textures_.erase(textures_.begin() + static_cast<std::ptrdiff_t>(i));
    }
}

fettle_console_picture TriangleSurface::picture() {
    drop_unused();
    returned_textures_.clear();
    for (const Pixels& each : textures_)
        returned_textures_.push_back(
            {each.id, each.width, each.height, each.version, each.rgba.data()});
    return {vertices_.data(),
            indices_.data(),
            commands_.data(),
            returned_textures_.data(),
            static_cast<std::uint32_t>(vertices_.size()),
            static_cast<std::uint32_t>(indices_.size()),
            static_cast<std::uint32_t>(commands_.size()),
            static_cast<std::uint32_t>(returned_textures_.size())};
}

}  // namespace fettle::host
