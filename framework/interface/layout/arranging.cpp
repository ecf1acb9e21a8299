// The place of a widget within its parent.

#include <algorithm>
#include <array>
#include <cmath>

#include <layout/growing.h>
#include <layout/layout.h>

namespace fettle::interface {

using property::Row;
using property::Vec2;

namespace {

constexpr std::array<const char*, 9> anchors{"top_left",    "top",    "top_right",
                                             "left",        "center", "right",
                                             "bottom_left", "bottom", "bottom_right"};

}  // namespace

void Layout::arrange(Row row, Box box, const Box& clip) {
    Widget& widget = widgets_[row];
    box.lower += widget.placing.offset;
    box.upper += widget.placing.offset;
    widget.arranged.box = snapped(box);
    widget.arranged.clip = clip;
    const double padding = padding_of(widget);
    const Box inner = widget.arranged.box.smaller(padding);
    switch (widget.kind) {
        case Kind::panel:
            arrange_panel(widget, inner, clip);
            break;
        case Kind::row:
            arrange_line(widget, inner, clip, 0);
            break;
        case Kind::column:
            if (is_grid(widget))
                arrange_grid(widget, inner, clip);
            else
                arrange_line(widget, inner, clip, 1);
            break;
        case Kind::list:
            arrange_list(widget);
            break;
        default:
            write(widget);
            break;
    }
}

void Layout::arrange_panel(Widget& widget, const Box& inner, const Box& clip) {
    for (const Row child : widget.arranged.children) {
        Widget& one = widgets_[child];
        const auto n = static_cast<int>(
            std::find(anchors.begin(), anchors.end(), one.placing.anchor) - anchors.begin());
        const int column = n % 3, row = n / 3;
        const Vec2 part(0.5 * column, 0.5 * row);
        Vec2 size = one.arranged.wanted;
        for (const int axis : {0, 1})
            if (fills(one, axis))
                size[axis] = std::max(inner.size()[axis], one.placing.min_size[axis]);
        const Vec2 lower = inner.lower + part.times(inner.size() - size);
        arrange(child, {lower, lower + size}, clip);
    }
}

/// `along`: 0 for a row, 1 for a column.
void Layout::arrange_line(Widget& widget, const Box& inner, const Box& clip, int along) {
    const double spacing = spacing_of(widget);
    const int across = 1 - along;
    double left = inner.size()[along], shares = 0;
    if (!widget.arranged.children.empty())
        left -= spacing * static_cast<double>(widget.arranged.children.size() - 1);
    // A list that grows may become smaller than its content.
    const auto least = [&](const Widget& one) {
        return one.kind == Kind::list && growth(one, along) > 0 ? one.placing.min_size[along]
                                                                : one.arranged.wanted[along];
    };
    for (const Row child : widget.arranged.children) {
        left -= least(widgets_[child]);
        shares += growth(widgets_[child], along);
    }
    const double spare = std::max(0.0, left);
    double at = inner.lower[along];
    if (shares == 0) at += spare * share_before(widget.placing.justify);
    for (const Row child : widget.arranged.children) {
        Widget& one = widgets_[child];
        Vec2 size = one.arranged.wanted, lower = inner.lower;
        size[along] = least(one) + (shares > 0 ? spare * growth(one, along) / shares : 0);
        const bool stretched = widget.placing.align == "stretch" && !(one.placing.size[across] > 0);
        const double room = inner.size()[across];
        if (stretched || fills(one, across))
            size[across] = std::max(room, one.placing.min_size[across]);
        else
            lower[across] += share_before(widget.placing.align) * (room - size[across]);
        lower[along] = at;
        arrange(child, {lower, lower + size}, clip);
        at += size[along] + spacing;
    }
}

void Layout::arrange_list(Widget& widget) {
    const Box inner = inside(widget);
    const Box clip = inner.within(widget.arranged.clip);
    widget.arranged.lines.clear();
    const double bar = widget.arranged.content_height > inner.height() ? measure::scroll_bar : 0;
    if (!widget.content.items.empty()) {
        const Lettering lettering = Lettering::of(widget);
        for (const property::Value& item : widget.content.items) {
            const auto line =
                fitted(media_, lettering, item.is(property::Type::text) ? item.text() : "",
                       inner.width() - bar - 2 * measure::field_x, false);
            widget.arranged.lines.push_back(line.empty() ? "" : line.front());
        }
        return;
    }
    double at = inner.lower.y - scrolled(widget);
    for (const Row child : widget.arranged.children) {
        Widget& one = widgets_[child];
        double width = one.arranged.wanted.x;
        if (!(one.placing.size.x > 0))
            width = std::max(inner.width() - bar, one.placing.min_size.x);
        arrange(child, {{inner.lower.x, at}, {inner.lower.x + width, at + one.arranged.wanted.y}},
                clip);
        at += one.arranged.wanted.y + spacing_of(widget);
    }
}

/// Breaks the text of a widget into lines for the present width of the widget.
void Layout::write(Widget& widget) {
    const Lettering lettering = Lettering::of(widget);
    double width = widget.arranged.box.width();
    const std::string* text = &widget.content.text;
    switch (widget.kind) {
        case Kind::button:
            width -= 2 * measure::button_x;
            if (!widget.content.image.empty())
                width -= widget.arranged.box.height() - 2 * measure::button_y + 8;
            if (widget.content.listening) text = &widget.content.prompt;
            break;
        case Kind::toggle:
            width -= measure::switch_width + 12;
            break;
        case Kind::label:
        case Kind::progress_bar:
            break;
        default:
            return;
    }
    // The width is one pixel of the screen more, because both edges were rounded to such pixels.
    widget.arranged.lines =
        fitted(media_, lettering, *text, width + 1 / scale_,
               widget.style.overflow == "wrap" && widget.kind != Kind::progress_bar);
    const auto fit = static_cast<std::size_t>(
        std::max(1.0, std::floor((widget.arranged.box.height() + 1) / lettering.line_height())));
    if (widget.arranged.lines.size() > fit && !(widget.kind == Kind::label))
        widget.arranged.lines.resize(fit);
}

}  // namespace fettle::interface
