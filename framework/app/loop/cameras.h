#pragma once
// The class Camera: another picture of the world in a part of the screen.

#include <functional>
#include <vector>

#include <fettle/app/services.h>  // declares the class, which is not exported
#include <fettle/app/view.h>
#include <fettle/property/painter.h>
#include <fettle/property/tree.h>

#include <loop/camera_painter.h>

namespace fettle::app {

class Cameras {
  public:
    Cameras(property::Tree& tree, const View& view);
    Cameras(const Cameras&) = delete;

    /// One step of the simulation, `dt` seconds long: cameras follow and keep to their limits.
    void advance(double dt);
    /// To be called at the beginning and at the end of each step, for pictures between two steps.
    void note_step_begins();
    void note_step_ended();
    /// Draws the game as the view shows it, then the pictures of the cameras, then what is on the
    /// screen. `game` draws all of it with a painter; without cameras it is called once. `alpha`:
    /// position between the last two steps, 0 to 1.
    void draw(property::Painter& painter, const View& view, double alpha,
              const std::function<void(property::Painter&)>& game);

  private:
    /// The data of a camera that the tree does not store.
    struct Row {
        property::Handle self{};  // null: the row is free
        property::Track track{};  // for drawing only
    };
    struct Properties {
        const property::Property *viewport, *center, *height, *angle, *follow, *follow_damping,
            *dead_zone, *limits, *shake_amount, *shake_length, *shake_left, *background, *visible,
            *z;
    };
    void define(property::Tree& tree);
    std::vector<property::Property> properties();
    /// The visible ones in the game, in the order of their z.
    std::vector<property::Handle> shown() const;
    /// The picture of a camera as a view, and its place on the screen. The instance that it follows
    /// is taken where it is drawn at `alpha`.
    CameraPicture picture(property::Handle camera, const property::Vec2& screen,
                          double alpha) const;
    /// The same between the last two steps, and shaken.
    CameraPicture drawn(property::Handle camera, const property::Vec2& screen, double alpha) const;
    /// The picture that is being drawn; otherwise that after the last step.
    CameraPicture seen(property::Handle camera) const;
    double zoom(property::Row row) const;
    void set_zoom(property::Row row, double zoom);
    void advance(Row& row, double dt);
    property::Placement placement(property::Handle camera) const;
    /// Calls `visit(row)` for the cameras in the game.
    void each(const std::function<void(Row&)>& visit);

    property::Tree& tree_;
    const View& view_;
    Properties of_{};
    std::vector<Row> rows_{};
    std::vector<property::Handle> all_{};  // in the order in which they were made
};

}  // namespace fettle::app
