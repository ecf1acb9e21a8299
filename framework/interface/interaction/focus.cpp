// Which widget has the keyboard.

#include <cmath>
#include <limits>

#include <interaction/player.h>

namespace fettle::interface {

using property::Handle;
using property::Row;
using property::Value;
using property::Vec2;

Widget* Player::above(const Widget& widget) {
    return widget.arranged.parent == no_widget ? nullptr : &widgets_[widget.arranged.parent];
}

bool Player::inside(const Widget& widget, const Widget& top) {
    for (const Widget* each = &widget; each != nullptr; each = above(*each))
        if (each == &top) return true;
    return false;
}

bool Player::enabled(const Widget& widget) {
    for (const Widget* each = &widget; each != nullptr; each = above(*each))
        if (each->disabled) return false;
    return true;
}

Widget* Player::modal() {
    lay_out();
    const auto& shown = layout_.shown();
    for (auto row = shown.rbegin(); row != shown.rend(); ++row)
        if (Widget& widget = widgets_[*row]; widget.modal && is_container(widget.kind))
            return &widget;
    return nullptr;
}

bool Player::can_focus(const Widget& widget) {
    return is_active(widget.kind) && widget.focusable && widget.arranged.shown && enabled(widget) &&
           (widget.kind != Kind::list || !widget.content.items.empty());
}

Widget* Player::focused() {
    lay_out();
    Widget* const widget = widgets_.find(widgets_.board.focus);
    return widget != nullptr && can_focus(*widget) ? widget : nullptr;
}

Widget* Player::listening() {
    lay_out();
    for (const Row row : layout_.shown())
        if (Widget& widget = widgets_[row]; widget.content.listening && enabled(widget))
            return &widget;
    return nullptr;
}

void Player::focus(Widget* widget, bool shown) {
    const Handle before = widgets_.board.focus, now = widget ? widget->self : Handle{};
    const Handle service = widgets_.service();
    if (!widgets_.tree().alive(service)) return;
    if (widgets_.board.focus_shown != shown) widgets_.set(service, "focus_shown", Value(shown));
    if (before == now) return;
    if (modal() == nullptr) outside_ = now;
    widgets_.set(service, "focus", Value(now));
    if (Widget* const field = widgets_.find(before); field && !field->content.bind.empty())
        binding_.update(*field);
    if (widget == nullptr) return;
    if (widget->kind == Kind::text_field) widgets_.select_text(*widget);
    for (Widget* each = above(*widget); each != nullptr; each = above(*each)) {
        if (each->modal && !(each->last_focus == now))
            widgets_.set(each->self, "last_focus", Value(now));
        if (each->kind == Kind::list) {
            // A list scrolls to it.
            const Box inner = Layout::inside(*each);
            const double over = inner.lower.y - widget->arranged.box.lower.y;
            const double under = widget->arranged.box.upper.y - inner.upper.y;
            if (over > 0)
                scroll(*each, -over);
            else if (under > 0)
                scroll(*each, under);
        }
    }
}

/// Gives the keyboard to the modal widget in front, and takes it from a widget that cannot have it.
/// When no modal widget is left, the widget that had the keyboard before gets it again.
void Player::keep_focus() {
    Widget* const now = focused();
    Widget* const top = modal();
    const Handle beneath = widgets_.board.focus_beneath;
    if (top == nullptr) {
        Widget* const before = widgets_.find(beneath);
        if (now == nullptr && before != nullptr && can_focus(*before))
            focus(before, widgets_.board.focus_shown);
        else if (now == nullptr && widgets_.board.focus)
            focus(nullptr, widgets_.board.focus_shown);
        if (beneath) widgets_.set(widgets_.service(), "focus_beneath", Value(Handle{}));
        outside_ = widgets_.board.focus;
        return;
    }
    if (outside_ && !beneath) widgets_.set(widgets_.service(), "focus_beneath", Value(outside_));
    outside_ = {};
    if (now != nullptr && inside(*now, *top)) return;
    Widget* last = widgets_.find(top->last_focus);
    if (last == nullptr || !can_focus(*last) || !inside(*last, *top)) {
        const std::vector<Widget*> all = reachable();
        last = all.empty() ? nullptr : all.front();
    }
    if (last != nullptr || widgets_.board.focus) focus(last, widgets_.board.focus_shown);
}

/// The widgets that can have the keyboard now.
std::vector<Widget*> Player::reachable() {
    std::vector<Widget*> all;
    Widget* const top = modal();
    Widget* const now = focused();
    const Widget* root = now;
    while (root != nullptr && above(*root) != nullptr) root = above(*root);
    for (const Row row : layout_.shown()) {
        Widget& widget = widgets_[row];
        if (!can_focus(widget)) continue;
        if (top != nullptr ? inside(widget, *top) : root == nullptr || inside(widget, *root))
            all.push_back(&widget);
    }
    return all;
}

/// `direction`: 1 or -1.
void Player::next(int direction) {
    const std::vector<Widget*> all = reachable();
    if (all.empty()) return;
    Widget* const now = focused();
    const auto count = static_cast<int>(all.size());
    int at = direction > 0 ? -1 : count;
    for (int i = 0; i < count; ++i)
        if (all[static_cast<std::size_t>(i)] == now) at = i;
    const int next = (at + direction + count) % count;  // NOLINT: there is a widget
    focus(all[static_cast<std::size_t>(next)], true);
}

/// The nearest widget in that direction; if there is none, the farthest in the opposite one. Left
/// and right stay in a row: a disabled widget leads to the next one, and not out of the row.
/// `direction`: one of the four, y down.
void Player::towards(const Vec2& direction) {
    Widget* const now = focused();
    const std::vector<Widget*> all = reachable();
    if (now == nullptr) {
        if (!all.empty()) focus(all.front(), true);
        return;
    }
    Widget *best = nullptr, *in_row = nullptr;
    double least = std::numeric_limits<double>::infinity();
    double least_in_row = least;
    Widget* opposite = nullptr;
    double farthest = 0;
    const int along = direction.x != 0 ? 0 : 1, across = 1 - along;
    for (Widget* each : all) {
        if (each == now) continue;
        const Vec2 apart = each->arranged.box.center() - now->arranged.box.center();
        const double ahead = apart.dot(direction);
        // A widget in line with it is preferred to one beside the line.
        const double overlap =
            std::min(each->arranged.box.upper[across], now->arranged.box.upper[across]) -
            std::max(each->arranged.box.lower[across], now->arranged.box.lower[across]);
        const double aside = overlap > 0 ? 0 : -overlap;
        // Left and right never lead to a widget above or below the row.
        const bool leaves_row = along == 0 && overlap <= 0 && std::abs(apart[across]) > ahead;
        if (ahead > 1 && !leaves_row && ahead + 3 * aside < least) {
            least = ahead + 3 * aside;
            best = each;
        }
        if (along == 0 && overlap > 0 && ahead > 1 && ahead < least_in_row) {
            least_in_row = ahead;
            in_row = each;
        }
        if (-ahead > farthest && overlap > 0) {
            farthest = -ahead;
            opposite = each;
        }
    }
    if (in_row != nullptr)
        best = in_row;
    else if (best == nullptr || (along == 0 && opposite != nullptr))
        best = opposite;
    focus(best != nullptr ? best : now, true);
}

}  // namespace fettle::interface
