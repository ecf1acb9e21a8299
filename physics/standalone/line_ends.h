#pragma once

#include <geometry/vector.h>

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace fettle::physics::detail {

/// Finds the ends of lines that are near to a point, in a tree of the places where lines end (J. L.
/// Bentley, "Multidimensional binary search trees used for associative searching", 1975). Any
/// number of lines may end in one place.
class LineEnds {
  public:
    struct End {
        uint32_t line = 0;
        bool last = false;  ///< the last point of the line, not the first
    };

    /// `reach`: ends within this distance are near, m. Each line has two points at least.
    LineEnds(std::span<const std::vector<Vec2>> lines, float reach);

    bool is_used(uint32_t line) const { return used_[line]; }
    void use(uint32_t line);

    /// The nearest end of an unused line; null if none is within reach. If two ends are equally
    /// near, the one whose `last` equals the argument comes first (its line keeps its direction),
    /// then the one of the earlier line.
    const End* nearest(Vec2 to, bool last);

  private:
    /// All ends in one point.
    struct Place {
        Vec2 at;
        std::array<uint32_t, 2> next = {};  ///< in `ends_`: the first that may be unused, by `last`
        std::array<uint32_t, 2> end = {};
    };
    /// A node of the tree: the middle place of a range, with the box and the number of unused ends
    /// of the whole range.
    struct Node {
        Place place;
        Box4 box = no_box;    ///< of the range
        uint32_t unused = 0;  ///< number of ends in the range
    };
    struct Search {
        Vec2 to;
        bool last = false;
        const End* best = nullptr;
        float least = 0.0f;  ///< m², the distance of the best
    };

    Vec2 place_of(const End& end) const {
        return end.last ? lines_[end.line].back() : lines_[end.line].front();
    }
    std::vector<Place> gather_places();
    void build(std::span<Place> places, uint32_t begin);
    void visit(uint32_t begin, uint32_t end, Search& search);
    const End* first_unused(Place& place, bool last);

    std::span<const std::vector<Vec2>> lines_;
    float most_;  ///< m², the square of the reach
    std::vector<bool> used_;
    std::vector<End> ends_;  ///< by place, end and line
    std::vector<Node> nodes_;
    std::array<std::vector<uint32_t>, 2> node_of_;  ///< of the first and last point of each line
};

}  // namespace fettle::physics::detail
