#include "canvas.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace fettle::app {

using property::Color;
using property::Paint;
using property::Vec2;

namespace {

sf::Color native(Color color, float opacity = 1) {
    const auto channel = [](float value) {
        return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0f, 1.0f)));
    };
    return {channel(color.r), channel(color.g), channel(color.b), channel(color.a * opacity)};
}

sf::Color clear(sf::Color color) {
    color.a = 0;
    return color;
}

bool finite(const Vec2& v) {
    return std::isfinite(v.x()) && std::isfinite(v.y());
}

}  // namespace

// --- A frame -------------------------------------------------------------------------------------

void Canvas::begin(Color background) {
    strip_.clear();
    in_pixels_ = false;
    background.a = 1;
    target_.clear(native(background));
}

void Canvas::set_view(const View& view) {
    view_ = view;
}

void Canvas::flush() {
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

sf::Vector2f Canvas::pixel(const Vec2& position) const {
    const Vec2 p = in_pixels_ ? position : view_.to_screen(position);
    return {static_cast<float>(p.x()), static_cast<float>(p.y())};
}

float Canvas::pixels(double length) const {
    return static_cast<float>(in_pixels_ ? length : length * view_.zoom());
}

bool Canvas::outside(sf::Vector2f lower, sf::Vector2f upper) const {
    return upper.x < 0 || upper.y < 0 || lower.x > width() || lower.y > height();
}

bool Canvas::sees(const Vec2& lower, const Vec2& upper) const {
    const sf::Vector2f a = pixel(lower), b = pixel(upper);
    constexpr float margin = 4;  // px, for borders
    return !outside({std::min(a.x, b.x) - margin, std::min(a.y, b.y) - margin},
                    {std::max(a.x, b.x) + margin, std::max(a.y, b.y) + margin});
}

// --- Figures -------------------------------------------------------------------------------------

void Canvas::circle(const Vec2& center, double radius, const Paint& paint) {
    if (!finite(center) || !(radius > 0)) return;
    const sf::Vector2f middle = pixel(center);
    const float size = pixels(radius);
    const sf::Vector2f reach{size + 1, size + 1};
    if (outside(middle - reach, middle + reach)) return;
    // A small circle that hides what lies under it is one disc upon another.
    if (size <= Atlas::largest_disc && paint.fill.a >= 1) {
        const bool bordered = paint.border.a > 0 && paint.border_width > 0;
        if (bordered) draw_disc(middle, size, native(paint.border));
        const float inner = bordered ? size - paint.border_width : size;
        if (inner > 0) draw_disc(middle, inner, native(paint.fill));
        return;
    }
    corners_.assign(1, middle);
    figure(size, paint);
}

void Canvas::polygon(std::span<const Vec2> vertices, double rounding, const Paint& paint) {
    corners_.clear();
    for (const Vec2& vertex : vertices) {
        if (!finite(vertex)) return;
        corners_.push_back(pixel(vertex));
    }
    figure(pixels(rounding), paint);
}

void Canvas::line(const Vec2& from, const Vec2& to, Color color, float width) {
    if (!finite(from) || !finite(to) || !(width > 0)) return;
    const sf::Vector2f a = pixel(from), b = pixel(to);
    // Thinner than a pixel is paler than a line of one.
    const Paint paint{
        {color.r, color.g, color.b, color.a * std::min(1.0f, width)}, {0, 0, 0, 0}, 0};
    const float half = 0.5f * std::max(width, 1.0f);
    const sf::Vector2f along = b - a;
    const float length = std::hypot(along.x, along.y);
    if (width > 2.5f || length < 1e-3f) {  // round ends
        corners_.assign({a, b});
        figure(half, paint);
        return;
    }
    const sf::Vector2f side = sf::Vector2f{along.y, -along.x} * (half / length);
    corners_.assign({a + side, a - side, b - side, b + side});
    figure(0, paint);
}

void Canvas::point(const Vec2& position, Color color, float size) {
    if (!finite(position) || !(size > 0)) return;
    const sf::Vector2f middle = pixel(position);
    const float radius = std::min(0.5f * size, Atlas::largest_disc);
    const sf::Vector2f reach{radius + 1, radius + 1};
    if (!outside(middle - reach, middle + reach)) draw_disc(middle, radius, native(color));
}

void Canvas::figure(float rounding, const Paint& paint) {
    if (corners_.empty()) return;
    if (corners_.size() < 3) rounding = std::max(rounding, 0.5f);
    sf::Vector2f lower = corners_[0], upper = corners_[0];
    for (const sf::Vector2f corner : corners_) {
        lower = {std::min(lower.x, corner.x), std::min(lower.y, corner.y)};
        upper = {std::max(upper.x, corner.x), std::max(upper.y, corner.y)};
    }
    const sf::Vector2f reach{rounding + 1, rounding + 1};
    if (outside(lower - reach, upper + reach)) return;
    outline_.set(corners_, rounding);
    draw_outline(paint);
}

void Canvas::draw_outline(const Paint& paint) {
    const float limit = outline_.depth_limit();
    const auto within = [limit](float depth) { return std::min(depth, limit); };
    const sf::Color fill = native(paint.fill);
    rings_.clear();
    const auto ring = [&](float depth, sf::Color color) {
        outline_.ring(depth, rings_);
        ring_colors_[rings_.size() / outline_.size() - 1] = color;
    };
    if (paint.border.a <= 0 || paint.border_width <= 0) {
        ring(-0.5f, clear(fill));
        ring(within(0.5f), fill);
    } else {
        // A border thinner than a pixel is a paler one.
        const float width = std::max(paint.border_width, 1.0f);
        const sf::Color border = native(paint.border, std::min(paint.border_width, 1.0f));
        ring(-0.5f, clear(border));
        ring(within(0.5f), border);
        // Nobody sees how crisp the border of a figure of ten pixels is; thousands of them count.
        if (width > 1 && limit > 5) ring(within(width - 0.5f), border);
        ring(within(width + 0.5f), fill.a > 0 ? fill : clear(border));
    }
    draw_rings(fill.a > 0);
}

/// Strips between neighbouring rings of rings_, and the inside of the innermost.
void Canvas::draw_rings(bool filled) {
    const std::size_t n = outline_.size();
    const std::size_t count = rings_.size() / n;
    for (std::size_t r = 0; r + 1 < count; ++r) {
        const sf::Vector2f* outer = rings_.data() + r * n;
        const sf::Vector2f* inner = outer + n;
        CanvasVertex* out = start_strip(2 * (n + 1), outer[0]);
        for (std::size_t i = 0; i <= n; ++i) {
            const std::size_t at = i == n ? 0 : i;
            *out++ = plain(outer[at], ring_colors_[r]);
            *out++ = plain(inner[at], ring_colors_[r + 1]);
        }
    }
    if (!filled || n < 3) return;
    // A convex polygon as a strip: zigzag from one end to the other.
    const sf::Vector2f* inside = rings_.data() + (count - 1) * n;
    const sf::Color color = ring_colors_[count - 1];
    CanvasVertex* out = start_strip(n, inside[0]);
    *out++ = plain(inside[0], color);
    for (std::size_t low = 1, high = n - 1; low <= high; ++low, --high) {
        *out++ = plain(inside[low], color);
        if (high > low) *out++ = plain(inside[high], color);
    }
}

void Canvas::draw_disc(sf::Vector2f center, float radius, sf::Color color) {
    const Disc& disc = atlas_.disc(radius);
    const float half = 0.5f * disc.patch.width * radius / disc.radius;
    add_quad(center - sf::Vector2f{half, half}, center + sf::Vector2f{half, half}, disc.patch,
             color);
}

// --- The batch -----------------------------------------------------------------------------------

CanvasVertex Canvas::plain(sf::Vector2f position, sf::Color color) const {
    constexpr float white = Atlas::white;
    return {position.x, position.y, color.r, color.g, color.b, color.a, white, white};
}

/// Room for a strip of `count` vertices, joined to what stands before by triangles without area.
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

// --- Text ----------------------------------------------------------------------------------------

struct Canvas::Run {
    std::u32string line{};
    unsigned size = 0;  // px, as the glyphs are in the atlas
    float scale = 1;    // from there to the screen
    float width = 0;    // px on the screen
    Face face = Face::plain;
};

bool Canvas::lay_out(Run& run, std::string_view text, float size, Face face) {
    if (!(size >= 1) || text.empty() || !atlas_.has_font(face)) return false;
    run.line = decode_utf8(text);
    run.face = face;
    // Whole sizes are sharp; large text comes in fewer sizes, so that zooming does not fill the
    // atlas.
    const float whole = std::round(size);
    const float kept = whole <= 32 ? whole : std::min(96.0f, 8 * std::ceil(whole / 8));
    run.size = static_cast<unsigned>(kept);
    run.scale = whole <= 32 ? 1 : size / kept;
    if (!atlas_.prepare(run.line, run.size, face)) {
        flush();
        atlas_.clear_glyphs();
        if (!atlas_.prepare(run.line, run.size, face)) return false;
    }
    char32_t before = 0;
    for (const char32_t c : run.line) {
        if (before != 0) run.width += run.scale * atlas_.kerning(before, c, run.size, face);
        run.width += run.scale * atlas_.glyph(c, run.size, face).advance;
        before = c;
    }
    return true;
}

void Canvas::draw_text(const Run& run, sf::Vector2f baseline, sf::Color color) {
    sf::Vector2f pen = baseline;
    char32_t before = 0;
    for (const char32_t c : run.line) {
        const Glyph& glyph = atlas_.glyph(c, run.size, run.face);
        if (before != 0) pen.x += run.scale * atlas_.kerning(before, c, run.size, run.face);
        before = c;
        if (glyph.patch.width > 0) {
            sf::Vector2f lower = pen + sf::Vector2f{glyph.left, glyph.top} * run.scale;
            if (run.scale == 1) lower = {std::round(lower.x), std::round(lower.y)};
            const sf::Vector2f size{glyph.patch.width * run.scale, glyph.patch.height * run.scale};
            add_quad(lower, lower + size, glyph.patch, color);
        }
        pen.x += run.scale * glyph.advance;
    }
}

void Canvas::text(const Vec2& position, std::string_view text, double height, Color color,
                  property::TextAlign align) {
    Run run;
    if (!finite(position) || !lay_out(run, text, pixels(height), Face::plain)) return;
    const float size = static_cast<float>(run.size) * run.scale;
    sf::Vector2f middle = pixel(position);
    if (align != property::TextAlign::middle)
        middle.x += (align == property::TextAlign::left ? 0.5f : -0.5f) * run.width;
    const sf::Vector2f reach{0.5f * run.width + 1, size};
    if (outside(middle - reach, middle + reach)) return;
    // The middle of capitals, which are 0.73 of the size high.
    draw_text(run, {std::round(middle.x - 0.5f * run.width), std::round(middle.y + 0.365f * size)},
              native(color));
}

float Canvas::text(float x, float y, std::string_view line, float size, SurfaceColor color,
                   Face face) {
    Run run;
    if (!lay_out(run, line, size, face)) return 0;
    if (color.a > 0)
        draw_text(run, {std::round(x), std::round(y) + run.scale * atlas_.ascent(run.size, face)},
                  {color.r, color.g, color.b, color.a});
    return run.width;
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
    // A view on the clip rectangle alone: nothing beyond its edges is drawn.
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
