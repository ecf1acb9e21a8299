#include <lines/lines.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include <fettle/property/between_steps.h>
#include <fettle/property/pose.h>
#include <fettle/property/thick_line.h>
#include <lines/dashes.h>
#include <properties/properties.h>

namespace fettle::visuals {

using property::Handle;
using property::LinePiece;
using property::Painter;
using property::Property;
using property::Type;
using property::Vec2;

namespace {

std::vector<Property> line_properties() {
    return {
        {.name = "points",
         .type = Type::list,
         .unit = "m",
         .doc = "Its corners, relative to its position; pixels in a layer on the screen.",
         .element = Type::vec2},
        position_property("Where its point (0, 0) is, relative to its parent."),
        angle_property(),
        {.name = "width",
         .type = Type::number,
         .default_value = 0.05,
         .unit = "m",
         .range = {0, 1e6},
         .doc = "Thickness; never less than a pixel. Pixels in a layer on the screen."},
        {.name = "color",
         .type = Type::color,
         .default_value = property::Color{1, 1, 1, 1},
         .range = {0, 1},
         .doc = "Its color."},
        {.name = "closed",
         .type = Type::boolean,
         .doc = "Whether the last point is connected with the first."},
        {.name = "dashed",
         .type = Type::number,
         .unit = "m",
         .range = {0, 1e6},
         .doc = "Length of dashes with their round ends, and of the gaps between them; 0: no gaps. "
                "Pixels in a layer on the screen."},
        blend_property(),
        visible_property(),
    };
}

/// The highest bit distinguishes the number of the figure from numbers of bodies.
std::uint64_t figure_of(Handle self) {
    return std::uint64_t{1} << 63 | std::uint64_t{self.generation} << 32 | self.index;
}

}  // namespace

void Lines::define(property::Tree& tree) {
    property::ClassDescriptor described{
        .name = "Line",
        .doc = "A line through several points, with round corners and ends.",
        .properties = line_properties()};
    described.lifecycle.context = this;
    described.lifecycle.draw = [](void* context, const property::Tree& in, Handle self,
                                  property::Row, Painter& painter, double alpha) {
        static_cast<const Lines*>(context)->draw(in, self, painter, alpha);
    };
    const property::Class& made = tree.define(std::move(described));
    const auto of = [&](const char* name) { return made.property(name); };
    of_ = {of("points"), of("width"), of("color"),  of("closed"),
           of("dashed"), of("blend"), of("visible")};
}

void Lines::draw(const property::Tree& tree, Handle self, Painter& painter, double alpha) const {
    const Reader read(tree, self);
    if (!read.flag(of_.visible)) return;
    const bool screen = painter.on_screen();
    std::vector<Vec2> points;
    const property::Value list = property::drawn_points(tree, self, *of_.points, screen, alpha);
    for (const property::Value& point : list.list()) points.push_back(point.vec2());
    if (points.size() < 2) return;
    if (read.flag(of_.closed)) points.push_back(points.front());
    painter.push(property::place_below(tree, self, screen, alpha).value_or(property::Transform()));
    const property::Blend blend = blend_of(read.in_place(of_.blend));
    if (blend != property::Blend::normal) painter.blend(blend);
    const double width = read.number(of_.width), pixels = width * painter.pixels_per_unit();
    const double round = pixels < property::thinnest_round_line ? 0 : width;
    property::Color color = read.color(of_.color);
    std::optional<std::vector<LinePiece>> pieces;
    if (const double dash = read.number(of_.dashed); dash > 0) {
        pieces = dashes(painter, points, dash, round);
        if (!pieces) color.a *= 0.5f;  // the mean of dashes and gaps
    }
    if (!pieces) {
        pieces.emplace();
        for (std::size_t i = 0; i + 1 < points.size(); ++i)
            pieces->push_back({points[i], points[i + 1], 0.5 * width});
    }
    property::draw_thick_line(painter, figure_of(self), *pieces, std::max(1.0, pixels), color);
    painter.pop();
}

}  // namespace fettle::visuals
