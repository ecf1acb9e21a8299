// The effect of the mouse.

#include <algorithm>
#include <cmath>

#include <interaction/player.h>

namespace fettle::interface {

using property::Row;
using property::Value;
using property::Vec2;

namespace {

/// True if a click on it does not reach what lies below it.
bool is_solid(const Widget& widget) {
    return is_active(widget.kind) || widget.kind == Kind::panel ||
           (is_container(widget.kind) && (widget.modal || widget.style.color));
}

}  // namespace

Widget* Player::under(const Vec2& point) {
    lay_out();
    const auto& shown = layout_.shown();
    Widget* const top = modal();
    for (auto row = shown.rbegin(); row != shown.rend(); ++row) {
        Widget& widget = widgets_[*row];
        if (is_solid(widget) && widget.arranged.box.contains(point) &&
            widget.arranged.clip.contains(point)) {
            if (top != nullptr && !inside(widget, *top)) continue;
            return &widget;
        }
    }
    return nullptr;
}

const Widget* Player::seen_at(const Vec2& pixels) {
    lay_out();
    const Vec2 point = at(pixels);
    const auto& shown = layout_.shown();
    for (auto row = shown.rbegin(); row != shown.rend(); ++row) {
        const Widget& widget = widgets_[*row];
        const bool drawn = !is_container(widget.kind) || has_background(widget);
        if (drawn && widget.arranged.box.contains(point) && widget.arranged.clip.contains(point))
            return &widget;
    }
    return nullptr;
}

Widget* Player::list_under(const Vec2& point) {
    for (Widget* each = under(point); each != nullptr; each = above(*each))
        if (each->kind == Kind::list &&
            each->arranged.content_height > Layout::inside(*each).height())
            return each;
    return nullptr;
}

void Player::press(const Vec2& point) {
    Widget* const widget = under(point);
    Widget* const before = focused();
    const bool is_modal = modal() != nullptr;
    if (widget == nullptr || !enabled(*widget) || !is_active(widget->kind)) {
        // A click outside of all widgets takes the keyboard from a widget, but not from a modal
        // menu.
        if (before != nullptr && !is_modal) focus(nullptr, false);
        return;
    }
    hold(widget->self);
    drags_bar_ = false;
    // In a menu that is always visible, a click must not take the keyboard from the game.
    const bool takes_keys = is_modal || widget->kind == Kind::text_field || before != nullptr;
    if (takes_keys && can_focus(*widget)) focus(widget, false);
    const Box inner = Layout::inside(*widget);
    if (widget->kind == Kind::slider) {
        drag(*widget, point);
    } else if (widget->kind == Kind::list) {
        drags_bar_ = widget->arranged.content_height > inner.height() &&
                     point.x > inner.upper.x - measure::scroll_bar;
        if (drags_bar_) {
            drag(*widget, point);
        } else if (!widget->content.items.empty() && inner.contains(point)) {
            const double each = Layout::line_of(*widget) + Layout::spacing_of(*widget);
            const auto line = static_cast<std::int64_t>(
                std::floor((point.y - inner.lower.y + Layout::scrolled(*widget)) / each));
            if (line < 0 || line >= static_cast<std::int64_t>(widget->content.items.size())) return;
            if (widget->content.selected == line + 1)
                widgets_.emit(*widget, "submitted", {Value(widget->content.selected)});
            else
                select(*widget, line + 1);
        }
    } else if (widget->kind == Kind::text_field) {
        press_text(*widget, point);
    }
}

void Player::release(const Vec2& point) {
    Widget* const widget = widgets_.find(widgets_.board.held);
    hold({});
    if (widget == nullptr || under(point) != widget || !enabled(*widget)) return;
    if (widget->kind == Kind::toggle) {
        switch_over(*widget);
    } else if (widget->kind == Kind::button) {
        if (!widget->content.bind.empty()) widgets_.set(widget->self, "listening", Value(true));
        widgets_.emit(*widget, "pressed");
    }
}

void Player::drag(Widget& widget, const Vec2& point) {
    if (!enabled(widget)) return;
    if (widget.kind == Kind::slider) {
        const double from = widget.arranged.box.lower.x + measure::knob;
        const double length = std::max(1.0, widget.arranged.box.width() - 2 * measure::knob);
        const double share = std::clamp((point.x - from) / length, 0.0, 1.0);
        const property::Range range = binding_.range(widget);
        choose_value(widget, range.min + share * (range.max - range.min));
    } else if (widget.kind == Kind::list && drags_bar_) {
        const Box inner = Layout::inside(widget);
        const double length = inner.height();
        const double bar =
            std::max(24.0, length * length / std::max(length, widget.arranged.content_height));
        const double share = (point.y - inner.lower.y - 0.5 * bar) / std::max(1.0, length - bar);
        const double wanted =
            std::clamp(share, 0.0, 1.0) * (widget.arranged.content_height - length);
        scroll(widget, wanted - Layout::scrolled(widget));
    } else if (widget.kind == Kind::text_field) {
        drag_text(widget, point);
    }
}

void Player::scroll(Widget& list, double pixels) {
    const double most = std::max(0.0, list.arranged.content_height - Layout::inside(list).height());
    const double to = std::clamp(Layout::scrolled(list) + pixels, 0.0, most);
    if (to != list.content.scroll) widgets_.set(list.self, "scroll", Value(to));
    lay_out();
}

}  // namespace fettle::interface
