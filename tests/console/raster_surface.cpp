#include "raster_surface.h"

#include <algorithm>
#include <cmath>
#include <fstream>

namespace fettle::console::test {

using app::SurfaceVertex;

RasterSurface::RasterSurface(unsigned width, unsigned height, Pixel background)
    : width_(width), height_(height), background_(background) {
    clear();
}

void RasterSurface::clear() {
    // Most frames are never painted.
    if (pixels_.empty() || painted_ > 0) pixels_.assign(std::size_t{width_} * height_, background_);
    calls_.clear();
    triangle_count_ = 0;
    painted_ = 0;
}

void RasterSurface::resize(unsigned width, unsigned height) {
    width_ = width;
    height_ = height;
    pixels_.clear();
    clear();
}

const std::vector<Pixel>& RasterSurface::pixels() const {
    for (; painted_ < calls_.size(); ++painted_) {
        const Call& call = calls_[painted_];
        auto found = textures_.find(call.texture);
        const Image* image = found == textures_.end() ? nullptr : &found->second;
        for (std::size_t i = 0; i + 2 < call.corners.size(); i += 3)
            fill(&call.corners[i], image, call.clip);
    }
    return pixels_;
}

app::Surface::Texture RasterSurface::create_texture(unsigned width, unsigned height,
                                                    const std::uint8_t* rgba) {
    std::size_t bytes = std::size_t{width} * height * 4;
    textures_[next_] = {width, height, std::vector<std::uint8_t>(rgba, rgba + bytes)};
    return next_++;
}

void RasterSurface::update_texture(Texture texture, unsigned x, unsigned y, unsigned width,
                                   unsigned height, const std::uint8_t* rgba) {
    Image& image = textures_.at(texture);
    for (unsigned row = 0; row < height; ++row)
        std::copy_n(rgba + std::size_t{row} * width * 4, std::size_t{width} * 4,
                    image.rgba.begin() + (std::ptrdiff_t{y + row} * image.width + x) * 4);
}

void RasterSurface::triangles(std::span<const SurfaceVertex> vertices,
                              std::span<const std::uint16_t> indices, Texture texture,
                              const app::ClipRectangle& clip) {
    if (texture != 0 && !textures_.contains(texture)) ++faults_;
    Call call{{}, texture, clip};
    triangle_count_ += indices.size() / 3;
    for (std::uint16_t index : indices) {
        if (index >= vertices.size())
            ++faults_;
        else
            call.corners.push_back(vertices[index]);
    }
    calls_.push_back(std::move(call));
}

namespace {

/// Twice the signed area of the triangle a, b, p.
float edge(const SurfaceVertex& a, const SurfaceVertex& b, float x, float y) {
    return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x);
}

}  // namespace

void RasterSurface::fill(const SurfaceVertex* corners, const Image* image,
                         const app::ClipRectangle& clip) const {
    const SurfaceVertex &a = corners[0], &b = corners[1], &c = corners[2];
    float area = edge(a, b, c.x, c.y);
    if (area == 0) return;
    float left = std::max({clip.left, std::min({a.x, b.x, c.x}), 0.0f});
    float top = std::max({clip.top, std::min({a.y, b.y, c.y}), 0.0f});
    float right = std::min({clip.left + clip.width, std::max({a.x, b.x, c.x}), width()});
    float bottom = std::min({clip.top + clip.height, std::max({a.y, b.y, c.y}), height()});
    for (auto y = static_cast<int>(top); static_cast<float>(y) < bottom; ++y)
        for (auto x = static_cast<int>(left); static_cast<float>(x) < right; ++x) {
            float px = static_cast<float>(x) + 0.5f, py = static_cast<float>(y) + 0.5f;
            if (px < left || px >= right || py < top || py >= bottom) continue;
            float wa = edge(b, c, px, py) / area, wb = edge(c, a, px, py) / area, wc = 1 - wa - wb;
            if (wa < 0 || wb < 0 || wc < 0) continue;
            auto mix = [&](float u, float v, float w) { return wa * u + wb * v + wc * w; };
            float color[4] = {mix(a.r, b.r, c.r), mix(a.g, b.g, c.g), mix(a.b, b.b, c.b),
                              mix(a.a, b.a, c.a)};
            if (image != nullptr) {
                float u = mix(a.u, b.u, c.u) * static_cast<float>(image->width);
                float v = mix(a.v, b.v, c.v) * static_cast<float>(image->height);
                auto tx = std::min(static_cast<unsigned>(std::max(u, 0.0f)), image->width - 1);
                auto ty = std::min(static_cast<unsigned>(std::max(v, 0.0f)), image->height - 1);
                const std::uint8_t* texel = &image->rgba[(std::size_t{ty} * image->width + tx) * 4];
                for (int i = 0; i < 4; ++i) color[i] *= static_cast<float>(texel[i]) / 255;
            }
            float alpha = std::clamp(color[3] / 255, 0.0f, 1.0f);
            Pixel& pixel = pixels_[static_cast<std::size_t>(y) * width_ + static_cast<unsigned>(x)];
            for (std::size_t i = 0; i < 3; ++i)
                pixel[i] = static_cast<std::uint8_t>(
                    std::lround(static_cast<float>(pixel[i]) * (1 - alpha) + color[i] * alpha));
        }
}

void RasterSurface::save(const std::filesystem::path& file) const {
    std::filesystem::create_directories(file.parent_path());
    std::ofstream out(file, std::ios::binary);
    out << "P6\n" << width_ << ' ' << height_ << "\n255\n";
    for (const Pixel& pixel : pixels())
        out.write(reinterpret_cast<const char*>(pixel.data()), static_cast<std::streamsize>(3));
}

}  // namespace fettle::console::test
