#include <lines/lines.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <fettle/property/pose.h>
#include <properties/properties.h>

namespace fettle::visuals {

using property::Handle;
using property::Painter;
using property::Property;
using property::Type;
using property::Vec2;

namespace {

constexpr std::size_t most_dashes = 20'000;

using Segments = std::vector<std::array<Vec2, 2>>;

/// Cuts the line into dashes with gaps of the same length. A dash may go around a corner.
Segments dashes(const std::vector<Vec2>& points, double length) {
    Segments cut;
    bool on = true;
    double left = length;  // of the current dash or gap
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        Vec2 at = points[i];
        double rest = (points[i + 1] - at).length();
        if (rest <= 0) continue;
        const Vec2 along = (points[i + 1] - at) / rest;
        while (rest > 0 && cut.size() < most_dashes) {
            const double part = std::min(left, rest);
            const Vec2 to = at + part * along;
            if (on) cut.push_back({at, to});
            at = to;
            rest -= part;
            left -= part;
            if (left > 0) continue;
            on = !on;
            left = length;
        }
    }
    return cut;
}

std::vector<Property> line_properties() {
    return {
        {.name = "points",
         .type = Type::list,
         .unit = "m",
         .doc = "Its corners, relative to its position; pixels in a layer on the screen.",
         .element = Type::vec2},
        position_property("Where its point (0, 0) is, relative to what it hangs below."),
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
         .doc = "Length of dashes, and of the gaps between them; 0: no gaps. Pixels in a layer on "
                "the screen."},
        blend_property(),
        visible_property(),
    };
}

void draw_segments(Painter& painter, Handle self, const Segments& segments, double width,
                   property::Color color) {
    const double pixels = width * painter.pixels_per_unit();
    if (pixels < 2) {
        for (const auto& [from, to] : segments)
            painter.line(from, to, color, static_cast<float>(std::max(1.0, pixels)));
        return;
    }
    // All segments are parts of one figure: where they overlap, a translucent color is drawn once.
    // The highest bit distinguishes the number of the figure from numbers of bodies.
    const std::uint64_t whole =
        std::uint64_t{1} << 63 | std::uint64_t{self.generation} << 32 | self.index;
    painter.part_of(whole);
    for (const auto& segment : segments)
        painter.polygon(segment, 0.5 * width, {.fill = color, .border = {0, 0, 0, 0}});
    painter.part_of(0);
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
    of_ = {of("points"),   of("width"), of("color"), of("closed"), of("dashed"),
           of("position"), of("angle"), of("blend"), of("visible")};
}

void Lines::draw(const property::Tree& tree, Handle self, Painter& painter, double alpha) const {
    const Reader read(tree, self);
    if (!read.flag(of_.visible)) return;
    std::vector<Vec2> points;
    const property::Value list = read.value(of_.points);
    for (const property::Value& point : list.list()) points.push_back(point.vec2());
    if (points.size() < 2) return;
    if (read.flag(of_.closed)) points.push_back(points.front());
    Segments segments;
    const double dash = read.number(of_.dashed);
    if (dash > 0)
        segments = dashes(points, dash);
    else
        for (std::size_t i = 0; i + 1 < points.size(); ++i)
            segments.push_back({points[i], points[i + 1]});
    const bool screen = painter.on_screen();
    painter.push(property::place_below(tree, tree.parent(self), screen, alpha)
                     .value_or(property::Transform()) *
                 property::local_pose(read.vec2(of_.position), read.number(of_.angle), 1, screen));
    const property::Blend blend = blend_of(read.in_place(of_.blend));
    if (blend != property::Blend::normal) painter.blend(blend);
    draw_segments(painter, self, segments, read.number(of_.width), read.color(of_.color));
    painter.pop();
}

}  // namespace fettle::visuals
