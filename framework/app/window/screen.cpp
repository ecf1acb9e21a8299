#include <fettle/app/screen.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <set>
#include <stdexcept>
#include <thread>
#include <utility>

#include <draw/canvas.h>
#include <draw/effect_pass.h>
#include <sfml/sfml.h>
#include <sfml/system_clipboard.h>
#include <window/picture_file.h>

namespace fettle::app {

namespace {

// No multi-sampling: figures have their own anti-aliased rims and look the same without it.
// Software rendering needs a fifth of the time (10 000 circles at 1280 x 800: 23 ms, not 135 ms).
constexpr unsigned samples = 0;

void require_display() {
    if (!display_available())
        throw std::runtime_error(
            "there is no display to draw on: set DISPLAY, use xvfb-run, or run with --headless");
}

Pixels pixels_of(const sf::Texture& texture) {
    const sf::Image image = texture.copyToImage();
    Pixels pixels{image.getSize().x, image.getSize().y, {}};
    const std::size_t bytes = std::size_t{pixels.width} * pixels.height * 4;
    if (bytes > 0) pixels.rgba.assign(image.getPixelsPtr(), image.getPixelsPtr() + bytes);
    return pixels;
}

/// The clipboard of a picture in memory; it is not shared with other programs.
class OwnClipboard : public Clipboard {
  public:
    std::string read() override { return text_; }
    void write(std::string_view text) override { text_ = text; }

  private:
    std::string text_;
};

class Picture : public Screen {
  public:
    Picture(unsigned width, unsigned height) {
        if (!sfml::create(target_, width, height, samples))
            throw std::runtime_error("a picture of " + std::to_string(width) + " x " +
                                     std::to_string(height) + " pixels cannot be made");
        canvas_ = std::make_unique<Canvas>(target_);
    }
    property::Vec2 size() const override {
        return {static_cast<double>(target_.getSize().x), static_cast<double>(target_.getSize().y)};
    }
    void begin(property::Color background) override { canvas_->begin(background); }
    property::Painter& painter(const View& view) override {
        canvas_->set_view(view);
        return *canvas_;
    }
    Surface& surface() override { return *canvas_; }
    std::string apply(const Effect& effect) override {
        canvas_->flush();
        return effect_.draw(target_, effect, [this](sf::Texture& copy) {
            target_.display();
            copy.update(target_.getTexture());
            return false;
        });
    }
    void present() override {
        canvas_->flush();
        target_.display();
    }
    void save(const std::filesystem::path& file) override { write_picture(pixels(), file); }
    Pixels pixels() const override { return pixels_of(target_.getTexture()); }
    void release_textures() override { canvas_->release_textures(); }
    Clipboard& clipboard() override { return clipboard_; }

  private:
    sf::RenderTexture target_;
    std::unique_ptr<Canvas> canvas_;
    EffectPass effect_;
    OwnClipboard clipboard_;
};

/// Limits the frame rate where the system does not: some drivers ignore vertical synchronization,
/// and virtual displays do not have it.
class Pacer {
  public:
    void wait(bool vsync) {
        using std::chrono::steady_clock;
        const auto now = steady_clock::now();
        const auto spent = now - last_;
        last_ = now;
        if (!vsync) {
            fast_frames_ = 0;
            return;
        }
        fast_frames_ = spent < std::chrono::milliseconds(4) ? fast_frames_ + 1 : 0;
        if (fast_frames_ > 20) waits_ = true;
        if (!waits_) return;
        constexpr auto frame = steady_clock::duration(std::chrono::seconds(1)) / 60;
        next_ = std::max(next_ + frame, now);
        if (next_ > now + frame) next_ = now + frame;
        std::this_thread::sleep_until(next_);
        last_ = steady_clock::now();
    }

  private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
    std::chrono::steady_clock::time_point next_ = last_;
    int fast_frames_ = 0;
    bool waits_ = false;
};

class SfmlWindow : public Window {
  public:
    explicit SfmlWindow(const WindowState& state) : state_(state) {
        open();
        reported_size_ = size();
        opened_ = reported_size_;
        canvas_ = std::make_unique<Canvas>(window_);
    }
    property::Vec2 size() const override {
        return {static_cast<double>(window_.getSize().x), static_cast<double>(window_.getSize().y)};
    }
    void begin(property::Color background) override { canvas_->begin(background); }
    property::Painter& painter(const View& view) override {
        canvas_->set_view(view);
        return *canvas_;
    }
    std::string apply(const Effect& effect) override {
        canvas_->flush();
        return effect_.draw(window_, effect, [this](sf::Texture& copy) {
            copy.update(window_);
            return true;
        });
    }
    Surface& surface() override { return *canvas_; }
    void present() override {
        canvas_->flush();
        if (keep_frame_) {
            if (!frame_) frame_ = std::make_unique<sf::Texture>();
            if (frame_->getSize() != window_.getSize())
                (void)sfml::create(*frame_, window_.getSize().x, window_.getSize().y);
            frame_->update(window_);
            keep_frame_ = false;
        }
        window_.display();
        pacer_.wait(state_.vsync);
    }
    void save(const std::filesystem::path& file) override {
        if (!frame_) throw std::runtime_error(file.string() + ": no frame was kept for a picture");
        write_picture(pixels(), file);
    }
    Pixels pixels() const override { return frame_ ? pixels_of(*frame_) : Pixels{}; }
    void keep_frame() override { keep_frame_ = true; }
    void release_textures() override { canvas_->release_textures(); }
    Clipboard& clipboard() override { return clipboard_; }

