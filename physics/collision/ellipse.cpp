#include <collision/ellipse.h>
#include <collision/extreme_points.h>
#include <geometry/trigonometry.h>

#include <algorithm>
#include <array>

namespace fettle::physics::detail {

Vec2 EllipseForm::support(Vec2 direction) const {
    // The gradient of the support function h(d) = √(a²(d·u)² + b²(d·v)²).
    const Vec2 other = {-axis.y, axis.x};
    const float along = first * dot(direction, axis), across = second * dot(direction, other);
    const float l = std::sqrt(along * along + across * across);
    if (!(l > 0.0f)) return center;
    return center + (first * along / l) * axis + (second * across / l) * other;
}

float EllipseForm::reach(Vec2 direction) const {
    const float along = first * dot(direction, axis), across = second * cross(axis, direction);
    return std::sqrt(along * along + across * across);
}

void write_ellipse(const Ellipse& ellipse, Vec2* vertices, Vec2* normals) {
    const Rotation q = rotation_of(ellipse.angle);
    vertices[0] = ellipse.center;
    normals[0] = {q.c, q.s};
    vertices[1] = {ellipse.radius_x, ellipse.radius_y};
}

void write_ellipse(const Ellipse& ellipse, uint32_t begin, VertexPool& pool) {
    write_ellipse(ellipse, &pool.local[begin], &pool.normals[begin]);
    pool.vertices[begin + 1] = pool.local[begin + 1];
}

Vec2 half_box(const EllipseForm& ellipse) {
    return {ellipse.reach({1.0f, 0.0f}), ellipse.reach({0.0f, 1.0f})};
}

AreaMoments moments_of(const Ellipse& ellipse) {
    const double a = ellipse.radius_x, b = ellipse.radius_y;
    AreaMoments moments;
    moments.area = std::numbers::pi * a * b;
    moments.center_x = ellipse.center.x;
    moments.center_y = ellipse.center.y;
    moments.moment = 0.25 * moments.area * (a * a + b * b);
    return moments;
}

namespace {

/// Foot point on the ellipse (x/a)² + (y/b)² = 1 with a ≥ b, for a point of the first quadrant.
/// With the parameter t of the line p = q + t·∇/2, the foot point q is (a²x/(t + a²), b²y/(t +
/// b²)). t is the greatest root of (ax/(t + a²))² + (by/(t + b²))² = 1 (D. Eberly, "Distance from a
/// Point to an Ellipse", section 2.9). That function falls and is convex beyond -b², so Newton's
/// method from the left always ascends to the root.
struct Foot {
    double x, y;
};
Foot foot_point(double a, double b, double x, double y) {
    const double aa = a * a, bb = b * b;
    if (y <= 1e-12 * b) {
        const double focal = aa - bb;
        if (a * x < focal) {
            const double share = a * x / focal;
            return {a * share, b * std::sqrt(std::max(0.0, 1.0 - share * share))};
        }
        return {a, 0.0};
    }
    double t = std::max(b * y - bb, a * x - aa);
    for (int round = 0; round < 64; ++round) {
        const double u = a * x / (t + aa), v = b * y / (t + bb);
        const double excess = u * u + v * v - 1.0;
        const double slope = -2.0 * (u * u / (t + aa) + v * v / (t + bb));
        const double step = excess / slope;
        if (!(step < 0.0)) break;
        t -= step;
        if (-step <= 1e-14 * (t + bb)) break;
    }
    return {aa * x / (t + aa), bb * y / (t + bb)};
}

}  // namespace

RimPoint nearest_on_rim(const EllipseForm& e, Vec2 p) {
    const Vec2 other = {-e.axis.y, e.axis.x};
    const Vec2 d = p - e.center;
    const double x = double(dot(d, e.axis)), y = double(dot(d, other));
    const double first = double(e.first), second = double(e.second);
    const bool swapped = second > first;
    Foot foot = swapped ? foot_point(second, first, std::fabs(y), std::fabs(x))
                        : foot_point(first, second, std::fabs(x), std::fabs(y));
    if (swapped) std::swap(foot.x, foot.y);
    const double qx = std::copysign(foot.x, x), qy = std::copysign(foot.y, y);
    const double nx = qx / (first * first), ny = qy / (second * second);
    const double l = std::sqrt(nx * nx + ny * ny);
    RimPoint rim;
    rim.point = e.center + float(qx) * e.axis + float(qy) * other;
    rim.normal = float(nx / l) * e.axis + float(ny / l) * other;
    rim.distance = float((x - qx) * nx / l + (y - qy) * ny / l);
    return rim;
}

namespace {

EllipseGap gap_at_vertex(const EllipseForm& ellipse, Vec2 vertex, int index) {
    const RimPoint rim = nearest_on_rim(ellipse, vertex);
    return {rim.normal, rim.point, vertex, rim.distance, -1, index};
}

/// True if the direction is between the normals of the edges before and after a vertex.
bool in_cone(Vec2 before, Vec2 direction, Vec2 after) {
    return cross(before, direction) >= -1e-6f && cross(direction, after) >= -1e-6f;
}

/// The gap at the vertex with the greatest separation (the least depth) of ellipse and polygon;
/// `otherwise` if no vertex has a greater one. In the frame in which the ellipse is the unit
/// circle, distances from the center show which vertices come into question.
EllipseGap gap_at_best_vertex(const EllipseForm& ellipse, const Convex& other, Vec2 offset,
                              const EllipseGap& otherwise) {
    const auto on_circle = [&](int i) {
        const Vec2 d = other.vertices[i] + offset - ellipse.center;
        return Vec2{dot(d, ellipse.axis) / ellipse.first, cross(ellipse.axis, d) / ellipse.second};
    };
    const Vec2 center = ellipse.center - offset;
    float nearest = 1e30f;
    bool centered = other.count > 2;  // the center of the ellipse is inside
    for (int i = 0; i < other.count; ++i) {
        const Vec2 a = on_circle(i), along = on_circle(i + 1 < other.count ? i + 1 : 0) - a;
        const float l = length_squared(along);
        const float t = l > 0.0f ? clamp(-dot(a, along) / l, 0.0f, 1.0f) : 0.0f;
        nearest = min(nearest, length_squared(a + t * along));
        centered = centered && dot(other.normals[i], center) <= other.offsets[i];
    }
    EllipseGap best = otherwise;
    if (centered) return best;
    const bool apart = nearest > 1.0f;
    for (int i = 0; i < other.count; ++i) {
        if (!apart && length_squared(on_circle(i)) > 1.0f) continue;
        const EllipseGap gap = gap_at_vertex(ellipse, other.vertices[i] + offset, i);
        const int previous = i > 0 ? i - 1 : other.count - 1;
        if (gap.separation > best.separation &&
            in_cone(other.normals[previous], -gap.normal, other.normals[i]))
            best = gap;
    }
    return best;
}

}  // namespace

EllipseGap gap_between(const EllipseForm& ellipse, const Convex& other, Vec2 offset) {
    if (other.count == 1) return gap_at_vertex(ellipse, other.vertices[0] + offset, 0);
    const Vec2 center = ellipse.center - offset;
    const auto [edge, best] = deepest_edge(
        Facets(other), center, [&](Vec2 n) { return dot(n, center) - ellipse.reach(n); });
    // The separation along a direction is greatest at this normal, or in the cone of one of its two
    // vertices: the one beyond which the deepest point of the ellipse is.
    const int next = edge + 1 < other.count ? edge + 1 : 0;
    const Vec2 n = other.normals[edge];
    const Vec2 v1 = other.vertices[edge] + offset, v2 = other.vertices[next] + offset;
    const Vec2 deepest = ellipse.support(-n);
    const Vec2 along = v2 - v1;
    const bool before = dot(deepest - v1, along)<0.0f, after = dot(deepest - v2, along)> 0.0f;
    if (before || after) {
        const int vertex = before ? edge : next;
        const int previous = vertex > 0 ? vertex - 1 : other.count - 1;
        const EllipseGap gap = gap_at_vertex(ellipse, before ? v1 : v2, vertex);
        if (in_cone(other.normals[previous], -gap.normal, other.normals[vertex])) return gap;
    }
    const EllipseGap gap = {-n, deepest, deepest - best * n, best, edge, -1};
    // Beyond a tip, all edges overlap the ellipse: then the greatest separation may be elsewhere.
    return best < 0.0f ? gap_at_best_vertex(ellipse, other, offset, gap) : gap;
}

EllipseGap gap_between(const EllipseForm& ellipse, const EllipseForm& other, Vec2 offset) {
    // s(d) = d·c - h(d) - k(d) is the separation along a direction d. Its maximum over all
    // directions is the distance, or minus the depth. Its slope along the circle of directions is
    // d⊥·(the chord between the two support points). Directions that are evenly spaced on the rims
    // are dense where an ellipse is flat. The best of them and its neighbors enclose the maximum.
    const Vec2 c = other.center + offset - ellipse.center;
    const auto separation = [&](Vec2 d) { return dot(d, c) - ellipse.reach(d) - other.reach(d); };
    constexpr int samples = 16;
    constexpr float cosines[samples / 4 + 1] = {1.0f, 0.92387953f, 0.70710678f, 0.38268343f, 0.0f};
    std::array<Vec2, 2 * samples + 1> directions;
    size_t count = 0;
    for (const EllipseForm* form : {&ellipse, &other}) {
        const Vec2 across = {-form->axis.y, form->axis.x};
        for (int i = 0; i < samples; ++i) {
            const int k = i % 4;
            float x = cosines[k], y = cosines[4 - k];
            for (int turns = i / 4; turns > 0; --turns) {
                const float kept = x;
                x = -y;
                y = kept;
            }
            directions[count++] =
                normalized((form->second * x) * form->axis + (form->first * y) * across);
        }
    }
    if (length_squared(c) > 0.0f) directions[count++] = normalized(c);
    // Increases with the angle, from 0 to 4 for a full turn.
    const auto turned = [](Vec2 d) {
        const float k = d.x / (std::fabs(d.x) + std::fabs(d.y));
        return d.y >= 0.0f ? 1.0f - k : 3.0f + k;
    };
    std::sort(directions.begin(), directions.begin() + std::ptrdiff_t(count),
              [&](Vec2 a, Vec2 b) { return turned(a) < turned(b); });
    size_t best = 0;
    float greatest = -1e30f;
    for (size_t i = 0; i < count; ++i) {
        const float s = separation(directions[i]);
        if (s > greatest) {
            greatest = s;
            best = i;
        }
    }
    Vec2 low = directions[(best + count - 1) % count], high = directions[(best + 1) % count];
    Vec2 d = directions[best];
    for (int round = 0; round < 32; ++round) {
        const Vec2 chord =
            c + (other.support(-d) - other.center) - (ellipse.support(d) - ellipse.center);
        const float slope = cross(d, chord);
        (slope > 0.0f ? low : high) = d;
        const Vec2 middle = normalized(low + high);
        if (cross(low, high) < 1e-7f || length_squared(middle) == 0.0f) break;
        d = middle;
    }
    if (separation(d) < greatest) d = directions[best];
    EllipseGap gap;
    gap.normal = d;
    gap.on_ellipse = ellipse.support(d);
    gap.on_other = other.support(-d) + offset;
    gap.separation = separation(d);
    return gap;
}

}  // namespace fettle::physics::detail
