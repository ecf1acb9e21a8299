#pragma once
// The class Camera: another picture of the world in a part of the screen.

#include <functional>
#include <vector>

#include <fettle/app/view.h>
#include <fettle/property/painter.h>
#include <fettle/property/tree.h>

#include <loop/camera_painter.h>

namespace fettle::app {

class Cameras {
  public:
    Cameras(property::Tree& tree, const View& view);
    Cameras(const Cameras&) = delete;

    /// Draws the game as the view shows it, then the pictures of the cameras, then what is on the
    /// screen. `game` draws all of it with a painter; without cameras it is called once.
    void draw(property::Painter& painter, const View& view, double alpha,
              const std::function<void(property::Painter&)>& game) const;

  private:
    struct Properties {
        const property::Property *viewport, *center, *height, *angle, *follow, *background,
            *visible, *z;
    };
    void define(property::Tree& tree);
    /// The visible ones in the game, in the order of their z.
    std::vector<property::Handle> shown() const;
    CameraPicture picture(property::Handle camera, const View& view, double alpha) const;

    property::Tree& tree_;
    const View& view_;
    Properties of_{};
    std::vector<property::Handle> all_{};  // in the order in which they were made
};

}  // namespace fettle::app
