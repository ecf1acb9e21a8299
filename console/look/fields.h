#pragma once
// Fields to edit one number or one text in. Dear ImGui's own drag fields know neither infinity nor
// units nor the shortest decimal of a float, and round what they are given; these do not.

#include <imgui.h>

#include <functional>
#include <optional>
#include <string>

#include <fettle/property/class.h>

namespace fettle::console {

struct NumberLook {
    std::string_view unit{};
    property::Range range{};
    property::Precision precision = property::Precision::double_precision;
    bool integer = false;
    std::string_view label{};  // "x" and "y" of a vector
};

class Fields {
  public:
    /// What a text that is not a number comes to ("2 * math.pi"); may be missing.
    std::function<std::optional<double>(const std::string& expression)> calculate;

    /// Dragged sideways (shift: slower; alt: finest), clicked or ctrl-clicked to type. The new
    /// value, on each change.
    std::optional<double> number(const char* id, double value, const NumberLook& look, float width);
    /// One line; the new text when Enter is pressed or the field is left.
    std::optional<std::string> text(const char* id, const std::string& value, float width);

    /// A field was clicked to be typed into and takes the keyboard within the next frames.
    bool about_to_type() const { return typing_ != 0 && !typing_active_; }
    /// Call once a frame, after all fields.
    void end_frame();
    /// What was typed last and is no number; "" when it was.
    std::string take_problem();

  private:
    std::optional<double> typed_number(const char* id, const NumberLook& look, float width);
    std::optional<double> parse(const std::string& typed, std::string_view unit);
    double dragged(double pixels, const NumberLook& look);
    void start_typing(ImGuiID field, std::string text);

    // One field at a time is dragged or typed into.
    ImGuiID typing_ = 0;
    bool typing_active_ = false;
    bool typing_seen_ = false;
    int frames_to_focus_ = 0;
    std::string buffer_;
    std::string before_;
    double start_ = 0, travelled_ = 0;
    bool moved_ = false;
    std::string problem_;
};

/// A line of text that grows as needed. `flags`: ImGuiInputTextFlags.
bool input_line(const char* id, const char* hint, std::string& text, int flags);

}  // namespace fettle::console
