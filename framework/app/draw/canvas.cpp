#include <draw/canvas.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace fettle::app {

using property::Color;
using property::Vec2;

bool is_finite(const Vec2& v) {
    return std::isfinite(v.x()) && std::isfinite(v.y());
}

// --- A frame -------------------------------------------------------------------------------------

void Canvas::begin(Color background) {
    strip_.clear();
    joined_.clear();
    in_pixels_ = false;
    whole_ = 0;
    background.a = 1;
    target_.clear(native(background));
}

void Canvas::set_view(const View& view) {
    draw_collected();
    view_ = view;
}

void Canvas::begin_screen() {
    draw_collected();
    in_pixels_ = true;
}

void Canvas::end_screen() {
    draw_collected();
    in_pixels_ = false;
}

void Canvas::flush() {
    draw_collected();
    if (strip_.empty()) return;
    target_.setView(sf::View(sfml::rectangle(0, 0, width(), height())));
    draw(strip_, sf::PrimitiveType::TriangleStrip, atlas_.texture());
    strip_.clear();
}

void Canvas::draw(const std::vector<CanvasVertex>& vertices, sf::PrimitiveType type,
                  const sf::Texture& texture) {
    static_assert(sizeof(CanvasVertex) == sizeof(sf::Vertex) &&
                  offsetof(CanvasVertex, r) == offsetof(sf::Vertex, color) &&
                  offsetof(CanvasVertex, u) == offsetof(sf::Vertex, texCoords));
    sf::RenderStates states;
    states.texture = &texture;
    target_.draw(reinterpret_cast<const sf::Vertex*>(vertices.data()), vertices.size(), type,
                 states);
}

Vec2 Canvas::exact(const Vec2& position) const {
    return in_pixels_ ? position : view_.to_screen(position);
}

sf::Vector2f Canvas::pixel(const Vec2& position) const {
    const Vec2 p = exact(position);
    return {static_cast<float>(p.x()), static_cast<float>(p.y())};
}

double Canvas::pixels(double length) const {
    return in_pixels_ ? length : length * view_.zoom();
}

bool Canvas::outside(const Vec2& lower, const Vec2& upper) const {
    return upper.x() < 0 || upper.y() < 0 || lower.x() > static_cast<double>(width()) ||
           lower.y() > static_cast<double>(height());
}

bool Canvas::sees(const Vec2& lower, const Vec2& upper) const {
    const Vec2 a = exact(lower), b = exact(upper);
    const Vec2 margin(4, 4);  // px; a border may lie outside the given box
    return !outside(a.cwiseMin(b) - margin, a.cwiseMax(b) + margin);
}

// --- The batch -----------------------------------------------------------------------------------

CanvasVertex Canvas::plain(sf::Vector2f position, sf::Color color) const {
    constexpr float white = Atlas::white;
    return {position.x, position.y, color.r, color.g, color.b, color.a, white, white};
}

/// Appends `count` vertices to the strip, joined to the last one by degenerate triangles.
CanvasVertex* Canvas::start_strip(std::size_t count, sf::Vector2f first) {
    const std::size_t size = strip_.size();
    if (size == 0) {
        strip_.resize(count);
        return strip_.data();
    }
    strip_.resize(size + 2 + count);
    strip_[size] = strip_[size - 1];
    strip_[size + 1] = plain(first, sf::Color::Transparent);
    return strip_.data() + size + 2;
}

void Canvas::add_quad(sf::Vector2f lower, sf::Vector2f upper, const Patch& patch, sf::Color color) {
    const auto corner = [color](float x, float y, float u, float v) {
        return CanvasVertex{x, y, color.r, color.g, color.b, color.a, u, v};
    };
    const float right = patch.left + patch.width, bottom = patch.top + patch.height;
    CanvasVertex* out = start_strip(4, lower);
    out[0] = corner(lower.x, lower.y, patch.left, patch.top);
    out[1] = corner(upper.x, lower.y, right, patch.top);
    out[2] = corner(lower.x, upper.y, patch.left, bottom);
    out[3] = corner(upper.x, upper.y, right, bottom);
}

// --- A layer's triangles -------------------------------------------------------------------------

Surface::Texture Canvas::create_texture(unsigned width, unsigned height, const std::uint8_t* rgba) {
    auto texture = std::make_unique<sf::Texture>();
    if (width == 0 || height == 0 || !sfml::create(*texture, width, height)) return 0;
    texture->setSmooth(true);
    if (rgba != nullptr) sfml::update(*texture, rgba, width, height, 0, 0);
    textures_.emplace(next_texture_, std::move(texture));
    return next_texture_++;
}

void Canvas::update_texture(Texture texture, unsigned x, unsigned y, unsigned width,
                            unsigned height, const std::uint8_t* rgba) {
    const auto found = textures_.find(texture);
    if (found != textures_.end()) sfml::update(*found->second, rgba, width, height, x, y);
}

void Canvas::destroy_texture(Texture texture) {
    textures_.erase(texture);
}

void Canvas::triangles(std::span<const SurfaceVertex> vertices,
                       std::span<const std::uint16_t> indices, Texture texture,
                       const ClipRectangle& clip) {
    flush();
    const auto found = textures_.find(texture);
    const bool plain = found == textures_.end();
    const sf::Texture& source = plain ? atlas_.texture() : *found->second;
    const auto wide = static_cast<float>(source.getSize().x);
    const auto high = static_cast<float>(source.getSize().y);
    layer_.clear();
    for (const std::uint16_t index : indices) {
        if (index >= vertices.size()) return;
        const SurfaceVertex& v = vertices[index];
        layer_.push_back({v.x, v.y, v.r, v.g, v.b, v.a, plain ? Atlas::white : v.u * wide,
                          plain ? Atlas::white : v.v * high});
    }
    // The view and viewport are the clip rectangle, so nothing outside it is drawn.
    const float left = std::clamp(std::floor(clip.left), 0.0f, width());
    const float top = std::clamp(std::floor(clip.top), 0.0f, height());
    const float right = std::clamp(std::ceil(clip.left + clip.width), left, width());
    const float bottom = std::clamp(std::ceil(clip.top + clip.height), top, height());
    if (right <= left || bottom <= top) return;
    sf::View view(sfml::rectangle(left, top, right - left, bottom - top));
    view.setViewport(sfml::rectangle(left / width(), top / height(), (right - left) / width(),
                                     (bottom - top) / height()));
    target_.setView(view);
    draw(layer_, sf::PrimitiveType::Triangles, source);
}

}  // namespace fettle::app
