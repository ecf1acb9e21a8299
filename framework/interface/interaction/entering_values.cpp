// Values that the player chooses. Those that are typed: editing.cpp.

#include <algorithm>
#include <cmath>

#include <interaction/player.h>

namespace fettle::interface {

using property::Value;

namespace {

/// The value without the last digits, in which sums of steps are not exact: 0.6 and not
/// 0.6000000000000001.
double rounded(double value, double step) {
    constexpr double parts = 1e9;  // of a step: smaller differences are not kept
    const double scale = parts * std::pow(10, std::ceil(-std::log10(step)));
    const double scaled = std::round(value * scale);
    return std::abs(scaled) < 1e15 ? scaled / scale + 0.0 : value;  // no -0
}

}  // namespace

void Player::choose_value(Widget& slider, double value) {
    const property::Range range = binding_.range(slider);
    if (const double step = binding_.step(slider); step > 0)
        value = rounded(range.min + step * std::round((value - range.min) / step), step);
    const auto [least, greatest] = std::minmax(range.min, range.max);
    value = std::clamp(value, least, greatest);
    if (!std::isfinite(value) || value == slider.content.value) return;
    const double before = slider.content.value;
    widgets_.set(slider.self, "value", Value(value));
    binding_.update(slider);
    if (slider.content.value != before)
        widgets_.emit(slider, "changed", {Value(slider.content.value)});
}

void Player::nudge(Widget& slider, int direction) {
    const property::Range range = binding_.range(slider);
    const double length = range.max - range.min, step = binding_.step(slider);
    choose_value(slider, slider.content.value +
                             direction * (step > 0 ? std::copysign(step, length) : 0.05 * length));
}

void Player::switch_over(Widget& toggle) {
    const bool before = toggle.content.on;
    widgets_.set(toggle.self, "value", Value(!before));
    binding_.update(toggle);
    if (toggle.content.on != before) widgets_.emit(toggle, "changed", {Value(toggle.content.on)});
}

void Player::select(Widget& list, std::int64_t line) {
    if (list.content.selected == line) return;
    widgets_.set(list.self, "selected", Value(line));
    binding_.update(list);
    show_line(list);
    widgets_.emit(list, "changed", {Value(list.content.selected)});
}

/// Scrolls to the chosen line.
void Player::show_line(Widget& list) {
    const double line = Layout::line_of(list);
    const double top =
        static_cast<double>(list.content.selected - 1) * (line + Layout::spacing_of(list));
    const double height = Layout::inside(list).height(), from = Layout::scrolled(list);
    if (top < from)
        scroll(list, top - from);
    else if (top + line > from + height)
        scroll(list, top + line - from - height);
}

}  // namespace fettle::interface
