#pragma once
// The places of the widgets on the screen. They are computed when one is needed and something has
// changed.

#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

#include <fettle/property/media.h>

#include <layout/writing.h>
#include <widgets/widgets.h>

namespace fettle::interface {

/// Sizes of controls, in pixels of the layout.
namespace measure {
inline constexpr double button_x = 18, button_y = 9;  // between the edge and the text
inline constexpr double switch_width = 42, switch_height = 24;
inline constexpr double knob = 9;         // radius
inline constexpr double bar = 20;         // height of a progress bar
inline constexpr double scroll_bar = 12;  // width
inline constexpr double field_x = 11;
inline constexpr double control_width = 220;
inline constexpr double list_height = 220;
inline constexpr double narrowest = 60;  // width to which a text is cut in a row at most
}  // namespace measure

class Layout {
  public:
    Layout(Widgets& widgets, property::Media& media) : widgets_(widgets), media_(media) {}

    /// Lays out if something has changed. `screen`: px.
    void update(const property::Vec2& screen);
    /// Widgets without a parent, in the order of drawing.
    const std::vector<property::Row>& tops() const { return tops_; }
    /// All widgets that are shown, in the order of drawing.
    const std::vector<property::Row>& shown() const { return shown_; }
    std::uint64_t count() const { return count_; }
    property::Media& media() const { return media_; }
    /// What an Image shows.
    const property::Picture& picture_of(const Widget& widget) const;

    static double padding_of(const Widget& widget);
    static double spacing_of(const Widget& widget);
    /// Height of a line of a list.
    static double line_of(const Widget& list);
    /// The part of a list that shows its content.
    static Box inside(const Widget& list);
    /// How far the list is scrolled: at most to the end.
    static double scrolled(const Widget& list);

  private:
    void collect();
    void collect_below(property::Row row, property::Row parent, const Theme& theme, bool shown,
                       int depth);
    void load_font(const Widget& widget);
    const Theme& theme_of(const Widget& widget, const Theme& above);
    void sort_tops();

    property::Vec2 measure(property::Row row, double width);
    property::Vec2 natural(Widget& widget, double width);
    property::Vec2 natural_line(Widget& widget, double width, int along);
    property::Vec2 natural_grid(Widget& widget, double width);
    property::Vec2 measure_cell(property::Row child, double width);
    std::vector<double> rows_of(const Widget& grid) const;
    std::vector<double> growths_of(const Widget& grid) const;
    property::Vec2 natural_panel(Widget& widget, double width);
    double longest_word(const Widget& widget) const;
    double widest_text(Widget& row, double width, double needed);
    property::Vec2 natural_control(Widget& widget, double width);
    property::Vec2 natural_list(Widget& widget, double width);
    property::Vec2 natural_text(Widget& widget, double width);

    void arrange(property::Row row, Box box, const Box& clip);
    void arrange_panel(Widget& widget, const Box& inner, const Box& clip);
    void arrange_line(Widget& widget, const Box& inner, const Box& clip, int along);
    void arrange_grid(Widget& widget, const Box& inner, const Box& clip);
    void arrange_list(Widget& widget);
    void write(Widget& widget);
    Box snapped(const Box& box) const;

    Widgets& widgets_;
    property::Media& media_;
    property::Vec2 screen_{0, 0};
    double scale_ = 0;
    std::vector<property::Row> tops_, shown_;
    std::unordered_map<property::Row, std::size_t> places_;  // in the order of the tree
    std::vector<double> order_;  // `z` of the tops when they were sorted
    std::uint64_t count_ = 0;
};

}  // namespace fettle::interface
