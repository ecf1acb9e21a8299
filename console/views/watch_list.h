#pragma once
// The pinned values, each with a line of its latest samples.

#include <imgui.h>

#include <functional>
#include <string>
#include <vector>

#include <fettle/property/tree.h>

#include <look/rect.h>
#include <observed/trace.h>

namespace fettle::console {

/// An observed value for people.
struct ObservedText {
    std::string text;
    std::size_t spare = 0;  // letters that a longer value needs more than this one

    /// The width of a place that stays the same while the value changes, in pixels.
    float place() const;
};
/// The value with numbers of `digits` digits, and with the unit. `largest`: see `aligned_number`.
ObservedText observed_text(const property::Tree& tree, const property::Value& value,
                           const std::string& unit, double largest, int digits = 4);

/// With as many digits, 2 to 4, as leave it in `room`, which is what the name beside it leaves; if
/// even two are too many, as leave it in `widest`, and then the name is shortened.
ObservedText observed_text_in(const property::Tree& tree, const property::Value& value,
                              const std::string& unit, double largest, float room, float widest);

class WatchList {
  public:
    /// Runs a command as if it were typed.
    std::function<void(const std::string& command)> run;
    /// Called when a pinned path is clicked; when it is clicked with the right button.
    std::function<void(std::string_view path)> follow, menu;

    /// Draws a window with its lower left corner at `corner`; not taller than `room`.
    void draw(ImVec2 corner, float width, float room, const property::Tree& tree,
              const std::vector<Trace>& pins, float opacity);
    const Rect& rect() const { return rect_; }
    void hide() { rect_ = {}; }
    /// The rectangle of the button that unpins the nth value, for tests.
    Rect button(std::size_t index) const {
        return index < buttons_.size() ? buttons_[index] : Rect();
    }

    /// How a pin is drawn in that width.
    struct Row {
        std::vector<std::string> above{};  // the name, if it does not fit beside the value
        ObservedText value{};
        float name_width = 0, value_width = 0;  // px, of their places
        float room = 0;                         // px, of both together
        float curve = 0;                        // px, of the place of the curve
        float height = 0;                       // px
    };
    Row row_of(const property::Tree& tree, const Trace& pin, float width, bool low) const;

  private:
    void draw_row(const property::Tree& tree, const Trace& pin, const Row& row, float width);

    Rect rect_;
    std::vector<Rect> buttons_;
    std::string unpinned_;
};

/// Draws samples as a line into a rectangle, scaled to their range.
void draw_sparkline(ImDrawList& list, const Rect& rect, const Trace& trace);

}  // namespace fettle::console
