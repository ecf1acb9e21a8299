#pragma once
// One property as a row: name, the widget for its type, its error, and a button that restores the
// default. Values are read while the row is visible, and written through the tree like any edit.

#include <imgui.h>

#include <functional>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include <fettle/property/tree.h>

#include <editing/mixed_values.h>
#include <editing/reference_picker.h>
#include <editing/row_layout.h>
#include <look/fields.h>
#include <look/rect.h>

namespace fettle::console {

class PropertyEditor {
  public:
    explicit PropertyEditor(property::Tree& tree) : tree_(tree), references_(tree) {}
    ~PropertyEditor() { end_drag(); }
    PropertyEditor(const PropertyEditor&) = delete;

    /// Called when a reference is clicked.
    std::function<void(property::Handle)> follow;
    /// Makes an expression the formula of the property with that path. Returns why it is refused,
    /// or "".
    std::function<std::string(const std::string& path, const std::string& expression)> define;
    /// Called with the path of a property that was clicked with the right button.
    std::function<void(const std::string& path)> menu;

    /// Called when the last writer of the property with that path is clicked.
    std::function<void(const property::Cause&, const std::string& path)> go_to_write;
    /// The rectangle of the last writer in the last frame; empty if it was not visible.
    Rect gutter_rect(const property::Property& property) const;
    /// Begins typing a formula in the row of a property of the shown instance.
    void begin_formula(const property::Property& property) { formula_begins_ = &property; }

    /// Edits also change these instances if they have the property.
    void also_edit(const std::vector<property::Handle>& others, std::uint64_t revision) {
        mixed_.compare_with(others, revision);
    }
    /// Must be called before the rows of an instance, with all of them: makes their column of names
    /// wide enough for the longest one, as far as the values leave room.
    void fit_labels(const std::vector<const property::Property*>& properties) {
        layout_.fit(properties);
    }
    /// True if something was edited; then other properties may not exist any more.
    bool draw(property::Handle instance, const property::Property& property, ImFont* bold);
    /// Must be called once per frame, before all rows, and `end_frame` after them.
    void begin_frame();
    void end_frame() { fields_.end_frame(); }
    /// Ends a running drag, which becomes a step of undo. Must be called when the editor is hidden.
    void end_drag();
    /// Whether a drag has begun an edit that its end will end.
    bool drags() const { return dragging_; }
    /// The rectangle of the property's widget in the last frame; empty if it was not visible.
    Rect widget_rect(const property::Property& property) const;
    bool about_to_type() const { return fields_.about_to_type() || fields_.moves_focus(); }
    /// Whether a field, or a widget at which `move_focus` has stopped, has the keyboard.
    bool typing() const { return fields_.typing() || fields_.widget_has_focus(); }
    /// Goes to the next field, or the one before; see `Fields`.
    void move_focus(bool back) { fields_.move_focus(back); }
    bool consume_moved_before_first() { return fields_.consume_moved_before_first(); }
    /// Removes the shown errors, because another instance is edited.
    void forget() {
        problems_.clear();
        formula_of_ = nullptr;
    }
    std::size_t problems() const { return problems_.size(); }
    /// Why the last edit of a property of the shown instance was refused; "" if it was not.
    std::string problem(const property::Property& property) const;

    Fields& fields() { return fields_; }

  private:
    struct Target {
        property::Handle instance;
        const property::Property* property;
    };
    /// Where the value of a property comes from.
    struct Origin {
        bool formula = false;
        bool ad_hoc = false;
        bool resettable = false;
        std::string source{}, problem{};  // of the formula
    };
    bool is_plain(const property::Property& property) const;
    Origin origin_of(property::Handle instance, const property::Property& property) const;
    void take_typed(const Target& target);
    void remarks(const property::Property& property, const Origin& origin, float left);
    void label(const Target& target, float width, bool overridden, bool formula, ImFont* bold);
    void tooltip(const Target& target, ImFont* bold);
    /// True if the property does not exist any more.
    bool reset_button(const Target& target);
    /// Draws a line of text below the widget.
    void remark(float left, ImU32 color, const std::string& text);
    bool written_by_simulation(property::Handle instance, const property::Property& property) const;
    void mixed_line(const Target& target, float start, float indent, const std::string& text);
    void offer_menu(const Target& target);
    /// Width of the column with the last writer: a text, or a mark if there is no room for one.
    static float gutter_width(float available);
    static constexpr float wide_enough = 40;  // font heights
    void gutter(const Target& target, ImVec2 at, float width);
    void widget(const Target& target, const property::Value& value, float width, float before);
    /// The line for a formula, in place of the widget. False if no formula is typed here.
    bool formula_line(const Target& target, const std::string& source, float width);
    /// Defines a formula for the instance and the other selected ones.
    void define_formula(const Target& target, const std::string& expression);
    void boolean(const Target& target, const property::Value& value);
    void number(const Target& target, const property::Value& value, float width);
    void text(const Target& target, const property::Value& value, float width);
    void enumerator(const Target& target, const property::Value& value, float width);
    void vector(const Target& target, const property::Value& value, float width);
    void color(const Target& target, const property::Value& value, float width);
    /// Draws a link to an instance; `editable_reference` adds a list to choose another one.
    void reference(property::Handle to, float width);
    void editable_reference(const Target& target, property::Handle to, float width);
    void nil(const Target& target, float width);
    /// Its elements may begin `before` pixels further left, where they need more than `width`.
    void list(const Target& target, const property::Value& value, float width, float before);
    void element(const Target& target, const property::List& elements, std::size_t index,
                 float width);
    /// The new vector if one of its two fields changed. Where both do not fit side by side, they
    /// are one above the other.
    std::optional<property::Vec2> vector_fields(const Target& target, property::Vec2 value,
                                                float width);
    /// The value that a property of that type gets first.
    static property::Value zero_of(property::Type type);
    static NumberLook look_of(const property::Property& property);
    void write(const Target& target, const property::Value& value);
    /// Runs an edit; the text of its exception is shown below the row.
    void attempt(const Target& target, const std::function<void()>& edit);

    std::string name_of_edit(const Target& target) const;
    /// Runs an edit for the instance and for the others, as one step of undo.
    void edit_all(const Target& target, const std::string& name,
                  const std::function<void(property::Handle, const property::Property&)>& edit);

    property::Value edited(property::Handle instance, const property::Property& property,
                           const property::Value& before, const property::Value& after) const;

    property::Tree& tree_;
    RowLayout layout_;
    MixedValues mixed_;
    Fields fields_;
    ReferencePicker references_;
    // The property whose formula is typed, and the one for which typing begins in this frame.
    const property::Property *formula_of_ = nullptr, *formula_begins_ = nullptr;
    bool edited_ = false;
    bool dragging_ = false;
    std::unordered_map<const property::Property*, std::string> problems_;
    std::string seen_problem_;  // that was scrolled into view
    property::Handle problems_of_;
    std::unordered_map<const property::Property*, Rect> widgets_, gutters_;
};

/// The writer of a value as text: "main.lua:30", "console, step 412", "physics".
std::string writer_text(const property::Cause& cause);
/// File and line of a place in a script; no file for other places.
std::pair<std::string, int> script_place(const std::string& where);

}  // namespace fettle::console
