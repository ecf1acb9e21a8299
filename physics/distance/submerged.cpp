#include <collision/ellipse.h>
#include <distance/distance.h>
#include <geometry/trigonometry.h>

#include <algorithm>
#include <cmath>

// In the frame of the surface, with x along it and w the height above it, Green's theorem converts
// the integrals over the part below into integrals along the boundary:
//
//     A = ∬ dA = -∮ w dx,   ∬ x dA = -∮ x·w dx,   ∬ w dA = -∮ w²/2 dx.
//
// The chord that closes the part has w = 0, where all three integrals are 0. So it is enough to
// follow the edges and arcs of the shape and to omit everything above the surface.

namespace fettle::physics::detail {
namespace {

struct Integrals {
    double area = 0.0, x = 0.0, w = 0.0;

    void add(const Integrals& o, double sign = 1.0) {
        area += sign * o.area;
        x += sign * o.x;
        w += sign * o.w;
    }
};

struct Place {
    double x = 0.0, w = 0.0;
};

/// Integrals along the part of a straight section of the boundary that is below.
Integrals of_segment(Place p, Place q) {
    if (p.w >= 0.0 && q.w >= 0.0) return {};
    if (p.w > 0.0 || q.w > 0.0) {
        const double t = p.w / (p.w - q.w);
        const Place cut = {p.x + t * (q.x - p.x), 0.0};
        (p.w > 0.0 ? p : q) = cut;
    }
    const double dx = q.x - p.x;
    return {-dx * (p.w + q.w) / 2,
            -dx * (2 * p.x * p.w + p.x * q.w + q.x * p.w + 2 * q.x * q.w) / 6,
            -dx * (p.w * p.w + p.w * q.w + q.w * q.w) / 6};
}

/// Antiderivatives along the circle x = c.x + r·cos θ, w = c.w + r·sin θ, dx = -r·sin θ dθ.
Integrals on_circle(Place c, double r, double angle) {
    const Rotation q = rotation_of(angle);
    const double cosine = double(q.c), s = double(q.s), half = (angle - s * cosine) / 2;
    Integrals i;
    i.area = r * (-c.w * cosine + r * half);
    i.x = r * (-c.x * c.w * cosine + c.x * r * half + r * c.w * s * s / 2 + r * r * s * s * s / 3);
    i.w = r / 2 *
          (-c.w * c.w * cosine + 2 * c.w * r * half +
           r * r * (cosine * cosine * cosine / 3 - cosine));
    return i;
}

Integrals of_arc(Place center, double r, double from, double sweep) {
    constexpr double turn = two_pi<double>;
    const double high = -center.w / r;  // the arc is below where sin θ is smaller than this
    Integrals sum;
    const auto add = [&](double a, double b) {
        if (b <= a) return;
        sum.add(on_circle(center, r, b));
        sum.add(on_circle(center, r, a), -1.0);
    };
    if (high <= -1.0) return sum;
    if (high >= 1.0) {
        add(from, from + sweep);
        return sum;
    }
    const double edge = angle_of(high, std::sqrt(1.0 - high * high));
    for (int k = -2; k <= 1; ++k) {
        add(std::max(from, turn / 2 - edge + turn * k),
            std::min(from + sweep, turn + edge + turn * k));
    }
    return sum;
}

}  // namespace

AreaPart part_below(const Convex& shape, Vec2 normal, double depth) {
    const Vec2 along = right_perp(normal);
    const auto place = [&](Vec2 p) {
        return Place{double(dot(along, p)), double(dot(normal, p)) - depth};
    };
    constexpr double turn = two_pi<double>;
    const double r = double(shape.radius);
    Integrals sum;
    if (shape.count == 1 && r > 0.0) sum = of_arc(place(shape.vertices[0]), r, 0.0, turn);
    for (int i = 0; shape.count > 1 && i < shape.count; ++i) {
        const int next = i + 1 < shape.count ? i + 1 : 0;
        const Vec2 n = shape.normals[i], m = shape.normals[next];
        sum.add(of_segment(place(shape.vertices[i] + shape.radius * n),
                           place(shape.vertices[next] + shape.radius * n)));
        if (!(r > 0.0)) continue;
        const double from = angle_of(double(dot(normal, n)), double(dot(along, n)));
        double sweep = angle_of(double(cross(n, m)), double(dot(n, m)));
        if (sweep < -1e-3) sweep += turn;  // after rounding, half a turn may be negative
        sum.add(of_arc(place(shape.vertices[next]), r, from, std::max(sweep, 0.0)));
    }
    if (!(sum.area > 1e-12)) return {};
    const auto x = float(sum.x / sum.area), w = float(sum.w / sum.area + depth);
    return {sum.area, x * along + w * normal};
}

namespace {

/// The ellipse is transformed to a unit circle. Half-planes stay half-planes, and ratios of areas
/// do not change.
AreaPart part_of_ellipse(const EllipseForm& e, Vec2 normal, double depth) {
    const float reach = e.reach(normal);
    const Vec2 across = {-e.axis.y, e.axis.x};
    const Vec2 n = {e.first * dot(normal, e.axis) / reach, e.second * dot(normal, across) / reach};
    const Vec2 origin;
    const Convex circle = {&origin, nullptr, nullptr, 1, 1.0f};
    const double height = (depth - double(dot(normal, e.center))) / double(reach);
    const AreaPart part = part_below(circle, n, height);
    return {
        part.area * double(e.first) * double(e.second),
        e.center + (e.first * part.centroid.x) * e.axis + (e.second * part.centroid.y) * across};
}

}  // namespace

AreaPart part_below(const Solid& shape, Vec2 normal, double depth) {
    if (shape.kind == FormKind::large) {
        AreaPart part = part_below(shape.form, unrotate(shape.rotation, normal), depth);
        part.centroid = rotate(shape.rotation, part.centroid);
        return part;
    }
    return shape.kind == FormKind::ellipse ? part_of_ellipse(ellipse_of(shape.form), normal, depth)
                                           : part_below(shape.form, normal, depth);
}

}  // namespace fettle::physics::detail
