#pragma once
// The values of one widget.

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <fettle/property/tree.h>

#include <themes/themes.h>

namespace fettle::interface {

enum class Kind : std::uint8_t {
    panel,
    row,
    column,
    list,
    button,
    label,
    image,
    slider,
    toggle,
    text_field,
    progress_bar
};

/// On the screen, y down: `lower` is the top left corner.
struct Box {
    property::Vec2 lower{0, 0}, upper{0, 0};
    property::Vec2 size() const { return upper - lower; }
    double width() const { return upper.x - lower.x; }
    double height() const { return upper.y - lower.y; }
    property::Vec2 center() const { return 0.5 * (lower + upper); }
    bool contains(const property::Vec2& p) const {
        return p.x >= lower.x && p.x < upper.x && p.y >= lower.y && p.y < upper.y;
    }
    Box smaller(double by) const {
        return {lower + property::Vec2(by, by), upper - property::Vec2(by, by)};
    }
    Box within(const Box& other) const { return {lower.max(other.lower), upper.min(other.upper)}; }
};

/// Where a widget is to be, and how large.
struct Placing {
    std::string anchor = "top_left", fill = "none";
    property::Vec2 offset{0, 0}, size{0, 0}, min_size{0, 0};
    double grow = 0;
    std::optional<double> padding, spacing;            // of a container
    std::string align = "stretch", justify = "start";  // of what is in a row or a column
    std::int64_t columns = 1;                          // of a column: more than one is a grid
};

/// How a widget looks.
struct Style {
    property::Handle theme{};
    double opacity = 1;
    std::optional<double> radius, font_size;
    std::optional<property::Color> color, text_color;
    property::Color tint{1, 1, 1, 1};
    std::string text_align = "left", overflow = "cut";
    std::string look = "normal", font;
};

/// The data that a widget shows, and the data that the player changes.
struct Content {
    std::string text, image, bind, placeholder, prompt = "press a key";
    double value = 0, step = 0, scroll = 0;
    std::optional<double> min, max;
    bool on = false, listening = false;
    std::optional<std::int64_t> mark;  // the other end of the selection
    std::int64_t caret = 0, max_length = 0, selected = 0;
    property::List items{};
};

inline constexpr property::Row no_widget = std::numeric_limits<property::Row>::max();

/// The results of the layout.
struct Arranged {
    std::vector<property::Row> children{};
    property::Row parent = no_widget;
    const Theme* look_of = nullptr;  // its theme
    property::Vec2 wanted{0, 0};     // size
    Box box{}, clip{};
    std::vector<std::string> lines{};  // of its text
    double content_height = 0;         // of a list
    std::vector<double> columns{};     // widths, of a grid
    bool shown = false;                // visible, with all above it
};

/// Numbers that change gradually while a widget is drawn.
struct Animation {
    double hover = 0, press = 0, ring = 0, switched = -1;  // 0 to 1; below 0: not known yet
    double view_left = 0;                                  // px, what a text field has scrolled
};

/// The bound property and the value of the widget, as they were when they were compared last.
struct BoundValue {
    property::Value own_before{}, target_before{};
    bool bound_before = false;
    std::string problem{};  // the last one that was reported
};

struct Widget {
    property::Handle self{};
    Kind kind = Kind::panel;
    bool visible = true, disabled = false, focusable = true, modal = false;
    property::Handle last_focus{};
    Placing placing{};
    Style style{};
    Content content{};
    Arranged arranged{};
    Animation animation{};
    BoundValue bound{};
};

inline bool is_container(Kind kind) {
    return kind <= Kind::list;
}
inline bool is_active(Kind kind) {
    return kind == Kind::button || kind == Kind::slider || kind == Kind::toggle ||
           kind == Kind::text_field || kind == Kind::list;
}

/// Whether its widgets are in several columns.
inline bool is_grid(const Widget& widget) {
    return widget.kind == Kind::column && widget.placing.columns > 1;
}

/// Whether it covers what lies below it with a color of its own, as a container.
inline bool has_background(const Widget& widget) {
    if (!is_container(widget.kind)) return false;
    if (widget.style.color) return widget.style.color->a > 0;
    return widget.kind == Kind::panel || widget.kind == Kind::list;
}

}  // namespace fettle::interface
