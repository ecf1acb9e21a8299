// Names of keys, mouse buttons and gamepad axes for both versions of SFML.

#include <array>
#include <cstdio>
#include <optional>
#include <utility>

#include <sfml/sfml.h>
#include <sfml/x11.h>

namespace fettle::app::sfml {

std::string key_name(sf::Keyboard::Key key) {
    using Key = sf::Keyboard::Key;
    const auto numbered = [key](Key first, int count, int start, const char* prefix) {
        const int offset = static_cast<int>(key) - static_cast<int>(first);
        return offset >= 0 && offset < count ? prefix + std::to_string(start + offset)
                                             : std::string();
    };
    const int letter = static_cast<int>(key) - static_cast<int>(Key::A);
    if (letter >= 0 && letter < 26) return {static_cast<char>('a' + letter)};
    if (std::string name = numbered(Key::Num0, 10, 0, ""); !name.empty()) return name;
    if (std::string name = numbered(Key::Numpad0, 10, 0, "numpad_"); !name.empty()) return name;
    if (std::string name = numbered(Key::F1, 15, 1, "f"); !name.empty()) return name;
    static constexpr std::pair<Key, const char*> named[] = {
        {Key::Space, "space"},
        {Key::Enter, "enter"},
        {Key::Escape, "escape"},
        {Key::Tab, "tab"},
        {Key::Backspace, "backspace"},
        {Key::Delete, "delete"},
        {Key::Insert, "insert"},
        {Key::Left, "left"},
        {Key::Right, "right"},
        {Key::Up, "up"},
        {Key::Down, "down"},
        {Key::Home, "home"},
        {Key::End, "end"},
        {Key::PageUp, "page_up"},
        {Key::PageDown, "page_down"},
        {Key::LShift, "left_shift"},
        {Key::RShift, "right_shift"},
        {Key::LControl, "left_control"},
        {Key::RControl, "right_control"},
        {Key::LAlt, "left_alt"},
        {Key::RAlt, "right_alt"},
        {Key::LSystem, "left_system"},
        {Key::RSystem, "right_system"},
        {Key::Menu, "menu"},
        {Key::Pause, "pause"},
        {key_grave, "grave"},
        {Key::Hyphen, "minus"},
        {Key::Equal, "equal"},
        {Key::LBracket, "left_bracket"},
        {Key::RBracket, "right_bracket"},
        {Key::Backslash, "backslash"},
        {Key::Semicolon, "semicolon"},
        {key_apostrophe, "apostrophe"},
        {Key::Comma, "comma"},
        {Key::Period, "period"},
        {Key::Slash, "slash"},
        {Key::Add, "numpad_add"},
        {Key::Subtract, "numpad_subtract"},
        {Key::Multiply, "numpad_multiply"},
        {Key::Divide, "numpad_divide"},
    };
    for (const auto& [code, name] : named)
        if (code == key) return name;
    return {};
}

std::string key_name(sf::Keyboard::Key key, bool pressed) {
    static std::optional<sf::Keyboard::Key> left_of_1;  // while it is held down
    std::string name = key_name(key);
    // In all layouts it types a sign, or a letter that SFML does not know.
    const bool may_be = name.empty() || key == sf::Keyboard::Key::LBracket ||
                        key == sf::Keyboard::Key::RBracket || key == sf::Keyboard::Key::Backslash ||
                        key == sf::Keyboard::Key::Slash || key == key_apostrophe ||
                        key == sf::Keyboard::Key::Semicolon;
    if (!may_be) return name;
    if (pressed && !left_of_1 && is_key_left_of_1_down()) left_of_1 = key;
    if (left_of_1 != key) return name;
    if (!pressed) left_of_1.reset();
    return "grave";
}

bool is_down(const std::string& key) {
    if (key == "grave" && is_key_left_of_1_down()) return true;
    for (int code = 0; code < static_cast<int>(sf::Keyboard::KeyCount); ++code)
        if (const auto each = static_cast<sf::Keyboard::Key>(code);
            key_name(each) == key && sf::Keyboard::isKeyPressed(each))
            return true;
    return false;
}

std::string button_name(sf::Mouse::Button button) {
    switch (button) {
        case sf::Mouse::Button::Left:
            return "left";
        case sf::Mouse::Button::Right:
            return "right";
        case sf::Mouse::Button::Middle:
            return "middle";
        case button_extra_1:
            return "extra_1";
        case button_extra_2:
            return "extra_2";
        default:
            return {};
    }
}

bool is_button_down(const std::string& button) {
    for (int code = 0; code < static_cast<int>(sf::Mouse::ButtonCount); ++code)
        if (const auto each = static_cast<sf::Mouse::Button>(code);
            button_name(each) == button && sf::Mouse::isButtonPressed(each))
            return true;
    return false;
}

std::string device_of(unsigned gamepad) {
    const sf::Joystick::Identification device = sf::Joystick::getIdentification(gamepad);
    char text[20];
    std::snprintf(text, sizeof text, "%04x:%04x", device.vendorId, device.productId);
    return text;
}

std::unique_ptr<sf::Cursor> system_cursor(Cursor form) {
    using Type = sf::Cursor::Type;
    constexpr std::array types = {
        Type::Arrow,          Type::Hand,         Type::Text, Type::Cross, Type::SizeAll,
        Type::SizeHorizontal, Type::SizeVertical, Type::Wait, Type::Help,  Type::NotAllowed};
    return load_cursor(types[static_cast<std::size_t>(form)]);
}

void set_axis(InputEvent& event, sf::Joystick::Axis axis, float position) {
    const float value = position / 100;
    const auto is = [&](const char* name, float delta) {
        event.name = name;
        event.delta = delta;
    };
    switch (axis) {
        case sf::Joystick::Axis::X:
            is("left_x", value);
            break;
        case sf::Joystick::Axis::Y:
            is("left_y", -value);
            break;
        case sf::Joystick::Axis::U:
            is("right_x", value);
            break;
        case sf::Joystick::Axis::V:
            is("right_y", -value);
            break;
        case sf::Joystick::Axis::Z:
            is("left_trigger", value);
            break;
        case sf::Joystick::Axis::R:
            is("right_trigger", value);
            break;
        case sf::Joystick::Axis::PovX:
            is("pad_x", value);
            break;
        case sf::Joystick::Axis::PovY:
            is("pad_y", -value);
            break;
    }
}

}  // namespace fettle::app::sfml
