#pragma once
// Input as properties: `input.keys.space`, `input.mouse.world`, `input.gamepads[1].left`.
//
// A property that changes is input, whoever changes it: the window sets `input.keys.space` when the
// space bar goes down, and a script or a test that sets it has pressed it just the same. Either way
// the game's callbacks are called in the next input phase, in the order of what happened.

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

/// Every key there is, by the name that events and `input.keys` use.
std::span<const std::string_view> key_names();

class Input {
  public:
    static constexpr int gamepad_count = 4;
    static constexpr int gamepad_buttons = 16;

    /// Puts `input` into the tree. Tree and view must outlive its use.
    Input(property::Tree& tree, View& view);
    ~Input();
    Input(const Input&) = delete;
    Input& operator=(const Input&) = delete;

    /// An event that the game is to get.
    void apply(const InputEvent& event);
    /// An event that a layer took for itself: keys and buttons that the game holds are let go, and
    /// the mouse is known to have moved; nothing else reaches the game.
    void observe(const InputEvent& event);
    /// Lets go of every key and button, as when the window loses the focus.
    void release_all();

    /// Calls the game's callbacks for what happened since the last time, until one fails or quits.
    /// False when one failed; the rest is dropped.
    bool deliver(script::Runtime& runtime);
    /// Forgets what was not delivered.
    void drop();
    /// The frame is over: what counts per frame (the wheel) starts anew.
    void end_frame();

    /// Whether the game sees a key ("space") held down; false for unknown names.
    bool key(std::string_view name) const;
    /// Whether the game sees a mouse button ("left") held down; false for unknown names.
    bool button(std::string_view name) const;
    bool any_button() const;
    property::Vec2 mouse() const;  // px

    struct FETTLE_APP_PRIVATE State;

  private:
    void point(const InputEvent& event, bool tell);
    void set_switch(property::Handle instance, std::string_view name, bool down);
    void apply_gamepad(const InputEvent& event);
    std::unique_ptr<State> state_;
};

}  // namespace fettle::app

FETTLE_APP_END
