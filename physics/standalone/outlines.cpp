#include <checks/arguments.h>
#include <fettle/physics/outlines.h>
#include <geometry/decomposition.h>
#include <geometry/vector.h>

#include <algorithm>
#include <cmath>
#include <utility>

// Lines as chains.

namespace fettle::physics {

using namespace detail;

namespace {

/// Marks the points of `first` … `last` that remain between two points that do. The index of a
/// closed line goes round.
void mark_corners(std::span<const Vec2> points, size_t first, size_t last, float straight,
                  std::vector<bool>& remains) {
    const size_t count = points.size();
    std::vector<std::pair<size_t, size_t>> open = {{first, last}};
    while (!open.empty()) {
        const auto [begin, end] = open.back();
        open.pop_back();
        const Vec2 from = points[begin % count], way = points[end % count] - from;
        const float whole = length_squared(way);
        float farthest = straight * straight;
        size_t corner = begin;
        for (size_t i = begin + 1; i < end; ++i) {
            const Vec2 p = points[i % count] - from;
            const float t = whole > 0.0f ? clamp(dot(p, way) / whole, 0.0f, 1.0f) : 0.0f;
            const float squared = length_squared(p - t * way);
            if (squared <= farthest) continue;
            farthest = squared;
            corner = i;
        }
        if (corner == begin) continue;
        remains[corner % count] = true;
        open.emplace_back(begin, corner);
        open.emplace_back(corner, end);
    }
}

}  // namespace

std::vector<Vec2> without_straight_points(std::span<const Vec2> points, bool closed,
                                          float straight) {
    check_not_negative("straight", straight);
    for (const Vec2& p : points) check_point("points", p);
    const size_t count = points.size();
    if (count < 3) return {points.begin(), points.end()};
    std::vector<bool> remains(count);
    if (closed) {
        // Two corners for certain: the leftmost of the lowest points, and the farthest from it.
        size_t low = 0, far = 0;
        for (size_t i = 1; i < count; ++i)
            if (points[i].y < points[low].y ||
                (points[i].y == points[low].y && points[i].x < points[low].x))
                low = i;
        for (size_t i = 0; i < count; ++i)
            if (length_squared(points[i] - points[low]) > length_squared(points[far] - points[low]))
                far = i;
        remains[low] = remains[far] = true;
        const size_t ahead = far > low ? far : far + count;
        mark_corners(points, low, ahead, straight, remains);
        mark_corners(points, far, low > far ? low : low + count, straight, remains);
    } else {
        remains[0] = remains[count - 1] = true;
        mark_corners(points, 0, count - 1, straight, remains);
    }
    std::vector<Vec2> kept;
    for (size_t i = 0; i < count; ++i)
        if (remains[i]) kept.push_back(points[i]);
    return kept;
}

namespace {

/// Finds the ends of lines that are near to a point.
class LineEnds {
  public:
    struct End {
        uint32_t line = 0;
        bool last = false;  ///< the last point of the line, not the first
    };

    LineEnds(std::span<const std::vector<Vec2>> lines, float reach)
        : lines_(lines), reach_(reach), used_(lines.size()) {
        for (uint32_t i = 0; i < lines.size(); ++i)
            for (const bool last : {false, true}) sorted_.push_back({i, last});
        std::stable_sort(sorted_.begin(), sorted_.end(),
                         [this](const End& a, const End& b) { return place(a).x < place(b).x; });
    }

    Vec2 place(const End& end) const {
        return end.last ? lines_[end.line].back() : lines_[end.line].front();
    }
    bool is_used(uint32_t line) const { return used_[line]; }
    void use(uint32_t line) { used_[line] = true; }

