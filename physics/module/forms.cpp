#include "forms.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace fettle::physics_module {
namespace {

using physics::ShapeType;
using property::Paint;
using property::Painter;
using property::Vec2;

constexpr float line_width = 3.0f;  // px

/// Points in the world; few shapes have more than there is room for without asking for memory.
class Placed {
  public:
    Placed(std::span<const physics::Vec2> local, const Frame& frame) {
        if (local.size() > some_.size()) many_.resize(local.size());
        points_ = many_.empty() ? std::span<Vec2>(some_) : std::span<Vec2>(many_);
        points_ = points_.first(local.size());
        for (std::size_t i = 0; i < local.size(); ++i) points_[i] = frame.point(local[i]);
    }
    std::span<const Vec2> points() const { return points_; }

  private:
    std::array<Vec2, 16> some_;
    std::vector<Vec2> many_;
    std::span<Vec2> points_;
};

void draw_circle(const physics::Shape& shape, const Frame& frame, const Paint& paint,
                 Painter& painter) {
    const Vec2 center = frame.point(shape.center());
    const double radius = shape.radius();
    painter.circle(center, radius, paint);
    painter.line(center, center + radius * frame.direction(), paint.border, paint.border_width);
}

/// A screen has no ellipses; this many corners are none that one sees.
void draw_ellipse(const physics::Shape& shape, const Frame& frame, const Paint& paint,
                  Painter& painter) {
    constexpr std::size_t corners = 64;
    std::array<physics::Vec2, corners> rim;
    const float c = std::cos(shape.angle()), s = std::sin(shape.angle());
    for (std::size_t i = 0; i < corners; ++i) {
        const float t = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / corners;
        const float x = shape.radius_x() * std::cos(t), y = shape.radius_y() * std::sin(t);
        rim[i] = shape.center() + physics::Vec2(c * x - s * y, s * x + c * y);
    }
    const Placed placed(rim, frame);
    painter.polygon(placed.points(), 0, paint);
    painter.line(frame.point(shape.center()), placed.points()[0], paint.border, paint.border_width);
}

void draw_lines(std::span<const Vec2> points, bool closed, const property::Color& color,
                float width, Painter& painter) {
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        painter.line(points[i], points[i + 1], color, width);
    if (closed && points.size() > 2) painter.line(points.back(), points.front(), color, width);
}

/// The inside piece by piece, the outline as a whole.
void draw_concave(const physics::Shape& shape, const Frame& frame, const Paint& paint,
                  Painter& painter) {
    Paint inside = paint;
    // No seams between the pieces of what is opaque.
    inside.border = paint.fill.a < 1 ? property::Color{0, 0, 0, 0} : paint.fill;
    inside.border_width = paint.fill.a < 1 ? 0.0f : 1.0f;
    for (const auto& piece : shape.pieces())
        painter.polygon(Placed(piece, frame).points(), 0, inside);
    draw_lines(Placed(shape.vertices(), frame).points(), true, paint.border, paint.border_width,
               painter);
}

void draw_polygon(const physics::Shape& shape, const Frame& frame, const Paint& paint,
                  Painter& painter) {
    const Placed placed(shape.vertices(), frame);
    const double rounding =
        shape.type() == ShapeType::box
            ? std::min<double>(shape.rounding(), 0.5 * std::min(shape.width(), shape.height()))
            : shape.rounding();
    if (shape.type() == ShapeType::segment && rounding == 0)
        draw_lines(placed.points(), false, paint.fill, line_width, painter);
    else
        painter.polygon(placed.points(), rounding, paint);
}

}  // namespace

void draw_form(const physics::Shape& shape, const Frame& frame, const Paint& paint,
               Painter& painter) {
    switch (shape.type()) {
        case ShapeType::circle:
            return draw_circle(shape, frame, paint, painter);
        case ShapeType::ellipse:
            return draw_ellipse(shape, frame, paint, painter);
        case ShapeType::concave:
            return draw_concave(shape, frame, paint, painter);
        case ShapeType::chain:
            return draw_lines(Placed(shape.vertices(), frame).points(), shape.closed(), paint.fill,
                              line_width, painter);
        default:
            return draw_polygon(shape, frame, paint, painter);
    }
}

}  // namespace fettle::physics_module
