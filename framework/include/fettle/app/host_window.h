#pragma once
// Layers in a window of another library: a game with its own loop and SFML window gets the console
// by passing its events to it and letting it draw last.

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

/// The window must outlive this object, which never opens, clears or displays it.
class HostWindow {
  public:
    /// For a window, which must outlive it.
    explicit HostWindow(sf::RenderWindow& window);
    ~HostWindow();
    HostWindow(const HostWindow&) = delete;
    HostWindow& operator=(const HostWindow&) = delete;

    /// True: the layer has used the event, and the game should not get it.
    bool handle(const sf::Event& event, Layer& layer);
    /// Draws the layer over the picture. `seconds`: real time since the last frame. Leaves the
    /// window's own view unchanged.
    void draw(Layer& layer, double seconds);
    /// Draws instances of the tree in the world as `view` shows it, each with the draw function of
    /// its class.
    void draw(const property::Tree& tree, property::Handle top, const View& view, double alpha);
    Clipboard& clipboard();  ///< that of the system

  private:
    struct FETTLE_APP_PRIVATE State;
    std::unique_ptr<State> state_;
};

}  // namespace fettle::app

FETTLE_APP_END
