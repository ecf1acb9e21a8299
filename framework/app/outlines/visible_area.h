#pragma once
// Reduces outlines that are much larger than the screen to their visible part. Arcs get as many
// corners as their visible part needs, and everything is cut off slightly outside of the screen. So
// a circle of a million pixels looks as round as one of a hundred, and all coordinates stay small
// enough for the single precision of the graphics system.

#include <span>
#include <vector>

#include <fettle/property/value.h>

namespace fettle::app {

class VisibleArea {
  public:
    using Point = property::Vec2;  // pixels

    /// `lower` and `upper` are the corners of the visible area.
    VisibleArea(const Point& lower, const Point& upper) : lower_(lower), upper_(upper) {}

    /// Appends the arc center + a cos t + b sin t, t from `start` to `end`, without its last point.
    void arc(const Point& center, const Point& a, const Point& b, double start, double end,
             std::vector<Point>& outline) const;
    /// Returns the outline at the distance `rounding` outside of a convex one, which may have only
    /// one or two corners.
    std::vector<Point> rounded(std::span<const Point> corners, double rounding) const;
    /// Cuts off what lies outside of the visible area. The remaining parts of a concave outline may
    /// be connected along the edge of this area.
    void cut(std::vector<Point>& outline) const;
    /// The same for a line; returns false if nothing remains.
    bool cut(Point& from, Point& to) const;

  private:
    struct Arc;
    void bend(const Arc& arc, double start, const Point& from, double end, const Point& to,
              int levels, std::vector<Point>& outline) const;

    Point lower_, upper_;
};

}  // namespace fettle::app
