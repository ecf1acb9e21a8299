#include <look/pen.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace fettle::console {

using property::Vec2;

namespace {

constexpr double two_pi = 2 * std::numbers::pi;

ImU32 color_of(const property::Color& color, float opacity) {
    const auto byte = [](float part) {
        return static_cast<int>(std::lround(255 * std::clamp(part, 0.0f, 1.0f)));
    };
    return IM_COL32(byte(color.r), byte(color.g), byte(color.b), byte(color.a * opacity));
}

bool is_convex(const std::vector<ImVec2>& points) {
    int left = 0, right = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const ImVec2 &a = points[i], &b = points[(i + 1) % points.size()],
                     &c = points[(i + 2) % points.size()];
        const float cross = (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x);
        if (cross > 1e-3f) ++left;
        if (cross < -1e-3f) ++right;
    }
    return left == 0 || right == 0;
}

}  // namespace

void Pen::circle(const Vec2& center, double radius, const property::Paint& paint) {
    arc(center, Vec2(radius, 0), Vec2(0, radius), 0, two_pi);
    stroke(true, paint);
}

void Pen::ellipse(const Vec2& center, const Vec2& radii, double angle,
                  const property::Paint& paint) {
    const Vec2 along(std::cos(angle), std::sin(angle)), across(-along.y, along.x);
    arc(center, radii.x * along, radii.y * across, 0, two_pi);
    stroke(true, paint);
}

void Pen::polygon(std::span<const Vec2> vertices, double rounding, const property::Paint& paint) {
    const std::size_t n = vertices.size();
    if (rounding <= 0 || n < 2) {
        for (const Vec2& vertex : vertices) points_.push_back(pixel(vertex));
        return stroke(n > 2, paint);
    }
    // The polygon is convex and counter-clockwise. At each corner the rounding turns from the
    // normal of one edge to the normal of the next.
    const auto normal = [&](std::size_t i) {
        const Vec2 edge = vertices[(i + 1) % n] - vertices[i % n];
        return std::atan2(-edge.x, edge.y);
    };
    for (std::size_t i = 0; i < n; ++i) {
        const double before = normal(i + n - 1);
        double turn = std::remainder(normal(i) - before, two_pi);
        if (turn < -1) turn += two_pi;  // at the end of a line
        arc(vertices[i], Vec2(rounding, 0), Vec2(0, rounding), before, before + turn);
    }
    stroke(true, paint);
}

void Pen::line(const Vec2& from, const Vec2& to, property::Color color, float width) {
    points_ = {pixel(from), pixel(to)};
    stroke(false, {.fill = {0, 0, 0, 0}, .border = color, .border_width = width});
}

double Pen::pixels_per_unit() const {
    const ImVec2 from = pixel({0, 0}), to = pixel({1, 0});
    return std::hypot(static_cast<double>(to.x - from.x), static_cast<double>(to.y - from.y));
}

/// Each row of pixels becomes a few boxes.
void Pen::letter(const property::Picture& picture, const Vec2& lower, const Vec2& upper,
                 const property::Color& tint) {
    const std::uint32_t wide = picture.width(), high = picture.height();
    const std::vector<std::uint8_t>& rgba = picture.rgba();
    const double down = on_screen() ? 1 : -1;  // rows begin at the top
    const Vec2 size = upper - lower, corner(lower.x, down > 0 ? lower.y : upper.y);
    const auto at = [&](std::uint32_t x, std::uint32_t y) {
        return pixel(corner + Vec2(size.x * x / wide, down * size.y * y / high));
    };
    constexpr int steps = 4;  // of opacity
    for (std::uint32_t y = 0; y < high; ++y)
        for (std::uint32_t x = 0, end = 0; x < wide; x = end) {
            const auto covered = [&](std::uint32_t column) {
                return (rgba[4 * (std::size_t{y} * wide + column) + 3] * steps + 127) / 255;
            };
            const int cover = covered(x);
            for (end = x + 1; end < wide && covered(end) == cover;) ++end;
            if (cover == 0) continue;
            const float share = style_.opacity * static_cast<float>(cover) / steps;
            list_.AddQuadFilled(at(x, y), at(end, y), at(end, y + 1), at(x, y + 1),
                                color_of(tint, share));
        }
    owners_.insert(owner_);
}

