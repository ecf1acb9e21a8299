#include <themes/fields.h>
#include <widgets/classes.h>
#include <widgets/groups.h>

namespace fettle::interface {

using property::Property;
using property::Value;

namespace {

Property with_default(const char* name, const Value& default_value) {
    return {.name = name, .type = default_value.type(), .default_value = default_value};
}

property::Event cancelled() {
    return {.name = "cancelled",
            .doc = "It is modal, and the player pressed escape, or B on the gamepad."};
}

property::ClassDescriptor list_descriptor(Widgets& widgets) {
    return {.name = "List",
            .base = "Widget",
            .doc =
                "Lines of text to choose from, or widgets below each other; it scrolls if there is "
                "no room for all.",
            .properties = joined(
                container_properties(widgets),
                Properties{
                    field<&Widget::placing, &Placing::spacing>(
                        widgets, {.name = "spacing",
                                  .unit = "px",
                                  .range = {0, 100'000},
                                  .doc = "Distance between its widgets; nil: that of the theme."}),
                    field<&Widget::content, &Content::items>(
                        widgets, {.name = "items",
                                  .doc = "Its lines. If there are none, it shows the "
                                         "widgets below it.",
                                  .element = property::Type::text}),
                    field<&Widget::content, &Content::selected>(
                        widgets, {.name = "selected",
                                  .range = {0, 1e9},
                                  .doc = "Number of the chosen line, from 1; 0, or more than there "
                                         "are: none."}),
                    field<&Widget::content, &Content::scroll>(
                        widgets, {.name = "scroll",
                                  .unit = "px",
                                  .range = {0, 1e9},
                                  .doc = "How far down it is scrolled."}),
                    field<&Widget::focusable>(
                        widgets, {.name = "focusable", .doc = "Whether it can have the keyboard."}),
                    bind_property(widgets,
                                  "Path of a property that is the chosen line: a text, or its "
                                  "number. Without items, its lines are the values that the "
                                  "property can have.")},
                text_properties(widgets, "left", "cut")),
            .events = {
                cancelled(),
                {.name = "changed",
                 .fields = {{.name = "selected",
                             .type = property::Type::integer,
                             .doc = "Number of the line."}},
                 .doc = "The player has chosen another line."},
                {.name = "submitted",
                 .fields = {{.name = "selected",
                             .type = property::Type::integer,
                             .doc = "Number of the line."}},
                 .doc = "The player has pressed Enter on a line, or clicked on the chosen one."}}};
}

}  // namespace

std::vector<property::ClassDescriptor> container_classes(Widgets& widgets) {
    std::vector<property::ClassDescriptor> all;
    all.push_back(
        {.name = "Panel",
         .base = "Widget",
         .doc = "A box with a background. Each of its widgets is at its own anchor, so it "
                "mostly holds one column or row.",
         .properties = joined({with_default("anchor", "center")}, container_properties(widgets)),
         .events = {cancelled()}});
    all.push_back({.name = "Row",
                   .base = "Widget",
                   .doc = "Widgets side by side.",
                   .properties = joined(container_properties(widgets), line_up_properties(widgets)),
                   .events = {cancelled()}});
    for (Property& each : all.back().properties)
        if (each.name == "align") each.default_value = Value("center");
    all.push_back(
        {.name = "Column",
         .base = "Widget",
         .doc = "Widgets below each other, or in a grid with several columns.",
         .properties = joined(
             container_properties(widgets),
             joined(line_up_properties(widgets),
                    Properties{field<&Widget::placing, &Placing::columns>(
                        widgets,
                        {.name = "columns",
                         .range = {1, 1000},
                         .doc = "How many widgets are side by side: with 4, the first four widgets "
                                "are the first row of a grid. All columns are as wide as the "
                                "widest, unless a widget grows: then each is as wide as its "
                                "widest widget, and those with widgets that grow share what is "
                                "left."})})),
         .events = {cancelled()}});
    all.push_back(list_descriptor(widgets));
    return all;
}

}  // namespace fettle::interface
