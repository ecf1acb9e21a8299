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

/// The share of the free length that lies before the widget.
double share_before(const std::string& where) {
    return where == "center" ? 0.5 : where == "end" ? 1 : 0;
}

}  // namespace

void Layout::arrange(Row row, Box box, const Box& clip) {
    Widget& widget = widgets_[row];
    box.lower += widget.offset;
    box.upper += widget.offset;
    widget.box = snapped(box);
    widget.clip = clip;
    const double padding = padding_of(widget);
    const Box inner = widget.box.smaller(padding);
    switch (widget.kind) {
        case Kind::panel:
            arrange_panel(widget, inner, clip);
            break;
        case Kind::row:
            arrange_line(widget, inner, clip, 0);
            break;
        case Kind::column:
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
    for (const Row child : widget.children) {
        Widget& one = widgets_[child];
        const auto n = static_cast<int>(std::find(anchors.begin(), anchors.end(), one.anchor) -
                                        anchors.begin());
        const Vec2 part(0.5 * (n % 3), 0.5 * (n / 3));
        Vec2 size = one.wanted;
        for (const int axis : {0, 1})
            if (fills(one, axis)) size[axis] = std::max(inner.size()[axis], one.min_size[axis]);
        const Vec2 lower = inner.lower + part.times(inner.size() - size);
        arrange(child, {lower, lower + size}, clip);
    }
}

/// `along`: 0 for a row, 1 for a column.
void Layout::arrange_line(Widget& widget, const Box& inner, const Box& clip, int along) {
    const double spacing = spacing_of(widget);
    const int across = 1 - along;
    double left = inner.size()[along], shares = 0;
    if (!widget.children.empty()) left -= spacing * static_cast<double>(widget.children.size() - 1);
    // A list that grows may become smaller than what is in it.
    const auto least = [&](const Widget& one) {
        return one.kind == Kind::list && growth(one, along) > 0 ? one.min_size[along]
                                                                : one.wanted[along];
    };
    for (const Row child : widget.children) {
        left -= least(widgets_[child]);
        shares += growth(widgets_[child], along);
    }
    const double spare = std::max(0.0, left);
    double at = inner.lower[along];
    if (shares == 0) at += spare * share_before(widget.justify);
    for (const Row child : widget.children) {
        Widget& one = widgets_[child];
        Vec2 size = one.wanted, lower = inner.lower;
        size[along] = least(one) + (shares > 0 ? spare * growth(one, along) / shares : 0);
        const bool stretched = widget.align == "stretch" && !(one.size[across] > 0);
        const double room = inner.size()[across];
        if (stretched || fills(one, across))
            size[across] = std::max(room, one.min_size[across]);
        else
            lower[across] += share_before(widget.align) * (room - size[across]);
        lower[along] = at;
        arrange(child, {lower, lower + size}, clip);
        at += size[along] + spacing;
    }
}

void Layout::arrange_list(Widget& widget) {
    const Box inner = inside(widget);
    const Box clip = inner.within(widget.clip);
    widget.lines.clear();
    const double bar = widget.content > inner.height() ? measure::scroll_bar : 0;
    if (!widget.items.empty()) {
        const Lettering lettering = Lettering::of(widget);
        for (const property::Value& item : widget.items) {
            const auto line =
                fitted(media_, lettering, item.is(property::Type::text) ? item.text() : "",
                       inner.width() - bar - 2 * measure::field_x, false);
            widget.lines.push_back(line.empty() ? "" : line.front());
        }
        return;
    }
    double at = inner.lower.y - scrolled(widget);
    for (const Row child : widget.children) {
        Widget& one = widgets_[child];
        double width = one.wanted.x;
        if (!(one.size.x > 0)) width = std::max(inner.width() - bar, one.min_size.x);
        arrange(child, {{inner.lower.x, at}, {inner.lower.x + width, at + one.wanted.y}}, clip);
        at += one.wanted.y + spacing_of(widget);
    }
}

/// The lines of its text, for the width that it has now.
void Layout::write(Widget& widget) {
    const Lettering lettering = Lettering::of(widget);
    double width = widget.box.width();
    const std::string* text = &widget.text;
    switch (widget.kind) {
        case Kind::button:
            width -= 2 * measure::button_x;
            if (!widget.image.empty()) width -= widget.box.height() - 2 * measure::button_y + 8;
            if (widget.listening) text = &widget.prompt;
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
    // One pixel of the screen more, because both edges are rounded to such pixels.
    widget.lines = fitted(media_, lettering, *text, width + 1 / scale_,
                          widget.overflow == "wrap" && widget.kind != Kind::progress_bar);
    const auto fit = static_cast<std::size_t>(
        std::max(1.0, std::floor((widget.box.height() + 1) / lettering.line_height())));
    if (widget.lines.size() > fit && !(widget.kind == Kind::label)) widget.lines.resize(fit);
}

}  // namespace fettle::interface
