#include "wild/checks/outlines.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fettle::bench::wild {
namespace {

double cross(const Vec2& a, const Vec2& b) {
    return double(a.x) * b.y - double(a.y) * b.x;
}

double twice_area(const std::vector<Vec2>& points) {
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        sum += cross(points[i], points[(i + 1) % points.size()]);
    return sum;
}

/// The edges of a solid, whose front is outside.
std::vector<Edge> around(std::vector<Vec2> points) {
    if (twice_area(points) > 0) std::ranges::reverse(points);
    std::vector<Edge> edges;
    for (std::size_t i = 0; i < points.size(); ++i)
        edges.push_back({points[i], points[(i + 1) % points.size()]});
    return edges;
}

/// A polygon inside an ellipse, of edges short enough that the difference does not matter: 1 % of
/// the radius.
std::vector<Vec2> on_ellipse(const Vec2& center, const Vec2& radii, float angle) {
    std::vector<Vec2> points;
    for (int i = 0; i < 24; ++i) {
        const float turn = 2 * std::numbers::pi_v<float> * float(i) / 24;
        points.push_back(
            placed({radii.x * std::cos(turn), radii.y * std::sin(turn)}, center, angle));
    }
    return points;
}

std::vector<Vec2> corners(const Box& box) {
    const float r = std::min(box.rounding, 0.5f * std::min(box.width, box.height) - 1e-4f);
    const float x = 0.5f * box.width - r, y = 0.5f * box.height - r;
    std::vector<Vec2> points;
    for (const Vec2& corner : {Vec2{-x, -y}, Vec2{x, -y}, Vec2{x, y}, Vec2{-x, y}})
        points.push_back(placed(corner, box.center, box.angle));
    return points;
}

struct EdgesOf {
    Outline operator()(const Circle& c) const {
        return {Outline::Kind::solid, around(on_ellipse(c.center, {c.radius, c.radius}, 0)), {}};
    }
    Outline operator()(const Ellipse& e) const {
        return {Outline::Kind::solid,
                around(on_ellipse(e.center, {e.radius_x, e.radius_y}, e.angle)),
                {}};
    }
    Outline operator()(const Box& b) const {
        return {Outline::Kind::solid, around(corners(b)), {}};
    }
    Outline operator()(const Polygon& p) const {
        return {Outline::Kind::solid, around(p.vertices), {}};
    }
    Outline operator()(const Concave& c) const {
        return {Outline::Kind::solid, around(c.vertices), {}};
    }
    Outline operator()(const Segment& s) const {
        return {Outline::Kind::line, {{s.from, s.to}}, {}};
    }
    Outline operator()(const Chain& c) const {
        Outline outline{Outline::Kind::one_sided, {}, {}};
        for (std::size_t i = 0; i + (c.closed ? 0 : 1) < c.points.size(); ++i)
            outline.edges.push_back({c.points[i], c.points[(i + 1) % c.points.size()]});
        return outline;
    }
};

Core core_of(const std::vector<Vec2>& points, float rounding) {
    Core core;
    Vec2 weighted = {};
    double area = 0;
    const Vec2 origin = points.front();  // near the polygon, so that the sum is precise
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec2 a = points[i] - origin, b = points[(i + 1) % points.size()] - origin;
        const double part = cross(a, b);
        weighted += float(part / 3) * (a + b);
        area += part;
    }
    core.point = origin + weighted / float(area);
    core.depth = infinity;
    for (const Edge& edge : around(points)) {
        const Vec2 along = edge.to - edge.from;
        const double away = std::abs(cross(along, core.point - edge.from)) / along.length();
        core.depth = std::min(core.depth, float(away) + rounding);
    }
    return core;
}

struct CoresOf {
    using Cores = std::vector<Core>;
    Cores operator()(const Circle& c) const { return {{c.center, c.radius}}; }
    Cores operator()(const Ellipse& e) const {
        return {{e.center, std::min(e.radius_x, e.radius_y)}};
    }
    Cores operator()(const Box& b) const {
        return {{b.center, 0.5f * std::min(b.width, b.height)}};
    }
    Cores operator()(const Polygon& p) const { return {core_of(p.vertices, p.rounding)}; }
    Cores operator()(const Segment& s) const { return {{(s.from + s.to) / 2, s.rounding}}; }
    Cores operator()(const Chain&) const { return {}; }
    Cores operator()(const Concave& c) const {
        Cores cores;
        World scratch;
        for (const std::vector<Vec2>& piece : scratch.create_shape(c).pieces())
            cores.push_back(core_of(piece, 0));
        return cores;
    }
};

}  // namespace

Outline outline_of(const Geometry& geometry) {
    Outline outline = std::visit(EdgesOf{}, geometry);
    outline.box = {{infinity, infinity}, {-infinity, -infinity}};
    for (const Edge& edge : outline.edges)
        for (const Vec2& point : {edge.from, edge.to}) {
            outline.box.min = outline.box.min.min(point);
            outline.box.max = outline.box.max.max(point);
        }
    return outline;
}

std::vector<Core> cores_of(const Geometry& geometry) {
    return std::visit(CoresOf{}, geometry);
}

float distance_to(const Edge& edge, const Vec2& point) {
    const Vec2 along = edge.to - edge.from;
    const float part = (point - edge.from).dot(along) / std::max(along.length_squared(), 1e-12f);
    return (edge.from + std::clamp(part, 0.0f, 1.0f) * along - point).length();
}

int crossing(const Edge& edge, const Vec2& p, const Vec2& q) {
    const Vec2 along = edge.to - edge.from;
    const bool p_in_front = cross(along, p - edge.from) > 0;
    const bool q_in_front = cross(along, q - edge.from) > 0;
    if (p_in_front == q_in_front) return 0;
    const Vec2 way = q - p;
    const bool from_beside = cross(way, edge.from - p) > 0, to_beside = cross(way, edge.to - p) > 0;
    if (from_beside == to_beside) return 0;
    return p_in_front ? 1 : -1;
}

float part_of_way(const Edge& edge, const Vec2& p, const Vec2& q) {
    const Vec2 along = edge.to - edge.from;
    const float before = cross(along, p - edge.from), after = cross(along, q - edge.from);
    return before / (before - after);
}

}  // namespace fettle::bench::wild
