#pragma once
// One interface for SFML 2 and 3. The rest of the application layer uses only this header and names
// that are the same in both versions.

#include <cstdint>
#include <memory>
#include <optional>
#include <streambuf>
#include <string>
#include <type_traits>

#include <SFML/Audio.hpp>
#include <SFML/Config.hpp>
#include <SFML/Graphics.hpp>
#include <SFML/System/Err.hpp>
#include <SFML/Window.hpp>

#include <fettle/app/event.h>
#include <fettle/app/window_state.h>

namespace fettle::app::sfml {

/// While it lives, SFML prints nothing to the terminal. SFML also prints messages in harmless
/// cases, such as a virtual display without vertical synchronization. Failures are detected by
/// return values.
class NoMessages {
  public:
    NoMessages() : before_(sf::err().rdbuf(nullptr)) {}
    ~NoMessages() { sf::err().rdbuf(before_); }
    NoMessages(const NoMessages&) = delete;

  private:
    std::streambuf* before_;
};

/// The name of a key; "" if it has none. sfml_events.cpp defines this function and the next six.
std::string key_name(sf::Keyboard::Key key);
/// The same for a key that goes down or up. The key left of the 1 is "grave" in every layout of the
/// keyboard, because it opens the console; SFML 2 names it by what it types, or not at all.
std::string key_name(sf::Keyboard::Key key, bool pressed);
/// Whether the key of this name is held down, whichever window has the keyboard.
bool is_down(const std::string& key);
std::string button_name(sf::Mouse::Button button);
/// The same as `is_down` for a button of the mouse.
bool is_button_down(const std::string& button);
/// Sets name and delta of an axis event. `position`: percent, y down positive.
void set_axis(InputEvent& event, sf::Joystick::Axis axis, float position);
/// Maker and product of a gamepad, "054c:0ce6".
std::string device_of(unsigned gamepad);

/// A touch is the left button of the mouse. False for fingers that come while another is down.
inline bool convert_touch(EventKind kind, unsigned finger, sf::Vector2i at, InputEvent& out) {
    if (finger != 0) return false;
    out.kind = kind;
    if (kind != EventKind::mouse_moved) out.name = "left";
    out.x = static_cast<float>(at.x);
    out.y = static_cast<float>(at.y);
    return true;
}

/// A pointer of the system; null if it has none of this form. sfml_events.cpp defines this
/// function.
std::unique_ptr<sf::Cursor> system_cursor(Cursor form);

/// True if OpenAL has opened a sound device. sfml_audio.cpp defines this function.
bool openal_device_opened();

#if SFML_VERSION_MAJOR >= 3

/// Whether the library draws quads.
inline constexpr bool has_quads = false;
inline constexpr auto quads = sf::PrimitiveType::Triangles;  // not used
/// Whether the library plays through OpenAL, which can write its output to a file.
inline constexpr bool plays_on_openal = false;
/// True if the library could open a sound device. Only meaningful while a stream exists, which
/// opens it. Where there is none, version 3.1 opens one that discards the sound.
inline bool audio_device_opened() {
    return sf::PlaybackDevice::getDevice().value_or("NULL Playback Device") !=
           "NULL Playback Device";
}
inline std::unique_ptr<sf::Cursor> load_cursor(sf::Cursor::Type type) {
    std::optional<sf::Cursor> cursor = sf::Cursor::createFromSystem(type);
    return cursor ? std::make_unique<sf::Cursor>(std::move(*cursor)) : nullptr;
}
class StereoStream : public sf::SoundStream {
  protected:
    void open(unsigned rate) {
        initialize(2, rate, {sf::SoundChannel::FrontLeft, sf::SoundChannel::FrontRight});
    }
};

using Byte = std::uint8_t;
inline constexpr auto key_apostrophe = sf::Keyboard::Key::Apostrophe;
inline constexpr auto key_grave = sf::Keyboard::Key::Grave;
inline constexpr auto button_extra_1 = sf::Mouse::Button::Extra1;
inline constexpr auto button_extra_2 = sf::Mouse::Button::Extra2;

inline sf::FloatRect rectangle(float left, float top, float width, float height) {
    return {{left, top}, {width, height}};
}
template <class Number>
Number left(const sf::Rect<Number>& r) {
    return r.position.x;
}
template <class Number>
Number top(const sf::Rect<Number>& r) {
    return r.position.y;
}
template <class Number>
Number width(const sf::Rect<Number>& r) {
    return r.size.x;
}
template <class Number>
Number height(const sf::Rect<Number>& r) {
    return r.size.y;
}

inline unsigned width(const sf::VideoMode& mode) {
    return mode.size.x;
}
inline unsigned height(const sf::VideoMode& mode) {
    return mode.size.y;
}

/// How a window is opened.
struct Frame {
    unsigned width = 0, height = 0;  // px
    bool fullscreen = false, resizable = true;
};
inline void open(sf::RenderWindow& window, const std::string& title, const Frame& frame,
                 unsigned samples) {
    sf::ContextSettings settings;
    settings.antiAliasingLevel = samples;
    window.create(sf::VideoMode({frame.width, frame.height}),
                  sf::String::fromUtf8(title.begin(), title.end()),
                  frame.resizable ? sf::Style::Default : sf::Style::Titlebar | sf::Style::Close,
                  frame.fullscreen ? sf::State::Fullscreen : sf::State::Windowed, settings);
}
inline void set_icon(sf::RenderWindow& window, const sf::Image& image) {
    window.setIcon(image.getSize(), image.getPixelsPtr());
}
inline bool create(sf::RenderTexture& target, unsigned width, unsigned height, unsigned samples) {
    sf::ContextSettings settings;
    settings.antiAliasingLevel = samples;
    return target.resize({width, height}, settings);
}
inline bool create(sf::Texture& texture, unsigned width, unsigned height) {
    return texture.resize({width, height});
}
inline void update(sf::Texture& texture, const std::uint8_t* rgba, unsigned width, unsigned height,
                   unsigned x, unsigned y) {
    texture.update(rgba, {width, height}, {x, y});
}
inline bool load(sf::Font& font, const std::string& file) {
    return font.openFromFile(file);
}

/// Converts an event for the rest of the program; false for kinds that are not used.
inline bool convert(const sf::Event& event, InputEvent& out) {
    out = {};
    const auto place = [&](sf::Vector2i at) {
        out.x = static_cast<float>(at.x);
        out.y = static_cast<float>(at.y);
    };
    const auto key = [&](EventKind kind, const auto& e) {
        out.kind = kind;
        out.name = e.scancode == sf::Keyboard::Scan::Grave ? "grave" : key_name(e.code);
        out.control = e.control, out.shift = e.shift, out.alt = e.alt;
    };
    const auto button = [&](EventKind kind, const auto& e) {
        out.kind = kind;
        out.name = button_name(e.button);
        place(e.position);
    };
    const auto gamepad = [&](EventKind kind, unsigned number) {
        out.kind = kind;
        out.gamepad = static_cast<int>(number) + 1;
    };
    bool known = true;
    event.visit([&](const auto& e) {
        using E = std::decay_t<decltype(e)>;
        if constexpr (std::is_same_v<E, sf::Event::Closed>) {
            out.kind = EventKind::closing;
        } else if constexpr (std::is_same_v<E, sf::Event::Resized>) {
            out.kind = EventKind::resized;
            place(sf::Vector2i(e.size));
        } else if constexpr (std::is_same_v<E, sf::Event::FocusGained> ||
                             std::is_same_v<E, sf::Event::FocusLost>) {
            out.kind = EventKind::focus;
            out.focused = std::is_same_v<E, sf::Event::FocusGained>;
        } else if constexpr (std::is_same_v<E, sf::Event::TextEntered>) {
            out.kind = EventKind::text;
            out.character = e.unicode;
        } else if constexpr (std::is_same_v<E, sf::Event::KeyPressed>) {
            key(EventKind::key_pressed, e);
        } else if constexpr (std::is_same_v<E, sf::Event::KeyReleased>) {
            key(EventKind::key_released, e);
        } else if constexpr (std::is_same_v<E, sf::Event::MouseButtonPressed>) {
            button(EventKind::mouse_pressed, e);
        } else if constexpr (std::is_same_v<E, sf::Event::MouseButtonReleased>) {
            button(EventKind::mouse_released, e);
        } else if constexpr (std::is_same_v<E, sf::Event::MouseMoved>) {
            out.kind = EventKind::mouse_moved;
            place(e.position);
        } else if constexpr (std::is_same_v<E, sf::Event::MouseWheelScrolled>) {
            known = e.wheel == sf::Mouse::Wheel::Vertical;
            out.kind = EventKind::wheel;
            out.delta = e.delta;
            place(e.position);
        } else if constexpr (std::is_same_v<E, sf::Event::JoystickButtonPressed>) {
            gamepad(EventKind::gamepad_pressed, e.joystickId);
            out.name = std::to_string(e.button + 1);
        } else if constexpr (std::is_same_v<E, sf::Event::JoystickButtonReleased>) {
            gamepad(EventKind::gamepad_released, e.joystickId);
            out.name = std::to_string(e.button + 1);
        } else if constexpr (std::is_same_v<E, sf::Event::JoystickMoved>) {
            gamepad(EventKind::gamepad_axis, e.joystickId);
            set_axis(out, e.axis, e.position);
        } else if constexpr (std::is_same_v<E, sf::Event::JoystickConnected>) {
            gamepad(EventKind::gamepad_connected, e.joystickId);
            out.name = device_of(e.joystickId);
        } else if constexpr (std::is_same_v<E, sf::Event::JoystickDisconnected>) {
            gamepad(EventKind::gamepad_disconnected, e.joystickId);
        } else if constexpr (std::is_same_v<E, sf::Event::TouchBegan>) {
            known = convert_touch(EventKind::mouse_pressed, e.finger, e.position, out);
        } else if constexpr (std::is_same_v<E, sf::Event::TouchMoved>) {
            known = convert_touch(EventKind::mouse_moved, e.finger, e.position, out);
        } else if constexpr (std::is_same_v<E, sf::Event::TouchEnded>) {
            known = convert_touch(EventKind::mouse_released, e.finger, e.position, out);
        } else {
            known = false;
        }
    });
    return known;
}

inline bool poll(sf::RenderWindow& window, InputEvent& out) {
    while (const std::optional<sf::Event> event = window.pollEvent())
        if (convert(*event, out)) return true;
    return false;
}

#else

inline constexpr bool has_quads = true;
inline constexpr auto quads = sf::PrimitiveType::Quads;

inline constexpr bool plays_on_openal = true;
inline bool audio_device_opened() {
    return openal_device_opened();
}
inline std::unique_ptr<sf::Cursor> load_cursor(sf::Cursor::Type type) {
    auto cursor = std::make_unique<sf::Cursor>();
    return cursor->loadFromSystem(type) ? std::move(cursor) : nullptr;
}
class StereoStream : public sf::SoundStream {
  protected:
    void open(unsigned rate) { initialize(2, rate); }
};

using Byte = sf::Uint8;
inline constexpr auto key_apostrophe = sf::Keyboard::Key::Quote;
inline constexpr auto key_grave = sf::Keyboard::Key::Tilde;
inline constexpr auto button_extra_1 = sf::Mouse::Button::XButton1;
inline constexpr auto button_extra_2 = sf::Mouse::Button::XButton2;

inline sf::FloatRect rectangle(float left, float top, float width, float height) {
    return {left, top, width, height};
}
template <class Number>
Number left(const sf::Rect<Number>& r) {
    return r.left;
}
template <class Number>
Number top(const sf::Rect<Number>& r) {
    return r.top;
}
template <class Number>
Number width(const sf::Rect<Number>& r) {
    return r.width;
}
template <class Number>
Number height(const sf::Rect<Number>& r) {
    return r.height;
}

inline unsigned width(const sf::VideoMode& mode) {
    return mode.width;
}
inline unsigned height(const sf::VideoMode& mode) {
    return mode.height;
}

/// How a window is opened.
struct Frame {
    unsigned width = 0, height = 0;  // px
    bool fullscreen = false, resizable = true;
};
inline void open(sf::RenderWindow& window, const std::string& title, const Frame& frame,
                 unsigned samples) {
    const sf::Uint32 framed = sf::Style::Titlebar | sf::Style::Close;
    const sf::Uint32 style = frame.fullscreen  ? sf::Uint32{sf::Style::Fullscreen}
                             : frame.resizable ? framed | sf::Style::Resize
                                               : framed;
    window.create(sf::VideoMode(frame.width, frame.height),
                  sf::String::fromUtf8(title.begin(), title.end()), style,
                  sf::ContextSettings(0, 0, samples));
}
inline void set_icon(sf::RenderWindow& window, const sf::Image& image) {
    window.setIcon(image.getSize().x, image.getSize().y, image.getPixelsPtr());
}
inline bool create(sf::RenderTexture& target, unsigned width, unsigned height, unsigned samples) {
    return target.create(width, height, sf::ContextSettings(0, 0, samples));
}
inline bool create(sf::Texture& texture, unsigned width, unsigned height) {
    return texture.create(width, height);
}
inline void update(sf::Texture& texture, const std::uint8_t* rgba, unsigned width, unsigned height,
                   unsigned x, unsigned y) {
    texture.update(rgba, width, height, x, y);
}
inline bool load(sf::Font& font, const std::string& file) {
    return font.loadFromFile(file);
}

/// Converts an event of a gamepad; false for other events.
inline bool convert_gamepad(const sf::Event& event, InputEvent& out) {
    const auto gamepad = [&](EventKind kind, unsigned number) {
        out.kind = kind;
        out.gamepad = static_cast<int>(number) + 1;
    };
    switch (event.type) {
        case sf::Event::JoystickButtonPressed:
        case sf::Event::JoystickButtonReleased:
            gamepad(event.type == sf::Event::JoystickButtonPressed ? EventKind::gamepad_pressed
                                                                   : EventKind::gamepad_released,
                    event.joystickButton.joystickId);
            out.name = std::to_string(event.joystickButton.button + 1);
            break;
        case sf::Event::JoystickMoved:
            gamepad(EventKind::gamepad_axis, event.joystickMove.joystickId);
            set_axis(out, event.joystickMove.axis, event.joystickMove.position);
            break;
        case sf::Event::JoystickConnected:
            gamepad(EventKind::gamepad_connected, event.joystickConnect.joystickId);
            out.name = device_of(event.joystickConnect.joystickId);
            break;
        case sf::Event::JoystickDisconnected:
            gamepad(EventKind::gamepad_disconnected, event.joystickConnect.joystickId);
            break;
        default:
            return false;
    }
    return true;
}

/// Converts an event for the rest of the program; false for kinds that are not used.
inline bool convert(const sf::Event& event, InputEvent& out) {
    out = {};
    const auto place = [&](auto x, auto y) {
        out.x = static_cast<float>(x);
        out.y = static_cast<float>(y);
    };
    const auto key = [&](EventKind kind) {
        out.kind = kind;
        out.name = key_name(event.key.code, kind == EventKind::key_pressed);
        out.control = event.key.control, out.shift = event.key.shift, out.alt = event.key.alt;
    };
    const auto button = [&](EventKind kind) {
        out.kind = kind;
        out.name = button_name(event.mouseButton.button);
        place(event.mouseButton.x, event.mouseButton.y);
    };
    const auto touch = [&](EventKind kind) {
        return convert_touch(kind, event.touch.finger, {event.touch.x, event.touch.y}, out);
    };
    switch (event.type) {
        case sf::Event::Closed:
            out.kind = EventKind::closing;
            break;
        case sf::Event::Resized:
            out.kind = EventKind::resized;
            place(event.size.width, event.size.height);
            break;
        case sf::Event::GainedFocus:
        case sf::Event::LostFocus:
            out.kind = EventKind::focus;
            out.focused = event.type == sf::Event::GainedFocus;
            break;
        case sf::Event::TextEntered:
            out.kind = EventKind::text;
            out.character = event.text.unicode;
            break;
        case sf::Event::KeyPressed:
            key(EventKind::key_pressed);
            break;
        case sf::Event::KeyReleased:
            key(EventKind::key_released);
            break;
        case sf::Event::MouseButtonPressed:
            button(EventKind::mouse_pressed);
            break;
        case sf::Event::MouseButtonReleased:
            button(EventKind::mouse_released);
            break;
        case sf::Event::MouseMoved:
            out.kind = EventKind::mouse_moved;
            place(event.mouseMove.x, event.mouseMove.y);
            break;
        case sf::Event::MouseWheelScrolled:
            if (event.mouseWheelScroll.wheel != sf::Mouse::VerticalWheel) return false;
            out.kind = EventKind::wheel;
            out.delta = event.mouseWheelScroll.delta;
            place(event.mouseWheelScroll.x, event.mouseWheelScroll.y);
            break;
        case sf::Event::TouchBegan:
            return touch(EventKind::mouse_pressed);
        case sf::Event::TouchMoved:
            return touch(EventKind::mouse_moved);
        case sf::Event::TouchEnded:
            return touch(EventKind::mouse_released);
        default:
            return convert_gamepad(event, out);
    }
    return true;
}

inline bool poll(sf::RenderWindow& window, InputEvent& out) {
    sf::Event event;
    while (window.pollEvent(event))
        if (convert(event, out)) return true;
    return false;
}

#endif

/// Whether OpenGL draws on the processor. Needs an active context.
bool renders_in_software();

}  // namespace fettle::app::sfml
