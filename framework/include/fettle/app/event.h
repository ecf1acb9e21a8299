#pragma once
// Input events, independent of the window library: the window passes them to layers, to the tree
// and to the game.

#include <cstdint>
#include <string>
#include <string_view>

#include <fettle/app/export.h>

FETTLE_APP_BEGIN

namespace fettle::app {

/// The kind of an event.
enum class EventKind : std::uint8_t {
    key_pressed,
    key_released,
    text,
    mouse_pressed,
    mouse_released,
    mouse_moved,
    wheel,
    resized,
    focus,
    closing,
    gamepad_pressed,
    gamepad_released,
    gamepad_axis,
    gamepad_connected,
    gamepad_disconnected
};

/// An event of keyboard, mouse, gamepad or window.
struct InputEvent {
    EventKind kind = EventKind::focus;  ///< what happened
    /// Key: "a" to "z", "0" to "9", "f1" to "f15", "space" "enter" "escape" "tab" "backspace"
    /// "delete" "insert" "left" "right" "up" "down" "home" "end" "page_up" "page_down" "left_shift"
    /// "right_shift" "left_control" "right_control" "left_alt" "right_alt" "left_system"
    /// "right_system" "menu" "pause" "grave" "minus" "equal" "left_bracket" "right_bracket"
    /// "backslash" "semicolon" "apostrophe" "comma" "period" "slash" "numpad_0" to "numpad_9"
    /// "numpad_add" "numpad_subtract" "numpad_multiply" "numpad_divide".
    /// Mouse: "left" "right" "middle" "extra_1" "extra_2". Gamepad: button number ("1" ...) or
    /// axis: "left_x" "left_y" "right_x" "right_y" "left_trigger" "right_trigger" "pad_x" "pad_y".
    /// gamepad_connected: maker and product of the device in hexadecimal digits, "054c:0ce6", or
    /// "".
    std::string name{};
    char32_t character = 0;  // text
    float x = 0, y = 0;      // mouse position in pixels from the top left; new size when resized
    float delta = 0;         // wheel: notches, away from the user positive; axis: -1 to 1, up
                             // and right positive
    int gamepad = 0;         // from 1
    bool control = false, shift = false, alt = false;  ///< keys that are held down
    bool repeated = false;                             // key held down
    bool focused = false;                              // focus: gained
};

}  // namespace fettle::app

FETTLE_APP_END
