#include <geometry/orientation.h>
#include <standalone/farthest_point.h>

#include <algorithm>
#include <numeric>

namespace fettle::physics::detail {

namespace {

/// Number of points of a piece of the lowest level, and the greatest number of corners of a hull
/// that are examined one by one: of a larger hull, the boxes of its halves may exclude most
/// corners.
constexpr size_t few = 32;

float distance_squared(Vec2 point, const FarthestPoint::Segment& from) {
    const Vec2 p = point - from.from;
    return length_squared(p - nearest_fraction(from.to_end, p) * from.to_end);
}

/// The greatest distance in a box is that of a corner.
float farthest_in(const Box4& box, const FarthestPoint::Segment& from) {
    constexpr float rounding = 1.0f + 1e-5f;
    float most = 0.0f;
    for (const float x : {box.low.x, box.high.x})
        for (const float y : {box.low.y, box.high.y})
            most = max(most, distance_squared({x, y}, from));
    return rounding * most;
}

}  // namespace

FarthestPoint::FarthestPoint(std::span<const Vec2> points) : points_(points) {
    if (points.size() <= few) return;
    std::vector<Piece> pieces;
    for (size_t first = 0; first < points.size(); first += few) {
        std::vector<uint32_t> all(std::min(few, points.size() - first));
        std::iota(all.begin(), all.end(), uint32_t(first));
        pieces.push_back(piece_of(std::move(all)));
    }
    levels_.push_back(std::move(pieces));
    while (levels_.back().size() > 1) {
        const std::vector<Piece>& halves = levels_.back();
        std::vector<Piece> wholes;
        for (size_t i = 0; i < halves.size(); i += 2) {
            std::vector<uint32_t> corners = halves[i].hull;
            if (i + 1 < halves.size())
                corners.insert(corners.end(), halves[i + 1].hull.begin(), halves[i + 1].hull.end());
            wholes.push_back(piece_of(std::move(corners)));
        }
        levels_.push_back(std::move(wholes));
    }
}

FarthestPoint::Piece FarthestPoint::piece_of(std::vector<uint32_t> candidates) const {
    Piece made;
    std::sort(candidates.begin(), candidates.end(), [this](uint32_t a, uint32_t b) {
        const Vec2 p = points_[a], q = points_[b];
        return p.x != q.x ? p.x < q.x : p.y != q.y ? p.y < q.y : a < b;
    });
    // Of points in one place, the first counts.
    candidates.erase(
        std::unique(candidates.begin(), candidates.end(),
                    [this](uint32_t a, uint32_t b) { return points_[a] == points_[b]; }),
        candidates.end());
    made.hull = monotone_chain(candidates, [this](uint32_t i) { return points_[i]; });
    for (const uint32_t i : made.hull) {
        made.box.low = {min(made.box.low.x, points_[i].x), min(made.box.low.y, points_[i].y)};
        made.box.high = {max(made.box.high.x, points_[i].x), max(made.box.high.y, points_[i].y)};
    }
    return made;
}

FarthestPoint::Found FarthestPoint::search(size_t first, size_t last, const Segment& from,
                                           Found found) const {
    if (first + few >= last || levels_.empty())
        for (size_t i = first; i < last; ++i) compare(i, from, found);
    else
        visit(levels_.size() - 1, 0, first, last, from, found);
    return found;
}

void FarthestPoint::visit(size_t level, size_t piece, size_t first, size_t last,
                          const Segment& from, Found& found) const {
    const size_t size = few << level, begin = piece * size;
    const size_t end = std::min(begin + size, points_.size());
    if (begin >= last || end <= first) return;
    const bool whole = first <= begin && end <= last;
    const Piece& here = levels_[level][piece];
    if (farthest_in(here.box, from) <= found.squared) return;
    if (whole && (level == 0 || here.hull.size() <= few)) {
        for (const uint32_t i : here.hull) compare(i, from, found);
    } else if (level == 0) {
        for (size_t i = std::max(begin, first); i < std::min(end, last); ++i)
            compare(i, from, found);
    } else {
        visit(level - 1, 2 * piece, first, last, from, found);
        if (2 * piece + 1 < levels_[level - 1].size())
            visit(level - 1, 2 * piece + 1, first, last, from, found);
    }
}

void FarthestPoint::compare(size_t index, const Segment& from, Found& found) const {
    const float squared = distance_squared(points_[index], from);
    const bool farther = squared > found.squared;
    if (farther || (squared == found.squared && index < found.index)) found = {squared, index};
}

}  // namespace fettle::physics::detail
