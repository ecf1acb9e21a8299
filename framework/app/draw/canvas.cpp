#include <draw/canvas.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace fettle::app {

using property::Blend;
using property::Color;
using property::Vec2;

bool is_finite(const Vec2& v) {
    return std::isfinite(v.x) && std::isfinite(v.y);
}

namespace {

void multiply_by_opacity(std::vector<CanvasVertex>& vertices) {
    for (CanvasVertex& v : vertices) {
        v.r = static_cast<std::uint8_t>(v.r * v.a / 255);
        v.g = static_cast<std::uint8_t>(v.g * v.a / 255);
        v.b = static_cast<std::uint8_t>(v.b * v.a / 255);
    }
}

}  // namespace

Canvas::Canvas(sf::RenderTarget& target) : target_(target) {
    // Without an active target, the renderer is not known.
    if (target_.setActive(true) && sfml::has_quads && sfml::renders_in_software())
        pictures_.keep_texels();
}

// --- A frame -------------------------------------------------------------------------------------

void Canvas::begin(Color background) {
    batch_.clear();
    collected_.parts.clear();
    polyline_.points.clear();
    reset_state();
    pictures_.begin_frame();
    whole_ = 0;
    background.a = 1;
    target_.clear(native(background));
}

void Canvas::set_view(const View& view) {
    draw_collected();
    view_ = view;
    world_to_pixels_ = view_.world_to_window();
    screen_to_pixels_ = property::Transform::moved(view_.corner());
    has_to_pixels_ = false;
}

void Canvas::begin_screen() {
    draw_collected();
    push_screen();
}

void Canvas::end_screen() {
    draw_collected();
    pop();
}

void Canvas::set_state(const State& next) {
    const State& now = state();
    const bool same_clip = now.clipped == next.clipped && now.clip_lower == next.clip_lower &&
                           now.clip_upper == next.clip_upper;
    // The triangles that are collected already belong to the old state.
    if (now.opacity != next.opacity) draw_collected();
    if (now.blend != next.blend || !same_clip) flush();
    Painter::set_state(next);
    has_to_pixels_ = false;
}

void Canvas::set_transform(const property::Transform& transform) {
    Painter::set_transform(transform);
    has_to_pixels_ = false;
}

void Canvas::find_to_pixels() const {
    to_pixels_ = (state().on_screen ? screen_to_pixels_ : world_to_pixels_) * state().transform;
    has_to_pixels_ = true;
}

void Canvas::clip(const Vec2& lower, const Vec2& upper) {
    State clipped = state();
    Vec2 from = exact(lower), to = from;
    for (const Vec2& corner : {upper, Vec2(lower.x, upper.y), Vec2(upper.x, lower.y)}) {
        from = from.min(exact(corner));
        to = to.max(exact(corner));
    }
    if (!is_finite(from) || !is_finite(to)) return;
    if (clipped.clipped) {
        from = from.max(clipped.clip_lower);
        to = to.min(clipped.clip_upper);
    }
    clipped.clipped = true;
    clipped.clip_lower = from;
    clipped.clip_upper = to;
    set_state(clipped);
}

void Canvas::gradient(const property::Gradient& gradient) {
    const Vec2 along = gradient.to - gradient.from;
    property::Gradient placed = gradient;
    placed.from = exact(gradient.from);
    placed.to = exact(gradient.to);
    State next = state();
    next.gradient_across = exact(gradient.from + Vec2(-along.y, along.x));
    next.gradient = std::make_shared<const property::Gradient>(std::move(placed));
    set_state(next);
}

void Canvas::flush() {
    draw_collected();
    draw_strip();
}

void Canvas::draw_strip() {
    if (batch_.empty()) return;
    const State& s = state();
    const Vec2 size(static_cast<double>(width()), static_cast<double>(height()));
    const Vec2 lower = s.clipped ? s.clip_lower.max({0, 0}).min(size) : Vec2(0, 0);
    const Vec2 upper = s.clipped ? s.clip_upper.max({0, 0}).min(size) : size;
    const auto edge = [](double x) { return static_cast<float>(std::round(x)); };
    const float left = edge(lower.x), top = edge(lower.y);
    const float right = edge(upper.x), bottom = edge(upper.y);
    if (right > left && bottom > top) {
        set_clip(left, top, right, bottom);
        const sf::Texture& texture = batch_.texture ? *batch_.texture : atlas_.texture();
        if (s.blend == property::Blend::multiply) multiply_by_opacity(batch_.strip);
        if (s.blend == property::Blend::multiply) multiply_by_opacity(batch_.quads);
        if (!batch_.strip.empty())
            draw(batch_.strip, sf::PrimitiveType::TriangleStrip, texture, s.blend);
        const PixelBox clip{static_cast<int>(left), static_cast<int>(top), static_cast<int>(right),
                            static_cast<int>(bottom)};
        if (!batch_.quads.empty() && !draw_quads_here(texture, s.blend, clip))
            draw(batch_.quads, sfml::quads, texture, s.blend);
    }
    batch_.clear();
}

