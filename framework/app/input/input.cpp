#include <fettle/app/input.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include <fettle/property/utf8.h>
#include <fettle/script/runtime.h>

#include <input/input_state.h>

namespace fettle::app {

using property::Handle;
using property::Value;
using property::Vec2;

namespace {

/// Some windows also send escape, backspace, tab and delete as text. They are keys only.
bool is_control(char32_t c) {
    return c < 0x20 || (c >= 0x7F && c < 0xA0);
}

/// The number of a device's axis that an event names, as in mappings. An event has the name that
/// the axis has on a common gamepad.
std::optional<std::size_t> raw_axis(std::string_view name) {
    constexpr std::array<std::string_view, 8> names{"left_x",  "left_y",  "left_trigger",
                                                    "right_x", "right_y", "right_trigger",
                                                    "pad_x",   "pad_y"};
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) return std::nullopt;
    return static_cast<std::size_t>(found - names.begin());
}

/// The cause of what an event changes.
std::function<std::string()>& window_name() {
    static std::function<std::string()> name = [] { return std::string("window"); };
    return name;
}

/// In slow motion a step may be seconds away: a release waits for it no longer than this.
constexpr int most_frames_without_step = 10;

/// The event that ends what an event begins, or none.
std::optional<EventKind> release_of(EventKind press) {
    switch (press) {
        case EventKind::key_pressed:
            return EventKind::key_released;
        case EventKind::mouse_pressed:
            return EventKind::mouse_released;
        case EventKind::gamepad_pressed:
            return EventKind::gamepad_released;
        default:
            return std::nullopt;
    }
}

/// Whether the sign of the axis is inverted in events, so that up is positive.
bool points_up(std::size_t axis) {
    return axis == 1 || axis == 4 || axis == 7;
}

}  // namespace

// --- State ---------------------------------------------------------------------------------------

void Input::State::queue(std::string_view callback, std::vector<Value> arguments) {
    calls.push_back({.callback = callback, .arguments = std::move(arguments)});
}

void Input::State::queue(Act act, bool taken, std::string_view callback,
                         std::vector<Value> arguments) {
    calls.push_back({.callback = callback,
                     .arguments = std::move(arguments),
                     .act = std::move(act),
                     .taken = taken});
}

void Input::State::queue_switch(Act act, bool& taken, std::string_view callback,
                                std::vector<Value> arguments) {
    // A release goes where its press went: to the game or to what lies over it.
    const bool had = std::exchange(taken, act.down && takes(act));
    const bool now = act.down ? taken : had;
    queue(std::move(act), now, callback, std::move(arguments));
}

void Input::State::move_mouse(const Vec2& pixels) {
    if (!std::isfinite(pixels.x) || !std::isfinite(pixels.y))
        throw std::invalid_argument("the point is too far outside of the screen");
    mouse = pixels;
    if (silent) return;
    std::vector<Value> arguments{view.to_world(mouse), mouse};
    // Consecutive moves give one call, because some mice send a thousand events a second.
    Act act{.kind = Act::Kind::pointer, .value = mouse};
    const bool taken = takes(act);
    if (!calls.empty() && calls.back().callback == "mouse_moved" && calls.back().taken == taken)
        calls.pop_back();
    queue(std::move(act), taken, "mouse_moved", std::move(arguments));
}

void Input::State::type(const std::string& text) {
    Act act{.kind = Act::Kind::text, .name = text};
    const bool taken = takes(act);
    queue(std::move(act), taken, "text_input", {text});
}

void Input::State::turn_wheel(double notches) {
    const double delta = notches - wheel;
    wheel = notches;
    Act act{.kind = Act::Kind::wheel, .value = {0, delta}};
    const bool taken = takes(act);
    queue(std::move(act), taken, "wheel", {delta, view.to_world(mouse)});
}

// --- Input ---------------------------------------------------------------------------------------

Input::Input(property::Tree& tree, View& view) : state_(std::make_unique<State>(tree, view)) {
    state_->define();
}

Input::~Input() {
    if (!state_->tree_life.expired())
        property::set_added_rules(state_->tree, *state_->actions_class, nullptr);
}

void Input::apply(const InputEvent& event) {
    if (!must_wait(event)) apply_now(event);
}

