#include <themes/themes.h>

#include <themes/fields.h>

namespace fettle::interface {

using property::Handle;

void Themes::define(property::Tree& tree) {
    constexpr property::Range pixels{0, 1000};
    property::ClassDescriptor described{
        .name = "Theme",
        .doc =
            "Colors, font and distances of widgets. A widget has that of its property `theme`, "
            "else that of the widget above it, else interface.theme.",
        .properties = {
            field<&Theme::panel>(*this, {.name = "panel", .doc = "Background of panels."}),
            field<&Theme::control>(
                *this, {.name = "control", .doc = "Buttons, and the tracks of sliders."}),
            field<&Theme::field>(*this,
                                 {.name = "field", .doc = "Background of text fields and lists."}),
            field<&Theme::accent>(
                *this, {.name = "accent",
                        .doc = "What is chosen or switched on, and the most important button."}),
            field<&Theme::text>(*this, {.name = "text", .doc = "Text."}),
            field<&Theme::muted>(
                *this, {.name = "muted", .doc = "Text of less importance, such as a placeholder."}),
            field<&Theme::on_accent>(*this,
                                     {.name = "on_accent", .doc = "Text on the color `accent`."}),
            field<&Theme::border>(*this,
                                  {.name = "border", .doc = "Line around panels and fields."}),
            field<&Theme::focus>(
                *this, {.name = "focus", .doc = "Ring around the widget that has the keyboard."}),
            field<&Theme::shade>(*this,
                                 {.name = "shade", .doc = "Covers what is behind a modal widget."}),
            field<&Theme::font>(
                *this,
                {.name = "font",
                 .doc = "sans, bold, mono, or a font file (TTF, OTF) in the game's folder."}),
            field<&Theme::font_size>(
                *this,
                {.name = "font_size", .unit = "px", .range = {1, 1000}, .doc = "Size of texts."}),
            field<&Theme::radius>(
                *this,
                {.name = "radius", .unit = "px", .range = pixels, .doc = "Radius of corners."}),
            field<&Theme::padding>(
                *this, {.name = "padding",
                        .unit = "px",
                        .range = pixels,
                        .doc = "Distance between the edge of a panel and what is in it."}),
            field<&Theme::spacing>(
                *this, {.name = "spacing",
                        .unit = "px",
                        .range = pixels,
                        .doc = "Distance between the widgets of a row, a column or a list."}),
        }};
    described.lifecycle.context = this;
    described.lifecycle.create = [](void* context, property::Tree&, Handle self) {
        return static_cast<Themes*>(context)->rows_.add(self);
    };
    described.lifecycle.destroy = [](void* context, property::Tree&, Handle, property::Row row) {
        auto& themes = *static_cast<Themes*>(context);
        themes.rows_.remove(row);
        themes.changed(row);
    };
    class_ = &tree.define(std::move(described));
}

}  // namespace fettle::interface