/// Draws `batch_.quads` on the processor, and their picture at once. False if that is not possible,
/// or if it would take longer than the renderer of OpenGL.
bool Canvas::draw_quads_here(const sf::Texture& texture, Blend blend, const PixelBox& clip) {
    if (batch_.quads.size() < 1000 || blend == Blend::multiply) return false;
    const TexelRows texels = pictures_.texels(texture);
    if (texels.rgba == nullptr) return false;
    raster_.measure(batch_.quads, clip);
    if (!raster_.is_faster()) return false;
    if (raster_.box().width() == 0 || raster_.box().height() == 0) return true;
    const bool adds = blend == Blend::add;
    raster_.draw(batch_.quads, texels, adds);
    const PixelBox& box = raster_.box();
    // With one texture, the renderer would wait for the picture before.
    sf::Texture& drawn = drawn_here_[next_drawn_here_++ % drawn_here_.size()];
    const auto wide = static_cast<unsigned>(width()), high = static_cast<unsigned>(height());
    if (drawn.getSize() != target_.getSize() && !sfml::create(drawn, wide, high)) return false;
    sfml::update(drawn, raster_.rgba(), static_cast<unsigned>(box.width()),
                 static_cast<unsigned>(box.height()), 0, 0);
    const auto corner = [&](int x, int y) {
        return CanvasVertex(static_cast<float>(x), static_cast<float>(y), 255, 255, 255, 255,
                            static_cast<float>(x - box.left), static_cast<float>(y - box.top));
    };
    const std::array<CanvasVertex, 4> corners{corner(box.left, box.top), corner(box.right, box.top),
                                              corner(box.left, box.bottom),
                                              corner(box.right, box.bottom)};
    using Factor = sf::BlendMode::Factor;
    sf::RenderStates states(&drawn);
    states.blendMode = sf::BlendMode(Factor::One, adds ? Factor::One : Factor::OneMinusSrcAlpha);
    target_.draw(reinterpret_cast<const sf::Vertex*>(corners.data()), corners.size(),
                 sf::PrimitiveType::TriangleStrip, states);
    return true;
}

/// The view and viewport are the clip rectangle, so nothing outside it is drawn.
void Canvas::set_clip(float left, float top, float right, float bottom) {
    sf::View view(sfml::rectangle(left, top, right - left, bottom - top));
    view.setViewport(sfml::rectangle(left / width(), top / height(), (right - left) / width(),
                                     (bottom - top) / height()));
    target_.setView(view);
}

void Canvas::draw(const std::vector<CanvasVertex>& vertices, sf::PrimitiveType type,
                  const sf::Texture& texture, property::Blend blend) {
    static_assert(sizeof(CanvasVertex) == sizeof(sf::Vertex) &&
                  offsetof(CanvasVertex, r) == offsetof(sf::Vertex, color) &&
                  offsetof(CanvasVertex, u) == offsetof(sf::Vertex, texCoords));
    sf::RenderStates states;
    states.texture = &texture;
    if (blend == property::Blend::add) states.blendMode = sf::BlendAdd;
    // The colors are multiplied by their opacity, so transparent parts change nothing.
    if (blend == property::Blend::multiply)
        states.blendMode =
            sf::BlendMode(sf::BlendMode::Factor::DstColor, sf::BlendMode::Factor::OneMinusSrcAlpha,
                          sf::BlendMode::Equation::Add, sf::BlendMode::Factor::Zero,
                          sf::BlendMode::Factor::One, sf::BlendMode::Equation::Add);
    target_.draw(reinterpret_cast<const sf::Vertex*>(vertices.data()), vertices.size(), type,
                 states);
}

sf::Vector2f Canvas::pixel(const Vec2& position) const {
    const Vec2 p = exact(position);
    return {static_cast<float>(p.x), static_cast<float>(p.y)};
}

double Canvas::pixels(double length) const {
    const double outer = transformed() ? length * state().transform.scale() : length;
    return state().on_screen ? outer : outer * view_.zoom();
}

Color Canvas::faded(Color color) const {
    color.a *= state().opacity;
    return color;
}

property::Paint Canvas::faded(const property::Paint& paint) const {
    return {faded(paint.fill), faded(paint.border), paint.border_width};
}

bool Canvas::outside(const Vec2& lower, const Vec2& upper) const {
    return upper.x < 0 || upper.y < 0 || lower.x > static_cast<double>(width()) ||
           lower.y > static_cast<double>(height());
}

