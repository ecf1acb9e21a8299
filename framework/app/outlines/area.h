#pragma once
// Cuts the inside of closed outlines of any form into trapezoids.
//
// Each row of pixels is tested along its middle, where the pixel centers are: the parts between two
// edges are inside. Consecutive rows between the same two edges become one trapezoid. If a row
// crosses very many edges, they are not sorted; the edges left of each pixel center are counted
// instead. So the cost is linear in the number of corners and crossings, even for very tangled
// outlines.

#include <cstdint>
#include <span>
#include <vector>

#include <SFML/System/Vector2.hpp>

namespace fettle::app {

struct Trapezoid {
    float top, bottom;  // whole pixels
    float top_left, top_right, bottom_left, bottom_right;
};

class Area {
  public:
    void clear() { edges_.clear(); }
    /// Adds a closed outline in pixels.
    void add(std::span<const sf::Vector2f> outline);

    /// Decides by the winding number of a point whether it is inside.
    enum class Rule : std::uint8_t {
        any_way,  // the winding number is not 0
        forward   // the winding number is above 0; positive areas count positive
    };
    /// Appends the trapezoids of the inside from `first_row` up to, but not including, `end_row`.
    void cut(Rule rule, int first_row, int end_row, std::vector<Trapezoid>& trapezoids);

  private:
    struct Edge {
        int first, end;  // rows whose middle the edge crosses; `end` is excluded
        float x, slope;  // x in the middle of the first row, and its change for each row
        int direction;   // 1: down
        // The span to the right of this edge, if one is open.
        std::uint32_t right = 0;
        int top = -1, bottom = -1;
        float middle(int row) const { return x + slope * static_cast<float>(row - first); }
        // The x at the upper border of the row.
        float border(int row) const { return middle(row) - 0.5f * slope; }
    };
    void sort_by_row(int first_row, int end_row);
    void find_spans(Rule rule, int row, std::vector<Trapezoid>& trapezoids);
    bool count_spans(Rule rule, int row, std::vector<Trapezoid>& trapezoids);
    void end_span(Edge& left, std::vector<Trapezoid>& trapezoids);
    void put(const Edge& left, const Edge& right, int top, int bottom,
             std::vector<Trapezoid>& trapezoids) const;

    std::vector<Edge> edges_;
    std::vector<std::uint32_t> order_, starts_;  // edges grouped by their first row
    std::vector<std::uint32_t> active_;          // edges that the row crosses, from left to right
    std::vector<int> columns_;                   // change of the winding number at each column
    std::vector<std::uint32_t> open_,
        open_now_;  // left edges of the open spans: in the last row, and in this row
};

}  // namespace fettle::app
