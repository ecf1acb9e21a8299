#pragma once
// The current input, to which the tree's properties are bound, and the queue of callbacks.

#include <array>
#include <deque>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <fettle/app/foreground.h>
#include <fettle/app/input.h>
#include <fettle/property/added_rules.h>

#include <input/actions.h>
#include <input/gamepad_mapping.h>

namespace fettle::app {

/// Sticks are vectors. Their axes are called "left_x", "left_y" and so on.
inline constexpr std::array<std::string_view, 3> gamepad_stick_names{"left", "right", "pad"};
/// Triggers are numbers. Their axes have the same names.
inline constexpr std::array<std::string_view, 2> gamepad_trigger_names{"left_trigger",
                                                                       "right_trigger"};
/// The stick that is a directional pad.
inline constexpr std::size_t hat_stick = 2;
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
        bool taken = false;  // the foreground has its press
    };
    struct Gamepad {
        property::Handle instance{};
        bool connected = false;
        std::array<property::Vec2, gamepad_stick_names.size()> sticks{};
        std::array<double, gamepad_trigger_names.size()> triggers{};
        std::array<bool, gamepad_buttons> buttons{};
        std::array<bool, gamepad_button_names.size()> named{};
        // Sticks, triggers and buttons that the foreground has taken.
        std::array<bool, gamepad_stick_names.size()> taken_sticks{};
        std::array<bool, gamepad_trigger_names.size()> taken_triggers{};
        std::array<bool, gamepad_buttons> taken_buttons{};
        std::array<bool, gamepad_button_names.size()> taken_named{};
        std::string mapping_text = "xbox";
        GamepadMapping mapping = parse_gamepad_mapping("xbox");
        bool mapping_given = false;  // by the game or the player, so the device does not choose it
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
    /// Context of the property for one named button of all gamepads.
    struct NamedButton {
        State* state = nullptr;
        std::size_t index = 0;
    };
    /// Contexts of the properties of each gamepad.
    struct GamepadContexts {
        std::array<GamepadAxis, gamepad_stick_names.size()> sticks{};
        std::array<GamepadAxis, gamepad_trigger_names.size()> triggers{};
        std::array<GamepadButton, gamepad_buttons> buttons{};
        std::array<NamedButton, gamepad_button_names.size()> named{};
    };
    struct Call {
        std::string_view callback;
        std::vector<property::Value> arguments;
        // For an action: an event of this instance comes first.
        property::Handle instance{};
        const property::Event* event = nullptr;
        // For input of a device: what the foreground gets, and whether the game does not get it.
        std::optional<Act> act{};
        bool taken = false;
    };
    /// A press of a device that no step has seen yet. Its release waits until the end of the frame
    /// with the next step, so that a short click is down in that step, but not for many frames.
    struct NewPress {
        InputEvent press;
        std::optional<InputEvent> release{};
        int frames = 0;  // that have ended since
    };
    /// A change that one step and one update see.
    struct Edge {
        bool for_step = false, for_update = false;  // not seen yet
        bool seen = false;                          // by the step or the update that runs
    };
    struct Action {
        bool used = false;  // by an instance, whose row this is
        property::Handle instance{};
        property::Value value{};  // from which `bindings` were read
        ActionBindings bindings{};
        double strength = 0;
        property::Vec2 direction{0, 0};
        bool forced = false;  // held by a script
        bool held = false;
        Edge pressed{}, released{};
    };
    /// Rules for the properties of `input.actions`.
    struct ActionRules : property::AddedRules {
        explicit ActionRules(State& of) : state(of) {}
        void check(property::Handle instance, std::string_view name,
                   const property::Value& value) const override;
        void changed(property::Handle instance, std::string_view name) override;
        State& state;
    };

    property::Tree& tree;
    View& view;
    property::Handle keys_instance{}, mouse_instance{};
    std::vector<Switch> keys{};
    std::array<Switch, mouse_button_names.size()> buttons{};
    std::array<Gamepad, gamepad_count> gamepads{};
    GamepadContexts contexts{};
    property::Handle input_instance{}, actions_instance{};
    const property::Class* action_class = nullptr;
    const property::Class* actions_class = nullptr;
    std::weak_ptr<const property::Tree*> tree_life = tree.lifetime();
    std::deque<Action> actions{};  // rows of the class Action
    Action move{};                 // has no instance
    double dead_zone = 0.2;
    std::string clipboard{};
    ActionRules rules{*this};
    property::Vec2 mouse{0, 0};  // px
    double wheel = 0;            // notches in this frame, with those added by scripts
    double wheel_delivered = 0;  // part of `wheel` whose callbacks are delivered in this frame
    std::vector<Call> calls{};
    bool silent = false;  // no callbacks for mouse moves
    std::vector<NewPress> new_presses{};
    bool presses_seen = false;  // by a step of this frame, or the game is paused
    Foreground* foreground = nullptr;

    /// Registers the classes and creates the instances.
    void define();

    void queue(std::string_view callback, std::vector<property::Value> arguments);
    /// Queues input that the foreground may take.
    void queue(Act act, bool taken, std::string_view callback,
               std::vector<property::Value> arguments);
    /// The same for what is pressed or released. `taken` is that of the key or button.
    void queue_switch(Act act, bool& taken, std::string_view callback,
                      std::vector<property::Value> arguments);
    bool takes(const Act& act) const { return foreground != nullptr && foreground->takes(act); }
    void move_mouse(const property::Vec2& pixels);
    void turn_wheel(double notches);
    void type(const std::string& text);
    void move_stick(Gamepad& gamepad, std::size_t stick, const property::Vec2& to);
    void pull_trigger(Gamepad& gamepad, std::size_t trigger, double to);
    /// Releases all buttons and axes of a gamepad that is disconnected.
    void connect(Gamepad& gamepad, bool connected);
    void press_raw(Gamepad& gamepad, std::size_t button, bool down);
    void press_named(Gamepad& gamepad, std::size_t button, bool down);
    void set_mapping(Gamepad& gamepad, const std::string& text);
    /// An axis of the device moved to a value from -1 to 1, as the device reports it: down is
    /// positive. `axis`: 0 to 5 are X, Y, Z, and the three rotations; 6 and 7 are those of the hat.
    void move_raw_axis(Gamepad& gamepad, std::size_t axis, double value);

    /// Computes all actions from the switches, and queues the changes.
    void update_actions();
    /// Makes the instance of an action, reads its bindings, or deletes it, as `input.actions` says.
    void sync_action(std::string_view name);
    /// The same for all, after a restore or an undo.
    void sync_actions();
    void set_move(const property::Value& value);
    property::Row add_action(property::Handle instance);

  private:
    void update_action(Action& action, bool reports_press);
    void press_hat_buttons(Gamepad& gamepad);
    int number_of(const Gamepad& gamepad) const {
        return static_cast<int>(&gamepad - gamepads.data()) + 1;
    }
    void define_keys(property::Handle input);
    void define_mouse(property::Handle input);
    void define_gamepads(property::Handle input);
    void define_actions(property::Handle input);
};

}  // namespace fettle::app