bool Canvas::sees(const Vec2& lower, const Vec2& upper) const {
    const Vec2 margin(4, 4);  // px; a border may lie outside the given box
    Vec2 from = exact(lower), to = from;
    const auto add = [&](const Vec2& corner) {
        const Vec2 p = exact(corner);
        from = from.min(p);
        to = to.max(p);
    };
    add(upper);
    if (transformed() || view_.angle != 0) {
        add(Vec2(lower.x, upper.y));
        add(Vec2(upper.x, lower.y));
    }
    return !outside(from - margin, to + margin);
}

// --- The batch -----------------------------------------------------------------------------------

CanvasVertex Canvas::plain(sf::Vector2f position, sf::Color color) const {
    if (shade_.texture() != nullptr) {
        const sf::Vector2f at = shade_.texel(position);
        return {position.x, position.y, color.r, color.g, color.b, color.a, at.x, at.y};
    }
    constexpr float white = Atlas::white;
    return {position.x, position.y, color.r, color.g, color.b, color.a, white, white};
}

/// Appends `count` vertices to the strip, joined to the last one by degenerate triangles.
CanvasVertex* Canvas::start_strip(std::size_t count, sf::Vector2f first,
                                  const sf::Texture* texture) {
    if (texture == nullptr) texture = shade_.texture();
    const bool fits = texture == nullptr ? batch_.texture == &atlas_.texture() ||
                                               pictures_.has_white(batch_.texture)
                                         : batch_.texture == texture;
    if (!fits || !batch_.quads.empty()) {
        draw_strip();
        batch_.texture = texture == nullptr ? &atlas_.texture() : texture;
    }
    batch_.last_quads = 0;
    const std::size_t size = batch_.strip.size();
    if (size == 0) {
        batch_.strip.resize(count);
        return batch_.strip.data();
    }
    batch_.strip.resize(size + 2 + count);
    batch_.strip[size] = batch_.strip[size - 1];
    batch_.strip[size + 1] = plain(first, sf::Color::Transparent);
    return batch_.strip.data() + size + 2;
}

void Canvas::add_quad(sf::Vector2f lower, sf::Vector2f upper, const Patch& patch, sf::Color color) {
    const auto corner = [color](float x, float y, float u, float v) {
        return CanvasVertex{x, y, color.r, color.g, color.b, color.a, u, v};
    };
    const float right = patch.left + patch.width, bottom = patch.top + patch.height;
    add_quad(
        {corner(lower.x, lower.y, patch.left, patch.top),
         corner(upper.x, lower.y, right, patch.top), corner(lower.x, upper.y, patch.left, bottom),
         corner(upper.x, upper.y, right, bottom)},
        atlas_.texture());
}

/// Many parts of textures in a row are drawn as quads, for which software rendering needs half the
/// time of two triangles each (50 000 particles of 4 px: 55 ms, not 110). A few are drawn with the
/// figures around them.
void Canvas::add_quad(const CanvasVertex (&corners)[4], const sf::Texture& texture) {
    constexpr std::size_t enough = 64;
    if (!batch_.quads.empty() && batch_.texture == &texture) {
        batch_.quads.insert(batch_.quads.end(), {corners[0], corners[1], corners[3], corners[2]});
        return;
    }
    const std::size_t before = batch_.texture == &texture ? batch_.last_quads : 0;
    CanvasVertex* out = start_strip(4, {corners[0].x, corners[0].y}, &texture);
    std::copy_n(corners, 4, out);
    batch_.last_quads = before + 1;
    if (sfml::has_quads && batch_.last_quads == enough) begin_quads();
}

/// Draws the strip up to the quads at its end, which become the first of `batch_.quads`.
void Canvas::begin_quads() {
    constexpr std::size_t joined = 6;  // vertices of a quad with those that join it
    const std::size_t count = batch_.last_quads, length = joined * count - 2;
    const std::vector<CanvasVertex> last(batch_.strip.end() - static_cast<std::ptrdiff_t>(length),
                                         batch_.strip.end());
    const sf::Texture* const texture = batch_.texture;
    const std::size_t rest = batch_.strip.size() - length;
    batch_.strip.resize(rest > 2 ? rest - 2 : 0);
    draw_strip();
    batch_.texture = texture;
    for (std::size_t i = 0; i < count; ++i)
        for (const std::size_t corner : {0, 1, 3, 2})
            batch_.quads.push_back(last[joined * i + corner]);
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
    const float left = std::clamp(std::floor(clip.left), 0.0f, width());
    const float top = std::clamp(std::floor(clip.top), 0.0f, height());
    const float right = std::clamp(std::ceil(clip.left + clip.width), left, width());
    const float bottom = std::clamp(std::ceil(clip.top + clip.height), top, height());
    if (right <= left || bottom <= top) return;
    set_clip(left, top, right, bottom);
    draw(layer_, sf::PrimitiveType::Triangles, source, property::Blend::normal);
}

}  // namespace fettle::app
