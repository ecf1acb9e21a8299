// The classes and properties of `input` in the tree.

#include <input/input_state.h>

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
                    k.state->queue_switch({.kind = Act::Kind::key, .name = k.name, .down = k.down},
                                          k.taken, k.down ? "key_pressed" : "key_released",
                                          {k.name});
                    k.state->update_actions();
                }),
            .transient = true};
}

Property button_property(State::Switch& button) {
    return {
        .name = button.name,
        .type = Type::boolean,
        .default_value = false,
        .doc = "Whether the button is held down.",
        .binding = accessor(
            button, [](State::Switch& b, Row) { return b.down; },
            [](State::Switch& b, Row, const Value& down) {
                b.down = down.boolean();
                const Vec2 at = b.state->mouse;
                b.state->queue_switch(
                    {.kind = Act::Kind::mouse_button, .name = b.name, .down = b.down, .value = at},
                    b.taken, b.down ? "mouse_pressed" : "mouse_released",
                    {b.name, b.state->view.to_world(at), at});
                b.state->update_actions();
            }),
        .transient = true};
}

std::vector<Property> mouse_properties(State& state) {
    // The view can change either position without a write, so the tree compares both at barriers.
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
             .doc = "Notches the wheel was turned in this frame, away from the user positive. "
                    "Setting it turns it by the difference: `wheel` is called in the next frame, "
                    "in which it reads these notches.",
             .binding = accessor(
                 state, [](State& s, Row) { return s.wheel; },
                 [](State& s, Row, const Value& notches) { s.turn_wheel(notches.number()); }),
             .transient = true,
             .simulated = true}};
}

constexpr std::array<const char*, gamepad_stick_names.size()> stick_docs{
    "The left stick, right and up positive. Setting it moves it: gamepad_axis is called with "
    "\"left_x\" and \"left_y\".",
    "The right stick, right and up positive. Setting it moves it: gamepad_axis is called with "
    "\"right_x\" and \"right_y\".",
    "The directional pad, right and up positive. A player moves it to -1, 0 or 1; a script may set "
    "what lies between. Setting it moves it: gamepad_axis is called with \"pad_x\" and \"pad_y\"."};
constexpr std::array<const char*, gamepad_trigger_names.size()> trigger_docs{
    "How far the left trigger is pulled. Setting it pulls it: gamepad_axis is called with "
    "\"left_trigger\".",
    "How far the right trigger is pulled. Setting it pulls it: gamepad_axis is called with "
    "\"right_trigger\"."};

Property stick(State::GamepadAxis& stick) {
    return {.name = std::string(gamepad_stick_names[stick.index]),
            .type = Type::vec2,
            .range = {-1, 1},
            .doc = stick_docs[stick.index],
            .binding = accessor(
                stick,
                [](State::GamepadAxis& s, Row row) -> Vec2 {
                    return s.state->gamepads[row].sticks[s.index];
                },
                [](State::GamepadAxis& s, Row row, const Value& to) {
                    s.state->move_stick(s.state->gamepads[row], s.index, to.vec2());
                }),
            .transient = true};
}

Property trigger(State::GamepadAxis& trigger) {
    return {.name = std::string(gamepad_trigger_names[trigger.index]),
            .type = Type::number,
            .range = {0, 1},
            .doc = trigger_docs[trigger.index],
            .binding = accessor(
                trigger,
                [](State::GamepadAxis& t, Row row) -> double {
                    return t.state->gamepads[row].triggers[t.index];
                },
                [](State::GamepadAxis& t, Row row, const Value& to) {
                    t.state->pull_trigger(t.state->gamepads[row], t.index, to.number());
                }),
            .transient = true};
}

/// `reported`: the name in callbacks.
Property button_property(std::string name, const std::string& reported, property::Binding binding) {
    return {.name = std::move(name),
            .type = Type::boolean,
            .default_value = false,
            .doc =
                "Whether the button is held down. Setting it presses or releases it: "
                "gamepad_pressed or gamepad_released is called with \"" +
                reported + "\".",
            .binding = binding,
            .transient = true};
}

Property gamepad_button(State::GamepadButton& button) {
    return button_property("button_" + button.name, button.name,
                           accessor(
                               button,
                               [](State::GamepadButton& b, Row row) {
                                   return bool{b.state->gamepads[row].buttons[b.index]};
                               },
                               [](State::GamepadButton& b, Row row, const Value& down) {
                                   b.state->press_raw(b.state->gamepads[row], b.index,
                                                      down.boolean());
                               }));
}

