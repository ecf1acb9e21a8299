#include <algorithm>
#include <charconv>
#include <optional>
#include <stdexcept>

#include <fettle/script/synonyms.h>

#include <input/actions.h>
#include <input/gamepad_mapping.h>
#include <input/index_among.h>
#include <input/input_state.h>

namespace fettle::app {

using property::List;
using property::Type;
using property::Value;

namespace {

using Kind = ActionSwitch::Kind;

/// Every name of a switch or a stick, for the nearest spelling.
const std::vector<std::string>& all_names() {
    static const std::vector<std::string> names = [] {
        std::vector<std::string> all(key_names().begin(), key_names().end());
        for (const std::string_view each : mouse_button_names)
            all.push_back("mouse." + std::string(each));
        for (const std::string_view each : gamepad_button_names)
            all.push_back("gamepad." + std::string(each));
        for (const std::string_view each : gamepad_trigger_names)
            all.push_back("gamepad." + std::string(each));
        for (const std::string_view each : gamepad_stick_names) {
            all.push_back("gamepad." + std::string(each));
            for (const char* half : {"_x+", "_x-", "_y+", "_y-"})
                all.push_back("gamepad." + std::string(each) + half);
        }
        return all;
    }();
    return names;
}

[[noreturn]] void refuse_name(const std::string& name) {
    // A gamepad's number does not matter for the spelling.
    std::string plain = name;
    if (plain.starts_with("gamepad_") && plain.size() > 9 && plain[9] == '.') plain.erase(7, 2);
    if (plain != name && std::ranges::find(all_names(), plain) != all_names().end())
        throw std::invalid_argument("no key, button or axis is called \"" + name +
                                    "\": there are gamepad_1 to gamepad_" +
                                    std::to_string(Input::gamepad_count));
    const auto meant = script::property_synonyms(name == " " ? "spacebar" : name);
    throw std::invalid_argument("no key, button or axis is called \"" + name + "\"" +
                                script::hint_at(meant, plain, all_names()));
}

/// Returns the number of the gamepad in "gamepad.a" (0) or "gamepad_2.a" (2), and removes that part
/// of the name. Empty if the name is not of a gamepad.
std::optional<int> read_gamepad(std::string_view& name) {
    const std::size_t dot = name.find('.');
    if (dot == std::string_view::npos || !name.starts_with("gamepad")) return std::nullopt;
    const std::string_view number = name.substr(7, dot - 7);
    int gamepad = 0;
    if (!number.empty()) {
        if (number.size() != 2 || number[0] != '_' || number[1] < '1' ||
            number[1] > '0' + Input::gamepad_count)
            return std::nullopt;
        gamepad = number[1] - '0';
    }
    name.remove_prefix(dot + 1);
    return gamepad;
}

std::optional<ActionSwitch> gamepad_switch(std::string_view part, int gamepad) {
    ActionSwitch made{.gamepad = gamepad};
    if (const auto named = index_among(gamepad_button_names, part)) {
        made.kind = Kind::named_button;
        made.index = *named;
        return made;
    }
    if (const auto trigger = index_among(gamepad_trigger_names, part)) {
        made.kind = Kind::trigger;
        made.index = *trigger;
        return made;
    }
    if (part.starts_with("button_")) {
        int number = 0;
        const std::string_view digits = part.substr(7);
        const auto end = digits.data() + digits.size();
        const auto read = std::from_chars(digits.data(), end, number);
        if (read.ec != std::errc() || read.ptr != end || number < 1 ||
            number > Input::gamepad_buttons)
            return std::nullopt;
        made.kind = Kind::raw_button;
        made.index = static_cast<std::size_t>(number - 1);
        return made;
    }
    if (part.size() < 4 || (part.back() != '+' && part.back() != '-')) return std::nullopt;
    made.kind = Kind::axis;
    made.sign = part.back() == '+' ? 1 : -1;
    part.remove_suffix(1);
    const bool x = part.ends_with("_x");
    if (!x && !part.ends_with("_y")) return std::nullopt;
    part.remove_suffix(2);
    const auto stick = index_among(gamepad_stick_names, part);
    if (!stick) return std::nullopt;
    made.index = 2 * *stick + (x ? 0 : 1);
    return made;
}

std::optional<ActionSwitch> switch_named(std::string_view name) {
    if (const auto key = index_among(key_names(), name))
        return ActionSwitch{.kind = Kind::key, .index = *key};
    constexpr std::string_view mouse = "mouse.";
    if (name.starts_with(mouse)) {
        const auto button = index_among(mouse_button_names, name.substr(mouse.size()));
        if (!button) return std::nullopt;
        return ActionSwitch{.kind = Kind::mouse, .index = *button};
    }
    const auto gamepad = read_gamepad(name);
    return gamepad ? gamepad_switch(name, *gamepad) : std::nullopt;
}

void add_name(ActionBindings& bindings, const std::string& name) {
    if (const auto found = switch_named(name)) {
        bindings.switches.push_back(*found);
        return;
    }
    std::string_view part = name;
    const auto gamepad = read_gamepad(part);
    const auto stick = gamepad ? index_among(gamepad_stick_names, part) : std::nullopt;
    if (!stick) refuse_name(name);
    bindings.directions.push_back({.gamepad = *gamepad, .stick = *stick});
}

void add_four(ActionBindings& bindings, const List& names) {
    ActionDirection direction;
    for (const Value& name : names) {
        if (!name.is(Type::text)) break;
        const auto found = switch_named(name.text());
        if (!found) refuse_name(name.text());
        direction.four.push_back(*found);
    }
    if (names.size() != 4 || direction.four.size() != 4)
        throw std::invalid_argument(
            "a list in the list names four keys or buttons: left, right, down, up");
    bindings.directions.push_back(std::move(direction));
}

}  // namespace

ActionBindings parse_action(const Value& value) {
    ActionBindings bindings;
    if (value.is(Type::text)) {
        add_name(bindings, value.text());
        return bindings;
    }
    if (!value.is(Type::list))
        throw std::invalid_argument(
            "expected names of keys and buttons, as in { \"space\", \"gamepad.a\" }, got " +
            property::value_text(value));
    constexpr std::size_t most = 64;
    if (value.list().size() > most)
        throw std::invalid_argument("an action has 64 keys and buttons at most");
    for (const Value& entry : value.list()) {
        if (entry.is(Type::text))
            add_name(bindings, entry.text());
        else if (entry.is(Type::list))
            add_four(bindings, entry.list());
        else
            throw std::invalid_argument("expected the name of a key or button, got " +
                                        property::value_text(entry));
    }
    return bindings;
}

}  // namespace fettle::app
