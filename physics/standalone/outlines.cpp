#include <checks/arguments.h>
#include <fettle/physics/outlines.h>
#include <geometry/decomposition.h>
#include <geometry/vector.h>
#include <standalone/farthest_point.h>
#include <standalone/line_ends.h>

#include <algorithm>
#include <string>
#include <utility>

// Conversion of lines to chains.

namespace fettle::physics {

using namespace detail;

namespace {

/// Marks the points that remain between two points of a line that remain. The index of a closed
/// line goes round.
class Corners {
  public:
    Corners(std::span<const Vec2> points, float straight)
        : remains(points.size()), points_(points), within_(straight * straight), parts_(points) {}

    void mark(size_t first, size_t last) {
        const size_t count = points_.size();
        std::vector<std::pair<size_t, size_t>> open = {{first, last}};
        while (!open.empty()) {
            const auto [begin, end] = open.back();
            open.pop_back();
            const size_t corner = farthest_between(begin, end);
            if (corner == begin) continue;
            remains[corner % count] = true;
            open.emplace_back(begin, corner);
            open.emplace_back(corner, end);
        }
    }

    std::vector<bool> remains;

  private:
    /// The point that is farthest from the straight line between `begin` and `end`; `begin` if all
    /// points are near enough to it.
    size_t farthest_between(size_t begin, size_t end) const {
        const size_t count = points_.size(), wrapped = std::max(begin + 1, count);
        const Vec2 from = points_[begin % count];
        const FarthestPoint::Segment straight{from, points_[end % count] - from};
        const auto found = parts_.search(begin + 1, std::min(end, count), straight, {within_, 0});
        const auto beyond = end > wrapped ? parts_.search(wrapped - count, end - count, straight,
                                                          {found.squared, 0})
                                          : found;
        if (beyond.squared > found.squared) return beyond.index + count;
        return found.squared > within_ ? found.index : begin;
    }

    std::span<const Vec2> points_;
    float within_;  ///< m²
    FarthestPoint parts_;
};

}  // namespace

std::vector<Vec2> without_straight_points(std::span<const Vec2> points, bool closed,
                                          float straight) {
    check_not_negative("straight", straight);
    check_points("points", "point", points);
    const size_t count = points.size();
    if (count < 3) return {points.begin(), points.end()};
    Corners corners(points, straight);
    std::vector<bool>& remains = corners.remains;
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
        corners.mark(low, ahead);
        corners.mark(far, low > far ? low : low + count);
    } else {
        remains[0] = remains[count - 1] = true;
        corners.mark(0, count - 1);
    }
    std::vector<Vec2> kept;
    for (size_t i = 0; i < count; ++i)
        if (remains[i]) kept.push_back(points[i]);
    return kept;
}

namespace {

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
        const std::string place = "lines: line " + std::to_string(&line - lines.data() + 1);
        check_points(place.c_str(), "point", line);
        std::vector<Vec2> points;
        for (const Vec2& point : line) {
            if (points.empty() || length(point - points.back()) > options.reach)
                points.push_back(point);
        }
        // The end of a line stays exact, because another line may begin there.
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
