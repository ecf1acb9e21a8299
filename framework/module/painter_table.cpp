// The C table of a painter.

#include <vector>

#include <fettle/property/painter.h>

#include "host_table.h"

namespace fettle::module {
namespace {

using property::Color;
using property::Painter;
using property::Vec2;

Painter& painter_of(void* self) {
    return *static_cast<Painter*>(self);
}
Vec2 point(const double* xy) {
    return {xy[0], xy[1]};
}
Color color(const float* rgba) {
    return {rgba[0], rgba[1], rgba[2], rgba[3]};
}

}  // namespace

fettle_painter painter_table(Painter& painter) {
    fettle_painter table{};
    table.struct_size = sizeof table;
    table.self = &painter;
    table.circle = [](void* self, const double* center, double radius, const float* fill,
                      const float* border, float width) {
        painter_of(self).circle(point(center), radius, {color(fill), color(border), width});
    };
    table.polygon = [](void* self, const double* vertices, std::uint32_t count, double rounding,
                       const float* fill, const float* border, float width) {
        std::vector<Vec2> corners;
        for (std::uint32_t i = 0; i < count; ++i) corners.push_back(point(vertices + 2 * i));
        painter_of(self).polygon(corners, rounding, {color(fill), color(border), width});
    };
    table.line = [](void* self, const double* from, const double* to, const float* rgba,
                    float width) {
        painter_of(self).line(point(from), point(to), color(rgba), width);
    };
    table.point = [](void* self, const double* position, const float* rgba, float size) {
        painter_of(self).point(point(position), color(rgba), size);
    };
    table.text = [](void* self, const double* position, const char* text, std::uint32_t length,
                    double height, const float* rgba, std::uint32_t align) {
        painter_of(self).text(point(position), {text, length}, height, color(rgba),
                              static_cast<property::TextAlign>(align));
    };
    table.shows = [](void* self, std::uint32_t overlay) -> std::uint32_t {
        return painter_of(self).shows(static_cast<property::Overlay>(overlay)) ? 1 : 0;
    };
    table.sees = [](void* self, const double* lower, const double* upper) -> std::uint32_t {
        return painter_of(self).sees(point(lower), point(upper)) ? 1 : 0;
    };
    table.begin_screen = [](void* self) { painter_of(self).begin_screen(); };
    table.end_screen = [](void* self) { painter_of(self).end_screen(); };
    table.ellipse = [](void* self, const double* center, const double* radii, double angle,
                       const float* fill, const float* border, float width) {
        painter_of(self).ellipse(point(center), point(radii), angle,
                                 {color(fill), color(border), width});
    };
    table.part_of = [](void* self, std::uint64_t whole) { painter_of(self).part_of(whole); };
    return table;
}

}  // namespace fettle::module
