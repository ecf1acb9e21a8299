#pragma once
// The inside of closed outlines, whatever their form, cut into trapezoids.
//
// Each row of pixels is looked at along the middle of the row, where the pixels' centers are: what
// lies between two outlines there is inside. Rows that lie between the same two edges become one
// trapezoid. A row that crosses very many edges, most of them between two pixels' centers, is not
// put in order: the edges in front of each center are counted. So the cost is that of the corners
// and of what each row crosses, and no outline is too tangled.

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
    /// A closed outline in pixels.
    void add(std::span<const sf::Vector2f> outline);

    /// Which points are inside: those that the outlines go round, counted with their direction.
    enum class Rule : std::uint8_t {
        any_way,  // not 0 times
        forward   // more often than 0 times, the way that has a positive area
    };
    /// Appends what is inside between two rows, the second excluded.
    void cut(Rule rule, int first_row, int end_row, std::vector<Trapezoid>& trapezoids);

  private:
    struct Edge {
        int first, end;  // rows whose middle it crosses, the second excluded
        float x, slope;  // in the middle of the first row; for each row
        int direction;   // 1: down
        // Of the span that it begins on its left side.
        std::uint32_t right = 0;
        int top = -1, bottom = -1;
        float middle(int row) const { return x + slope * static_cast<float>(row - first); }
        float border(int row) const { return middle(row) - 0.5f * slope; }  // its upper one
    };
    void sort_by_row(int first_row, int end_row);
    void find_spans(Rule rule, int row, std::vector<Trapezoid>& trapezoids);
    bool count_spans(Rule rule, int row, std::vector<Trapezoid>& trapezoids);
    void end_span(Edge& left, std::vector<Trapezoid>& trapezoids);
    void put(const Edge& left, const Edge& right, int top, int bottom,
             std::vector<Trapezoid>& trapezoids) const;

    std::vector<Edge> edges_;
    std::vector<std::uint32_t> order_, starts_;  // edges by their first row
    std::vector<std::uint32_t> active_;          // edges that the row crosses, from left to right
    std::vector<int> columns_;                   // what a row's edges change at each column
    std::vector<std::uint32_t> open_,
        open_now_;  // left edges of spans, of the row before and of this
};

}  // namespace fettle::app
