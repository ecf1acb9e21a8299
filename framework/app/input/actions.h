#pragma once
// Actions: commands of the player, from any of several keys, buttons and sticks.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <fettle/property/value.h>

namespace fettle::app {

/// One key, button or half of an axis.
struct ActionSwitch {
    enum class Kind : std::uint8_t { key, mouse, named_button, raw_button, axis, trigger };
    Kind kind = Kind::key;
    int gamepad = 0;        // from 1; 0: any
    std::size_t index = 0;  // in the table of its kind; axis: 2 * stick + component
    int sign = 1;           // axis
};

/// A stick, or four switches: left, right, down, up.
struct ActionDirection {
    int gamepad = 0;  // of the stick
    std::size_t stick = 0;
    std::vector<ActionSwitch> four{};  // empty: the stick
};

struct ActionBindings {
    std::vector<ActionSwitch> switches;
    std::vector<ActionDirection> directions;
};

/// Reads `"space"` or `{ "space", "gamepad.a", { "a", "d", "s", "w" } }`. Throws
/// std::invalid_argument, with the nearest spelling, for an unknown name or another form.
ActionBindings parse_action(const property::Value& value);

}  // namespace fettle::app
