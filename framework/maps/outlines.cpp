#include <fettle/maps/outlines.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <tuple>
#include <vector>

#include <fettle/property/error.h>
#include <fettle/property/value.h>

// Coordinates become integers, so that edges on one line are found exactly. On each line, the edges
// of all polygons are added up as intervals with a direction: where two polygons meet, the sum is
// zero. The remaining intervals are linked to closed outlines.

namespace fettle::maps {
namespace {

using property::Vec2;

constexpr double resolution = 256;
constexpr double largest = 4'000'000;  // products of two differences fit in 64 bits

struct Point {
    std::int64_t x, y;
    auto operator<=>(const Point&) const = default;  // NOLINT: no pointer
};

Point operator-(const Point& a, const Point& b) {
    return {a.x - b.x, a.y - b.y};
}
std::int64_t cross(const Point& a, const Point& b) {
    return a.x * b.y - a.y * b.x;
}
std::int64_t dot(const Point& a, const Point& b) {
    return a.x * b.x + a.y * b.y;
}

/// A line: its direction, without a common divisor and pointing to the right or straight up, and
/// the cross product of the direction with any of its points.
struct Line {
    Point direction;
    std::int64_t offset;
    auto operator<=>(const Line&) const = default;  // NOLINT: no pointer
};

/// A change of the sum of edges at a point of a line.
struct Change {
    Line line;
    Point at;
    int by;
};

struct Edge {
    Point from, to;
};

std::vector<Point> rounded(const Outline& polygon) {
    std::vector<Point> points;
    for (const Vec2& v : polygon) {
        if (!(std::abs(v.x) < largest && std::abs(v.y) < largest))
            throw property::Error(property::ErrorKind::out_of_range,
                                  "an outline has a vertex at " + property::value_text(v) +
                                      ", and its coordinates may be " +
                                      property::number_text(largest) + " at most");
        const Point p{std::llround(v.x * resolution), std::llround(v.y * resolution)};
        if (points.empty() || points.back() != p) points.push_back(p);
    }
    while (points.size() > 1 && points.front() == points.back()) points.pop_back();
    return points;
}

/// Twice the area; positive for counter-clockwise points. Exactly 0 for points on one line.
double area(const std::vector<Point>& points) {
    double sum = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        sum += static_cast<double>(
            cross(points[i] - points[0], points[(i + 1) % points.size()] - points[0]));
    return sum;
}

void add_edge(const Point& from, const Point& to, std::vector<Change>& changes) {
    Point direction = to - from;
    const std::int64_t divisor = std::gcd(direction.x, direction.y);
    direction = {direction.x / divisor, direction.y / divisor};
    if (direction.x < 0 || (direction.x == 0 && direction.y < 0))
        direction = {-direction.x, -direction.y};
    const Line line{direction, cross(direction, from)};
    changes.push_back({line, from, 1});
    changes.push_back({line, to, -1});
}

/// The edges where the sum is not zero. From left to right, an edge in the direction of the line
/// adds 1 up to its end, and one against it -1.
std::vector<Edge> remaining_edges(std::vector<Change>& changes) {
    std::ranges::sort(changes, [](const Change& a, const Change& b) {
        return std::tie(a.line, a.at) < std::tie(b.line, b.at);
    });
    std::vector<Edge> edges;
    int sum = 0;
    for (std::size_t i = 0; i < changes.size();) {
        const Change& here = changes[i];
        const std::size_t first = i;
        int next = sum;
        for (; i < changes.size() && changes[i].line == here.line && changes[i].at == here.at; ++i)
            next += changes[i].by;
        const bool same_line = first > 0 && changes[first - 1].line == here.line;
        if (same_line && sum != 0) {
            Edge edge{changes[first - 1].at, here.at};
            if (sum < 0) std::swap(edge.from, edge.to);
            edges.push_back(edge);
        }
        sum = next;
    }
    return edges;
}

/// Where edges begin, and which edges can follow another one. Sorted lists in place of a map: a map
/// of millions of points takes most of the time of a merge.
class Junctions {
  public:
    explicit Junctions(const std::vector<Edge>& edges) : follows_(edges.size()) {
        std::vector<End> ends;
        begins_.reserve(edges.size());
        ends.reserve(edges.size());
        for (std::size_t i = 0; i < edges.size(); ++i) {
            begins_.push_back({edges[i].from, i});
            ends.push_back({edges[i].to, i});
        }
        std::ranges::sort(begins_);
        std::ranges::sort(ends);
        std::size_t begin = 0;
        for (const End& end : ends) {
            while (begin < begins_.size() && begins_[begin].at < end.at) ++begin;
            follows_[end.edge] = begin;
        }
    }

