#include <fettle/app/screen.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <stdexcept>
#include <thread>

#include <draw/canvas.h>
#include <sfml/sfml.h>
#include <sfml/system_clipboard.h>

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

/// SFML writes errors to its own stream, also for harmless cases (a virtual display has no vertical
/// synchronization). Failures are detected by return values instead.
class Silence {
  public:
    Silence() : before_(sf::err().rdbuf(nullptr)) {}
    ~Silence() { sf::err().rdbuf(before_); }
    Silence(const Silence&) = delete;

  private:
    std::streambuf* before_;
};

void write_image(const sf::Image& image, const std::filesystem::path& file) {
    std::error_code ignored;
    const std::filesystem::path folder = file.parent_path();
    if (!folder.empty() && !std::filesystem::is_directory(folder, ignored))
        throw std::runtime_error(file.string() + ": cannot be written, since there is no folder " +
                                 folder.string());
    const Silence silence;
    if (!image.saveToFile(file.string()))
        throw std::runtime_error(file.string() +
                                 ": the picture cannot be written (endings known: .png .jpg .bmp "
                                 ".tga)");
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
    void present() override {
        canvas_->flush();
        target_.display();
    }
    void save(const std::filesystem::path& file) override {
        write_image(target_.getTexture().copyToImage(), file);
    }
    Pixels pixels() const override { return pixels_of(target_.getTexture()); }
    void release_textures() override { canvas_->release_textures(); }
    Clipboard& clipboard() override { return clipboard_; }

  private:
    sf::RenderTexture target_;
    std::unique_ptr<Canvas> canvas_;
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
    explicit SfmlWindow(const WindowOptions& options) : title_(options.title) {
        const Silence silence;
        const sf::VideoMode desktop = sf::VideoMode::getDesktopMode();
        sfml::open(window_, title_, std::min(options.width, sfml::width(desktop)),
                   std::min(options.height, sfml::height(desktop)), samples);
        keep_on(desktop);
        window_.setVerticalSyncEnabled(true);
        window_.setKeyRepeatEnabled(true);  // for the console; the game gets only the first press
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
        pacer_.wait(vsync_);
    }
    void save(const std::filesystem::path& file) override {
        if (!frame_) throw std::runtime_error(file.string() + ": no frame was kept for a picture");
        write_image(frame_->copyToImage(), file);
    }
    Pixels pixels() const override { return frame_ ? pixels_of(*frame_) : Pixels{}; }
    void keep_frame() override { keep_frame_ = true; }
    void release_textures() override { canvas_->release_textures(); }
    Clipboard& clipboard() override { return clipboard_; }

    bool poll(InputEvent& event) override {
        if (!sfml::poll(window_, event)) return false;
        if (event.kind == EventKind::key_pressed)
            event.repeated = !down_.insert(event.name).second;
        else if (event.kind == EventKind::key_released)
            down_.erase(event.name);
        else if (event.kind == EventKind::focus && !event.focused)
            down_.clear();
        return true;
    }
    bool focused() const override { return window_.hasFocus(); }
    void set_title(const std::string& title) override {
        if (title == title_) return;
        title_ = title;
        window_.setTitle(sf::String::fromUtf8(title_.begin(), title_.end()));
    }
    void set_vsync(bool on) override {
        if (on == vsync_) return;
        vsync_ = on;
        const Silence silence;
        window_.setVerticalSyncEnabled(on);
    }

  private:
    /// Without a window manager, SFML 2 may put a window partly outside of the screen.
    void keep_on(const sf::VideoMode& desktop) {
        const int spare_x = static_cast<int>(sfml::width(desktop) - window_.getSize().x);
        const int spare_y = static_cast<int>(sfml::height(desktop) - window_.getSize().y);
        const sf::Vector2i at = window_.getPosition();
        if (at.x > spare_x || at.y > spare_y) window_.setPosition({spare_x / 2, spare_y / 2});
    }

    std::string title_;
    sf::RenderWindow window_;
    std::unique_ptr<Canvas> canvas_;
    std::unique_ptr<sf::Texture> frame_;
    SystemClipboard clipboard_;
    Pacer pacer_;
    std::set<std::string> down_;
    bool vsync_ = true;
    bool keep_frame_ = false;
};

}  // namespace

std::unique_ptr<Window> open_window(const WindowOptions& options) {
    require_display();
    return std::make_unique<SfmlWindow>(options);
}

std::unique_ptr<Screen> make_picture(unsigned width, unsigned height) {
    require_display();
    return std::make_unique<Picture>(width, height);
}

}  // namespace fettle::app
