#pragma once
// Input as properties: `input.keys.space`, `input.mouse.world`, `input.gamepads[1].left`,
// `input.jump.pressed`.
//
// A change of one of these properties is input, with any cause: the window sets `input.keys.space`
// when the space bar goes down, and when a script or a test sets it, the effect is the same. The
// game's callbacks are called in the next input phase, in the order of the changes.

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fettle/app/event.h>
#include <fettle/app/export.h>
#include <fettle/app/view.h>
#include <fettle/property/tree.h>

FETTLE_APP_BEGIN

namespace fettle::script {
class Runtime;
}

namespace fettle::app {

class Foreground;

/// All keys, by the names that events and `input.keys` use.
std::span<const std::string_view> key_names();

class Input {
  public:
    static constexpr int gamepad_count = 4;
    static constexpr int gamepad_buttons = 16;

    /// Adds `input` to the tree. Tree and view must outlive this object.
    Input(property::Tree& tree, View& view);
    ~Input();
    Input(const Input&) = delete;
    Input& operator=(const Input&) = delete;

    /// Sets the foreground, which gets all input before the game. Not owned: it must outlive this
    /// object or be replaced. Null: none.
    void set_foreground(Foreground* foreground);
    Foreground* foreground() const;

    /// Applies an event for the game. The release of a key or button that no step has seen down is
    /// applied at the end of the frame with the next step, after ten frames without a step, or at
    /// its next press.
    void apply(const InputEvent& event);
    /// Applies an event that a layer used: keys and buttons that the game holds are released, and
    /// the mouse position is updated; nothing else reaches the game.
    void observe(const InputEvent& event);
    /// Releases every key and button, as when the window loses the focus.
    void release_all();

    /// Calls the game's callbacks for all input since the last call, until one fails or quits.
    /// False if one failed; the rest is dropped.
    bool deliver(script::Runtime& runtime);
    /// Drops input that was not delivered.
    void drop();
    /// To be called before and after a step, and before and after the game's `update`: `pressed`
    /// and `released` of an action are true in the first of each kind after the change.
    void begin_step();
    void begin_update();
    void end_step_or_update();
    /// Drops presses that no step has seen, since the game is paused.
    void drop_unseen_presses();
    /// End of the frame: values per frame (the wheel) are reset, and releases that waited for a
    /// step are applied.
    void end_frame();

    /// True if the game has a key ("space") held down; false for unknown names.
    bool key(std::string_view name) const;
    /// True if the game has a mouse button ("left") held down; false for unknown names.
    bool button(std::string_view name) const;
    bool any_button() const;
    property::Vec2 mouse() const;  // px

    struct FETTLE_APP_PRIVATE State;

  private:
    void apply_now(const InputEvent& event);
    bool must_wait(const InputEvent& event);
    void apply_release(const InputEvent& event);
    void point(const InputEvent& event, bool notify);
    void set_switch(property::Handle instance, std::string_view name, bool down);
    void repeat_key(std::string_view name);
    void apply_gamepad(const InputEvent& event);
    std::unique_ptr<State> state_;
};

}  // namespace fettle::app

FETTLE_APP_END
