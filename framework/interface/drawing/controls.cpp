// Draws controls: buttons, sliders, text fields and others.

#include <algorithm>
#include <cmath>

#include <drawing/colors.h>
#include <drawing/picture.h>

namespace fettle::interface {

using property::Color;
using property::TextAlign;
using property::Vec2;

/// Where the value lies between the ones at the left and the right end.
double Picture::share(const Widget& widget) const {
    const property::Range range = binding_.range(widget);
    if (range.max == range.min) return 0;
    return std::clamp((widget.content.value - range.min) / (range.max - range.min), 0.0, 1.0);
}

void Picture::draw_button(const Widget& widget) {
    const Theme& theme = *widget.arranged.look_of;
    const bool quiet = widget.style.look == "quiet" && !widget.style.color;
    const bool accent = widget.style.look == "accent" || widget.content.listening;
    Color fill = widget.style.color.value_or(accent ? theme.accent : theme.control);
    Color ink = accent ? theme.on_accent : theme.text;
    if (widget.style.color && !accent) ink = readable_on(fill);
    if (quiet && !accent)
        fill.a *=
            static_cast<float>(0.75 * std::max(widget.animation.hover, widget.animation.press));
    box(widget.arranged.box, radius_of(widget),
        touched(fill, widget.animation.hover, widget.animation.press),
        quiet ? none : mixed(theme.border, {1, 1, 1, theme.border.a}, 0.5));
    Box inner = widget.arranged.box;
    inner.lower.x += measure::button_x;
    inner.upper.x -= measure::button_x;
    if (!widget.content.image.empty()) {
        const double side = widget.arranged.box.height() - 2 * measure::button_y;
        const double x = widget.arranged.lines.empty() ? widget.arranged.box.center().x - 0.5 * side
                                                       : inner.lower.x;
        const Vec2 lower(x, widget.arranged.box.center().y - 0.5 * side);
        draw_image(widget, {lower, lower + Vec2(side, side)}, {1, 1, 1, 1});
        inner.lower.x += side + 8;
    }
    draw_lines(widget, inner, widget.style.text_color.value_or(ink));
}

void Picture::draw_slider(const Widget& widget) {
    const Theme& theme = *widget.arranged.look_of;
    constexpr double half = 3;
    const Color full = widget.style.color.value_or(theme.accent);
    const double y = widget.arranged.box.center().y;
    const double from = widget.arranged.box.lower.x + measure::knob;
    const double to = widget.arranged.box.upper.x - measure::knob;
    const double x = from + share(widget) * std::max(0.0, to - from);
    box({{from - half, y - half}, {to + half, y + half}}, half, theme.control);
    box({{from - half, y - half}, {x + half, y + half}}, half,
        touched(full, widget.animation.hover, 0));
    if (widget.animation.hover > 0)
        disc({x, y}, measure::knob + 6 * widget.animation.hover,
             {full.r, full.g, full.b, static_cast<float>(0.28 * widget.animation.hover)});
    disc({x, y + 1}, measure::knob + 0.5, {0, 0, 0, 0.3f});
    disc({x, y}, measure::knob - widget.animation.press, {1, 1, 1, 1});
}

void Picture::draw_toggle(const Widget& widget) {
    const Theme& theme = *widget.arranged.look_of;
    const double share = std::max(0.0, widget.animation.switched);
    const Color track = mixed(theme.control, widget.style.color.value_or(theme.accent), share);
    const double y = widget.arranged.box.center().y, half = 0.5 * measure::switch_height;
    const double left = widget.arranged.box.lower.x;
    box({{left, y - half}, {left + measure::switch_width, y + half}}, half,
        touched(track, widget.animation.hover, widget.animation.press), theme.border);
    const double x = left + half + share * (measure::switch_width - 2 * half);
    disc({x, y + 1}, half - 3, {0, 0, 0, 0.25f});
    disc({x, y}, half - 3.5, {1, 1, 1, 1});
    Box text = widget.arranged.box;
    text.lower.x += measure::switch_width + 12;
    draw_lines(widget, text, widget.style.text_color.value_or(theme.text));
}

/// The selection: one box for each part that is whole on the screen, since letters that are read
/// from right to left may be among others.
void Picture::draw_selection(const Widget& field, const std::vector<double>& carets,
                             const Vec2& at) {
    const auto last = static_cast<std::int64_t>(carets.size()) - 1;
    const std::int64_t mark = std::min(*field.content.mark, last);
    const std::int64_t caret = std::min(field.content.caret, last);
    const double half = 0.62 * Lettering::of(field).size;
    Color color = field.arranged.look_of->accent;
    color.a *= 0.45f;
    std::int64_t from = std::min(mark, caret);
    const std::int64_t to = std::max(mark, caret);
    while (from < to) {
        const auto x = [&](std::int64_t n) { return carets[static_cast<std::size_t>(n)]; };
        const bool rises = x(from + 1) >= x(from);
        std::int64_t end = from + 1;
        while (end < to && (x(end + 1) >= x(end)) == rises) ++end;
        box({{at.x + std::min(x(from), x(end)), at.y - half},
             {at.x + std::max(x(from), x(end)), at.y + half}},
            0, color);
        from = end;
    }
}

void Picture::draw_field(Widget& widget) {
    const Theme& theme = *widget.arranged.look_of;
    const bool focused = widgets_.board.focus == widget.self;
    const Color edge = mixed(mixed(theme.border, theme.muted, 0.5 * widget.animation.hover),
                             theme.accent, focused ? 1 : 0);
    box(widget.arranged.box, radius_of(widget), theme.field, edge);
    const Lettering lettering = Lettering::of(widget);
    Box inner = widget.arranged.box;
    inner.lower.x += measure::field_x;
    inner.upper.x -= measure::field_x;
    const std::vector<double> carets = lettering.carets(layout_.media(), widget.content.text);
    const double caret = caret_at(carets, widget.content.caret);
    // The text moves so that the caret is seen.
    if (!focused) widget.animation.view_left = 0;
    widget.animation.view_left =
        std::clamp(widget.animation.view_left, caret - inner.width() + 2, caret);
    widget.animation.view_left = std::max(0.0, widget.animation.view_left);
    painter_->push({});
    painter_->clip(inner.lower - Vec2(2, 0), inner.upper + Vec2(2, 0));
    const Vec2 at(inner.lower.x - widget.animation.view_left, inner.center().y);
    if (focused && widget.content.mark) draw_selection(widget, carets, at);
    if (widget.content.text.empty())
        draw_text(at, widget.content.placeholder, widget, theme.muted, TextAlign::left);
    else
        draw_text(at, widget.content.text, widget, widget.style.text_color.value_or(theme.text),
                  TextAlign::left);
    if (focused && std::fmod(time_, 1.1) < 0.7) {
        const double x = at.x + caret, half = 0.62 * lettering.size;
        box({{x - 0.75, at.y - half}, {x + 0.75, at.y + half}}, 0, theme.text);
    }
    painter_->pop();
}

void Picture::draw_progress(const Widget& widget) {
    const Theme& theme = *widget.arranged.look_of;
    const double radius = 0.5 * std::min(widget.arranged.box.height(), 2 * radius_of(widget));
    box(widget.arranged.box, radius, theme.field, theme.border);
    const double full = share(widget) * widget.arranged.box.width();
    if (full > 0) {
        // The whole bar, cut where it ends, so that a short part keeps the round corners.
        painter_->push({});
        painter_->clip(widget.arranged.box.lower,
                       {widget.arranged.box.lower.x + full, widget.arranged.box.upper.y});
        box(widget.arranged.box.smaller(1), radius - 1, widget.style.color.value_or(theme.accent));
        painter_->pop();
    }
    draw_lines(widget, widget.arranged.box, widget.style.text_color.value_or(theme.text));
}

void Picture::draw_list(const Widget& widget) {
    const Theme& theme = *widget.arranged.look_of;
    const Box inner = Layout::inside(widget);
    if (inner.width() <= 0 || inner.height() <= 0) return;
    const double from = Layout::scrolled(widget), line = Layout::line_of(widget);
    const bool scrolls = widget.arranged.content_height > inner.height() + 0.5;
    painter_->push({});
    painter_->clip(inner.lower, inner.upper);
    const double each = line + Layout::spacing_of(widget);
    const auto first = static_cast<std::size_t>(std::max(0.0, std::floor(from / each)));
    for (std::size_t i = first; i < widget.arranged.lines.size(); ++i) {
        const double top = inner.lower.y + static_cast<double>(i) * each - from;
        if (top > inner.upper.y) break;
        const Box row{{inner.lower.x, top},
                      {inner.upper.x - (scrolls ? measure::scroll_bar : 0), top + line}};
        const bool chosen = widget.content.selected == static_cast<std::int64_t>(i) + 1;
        if (chosen) box(row, std::max(0.0, radius_of(widget) - 3), theme.accent);
        Box text = row.smaller(0);
        text.lower.x += measure::field_x, text.upper.x -= measure::field_x;
        const Color ink = chosen ? theme.on_accent : widget.style.text_color.value_or(theme.text);
        const TextAlign align = widget.style.text_align == "left"    ? TextAlign::left
                                : widget.style.text_align == "right" ? TextAlign::right
                                                                     : TextAlign::middle;
        const double x = align == TextAlign::left    ? text.lower.x
                         : align == TextAlign::right ? text.upper.x
                                                     : text.center().x;
        draw_text({x, text.center().y}, widget.arranged.lines[i], widget, ink, align);
    }
    painter_->pop();
    if (!scrolls) return;
    const double length = inner.height();
    const double bar = std::max(24.0, length * length / widget.arranged.content_height);
    const double top =
        inner.lower.y + from / (widget.arranged.content_height - length) * (length - bar);
    Color color = theme.muted;
    color.a *= static_cast<float>(0.45 + 0.3 * widget.animation.hover);
    box({{inner.upper.x - 7, top}, {inner.upper.x - 1, top + bar}}, 3, color);
}

}  // namespace fettle::interface
