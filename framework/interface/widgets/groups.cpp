#include <widgets/groups.h>

#include <themes/fields.h>

namespace fettle::interface {

using property::accessor;
using property::Property;
using property::Row;
using property::Type;
using property::Value;

namespace {

constexpr property::Range lengths{0, 100'000};
constexpr property::Range places{-100'000, 100'000};

/// A value that is computed, not kept.
template <class Get>
Property computed(Widgets& widgets, const char* name, Type type, const char* unit, const char* doc,
                  Get get) {
    return {.name = name,
            .type = type,
            .unit = unit,
            .doc = doc,
            .binding = accessor(widgets, get),
            .read_only = true,
            .transient = true,
            .simulated = true};
}

Properties computed_properties(Widgets& widgets) {
    return {
        computed(
            widgets, "hovered", Type::boolean, "", "Whether the mouse is over it.",
            [](Widgets& w, Row row) { return w.callbacks.hovered && w.callbacks.hovered(row); }),
        computed(widgets, "focused", Type::boolean, "", "Whether it has the keyboard.",
                 [](Widgets& w, Row row) { return w.board.focus == w[row].self; }),
        computed(widgets, "held", Type::boolean, "", "Whether the player holds it down.",
                 [](Widgets& w, Row row) { return w.board.held == w[row].self; }),
        computed(widgets, "shown", Type::boolean, "",
                 "Whether it is on the screen: it and all widgets around it are visible.",
                 [](Widgets& w, Row row) {
                     if (w.callbacks.lay_out) w.callbacks.lay_out();
                     return w[row].arranged.shown;
                 }),
        computed(widgets, "screen_position", Type::vec2, "px",
                 "Where its top left corner is on the screen.",
                 [](Widgets& w, Row row) {
                     if (w.callbacks.lay_out) w.callbacks.lay_out();
                     return property::Vec2(w[row].arranged.box.lower * w.scale);
                 }),
        computed(widgets, "screen_size", Type::vec2, "px", "Its width and height on the screen.",
                 [](Widgets& w, Row row) {
                     if (w.callbacks.lay_out) w.callbacks.lay_out();
                     return property::Vec2(w[row].arranged.box.size() * w.scale);
                 }),
    };
}

}  // namespace

Properties common_properties(Widgets& widgets) {
    return joined(
        {
            field<&Widget::placing, &Placing::anchor>(
                widgets,
                {.name = "anchor",
                 .doc = "Which point of the panel, or of the screen, it is at, with its own point "
                        "of that name. Rows, columns and lists place their widgets themselves.",
                 .enumerators = {"top_left", "top", "top_right", "left", "center", "right",
                                 "bottom_left", "bottom", "bottom_right"}}),
            field<&Widget::placing, &Placing::offset>(
                widgets, {.name = "offset",
                          .unit = "px",
                          .range = places,
                          .doc = "By how much it is moved from its place, y down."}),
            field<&Widget::placing, &Placing::size>(
                widgets, {.name = "size",
                          .unit = "px",
                          .range = lengths,
                          .doc = "Width and height; 0: as large as what is in it needs."}),
            field<&Widget::placing, &Placing::min_size>(widgets,
                                                        {.name = "min_size",
                                                         .unit = "px",
                                                         .range = lengths,
                                                         .doc = "The least width and height."}),
            field<&Widget::placing, &Placing::fill>(
                widgets, {.name = "fill",
                          .doc = "Whether it takes all the width or height that there is.",
                          .enumerators = {"none", "width", "height", "both"}}),
            field<&Widget::placing, &Placing::grow>(
                widgets,
                {.name = "grow",
                 .range = {0, 1e6},
                 .doc = "Its share of the length that is left over in a row or column; 0: none."}),
            field<&Widget::visible>(widgets, {.name = "visible",
                                              .doc = "Whether it is drawn and takes up room, with "
                                                     "everything below it."}),
            field<&Widget::disabled>(
                widgets, {.name = "disabled",
                          .doc = "Whether it is pale and does nothing, with everything below it."}),
            field<&Widget::style, &Style::opacity>(
                widgets, {.name = "opacity",
                          .range = {0, 1},
                          .doc = "Multiplies the opacity of it and of everything below it."}),
            field<&Widget::style, &Style::theme>(
                widgets,
                {.name = "theme",
                 .doc =
                     "Colors, font and distances of it and of everything below it; nil: those of "
                     "the widget above it, at the top those of interface.theme.",
                 .reference_class = "Theme"}),
        },
        computed_properties(widgets));
}

Properties container_properties(Widgets& widgets) {
    return {
        field<&Widget::placing, &Placing::padding>(
            widgets,
            {.name = "padding",
             .unit = "px",
             .range = lengths,
             .doc = "Distance between its edge and what is in it. nil: that of the theme for "
                    "panels, 5 for lists, 0 for rows and columns."}),
        field<&Widget::style, &Style::color>(
            widgets,
            {.name = "color",
             .doc = "Its background. nil: that of the theme; rows and columns have none."}),
        field<&Widget::style, &Style::radius>(
            widgets, {.name = "radius",
                      .unit = "px",
                      .range = lengths,
                      .doc = "Radius of its corners; nil: that of the theme."}),
        field<&Widget::modal>(
            widgets,
            {.name = "modal",
             .doc =
                 "While it is visible, it gets all keys, buttons and clicks: nothing reaches the "
                 "game or other widgets. If it has a background, a shade covers what is behind "
                 "it."}),
        field<&Widget::last_focus>(widgets, {.name = "last_focus",
                                             .doc = "The widget in it that had the keyboard last.",
                                             .hidden = true,
                                             .reference_class = "Widget"}),
    };
}

Properties line_up_properties(Widgets& widgets) {
    return {
        field<&Widget::placing, &Placing::spacing>(
            widgets, {.name = "spacing",
                      .unit = "px",
                      .range = lengths,
                      .doc = "Distance between its widgets; nil: that of the theme."}),
        field<&Widget::placing, &Placing::align>(
            widgets,
            {.name = "align",
             .doc = "Where its widgets are across its direction; stretch: they are as wide "
                    "as it is.",
             .enumerators = {"start", "center", "end", "stretch"}}),
        field<&Widget::placing, &Placing::justify>(
            widgets, {.name = "justify",
                      .doc = "Where its widgets are along its direction if they leave room.",
                      .enumerators = {"start", "center", "end"}}),
    };
}

Properties text_properties(Widgets& widgets, const char* align, const char* overflow) {
    Property align_property = field<&Widget::style, &Style::text_align>(
        widgets, {.name = "text_align",
                  .doc = "Where its text is.",
                  .enumerators = {"left", "center", "right"}});
    align_property.default_value = Value(align);
    Property overflow_property = field<&Widget::style, &Style::overflow>(
        widgets, {.name = "overflow",
                  .doc = "What happens with text that is too long for its width: cut ends it with "
                         "\"…\", wrap continues it in another line.",
                  .enumerators = {"cut", "wrap"}});
    overflow_property.default_value = Value(overflow);
    return {
        field<&Widget::style, &Style::font>(
            widgets, {.name = "font",
                      .doc = "sans, bold, mono, or a font file (TTF, OTF) in the game's "
                             "folder; empty: that of the theme."}),
        field<&Widget::style, &Style::font_size>(
            widgets, {.name = "font_size",
                      .unit = "px",
                      .range = {1, 1000},
                      .doc = "Size of its text; nil: that of the theme."}),
        field<&Widget::style, &Style::text_color>(
            widgets, {.name = "text_color", .doc = "Color of its text; nil: that of the theme."}),
        std::move(align_property),
        std::move(overflow_property),
    };
}

Property text_property(Widgets& widgets, const char* doc) {
    return field<&Widget::content, &Content::text>(widgets, {.name = "text", .doc = doc});
}

Property bind_property(Widgets& widgets, const char* doc) {
    return field<&Widget::content, &Content::bind>(widgets, {.name = "bind", .doc = doc});
}

Property min_property(Widgets& widgets) {
    return field<&Widget::content, &Content::min>(
        widgets, {.name = "min",
                  .range = {-1e12, 1e12},
                  .doc = "The value at the left end. nil: the least one of the bound property, "
                         "else 0."});
}

Property max_property(Widgets& widgets) {
    return field<&Widget::content, &Content::max>(
        widgets, {.name = "max",
                  .range = {-1e12, 1e12},
                  .doc = "The value at the right end; it may be less than min, and then values "
                         "decrease to the right. nil: the greatest one of the bound property, "
                         "else 1, but min at least."});
}

}  // namespace fettle::interface
