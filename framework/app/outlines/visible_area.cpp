#include <outlines/visible_area.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <outlines/outline.h>

namespace fettle::app {

namespace {

using Point = VisibleArea::Point;

double cross(const Point& a, const Point& b) {
    return a.x * b.y - a.y * b.x;
}

}  // namespace

struct VisibleArea::Arc {
    Point center, a, b;
    Point at(double t) const { return center + std::cos(t) * a + std::sin(t) * b; }
};

void VisibleArea::arc(const Point& center, const Point& a, const Point& b, double start, double end,
                      std::vector<Point>& outline) const {
    const Arc whole{center, a, b};
    constexpr double quarter = std::numbers::pi / 2;
    constexpr int max_levels = 48;
    const int pieces = std::max(1, static_cast<int>(std::ceil((end - start) / quarter - 1e-9)));
    Point from = whole.at(start);
    for (int i = 0; i < pieces; ++i) {
        const double t0 = start + (end - start) * i / pieces;
        const double t1 = start + (end - start) * (i + 1) / pieces;
        const Point to = whole.at(t1);
        outline.push_back(from);
        bend(whole, t0, from, t1, to, max_levels, outline);
        from = to;
    }
}

/// Appends the points between two points of an arc, unless the chord differs invisibly from the arc
/// or the piece is not visible.
void VisibleArea::bend(const Arc& arc, double start, const Point& from, double end, const Point& to,
                       int levels, std::vector<Point>& outline) const {
    const double t = 0.5 * (start + end);
    const Point middle = arc.at(t);
    if (levels == 0 ||
        (middle - 0.5 * (from + to)).length_squared() < chord_tolerance * chord_tolerance)
        return;
    // The arc lies between the chord and the intersection of the tangents at its ends.
    const Point tip = arc.center + (middle - arc.center) / std::cos(0.5 * (end - start));
    const Point lower = from.min(to).min(tip), upper = from.max(to).max(tip);
    if (upper.x < lower_.x || upper.y < lower_.y || lower.x > upper_.x || lower.y > upper_.y)
        return;
    bend(arc, start, from, t, middle, levels - 1, outline);
    outline.push_back(middle);
    bend(arc, t, middle, end, to, levels - 1, outline);
}

std::vector<Point> VisibleArea::rounded(std::span<const Point> corners, double rounding) const {
    std::vector<Point> given, outline;
    for (const Point& corner : corners)
        if (given.empty() || corner != given.back()) given.push_back(corner);
    while (given.size() > 1 && given.front() == given.back()) given.pop_back();
    const std::size_t n = given.size();
    if (n == 0) return outline;
    const Point a(rounding, 0), b(0, rounding);
    if (n == 1) {
        arc(given[0], a, b, 0, 2 * std::numbers::pi, outline);
        return outline;
    }
    double area = 0;
    for (std::size_t i = 0; i < n; ++i)
        area += cross(given[i] - given[0], given[(i + 1) % n] - given[0]);
    if (area < 0) std::reverse(given.begin(), given.end());
    const auto direction = [&](std::size_t i) {  // of the normal of the edge from corner i
        const Point edge = given[(i + 1) % n] - given[i % n];
        return std::atan2(-edge.x, edge.y);
    };
    for (std::size_t i = 0; i < n; ++i) {
        const double before = direction(i + n - 1);
        double turn = std::remainder(direction(i) - before, 2 * std::numbers::pi);
        if (turn < -1) turn += 2 * std::numbers::pi;  // the end of a line: half a turn
        turn = std::max(turn, 0.0);
        arc(given[i], a, b, before, before + turn, outline);
        outline.push_back(given[i] + std::cos(before + turn) * a + std::sin(before + turn) * b);
    }
    return outline;
}

void VisibleArea::cut(std::vector<Point>& outline) const {
    std::vector<Point> kept;
    const auto side = [&](int axis, double limit, double sign) {
        kept.clear();
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const Point& from = outline[i];
            const Point& to = outline[i + 1 < outline.size() ? i + 1 : 0];
            const double start = sign * (limit - from[axis]), end = sign * (limit - to[axis]);
            if (start >= 0) kept.push_back(from);
            if ((start >= 0) == (end >= 0)) continue;
            Point crossing = from + start / (start - end) * (to - from);
            crossing[axis] = limit;
            kept.push_back(crossing);
        }
        std::swap(outline, kept);
    };
    for (const int axis : {0, 1}) {
        side(axis, upper_[axis], 1);
        side(axis, lower_[axis], -1);
    }
}

bool VisibleArea::cut(Point& from, Point& to) const {
    const Point along = to - from;
    double begin = 0, end = 1;
    for (const int axis : {0, 1}) {
        if (along[axis] == 0) {
            if (from[axis] < lower_[axis] || from[axis] > upper_[axis]) return false;
            continue;
        }
        const double a = (lower_[axis] - from[axis]) / along[axis];
        const double b = (upper_[axis] - from[axis]) / along[axis];
        begin = std::max(begin, std::min(a, b));
        end = std::min(end, std::max(a, b));
    }
    if (begin > end) return false;
    to = from + end * along;
    from += begin * along;
    return true;
}

}  // namespace fettle::app
