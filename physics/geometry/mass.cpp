#include <geometry/mass.h>
#include <geometry/trigonometry.h>

namespace fettle::physics::detail {
namespace {

/// Sums the moments of parts about a fixed reference point.
struct Sum {
    double area = 0.0, first_x = 0.0, first_y = 0.0, second = 0.0;

    /// Adds a part with its centroid at (x, y) and the polar moment `own` about that centroid.
    void add(double part, double x, double y, double own) {
        area += part;
        first_x += part * x;
        first_y += part * y;
        second += own + part * (x * x + y * y);
    }
};

/// Adds a triangle with a corner in the origin. The polar moment about that corner is |a × b| / 12
/// · (a·a + a·b + b·b) (e.g. D. Eberly, "Polyhedral Mass Properties", section 2, in the plane).
void add_triangle(Sum& sum, double ax, double ay, double bx, double by) {
    const double twice = ax * by - ay * bx;
    sum.area += 0.5 * twice;
    sum.first_x += twice * (ax + bx) / 6.0;
    sum.first_y += twice * (ay + by) / 6.0;
    sum.second += twice / 12.0 * (ax * ax + ay * ay + ax * bx + ay * by + bx * bx + by * by);
}

/// Adds a circular sector with the apex (x, y), the unit bisector (ux, uy) and the opening angle
/// `alpha`. Area ½ r² α, centroid at 4 r sin(α/2) / (3 α) along the bisector, polar moment about
/// the apex ¼ r⁴ α.
void add_sector(Sum& sum, double x, double y, double ux, double uy, double alpha, double r) {
    if (!(alpha > 0.0)) return;
    const double area = 0.5 * r * r * alpha;
    const double lever = 4.0 * r * double(rotation_of(0.5 * alpha).s) / (3.0 * alpha);
    sum.add(area, x + lever * ux, y + lever * uy,
            0.25 * r * r * r * r * alpha - area * lever * lever);
}

void add_rounding(Sum& sum, std::span<const Vec2> v, Vec2 origin, double r) {
    const size_t n = v.size();
    auto edge_normal = [&](size_t i, double& nx, double& ny, double& edge) {
        const double ex = double(v[(i + 1) % n].x) - v[i].x, ey = double(v[(i + 1) % n].y) - v[i].y;
        edge = std::sqrt(ex * ex + ey * ey);
        nx = edge > 0.0 ? ey / edge : 0.0;
        ny = edge > 0.0 ? -ex / edge : 0.0;
    };
    for (size_t i = 0; i < n; ++i) {
        const double x = double(v[i].x) - origin.x, y = double(v[i].y) - origin.y;
        if (n == 1) {
            add_sector(sum, x, y, 1.0, 0.0, two_pi<double>, r);
            return;
        }
        double nx, ny, edge, px, py, previous;
        edge_normal(i, nx, ny, edge);
        edge_normal((i + n - 1) % n, px, py, previous);
        const double mx = x + 0.5 * (double(v[(i + 1) % n].x) - v[i].x) + 0.5 * r * nx;
        const double my = y + 0.5 * (double(v[(i + 1) % n].y) - v[i].y) + 0.5 * r * ny;
        sum.add(edge * r, mx, my, edge * r * (edge * edge + r * r) / 12.0);
        const double alpha =
            n == 2 ? std::numbers::pi : angle_of(px * ny - py * nx, px * nx + py * ny);
        // The bisector of two opposite normals (at the end of a capsule) is parallel to the
        // segment, and points away from it.
        double ux = n == 2 ? ny : px + nx, uy = n == 2 ? -nx : py + ny;
        const double l = std::sqrt(ux * ux + uy * uy);
        if (l > 0.0) add_sector(sum, x, y, ux / l, uy / l, alpha, r);
    }
}

}  // namespace

AreaMoments moments_of(std::span<const Vec2> vertices, float radius) {
    if (vertices.empty()) return {};
    // A point near the shape, so that nothing cancels when the shape is far from the body's origin.
    const Vec2 origin = vertices[0];
    Sum sum;
    for (size_t i = 1; i + 1 < vertices.size(); ++i) {
        const Vec2 a = vertices[i] - origin, b = vertices[i + 1] - origin;
        add_triangle(sum, a.x, a.y, b.x, b.y);
    }
    if (radius > 0.0f) add_rounding(sum, vertices, origin, radius);
    AreaMoments moments;
    if (!(sum.area > 0.0)) {
        // A line has no area; its middle is the center.
        for (Vec2 v : vertices) {
            moments.center_x += double(v.x) / double(vertices.size());
            moments.center_y += double(v.y) / double(vertices.size());
        }
        return moments;
    }
    const double cx = sum.first_x / sum.area, cy = sum.first_y / sum.area;
    moments.area = sum.area;
    moments.center_x = cx + origin.x;
    moments.center_y = cy + origin.y;
    moments.moment = sum.second - sum.area * (cx * cx + cy * cy);
    if (!(moments.moment > 0.0)) moments.moment = 0.0;
    return moments;
}

}  // namespace fettle::physics::detail
