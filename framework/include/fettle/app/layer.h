#pragma once
// A layer lies over the game: it gets input first and draws last, such as the console and the error
// screen.

#include <string>
#include <string_view>

#include <fettle/app/event.h>
#include <fettle/app/export.h>
#include <fettle/app/surface.h>

FETTLE_APP_BEGIN

namespace fettle::app {

/// The system clipboard.
class Clipboard {
  public:
    virtual ~Clipboard() = default;
    virtual std::string read() = 0;                 ///< "" if it has no text
    virtual void write(std::string_view text) = 0;  ///< replaces its text
};

/// Lies over the game: it gets input first and is drawn last.
class Layer {
  public:
    virtual ~Layer() = default;
    /// True: the event goes no further, neither to lower layers nor to the game.
    virtual bool handle(const InputEvent& event) = 0;
    /// Once a frame, after the game is drawn. `seconds`: real time since the last frame.
    virtual void draw(Surface& surface, double seconds) = 0;
    /// The part of `whole` that this layer leaves free, in pixels: other layers draw texts there,
    /// such as the legend of the game's overlays or an error.
    virtual ClipRectangle free_area(const ClipRectangle& whole) const { return whole; }
    /// Height of its texts, which a person may have chosen for a screen of many pixels; 0: unknown.
    virtual float text_size() const { return 0; }
};

}  // namespace fettle::app

FETTLE_APP_END
