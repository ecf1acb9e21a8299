#pragma once
// Which button and axis of a gamepad is which, in the text format of the community's mapping files:
// "a:b0,b:b1,leftx:a0,dpup:h0.1".

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace fettle::app {

/// The buttons by the places that they have on a common gamepad: `a` is the lowest of the four.
inline constexpr std::array<std::string_view, 15> gamepad_button_names{
    "a",          "b",         "x",        "y",          "left_shoulder", "right_shoulder",
    "back",       "start",     "guide",    "left_stick", "right_stick",   "dpad_up",
    "dpad_right", "dpad_down", "dpad_left"};

/// The values that axes move: components of the sticks, and triggers.
enum class PadTarget : std::uint8_t {
    left_x,
    left_y,
    right_x,
    right_y,
    left_trigger,
    right_trigger,
    count
};
inline constexpr std::size_t pad_targets = static_cast<std::size_t>(PadTarget::count);

/// The part of a device that a name stands for.
struct PadSource {
    enum class Kind : std::uint8_t { none, button, axis, hat } kind = Kind::none;
    int index =
        0;         // of the button from 0, or of the axis; for a hat, 1 up, 2 right, 4 down, 8 left
    int half = 0;  // axis: 1 or -1 for one half of it
    bool inverted = false;
};

struct GamepadMapping {
    std::array<PadSource, gamepad_button_names.size()> buttons{};
    std::array<PadSource, pad_targets> targets{};
};

/// The name of the built-in mapping ("xbox", "playstation", "switch_pro") for a device "VVVV:PPPP"
/// (maker and product in hexadecimal digits).
std::string_view controller_of(std::string_view device);

/// Reads the name of a built-in mapping or a text. Throws std::invalid_argument, which names the
/// entry, for one that is malformed.
GamepadMapping parse_gamepad_mapping(std::string_view text);

}  // namespace fettle::app
