// The natural sizes of widgets.

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include <layout/growing.h>
#include <layout/layout.h>

namespace fettle::interface {

using property::Row;
using property::Vec2;

/// `width`: the available width.
Vec2 Layout::measure(Row row, double width) {
    Widget& widget = widgets_[row];
    if (widget.placing.size.x > 0) width = widget.placing.size.x;
    Vec2 wanted = natural(widget, width);
    for (const int axis : {0, 1})
        if (widget.placing.size[axis] > 0) wanted[axis] = widget.placing.size[axis];
    widget.arranged.wanted = wanted.max(widget.placing.min_size);
    return widget.arranged.wanted;
}

Vec2 Layout::natural(Widget& widget, double width) {
    const Lettering lettering = Lettering::of(widget);
    const double control = std::round(lettering.line_height() + 2 * measure::button_y);
    switch (widget.kind) {
        case Kind::panel:
            return natural_panel(widget, width);
        case Kind::row:
            return natural_line(widget, width, 0);
        case Kind::column:
            return is_grid(widget) ? natural_grid(widget, width) : natural_line(widget, width, 1);
        case Kind::list:
            return natural_list(widget, width);
        case Kind::button:
        case Kind::toggle:
            return natural_control(widget, width);
        case Kind::label:
            return natural_text(widget, width);
        case Kind::image: {
            if (widget.content.image.empty()) return {0, 0};
            const property::Picture& picture = picture_of(widget);
            return {static_cast<double>(picture.width()), static_cast<double>(picture.height())};
        }
        case Kind::slider:
            return {measure::control_width, std::max(control, 2 * measure::knob + 4)};
        case Kind::text_field:
            return {measure::control_width, control};
        case Kind::progress_bar:
            return {measure::control_width,
                    widget.content.text.empty() ? measure::bar : lettering.line_height() + 4};
    }
    return {0, 0};
}

/// A button or a toggle: a text of one line or more beside a picture or a switch.
Vec2 Layout::natural_control(Widget& widget, double width) {
    const Lettering lettering = Lettering::of(widget);
    const double edge = 2 * measure::button_y;
    const double control = std::round(lettering.line_height() + edge);
    const std::string& text =
        widget.content.listening ? widget.content.prompt : widget.content.text;
    double beside = measure::switch_width + (text.empty() ? 0 : 12);
    if (widget.kind == Kind::button) {
        const double icon = widget.content.image.empty() ? 0 : control - edge;
        beside = icon + (icon > 0 && !text.empty() ? 8 : 0) + 2 * measure::button_x;
    }
    if (widget.style.overflow != "wrap")
        return {std::ceil(lettering.width(media_, text)) + beside, control};
    const auto lines = fitted(media_, lettering, text, width - beside, true);
    double widest = 0;
    for (const std::string& line : lines) widest = std::max(widest, lettering.width(media_, line));
    const auto count = static_cast<double>(std::max<std::size_t>(1, lines.size()));
    return {std::ceil(widest) + beside, std::round(count * lettering.line_height() + edge)};
}

/// The least width of a text that grows in a row and wraps; 0 for other widgets.
double Layout::longest_word(const Widget& widget) const {
    if (widget.kind != Kind::label || widget.style.overflow != "wrap" || widget.placing.size.x > 0)
        return 0;
    const Lettering lettering = Lettering::of(widget);
    double longest = 0;
    std::istringstream words(widget.content.text);
    for (std::string word; words >> word;)
        for (const Piece& piece : pieces(word))
            longest = std::max(longest, lettering.width(media_, piece.text));
    return std::max(std::ceil(longest), widget.placing.min_size.x);
}

/// The width to which the widest texts of a row are cut, so that all widgets fit into it; short
/// texts stay whole. `width` if all fit. `needed`: width of the widgets that grow.
double Layout::widest_text(Widget& row, double width, double needed) {
    std::vector<double> texts;
    double room = width - needed;
    for (const Row child : row.arranged.children) {
        Widget& one = widgets_[child];
        if (growth(one, 0) > 0) continue;
        const double wanted = measure(child, width).x;
        if (may_shrink(one))
            texts.push_back(wanted);
        else
            room -= wanted;
    }
    std::sort(texts.begin(), texts.end());
    for (std::size_t i = 0; i < texts.size(); ++i) {
        const double share = room / static_cast<double>(texts.size() - i);
        if (texts[i] > share) return std::max(std::floor(share), measure::narrowest);
        room -= texts[i];
    }
    return width;
}

Vec2 Layout::natural_panel(Widget& widget, double width) {
    const double padding = padding_of(widget);
    Vec2 most(0, 0);
    for (const Row child : widget.arranged.children)
        most = most.max(measure(child, width - 2 * padding));
    return most + 2 * Vec2(padding, padding);
}

/// `along`: 0 for a row, 1 for a column.
Vec2 Layout::natural_line(Widget& widget, double width, int along) {
    const double padding = padding_of(widget), spacing = spacing_of(widget);
    double left = width - 2 * padding;  // of the width, for a row
    const auto count = static_cast<double>(widget.arranged.children.size());
    if (along == 0 && count > 0) left -= spacing * (count - 1);
    Vec2 wanted(0, 0);
    const auto add = [&](Row child, double given) {
        Vec2 one = measure(child, given);
        if (along == 0 && may_shrink(widgets_[child])) {
            one.x = std::min(one.x, std::max(given, widgets_[child].placing.min_size.x));
            widgets_[child].arranged.wanted.x = one.x;
        }
        wanted[along] += one[along];
        wanted[1 - along] = std::max(wanted[1 - along], one[1 - along]);
        if (along == 0) left = std::max(0.0, left - one.x);
    };
    // In a row, widgets that grow share the width that the others leave.
    double shares = 0, needed = 0;
    for (const Row child : widget.arranged.children) {
        const double grow = growth(widgets_[child], along);
        shares += grow;
        if (grow > 0) needed += longest_word(widgets_[child]);
    }
    const double widest = along == 0 ? widest_text(widget, left, needed) : width;
    for (const Row child : widget.arranged.children)
        if (along == 1 || growth(widgets_[child], along) == 0) {
            const bool narrower = may_shrink(widgets_[child]) && widest < left;
            add(child, narrower ? widest : left);
        }
    const double rest = left;
    if (along == 0)
        for (const Row child : widget.arranged.children)
            if (const double grow = growth(widgets_[child], along); grow > 0)
                add(child, rest * grow / shares);
    if (count > 0) wanted[along] += spacing * (count - 1);
    return wanted + 2 * Vec2(padding, padding);
}

Vec2 Layout::natural_list(Widget& widget, double width) {
    const double padding = padding_of(widget), spacing = spacing_of(widget);
    double height = 0, widest = measure::control_width;
    if (!widget.content.items.empty()) {
        const auto count = static_cast<double>(widget.content.items.size());
        height = count * line_of(widget) + (count - 1) * spacing;
    } else {
        for (const Row child : widget.arranged.children) {
            const Vec2 one = measure(child, width - 2 * padding - measure::scroll_bar);
            height += one.y + (height > 0 ? spacing : 0);
            widest = std::max(widest, one.x + 2 * padding + measure::scroll_bar);
        }
    }
    widget.arranged.content_height = height;
    return {std::min(widest, std::max(width, measure::control_width)),
            std::min(height + 2 * padding, measure::list_height)};
}

Vec2 Layout::natural_text(Widget& widget, double width) {
    const Lettering lettering = Lettering::of(widget);
    const auto lines =
        fitted(media_, lettering, widget.content.text, width, widget.style.overflow == "wrap");
    double widest = 0;
    for (const std::string& line : lines) widest = std::max(widest, lettering.width(media_, line));
    return {std::ceil(widest),
            std::ceil(lettering.line_height() *
                      static_cast<double>(std::max<std::size_t>(1, lines.size())))};
}

}  // namespace fettle::interface
