// Draws text with glyphs of the atlas.

#include <algorithm>
#include <cmath>
#include <vector>

#include <fettle/property/utf8.h>

#include <draw/canvas.h>

namespace fettle::app {

using property::Color;
using property::TextAlign;
using property::Vec2;

namespace {

constexpr float line_height = 1.2f;  // relative to the size
constexpr float tab_stops = 2;       // distance of tab stops, relative to the size
// Smallest width of a tab, relative to the size: about that of a space.
constexpr float tab_gap = 0.3f;

/// Splits a text into lines at "\n", "\r\n" and "\r".
std::vector<std::u32string> lines_of(std::string_view text) {
    std::vector<std::u32string> lines(1);
    bool after_return = false;
    for (const char32_t c : property::decode_utf8(text)) {
        const bool ends = c == U'\r' || (c == U'\n' && !after_return);
        if (ends)
            lines.emplace_back();
        else if (c != U'\n')
            lines.back().push_back(c);
        after_return = c == U'\r';
    }
    return lines;
}

}  // namespace

struct Canvas::Line {
    std::u32string text{};
    unsigned size = 0;  // px, size of the glyphs in the atlas
    float scale = 1;    // screen pixels for each pixel of the atlas
    float width = 0;    // px on the screen
    Face face = Face::plain;

    /// Calls `visit(glyph, x)` for each glyph, and returns the x of the end of the line.
    template <class Visit>
    float walk(const Atlas& atlas, Visit visit) const {
        const float stop = tab_stops * scale * static_cast<float>(size);
        const float gap = tab_gap * scale * static_cast<float>(size);
        float x = 0;
        char32_t before = 0;
        for (const char32_t c : text) {
            if (c == U'\t') {
                // A tab has a smallest width, so that the words beside it do not touch.
                x = stop * std::ceil((x + gap) / stop - 1e-3f);
                before = 0;
                continue;
            }
            if (before != 0) x += scale * atlas.kerning(before, c, size, face);
            const Glyph& glyph = atlas.glyph(c, size, face);
            visit(glyph, x);
            x += scale * glyph.advance;
            before = c;
        }
        return x;
    }
};

bool Canvas::lay_out(Line& line, float size, Face face) {
    if (!(size >= 1) || !std::isfinite(size) || line.text.empty() || !atlas_.has_font(face))
        return false;
    line.face = face;
    // Small text has whole sizes, which are sharp. Large text uses fewer sizes and is scaled, so
    // that zooming does not fill the atlas.
    const float whole = std::round(size);
    const float kept = whole <= 32 ? whole : std::min(96.0f, 8 * std::ceil(whole / 8));
    line.size = static_cast<unsigned>(kept);
    line.scale = whole <= 32 ? 1 : size / kept;
    if (!atlas_.prepare(line.text, line.size, face)) {
        flush();
        atlas_.clear_glyphs();
        if (!atlas_.prepare(line.text, line.size, face)) return false;
    }
    line.width = line.walk(atlas_, [](const Glyph&, float) {});
    return true;
}

void Canvas::draw_line_of_text(const Line& line, sf::Vector2f baseline, sf::Color color) {
    line.walk(atlas_, [&](const Glyph& glyph, float x) {
        if (glyph.patch.width <= 0) return;
        const sf::Vector2f pen{baseline.x + x, baseline.y};
        sf::Vector2f lower = pen + sf::Vector2f{glyph.left, glyph.top} * line.scale;
        if (line.scale == 1) lower = {std::round(lower.x), std::round(lower.y)};
        const sf::Vector2f size{glyph.patch.width * line.scale, glyph.patch.height * line.scale};
        add_quad(lower, lower + size, glyph.patch, color);
    });
}

void Canvas::text(const Vec2& position, std::string_view text, double height, Color color,
                  TextAlign align) {
    if (state().blend == property::Blend::multiply) {  // glyphs of the atlas cannot multiply
        push({});
        blend(property::Blend::normal);
        this->text(position, text, height, color, align);
        return pop();
    }
    draw_collected();
    const Vec2 at = exact(position);
    const auto size = static_cast<float>(pixels(height));
    if (!is_finite(at) || !(size >= 1) || !std::isfinite(size)) return;
    std::vector<std::u32string> lines = lines_of(text);
    const double spacing = static_cast<double>(line_height * size);
    double y = at.y - 0.5 * spacing * static_cast<double>(lines.size() - 1);
    for (std::u32string& characters : lines) {
        const double middle = y;
        y += spacing;
        const Vec2 reach(0, static_cast<double>(size));
        if (outside(Vec2(0, middle) - reach, Vec2(0, middle) + reach)) continue;
        Line line;
        line.text = std::move(characters);
        if (!lay_out(line, size, Face::plain)) continue;
        const auto width = static_cast<double>(line.width);
        const double left = at.x - (align == TextAlign::left    ? 0.0
                                    : align == TextAlign::right ? width
                                                                : 0.5 * width);
        if (left > static_cast<double>(this->width()) || left + width < 0) continue;
        // Half the height of capitals, which is 0.73 of the size.
        const float drawn = static_cast<float>(line.size) * line.scale;
        draw_line_of_text(line,
                          {static_cast<float>(std::round(left)),
                           std::round(static_cast<float>(middle) + 0.365f * drawn)},
                          native(faded(color)));
    }
}

float Canvas::text(float x, float y, std::string_view text, float size, SurfaceColor color,
                   Face face) {
    draw_collected();
    Line line;
    line.text = property::decode_utf8(text);
    if (!lay_out(line, size, face)) return 0;
    if (color.a > 0)
        draw_line_of_text(
            line, {std::round(x), std::round(y) + line.scale * atlas_.ascent(line.size, face)},
            {color.r, color.g, color.b, color.a});
    return line.width;
}

}  // namespace fettle::app
