#include <lines/dashes.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace fettle::visuals {

using property::LinePiece;
using property::Painter;
using property::Vec2;

namespace {

constexpr double least_pixels = 0.5;  // of a dash that can be seen
constexpr std::size_t most_pieces = 20'000;

/// A line with corners, and its points by their distance from its beginning.
class Way {
  public:
    explicit Way(std::span<const Vec2> points) {
        for (const Vec2& point : points) {
            if (!points_.empty() && point == points_.back()) continue;
            at_.push_back(points_.empty() ? 0 : at_.back() + (point - points_.back()).length());
            points_.push_back(point);
        }
    }
    double length() const { return at_.back(); }
    std::size_t corners() const { return points_.size(); }
    double at(std::size_t corner) const { return at_[corner]; }
    const Vec2& point(std::size_t corner) const { return points_[corner]; }
    /// The corner at which the straight piece begins in which this distance is.
    std::size_t corner_before(double distance) const {
        const auto after = std::upper_bound(at_.begin() + 1, at_.end() - 1, distance);
        return static_cast<std::size_t>(after - at_.begin()) - 1;
    }
    Vec2 direction(std::size_t corner) const {
        return (points_[corner + 1] - points_[corner]) / (at_[corner + 1] - at_[corner]);
    }
    Vec2 place(double distance) const {
        const std::size_t corner = corner_before(distance);
        return points_[corner] + (distance - at_[corner]) * direction(corner);
    }

  private:
    std::vector<Vec2> points_;
    std::vector<double> at_;
};

struct Stretch {
    double from, to;
};

/// Adds the stretches of a straight piece of the line that the painter shows, each at most `fine`
/// long.
void find_seen(const Painter& painter, const Vec2& a, const Vec2& b, const Stretch& stretch,
               double fine, double margin, std::vector<Stretch>& found) {
    const Vec2 beside(margin, margin);
    if (found.size() > most_pieces || !painter.sees(a.min(b) - beside, a.max(b) + beside)) return;
    const double middle = 0.5 * (stretch.from + stretch.to);
    if (stretch.to - stretch.from <= fine || !(middle > stretch.from && middle < stretch.to)) {
        found.push_back(stretch);
        return;
    }
    const Vec2 between = 0.5 * (a + b);
    find_seen(painter, a, between, {stretch.from, middle}, fine, margin, found);
    find_seen(painter, between, b, {middle, stretch.to}, fine, margin, found);
}

/// A dash that is shorter than the line is thick lies across it, so that it keeps its length.
void add_dash(const Way& way, Stretch dash, double width, std::vector<LinePiece>& to) {
    const double length = dash.to - dash.from;
    if (length < width) {
        const double middle = 0.5 * (dash.from + dash.to);
        const Vec2 along = way.direction(way.corner_before(middle));
        const Vec2 side = 0.5 * (width - length) * Vec2(-along.y, along.x);
        to.push_back({way.place(middle) - side, way.place(middle) + side, 0.5 * length});
        return;
    }
    dash.from += 0.5 * width;
    dash.to -= 0.5 * width;
    Vec2 from = way.place(dash.from);
    const std::size_t last = way.corner_before(dash.to);
    for (std::size_t corner = way.corner_before(dash.from); corner < last; ++corner) {
        to.push_back({from, way.point(corner + 1), 0.5 * width});
        from = way.point(corner + 1);
    }
    to.push_back({from, way.place(dash.to), 0.5 * width});
}

}  // namespace

std::optional<std::vector<LinePiece>> dashes(const Painter& painter, std::span<const Vec2> points,
                                             double length, double width) {
    const Way way(points);
    std::vector<LinePiece> pieces;
    if (way.corners() < 2) return pieces;
    if (length * painter.pixels_per_unit() < least_pixels) return std::nullopt;
    std::vector<Stretch> seen;
    for (std::size_t i = 0; i + 1 < way.corners(); ++i)
        find_seen(painter, way.point(i), way.point(i + 1), {way.at(i), way.at(i + 1)}, 32 * length,
                  length + width, seen);
    double next = 0;  // number of the next dash
    for (const Stretch& stretch : seen)
        for (next = std::max(next, std::floor(stretch.from / (2 * length)));
             2 * length * next < stretch.to; ++next) {
            if (pieces.size() > most_pieces) return std::nullopt;
            const double from = 2 * length * next;
            const double to = std::min(from + length, way.length());
            // What is left of a dash at the end may be too short to look like one.
            if (to - from > 0.999 * std::min(length, width) && to > stretch.from)
                add_dash(way, {from, to}, width, pieces);
        }
    return pieces;
}

}  // namespace fettle::visuals
