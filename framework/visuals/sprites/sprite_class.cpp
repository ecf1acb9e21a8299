// The properties of Sprite.

#include <stdexcept>

#include <properties/properties.h>
#include <sprites/sprites.h>

namespace fettle::visuals {

using property::accessor;
using property::Property;
using property::Type;
using property::Value;

std::vector<Property> Sprites::picture_properties() {
    return {
        {.name = "image",
         .type = Type::text,
         .doc = "An image file in the game's folder (PNG, JPEG, BMP, TGA), or a JSON file that "
                "Aseprite exported. A checkerboard is drawn for a file that is missing."},
        position_property("Where its origin is, relative to its parent; pixels in a layer "
                          "on the screen."),
        angle_property(),
        {.name = "size",
         .type = Type::vec2,
         .unit = "m",
         .range = {0, 1e9},
         .doc = "Width and height; nil: those of the image, by pixels_per_unit. Pixels in a layer "
                "on the screen.",
         .nullable = true},
        {.name = "scale",
         .type = Type::number,
         .default_value = 1.0,
         .range = {-1e6, 1e6},
         .doc = "Enlarges it, and what is below it."},
        {.name = "pixels_per_unit",
         .type = Type::number,
         .default_value = 32.0,
         .unit = "px/m",
         .range = {1e-3, 1e6},
         .doc = "Pixels of the image in a meter, where `size` is nil. In a layer on the screen a "
                "pixel of the image is a pixel."},
        {.name = "origin",
         .type = Type::vec2,
         .default_value = property::Vec2(0.5, 0.5),
         .range = {-1e6, 1e6},
         .doc = "The point of the image that is at its position, around which it turns: (0, 0) is "
                "the bottom left corner, (1, 1) the top right one."},
        {.name = "flip_x", .type = Type::boolean, .doc = "Mirrors the image, left and right."},
        {.name = "flip_y", .type = Type::boolean, .doc = "Mirrors the image, top and bottom."},
    };
}

std::vector<Property> Sprites::look_properties() {
    return {
        {.name = "tint",
         .type = Type::color,
         .default_value = property::Color{1, 1, 1, 1},
         .range = {0, 1},
         .doc = "The colors of the image are multiplied by it."},
        blend_property(),
        visible_property(),
        {.name = "smooth",
         .type = Type::boolean,
         .default_value = images_.smooth.value_or(true),
         .doc = "Whether pixels are mixed when the image is enlarged; otherwise each is a square."},
    };
}

std::vector<Property> Sprites::frame_properties() {
    // A write begins the animation again. The hook only writes this class's own memory.
    const auto restarts = [this](Property property) {
        property.binding.context = this;
        property.binding.invalidate = [](void* context, property::Row row) {
            Row& r = static_cast<Sprites*>(context)->rows_[row];
            r.frame = 0;
            r.elapsed = 0;
        };
        return property;
    };
    return {
        {.name = "columns",
         .type = Type::integer,
         .default_value = 1,
         .range = {1, 10'000},
         .doc = "Number of frames beside each other in the image."},
        {.name = "rows",
         .type = Type::integer,
         .default_value = 1,
         .range = {1, 10'000},
         .doc = "Number of rows of frames in the image."},
        {.name = "frame_size",
         .type = Type::vec2,
         .unit = "px",
         .range = {1, 100'000},
         .doc = "Width and height of a frame. nil: those of the image, divided by columns and "
                "rows; otherwise there are as many frames as the image has room for, and columns "
                "and rows do not matter.",
         .nullable = true},
        {.name = "margin",
         .type = Type::number,
         .default_value = 0.0,
         .unit = "px",
         .range = {0, 100'000},
         .doc = "Distance of the frames from the edges of the image."},
        {.name = "spacing",
         .type = Type::number,
         .default_value = 0.0,
         .unit = "px",
         .range = {0, 100'000},
         .doc = "Distance of two frames in the image."},
        // After columns and rows in the order of names, so a constructor may give any of them.
        {.name = "sheet",
         .type = Type::list,
         .default_value = property::List{Value(1), Value(1)},
         .range = {1, 10'000},
         .doc = "Columns and rows in one value: { columns, rows }. The sheet that Aseprite "
                "exported is given by its JSON file as `image`.",
         .binding = accessor(
             *this,
             [](Sprites& s, property::Row row) {
                 const Reader read(*s.tree_, s.rows_[row].self);
                 return Value(property::List{read.value(s.of_.columns), read.value(s.of_.rows)});
             },
             [](Sprites& s, property::Row row, const Value& value) {
                 const property::List& sheet = value.list();
                 if (sheet.size() != 2)
                     throw std::invalid_argument("expected two numbers: { columns, rows }");
                 s.tree_->set(s.rows_[row].self, *s.of_.columns, sheet[0]);
                 s.tree_->set(s.rows_[row].self, *s.of_.rows, sheet[1]);
             }),
         .transient = true,
         .element = Type::integer,
         .derives_from = {"columns", "rows"}},
        restarts({.name = "animation",
                  .type = Type::text,
                  .doc = "The frames that are played: a tag of an Aseprite file, or the first and "
                         "the last frame, such as \"3-6\". Empty: all frames."}),
        {.name = "frame",
         .type = Type::integer,
         .default_value = 1,
         .range = {1, 1e6},
         .doc = "The frame that is shown, from 1, within the animation. Beyond the last one, "
                "counting begins again at the first.",
         .binding = accessor(
             *this, [](Sprites& s, property::Row row) { return Value(s.rows_[row].frame + 1); },
             [](Sprites& s, property::Row row, const Value& value) {
                 Row& r = s.rows_[row];
                 r.frame = value.integer() - 1;
                 r.elapsed = 0;
             }),
         .simulated = true},
        {.name = "frame_time",
         .type = Type::number,
         .unit = "s",
         .range = {0, 1e6},
         .doc = "Time since the frame began.",
         .binding = accessor(
             *this, [](Sprites& s, property::Row row) { return s.rows_[row].elapsed; },
             [](Sprites& s, property::Row row, const Value& value) {
                 s.rows_[row].elapsed = value.number();
             }),
         .simulated = true,
         .hidden = true},
        {.name = "frames_per_second",
         .type = Type::number,
         .unit = "1/s",
         .range = {0, 1000},
         .doc = "Speed of the animation. 0: the times in the Aseprite file, or no motion."},
        {.name = "loop",
         .type = Type::boolean,
         .default_value = true,
         .doc = "Whether the animation begins again at its end."},
        {.name = "playing",
         .type = Type::boolean,
         .default_value = true,
         .doc = "Whether the animation goes on. At its end without `loop` it stays at the last "
                "frame until `animation` changes; `frame` = 1 plays it again."},
    };
}

std::vector<Property> Sprites::derived_properties() {
    const auto derived = [](Property property, std::vector<std::string> sources) {
        property.read_only = property.transient = true;
        property.derives_from = std::move(sources);
        return property;
    };
    return {
        derived({.name = "image_width",
                 .type = Type::integer,
                 .unit = "px",
                 .doc = "Width of the image file, or of the checkerboard.",
                 .binding = accessor(*this,
                                     [](Sprites& s, property::Row row) {
                                         Row& r = s.rows_[row];
                                         const Sheet* sheet = s.sheet(r, Reader(*s.tree_, r.self));
                                         return Value(std::int64_t{
                                             sheet == nullptr ? 0 : sheet->picture.width()});
                                     })},
                {"image"}),
        derived({.name = "image_height",
                 .type = Type::integer,
                 .unit = "px",
                 .doc = "Height of the image file, or of the checkerboard.",
                 .binding = accessor(*this,
                                     [](Sprites& s, property::Row row) {
                                         Row& r = s.rows_[row];
                                         const Sheet* sheet = s.sheet(r, Reader(*s.tree_, r.self));
                                         return Value(std::int64_t{
                                             sheet == nullptr ? 0 : sheet->picture.height()});
                                     })},
                {"image"}),
        derived({.name = "frame_count",
                 .type = Type::integer,
                 .doc = "Number of frames of the animation.",
                 .binding = accessor(*this,
                                     [](Sprites& s, property::Row row) {
                                         Row& r = s.rows_[row];
                                         const Reader read(*s.tree_, r.self);
                                         const Sheet* sheet = s.sheet(r, read);
                                         return Value(sheet == nullptr
                                                          ? std::int64_t{0}
                                                          : s.playing(r, *sheet, read).count);
                                     })},
                {"image", "columns", "rows", "animation", "frame_size", "margin", "spacing"}),
    };
}

void Sprites::define(property::Tree& tree) {
    tree_ = &tree;
    property::ClassDescriptor described{
        .name = "Sprite",
        .doc =
            "A picture in the world or, in a layer, on the screen. Its parent moves it: a body, "
            "another sprite, or any instance with a `position`.",
        .weight = 200};
    for (const auto& group :
         {picture_properties(), look_properties(), frame_properties(), derived_properties()})
        described.properties.insert(described.properties.end(), group.begin(), group.end());
    described.events = {
        {.name = "finished", .doc = "The animation came to its end; only without `loop`."}};
    described.lifecycle = lifecycle_with_rows<&Sprites::rows_, &Sprites::draw>(*this);
    const property::Class& made = tree.define(std::move(described));
    const auto of = [&](const char* name) { return made.property(name); };
    of_ = {of("image"),      of("size"),
           of("origin"),     of("flip_x"),
           of("flip_y"),     of("tint"),
           of("columns"),    of("rows"),
           of("animation"),  of("frames_per_second"),
           of("loop"),       of("playing"),
           of("blend"),      of("visible"),
           of("smooth"),     of("pixels_per_unit"),
           of("frame_size"), of("margin"),
           of("spacing")};
    finished_ = made.event("finished");
}

}  // namespace fettle::visuals
