#pragma once
// The target of drawing: a window, or a picture in memory. Both need a display; a headless run
// creates neither.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include <fettle/app/effect.h>
#include <fettle/app/event.h>
#include <fettle/app/export.h>
#include <fettle/app/layer.h>
#include <fettle/app/surface.h>
#include <fettle/app/view.h>
#include <fettle/app/window_state.h>
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
    /// Draws the picture of the frame so far again through a shader. Returns why that failed, with
    /// the line of an error in the shader; "" if it was drawn.
    virtual std::string apply(const Effect& effect) {
        (void)effect;
        return {};
    }
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

class Window : public Screen {
  public:
    /// The next event since the last call; false when there is none.
    virtual bool poll(InputEvent& event) = 0;
    virtual bool focused() const = 0;
    /// Changes the window to this state. If its size changes, an event reports the new size. With
    /// vertical synchronization, frames wait for the screen; if the system does not support that,
    /// the window waits itself.
    virtual void follow(const WindowState& state) = 0;
    /// Shows an image, the content of a file, in the task bar. False if it is not an image.
    virtual bool set_icon(const std::string& image) = 0;
    /// Lets `poll` report the gamepads that are plugged in, for a game that starts now. A window
    /// that was just opened does so by itself.
    virtual void report_gamepads() = 0;
};

/// The pixels of an image file. Throws std::runtime_error that names file and reason.
Pixels read_picture(const std::filesystem::path& file);

/// True if a window or a picture can be created. Creates neither and is safe without a display.
bool display_available();

/// Both throw std::runtime_error when there is no display.
std::unique_ptr<Window> open_window(const WindowState& state);
std::unique_ptr<Screen> make_picture(unsigned width, unsigned height);

}  // namespace fettle::app

FETTLE_APP_END
