#pragma once

#include <geometry/vector.h>

#include <cstdint>
#include <span>
#include <vector>

namespace fettle::physics::detail {

/// Finds the point of a part of a line that is farthest from a segment. That point is a corner of
/// the convex hull of the part, so hulls of pieces of the line are kept, with twice as many points
/// from level to level: a search examines few corners instead of all points.
class FarthestPoint {
  public:
    struct Segment {
        Vec2 from, to_end;  ///< m; the vector from one end to the other
    };
    struct Found {
        float squared = 0.0f;  ///< m², only points that are farther are found
        size_t index = 0;      ///< of the point
    };

    /// The points must outlive this.
    explicit FarthestPoint(std::span<const Vec2> points);

    /// The point of those from `first` to before `last` that is farther from the segment than
    /// `found`, and the first one of equals; `found` if there is none.
    Found search(size_t first, size_t last, const Segment& from, Found found) const;

  private:
    /// Points one after another.
    struct Piece {
        std::vector<uint32_t> hull;
        Box4 box = no_box;
    };

    Piece piece_of(std::vector<uint32_t> candidates) const;
    void visit(size_t level, size_t piece, size_t first, size_t last, const Segment& from,
               Found& found) const;
    void compare(size_t index, const Segment& from, Found& found) const;

    std::span<const Vec2> points_;
    std::vector<std::vector<Piece>> levels_;
};

}  // namespace fettle::physics::detail
