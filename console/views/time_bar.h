#pragma once
// The time bar: pause, step, play back, record, go back to any stored moment, and continue from
// there. Marks show where people edited, where scripts failed and where a condition broke; a right
// click sets a bookmark. Above it, the other branches of the past have a lane each.

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <imgui.h>

#include <fettle/console/interpreter.h>
#include <fettle/property/tree.h>

#include <branches/branches.h>
#include <look/rect.h>
#include <observed/time_marks.h>
#include <views/playing_back.h>

namespace fettle::console {

class TimeBar {
  public:
    TimeBar(property::Tree& tree, const Interpreter& interpreter, TimeMarks& marks)
        : tree_(tree), interpreter_(interpreter), marks_(marks) {}
    TimeBar(const TimeBar&) = delete;

    /// Runs a command as if it were typed; and puts text into the prompt, with the cursor between
    /// the two parts.
    std::function<void(const std::string& command)> run{};
    std::function<void(const std::string& before, const std::string& after)> insert{};
    /// Says why the game cannot go to a step; and what else has happened.
    std::function<void(const std::string& problem)> report{};
    std::function<void(const std::string& line)> note{};
    /// Whether the game stands because a script failed, and what makes it go on; may be empty.
    std::function<bool()> halted{};
    std::function<void()> resume{};
    /// Whether the run is being recorded into a file; without this function there is no button.
    std::function<bool()> records{};

    using Times = GameTimes;
    Times times() const;

    /// Whether the game stores its past.
    bool available() const;
    float height() const;
    /// Draws a window of that width with its lower left corner at `corner`.
    void draw(ImVec2 corner, float width, float opacity, ImFont* bold);
    const Rect& rect() const { return rect_; }
    /// Pixels above it where its tooltips are.
    float tip_room() const { return tip_room_; }
    void hide() { rect_ = {}; }
    /// Pauses the game and goes to a step. If the past does not contain it, nothing changes.
    void go_to(std::int64_t step);
    /// As `PlayingBack::request`.
    std::string play_back(double seconds);
    /// Call before each frame: goes on with playing back. `drags`: an edit is under way.
    void play_on(bool drags);
    bool plays_back() const { return playing_back_.is_running(); }

    // Rectangles of the parts, for tests.
    const Rect& track() const { return track_; }
    const Rect& play_button() const { return play_; }
    const Rect& step_button() const { return step_; }
    const Rect& return_button() const { return return_; }
    const Rect& play_back_button() const { return play_back_; }
    const Rect& record_button() const { return record_; }
    /// Of the branches, in their order.
    const std::vector<Rect>& lanes() const { return lanes_; }
    /// An entry of the menu of a branch.
    Rect menu_entry(const std::string& label) const;

  private:
    property::Value value(const char* name) const;
    bool icon(const char* id, Rect& place);
    void draw_play(const Times& now);
    void draw_step(const Times& now);
    void draw_play_back(const Times& now);
    void draw_record();
    void follow_branch();
    void draw_lanes(const Times& now);
    void draw_lane(const Times& now, const OtherBranch& branch, const Rect& lane);
    void draw_branch_menu();
    void draw_entries(const std::string& name);
    bool entry(const char* label, const char* tip_text);
    void tip(const std::string& text) const;
    static float lane_height();
    void draw_track(const Times& now, float width);
    void draw_ruler(const Times& now) const;
    void draw_marks(const Times& now) const;
    float x_of(const Times& now, std::int64_t step) const;
    std::int64_t step_at(const Times& now, float x) const;
    static std::int64_t step_of(const Times& now, const TimeMark& mark);
    const TimeMark* mark_at(const Times& now, float x) const;
    void draw_text(const Times& now, ImFont* bold, bool narrow);

    property::Tree& tree_;
    const Interpreter& interpreter_;
    TimeMarks& marks_;
    Rect rect_, track_, play_, step_, play_back_, record_, return_;
    std::int64_t requested_ = -1;        // the last step that the drag requested
    std::vector<OtherBranch> branches_;  // as they were at the last picture
    std::vector<Rect> lanes_;
    std::string menu_of_;  // the branch whose menu is open
    bool opens_menu_ = false;
    std::vector<std::pair<std::string, Rect>> entries_;  // of the menu, as it was drawn last
    float tip_room_ = 0;
    PlayingBack playing_back_{tree_, [this](std::int64_t step) { go_to(step); }};
};

}  // namespace fettle::console
