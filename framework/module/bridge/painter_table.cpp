// The C table of a painter.

#include <memory>
#include <unordered_map>
#include <utility>
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

property::Transform transform(const double* matrix) {
    return {point(matrix), point(matrix + 2), point(matrix + 4)};
}

/// The program's copies of pictures of modules. A module may free a picture at any time, and the
/// painter of the program recognizes pictures by their address.
class Copies {
  public:
    const property::Picture& of(const fettle_picture& native) {
        if (copies_.size() > 1000) copies_.clear();  // those in use are copied again
        Copy& copy = copies_[native.owner];
        if (copy.picture == nullptr || copy.version != native.version) {
            const std::size_t bytes = std::size_t{native.width} * native.height * 4;
            std::vector<std::uint8_t> rgba(native.rgba, native.rgba + bytes);
            copy.picture =
                std::make_unique<property::Picture>(native.width, native.height, std::move(rgba));
            copy.version = native.version;
        }
        return *copy.picture;
    }

  private:
    struct Copy {
        std::unique_ptr<property::Picture> picture;
        std::uint64_t version = 0;
    };
    std::unordered_map<const void*, Copy> copies_;
};

void add_transforms(fettle_painter& table) {
    table.push = [](void* self, const double* matrix) { painter_of(self).push(transform(matrix)); };
    table.pop = [](void* self) { painter_of(self).pop(); };
    table.fade = [](void* self, float opacity) { painter_of(self).fade(opacity); };
    table.blend = [](void* self, std::uint32_t mode) {
        if (mode <= FETTLE_BLEND_MULTIPLY)
            painter_of(self).blend(static_cast<property::Blend>(mode));
    };
    table.clip = [](void* self, const double* lower, const double* upper) {
        painter_of(self).clip(point(lower), point(upper));
    };
    table.picture = [](void* self, const fettle_picture* picture, const double* area,
                       const double* lower, const double* upper, const float* tint,
                       std::uint32_t smooth) {
        thread_local Copies copies;
        if (picture == nullptr || picture->rgba == nullptr) return;
        painter_of(self).picture(copies.of(*picture), {area[0], area[1], area[2], area[3]},
                                 point(lower), point(upper), color(tint), smooth != 0);
    };
    table.pixels_per_unit = [](void* self) { return painter_of(self).pixels_per_unit(); };
    table.label_scale = [](void* self) { return painter_of(self).label_scale(); };
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
        corners.reserve(count);
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
    add_transforms(table);
    return table;
}

}  // namespace fettle::module
