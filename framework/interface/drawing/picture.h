#pragma once
// Draws the widgets.

#include <string>

#include <fettle/property/media.h>
#include <fettle/property/painter.h>

#include <binding/binding.h>
#include <interaction/player.h>
#include <layout/layout.h>
#include <widgets/widgets.h>

namespace fettle::interface {

class Picture {
  public:
    Picture(Widgets& widgets, Layout& layout, Binding& binding, Player& player)
        : widgets_(widgets), layout_(layout), binding_(binding), player_(player) {}
    /// `seconds`: real time since the last call, for soft changes of color.
    void advance(double seconds);
    void draw(property::Painter& painter, const property::Vec2& screen);

  private:
    void draw_widget(Widget& widget, bool enabled);
    void draw_background(const Widget& widget);
    void draw_button(const Widget& widget);
    void draw_image(const Widget& widget, const Box& box, property::Color tint);
    void draw_slider(const Widget& widget);
    void draw_toggle(const Widget& widget);
    void draw_field(Widget& widget);
    void draw_selection(const Widget& field, const std::vector<double>& carets,
                        const property::Vec2& at);
    void draw_progress(const Widget& widget);
    void draw_list(const Widget& widget);
    void draw_lines(const Widget& widget, const Box& box, property::Color color);
    void draw_text(const property::Vec2& at, const std::string& text, const Widget& widget,
                   property::Color color, property::TextAlign align);
    void draw_ring(const Widget& widget);
    void draw_shade(const Theme& theme, const property::Vec2& screen);

    void box(const Box& box, double radius, property::Color fill, property::Color border = none);
    void disc(const property::Vec2& center, double radius, property::Color fill);
    double radius_of(const Widget& widget) const;
    double share(const Widget& widget) const;

    static constexpr property::Color none{0, 0, 0, 0};

    Widgets& widgets_;
    Layout& layout_;
    Binding& binding_;
    Player& player_;
    property::Painter* painter_ = nullptr;
    double time_ = 0;  // s, for the caret
};

}  // namespace fettle::interface
