#pragma once
// The time bar: pause, step, go back to any stored moment, and continue from there. Marks show
// where people edited, where scripts failed and where a condition broke; a right click sets a
// bookmark.

#include <cstdint>
#include <string>

#include <imgui.h>

#include <fettle/console/interpreter.h>
#include <fettle/property/tree.h>

#include <model/rect.h>
#include <model/time_marks.h>

namespace fettle::console {

class TimeBar {
  public:
    TimeBar(property::Tree& tree, const Interpreter& interpreter, TimeMarks& marks)
        : tree_(tree), interpreter_(interpreter), marks_(marks) {}

    struct Times {
        std::int64_t step = 0, oldest = 0, newest = 0;
        double dt = 0;
        bool paused = false;
        bool in_past() const { return step < newest; }
    };
    Times times() const;

    /// Whether the game stores its past.
    bool available() const;
    static float height();
    /// Draws a window of that width with its lower left corner at `corner`.
    void draw(ImVec2 corner, float width, float opacity, ImFont* bold);
    const Rect& rect() const { return rect_; }
    void hide() { rect_ = {}; }
    /// Pauses the game and goes to a step.
    void go_to(std::int64_t step);

    // Rectangles of the parts, for tests.
    const Rect& track() const { return track_; }
    const Rect& play_button() const { return play_; }
    const Rect& step_button() const { return step_; }
    const Rect& return_button() const { return return_; }

  private:
    property::Value value(const char* name) const;
    void set(const char* name, bool on);
    bool icon(const char* id, Rect& place);
    void draw_play(const Times& now);
    void draw_step(const Times& now);
    void draw_track(const Times& now, float width);
    void draw_ruler(const Times& now) const;
    void draw_marks(const Times& now) const;
    float x_of(const Times& now, std::int64_t step) const;
    std::int64_t step_at(const Times& now, float x) const;
    const TimeMark* mark_at(const Times& now, float x) const;
    void draw_text(const Times& now, ImFont* bold, bool narrow);

    property::Tree& tree_;
    const Interpreter& interpreter_;
    TimeMarks& marks_;
    Rect rect_, track_, play_, step_, return_;
    std::int64_t asked_ = -1;  // the last step that the drag requested
};

}  // namespace fettle::console
