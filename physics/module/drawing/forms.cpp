#include <drawing/forms.h>

#include <algorithm>
#include <array>

namespace fettle::physics_module {
namespace {

using physics::ShapeType;
using property::Paint;
using property::Painter;
using property::Vec2;

constexpr float line_width = 3.0f;  // px

/// Points in the world; most shapes fit into the array and allocate nothing.
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

void draw_lines(std::span<const Vec2> points, bool closed, const property::Color& color,
                float width, Painter& painter) {
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        painter.line(points[i], points[i + 1], color, width);
    if (closed && points.size() > 2) painter.line(points.back(), points.front(), color, width);
}

double rounding_of(const physics::Shape& shape) {
    if (shape.type() != ShapeType::box) return shape.rounding();
    return std::min<double>(shape.rounding(), 0.5 * std::min(shape.width(), shape.height()));
}

Vec2 radii_of(const physics::Shape& shape) {
    if (shape.type() == ShapeType::ellipse) return widen(shape.radius_x(), shape.radius_y());
    return widen(shape.radius(), shape.radius());
}

bool is_round(const physics::Shape& shape) {
    return shape.type() == ShapeType::circle || shape.type() == ShapeType::ellipse;
}

/// Angle of the shape relative to its body.
double angle_of(const physics::Shape& shape) {
    return shape.type() == ShapeType::ellipse ? static_cast<double>(shape.angle()) : 0.0;
}

void draw_polygon(const physics::Shape& shape, const Frame& frame, const Paint& paint,
                  Painter& painter) {
    const Placed placed(shape.vertices(), frame);
    const double rounding = rounding_of(shape);
    if (is_line(shape))
        draw_lines(placed.points(), false, paint.fill, line_width, painter);
    else
        painter.polygon(placed.points(), rounding, paint);
}

}  // namespace

bool is_line(const physics::Shape& shape) {
    return shape.type() == ShapeType::chain ||
           (shape.type() == ShapeType::segment && rounding_of(shape) == 0);
}

Extent extent_of(const physics::Shape& shape, const Frame& frame) {
    if (is_round(shape)) {
        const Vec2 radii = radii_of(shape), middle = frame.point(shape.center());
        const double turned = frame.angle() + angle_of(shape);
        const double c = std::cos(turned), s = std::sin(turned);
        const Vec2 reach(std::hypot(radii.x * c, radii.y * s),
                         std::hypot(radii.x * s, radii.y * c));
        return {middle - reach, middle + reach};
    }
    Extent extent{frame.position(), frame.position()};
    bool first = true;
    for (const physics::Vec2& vertex : shape.vertices()) {
        const Vec2 point = frame.point(vertex);
        extent.lower = first ? point : Vec2(extent.lower.min(point));
        extent.upper = first ? point : Vec2(extent.upper.max(point));
        first = false;
    }
    const bool lines = shape.type() == ShapeType::chain || shape.type() == ShapeType::concave;
    const double rounding = lines ? 0.0 : rounding_of(shape);
    const Vec2 reach(rounding, rounding);
    return {extent.lower - reach, extent.upper + reach};
}

void draw_form(const physics::Shape& shape, const Frame& frame, const Paint& paint,
               Painter& painter) {
    switch (shape.type()) {
        case ShapeType::circle:
            return painter.circle(frame.point(shape.center()), shape.radius(), paint);
        case ShapeType::ellipse:
            return painter.ellipse(frame.point(shape.center()), radii_of(shape),
                                   frame.angle() + angle_of(shape), paint);
        case ShapeType::concave:
            return painter.polygon(Placed(shape.vertices(), frame).points(), 0, paint);
        case ShapeType::chain:
            return draw_lines(Placed(shape.vertices(), frame).points(), shape.closed(), paint.fill,
                              line_width, painter);
        default:
            return draw_polygon(shape, frame, paint, painter);
    }
}

void draw_mark(const physics::Shape& shape, const Frame& frame, const Paint& paint,
               Painter& painter) {
    if (!is_round(shape)) return;
    const Vec2 middle = frame.point(shape.center());
    const double turned = frame.angle() + angle_of(shape);
    const Vec2 rim = middle + radii_of(shape).x * Vec2(std::cos(turned), std::sin(turned));
    painter.line(middle, rim, paint.border, paint.border_width);
}

}  // namespace fettle::physics_module
