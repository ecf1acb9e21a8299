#pragma once
// A screen that notes what is drawn on it: figures and texts, and where they are.

#include <algorithm>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <fettle/app/screen.h>

namespace fettle::app {

using property::Color;
using property::Paint;
using property::Vec2;

/// Notes the texts and the box around what is filled; has characters of a fixed width.
class NotingSurface : public Surface {
  public:
    float wide = 1280;
    float width() const override { return wide; }
    float height() const override { return 800; }
    Texture create_texture(unsigned, unsigned, const std::uint8_t*) override { return 1; }
    void update_texture(Texture, unsigned, unsigned, unsigned, unsigned,
                        const std::uint8_t*) override {}
    void destroy_texture(Texture) override {}
    void triangles(std::span<const SurfaceVertex> vertices, std::span<const std::uint16_t>, Texture,
                   const ClipRectangle&) override {
        for (const SurfaceVertex& vertex : vertices) {
            top = std::min(top, vertex.y);
            low = std::max(low, vertex.y);
            right = std::max(right, vertex.x);
        }
        if (!vertices.empty())
            fills.push_back({vertices[0].r, vertices[0].g, vertices[0].b, vertices[0].a});
    }
    float text(float x, float y, std::string_view line, float size, SurfaceColor color,
               Face) override {
        const float length = 0.6f * size * static_cast<float>(line.size());
        if (color.a > 0) {
            lines.push_back({std::string(line), y});
            text_right = std::max(text_right, x + length);
        }
        return length;
    }
    /// The height of the line that contains the text; -1 if there is none.
    float line_with(std::string_view part) const {
        for (const auto& [line, y] : lines)
            if (line.find(part) != std::string::npos) return y;
        return -1;
    }
    std::vector<std::pair<std::string, float>> lines;
    std::vector<SurfaceColor> fills;      // in the order in which they were drawn
    float top = 800, low = 0, right = 0;  // px
    float text_right = 0;                 // px, where the texts end
};

struct Circle {
    Vec2 pixel;
    double radius;
    Vec2 clip_lower, clip_upper;  // px
    bool on_screen;
};

/// Notes circles, and where they are on the screen.
class NotingPainter : public property::Painter {
  public:
    View view{};
    std::vector<Circle> circles{};
    int polygons = 0;

    void circle(const Vec2& center, double radius, const Paint&) override {
        circles.push_back(
            {to_pixels(center), radius * pixels_per_unit(), clip_lower_, clip_upper_, on_screen()});
    }
    void clip(const Vec2& lower, const Vec2& upper) override {
        // The box around the turned box, as on the screen.
        const Vec2 a = to_pixels(lower), b = to_pixels(upper);
        const Vec2 c = to_pixels({lower.x, upper.y}), d = to_pixels({upper.x, lower.y});
        clip_lower_ = a.min(b).min(c).min(d);
        clip_upper_ = a.max(b).max(c).max(d);
    }
    double pixels_per_unit() const override {
        return (on_screen() ? 1 : view.zoom()) * transform().scale();
    }
    property::Seen seen() const override {
        return {view.center, view.lower(), view.upper(), view.screen};
    }
    void ellipse(const Vec2&, const Vec2&, double, const Paint&) override {}
    void polygon(std::span<const Vec2>, double, const Paint&) override { ++polygons; }
    void line(const Vec2&, const Vec2&, Color, float) override {}
    void point(const Vec2&, Color, float) override {}
    void text(const Vec2&, std::string_view, double, Color, property::TextAlign) override {}
    void part_of(std::uint64_t) override {}
    bool shows(property::Overlay) const override { return false; }
    bool sees(const Vec2&, const Vec2&) const override { return true; }
    void begin_screen() override { push_screen(); }
    void end_screen() override { pop(); }

  private:
    Vec2 to_pixels(const Vec2& p) const {
        return on_screen() ? transform()(p) : view.to_screen(transform()(p));
    }
    Vec2 clip_lower_{0, 0}, clip_upper_{0, 0};
};

class NotingScreen : public Screen {
  public:
    NotingPainter noted{};
    NotingSurface noted_surface{};

    Vec2 size() const override { return {1280, 800}; }
    void begin(Color) override { noted.circles.clear(); }
    property::Painter& painter(const View& view) override {
        noted.view = view;
        return noted;
    }
    Surface& surface() override { return noted_surface; }
    void present() override {}
    void save(const std::filesystem::path&) override {}
    Pixels pixels() const override { return {}; }
    void release_textures() override {}
    Clipboard& clipboard() override { throw std::logic_error("there is no clipboard"); }
};

}  // namespace fettle::app
