#include <themes/fields.h>
#include <widgets/classes.h>
#include <widgets/groups.h>

namespace fettle::interface {

using property::Property;
using property::Type;

namespace {

property::Event changed(Type type) {
    return {
        .name = "changed",
        .fields = {{.name = "value", .type = type, .doc = "The new value."}},
        .doc =
            "The player has changed it. A change by a script is not an event: watch the property."};
}

Property focusable(Widgets& widgets) {
    return field<&Widget::focusable>(
        widgets, {.name = "focusable", .doc = "Whether it can have the keyboard."});
}

Property image_property(Widgets& widgets, const char* doc) {
    return field<&Widget::content, &Content::image>(widgets, {.name = "image", .doc = doc});
}

property::ClassDescriptor button(Widgets& widgets) {
    return {
        .name = "Button",
        .base = "Widget",
        .doc = "Something to press: with the mouse, Enter or Space, or A on the gamepad.",
        .properties = joined(
            {text_property(widgets, "What is written on it."),
             image_property(widgets, "A picture before its text: a file in the game's folder."),
             field<&Widget::style, &Style::look>(
                 widgets, {.name = "look",
                           .doc = "accent: it stands out. quiet: only its text is seen.",
                           .enumerators = {"normal", "accent", "quiet"}}),
             field<&Widget::style, &Style::color>(
                 widgets, {.name = "color", .doc = "Its background; nil: that of its look."}),
             field<&Widget::style, &Style::radius>(
                 widgets, {.name = "radius",
                           .unit = "px",
                           .range = {0, 100'000},
                           .doc = "Radius of its corners; nil: that of the theme."}),
             focusable(widgets),
             field<&Widget::content, &Content::listening>(
                 widgets,
                 {.name = "listening",
                  .doc = "Whether it waits for a key or button of any device. The event `captured` "
                         "reports the next one, which does nothing else; escape ends it."}),
             field<&Widget::content, &Content::prompt>(
                 widgets,
                 {.name = "prompt", .doc = "What is written on it while it is listening."}),
             bind_property(widgets,
                           "Path of the keys of an action, such as input.actions.jump: the button "
                           "shows them, and after a press the player chooses another one.")},
            text_properties(widgets, "center", "cut")),
        .events = {{.name = "pressed", .doc = "The player has pressed and released it."},
                   {.name = "captured",
                    .fields = {{.name = "name",
                                .type = Type::text,
                                .doc = "As in input.actions: \"space\", \"mouse.left\", "
                                       "\"gamepad.a\"."}},
                    .doc = "It was listening, and the player has pressed a key or button."}}};
}

property::ClassDescriptor slider(Widgets& widgets) {
    return {.name = "Slider",
            .base = "Widget",
            .doc = "A number to choose with the mouse, the arrow keys or the gamepad.",
            .properties =
                {field<&Widget::content, &Content::value>(
                     widgets, {.name = "value", .range = {-1e12, 1e12}, .doc = "The number."}),
                 min_property(widgets), max_property(widgets),
                 field<&Widget::content, &Content::step>(
                     widgets, {.name = "step",
                               .range = {0, 1e12},
                               .doc = "The player chooses multiples of it, counted from min; 0: "
                                      "any number. Integers have a step of 1 at least."}),
                 focusable(widgets),
                 field<&Widget::style, &Style::color>(
                     widgets, {.name = "color", .doc = "The part up to the value; nil: accent."}),
                 bind_property(widgets,
                               "Path of a property that is the number, such as "
                               "audio.volume; both always have the same value.")},
            .events = {changed(Type::number)}};
}

property::ClassDescriptor toggle(Widgets& widgets) {
    return {.name = "Toggle",
            .base = "Widget",
            .doc = "A switch with a text.",
            .properties =
                joined({text_property(widgets, "What is written beside it."),
                        field<&Widget::content, &Content::on>(
                            widgets, {.name = "value", .doc = "Whether it is on."}),
                        focusable(widgets),
                        field<&Widget::style, &Style::color>(
                            widgets, {.name = "color", .doc = "Its color if on; nil: accent."}),
                        bind_property(widgets,
                                      "Path of a boolean property; both always have the same "
                                      "value.")},
                       text_properties(widgets, "left", "cut")),
            .events = {changed(Type::boolean)}};
}

property::ClassDescriptor text_field(Widgets& widgets) {
    return {
        .name = "TextField",
        .base = "Widget",
        .doc =
            "A line of text to type. Shift with the arrow keys, Home and End, or dragging the "
            "mouse selects; ctrl with A selects everything, with C, X and V copies, cuts and "
            "pastes.",
        .properties = joined(
            {text_property(widgets, "What is in it."),
             field<&Widget::content, &Content::placeholder>(
                 widgets, {.name = "placeholder", .doc = "Shown while it is empty."}),
             field<&Widget::content, &Content::max_length>(
                 widgets, {.name = "max_length",
                           .range = {0, 1e6},
                           .doc = "Number of characters that can be typed; 0: no limit."}),
             field<&Widget::content, &Content::caret>(
                 widgets, {.name = "caret",
                           .range = {0, 1e9},
                           .doc = "Number of characters before the caret, the text cursor. It "
                                  "is one end of the selection."}),
             field<&Widget::content, &Content::mark>(
                 widgets, {.name = "mark",
                           .range = {0, 1e9},
                           .doc = "Number of characters before the other end of the selection; "
                                  "nil: nothing is selected. What the player types takes the "
                                  "place of the selection."}),
             focusable(widgets),
             bind_property(widgets,
                           "Path of a text or number; the player's typing sets it at once. Text "
                           "that is no number does not change a number, and is replaced by it "
                           "when the field loses the keyboard.")},
            text_properties(widgets, "left", "cut")),
        .events = {changed(Type::text),
                   {.name = "submitted",
                    .fields = {{.name = "text", .type = Type::text, .doc = "What is in it."}},
                    .doc = "The player has pressed Enter."}}};
}

property::ClassDescriptor progress_bar(Widgets& widgets) {
    return {
        .name = "ProgressBar",
        .base = "Widget",
        .doc = "A bar whose full part shows where its value is between min and max.",
        .properties = joined(
            {field<&Widget::content, &Content::value>(
                 widgets, {.name = "value", .range = {-1e12, 1e12}, .doc = "Between min and max."}),
             min_property(widgets), max_property(widgets), text_property(widgets, "Written on it."),
             field<&Widget::style, &Style::color>(
                 widgets, {.name = "color", .doc = "The full part; nil: accent."}),
             bind_property(widgets, "Path of a property that is the value.")},
            text_properties(widgets, "center", "cut"))};
}

}  // namespace

std::vector<property::ClassDescriptor> control_classes(Widgets& widgets) {
    std::vector<property::ClassDescriptor> all;
    all.push_back(button(widgets));
    all.push_back({.name = "Label",
                   .base = "Widget",
                   .doc = "A text.",
                   .properties = joined(
                       {text_property(widgets, "What is written; it may have several lines."),
                        bind_property(widgets, "Path of a property; the text is its value.")},
                       text_properties(widgets, "left", "wrap"))});
    all.push_back({.name = "Image",
                   .base = "Widget",
                   .doc = "A picture, as large as fits without being distorted.",
                   .properties = {
                       image_property(widgets, "A file in the game's folder."),
                       field<&Widget::style, &Style::tint>(
                           widgets, {.name = "tint", .doc = "Multiplies the picture's colors."})}});
    all.push_back(slider(widgets));
    all.push_back(toggle(widgets));
    all.push_back(text_field(widgets));
    all.push_back(progress_bar(widgets));
    return all;
}

const char* main_property(Kind kind) {
    switch (kind) {
        case Kind::slider:
        case Kind::progress_bar:
        case Kind::toggle:
            return "value";
        case Kind::button:
        case Kind::label:
        case Kind::text_field:
            return "text";
        case Kind::list:
            return "selected";
        default:
            return "";
    }
}

}  // namespace fettle::interface