/// Whether a release is kept until the end of the frame. Notes presses.
bool Input::must_wait(const InputEvent& event) {
    State& s = *state_;
    const auto same =
        std::find_if(s.new_presses.begin(), s.new_presses.end(), [&](const State::NewPress& each) {
            return each.press.name == event.name && each.press.gamepad == event.gamepad &&
                   (each.press.kind == event.kind || release_of(each.press.kind) == event.kind);
        });
    if (release_of(event.kind) && !event.repeated) {
        if (same != s.new_presses.end()) {
            const std::optional<InputEvent> release = same->release;
            s.new_presses.erase(same);
            if (release) apply_release(*release);
        }
        s.new_presses.push_back({.press = event});
        return false;
    }
    if (same == s.new_presses.end() || event.kind == same->press.kind) return false;
    if (event.kind == EventKind::mouse_released) point(event, true);
    same->release = event;
    return true;
}

/// Applies a release that waited, where it happened: the mouse may have moved on meanwhile.
void Input::apply_release(const InputEvent& event) {
    if (event.kind != EventKind::mouse_released) return apply_now(event);
    State& s = *state_;
    const property::Tree::CauseScope cause(s.tree, property::Writer::module, &window_name());
    const Vec2 now = s.mouse + s.view.corner();
    point(event, false);
    set_switch(s.mouse_instance, event.name, false);
    point({.x = static_cast<float>(now.x), .y = static_cast<float>(now.y)}, false);
}

void Input::apply_now(const InputEvent& event) {
    State& s = *state_;
    const property::Tree::CauseScope cause(s.tree, property::Writer::module, &window_name());
    switch (event.kind) {
        case EventKind::key_pressed:
            if (!event.repeated)
                set_switch(s.keys_instance, event.name, true);
            else
                repeat_key(event.name);
            break;
        case EventKind::key_released:
            set_switch(s.keys_instance, event.name, false);
            break;
        case EventKind::text:
            if (!is_control(event.character)) {
                std::string typed;
                property::append_code_point(typed, event.character);
                s.type(typed);
            }
            break;
        case EventKind::mouse_pressed:
        case EventKind::mouse_released:
            point(event, true);
            set_switch(s.mouse_instance, event.name, event.kind == EventKind::mouse_pressed);
            break;
        case EventKind::mouse_moved:
            point(event, true);
            break;
        case EventKind::wheel:
            point(event, true);
            s.tree.set(s.mouse_instance, "wheel", s.wheel + event.delta);
            break;
        case EventKind::resized:
            s.view.screen = {std::max(1.0f, event.x), std::max(1.0f, event.y)};
            if (!s.view.window.fullscreen) s.view.window.size = s.view.screen;
            s.queue("resized", {s.view.screen.x, s.view.screen.y});
            break;
        case EventKind::focus:
            if (!event.focused) release_all();
            s.queue("focus", {event.focused});
            break;
        case EventKind::closing:
            s.queue("closing", {});
            break;
        default:
            apply_gamepad(event);
            break;
    }
}

void Input::observe(const InputEvent& event) {
    switch (event.kind) {
        case EventKind::key_released:
            if (key(event.name)) apply(event);
            break;
        case EventKind::mouse_released:
            if (button(event.name)) apply(event);
            break;
        case EventKind::mouse_moved:
            // A drag that began in the game continues even over a layer.
            point(event, any_button());
            break;
        case EventKind::gamepad_released:
        case EventKind::gamepad_axis:
        case EventKind::gamepad_connected:
        case EventKind::gamepad_disconnected:
            apply(event);
            break;
        case EventKind::resized:
        case EventKind::focus:
        case EventKind::closing:
            apply(event);
            break;
        default:
            break;
    }
}

void Input::point(const InputEvent& event, bool notify) {
    State& s = *state_;
    s.silent = !notify;
    s.tree.set(s.mouse_instance, "screen", Vec2(event.x, event.y) - s.view.corner());
    s.silent = false;
}

/// Reports the repetition of a key that is held down to the foreground; the game does not get it.
void Input::repeat_key(std::string_view name) {
    State& s = *state_;
    const bool taken = std::any_of(s.keys.begin(), s.keys.end(), [&](const State::Switch& key) {
        return key.taken && key.name == name;
    });
    if (taken)
        s.queue({.kind = Act::Kind::key, .name = std::string(name), .down = true, .repeated = true},
                true, "key_pressed", {});
}