Property named_button(State::NamedButton& button) {
    const std::string name(gamepad_button_names[button.index]);
    return button_property(name, name,
                           accessor(
                               button,
                               [](State::NamedButton& b, Row row) {
                                   return bool{b.state->gamepads[row].named[b.index]};
                               },
                               [](State::NamedButton& b, Row row, const Value& down) {
                                   b.state->press_named(b.state->gamepads[row], b.index,
                                                        down.boolean());
                               }));
}

Property mapping_property(State& state) {
    return {.name = "mapping",
            .type = Type::text,
            .default_value = "xbox",
            .doc =
                "Which button and axis of the device has which name: \"xbox\", \"playstation\", "
                "\"switch_pro\", or a text in the format of the community's mapping files, such "
                "as \"a:b0,b:b1,leftx:a0,dpup:h0.1\".",
            .binding = accessor(
                state, [](State& s, Row row) { return Value(s.gamepads[row].mapping_text); },
                [](State& s, Row row, const Value& text) {
                    s.set_mapping(s.gamepads[row], text.text());
                    s.gamepads[row].mapping_given = true;
                }),
            .transient = true};
}

Property connected(State& state) {
    return {
        .name = "connected",
        .type = Type::boolean,
        .default_value = false,
        .doc =
            "Whether there is such a gamepad. Before it disconnects, all its buttons and axes are "
            "released.",
        .binding = accessor(
            state, [](State& s, Row row) { return bool{s.gamepads[row].connected}; },
            [](State& s, Row row, const Value& now) { s.connect(s.gamepads[row], now.boolean()); }),
        .transient = true};
}

Property move_property(State& state) {
    return {.name = "move",
            .type = Type::vec2,
            .range = {-1, 1},
            .doc =
                "Where the player wants to go, right and up positive, of length 1 at most: from "
                "the keys and sticks of `input.actions.move`.",
            .binding = accessor(state, [](State& s, Row) -> Vec2 { return s.move.direction; }),
            .read_only = true,
            .transient = true,
            .simulated = true};
}

Property dead_zone_property(State& state) {
    return {.name = "dead_zone",
            .type = Type::number,
            .default_value = 0.2,
            .range = {0, 0.9},
            .doc = "How far a stick must be moved before actions react to it.",
            .binding = column(state, Native::f64, 0, [](State& s) { return &s.dead_zone; }),
            .transient = true};
}

Property clipboard_property(State& state) {
    return {.name = "clipboard",
            .type = Type::text,
            .doc =
                "The text that was copied last: by the player, or by the game, which sets it. In "
                "a window it is the clipboard of the system, as it was when the player last "
                "pressed ctrl and V or copied something in the game.",
            .binding = accessor(
                state, [](State& s, Row) { return Value(s.clipboard); },
                [](State& s, Row, const Value& text) { s.clipboard = text.text(); }),
            .transient = true};
}

}  // namespace

void Input::State::define() {
    const property::Class& input_class = tree.define(
        {.name = "Input",
         .doc = "What the player does: keys, mouse, gamepads, and the actions bound to them.",
         .creatable = false,
         .snapshots = property::Snapshots::never,
         .properties = {move_property(*this),
                        dead_zone_property(*this),
                        clipboard_property(*this),
                        {.name = "gamepads",
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
    input_instance = input;
    define_keys(input);
    define_mouse(input);
    define_gamepads(input);
    define_actions(input);  // they read the others
}

void Input::State::define_keys(Handle input) {
    std::vector<Property> properties;
    keys.reserve(key_names().size());  // properties are bound to its elements
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
    std::vector<Property> properties{connected(*this)};
    for (std::size_t i = 0; i < contexts.sticks.size(); ++i) {
        contexts.sticks[i] = {this, i};
        properties.push_back(stick(contexts.sticks[i]));
    }
    for (std::size_t i = 0; i < contexts.triggers.size(); ++i) {
        contexts.triggers[i] = {this, i};
        properties.push_back(trigger(contexts.triggers[i]));
    }
    for (std::size_t i = 0; i < contexts.buttons.size(); ++i) {
        contexts.buttons[i] = {this, i, std::to_string(i + 1)};
        properties.push_back(gamepad_button(contexts.buttons[i]));
    }
    for (std::size_t i = 0; i < contexts.named.size(); ++i) {
        contexts.named[i] = {this, i};
        properties.push_back(named_button(contexts.named[i]));
    }
    properties.push_back(mapping_property(*this));
    const property::Class& gamepad_class =
        tree.define({.name = "Gamepad",
                     .doc = "A gamepad: two sticks, a directional pad, two triggers and up to "
                            "sixteen buttons, by number and, as far as `mapping` knows them, by "
                            "name. Setting one moves, pulls or presses it.",
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