    /// Puts the edges into `ways` that begin where `edge` ends, in their order, without those that
    /// are `used`. The edge `first` is among them in any case.
    void leaving(const Edge& edge, std::size_t index, const std::vector<bool>& used,
                 std::size_t first, std::vector<std::size_t>& ways) const {
        ways.clear();
        for (std::size_t i = follows_[index]; i < begins_.size() && begins_[i].at == edge.to; ++i) {
            const std::size_t way = begins_[i].edge;
            if (!used[way] || way == first) ways.push_back(way);
        }
    }

  private:
    struct End {
        Point at;
        std::size_t edge;
        auto operator<=>(const End&) const = default;  // NOLINT: no pointer
    };
    std::vector<End> begins_;           // by their points, then in the order of the edges
    std::vector<std::size_t> follows_;  // for each edge, the first of `begins_` at its end
};

/// The next edge of an outline at a point where several leave: the first one clockwise from the
/// way back, so that the outline turns left as far as it can and parts that meet in a corner stay
/// separate.
std::size_t next_edge(const Edge& arriving, const std::vector<std::size_t>& leaving,
                      const std::vector<Edge>& edges) {
    const Point back = arriving.from - arriving.to;
    const auto angle_class = [&](const Point& d) {
        const std::int64_t side = cross(back, d);
        // 0: clockwise from `back` by less than a half turn; 1: a half turn; 2: more; 3: `back`
        // itself.
        if (side == 0) return dot(back, d) > 0 ? 3 : 1;
        return side < 0 ? 0 : 2;
    };
    std::size_t best = 0;
    for (std::size_t i = 1; i < leaving.size(); ++i) {
        const Point a = edges[leaving[i]].to - edges[leaving[i]].from;
        const Point b = edges[leaving[best]].to - edges[leaving[best]].from;
        const int class_a = angle_class(a), class_b = angle_class(b);
        if (class_a < class_b || (class_a == class_b && cross(a, b) < 0)) best = i;
    }
    return best;
}

/// Drops points between two edges of one direction.
Outline simplified(const std::vector<Point>& points) {
    Outline outline;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Point& before = points[(i + points.size() - 1) % points.size()];
        const Point& after = points[(i + 1) % points.size()];
        if (cross(points[i] - before, after - points[i]) == 0) continue;
        outline.emplace_back(static_cast<double>(points[i].x) / resolution,
                             static_cast<double>(points[i].y) / resolution);
    }
    return outline;
}

}  // namespace

std::vector<Outline> merged_outlines(std::span<const Outline> polygons) {
    std::vector<Change> changes;
    for (const Outline& polygon : polygons) {
        std::vector<Point> points = rounded(polygon);
        const double size = points.size() < 3 ? 0 : area(points);
        if (size == 0) continue;
        if (size < 0) std::ranges::reverse(points);
        for (std::size_t i = 0; i < points.size(); ++i)
            add_edge(points[i], points[(i + 1) % points.size()], changes);
    }
    const std::vector<Edge> edges = remaining_edges(changes);
    const Junctions junctions(edges);
    std::vector<Outline> outlines;
    std::vector<std::size_t> ways;
    std::vector<bool> used(edges.size(), false);
    for (std::size_t first = 0; first < edges.size(); ++first) {
        if (used[first]) continue;
        std::vector<Point> points;
        for (std::size_t edge = first; !used[edge];) {
            used[edge] = true;
            points.push_back(edges[edge].from);
            junctions.leaving(edges[edge], edge, used, first, ways);
            if (ways.empty()) break;
            edge = ways[next_edge(edges[edge], ways, edges)];
        }
        Outline outline = simplified(points);
        if (outline.size() >= 3) outlines.push_back(std::move(outline));
    }
    return outlines;
}

}  // namespace fettle::maps
