// Convex hulls of points.

#include <fettle/physics/hull.h>

#include <algorithm>
#include <cmath>

namespace fettle::physics {
namespace {

struct Point {
    double x, y;
};

/// Twice the signed area of the triangle o, a, b. In double precision, the sign is correct for
/// floats unless the area is below the tolerance that is used below.
double turn(Point o, Point a, Point b) {
    return (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
}

double length(Point a, Point b) {
    return std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
}

/// Monotone chain (A. M. Andrew, "Another efficient algorithm for convex hulls in two dimensions",
/// 1979).
std::vector<Point> monotone_chain(const std::vector<Point>& sorted) {
    std::vector<Point> chain;
    auto extend = [&chain](Point p, size_t base) {
        while (chain.size() >= base + 2 && turn(chain[chain.size() - 2], chain.back(), p) <= 0.0) {
            chain.pop_back();
        }
        chain.push_back(p);
    };
    for (Point p : sorted) extend(p, 0);
    const size_t upper = chain.size() - 1;
    for (size_t i = sorted.size() - 1; i-- > 0;) extend(sorted[i], upper);
    chain.pop_back();
    return chain;
}

/// Drops corners whose distance from the line between their neighbors is within the rounding error,
/// and corners that are too near to the next one: the normal of such a short edge would consist of
/// rounding errors.
void drop_flat_corners(std::vector<Point>& hull, double extent) {
    const double flat = 2.5e-7 * extent, near = 1e-5 * extent;
    // Repeats until nothing changes, so that the hull of a hull is the same hull.
    for (size_t i = 0, kept = 0; hull.size() >= 3 && kept < hull.size();) {
        const size_t n = hull.size();
        const Point before = hull[(i + n - 1) % n];
        const Point after = hull[(i + 1) % n];
        const double chord = length(before, after);
        if (turn(before, hull[i], after) <= flat * chord || length(before, hull[i]) <= near) {
            hull.erase(hull.begin() + std::ptrdiff_t(i));
            i = i > 0 ? i - 1 : 0;
            kept = 0;
        } else {
            i = (i + 1) % n;
            ++kept;
        }
    }
}

}  // namespace

const char* describe(HullStatus status) {
    switch (status) {
        case HullStatus::ok:
            return "a convex polygon";
        case HullStatus::too_few_points:
            return "a polygon needs at least three different vertices";
        case HullStatus::collinear:
            return "all vertices of the polygon lie on one line";
        case HullStatus::not_finite:
            return "a vertex of the polygon is not a finite number";
    }
    return "";
}

HullStatus convex_hull(std::span<const Vec2> points, std::vector<Vec2>& hull) {
    std::vector<Point> sorted;
    sorted.reserve(points.size());
    for (const Vec2& p : points) {
        if (!std::isfinite(p.x) || !std::isfinite(p.y)) return HullStatus::not_finite;
        sorted.push_back({p.x, p.y});
    }
    std::sort(sorted.begin(), sorted.end(),
              [](Point a, Point b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    sorted.erase(std::unique(sorted.begin(), sorted.end(),
                             [](Point a, Point b) { return a.x == b.x && a.y == b.y; }),
                 sorted.end());
    if (sorted.size() < 3) return HullStatus::too_few_points;

    double low = sorted[0].y, high = sorted[0].y;
    for (Point p : sorted) {
        low = std::min(low, p.y);
        high = std::max(high, p.y);
    }
    const double extent = std::max(sorted.back().x - sorted.front().x, high - low);
    std::vector<Point> corners = monotone_chain(sorted);
    drop_flat_corners(corners, extent);
    if (corners.size() < 3) return HullStatus::collinear;

    hull.clear();
    for (Point p : corners) hull.emplace_back(float(p.x), float(p.y));
    return HullStatus::ok;
}

}  // namespace fettle::physics