    /// The nearest end of an unused line. `last`: the end that keeps the direction of its line.
    const End* nearest(Vec2 to, bool last) const {
        const End* best = nullptr;
        float least = 0.0f;
        auto at = std::lower_bound(sorted_.begin(), sorted_.end(), to.x - reach_,
                                   [this](const End& end, float x) { return place(end).x < x; });
        for (; at != sorted_.end() && place(*at).x <= to.x + reach_; ++at) {
            if (used_[at->line]) continue;
            const float squared = length_squared(place(*at) - to);
            if (squared > reach_ * reach_) continue;
            if (best != nullptr && !comes_before(*at, squared, *best, least, last)) continue;
            best = &*at;
            least = squared;
        }
        return best;
    }

  private:
    static bool comes_before(const End& a, float squared_a, const End& b, float squared_b,
                             bool last) {
        if (squared_a != squared_b) return squared_a < squared_b;
        if ((a.last == last) != (b.last == last)) return a.last == last;
        return a.line < b.line;
    }

    std::span<const std::vector<Vec2>> lines_;
    float reach_;
    std::vector<bool> used_;
    std::vector<End> sorted_;  ///< from left to right
};

/// Extends a line at its end by all lines that begin or end there.
void extend(std::vector<Vec2>& line, LineEnds& ends, std::span<const std::vector<Vec2>> lines,
            bool at_front, float reach) {
    const auto meets_itself = [&] {
        return line.size() > 2 && length(line.front() - line.back()) <= reach;
    };
    if (at_front) std::reverse(line.begin(), line.end());
    while (!meets_itself()) {
        const LineEnds::End* next = ends.nearest(line.back(), at_front);
        if (next == nullptr) break;
        const std::vector<Vec2>& added = lines[next->line];
        ends.use(next->line);
        if (next->last)
            line.insert(line.end(), added.rbegin() + 1, added.rend());
        else
            line.insert(line.end(), added.begin() + 1, added.end());
    }
    if (at_front) std::reverse(line.begin(), line.end());
}

/// The chain of a line; its points are none if too few remain.
Chain chain_of(const std::vector<Vec2>& line, const JoinOptions& options) {
    Chain chain;
    chain.closed = line.size() > 2 && length(line.front() - line.back()) <= options.reach;
    for (const Vec2 p : line) chain.points.push_back(p);
    if (chain.closed) chain.points.pop_back();
    chain.points = without_straight_points(chain.points, chain.closed, options.straight);
    if (chain.points.size() < (chain.closed ? size_t{3} : size_t{2})) {
        chain.points.clear();
        return chain;
    }
    const bool counter_clockwise = signed_area(chain.points) > 0.0;
    if (chain.closed && options.closed != Winding::as_given &&
        counter_clockwise != (options.closed == Winding::counter_clockwise))
        std::reverse(chain.points.begin(), chain.points.end());
    return chain;
}

}  // namespace

std::vector<Chain> join_lines(std::span<const std::vector<Vec2>> lines,
                              const JoinOptions& options) {
    check_not_negative("reach", options.reach);
    check_not_negative("straight", options.straight);
    check_enumerator("closed", options.closed, Winding::counter_clockwise);
    std::vector<std::vector<Vec2>> distinct;
    for (const std::vector<Vec2>& line : lines) {
        std::vector<Vec2> points;
        for (const Vec2& p : line) {
            const Vec2 point = check_point("lines", p);
            if (points.empty() || length(point - points.back()) > options.reach)
                points.push_back(point);
        }
        // The end of a line is exact: it may be what joins it to another.
        if (points.size() > 1) points.back() = line.back();
        if (points.size() > 1) distinct.push_back(std::move(points));
    }
    LineEnds ends(distinct, options.reach);
    std::vector<Chain> chains;
    for (uint32_t i = 0; i < distinct.size(); ++i) {
        if (ends.is_used(i)) continue;
        ends.use(i);
        std::vector<Vec2> line = distinct[i];
        extend(line, ends, distinct, false, options.reach);
        extend(line, ends, distinct, true, options.reach);
        Chain chain = chain_of(line, options);
        if (!chain.points.empty()) chains.push_back(std::move(chain));
    }
    return chains;
}

}  // namespace fettle::physics
