#pragma once
// Layers in a window that is somebody else's: a game with a loop and a window of its own, written
// with SFML, gets the console by handing it its events and letting it draw last.

#include <memory>

#include <fettle/app/export.h>
#include <fettle/app/layer.h>
#include <fettle/app/view.h>
#include <fettle/property/tree.h>

namespace sf {
class Event;
class RenderWindow;
}  // namespace sf

FETTLE_APP_BEGIN

namespace fettle::app {

/// The window must outlive it. It opens, clears and shows nothing by itself.
class HostWindow {
  public:
    explicit HostWindow(sf::RenderWindow& window);
    ~HostWindow();
    HostWindow(const HostWindow&) = delete;
    HostWindow& operator=(const HostWindow&) = delete;

    /// True: the layer has taken the event, the game should not have it too.
    bool handle(const sf::Event& event, Layer& layer);
    /// Draws the layer over what is there. `seconds`: real time since the last frame. The window's
    /// own view is as it was afterwards.
    void draw(Layer& layer, double seconds);
    /// Draws instances of the tree in the world as `view` shows it, each by its class's own
    /// drawing.
    void draw(const property::Tree& tree, property::Handle top, const View& view, double alpha);
    Clipboard& clipboard();

  private:
    struct FETTLE_APP_PRIVATE State;
    std::unique_ptr<State> state_;
};

}  // namespace fettle::app

FETTLE_APP_END
