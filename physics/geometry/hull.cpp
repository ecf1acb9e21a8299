// Convex hulls of points.

#include <fettle/physics/hull.h>
#include <geometry/orientation.h>

#include <algorithm>
#include <cmath>

namespace fettle::physics {
namespace {

using detail::orientation;

double length(Vec2 a, Vec2 b) {
    const double x = double(b.x) - double(a.x), y = double(b.y) - double(a.y);
    return std::sqrt(x * x + y * y);
}

/// Drops corners whose distance from the line between their neighbors is within the rounding error,
/// and corners that are too near to the next one: the normal of such a short edge would consist of
/// rounding errors.
void drop_flat_corners(std::vector<Vec2>& hull, double extent) {
    const double flat = 2.5e-7 * extent, near = 1e-5 * extent;
    // Repeats until nothing changes, so that the hull of a hull is the same hull.
    for (size_t i = 0, kept = 0; hull.size() >= 3 && kept < hull.size();) {
        const size_t n = hull.size();
        const Vec2 before = hull[(i + n - 1) % n];
        const Vec2 after = hull[(i + 1) % n];
        const double chord = length(before, after);
        if (orientation(before, hull[i], after) <= flat * chord ||
            length(before, hull[i]) <= near) {
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
    for (const Vec2& p : points)
        if (!std::isfinite(p.x) || !std::isfinite(p.y)) return HullStatus::not_finite;
    std::vector<Vec2> sorted(points.begin(), points.end());
    std::sort(sorted.begin(), sorted.end(),
              [](Vec2 a, Vec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    if (sorted.size() < 3) return HullStatus::too_few_points;

    double low = double(sorted[0].y), high = low;
    for (const Vec2 p : sorted) {
        low = std::min(low, double(p.y));
        high = std::max(high, double(p.y));
    }
    const double extent = std::max(double(sorted.back().x) - double(sorted.front().x), high - low);
    std::vector<Vec2> corners = detail::monotone_chain(sorted, [](Vec2 p) { return p; });
    drop_flat_corners(corners, extent);
    if (corners.size() < 3) return HullStatus::collinear;
    hull = std::move(corners);
    return HullStatus::ok;
}

}  // namespace fettle::physics
