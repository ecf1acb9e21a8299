#pragma once
// Pictures over the game that get its input first, such as menus.

#include <cstdint>
#include <string>

#include <fettle/app/export.h>
#include <fettle/property/painter.h>
#include <fettle/property/value.h>

FETTLE_APP_BEGIN

namespace fettle::app {

/// One change of a device, as a property of `input` reports it, whether the player or a script made
/// it.
struct Act {
    enum class Kind : std::uint8_t {
        key,             // `name`, `down`, `repeated`
        mouse_button,    // `name`, `down`, `value`
        gamepad_button,  // `name` ("a", or a number as "1"), `down`, `gamepad`
        text,            // `name`: the text that was typed, in UTF-8
        pointer,         // `value`
        wheel,           // `value.y`: notches, away from the user positive
        stick,           // `name` ("left", "right", "pad"), `value`, `gamepad`
        trigger          // `name` ("left_trigger", "right_trigger"), `value.x`, `gamepad`
    };
    Kind kind = Kind::key;
    std::string name{};
    bool down = false;
    bool repeated = false;       // a key that is held down
    int gamepad = 0;             // from 1
    property::Vec2 value{0, 0};  // of a mouse: px from the top left corner
};

class Foreground {
  public:
    virtual ~Foreground() = default;
    /// True: the game does not get this input. Called as soon as the input arrives; must not change
    /// anything. If the game did not get a press, it does not get the release either.
    virtual bool takes(const Act& act) const = 0;
    /// Called for all input in the input phase of the frame, before the game gets the input that
    /// was not taken. It may change the tree.
    virtual void handle(const Act& act, bool taken) = 0;
    /// Called at the beginning of each frame. `mouse` and `screen`: px; `seconds`: real time since
    /// the last frame.
    virtual void frame(const property::Vec2& mouse, const property::Vec2& screen,
                       double seconds) = 0;
    /// Draws over the game.
    virtual void draw(property::Painter& painter) = 0;
};

}  // namespace fettle::app

FETTLE_APP_END