    bool poll(InputEvent& event) override {
        if (poll_gamepads(event) || poll_missed_release(event)) return true;
        do {
            if (!sfml::poll(window_, event)) return poll_size(event);
        } while (is_size_of_opening(event) || is_known_release(event));
        if (event.kind == EventKind::mouse_pressed)
            buttons_.insert(event.name);
        else if (event.kind == EventKind::key_pressed)
            event.repeated = !down_.insert(event.name).second;
        else if (event.kind == EventKind::key_released)
            down_.erase(event.name);
        else if (event.kind == EventKind::focus && !event.focused)
            down_.clear();
        else if (event.kind == EventKind::resized)
            reported_size_ = {event.x, event.y};
        return true;
    }
    bool focused() const override { return window_.hasFocus(); }
    void follow(const WindowState& state) override {
        const sfml::NoMessages quiet;
        const WindowState before = std::exchange(state_, state);
        if (state.fullscreen != before.fullscreen || state.resizable != before.resizable) {
            open();
            return;
        }
        if (!state.fullscreen && state.size != reported_size_) {
            reported_size_ = state.size;
            window_.setSize(
                {static_cast<unsigned>(state.size.x), static_cast<unsigned>(state.size.y)});
            keep_on_desktop();
        }
        if (state.title != before.title)
            window_.setTitle(sf::String::fromUtf8(state_.title.begin(), state_.title.end()));
        if (state.vsync != before.vsync) window_.setVerticalSyncEnabled(state.vsync);
        if (state.cursor_visible != before.cursor_visible)
            window_.setMouseCursorVisible(state.cursor_visible);
        if (state.cursor != before.cursor) show_cursor();
        if (state.grab_mouse != before.grab_mouse) window_.setMouseCursorGrabbed(state.grab_mouse);
    }
    bool set_icon(const std::string& bytes) override {
        const sfml::NoMessages quiet;
        sf::Image image;
        if (!image.loadFromMemory(bytes.data(), bytes.size())) return false;
        icon_ = std::make_unique<sf::Image>(std::move(image));
        sfml::set_icon(window_, *icon_);
        return true;
    }
    void report_gamepads() override { next_gamepad_ = 0; }

