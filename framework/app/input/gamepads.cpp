// Sticks, triggers and buttons of gamepads. The parts of a gamepad set one another: buttons by
// number and by name, the directional pad and its four buttons, axes and what they move.
//
// A property that is set sets the other properties of the same part, each by its own write, so that
// watchers and callbacks are called for all of them. The own value is set first. The others then
// find it equal and stop.

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include <input/input_state.h>

namespace fettle::app {

using property::Handle;
using property::Vec2;

namespace {

constexpr std::array<std::string_view, pad_targets> target_properties{
    "left", "left", "right", "right", "left_trigger", "right_trigger"};

bool is_trigger(std::size_t target) {
    return target >= static_cast<std::size_t>(PadTarget::left_trigger);
}

/// The component of the directional pad that a direction of the hat moves, and the sign of it.
struct HatPart {
    int component = 0;
    double sign = 1;
};
HatPart hat_part(int direction) {
    switch (direction) {
        case 1:
            return {1, 1};
        case 2:
            return {0, 1};
        case 4:
            return {1, -1};
        default:
            return {0, -1};
    }
}

/// The value of an axis in an entry of a mapping, which may invert it or use one half of it.
double mapped(const PadSource& source, double value) {
    if (source.inverted) value = -value;
    return source.half == 0 ? value : std::max(0.0, value * source.half);
}

std::string axis_name(std::string_view stick, int component) {
    return std::string(stick) + (component == 0 ? "_x" : "_y");
}

}  // namespace

void Input::State::press_raw(Gamepad& gamepad, std::size_t button, bool down) {
    gamepad.buttons[button] = down;
    queue_switch({.kind = Act::Kind::gamepad_button,
                  .name = contexts.buttons[button].name,
                  .down = down,
                  .gamepad = number_of(gamepad)},
                 gamepad.taken_buttons[button], down ? "gamepad_pressed" : "gamepad_released",
                 {number_of(gamepad), contexts.buttons[button].name});
    const auto is_this = [button](const PadSource& source) {
        return source.kind == PadSource::Kind::button && source.index == static_cast<int>(button);
    };
    for (std::size_t i = 0; i < gamepad.named.size(); ++i)
        if (is_this(gamepad.mapping.buttons[i]) && gamepad.named[i] != down)
            tree.set(gamepad.instance, gamepad_button_names[i], down);
    for (std::size_t i = 0; i < pad_targets; ++i)
        if (is_trigger(i) && is_this(gamepad.mapping.targets[i]))
            tree.set(gamepad.instance, target_properties[i], down ? 1.0 : 0.0);
    update_actions();
}

void Input::State::press_named(Gamepad& gamepad, std::size_t button, bool down) {
    gamepad.named[button] = down;
    const std::string name(gamepad_button_names[button]);
    queue_switch({.kind = Act::Kind::gamepad_button,
                  .name = name,
                  .down = down,
                  .gamepad = number_of(gamepad)},
                 gamepad.taken_named[button], down ? "gamepad_pressed" : "gamepad_released",
                 {number_of(gamepad), name});
    const PadSource& source = gamepad.mapping.buttons[button];
    if (source.kind == PadSource::Kind::button) {
        const auto raw = static_cast<std::size_t>(source.index);
        if (gamepad.buttons[raw] != down)
            tree.set(gamepad.instance, "button_" + contexts.buttons[raw].name, down);
    } else if (source.kind == PadSource::Kind::hat) {
        const HatPart part = hat_part(source.index);
        Vec2 pad = gamepad.sticks[hat_stick];
        const bool is_down = pad[part.component] * part.sign > 0.5;
        pad[part.component] = down ? part.sign : 0;
        if (is_down != down) tree.set(gamepad.instance, gamepad_stick_names[hat_stick], pad);
    }
    update_actions();
}

void Input::State::press_hat_buttons(Gamepad& gamepad) {
    for (std::size_t i = 0; i < gamepad.named.size(); ++i) {
        const PadSource& source = gamepad.mapping.buttons[i];
        if (source.kind != PadSource::Kind::hat) continue;
        const HatPart part = hat_part(source.index);
        const bool down = gamepad.sticks[hat_stick][part.component] * part.sign > 0.5;
        if (gamepad.named[i] != down) tree.set(gamepad.instance, gamepad_button_names[i], down);
    }
}

/// Buttons that are down get their new names.
void Input::State::set_mapping(Gamepad& gamepad, const std::string& text) {
    const GamepadMapping mapping = parse_gamepad_mapping(text);
    for (std::size_t i = 0; i < gamepad.named.size(); ++i)
        if (gamepad.named[i]) {
            gamepad.mapping.buttons[i] = {};  // the device's button stays down
            tree.set(gamepad.instance, gamepad_button_names[i], false);
        }
    gamepad.mapping = mapping;
    gamepad.mapping_text = text;
    for (std::size_t i = 0; i < gamepad.named.size(); ++i) {
        const PadSource& source = mapping.buttons[i];
        if (source.kind == PadSource::Kind::button &&
            gamepad.buttons[static_cast<std::size_t>(source.index)])
            tree.set(gamepad.instance, gamepad_button_names[i], true);
    }
    press_hat_buttons(gamepad);
}

void Input::State::move_raw_axis(Gamepad& gamepad, std::size_t axis, double value) {
    const auto is_this = [axis](const PadSource& source) {
        return source.kind == PadSource::Kind::axis && source.index == static_cast<int>(axis);
    };
    bool used = false;
    for (std::size_t i = 0; i < pad_targets; ++i) {
        const PadSource& source = gamepad.mapping.targets[i];
        if (!is_this(source)) continue;
        used = true;
        const double now = mapped(source, value);
        if (is_trigger(i)) {
            const double pulled = source.half == 0 ? 0.5 * (now + 1) : now;
            tree.set(gamepad.instance, target_properties[i], pulled);
            continue;
        }
        const int component = static_cast<int>(i % 2);
        Vec2 stick = gamepad.sticks[i / 2];
        stick[component] = component == 0 ? now : -now;
        tree.set(gamepad.instance, target_properties[i], stick);
    }
    for (std::size_t i = 0; i < gamepad.named.size(); ++i) {
        const PadSource& source = gamepad.mapping.buttons[i];
        if (!is_this(source)) continue;
        used = true;
        tree.set(gamepad.instance, gamepad_button_names[i], mapped(source, value) > 0.5);
    }
    constexpr std::size_t hat_x = 6, hat_y = 7;
    if (used || (axis != hat_x && axis != hat_y)) return;
    Vec2 pad = gamepad.sticks[hat_stick];
    pad[axis == hat_x ? 0 : 1] = axis == hat_x ? value : -value;
    tree.set(gamepad.instance, gamepad_stick_names[hat_stick], pad);
}

void Input::State::move_stick(Gamepad& gamepad, std::size_t stick, const Vec2& wanted) {
    const Vec2 from = gamepad.sticks[stick];
    const Vec2 to = wanted + Vec2(0, 0);  // a device whose y is the other way gives -0
    gamepad.sticks[stick] = to;
    Act act{.kind = Act::Kind::stick,
            .name = std::string(gamepad_stick_names[stick]),
            .gamepad = number_of(gamepad),
            .value = to};
    bool& taken = gamepad.taken_sticks[stick];
    // A stick that the foreground uses moves the game again once it has been released.
    taken = takes(act) || (taken && from.length() > dead_zone);
    for (const int axis : {0, 1})
        if (to[axis] != from[axis])
            queue(act, taken, "gamepad_axis",
                  {number_of(gamepad), axis_name(gamepad_stick_names[stick], axis), to[axis]});
    if (stick == hat_stick) press_hat_buttons(gamepad);
    update_actions();
}

void Input::State::pull_trigger(Gamepad& gamepad, std::size_t trigger, double to) {
    const double from = std::exchange(gamepad.triggers[trigger], to);
    Act act{.kind = Act::Kind::trigger,
            .name = std::string(gamepad_trigger_names[trigger]),
            .gamepad = number_of(gamepad),
            .value = {to, 0}};
    bool& taken = gamepad.taken_triggers[trigger];
    taken = takes(act) || (taken && from > dead_zone);
    queue(std::move(act), taken, "gamepad_axis",
          {number_of(gamepad), std::string(gamepad_trigger_names[trigger]), to});
    update_actions();
}

void Input::State::connect(Gamepad& gamepad, bool connected) {
    gamepad.connected = connected;
    if (connected) return;
    const Handle self = gamepad.instance;
    for (const std::string_view stick : gamepad_stick_names) tree.set(self, stick, Vec2(0, 0));
    for (const std::string_view trigger : gamepad_trigger_names) tree.set(self, trigger, 0.0);
    for (const GamepadButton& button : contexts.buttons)
        tree.set(self, "button_" + button.name, false);
    for (const std::string_view name : gamepad_button_names) tree.set(self, name, false);
}

}  // namespace fettle::app
