#pragma once
// Two runs side by side, played again and again.

#include <imgui.h>

#include <functional>

#include <fettle/property/tree.h>

#include <branches/comparison.h>
#include <look/pen.h>
#include <look/rect.h>

namespace fettle::console {

class CompareView {
  public:
    /// In a lower window, in pixels, there are no pictures.
    static constexpr float least_height = 80;
    /// The height of a window of this width in which both pictures use all of their width.
    /// `aspect`: width / height of a picture.
    static float height(float width, float aspect);

    /// Ends the comparison.
    std::function<void()> close;

    /// Draws a window in `place`. `pictures`: textures for the pictures of the game. `seconds`:
    /// since the last picture; `dt`: of a step.
    void draw(const Rect& place, const Comparison& runs, GamePictures& pictures, double seconds,
              double dt);
    const Rect& rect() const { return rect_; }
    void hide() { rect_ = track_ = close_ = {}; }
    /// For tests: the track on which a moment is chosen, the button that ends it, and the index of
    /// the moment that is shown.
    const Rect& track() const { return track_; }
    const Rect& close_button() const { return close_; }
    std::size_t shown() const { return shown_; }

  private:
    void draw_note(const Rect& place, const std::string& whole, const std::string& brief,
                   int rows_below) const;
    void draw_side(const Rect& place, const Comparison& runs, bool second,
                   GamePictures& pictures) const;
    void draw_title(const Rect& place, const std::string& name, const std::string& what,
                    ImU32 color) const;
    void draw_track(const Comparison& runs, double dt);
    void play(const Comparison& runs, double seconds, double dt);

    Rect rect_, track_, close_;
    std::size_t shown_ = 0;
    double time_ = 0;  // s since the first moment
    int number_ = 0;   // of the comparison
    bool held_ = false;
};

}  // namespace fettle::console