  private:
    /// Opens the window, or opens it again: a change of its frame needs that.
    void open() {
        const sfml::NoMessages quiet;
        const sf::VideoMode desktop = sf::VideoMode::getDesktopMode();
        sfml::Frame frame{.width = sfml::width(desktop),
                          .height = sfml::height(desktop),
                          .fullscreen = state_.fullscreen,
                          .resizable = state_.resizable};
        if (!state_.fullscreen) {
            frame.width = std::min(frame.width, static_cast<unsigned>(state_.size.x));
            frame.height = std::min(frame.height, static_cast<unsigned>(state_.size.y));
        }
        sfml::open(window_, state_.title, frame, samples);
        if (!state_.fullscreen) keep_on_desktop();
        window_.setVerticalSyncEnabled(state_.vsync);
        window_.setMouseCursorVisible(state_.cursor_visible);
        window_.setKeyRepeatEnabled(true);  // for the console; the game gets only the first press
        if (icon_) sfml::set_icon(window_, *icon_);
        if (state_.cursor != Cursor::arrow) show_cursor();
        window_.setMouseCursorGrabbed(state_.grab_mouse);
        reported_size_ = {0, 0};  // so that the size of a window that was opened again is reported
        opened_ = std::nullopt;
        reopened_ = true;
        awaits_keyboard_ = true;
        buttons_before_ = buttons_;
    }
    /// SFML only reports gamepads that are plugged in while the window is open, so the others are
    /// reported here.
    bool poll_gamepads(InputEvent& event) {
        while (next_gamepad_ < sf::Joystick::Count) {
            const unsigned gamepad = next_gamepad_++;
            if (!sf::Joystick::isConnected(gamepad)) continue;
            event = {};
            event.kind = EventKind::gamepad_connected;
            event.gamepad = static_cast<int>(gamepad) + 1;
            event.name = sfml::device_of(gamepad);
            return true;
        }
        return false;
    }
    /// Reports releases that happened while the window was opened again. The system reports them to
    /// neither window: the release of a key before the window has the keyboard, and that of a mouse
    /// button outside of the window.
    bool poll_missed_release(InputEvent& event) {
        return poll_missed_button_release(event) || poll_missed_key_release(event);
    }
    bool poll_missed_button_release(InputEvent& event) {
        const auto released = std::ranges::find_if_not(buttons_before_, sfml::is_button_down);
        if (released == buttons_before_.end()) return false;
        const sf::Vector2i at = sf::Mouse::getPosition(window_);
        event = {};
        event.kind = EventKind::mouse_released;
        event.name = *released;
        event.x = static_cast<float>(at.x);
        event.y = static_cast<float>(at.y);
        buttons_.erase(*released);
        buttons_before_.erase(released);
        return true;
    }
    /// True for a release that was reported already, or whose press was not reported.
    bool is_known_release(const InputEvent& event) {
        if (event.kind != EventKind::mouse_released) return false;
        buttons_before_.erase(event.name);
        return buttons_.erase(event.name) == 0;
    }
    bool poll_missed_key_release(InputEvent& event) {
        if (!awaits_keyboard_) return false;
        const auto released = std::ranges::find_if_not(down_, sfml::is_down);
        if (released == down_.end()) {
            awaits_keyboard_ = !window_.hasFocus();
            return false;
        }
        event = {};
        event.kind = EventKind::key_released;
        event.name = *released;
        down_.erase(released);
        return true;
    }
    void show_cursor() {
        // The window uses the cursor until it gets another one.
        if (std::unique_ptr<sf::Cursor> cursor = sfml::system_cursor(state_.cursor)) {
            window_.setMouseCursor(*cursor);
            cursor_ = std::move(cursor);
        }
    }
    /// True for the event with the size with which the window was first opened. The game has this
    /// size already, and may have set another one meanwhile.
    bool is_size_of_opening(const InputEvent& event) {
        if (event.kind != EventKind::resized) return false;
        const std::optional<property::Vec2> opened = std::exchange(opened_, std::nullopt);
        return opened && *opened == property::Vec2(event.x, event.y);
    }
    /// Reports the size of a window that was opened again, since the system may not.
    bool poll_size(InputEvent& event) {
        if (!std::exchange(reopened_, false) || size() == reported_size_) return false;
        reported_size_ = size();
        event = {};
        event.kind = EventKind::resized;
        event.x = static_cast<float>(reported_size_.x);
        event.y = static_cast<float>(reported_size_.y);
        return true;
    }
    /// A window that becomes larger, or that SFML 2 opens without a window manager, may be partly
    /// outside of the desktop. It is moved to the middle.
    void keep_on_desktop() {
        const sf::VideoMode desktop = sf::VideoMode::getDesktopMode();
        const int spare_x = static_cast<int>(sfml::width(desktop) - window_.getSize().x);
        const int spare_y = static_cast<int>(sfml::height(desktop) - window_.getSize().y);
        const sf::Vector2i at = window_.getPosition();
        if (at.x > spare_x || at.y > spare_y) window_.setPosition({spare_x / 2, spare_y / 2});
    }

    WindowState state_;
    property::Vec2 reported_size_{0, 0};      // px, the size that was reported to the game
    std::optional<property::Vec2> opened_{};  // px, until the system has reported another size
    bool reopened_ = false;
    unsigned next_gamepad_ = 0;  // to be reported
    std::unique_ptr<sf::Image> icon_;
    std::unique_ptr<sf::Cursor> cursor_;
    sf::RenderWindow window_;
    std::unique_ptr<Canvas> canvas_;
    EffectPass effect_;
    std::unique_ptr<sf::Texture> frame_;
    SystemClipboard clipboard_;
    Pacer pacer_;
    std::set<std::string> down_;
    std::set<std::string> buttons_;         // of the mouse, held
    std::set<std::string> buttons_before_;  // held since before the window was opened again
    bool awaits_keyboard_ = false;  // the window was opened and has not had the keyboard yet
    bool keep_frame_ = false;
};

}  // namespace

Pixels read_picture(const std::filesystem::path& file) {
    const sfml::NoMessages quiet;
    sf::Image image;
    if (!image.loadFromFile(file.string()))
        throw std::runtime_error(file.string() + ": this file is not an image that can be read");
    Pixels pixels{image.getSize().x, image.getSize().y, {}};
    const std::size_t bytes = std::size_t{pixels.width} * pixels.height * 4;
    pixels.rgba.assign(image.getPixelsPtr(), image.getPixelsPtr() + bytes);
    return pixels;
}

std::unique_ptr<Window> open_window(const WindowState& state) {
    require_display();
    return std::make_unique<SfmlWindow>(state);
}

std::unique_ptr<Screen> make_picture(unsigned width, unsigned height) {
    require_display();
    return std::make_unique<Picture>(width, height);
}

}  // namespace fettle::app
