#pragma once
// What a frame is drawn on: a window, or a picture in memory. Both need a display; a headless run
// makes neither.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fettle/app/event.h>
#include <fettle/app/export.h>
#include <fettle/app/layer.h>
#include <fettle/app/surface.h>
#include <fettle/app/view.h>
#include <fettle/property/painter.h>
#include <fettle/property/value.h>

FETTLE_APP_BEGIN

namespace fettle::app {

/// Rows from the top, four bytes a pixel: red, green, blue, opacity.
struct Pixels {
    unsigned width = 0, height = 0;
    std::vector<std::uint8_t> rgba{};
};

class Screen {
  public:
    virtual ~Screen() = default;
    virtual property::Vec2 size() const = 0;  // px
    /// Starts a frame.
    virtual void begin(property::Color background) = 0;
    /// Draws in the world as `view` shows it. Valid until `present`.
    virtual property::Painter& painter(const View& view) = 0;
    /// Draws in pixels, over what was drawn before.
    virtual Surface& surface() = 0;
    /// Ends a frame and shows it.
    virtual void present() = 0;
    /// The frame presented next is to be saved: a window shows its frames and forgets them.
    virtual void keep_frame() {}
    /// Writes the last frame kept. The ending of the name says the format: png, jpg, bmp or
    /// tga. Throws std::runtime_error that names file and reason.
    virtual void save(const std::filesystem::path& file) = 0;
    /// Of the last frame kept; none when there was none.
    virtual Pixels pixels() const = 0;
    /// Forgets every texture a layer made on the surface: its maker is gone.
    virtual void release_textures() = 0;
    virtual Clipboard& clipboard() = 0;
};

struct WindowOptions {
    std::string title = "Fettle";
    unsigned width = 1280, height = 800;  // px
};

class Window : public Screen {
  public:
    /// The next event since the last call; false when there is none.
    virtual bool poll(InputEvent& event) = 0;
    virtual bool focused() const = 0;
    virtual void set_title(const std::string& title) = 0;
    /// Frames wait for the screen; where the system does not do it, the window waits by itself.
    /// Off: as fast as they go.
    virtual void set_vsync(bool on) = 0;
};

/// Whether a window or a picture can be made. Makes neither and is safe without a display.
bool display_available();

/// Both throw std::runtime_error when there is no display.
std::unique_ptr<Window> open_window(const WindowOptions& options);
std::unique_ptr<Screen> make_picture(unsigned width, unsigned height);

}  // namespace fettle::app

FETTLE_APP_END
