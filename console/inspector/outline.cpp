#include <inspector/outline.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

#include <fettle/property/drawing.h>
#include <fettle/property/painter.h>

#include <look/theme.h>

namespace fettle::console {

using property::Handle;
using property::Type;
using property::Value;
using property::Vec2;

namespace {

std::optional<Value> read(const property::Tree& tree, Handle instance, std::string_view name,
                          Type type) {
    const property::Property* property = tree.find(instance, name);
    if (property == nullptr) return std::nullopt;
    Value value = tree.get(instance, *property);
    if (!value.is(type)) return std::nullopt;
    return value;
}

std::vector<Vec2> points_of(const Value& list) {
    std::vector<Vec2> points;
    for (const Value& value : list.list())
        if (value.is(Type::vec2)) points.push_back(value.vec2());
    return points;
}

/// A painter that draws outlines instead of figures.
class Pen : public property::Painter {
  public:
    Pen(ImDrawList& list, const ToPixels& to_pixels, double seconds)
        : list_(list), to_pixels_(to_pixels) {
        glow_ = 0.22f + 0.08f * static_cast<float>(std::sin(seconds * 4));
    }

    bool drew_anything() const { return drew_anything_; }

    void circle(const Vec2& center, double radius, const property::Paint&) override {
        arc(center, Vec2(radius, 0), Vec2(0, radius), 0, two_pi);
        stroke(true);
    }
    void ellipse(const Vec2& center, const Vec2& radii, double angle,
                 const property::Paint&) override {
        const Vec2 along(std::cos(angle), std::sin(angle)), across(-along.y(), along.x());
        arc(center, radii.x() * along, radii.y() * across, 0, two_pi);
        stroke(true);
    }
    void polygon(std::span<const Vec2> vertices, double rounding, const property::Paint&) override {
        const std::size_t n = vertices.size();
        if (rounding <= 0 || n < 2) {
            for (const Vec2& vertex : vertices) points_.push_back(pixel(vertex));
            return stroke(n > 2);
        }
        // The polygon is convex and counter-clockwise. At each corner the rounding turns from the
        // normal of one edge to the normal of the next.
        const auto normal = [&](std::size_t i) {
            const Vec2 edge = vertices[(i + 1) % n] - vertices[i % n];
            return std::atan2(-edge.x(), edge.y());
        };
        for (std::size_t i = 0; i < n; ++i) {
            const double before = normal(i + n - 1);
            double turn = std::remainder(normal(i) - before, two_pi);
            if (turn < -1) turn += two_pi;  // at the end of a line
            arc(vertices[i], Vec2(rounding, 0), Vec2(0, rounding), before, before + turn);
        }
        stroke(true);
    }
    void line(const Vec2& from, const Vec2& to, property::Color, float) override {
        points_ = {pixel(from), pixel(to)};
        stroke(false);
    }
    void point(const Vec2&, property::Color, float) override {}
    void text(const Vec2&, std::string_view, double, property::Color,
              property::TextAlign) override {}
    void part_of(std::uint64_t) override {}
    bool shows(property::Overlay) const override { return false; }
    bool sees(const Vec2&, const Vec2&) const override { return true; }
    void begin_screen() override {}
    void end_screen() override {}

  private:
    static constexpr double two_pi = 2 * std::numbers::pi;

    ImVec2 pixel(const Vec2& world) const {
        const Vec2 p = to_pixels_(world);
        return ImVec2(static_cast<float>(p.x()), static_cast<float>(p.y()));
    }
    /// Adds points of center + a cos t + b sin t; their number depends on the size on the screen.
    void arc(const Vec2& center, const Vec2& a, const Vec2& b, double start, double end) {
        const Vec2 middle = to_pixels_(center);
        const double radius = std::max((to_pixels_(center + a) - middle).norm(),
                                       (to_pixels_(center + b) - middle).norm());
        const double whole = std::clamp(4 * std::sqrt(radius), 12.0, 1024.0);
        const int segments = std::max(1, static_cast<int>(whole * (end - start) / two_pi));
        for (int i = 0; i <= segments; ++i) {
            const double t = start + (end - start) * i / segments;
            points_.push_back(pixel(center + std::cos(t) * a + std::sin(t) * b));
        }
    }
    void stroke(bool closed) {
        const auto distance = [](const ImVec2& a, const ImVec2& b) {
            return std::hypot(a.x - b.x, a.y - b.y);
        };
        // A very short last segment of a thick line would show as a spike.
        while (closed && points_.size() > 2 && distance(points_.back(), points_.front()) < 0.5f)
            points_.pop_back();
        const auto count = static_cast<int>(points_.size());
        const int flags = closed ? ImDrawFlags_Closed : 0;
        list_.AddPolyline(points_.data(), count, with_alpha(palette::accent, glow_), flags, 7);
        list_.AddPolyline(points_.data(), count, palette::accent, flags, 2);
        points_.clear();
        drew_anything_ = true;
    }

    ImDrawList& list_;
    const ToPixels& to_pixels_;
    float glow_;
    bool drew_anything_ = false;
    std::vector<ImVec2> points_;
};

}  // namespace

void draw_outline(ImDrawList& list, const property::Tree& tree, Handle instance,
                  const ToPixels& to_pixels, double seconds) {
    // A body is drawn by its shapes. A whole world gets no outline.
    const auto box = read(tree, instance, "aabb", Type::list);
    if (!box && tree.find(instance, "position") == nullptr) return;
    Pen pen(list, to_pixels, seconds);
    tree.draw(instance, pen, property::Drawing::alpha());
    if (pen.drew_anything() || !box) return;
    const std::vector<Vec2> corners = points_of(*box);
    if (corners.size() != 2) return;
    const std::array<Vec2, 4> round{corners[0], Vec2(corners[1].x(), corners[0].y()), corners[1],
                                    Vec2(corners[0].x(), corners[1].y())};
    pen.polygon(round, 0, {});
}

}  // namespace fettle::console
