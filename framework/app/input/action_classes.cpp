// Actions in the tree: their bindings are properties added to `input.actions`, and each has an
// instance of its name below `input`.

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <fettle/property/error.h>
#include <fettle/property/path.h>

#include <input/input_state.h>

namespace fettle::app {

using property::accessor;
using property::Class;
using property::Error;
using property::ErrorKind;
using property::Handle;
using property::List;
using property::Property;
using property::Row;
using property::Type;
using property::Value;
using property::Vec2;

namespace {

using State = Input::State;

constexpr double held_threshold = 0.5;  // strength

List default_move() {
    return {List{"a", "d", "s", "w"}, List{"left", "right", "down", "up"}, "gamepad.left",
            "gamepad.pad"};
}

// --- Strength

/// The part of a value beyond the dead zone, from 0 to 1.
double beyond(double value, double dead_zone) {
    return std::clamp((value - dead_zone) / (1 - dead_zone), 0.0, 1.0);
}

double strength_on(const State& s, const State::Gamepad& pad, const ActionSwitch& from) {
    switch (from.kind) {
        case ActionSwitch::Kind::named_button:
            return pad.named[from.index] && !pad.taken_named[from.index] ? 1 : 0;
        case ActionSwitch::Kind::raw_button:
            return pad.buttons[from.index] && !pad.taken_buttons[from.index] ? 1 : 0;
        case ActionSwitch::Kind::trigger:
            return pad.taken_triggers[from.index] ? 0 : pad.triggers[from.index];
        default: {
            if (pad.taken_sticks[from.index / 2]) return 0;
            const Vec2& stick = pad.sticks[from.index / 2];
            return beyond(from.sign * stick[static_cast<int>(from.index % 2)], s.dead_zone);
        }
    }
}

template <class Visit>
void each_gamepad(const State& s, int number, Visit visit) {
    for (std::size_t i = 0; i < s.gamepads.size(); ++i)
        if (number == 0 || static_cast<std::size_t>(number) == i + 1) visit(s.gamepads[i]);
}

double strength_of(const State& s, const ActionSwitch& from) {
    // A switch that the foreground has taken is not held for the game.
    const auto held = [](const State::Switch& each) { return each.down && !each.taken ? 1 : 0; };
    if (from.kind == ActionSwitch::Kind::key) return held(s.keys[from.index]);
    if (from.kind == ActionSwitch::Kind::mouse) return held(s.buttons[from.index]);
    double most = 0;
    each_gamepad(s, from.gamepad, [&](const State::Gamepad& pad) {
        most = std::max(most, strength_on(s, pad, from));
    });
    return most;
}

Vec2 direction_of(const State& s, const ActionDirection& from) {
    Vec2 longest(0, 0);
    if (!from.four.empty())
        return {strength_of(s, from.four[1]) - strength_of(s, from.four[0]),
                strength_of(s, from.four[3]) - strength_of(s, from.four[2])};
    each_gamepad(s, from.gamepad, [&](const State::Gamepad& pad) {
        if (pad.taken_sticks[from.stick]) return;
        const Vec2& stick = pad.sticks[from.stick];
        const double length = stick.length();
        if (length <= s.dead_zone) return;
        const Vec2 scaled = stick * (beyond(length, s.dead_zone) / length);
        if (scaled.length() > longest.length()) longest = scaled;
    });
    return longest;
}

// --- Descriptors

template <class Get>
Property computed_property(State& state, const char* name, Type type, const char* doc, Get get) {
    return {.name = name,
            .type = type,
            .doc = doc,
            .binding = accessor(state, get),
            .read_only = true,
            .transient = true,
            .simulated = true};
}

std::vector<Property> action_properties(State& state) {
    return {
        computed_property(state, "pressed", Type::boolean,
                          "Whether it began to be held: true in one step, and in one update.",
                          [](State& s, Row row) { return bool{s.actions[row].pressed.seen}; }),
        computed_property(state, "released", Type::boolean,
                          "Whether it ceased to be held: true in one step, and in one update.",
                          [](State& s, Row row) { return bool{s.actions[row].released.seen}; }),
        {.name = "held",
         .type = Type::boolean,
         .default_value = false,
         .doc = "Whether it is held. Setting it to true holds it until it is set to false.",
         .binding = accessor(
             state, [](State& s, Row row) { return bool{s.actions[row].held}; },
             [](State& s, Row row, const Value& held) {
                 s.actions[row].forced = held.boolean();
                 s.update_actions();
             }),
         .transient = true,
         .simulated = true},
        computed_property(
            state, "strength", Type::number,
            "How far the strongest of its keys, buttons and axes is pressed, 0 to 1: triggers and "
            "sticks have values in between.",
            [](State& s, Row row) -> double { return s.actions[row].strength; }),
        computed_property(state, "direction", Type::vec2,
                          "The direction of its sticks and sets of four keys, right and up "
                          "positive, of length 1 at most.",
                          [](State& s, Row row) -> Vec2 { return s.actions[row].direction; })};
}

property::ClassDescriptor action_descriptor(State& state) {
    return {
        .name = "Action",
        .doc =
            "What the player wants, from any of several keys, buttons and sticks. "
            "input.actions.jump = { \"space\", \"gamepad.a\" } makes input.jump.",
        .snapshots = property::Snapshots::never,
        .properties = action_properties(state),
        .events = {{.name = "press", .doc = "It began to be held."},
                   {.name = "release", .doc = "It ceased to be held."}},
        .lifecycle = {.context = &state,
                      .create = [](void* context, property::Tree&, Handle self) -> Row {
                          return static_cast<State*>(context)->add_action(self);
                      },
                      .destroy = [](void* context, property::Tree&, Handle,
                                    Row row) { static_cast<State*>(context)->actions[row] = {}; }}};
}

property::ClassDescriptor actions_descriptor(State& state) {
    return {.name = "Actions",
            .doc =
                "The keys, buttons and sticks of each action, as lists of names: \"space\", "
                "\"mouse.left\", \"gamepad.a\", \"gamepad_2.left_trigger\", \"gamepad.left\", or a "
                "list of four keys: left, right, down, up. Assigning a new name makes an "
                "action, nil removes it.",
            .creatable = false,
            .properties = {{.name = "move",
                            .type = Type::list,
                            .default_value = default_move(),
                            .doc = "What `input.move` is computed from.",
                            .binding = accessor(
                                state, [](State& s, Row) { return s.move.value; },
                                [](State& s, Row, const Value& value) { s.set_move(value); })}}};
}

}  // namespace

void Input::State::define_actions(Handle input) {
    set_move(default_move());
    actions_class = &tree.define(actions_descriptor(*this));
    action_class = &tree.define(action_descriptor(*this));
    actions_instance = tree.create(*actions_class, input, "actions");
    property::set_added_rules(tree, *actions_class, &rules);
}

Row Input::State::add_action(Handle instance) {
    const auto unused = std::find_if(actions.begin(), actions.end(),
                                     [](const Action& action) { return !action.used; });
    const auto row = static_cast<Row>(unused - actions.begin());
    if (unused == actions.end()) actions.emplace_back();
    actions[row] = {};
    actions[row].used = true;
    actions[row].instance = instance;
    return row;
}

// --- Bindings

void Input::State::ActionRules::check(Handle instance, std::string_view name,
                                      const Value& value) const {
    const property::Tree& instances = state.tree;
    const std::string path = instances.path(instance) + property::path_suffix(name);
    const Handle input = state.input_instance;
    const Class& of = instances.class_of(input);
    const Handle child = instances.child(input, name);
    if (of.property(name) != nullptr || of.method(name) != nullptr ||
        (child && &instances.class_of(child) != state.action_class))
        throw Error(ErrorKind::bad_name, path +
                                             ": input has something else of that name, so the "
                                             "action needs another one");
    try {
        (void)parse_action(value);
    } catch (const std::invalid_argument& problem) {
        throw Error(ErrorKind::rejected, path + ": " + problem.what());
    }
}

void Input::State::ActionRules::changed(Handle, std::string_view name) {
    // An undo also brings back and deletes the actions that its edit has deleted and made. The rest
    // follows before the next frame (`sync_actions`).
    if (state.tree.cause().writer != property::Writer::undo) state.sync_action(name);
}

void Input::State::sync_action(std::string_view name) {
    const Property* bindings = tree.find(actions_instance, name);
    Handle action = tree.child(input_instance, name);
    if (action && &tree.class_of(action) != action_class) return;
    if (bindings == nullptr) {
        if (action) tree.destroy(action);
        return;
    }
    const Value value = tree.peek(actions_instance, *bindings);
    if (action && actions[tree.row(action)].value == value) return;
    if (!action) action = tree.create(*action_class, input_instance, name);
    Action& state = actions[tree.row(action)];
    state.value = value;
    try {
        state.bindings = parse_action(state.value);
    } catch (const std::invalid_argument&) {
        state.bindings = {};  // the value of a formula, or of a game with other keys
    }
    // A key that is down now was pressed for something else, such as for choosing it.
    update_action(state, false);
}

void Input::State::sync_actions() {
    if (!tree.alive(actions_instance)) return;
    static std::function<std::string()> where = [] { return std::string("input.actions"); };
    const property::Tree::CauseScope cause(tree, property::Writer::module, &where);
    for (const Property* bindings : tree.ad_hoc(actions_instance)) {
        const Handle action = tree.child(input_instance, bindings->name);
        const bool known =
            action && &tree.class_of(action) == action_class &&
            actions[tree.row(action)].value == tree.peek(actions_instance, *bindings);
        if (!known) sync_action(bindings->name);
    }
    for (const Handle child : tree.children(input_instance))
        if (&tree.class_of(child) == action_class &&
            tree.find(actions_instance, tree.name(child)) == nullptr)
            tree.destroy(child);
}

void Input::State::set_move(const Value& value) {
    move.bindings = parse_action(value);
    move.value = value;
    update_action(move, false);
}

// --- Changes

void Input::State::update_actions() {
    for (Action& action : actions)
        if (action.used) update_action(action, true);
    update_action(move, true);
}

void Input::State::update_action(Action& action, bool reports_press) {
    // The largest value of each direction, so that two keys for one direction do not add up.
    Vec2 most(0, 0), least(0, 0);
    double strength = 0;
    for (const ActionDirection& each : action.bindings.directions) {
        const Vec2 one = direction_of(*this, each);
        most = most.max(one);
        least = least.min(one);
    }
    Vec2 direction = most + least;
    if (direction.length() > 1) direction = direction.normalized();
    for (const ActionSwitch& each : action.bindings.switches)
        strength = std::max(strength, strength_of(*this, each));
    action.direction = direction;
    action.strength = std::max({strength, direction.length(), action.forced ? 1.0 : 0.0});
    const bool held = action.strength >= held_threshold;
    if (held == action.held) return;
    action.held = held;
    if (!action.instance || (held && !reports_press)) return;
    Edge& edge = held ? action.pressed : action.released;
    edge.for_step = edge.for_update = true;
    calls.push_back({.callback = held ? "action_pressed" : "action_released",
                     .arguments = {tree.name(action.instance)},
                     .instance = action.instance,
                     .event = action_class->event(held ? "press" : "release")});
}

void Input::begin_step() {
    state_->presses_seen = true;
    for (State::Action& action : state_->actions)
        for (State::Edge* edge : {&action.pressed, &action.released})
            edge->seen = std::exchange(edge->for_step, false);
}

void Input::begin_update() {
    for (State::Action& action : state_->actions)
        for (State::Edge* edge : {&action.pressed, &action.released})
            edge->seen = std::exchange(edge->for_update, false);
}

void Input::end_step_or_update() {
    for (State::Action& action : state_->actions)
        action.pressed.seen = action.released.seen = false;
}

void Input::drop_unseen_presses() {
    state_->presses_seen = true;
    for (State::Action& action : state_->actions)
        action.pressed.for_step = action.released.for_step = false;
}

}  // namespace fettle::app
