#pragma once
// The overlays of the picture as a row of buttons: each switches a property of `view.show`.

#include <imgui.h>

#include <map>
#include <string>

#include <fettle/property/tree.h>

#include <look/rect.h>

namespace fettle::console {

class OverlayBar {
  public:
    explicit OverlayBar(property::Tree& tree) : tree_(tree) {}

    /// Whether the game has a `view.show`.
    bool available() const { return static_cast<bool>(show()); }
    /// Number of overlays that are shown now.
    int lit() const;
    /// Draws the buttons into the current window, in as many rows as they need.
    void draw();
    /// In the last picture, in pixels.
    float height() const { return height_; }
    /// The rectangle of a button in the last picture; for tests.
    Rect button(const std::string& name) const;

  private:
    property::Handle show() const;
    bool draw_button(const property::Property& property, bool on);

    property::Tree& tree_;
    std::map<std::string, Rect> buttons_;
    float height_ = 0;
};

}  // namespace fettle::console
