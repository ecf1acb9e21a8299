#pragma once
// Values over time, with the kept past. A click goes to that step.

#include <imgui.h>

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fettle/property/tree.h>

#include <look/rect.h>
#include <observed/trace.h>

namespace fettle::console {

/// The time between two labels below curves that are `seconds` long. There are at least two labels,
/// because a single one does not show the scale.
double seconds_between_labels(double seconds);
/// The difference of the values of two labels beside curves of that span and height, which do not
/// touch: a label is `line` high.
double value_between_labels(double span, float tall, float line);

/// The range of values that a plot shows, when those of its curves are from `low` to `high`.
std::pair<double, double> shown_range(double low, double high);

class PlotView {
  public:
    /// Runs a command as if it were typed.
    std::function<void(const std::string& command)> run;
    /// Goes to a step of the kept past.
    std::function<void(std::int64_t step)> go_to;

    /// The step of the game, the kept ones, and the seconds of a step.
    struct Times {
        std::int64_t step = 0, oldest = 0, newest = 0;
        double dt = 1.0 / 60;
    };

    /// Draws a window with its lower left corner at `corner`. It grows with the number of values,
    /// up to the height `room`.
    void draw(ImVec2 corner, ImVec2 size, float room, const property::Tree& tree,
              const std::vector<Trace>& plots, const Times& times, float opacity);
    /// The height that the legend takes for all values but the first.
    static float added_legend_height(std::size_t values);
    const Rect& rect() const { return rect_; }
    void hide() { rect_ = area_ = {}; }
    /// The rectangle of the curves, and of the button that ends the plot; for tests.
    const Rect& area() const { return area_; }
    /// The rectangle of an entry of the menu.
    Rect entry(std::string_view label) const;
    const Rect& close_button() const { return close_; }
    /// The lines of the legend, with the widths of the names in them, and the values.
    struct Line {
        Rect rect{};
        float name = 0;
        std::string value{};
    };
    const std::vector<Line>& legend() const { return legend_; }

  private:
    struct Scale {
        std::int64_t first = 0, last = 1;
        double low = 0, high = 1;
    };
    Scale scale_of(const std::vector<Trace>& plots, const Times& times) const;
    ImVec2 point(const Scale& scale, std::int64_t step, double value) const;
    void draw_grid(const Scale& scale, const Times& times, bool labels) const;
    void draw_curves(const Scale& scale, const std::vector<Trace>& plots) const;
    void draw_legend(const property::Tree& tree, const std::vector<Trace>& plots,
                     std::int64_t step);
    void draw_cursor(const Scale& scale, const Times& times, std::int64_t step) const;

    void draw_menu();

    Rect rect_, area_, close_;
    std::vector<Line> legend_;
    std::vector<std::pair<std::string, Rect>> menu_;
    std::int64_t requested_ = -1;
};

}  // namespace fettle::console
