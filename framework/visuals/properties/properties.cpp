#include <properties/properties.h>

#include <string_view>

namespace fettle::visuals {

using property::Property;
using property::Type;

Property position_property(const char* doc) {
    return {.name = "position", .type = Type::vec2, .unit = "m", .range = {-1e9, 1e9}, .doc = doc};
}

Property angle_property() {
    return {.name = "angle",
            .type = Type::number,
            .unit = "rad",
            .range = {-1e6, 1e6},
            .doc = "Counter-clockwise, relative to its parent."};
}

Property visible_property() {
    return {.name = "visible",
            .type = Type::boolean,
            .default_value = true,
            .doc = "Whether it is drawn."};
}

Property blend_property() {
    return {.name = "blend",
            .type = Type::text,
            .default_value = "normal",
            .doc =
                "How its colors are put on what is there: normal covers it, add makes it "
                "lighter, multiply makes it darker.",
            .enumerators = {"normal", "add", "multiply"}};
}

property::Blend blend_of(const property::Value& name) {
    const std::string_view text = name.text();
    if (text == "add") return property::Blend::add;
    if (text == "multiply") return property::Blend::multiply;
    return property::Blend::normal;
}

}  // namespace fettle::visuals
