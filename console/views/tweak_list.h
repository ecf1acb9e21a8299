#pragma once
// The list of tweaks above the log: old and new values, times, and buttons to keep, apply again or
// drop them.

#include <imgui.h>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <fettle/property/storage/tweaks.h>
#include <fettle/script/runtime.h>

#include <look/rect.h>

namespace fettle::console {

class TweakList {
  public:
    explicit TweakList(property::Tweaks* tweaks) : tweaks_(tweaks) {}

    /// Runs a command as if it were typed.
    std::function<script::Evaluation(std::string_view command)> evaluate;

    /// Receives the result of a button, one line per call.
    std::function<void(const std::string& line)> report;
    /// Called when the path of a tweak is clicked.
    std::function<void(std::string_view path)> follow;

    bool available() const { return tweaks_ != nullptr; }
    /// Number of tweaks that are neither kept nor dropped.
    std::size_t open_count();
    void draw(float height);

    /// The rectangle of a button of a row, or of the header (row -1), in pixels; "kept": the name
    /// of the file in its place. For tests.
    Rect button(int row, std::string_view label) const;
    /// Whether the times have a column of their own.
    bool shows_times() const { return times_; }

  private:
    using Tweak = property::Tweak;
    void refresh(bool now);
    /// Whether the tweak of the row does not exist any more: the row keeps its place.
    bool is_gone(std::size_t row) const;
    void draw_header();
    void draw_row(int row);
    void draw_change(const Tweak& tweak);
    bool small_button(int row, const char* label, const char* hint);
    void act(const char* function, const std::string& pattern);

    property::Tweaks* tweaks_;
    std::vector<Tweak> rows_;
    std::vector<bool> gone_{};  // by row; while the mouse is over the list
    bool hovered_ = false;
    double refreshed_ = -1;
    bool times_ = true;
    struct Drawn {
        int row;
        std::string label;
        Rect rect;
    };
    std::vector<Drawn> drawn_;
};

}  // namespace fettle::console