void Pen::textured(const property::Picture& picture, const property::PictureArea& area,
                   const Vec2& lower, const Vec2& upper, const property::Color& tint) {
    owners_.insert(owner_);
    const property::Blend blend = state().blend;
    if (blend == property::Blend::multiply) return;
    constexpr float pale = 0.5f;
    const float opacity =
        style_.opacity * state().opacity * (blend == property::Blend::add ? pale : 1);
    // On the screen, y points down.
    const double top = on_screen() ? lower.y : upper.y, bottom = on_screen() ? upper.y : lower.y;
    const auto at = [&](double x, double y) {
        return ImVec2(static_cast<float>(x / picture.width()),
                      static_cast<float>(y / picture.height()));
    };
    // Half a pixel within the area, so that its neighbors in the picture are not seen.
    const auto left_over = [](double size, std::uint32_t all) {
        return size < all ? std::min(0.5, 0.5 * size) : 0;
    };
    const double in_x = left_over(area.width, picture.width()),
                 in_y = left_over(area.height, picture.height());
    const double left = area.left + in_x, right = area.left + area.width - in_x;
    const double high = area.top + in_y, low = area.top + area.height - in_y;
    list_.AddImageQuad(style_.pictures->number(picture), pixel({lower.x, top}),
                       pixel({upper.x, top}), pixel({upper.x, bottom}), pixel({lower.x, bottom}),
                       at(left, high), at(right, high), at(right, low), at(left, low),
                       color_of(tint, opacity));
}

void Pen::picture(const property::Picture& picture, const property::PictureArea& area,
                  const Vec2& lower, const Vec2& upper, property::Color tint, bool) {
    if (tint.a <= 0) return;
    if (!style_.as_drawn) {
        for (const Vec2& corner : {lower, Vec2(upper.x, lower.y), upper, Vec2(lower.x, upper.y)})
            pictures_[owner_].push_back(pixel(corner));
        return;
    }
    if (picture.on_pixels()) return letter(picture, lower, upper, tint);
    if (style_.pictures != nullptr && GamePictures::fits(picture))
        return textured(picture, area, lower, upper, tint);
    for (const Vec2& corner : {lower, Vec2(upper.x, lower.y), upper, Vec2(lower.x, upper.y)})
        points_.push_back(pixel(corner));
    const auto faint = [&](float share) {
        return property::Color{tint.r, tint.g, tint.b, tint.a * share};
    };
    stroke(true, {.fill = faint(0.08f), .border = faint(0.8f), .border_width = 1});
}

void Pen::outline_pictures() {
    constexpr std::size_t corners = 4;
    for (auto& [owner, all] : std::exchange(pictures_, {})) {
        if (owners_.contains(owner)) continue;
        points_ = all;
        if (points_.size() > corners) {
            ImVec2 low = points_.front(), high = low;
            for (const ImVec2& at : points_) {
                low = ImVec2(std::min(low.x, at.x), std::min(low.y, at.y));
                high = ImVec2(std::max(high.x, at.x), std::max(high.y, at.y));
            }
            points_ = {low, ImVec2(high.x, low.y), high, ImVec2(low.x, high.y)};
        }
        owner_ = owner;
        stroke(true, {});
    }
}

ImVec2 Pen::pixel(const Vec2& at) const {
    const Vec2 p = on_screen() ? transform()(at) : to_pixels_(map_(transform()(at)));
    return ImVec2(static_cast<float>(p.x), static_cast<float>(p.y));
}

void Pen::arc(const Vec2& center, const Vec2& a, const Vec2& b, double start, double end) {
    const auto length = [&](const Vec2& way) {
        const ImVec2 from = pixel(center), to = pixel(center + way);
        return std::hypot(static_cast<double>(to.x - from.x), static_cast<double>(to.y - from.y));
    };
    // The outline is nowhere further from the circle than a third of a pixel.
    const double whole = std::clamp(4 * std::sqrt(std::max(length(a), length(b))), 8.0, 1024.0);
    const int segments = std::max(1, static_cast<int>(whole * (end - start) / two_pi));
    for (int i = 0; i <= segments; ++i) {
        const double t = start + (end - start) * i / segments;
        points_.push_back(pixel(center + std::cos(t) * a + std::sin(t) * b));
    }
}

void Pen::stroke(bool closed, const property::Paint& paint) {
    const auto distance = [](const ImVec2& a, const ImVec2& b) {
        return std::hypot(a.x - b.x, a.y - b.y);
    };
    // A very short last segment of a thick line would show as a spike.
    while (closed && points_.size() > 2 && distance(points_.back(), points_.front()) < 0.5f)
        points_.pop_back();
    const auto count = static_cast<int>(points_.size());
    const int flags = closed ? ImDrawFlags_Closed : 0;
    const bool hidden = paint.fill.a <= 0 && paint.border.a <= 0;
    if (style_.as_drawn && !hidden) {
        // An outline that is not convex has its border only.
        const float opacity = style_.opacity * state().opacity;
        if (closed && paint.fill.a > 0 && is_convex(points_))
            list_.AddConvexPolyFilled(points_.data(), count, color_of(paint.fill, opacity));
        const bool border = paint.border.a > 0 && paint.border_width > 0;
        list_.AddPolyline(points_.data(), count,
                          color_of(border ? paint.border : paint.fill, opacity), flags,
                          border ? paint.border_width : 1.5f);
    } else {
        if (style_.glow != 0)
            list_.AddPolyline(points_.data(), count, style_.glow, flags, style_.glow_width);
        list_.AddPolyline(points_.data(), count, style_.color, flags, style_.width);
    }
    points_.clear();
    owners_.insert(owner_);
}

}  // namespace fettle::console
