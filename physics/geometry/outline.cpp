#include <geometry/decomposition.h>
#include <geometry/number_text.h>
#include <geometry/orientation.h>

#include <algorithm>
#include <numeric>

// Tests whether an outline is a simple polygon, and describes the error if it is not.

namespace fettle::physics::detail {
namespace {

bool same(Vec2 a, Vec2 b) {
    return a.x == b.x && a.y == b.y;
}

/// Whether `p` is between a and b. It must be on their line.
bool between(Vec2 p, Vec2 a, Vec2 b) {
    return min(a.x, b.x) <= p.x && p.x <= max(a.x, b.x) && min(a.y, b.y) <= p.y &&
           p.y <= max(a.y, b.y);
}

struct Edge {
    uint32_t from, to;  // vertices
    Vec2 a, b;
    bool next_to(const Edge& o) const {
        return to == o.from || from == o.to || same(b, o.a) || same(a, o.b);
    }
};

std::string number(uint32_t vertex) {
    return std::to_string(vertex + 1);
}

std::string name(const Edge& e) {
    return "the edge from vertex " + number(e.from) + " to " + number(e.to);
}

std::string name(Vec2 p) {
    return "(" + number_text(double(p.x)) + ", " + number_text(double(p.y)) + ")";
}

Vec2 crossing(const Edge& e, const Edge& f) {
    const double d = orientation(e.a, e.b, f.b) - orientation(e.a, e.b, f.a);
    const double t = d != 0.0 ? -orientation(e.a, e.b, f.a) / d : 0.0;
    return {float(double(f.a.x) + t * (double(f.b.x) - double(f.a.x))),
            float(double(f.a.y) + t * (double(f.b.y) - double(f.a.y)))};
}

constexpr const char* no_hole =
    ": an outline cannot enclose a hole or meet itself; make a body of several shapes instead";

/// The error between two edges; the edge with the lower vertex comes first.
std::optional<std::string> problem_between(const Edge& e, const Edge& f) {
    const double ea = orientation(e.a, e.b, f.a), eb = orientation(e.a, e.b, f.b);
    const double fa = orientation(f.a, f.b, e.a), fb = orientation(f.a, f.b, e.b);
    const bool on_line = ea == 0.0 && eb == 0.0;
    if (e.next_to(f)) {
        // Neighbors share a vertex; they must not overlap.
        const Vec2 shared = same(e.b, f.a) ? e.b : e.a;
        const Vec2 p = same(e.b, f.a) ? e.a : e.b, q = same(e.b, f.a) ? f.b : f.a;
        const bool back = on_line && (between(p, shared, q) || between(q, shared, p));
        if (!back) return {};
        return name(f) + " runs back over " + name(e) + no_hole;
    }
    if ((ea > 0.0) != (eb > 0.0) && (fa > 0.0) != (fb > 0.0) && ea != 0.0 && eb != 0.0 &&
        fa != 0.0 && fb != 0.0)
        return name(e) + " crosses " + name(f) + " at " + name(crossing(e, f));
    const bool overlap =
        on_line && (between(f.a, e.a, e.b) || between(f.b, e.a, e.b) || between(e.a, f.a, f.b));
    if (overlap) return name(e) + " and " + name(f) + " overlap" + no_hole;
    if (ea == 0.0 && between(f.a, e.a, e.b))
        return "vertex " + number(f.from) + " touches " + name(e) + " at " + name(f.a) + no_hole;
    if (eb == 0.0 && between(f.b, e.a, e.b))
        return "vertex " + number(f.to) + " touches " + name(e) + " at " + name(f.b) + no_hole;
    if (fa == 0.0 && between(e.a, f.a, f.b))
        return "vertex " + number(e.from) + " touches " + name(f) + " at " + name(e.a) + no_hole;
    if (fb == 0.0 && between(e.b, f.a, f.b))
        return "vertex " + number(e.to) + " touches " + name(f) + " at " + name(e.b) + no_hole;
    return {};
}

}  // namespace

double signed_area(std::span<const Vec2> outline) {
    double twice = 0.0;
    for (size_t i = 1; i + 1 < outline.size(); ++i)
        twice += orientation(outline[0], outline[i], outline[i + 1]);
    return 0.5 * twice;
}

std::optional<std::string> outline_problem(std::span<const Vec2> outline) {
    std::vector<Edge> edges;
    const auto n = uint32_t(outline.size());
    for (uint32_t i = 0; i < n; ++i) {
        const uint32_t next = (i + 1) % n;
        if (!same(outline[i], outline[next])) edges.push_back({i, next, outline[i], outline[next]});
    }
    if (edges.size() < 3) return "a concave polygon needs at least three different vertices";
    // Only edges whose extents along x overlap can meet, so a sweep from left to right finds all
    // candidates.
    std::vector<uint32_t> order(edges.size());
    std::iota(order.begin(), order.end(), 0u);
    const auto low = [&](uint32_t e) { return min(edges[e].a.x, edges[e].b.x); };
    const auto high = [&](uint32_t e) { return max(edges[e].a.x, edges[e].b.x); };
    std::sort(order.begin(), order.end(),
              [&](uint32_t e, uint32_t f) { return low(e) != low(f) ? low(e) < low(f) : e < f; });
    std::vector<uint32_t> open;
    for (uint32_t e : order) {
        size_t kept = 0;
        for (uint32_t f : open) {
            if (high(f) < low(e)) continue;
            open[kept++] = f;
            const Edge &first = edges[std::min(e, f)], &second = edges[std::max(e, f)];
            if (auto problem = problem_between(first, second)) return problem;
        }
        open.resize(kept);
        open.push_back(e);
    }
    double extent = 0.0;
    for (Vec2 p : outline) extent = std::max(extent, double(length(p - outline[0])));
    if (!(std::fabs(signed_area(outline)) > 1e-7 * extent * extent))
        return "the vertices of the polygon lie on one line";
    return {};
}

}  // namespace fettle::physics::detail