void Input::set_foreground(Foreground* foreground) {
    state_->foreground = foreground;
}

Foreground* Input::foreground() const {
    return state_->foreground;
}

void Input::set_switch(Handle instance, std::string_view name, bool down) {
    // Keys without a name are ignored.
    if (const property::Property* found = state_->tree.find(instance, name);
        found != nullptr && found->type == property::Type::boolean)
        state_->tree.set(instance, *found, down);
}

void Input::apply_gamepad(const InputEvent& event) {
    State& s = *state_;
    if (event.gamepad < 1 || event.gamepad > gamepad_count) return;
    State::Gamepad& pad = s.gamepads[static_cast<std::size_t>(event.gamepad - 1)];
    if (event.kind == EventKind::gamepad_connected && !event.name.empty() && !pad.mapping_given) {
        s.tree.set(pad.instance, "mapping", std::string(controller_of(event.name)));
        pad.mapping_given = false;
    }
    s.tree.set(pad.instance, "connected", event.kind != EventKind::gamepad_disconnected);
    if (event.kind == EventKind::gamepad_pressed || event.kind == EventKind::gamepad_released) {
        set_switch(pad.instance, "button_" + event.name, event.kind == EventKind::gamepad_pressed);
    } else if (event.kind == EventKind::gamepad_axis) {
        const std::optional<std::size_t> axis = raw_axis(event.name);
        if (!axis || !std::isfinite(event.delta)) return;
        const double value = std::clamp(static_cast<double>(event.delta), -1.0, 1.0);
        s.move_raw_axis(pad, *axis, points_up(*axis) ? -value : value);
    }
}

void Input::release_all() {
    State& s = *state_;
    s.new_presses.clear();
    const auto release = [&](Handle instance, const auto& switches) {
        for (const State::Switch& each : switches)
            if (each.down) s.tree.set(instance, each.name, false);
    };
    release(s.keys_instance, s.keys);
    release(s.mouse_instance, s.buttons);
}

bool Input::deliver(script::Runtime& runtime) {
    state_->sync_actions();
    // Input made by a callback is delivered in the next frame.
    state_->wheel_delivered = state_->wheel;
    const std::vector<State::Call> calls = std::exchange(state_->calls, {});
    const auto life = runtime.lifetime();  // a callback may destroy the runtime
    for (const State::Call& call : calls) {
        if (call.act && state_->foreground != nullptr)
            state_->foreground->handle(*call.act, call.taken);
        if (call.taken) continue;
        if (call.event != nullptr && state_->tree.alive(call.instance))
            state_->tree.emit(call.instance, *call.event, {});
        if (!runtime.call(call.callback, call.arguments)) return false;
        if (life.expired() || runtime.quit_status()) break;
    }
    return true;
}

void Input::drop() {
    state_->calls.clear();
    drop_unseen_presses();
    state_->wheel_delivered = state_->wheel;
}

void Input::end_frame() {
    // A turn of the wheel by a script during the frame counts for the next frame, like its
    // callback.
    state_->wheel -= std::exchange(state_->wheel_delivered, 0);
    const bool seen = std::exchange(state_->presses_seen, false);
    for (State::NewPress& each : std::exchange(state_->new_presses, {})) {
        if (!seen && ++each.frames < most_frames_without_step)
            state_->new_presses.push_back(std::move(each));
        else if (each.release)
            apply_release(*each.release);
    }
}

namespace {

template <class Switches>
bool is_down(const Switches& switches, std::string_view name) {
    return std::any_of(switches.begin(), switches.end(),
                       [&](const auto& each) { return each.down && each.name == name; });
}

}  // namespace

bool Input::key(std::string_view name) const {
    return is_down(state_->keys, name);
}
bool Input::button(std::string_view name) const {
    return is_down(state_->buttons, name);
}

bool Input::any_button() const {
    return std::any_of(state_->buttons.begin(), state_->buttons.end(),
                       [](const State::Switch& each) { return each.down; });
}

Vec2 Input::mouse() const {
    return state_->mouse;
}

}  // namespace fettle::app
