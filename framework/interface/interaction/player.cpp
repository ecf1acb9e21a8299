#include <interaction/player.h>

#include <algorithm>
#include <array>

#include <fettle/property/last_value.h>

namespace fettle::interface {

using app::Act;
using property::Handle;
using property::Row;
using property::Value;
using property::Vec2;

namespace {

bool among(std::span<const std::string_view> names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
}

constexpr std::array<std::string_view, 10> navigation_keys{
    "up", "down", "left", "right", "tab", "enter", "space", "escape", "home", "end"};
constexpr std::array<std::string_view, 6> navigation_buttons{
    "a", "b", "dpad_up", "dpad_down", "dpad_left", "dpad_right"};
constexpr double pushed = 0.5;                                   // of a stick
constexpr double first_repetition = 0.4, next_repetition = 0.1;  // s, of a direction that is held

}  // namespace

// --- Input that the interface uses

bool Player::takes(const Act& act) {
    if (act.kind == Act::Kind::pointer || act.kind == Act::Kind::mouse_button) mouse_ = act.value;
    if (modal() != nullptr || listening() != nullptr) return true;
    Widget* const now = focused();
    const bool typing = now != nullptr && now->kind == Kind::text_field;
    switch (act.kind) {
        case Act::Kind::key:
            return typing || (now != nullptr && among(navigation_keys, act.name));
        case Act::Kind::text:
            return typing;
        case Act::Kind::mouse_button:
            return widgets_.find(widgets_.board.held) != nullptr || under(at(act.value)) != nullptr;
        case Act::Kind::pointer:
            return widgets_.find(widgets_.board.held) != nullptr;
        case Act::Kind::wheel:
            return list_under(at(mouse_)) != nullptr;
        case Act::Kind::gamepad_button:
            return now != nullptr && among(navigation_buttons, act.name);
        case Act::Kind::stick:
        case Act::Kind::trigger:
            return false;
    }
    return false;
}

void Player::frame(const Vec2& mouse, const Vec2& screen, double seconds) {
    mouse_ = mouse;
    screen_ = screen;
    clicks_.since += seconds;
    lay_out();
    binding_.update_all();
    keep_focus();
    // The held widget may have been deleted, or a restored snapshot may contain one that is held.
    if (widgets_.board.held && (!down_ || widgets_.find(widgets_.board.held) == nullptr)) hold({});
    repeat_direction(seconds);
}

void Player::hold(Handle widget) {
    if (!(widgets_.board.held == widget)) widgets_.set(widgets_.service(), "held", Value(widget));
}

void Player::handle(const Act& act, bool taken) {
    lay_out();
    if (act.kind == Act::Kind::pointer || act.kind == Act::Kind::mouse_button) mouse_ = act.value;
    if (Widget* const button = listening(); button != nullptr && taken) {
        capture(*button, act);
        return;
    }
    switch (act.kind) {
        case Act::Kind::key:
            if (taken && act.down) key(act.name, act.repeated);
            break;
        case Act::Kind::text:
            if (Widget* const field = focused();
                taken && field != nullptr && field->kind == Kind::text_field)
                type(*field, act.name);
            break;
        case Act::Kind::mouse_button:
            if (act.name != "left") break;
            down_ = act.down;
            if (act.down)
                press(at(act.value));
            else
                release(at(act.value));
            break;
        case Act::Kind::pointer:
            if (Widget* const widget = widgets_.find(widgets_.board.held))
                drag(*widget, at(act.value));
            break;
        case Act::Kind::wheel:
            if (Widget* const list = list_under(at(mouse_)); taken && list != nullptr)
                scroll(*list, -act.value.y * 1.5 * Layout::line_of(*list));
            break;
        case Act::Kind::gamepad_button:
            gamepad_button(act, taken);
            break;
        case Act::Kind::stick:
            if (act.name == "left") stick(act, taken);
            break;
        case Act::Kind::trigger:
            break;
    }
}

// --- Gamepads: their directions act as the arrow keys do, also when they are held

void Player::gamepad_button(const Act& act, bool taken) {
    constexpr std::string_view directions = "dpad_";
    if (act.name.starts_with(directions)) {
        const std::string arrow = act.name.substr(directions.size());
        if (!act.down)
            end_direction(arrow);
        else if (taken)
            begin_direction(arrow);
    } else if (taken && act.down && (act.name == "a" || act.name == "b")) {
        key(act.name == "a" ? "enter" : "escape", false);
    }
}

void Player::stick(const Act& act, bool taken) {
    const Vec2 before = std::exchange(stick_, act.value);
    for (const int axis : {0, 1})
        for (const int sign : {1, -1}) {
            const char* const arrow =
                axis == 0 ? (sign > 0 ? "right" : "left") : (sign > 0 ? "up" : "down");
            const bool was = sign * before[axis] > pushed, is = sign * act.value[axis] > pushed;
            if (was && !is) end_direction(arrow);
            if (taken && is && !was) begin_direction(arrow);
        }
}

void Player::begin_direction(const std::string& arrow) {
    direction_ = arrow;
    until_repeated_ = first_repetition;
    key(arrow, false);
}

void Player::end_direction(std::string_view arrow) {
    if (direction_ == arrow) direction_.clear();
}

void Player::repeat_direction(double seconds) {
    if (direction_.empty()) return;
    until_repeated_ -= seconds;
    if (until_repeated_ > 0) return;
    until_repeated_ = next_repetition;
    if (listening() == nullptr && (modal() != nullptr || focused() != nullptr))
        key(direction_, true);
}

// --- Keys

bool Player::holds(const std::string& name) const {
    const property::Tree& tree = widgets_.tree();
    const Handle input = tree.child(tree.root(), "input");
    const Handle keys = input ? tree.child(input, "keys") : Handle{};
    return keys && (last_value(tree, keys, "left_" + name).boolean() ||
                    last_value(tree, keys, "right_" + name).boolean());
}

bool Player::key(const std::string& name, bool repeated) {
    Widget* const now = focused();
    if (now != nullptr && key_of(*now, name)) return true;
    if (name == "tab") {
        next(holds("shift") ? -1 : 1);
    } else if (name == "up") {
        towards({0, -1});
    } else if (name == "down") {
        towards({0, 1});
    } else if (name == "left") {
        towards({-1, 0});
    } else if (name == "right") {
        towards({1, 0});
    } else if ((name == "enter" || name == "space") && !repeated) {
        if (now != nullptr) activate(*now);
    } else if (name == "escape" && !repeated) {
        cancel();
    } else {
        return false;
    }
    return true;
}

/// Keys that the widget uses itself.
bool Player::key_of(Widget& widget, const std::string& name) {
    if (widget.kind == Kind::text_field) return edit(widget, name);
    if (widget.kind == Kind::slider && (name == "left" || name == "right")) {
        nudge(widget, name == "right" ? 1 : -1);
        return true;
    }
    if (widget.kind != Kind::list) return false;
    const auto count = static_cast<std::int64_t>(widget.content.items.size());
    // A number beyond the lines is below the last one.
    std::int64_t line = std::min(widget.content.selected, count + 1);
    if (name == "up")
        line -= 1;
    else if (name == "down")
        line += 1;
    else if (name == "home")
        line = 1;
    else if (name == "end")
        line = count;
    else
        return false;
    // At its ends, the arrow keys leave the list.
    if (line < 1 || line > count) return false;
    select(widget, line);
    return true;
}

void Player::activate(Widget& widget) {
    const Handle self = widget.self;
    if (!(widgets_.board.focus_shown)) focus(&widget, true);
    if (widget.kind == Kind::toggle) {
        switch_over(widget);
    } else if (widget.kind == Kind::list) {
        const auto lines = static_cast<std::int64_t>(widget.content.items.size());
        if (widget.content.selected > 0 && widget.content.selected <= lines)
            widgets_.emit(widget, "submitted", {Value(widget.content.selected)});
    } else if (widget.kind == Kind::button) {
        if (!widget.content.bind.empty()) widgets_.set(self, "listening", Value(true));
        widgets_.emit(widget, "pressed");
    }
}

void Player::cancel() {
    if (Widget* const top = modal())
        widgets_.emit(*top, "cancelled");
    else
        focus(nullptr, widgets_.board.focus_shown);
}

void Player::capture(Widget& button, const Act& act) {
    std::string name;
    if (act.kind == Act::Kind::key && act.down && !act.repeated) name = act.name;
    if (act.kind == Act::Kind::mouse_button && act.down) name = "mouse." + act.name;
    const bool numbered = !act.name.empty() && act.name[0] >= '0' && act.name[0] <= '9';
    if (act.kind == Act::Kind::gamepad_button && act.down && !numbered)
        name = "gamepad." + act.name;
    if (act.kind == Act::Kind::trigger && act.value.x > pushed) name = "gamepad." + act.name;
    if (name.empty()) return;
    const Handle self = button.self;
    widgets_.set(self, "listening", Value(false));
    if (name == "escape" || !widgets_.tree().alive(self)) return;
    if (!button.content.bind.empty()) binding_.choose(button, name);
    widgets_.emit(button, "captured", {Value(name)});
}

}  // namespace fettle::interface
