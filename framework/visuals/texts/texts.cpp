#include <texts/texts.h>

#include <fettle/property/pose.h>
#include <letters/writing.h>
#include <properties/properties.h>

namespace fettle::visuals {

using property::accessor;
using property::Color;
using property::Painter;
using property::Property;
using property::Type;
using property::Value;
using property::Vec2;

namespace {

Align align_of(const Value& name) {
    return name.text() == "left"    ? Align::left
           : name.text() == "right" ? Align::right
                                    : Align::center;
}

}  // namespace

std::vector<Property> Texts::properties() {
    const auto derived = [](Property property) {
        property.read_only = property.transient = true;
        property.derives_from = {"text", "font", "size", "wrap"};
        return property;
    };
    return {
        {.name = "text",
         .type = Type::text,
         .doc = "What is written; it may have several lines. What follows the first 100 000 "
                "letters is "
                "not shown."},
        {.name = "font",
         .type = Type::text,
         .default_value = "sans",
         .doc = "sans, bold, mono, or a font file (TTF, OTF) in the game's folder. Letters that it "
                "lacks are taken from sans, then from other fonts of the system."},
        {.name = "size",
         .type = Type::number,
         .default_value = 0.5,
         .unit = "m",
         .range = {0, 1e6},
         .doc = "Size of the font; a line is 1.2 times as high. Pixels in a layer on the screen."},
        {.name = "align",
         .type = Type::text,
         .default_value = "center",
         .doc = "Where lines begin that are shorter than the longest.",
         .enumerators = {"left", "center", "right"}},
        {.name = "anchor",
         .type = Type::vec2,
         .default_value = Vec2(0.5, 0.5),
         .range = {-1e6, 1e6},
         .doc = "The point of the text that is at its position: (0, 0) is the bottom left corner, "
                "(1, 1) the top right one."},
        {.name = "wrap",
         .type = Type::number,
         .unit = "m",
         .range = {0, 1e9},
         .doc =
             "Longest line; words beyond it begin another line, and a word that is longer has one "
             "of its own. Chinese, Japanese and Korean are divided between characters. 0: no "
             "limit. Pixels in a layer on the screen."},
        {.name = "color",
         .type = Type::color,
         .default_value = Color{1, 1, 1, 1},
         .range = {0, 1},
         .doc = "Color of the letters."},
        {.name = "outline",
         .type = Type::color,
         .default_value = Color{0, 0, 0, 0},
         .range = {0, 1},
         .doc = "Color around the letters; transparent: none."},
        {.name = "outline_width",
         .type = Type::number,
         .default_value = 0.06,
         .range = {0, 1},
         .doc = "Width of the outline as a part of the size."},
        position_property("Where its anchor is, relative to its parent; pixels in a layer "
                          "on the screen."),
        angle_property(),
        blend_property(),
        visible_property(),
        derived({.name = "text_width",
                 .type = Type::number,
                 .unit = "m",
                 .doc = "Width of the longest line.",
                 .binding = accessor(*this,
                                     [](Texts& t, property::Row row) {
                                         Row& r = t.rows_[row];
                                         return t.layout(r).width * t.size_of(r);
                                     })}),
        derived({.name = "text_height",
                 .type = Type::number,
                 .unit = "m",
                 .doc = "Height of all lines.",
                 .binding = accessor(*this,
                                     [](Texts& t, property::Row row) {
                                         Row& r = t.rows_[row];
                                         return t.layout(r).height * t.size_of(r);
                                     })}),
    };
}

void Texts::define(property::Tree& tree) {
    tree_ = &tree;
    property::ClassDescriptor described{
        .name = "Text",
        .doc =
            "Written text in the world or, in a layer, on the screen. Its parent moves it, as that "
            "of a Sprite does.",
        .properties = properties(),
        .weight = 600};
    described.lifecycle = lifecycle_with_rows<&Texts::rows_, &Texts::draw>(*this);
    const property::Class& made = tree.define(std::move(described));
    const auto of = [&](const char* name) { return made.property(name); };
    of_ = {of("text"),  of("font"),    of("size"),          of("align"), of("anchor"), of("wrap"),
           of("color"), of("outline"), of("outline_width"), of("blend"), of("visible")};
}

double Texts::size_of(const Row& row) const {
    return Reader(*tree_, row.self).number(of_.size);
}

void Texts::clear_layouts() {
    for (Row& row : rows_) row.wrap = -1;
}

void Texts::step() {
    for (Row& row : rows_) {
        if (!row.self) continue;
        const Value font = Reader(*tree_, row.self).value(of_.font);
        if (font == row.loaded_font) continue;
        row.loaded_font = font;
        (void)fonts_.get([this, &row] { return tree_->path(row.self, *of_.font); }, font.text());
    }
}

const Layout& Texts::layout(Row& row) {
    const Reader read(*tree_, row.self);
    const double size = read.number(of_.size);
    const double wrap = size > 0 ? read.number(of_.wrap) / size : 0;
    const Value text = read.value(of_.text), font = read.value(of_.font),
                align = read.value(of_.align);
    if (text == row.text && font == row.font && align == row.align && wrap == row.wrap)
        return row.layout;
    row.text = text;
    row.font = font;
    row.align = align;
    row.wrap = wrap;
    const auto user = [this, &row] { return tree_->path(row.self, *of_.font); };
    row.layout = Layout::of(text.text(), fonts_.get(user, font.text()), align_of(align), wrap);
    return row.layout;
}

void Texts::draw(Row& row, Painter& painter, double alpha) {
    const Reader read(*tree_, row.self);
    if (!read.flag(of_.visible)) return;
    const Layout& placed = layout(row);
    if (placed.glyphs.empty()) return;
    const bool screen = painter.on_screen();
    painter.push(
        property::place_below(*tree_, row.self, screen, alpha).value_or(property::Transform()));
    const property::Blend blend = blend_of(read.in_place(of_.blend));
    if (blend != property::Blend::normal) painter.blend(blend);
    const double size = read.number(of_.size);
    const Vec2 anchor = read.vec2(of_.anchor);
    const Vec2 corner = Vec2(-anchor.x * placed.width, -(1 - anchor.y) * placed.height) * size;
    const Color outline = read.color(of_.outline);
    const double width = read.number(of_.outline_width);
    if (outline.a > 0 && width > 0) draw_letters(painter, placed, size, corner, outline, width);
    draw_letters(painter, placed, size, corner, read.color(of_.color));
    painter.pop();
}

}  // namespace fettle::visuals
