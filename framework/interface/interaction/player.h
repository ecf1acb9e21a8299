#pragma once
// The effect of mouse, keys and gamepads on the widgets.

#include <optional>
#include <string>
#include <string_view>

#include <fettle/app/foreground.h>

#include <binding/binding.h>
#include <interaction/words.h>
#include <layout/layout.h>
#include <widgets/widgets.h>

namespace fettle::interface {

class Player {
  public:
    Player(Widgets& widgets, Layout& layout, Binding& binding)
        : widgets_(widgets), layout_(layout), binding_(binding) {}

    bool takes(const app::Act& act);
    void handle(const app::Act& act, bool taken);
    /// `seconds`: since the last frame.
    void frame(const property::Vec2& mouse, const property::Vec2& screen, double seconds);
    void lay_out() { layout_.update(screen_); }
    /// The size of the screen before the first frame, px.
    void begin_on(const property::Vec2& screen) { screen_ = screen; }
    /// The widget that a click would be on; null if there is none.
    const Widget* hovered() { return under(at(mouse_)); }
    /// The widget that is seen at a point of the screen, also one that no click has an effect on;
    /// null if there is none.
    const Widget* seen_at(const property::Vec2& pixels);

  private:
    // Positions.
    property::Vec2 at(const property::Vec2& pixels) const { return pixels / widgets_.scale; }
    Widget* under(const property::Vec2& point);
    Widget* list_under(const property::Vec2& point);
    Widget* above(const Widget& widget);
    /// The modal widget in front of the others; null if there is none.
    Widget* modal();
    bool inside(const Widget& widget, const Widget& top);
    bool enabled(const Widget& widget);
    bool can_focus(const Widget& widget);
    Widget* focused();
    Widget* listening();

    // The keyboard.
    void focus(Widget* widget, bool shown);
    void keep_focus();
    std::vector<Widget*> reachable();
    void next(int direction);
    void towards(const property::Vec2& direction);
    /// Whether a key is held down: "shift", "control".
    bool holds(const std::string& name) const;
    bool key(const std::string& name, bool repeated);
    bool key_of(Widget& widget, const std::string& name);
    void activate(Widget& widget);
    void cancel();

    // Gamepads.
    void gamepad_button(const app::Act& act, bool taken);
    void stick(const app::Act& act, bool taken);
    void begin_direction(const std::string& key);
    void end_direction(std::string_view key);
    void repeat_direction(double seconds);

    // The mouse.
    void press(const property::Vec2& point);
    void release(const property::Vec2& point);
    void drag(Widget& widget, const property::Vec2& point);
    void scroll(Widget& list, double pixels);

    // Values.
    void choose_value(Widget& slider, double value);
    void nudge(Widget& slider, int direction);
    void switch_over(Widget& toggle);
    void select(Widget& list, std::int64_t line);
    void show_line(Widget& list);
    void capture(Widget& button, const app::Act& act);
    void hold(property::Handle widget);

    // Text: editing.cpp.
    bool edit(Widget& field, const std::string& key);
    bool shortcut(Widget& field, const std::string& key);
    void type(Widget& field, const std::string& text);
    void erase(Widget& field, bool onward, bool by_words);
    void replace(Widget& field, const Span& span, const std::string& by);
    void set_text(Widget& field, const std::string& text, std::int64_t caret);
    void put_caret(Widget& field, std::int64_t caret, std::optional<std::int64_t> mark);
    std::optional<std::int64_t> caret_after(const Widget& field, const std::string& key,
                                            bool by_words, bool selecting);
    static std::int64_t room(const Widget& field);
    std::string clipboard() const;
    void copy(const Widget& field);
    void paste(Widget& field);
    std::int64_t place_near(const Widget& field, const property::Vec2& point);
    void press_text(Widget& field, const property::Vec2& point);
    void drag_text(Widget& field, const property::Vec2& point);

    /// The last clicks on a text field, which follow each other quickly.
    struct Clicks {
        property::Handle field{};
        int count = 0;
        double since = 0;  // s, after the last one
        property::Vec2 at{0, 0};
        Span word{};  // at the first one
    };

    Widgets& widgets_;
    Layout& layout_;
    Binding& binding_;
    property::Vec2 mouse_{0, 0}, screen_{1280, 720};  // px
    bool down_ = false;                               // the left button of the mouse
    Clicks clicks_{};
    bool drags_bar_ = false;  // the bar of the list that is held
    property::Vec2 stick_{0, 0};
    std::string direction_{};     // the arrow key that a gamepad holds down; "" for none
    double until_repeated_ = 0;   // s
    property::Handle outside_{};  // has the keyboard while no modal widget is there
};

}  // namespace fettle::interface
