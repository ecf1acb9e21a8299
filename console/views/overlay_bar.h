#pragma once
// The overlays of the picture as a row of buttons: each switches a property of `view.show`.

#include <imgui.h>

#include <map>
#include <string>
#include <vector>

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
    /// Draws the buttons into the current window, in as many rows as they need. Where words would
    /// need more than two rows, the buttons have icons alone, so that the log keeps its room.
    void draw();
    /// In the last picture, in pixels.
    float height() const { return height_; }
    /// The rectangle of a button in the last picture; for tests.
    Rect button(const std::string& name) const;

  private:
    property::Handle show() const;
    bool draw_button(const property::Property& property, bool on, bool worded);
    static float button_width(const property::Property& property, bool worded);
    static std::size_t rows_of_words(const std::vector<const property::Property*>& shown);

    property::Tree& tree_;
    std::map<std::string, Rect> buttons_;
    float height_ = 0;
};

}  // namespace fettle::console
