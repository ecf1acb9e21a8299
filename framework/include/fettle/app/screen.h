#pragma once
// The target of drawing: a window, or a picture in memory. Both need a display; a headless run
// creates neither.

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
    /// The surface for drawing in pixels, over the picture.
    virtual Surface& surface() = 0;
    /// Ends a frame and shows it.
    virtual void present() = 0;
    /// Call before a frame that is to be saved: a window otherwise does not keep its frames.
    virtual void keep_frame() {}
    /// Writes the last kept frame. The ending of the name is the format: png, jpg, bmp or tga.
    /// Throws std::runtime_error that names file and reason.
    virtual void save(const std::filesystem::path& file) = 0;
    /// Pixels of the last kept frame; empty if there is none.
    virtual Pixels pixels() const = 0;
    /// Releases every texture that a layer made on the surface, after the layer is destroyed.
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
    /// Frames wait for the screen; if the system does not support it, the window waits itself. Off:
    /// no waiting.
    virtual void set_vsync(bool on) = 0;
};

/// True if a window or a picture can be created. Creates neither and is safe without a display.
bool display_available();

/// Both throw std::runtime_error when there is no display.
std::unique_ptr<Window> open_window(const WindowOptions& options);
std::unique_ptr<Screen> make_picture(unsigned width, unsigned height);

}  // namespace fettle::app

FETTLE_APP_END
