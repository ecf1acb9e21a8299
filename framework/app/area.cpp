#include "area.h"

#include <algorithm>
#include <cmath>

namespace fettle::app {

void Area::add(std::span<const sf::Vector2f> outline) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
        sf::Vector2f from = outline[i], to = outline[i + 1 < outline.size() ? i + 1 : 0];
        // In this system of coordinates, y down, an outline of positive area goes up on the left.
        const int direction = from.y < to.y ? -1 : 1;
        if (direction > 0) std::swap(from, to);
        const int first = static_cast<int>(std::ceil(from.y - 0.5f));
        const int end = static_cast<int>(std::ceil(to.y - 0.5f));
        if (first >= end) continue;
        const float slope = (to.x - from.x) / (to.y - from.y);
        const float x = from.x + slope * (static_cast<float>(first) + 0.5f - from.y);
        edges_.push_back({first, end, x, slope, direction});
    }
}

/// Edges of the rows, those of one row together; what begins above is moved down to the first.
void Area::sort_by_row(int first_row, int end_row) {
    starts_.assign(static_cast<std::size_t>(end_row - first_row) + 1, 0);
    for (Edge& edge : edges_) {
        if (edge.first < first_row && edge.end > first_row) {
            edge.x = edge.middle(first_row);
            edge.first = first_row;
        }
        if (edge.first >= first_row && edge.first < end_row)
            ++starts_[static_cast<std::size_t>(edge.first - first_row) + 1];
    }
    for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
    order_.resize(starts_.back());
    std::vector<std::uint32_t>& next = active_;
    next.assign(starts_.begin(), starts_.end());
    for (std::uint32_t i = 0; i < edges_.size(); ++i) {
        const Edge& edge = edges_[i];
        if (edge.first >= first_row && edge.first < end_row)
            order_[next[static_cast<std::size_t>(edge.first - first_row)]++] = i;
    }
}

void Area::cut(Rule rule, int first_row, int end_row, std::vector<Trapezoid>& trapezoids) {
    int lowest = first_row, highest = end_row;
    for (const Edge& edge : edges_) {
        highest = std::min(highest, edge.first);
        lowest = std::max(lowest, edge.end);
    }
    first_row = std::max(first_row, highest);
    end_row = std::min(end_row, lowest);
    if (first_row >= end_row) return;
    sort_by_row(first_row, end_row);
    active_.clear();
    open_.clear();
    for (int row = first_row; row < end_row; ++row) {
        std::erase_if(active_, [&](std::uint32_t i) { return edges_[i].end <= row; });
        const auto at = static_cast<std::size_t>(row - first_row);
        active_.insert(active_.end(), order_.begin() + starts_[at],
                       order_.begin() + starts_[at + 1]);
        find_spans(rule, row, trapezoids);
    }
    for (const std::uint32_t i : open_) end_span(edges_[i], trapezoids);
    open_.clear();
}

void Area::find_spans(Rule rule, int row, std::vector<Trapezoid>& trapezoids) {
    // From row to row the order hardly changes.
    for (std::size_t i = 1; i < active_.size(); ++i) {
        const std::uint32_t moving = active_[i];
        const float x = edges_[moving].middle(row);
        std::size_t to = i;
        for (; to > 0 && edges_[active_[to - 1]].middle(row) > x; --to)
            active_[to] = active_[to - 1];
        active_[to] = moving;
    }
    open_now_.clear();
    int round = 0;
    std::uint32_t left = 0;
    const auto inside = [rule](int times) {
        return rule == Rule::forward ? times > 0 : times != 0;
    };
    for (const std::uint32_t i : active_) {
        const bool before = inside(round);
        round += edges_[i].direction;
        if (!before && inside(round)) left = i;
        if (!before || inside(round)) continue;
        Edge& edge = edges_[left];
        if (edge.bottom != row || edge.right != i) {
            end_span(edge, trapezoids);
            edge.right = i;
            edge.top = row;
        }
        edge.bottom = row + 1;
        open_now_.push_back(left);
    }
    for (const std::uint32_t i : open_)
        if (edges_[i].bottom == row) end_span(edges_[i], trapezoids);
    std::swap(open_, open_now_);
}

void Area::end_span(Edge& left, std::vector<Trapezoid>& trapezoids) {
    if (left.top < 0) return;
    const Edge& right = edges_[left.right];
    int top = left.top, bottom = left.bottom;
    left.top = left.bottom = -1;
    // Edges that meet between two rows' middles would cross on the border between the rows.
    if (bottom - top > 1 && left.border(top) > right.border(top)) {
        put(left, right, top, top + 1, trapezoids);
        ++top;
    }
    if (bottom - top > 1 && left.border(bottom) > right.border(bottom)) {
        put(left, right, bottom - 1, bottom, trapezoids);
        --bottom;
    }
    put(left, right, top, bottom, trapezoids);
}

void Area::put(const Edge& left, const Edge& right, int top, int bottom,
               std::vector<Trapezoid>& trapezoids) const {
    const auto row = [](int number) { return static_cast<float>(number); };
    if (bottom - top == 1) {
        const float from = left.middle(top), to = right.middle(top);
        if (to > from) trapezoids.push_back({row(top), row(bottom), from, to, from, to});
        return;
    }
    trapezoids.push_back({row(top), row(bottom), left.border(top), right.border(top),
                          left.border(bottom), right.border(bottom)});
}

}  // namespace fettle::app
