// Converts figures to triangles.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <draw/canvas.h>
#include <outlines/border_rings.h>

namespace fettle::app {

using property::Color;
using property::Paint;
using property::Vec2;

namespace {

// px. A figure beyond these limits is cut to its visible part, in double precision.
constexpr double far_away = 8000, large_radius = 1000;
// px. Wider lines of one whole have round ends, which may overlap.
constexpr float widest_polyline = 4;

/// A bounding box.
struct Bounds {
    Vec2 lower, upper;
    explicit Bounds(const Vec2& point) : lower(point), upper(point) {}
    void add(const Vec2& point) {
        lower = lower.min(point);
        upper = upper.max(point);
    }
    bool near() const { return lower.smallest() > -far_away && upper.largest() < far_away; }
};

/// Whether a circle stays a circle.
bool is_similar(const property::Transform& t) {
    const double size = t.x.length_squared() + t.y.length_squared();
    return std::abs(t.x.dot(t.y)) <= 1e-9 * size &&
           std::abs(t.x.length_squared() - t.y.length_squared()) <= 1e-9 * size;
}

sf::Vector2f narrow(const Vec2& v) {
    return {static_cast<float>(v.x), static_cast<float>(v.y)};
}

}  // namespace

// --- What users draw -----------------------------------------------------------------------------

void Canvas::circle(const Vec2& center, double radius, const Paint& given) {
    if (transformed() && !is_similar(state().transform))
        return ellipse(center, Vec2(radius, radius), 0, given);
    if (in_gradient(given, [&](const Paint& p) { circle(center, radius, p); })) return;
    const Paint paint = faded(given);
    const Vec2 middle = exact(center);
    const double size = pixels(radius);
    if (!is_finite(middle) || !(size > 0) || !std::isfinite(size)) return;
    const Vec2 reach(size + 1, size + 1);
    if (outside(middle - reach, middle + reach)) return;
    edge_ = Edge::free;
    if (size > large_radius)
        return large_figure(visible_area(paint).rounded({&middle, 1}, size), paint);
    const auto small = static_cast<float>(size);
    // A small circle with an opaque fill is drawn as one disc over another.
    if (small <= Atlas::largest_disc && paint.fill.a >= 1 && whole_ == 0 && !shading_ &&
        state().blend == property::Blend::normal) {
        draw_collected();
        const bool bordered = paint.border.a > 0 && paint.border_width > 0;
        if (bordered) draw_disc(narrow(middle), small, native(paint.border));
        const float inner = bordered ? small - paint.border_width : small;
        if (inner > 0) draw_disc(narrow(middle), inner, native(paint.fill));
        return;
    }
    corners_.assign(1, narrow(middle));
    figure(small, paint);
}

void Canvas::ellipse(const Vec2& center, const Vec2& radii, double angle, const Paint& given) {
    if (in_gradient(given, [&](const Paint& p) { ellipse(center, radii, angle, p); })) return;
    const Paint paint = faded(given);
    const Vec2 middle = exact(center);
    const Vec2 along(std::cos(angle), std::sin(angle)), across(-along.y, along.x);
    const Vec2 a = exact(center + radii.x * along) - middle;
    const Vec2 b = exact(center + radii.y * across) - middle;
    if (!is_finite(middle) || !is_finite(a) || !is_finite(b)) return;
    const Vec2 reach =
        Vec2(std::sqrt(a.x * a.x + b.x * b.x), std::sqrt(a.y * a.y + b.y * b.y)) + Vec2(1, 1);
    if (outside(middle - reach, middle + reach)) return;
    std::vector<Vec2> rim;
    visible_area(paint).arc(middle, a, b, 0, 2 * std::numbers::pi, rim);
    edge_ = Edge::free;
    if (reach.largest() > large_radius) return large_figure(std::move(rim), paint);
    corners_.clear();
    for (const Vec2& point : rim) corners_.push_back(narrow(point));
    figure(0, paint);
}

void Canvas::polygon(std::span<const Vec2> vertices, double rounding, const Paint& given) {
    if (vertices.empty()) return;
    if (in_gradient(given, [&](const Paint& p) { polygon(vertices, rounding, p); })) return;
    const Paint paint = faded(given);
    const double radius = std::isfinite(rounding) ? pixels(std::max(rounding, 0.0)) : 0;
    Bounds bounds(exact(vertices[0]));
    corners_.clear();
    for (const Vec2& vertex : vertices) {
        const Vec2 p = exact(vertex);
        if (!is_finite(p)) return;
        bounds.add(p);
        corners_.push_back(narrow(p));
    }
    const Vec2 reach(radius + 1, radius + 1);
    if (outside(bounds.lower - reach, bounds.upper + reach)) return;
    edge_ = Edge::touching;
    if (bounds.near() && radius <= large_radius) {
        if (corners_.size() > 64) remove_close_corners(corners_);
        return figure(static_cast<float>(radius), paint);
    }
    std::vector<Vec2> outline;
    outline.reserve(vertices.size());
    for (const Vec2& vertex : vertices) outline.push_back(exact(vertex));
    if (radius > 0 || outline.size() < 3)
        outline = visible_area(paint).rounded(outline, std::max(radius, 0.5));
    large_figure(std::move(outline), paint);
}

void Canvas::line(const Vec2& from, const Vec2& to, Color color, float width) {
    if (polyline_.points.empty() || polyline_.whole != whole_) draw_collected();
    Vec2 start = exact(from), end = exact(to);
    if (!is_finite(start) || !is_finite(end) || !(width > 0) || !std::isfinite(width)) return;
    // A line thinner than a pixel is drawn one pixel wide and paler.
    const Paint paint{faded(Color{color.r, color.g, color.b, color.a * std::min(1.0f, width)}),
                      {0, 0, 0, 0},
                      width};
    Bounds bounds(start);
    bounds.add(end);
    const float half = 0.5f * std::max(width, 1.0f);
    const Vec2 reach(half + 1.0, half + 1.0);
    if (outside(bounds.lower - reach, bounds.upper + reach)) return;
    if (!bounds.near() && !visible_area(paint).cut(start, end)) return;
    const sf::Vector2f a = narrow(start), b = narrow(end), along = b - a;
    if (whole_ != 0 && width <= widest_polyline && !opaque(native(paint.fill)))
        return add_to_polyline(a, b, native(paint.fill), std::max(width, 1.0f));
    draw_collected();
    const float length = std::hypot(along.x, along.y);
    edge_ = Edge::free;
    const std::uint64_t whole = std::exchange(whole_, 0);  // a line never belongs to a whole
    if (width > 2.5f || length < 1e-3f) {                  // round ends
        corners_.assign({a, b});
        figure(half, paint);
    } else {
        const sf::Vector2f side = sf::Vector2f{along.y, -along.x} * (half / length);
        corners_.assign({a + side, a - side, b - side, b + side});
        figure(0, paint);
    }
    whole_ = whole;
}

void Canvas::point(const Vec2& position, Color color, float size) {
    draw_collected();
    const Vec2 middle = exact(position);
    if (!is_finite(middle) || !(size > 0)) return;
    const float radius = std::min(0.5f * size, Atlas::largest_disc);
    const Vec2 reach(radius + 1.0, radius + 1.0);
    if (!outside(middle - reach, middle + reach))
        draw_disc(narrow(middle), radius, native(faded(color)));
}

// --- Outlines ------------------------------------------------------------------------------------

/// The visible area for figures; larger than the screen, so that the cuts are not visible.
VisibleArea Canvas::visible_area(const Paint& paint) const {
    const double margin = 16 + 2 * std::clamp(static_cast<double>(paint.border_width), 0.0, 1e4);
    return {Vec2(-margin, -margin),
            Vec2(static_cast<double>(width()) + margin, static_cast<double>(height()) + margin)};
}

void Canvas::large_figure(std::vector<Vec2> outline, const Paint& paint) {
    visible_area(paint).cut(outline);
    if (outline.size() < 3) return;
    corners_.clear();
    for (const Vec2& point : outline) corners_.push_back(narrow(point));
    remove_close_corners(corners_);
    figure(0, paint);
}

void Canvas::figure(float rounding, const Paint& paint) {
    if (corners_.size() < 3) rounding = std::max(rounding, 0.5f);
    const bool parts = is_collected(paint);
    const bool convex = is_convex(corners_);
    if (convex)
        outline_.set(corners_, rounding);
    else
        outline_.set_any(corners_);
    if (parts)
        collect();
    else if (convex)
        draw_outline(paint);
    else
        draw_any_outline(paint);
}

/// For a convex outline: draws its rings, and the inside of the innermost ring.
void Canvas::draw_outline(const Paint& paint) {
    if (outline_.size() == 0) return;
    const float limit = outline_.depth_limit();
    const auto within = [limit](float depth) { return std::min(depth, limit); };
    const sf::Color fill = native(paint.fill);
    scratch_.rings.clear();
    const auto ring = [&](float depth, sf::Color color) {
        outline_.ring(depth, scratch_.rings);
        scratch_.ring_colors[scratch_.rings.size() / outline_.size() - 1] = color;
    };
    const auto halo = [&](sf::Color color) {
        outline_.halo(scratch_.rings);
        scratch_.ring_colors[0] = clear(color);
    };
    // An opaque color up to the outline that fades only outside of it leaves no gap where two
    // figures touch.
    const bool touching = edge_ == Edge::touching;
    if (!bordered(paint)) {
        if (!touching || !opaque(fill)) {
            ring(-0.5f, clear(fill));
            ring(within(0.5f), fill);
        } else if (draw_sides(fill)) {
            ring(0, fill);
        } else {
            halo(fill);
            ring(0, fill);
        }
    } else {
        // A border thinner than a pixel is drawn one pixel wide and paler.
        const sf::Color border = native(paint.border, std::min(paint.border_width, 1.0f));
        const bool fades_outside = touching && opaque(border);
        const float width =
            std::max(paint.border_width, 1.0f) - (fades_outside ? halo_correction : 0.0f);
        if (fades_outside) {
            halo(border);
            ring(0, border);
        } else {
            ring(-0.5f, clear(border));
            ring(within(0.5f), border);
        }
        // In a figure of about ten pixels the sharp border is not visible, so its vertices are
        // saved.
        if (width > 1 && limit > 5) ring(within(width - 0.5f), border);
        ring(within(width + 0.5f), fill.a > 0 ? fill : clear(border));
    }
    draw_rings(fill.a > 0);
}

/// Draws the halo of a figure with few sides separately for each side, so that the halos of
/// neighboring tiles do not overlap at their corners. Returns false for other figures.
bool Canvas::draw_sides(sf::Color fill) {
    const auto corners = outline_.corners();
    const auto sides = outline_.sides();
    const std::size_t n = corners.size();
    if (outline_.rounded() || n > 6 || n < 3) return false;
    CanvasVertex* out = start_strip(5 * n, corners[0]);
    for (std::size_t i = 0; i < n; ++i) {
        const sf::Vector2f from = corners[i], to = corners[i + 1 < n ? i + 1 : 0];
        const sf::Vector2f halo = sides[i].normal * sides[i].halo;
        *out++ = plain(from, fill);
        *out++ = plain(from + halo, clear(fill));
        *out++ = plain(to, fill);
        *out++ = plain(to + halo, clear(fill));
        *out++ = plain(to, fill);
    }
    return true;
}

/// Draws the strips between neighboring rings of scratch_.rings, and the inside of the innermost
/// ring.
void Canvas::draw_rings(bool filled) {
    const std::size_t n = outline_.size();
    const std::size_t count = scratch_.rings.size() / n;
    for (std::size_t r = 0; r + 1 < count; ++r) {
        const sf::Vector2f* outer = scratch_.rings.data() + r * n;
        const sf::Vector2f* inner = outer + n;
        CanvasVertex* out = start_strip(2 * (n + 1), outer[0]);
        for (std::size_t i = 0; i <= n; ++i) {
            const std::size_t at = i == n ? 0 : i;
            *out++ = plain(outer[at], scratch_.ring_colors[r]);
            *out++ = plain(inner[at], scratch_.ring_colors[r + 1]);
        }
    }
    if (!filled || n < 3) return;
    // A convex polygon as one strip: zigzag from one end to the other.
    const sf::Vector2f* inside = scratch_.rings.data() + (count - 1) * n;
    const sf::Color color = scratch_.ring_colors[count - 1];
    CanvasVertex* out = start_strip(n, inside[0]);
    *out++ = plain(inside[0], color);
    for (std::size_t low = 1, high = n - 1; low <= high; ++low, --high) {
        *out++ = plain(inside[low], color);
        if (high > low) *out++ = plain(inside[high], color);
    }
}

/// For any outline: draws the inside first, then the rim over it, which hides the steps of the
/// pixel rows.
void Canvas::draw_any_outline(const Paint& paint) {
    if (outline_.size() < 3) return;
    const BorderRings rim =
        outline_.goes_round_once() ? BorderRings::inside(paint) : BorderRings::on_both_sides(paint);
    if (rim.fill.a > 0) {
        scratch_.rings.clear();
        outline_.ring(rim.depth, scratch_.rings);
        scratch_.area.clear();
        scratch_.area.add(scratch_.rings);
        draw_inside(outline_.goes_round_once() ? Area::Rule::forward : Area::Rule::any_way,
                    rim.fill);
    }
    draw_border(rim, outline_.bends(), true);
}

void Canvas::draw_inside(Area::Rule rule, sf::Color color) {
    scratch_.trapezoids.clear();
    scratch_.area.cut(rule, 0, static_cast<int>(height()), scratch_.trapezoids);
    for (const Trapezoid& t : scratch_.trapezoids) {
        CanvasVertex* out = start_strip(4, {t.top_left, t.top});
        *out++ = plain({t.top_left, t.top}, color);
        *out++ = plain({t.top_right, t.top}, color);
        *out++ = plain({t.bottom_left, t.bottom}, color);
        *out++ = plain({t.bottom_right, t.bottom}, color);
    }
}

void Canvas::draw_border(const BorderRings& rim, std::span<const Bend> bends, bool closed) {
    for (std::size_t r = 0; r + 1 < rim.count; ++r) {
        const BorderRings::Ring &outer = rim.rings[r], &inner = rim.rings[r + 1];
        const std::size_t n = bends.size();
        CanvasVertex* out = start_strip(2 * (n + (closed ? 1 : 0)), outer.at(bends[0]));
        for (std::size_t i = 0; i < n + (closed ? 1 : 0); ++i) {
            const Bend& bend = bends[i == n ? 0 : i];
            *out++ = plain(outer.at(bend), outer.color);
            *out++ = plain(inner.at(bend), inner.color);
        }
    }
}

void Canvas::draw_disc(sf::Vector2f center, float radius, sf::Color color) {
    const Disc& disc = atlas_.disc(radius);
    const float half = 0.5f * disc.patch.width * radius / disc.radius;
    add_quad(center - sf::Vector2f{half, half}, center + sf::Vector2f{half, half}, disc.patch,
             color);
}

}  // namespace fettle::app
