#pragma once
// What can be seen of outlines that are much larger than the screen: arcs get as many corners as
// the part of them that can be seen needs, and everything is cut off a little outside of the
// screen. A circle of a million pixels then is as round as one of a hundred, and nothing of it is
// too large for the numbers that the graphics system computes with.

#include <span>
#include <vector>

#include <fettle/property/value.h>

namespace fettle::app {

class Sight {
  public:
    using Point = property::Vec2;  // pixels

    /// Figures reach from `lower` to `upper` where they are looked at.
    Sight(const Point& lower, const Point& upper) : lower_(lower), upper_(upper) {}

    /// Appends the arc center + a cos t + b sin t, t from `start` to `end`, without its last point.
    void arc(const Point& center, const Point& a, const Point& b, double start, double end,
             std::vector<Point>& outline) const;
    /// The outline `rounding` outside of a convex one, which may have one or two corners only.
    std::vector<Point> rounded(std::span<const Point> corners, double rounding) const;
    /// Cuts off what lies outside. Of a concave outline there may remain parts that are joined
    /// along the edge of what is seen.
    void cut(std::vector<Point>& outline) const;
    /// The same of a line; false when nothing remains.
    bool cut(Point& from, Point& to) const;

  private:
    struct Arc;
    void bend(const Arc& arc, double start, const Point& from, double end, const Point& to,
              int levels, std::vector<Point>& outline) const;

    Point lower_, upper_;
};

}  // namespace fettle::app
