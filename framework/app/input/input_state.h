#pragma once
// The current input, to which the tree's properties are bound, and the queue of callbacks.

#include <array>
#include <string>
#include <vector>

#include <fettle/app/input.h>

namespace fettle::app {

/// Sticks are vectors. Their axes are called "left_x", "left_y" and so on.
inline constexpr std::array<std::string_view, 3> gamepad_stick_names{"left", "right", "pad"};
/// Triggers are numbers. Their axes have the same names.
inline constexpr std::array<std::string_view, 2> gamepad_trigger_names{"left_trigger",
                                                                       "right_trigger"};
inline constexpr std::array<std::string_view, 5> mouse_button_names{"left", "right", "middle",
                                                                    "extra_1", "extra_2"};

struct Input::State {
    State(property::Tree& the_tree, View& the_view) : tree(the_tree), view(the_view) {}
    State(const State&) = delete;  // properties are bound to its members

    /// A key or a mouse button.
    struct Switch {
        State* state = nullptr;
        std::string name{};
        bool down = false;
    };
    struct Gamepad {
        property::Handle instance{};
        bool connected = false;
        std::array<property::Vec2, gamepad_stick_names.size()> sticks{};
        std::array<double, gamepad_trigger_names.size()> triggers{};
        std::array<bool, gamepad_buttons> buttons{};
    };
    /// Context of the properties for one stick or one trigger of all gamepads.
    struct GamepadAxis {
        State* state = nullptr;
        std::size_t index = 0;
    };
    /// Context of the property for one button of all gamepads.
    struct GamepadButton {
        State* state = nullptr;
        std::size_t index = 0;
        std::string name{};  // "1": the name in callbacks; the property is button_1
    };
    struct Call {
        std::string_view callback;
        std::vector<property::Value> arguments;
    };

    property::Tree& tree;
    View& view;
    property::Handle keys_instance{}, mouse_instance{};
    std::vector<Switch> keys{};
    std::array<Switch, mouse_button_names.size()> buttons{};
    std::array<Gamepad, gamepad_count> gamepads{};
    std::array<GamepadAxis, gamepad_stick_names.size()> gamepad_sticks{};
    std::array<GamepadAxis, gamepad_trigger_names.size()> gamepad_triggers{};
    std::array<GamepadButton, gamepad_buttons> gamepad_button_columns{};
    property::Vec2 mouse{0, 0};  // px
    double wheel = 0;            // notches in this frame, with those added by scripts
    double wheel_delivered = 0;  // part of `wheel` whose callbacks are delivered in this frame
    std::vector<Call> calls{};
    bool silent = false;  // no callbacks for mouse moves

    /// Registers the classes and creates the instances.
    void define();

    void queue(std::string_view callback, std::vector<property::Value> arguments);
    void move_mouse(const property::Vec2& pixels);
    void turn_wheel(double notches);
    void move_stick(Gamepad& gamepad, std::size_t stick, const property::Vec2& to);
    void pull_trigger(Gamepad& gamepad, std::size_t trigger, double to);
    /// Releases all buttons and axes of a gamepad that is disconnected.
    void connect(Gamepad& gamepad, bool connected);

  private:
    int number_of(const Gamepad& gamepad) const {
        return static_cast<int>(&gamepad - gamepads.data()) + 1;
    }
    void define_keys(property::Handle input);
    void define_mouse(property::Handle input);
    void define_gamepads(property::Handle input);
};

}  // namespace fettle::app
