#pragma once
// Where the time of the last frames went: a bar for each frame, and one frame by its parts.

#include <imgui.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include <fettle/app/frame_log.h>
#include <fettle/property/tree.h>

#include <look/rect.h>

namespace fettle::console {

class FrameView {
  public:
    /// Pauses the game and goes to a step of the kept past.
    std::function<void(std::int64_t step)> go_to;
    /// Ends the view.
    std::function<void()> close;

    /// Draws a window with its lower left corner at `corner`. `dt`: s, the time that a frame has.
    void draw(ImVec2 corner, ImVec2 size, const property::Tree& tree, const app::FrameLog& log,
              double dt, float opacity);
    static float height();
    const Rect& rect() const { return rect_; }
    void hide() { rect_ = bars_ = worst_ = {}; }
    /// The rectangles of the bars, of the button that goes to the worst frame, and of the button
    /// that ends the view; for tests.
    const Rect& bars() const { return bars_; }
    const Rect& worst_button() const { return worst_; }
    const Rect& close_button() const { return close_; }
    /// The frame that the lower part shows; nothing before the first frame.
    const std::optional<app::FrameTimes>& shown() const { return shown_; }

  private:
    void choose(const app::FrameTimes& frame, const app::FrameLog& log);
    Rect draw_buttons(const app::FrameLog& log);
    void draw_heading(const Rect& room) const;
    std::optional<std::size_t> draw_bars(const app::FrameLog& log, double dt);
    void draw_flame(const Rect& place, const property::Tree& tree, bool newest);

    Rect rect_, bars_, worst_, close_;
    std::optional<app::FrameTimes> shown_;
    /// The frame that was clicked. It is shown while the game stands at its step, also when the log
    /// has lost it.
    std::optional<app::FrameTimes> chosen_;
    std::int64_t step_before_ = 0;  // the step at which it was clicked
};

/// The frame that worked longest; waiting does not count. Nothing if there is none.
std::optional<app::FrameTimes> worst_frame(const app::FrameLog& log);

}  // namespace fettle::console
