#include "input_state.h"

namespace fettle::app {

using property::accessor;
using property::Handle;
using property::Native;
using property::Property;
using property::Row;
using property::Type;
using property::Value;
using property::Vec2;

namespace {

using State = Input::State;

Property key_property(State::Switch& key) {
    return {.name = key.name,
            .type = Type::boolean,
            .default_value = false,
            .doc = "Whether the key is held down.",
            .binding = accessor(
                key, [](State::Switch& k, Row) { return k.down; },
                [](State::Switch& k, Row, const Value& down) {
                    k.down = down.boolean();
                    k.state->queue(k.down ? "key_pressed" : "key_released", {k.name});
                }),
            .transient = true};
}

Property button_property(State::Switch& button) {
    return {.name = button.name,
            .type = Type::boolean,
            .default_value = false,
            .doc = "Whether the button is held down.",
            .binding = accessor(
                button, [](State::Switch& b, Row) { return b.down; },
                [](State::Switch& b, Row, const Value& down) {
                    b.down = down.boolean();
                    const Vec2 at = b.state->mouse;
                    b.state->queue(b.down ? "mouse_pressed" : "mouse_released",
                                   {b.name, b.state->view.to_world(at), at});
                }),
            .transient = true};
}

std::vector<Property> mouse_properties(State& state) {
    // World and screen position say the same, and the view moves one against the other: the tree
    // compares them at barriers.
    return {{.name = "world",
             .type = Type::vec2,
             .unit = "m",
             .doc = "Where the mouse is in the world. Setting it moves the mouse for the game.",
             .binding = accessor(
                 state, [](State& s, Row) { return s.view.to_world(s.mouse); },
                 [](State& s, Row, const Value& world) {
                     s.move_mouse(s.view.to_screen(world.vec2()));
                 }),
             .transient = true,
             .simulated = true,
             .derives_from = {"screen"}},
            {.name = "screen",
             .type = Type::vec2,
             .unit = "px",
             .doc = "Where the mouse is on the screen, from the top left corner, y down.",
             .binding = accessor(
                 state, [](State& s, Row) { return s.mouse; },
                 [](State& s, Row, const Value& pixels) { s.move_mouse(pixels.vec2()); }),
             .transient = true,
             .simulated = true,
             .derives_from = {"world"}},
            {.name = "wheel",
             .type = Type::number,
             .doc = "Notches the wheel was turned in this frame, away from the user positive.",
             .binding = accessor(
                 state, [](State& s, Row) { return s.wheel; },
                 [](State& s, Row, const Value& notches) { s.turn_wheel(notches.number()); }),
             .transient = true,
             .simulated = true}};
}

template <class Base>
Property stick(State& state, const char* name, const char* doc, Base base) {
    return {.name = name,
            .type = Type::vec2,
            .range = {-1, 1},
            .doc = doc,
            .binding = column(state, Native::vec2d, sizeof(State::Gamepad), base),
            .transient = true};
}

template <class Base>
Property trigger(State& state, const char* name, const char* doc, Base base) {
    return {.name = name,
            .type = Type::number,
            .range = {0, 1},
            .doc = doc,
            .binding = column(state, Native::f64, sizeof(State::Gamepad), base),
            .transient = true};
}

Property gamepad_button(State::GamepadButton& button) {
    return {.name = "button_" + button.name,
            .type = Type::boolean,
            .default_value = false,
            .doc = "Whether the button is held down.",
            .binding = accessor(
                button,
                [](State::GamepadButton& b, Row row) {
                    return bool{b.state->gamepads[row].buttons[b.index]};
                },
                [](State::GamepadButton& b, Row row, const Value& down) {
                    b.state->gamepads[row].buttons[b.index] = down.boolean();
                    b.state->queue(down.boolean() ? "gamepad_pressed" : "gamepad_released",
                                   {static_cast<int>(row) + 1, b.name});
                }),
            .transient = true};
}

std::vector<Property> gamepad_properties(State& state) {
    return {{.name = "connected",
             .type = Type::boolean,
             .default_value = false,
             .doc = "Whether there is such a gamepad.",
             .binding = column(state, Native::boolean, sizeof(State::Gamepad),
                               [](State& s) { return &s.gamepads[0].connected; }),
             .transient = true},
            stick(state, "left", "The left stick, right and up positive.",
                  [](State& s) { return s.gamepads[0].left.data(); }),
            stick(state, "right", "The right stick, right and up positive.",
                  [](State& s) { return s.gamepads[0].right.data(); }),
            stick(state, "pad", "The directional pad, right and up positive.",
                  [](State& s) { return s.gamepads[0].pad.data(); }),
            trigger(state, "left_trigger", "How far the left trigger is pulled.",
                    [](State& s) { return &s.gamepads[0].left_trigger; }),
            trigger(state, "right_trigger", "How far the right trigger is pulled.",
                    [](State& s) { return &s.gamepads[0].right_trigger; })};
}

}  // namespace

void Input::State::define() {
    const property::Class& input_class = tree.define(
        {.name = "Input",
         .doc = "What the player does: keys, mouse, gamepads.",
         .creatable = false,
         .snapshots = property::Snapshots::never,
         .properties = {{.name = "gamepads",
                         .type = Type::list,
                         .doc = "All gamepads, connected or not: input.gamepads[1].left.",
                         .binding = accessor(*this,
                                             [](State& s, Row) {
                                                 property::List list;
                                                 for (const Gamepad& pad : s.gamepads)
                                                     list.emplace_back(pad.instance);
                                                 return Value(std::move(list));
                                             }),
                         .read_only = true,
                         .transient = true,
                         .element = Type::reference,
                         .reference_class = "Gamepad"}}});
    const Handle input = tree.create(input_class, tree.root(), "input");
    define_keys(input);
    define_mouse(input);
    define_gamepads(input);
}

void Input::State::define_keys(Handle input) {
    std::vector<Property> properties;
    keys.reserve(key_names().size());  // the properties are bound to its elements
    for (const std::string_view name : key_names())
        properties.push_back(key_property(keys.emplace_back(Switch{this, std::string(name)})));
    const property::Class& keys_class =
        tree.define({.name = "Keys",
                     .doc = "Which keys are held down. Setting one presses or releases it.",
                     .creatable = false,
                     .snapshots = property::Snapshots::never,
                     .properties = std::move(properties)});
    keys_instance = tree.create(keys_class, input, "keys");
}

void Input::State::define_mouse(Handle input) {
    std::vector<Property> properties = mouse_properties(*this);
    for (std::size_t i = 0; i < buttons.size(); ++i) {
        buttons[i] = {this, std::string(mouse_button_names[i])};
        properties.push_back(button_property(buttons[i]));
    }
    const property::Class& mouse_class =
        tree.define({.name = "Mouse",
                     .doc = "The mouse. Setting a button presses or releases it.",
                     .creatable = false,
                     .snapshots = property::Snapshots::never,
                     .properties = std::move(properties)});
    mouse_instance = tree.create(mouse_class, input, "mouse");
}

void Input::State::define_gamepads(Handle input) {
    std::vector<Property> properties = gamepad_properties(*this);
    for (std::size_t i = 0; i < gamepad_button_columns.size(); ++i) {
        gamepad_button_columns[i] = {this, i, std::to_string(i + 1)};
        properties.push_back(gamepad_button(gamepad_button_columns[i]));
    }
    const property::Class& gamepad_class = tree.define({.name = "Gamepad",
                                                        .doc = "A gamepad.",
                                                        .creatable = false,
                                                        .snapshots = property::Snapshots::never,
                                                        .properties = std::move(properties)});
    for (std::size_t i = 0; i < gamepads.size(); ++i) {
        gamepads[i].instance =
            tree.create(gamepad_class, input, "gamepad_" + std::to_string(i + 1));
        tree.set_row(gamepads[i].instance, static_cast<Row>(i));
    }
}

}  // namespace fettle::app
