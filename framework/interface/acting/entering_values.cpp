// Values that the player chooses or types.

#include <algorithm>
#include <cmath>

#include <acting/player.h>

namespace fettle::interface {

using property::Handle;
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
    value = std::clamp(value, range.min, range.max);
    if (!std::isfinite(value) || value == slider.content.value) return;
    const double before = slider.content.value;
    widgets_.set(slider.self, "value", Value(value));
    binding_.update(slider);
    if (slider.content.value != before)
        widgets_.emit(slider, "changed", {Value(slider.content.value)});
}

void Player::nudge(Widget& slider, int direction) {
    const property::Range range = binding_.range(slider);
    const double step = binding_.step(slider);
    choose_value(slider, slider.content.value +
                             direction * (step > 0 ? step : 0.05 * (range.max - range.min)));
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

// --- Text

void Player::set_text(Widget& field, const std::string& text, std::int64_t caret) {
    const std::string before = field.content.text;
    widgets_.set(field.self, "text", Value(text));
    widgets_.set(field.self, "caret", Value(caret));
    if (!field.content.bind.empty()) binding_.update(field);
    if (field.content.text != before) widgets_.emit(field, "changed", {Value(field.content.text)});
}

void Player::type(Widget& field, const std::string& text) {
    const std::int64_t length = characters(field.content.text);
    if (field.content.max_length > 0 && length + characters(text) > field.content.max_length)
        return;
    constexpr std::size_t most = 1 << 20;
    if (field.content.text.size() + text.size() > most) return;
    const std::int64_t caret = std::min(field.content.caret, length);
    std::string longer = field.content.text;
    longer.insert(byte_of(longer, caret), text);
    set_text(field, longer, caret + characters(text));
}

/// False for a key that has no meaning in a text.
bool Player::edit(Widget& field, const std::string& key) {
    const std::int64_t length = characters(field.content.text);
    const std::int64_t caret = std::min(field.content.caret, length);
    const auto without = [&](std::int64_t n) {
        std::string shorter = field.content.text;
        const std::size_t from = byte_of(shorter, n), to = byte_of(shorter, n + 1);
        return shorter.erase(from, to - from);
    };
    std::int64_t to = caret;
    if (key == "left" || key == "right") {
        // In a text that begins at the right, the key with the arrow to the left goes on in it.
        const std::vector<double> carets =
            Lettering::of(field).carets(layout_.media(), field.content.text);
        const bool onward = (key == "left") == (carets.front() > carets.back());
        to = std::clamp<std::int64_t>(caret + (onward ? 1 : -1), 0, length);
    } else if (key == "home")
        to = 0;
    else if (key == "end")
        to = length;
    else if (key == "backspace") {
        if (caret > 0) set_text(field, without(caret - 1), caret - 1);
        return true;
    } else if (key == "delete") {
        if (caret < length) set_text(field, without(caret), caret);
        return true;
    } else if (key == "enter") {
        widgets_.emit(field, "submitted", {Value(field.content.text)});
        return true;
    } else {
        // A space is typed as text.
        return key == "space";
    }
    if (to != field.content.caret) widgets_.set(field.self, "caret", Value(to));
    return true;
}

}  // namespace fettle::interface
