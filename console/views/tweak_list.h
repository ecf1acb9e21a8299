#pragma once
// The tweaks, as a list over the log: what was changed to what, and when; keep, make again, drop.

#include <imgui.h>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include <fettle/property/storage/tweaks.h>
#include <fettle/script/runtime.h>

#include <model/rect.h>

namespace fettle::console {

class TweakList {
  public:
    explicit TweakList(property::Tweaks* tweaks) : tweaks_(tweaks) {}

    /// Performs a command as if it had been typed.
    std::function<script::Evaluation(std::string_view command)> evaluate;

    /// Told what came of a button, a line each.
    std::function<void(const std::string& line)> say;
    /// The path of a tweak was clicked.
    std::function<void(std::string_view path)> follow;

    bool available() const { return tweaks_ != nullptr; }
    /// How many are neither kept nor dropped.
    std::size_t open_count();
    void draw(float height);

    /// As last drawn, in pixels: of the button of a row, or of all (row -1). For tests.
    Rect button(int row, std::string_view label) const;

  private:
    using Tweak = property::Tweak;
    void refresh(bool now);
    void draw_header();
    void draw_row(int row);
    void draw_change(const Tweak& tweak);
    bool small_button(int row, const char* label, const char* hint);
    void act(const char* function, const std::string& pattern);

    property::Tweaks* tweaks_;
    std::vector<Tweak> rows_;
    double refreshed_ = -1;
    struct Drawn {
        int row;
        std::string label;
        Rect rect;
    };
    std::vector<Drawn> drawn_;
};

}  // namespace fettle::console
