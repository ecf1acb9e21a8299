#include <outlines/area.h>

#include <algorithm>
#include <cmath>

namespace fettle::app {

namespace {

// Edges of a row; sorting more costs more than counting columns.
constexpr std::size_t max_in_order = 128;
constexpr float max_columns = 1 << 16;  // coordinates near a screen are below this

bool is_inside(Area::Rule rule, int times) {
    return rule == Area::Rule::forward ? times > 0 : times != 0;
}

}  // namespace

void Area::add(std::span<const sf::Vector2f> outline) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
        sf::Vector2f from = outline[i], to = outline[i + 1 < outline.size() ? i + 1 : 0];
        // With y down, an outline with positive area goes up on its left side.
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

/// Groups the edges by their first row. Edges that begin above `first_row` are moved down to it.
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
        if (active_.size() <= max_in_order || !count_spans(rule, row, trapezoids))
            find_spans(rule, row, trapezoids);
    }
    for (const std::uint32_t i : open_) end_span(edges_[i], trapezoids);
    open_.clear();
}

void Area::find_spans(Rule rule, int row, std::vector<Trapezoid>& trapezoids) {
    // Insertion sort: from row to row the order hardly changes.
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
    const auto inside = [rule](int times) { return is_inside(rule, times); };
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

/// The same for many edges: does not sort them and rounds to whole pixels. Returns false if the row
/// is too long.
bool Area::count_spans(Rule rule, int row, std::vector<Trapezoid>& trapezoids) {
    float min_x = edges_[active_[0]].middle(row), max_x = min_x;
    for (const std::uint32_t i : active_) {
        min_x = std::min(min_x, edges_[i].middle(row));
        max_x = std::max(max_x, edges_[i].middle(row));
    }
    if (!(std::abs(min_x) < max_columns && std::abs(max_x) < max_columns)) return false;
    for (const std::uint32_t i : open_) end_span(edges_[i], trapezoids);
    open_.clear();
    const auto first_center = [](float x) { return static_cast<int>(std::ceil(x - 0.5f)); };
    const int first = first_center(min_x);
    columns_.assign(static_cast<std::size_t>(first_center(max_x) - first) + 1, 0);
    for (const std::uint32_t i : active_)
        columns_[static_cast<std::size_t>(first_center(edges_[i].middle(row)) - first)] +=
            edges_[i].direction;
    const auto at = [](int number) { return static_cast<float>(number); };
    int round = 0, begin = first;
    for (std::size_t c = 0; c < columns_.size(); ++c) {
        const bool before = is_inside(rule, round);
        round += columns_[c];
        if (is_inside(rule, round) == before) continue;
        const int column = first + static_cast<int>(c);
        if (before)
            trapezoids.push_back(
                {at(row), at(row + 1), at(begin), at(column), at(begin), at(column)});
        else
            begin = column;
    }
    return true;
}

void Area::end_span(Edge& left, std::vector<Trapezoid>& trapezoids) {
    if (left.top < 0) return;
    const Edge& right = edges_[left.right];
    int top = left.top, bottom = left.bottom;
    left.top = left.bottom = -1;
    // Edges that meet between the middles of two rows would cross at the border between the rows.
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
