#pragma once
// Fields for editing one number or one text. Dear ImGui's drag fields do not support infinity,
// units or the shortest decimal of a float, and they round values.

#include <imgui.h>

#include <functional>
#include <optional>
#include <string>
#include <utility>

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
    /// Computes a text that is not a number ("2 * math.pi"); optional. It throws if the text has an
    /// error, and returns nothing for a value that is no number.
    std::function<std::optional<double>(const std::string& expression)> calculate;

    /// A number that is dragged sideways (shift: slower; control: slowest), or clicked for typing.
    /// Returns the new value on each change.
    std::optional<double> number(const char* id, double value, const NumberLook& look, float width);
    /// One line of text. Returns the new text when Enter is pressed or the field loses the focus.
    std::optional<std::string> text(const char* id, const std::string& value, float width);

    /// The text field `id` gets the focus in the next frames, with that text.
    void begin_text(const char* id, std::string text);
    bool types_into(const char* id) const { return typing_ == ImGui::GetID(id); }

    bool typing() const { return typing_ != 0; }
    /// Goes from the field that has the focus to the next one, or to the one before; if none has
    /// it, to the first one. What was typed is entered.
    void move_focus(bool back) { focus_move_ = back ? FocusMove::previous : FocusMove::next; }
    bool moves_focus() const { return focus_move_ != FocusMove::none; }
    /// Makes the widget that was drawn last a stop of `move_focus`: for widgets that are not
    /// fields, such as a check box. Returns true once if it has the focus and `press_widget` was
    /// called.
    bool focus_stop(const char* id);
    bool widget_has_focus() const { return focused_widget_ != 0; }
    void press_widget() { pressed_ = true; }
    void unfocus_widget() { focused_widget_ = 0; }
    /// True once after `move_focus(true)` at the first field.
    bool consume_moved_before_first() { return std::exchange(moved_before_first_, false); }

    /// A field was clicked for typing and gets the focus within the next frames.
    bool about_to_type() const { return typing_ != 0 && !typing_active_; }
    /// Must be called once per frame, after all fields.
    void end_frame();
    /// The message if the last typed text is not a number, otherwise "".
    std::string consume_problem();
    /// The expression, if "is EXPRESSION" was typed, otherwise "".
    std::string consume_formula();
    /// True once after typing has ended, whatever was typed.
    bool consume_settled();
    /// The value that a field has just returned is refused: if it was entered with Enter, the field
    /// keeps the focus and the text, so that it can be mended.
    void refuse();

  private:
    std::optional<double> typed_number(const char* id, const NumberLook& look, float width);
    std::optional<double> parse(const std::string& typed, std::string_view unit);
    double dragged(double pixels, const NumberLook& look);
    void start_typing(ImGuiID field, std::string text);
    bool receives_focus(ImGuiID field, const std::string& text);
    void focus_previous();

    // Only one field at a time is dragged or edited.
    ImGuiID typing_ = 0;
    bool typing_active_ = false;
    bool typing_seen_ = false;
    int frames_to_focus_ = 0;
    std::string buffer_;
    std::string before_;
    double start_ = 0, travelled_ = 0;
    bool moved_ = false;
    std::string problem_, formula_;
    ImGuiID committed_ = 0;  // the field that returned a text in this frame
    std::string committed_text_;
    bool by_enter_ = false, settled_ = false;
    enum class FocusMove { none, next, previous };
    FocusMove focus_move_ = FocusMove::none;
    bool moved_before_first_ = false;
    ImGuiID focused_widget_ = 0;  // the widget that is no field and has the keyboard
    bool focused_widget_seen_ = false, pressed_ = false;
    struct Previous {
        ImGuiID field = 0;
        std::string text;
        float y = 0;  // in its window
        bool is_field = true;
    };
    Previous previous_;  // the last field before the one that has the keyboard
};

/// An input line without a length limit. `flags`: ImGuiInputTextFlags.
bool input_line(const char* id, const char* hint, std::string& text, int flags);

}  // namespace fettle::console
