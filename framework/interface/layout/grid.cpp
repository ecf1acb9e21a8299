// A column with several columns: a grid. All columns are as wide as the widest, unless a widget
// grows: then each is as wide as its widest widget, and those with widgets that grow share what is
// left.

#include <algorithm>
#include <cmath>
#include <vector>

#include <layout/growing.h>
#include <layout/layout.h>

namespace fettle::interface {

using property::Row;
using property::Vec2;

namespace {

std::size_t columns_of(const Widget& grid) {
    return static_cast<std::size_t>(grid.placing.columns);
}

double sum(const std::vector<double>& lengths, double spacing) {
    double all = 0;
    for (const double each : lengths) all += each;
    return lengths.empty() ? 0 : all + spacing * static_cast<double>(lengths.size() - 1);
}

}  // namespace

/// `width`: the width of the cell.
Vec2 Layout::measure_cell(Row child, double width) {
    Vec2 wanted = measure(child, width);
    Widget& one = widgets_[child];
    if (may_shrink(one)) {
        wanted.x = std::min(wanted.x, std::max(width, one.placing.min_size.x));
        one.arranged.wanted.x = wanted.x;
    }
    return wanted;
}

/// The heights of its rows.
std::vector<double> Layout::rows_of(const Widget& grid) const {
    std::vector<double> heights;
    const std::vector<Row>& children = grid.arranged.children;
    for (std::size_t i = 0; i < children.size(); ++i) {
        if (i % columns_of(grid) == 0) heights.push_back(0);
        heights.back() = std::max(heights.back(), widgets_[children[i]].arranged.wanted.y);
    }
    return heights;
}

/// How much each column grows: as the widget in it that grows most.
std::vector<double> Layout::growths_of(const Widget& grid) const {
    std::vector<double> growths(grid.arranged.columns.size(), 0);
    const std::vector<Row>& children = grid.arranged.children;
    for (std::size_t i = 0; i < children.size(); ++i) {
        double& of_column = growths[i % growths.size()];
        of_column = std::max(of_column, growth(widgets_[children[i]], 0));
    }
    return growths;
}

Vec2 Layout::natural_grid(Widget& widget, double width) {
    const double padding = padding_of(widget), spacing = spacing_of(widget);
    const std::vector<Row>& children = widget.arranged.children;
    const std::size_t count =
        std::min(columns_of(widget), std::max<std::size_t>(1, children.size()));
    std::vector<double>& widths = widget.arranged.columns;
    widths.assign(count, 0);
    const double room =
        std::max(0.0, width - 2 * padding - spacing * static_cast<double>(count - 1));
    const std::vector<double> growths = growths_of(widget);
    const double shares = sum(growths, 0);
    const auto widen = [&](std::size_t i, double given) {
        widths[i % count] = std::max(widths[i % count], measure_cell(children[i], given).x);
    };
    if (shares == 0) {
        const double equal = std::floor(room / static_cast<double>(count));
        for (std::size_t i = 0; i < children.size(); ++i) widen(i, equal);
        widths.assign(count, *std::ranges::max_element(widths));
    } else {
        // Columns that grow keep the room for their longest words.
        std::vector<double> words(count, 0);
        for (std::size_t i = 0; i < children.size(); ++i)
            if (growths[i % count] > 0)
                words[i % count] = std::max(words[i % count], longest_word(widgets_[children[i]]));
        const double most = std::max(0.0, room - sum(words, 0));
        const auto others = static_cast<double>(std::ranges::count(growths, 0.0));
        for (const double given : {most, std::floor(most / std::max(1.0, others))}) {
            widths.assign(count, 0);
            for (std::size_t i = 0; i < children.size(); ++i)
                if (growths[i % count] == 0) widen(i, given);
            if (sum(widths, 0) <= most) break;
        }
        const double rest = std::max(0.0, room - sum(widths, 0));
        for (std::size_t i = 0; i < children.size(); ++i)
            if (const double share = growths[i % count]; share > 0) widen(i, rest * share / shares);
    }
    return Vec2(sum(widths, spacing), sum(rows_of(widget), spacing)) + 2 * Vec2(padding, padding);
}

void Layout::arrange_grid(Widget& widget, const Box& inner, const Box& clip) {
    const double spacing = spacing_of(widget);
    const std::vector<Row>& children = widget.arranged.children;
    std::vector<double> widths = widget.arranged.columns;
    if (children.empty() || widths.empty()) return;
    const std::vector<double> heights = rows_of(widget);
    const std::size_t count = widths.size();
    const std::vector<double> growths = growths_of(widget);
    const double shares = sum(growths, 0);
    const bool stretch = widget.placing.align == "stretch";
    const double spare = std::max(0.0, inner.width() - sum(widths, spacing));
    for (std::size_t i = 0; i < count; ++i)
        if (shares > 0)
            widths[i] += spare * growths[i] / shares;
        else if (stretch)
            widths[i] += spare / static_cast<double>(count);
    double top = inner.lower.y;
    top += share_before(widget.placing.justify) *
           std::max(0.0, inner.height() - sum(heights, spacing));
    for (std::size_t i = 0; i < children.size(); ++i) {
        Widget& one = widgets_[children[i]];
        const double wide = widths[i % count], high = heights[i / count];
        double left = inner.lower.x;
        for (std::size_t before = 0; before < i % count; ++before) left += widths[before] + spacing;
        Vec2 size = one.arranged.wanted, lower(left, top);
        if ((stretch && !(one.placing.size.x > 0)) || fills(one, 0))
            size.x = std::max(wide, one.placing.min_size.x);
        else
            lower.x += share_before(widget.placing.align) * (wide - size.x);
        if (fills(one, 1))
            size.y = high;
        else
            lower.y += 0.5 * (high - size.y);
        arrange(children[i], {lower, lower + size}, clip);
        if (i % count + 1 == count) top += high + spacing;
    }
}

}  // namespace fettle::interface
