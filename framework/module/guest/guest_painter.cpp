// A painter that forwards drawing to the program.

#include "guest_tree.h"

namespace fettle::module {

using property::Color;
using property::Vec2;

// The base class counts what the module pushed; the program's painter has the transforms.
void GuestPainter::push(const property::Transform& transform) {
    const double matrix[] = {transform.x.x, transform.x.y,      transform.y.x,
                             transform.y.y, transform.origin.x, transform.origin.y};
    Painter::push(transform);
    table_.push(table_.self, matrix);
}

void GuestPainter::pop() {
    if (pushed() == 0) return;
    Painter::pop();
    table_.pop(table_.self);
}

void GuestPainter::picture(const property::Picture& picture, const property::PictureArea& area,
                           const Vec2& lower, const Vec2& upper, Color tint, bool smooth) {
    fettle_picture native{};
    native.struct_size = sizeof native;
    native.width = picture.width();
    native.height = picture.height();
    native.rgba = picture.rgba().data();
    native.owner = &picture;
    native.version = picture.version();
    const double part[] = {area.left, area.top, area.width, area.height};
    table_.picture(table_.self, &native, part, lower.data(), upper.data(), &tint.r, smooth ? 1 : 0);
}

void GuestPainter::circle(const Vec2& center, double radius, const property::Paint& paint) {
    table_.circle(table_.self, center.data(), radius, &paint.fill.r, &paint.border.r,
                  paint.border_width);
}

void GuestPainter::polygon(std::span<const Vec2> vertices, double rounding,
                           const property::Paint& paint) {
    std::vector<double> flat;
    flat.reserve(2 * vertices.size());
    for (const Vec2& v : vertices) flat.insert(flat.end(), {v.x, v.y});
    table_.polygon(table_.self, flat.data(), static_cast<std::uint32_t>(vertices.size()), rounding,
                   &paint.fill.r, &paint.border.r, paint.border_width);
}

void GuestPainter::ellipse(const Vec2& center, const Vec2& radii, double angle,
                           const property::Paint& paint) {
    table_.ellipse(table_.self, center.data(), radii.data(), angle, &paint.fill.r, &paint.border.r,
                   paint.border_width);
}

void GuestPainter::line(const Vec2& from, const Vec2& to, Color color, float width) {
    table_.line(table_.self, from.data(), to.data(), &color.r, width);
}

void GuestPainter::point(const Vec2& position, Color color, float size) {
    table_.point(table_.self, position.data(), &color.r, size);
}

void GuestPainter::text(const Vec2& position, std::string_view text, double height, Color color,
                        property::TextAlign align) {
    table_.text(table_.self, position.data(), text.data(), static_cast<std::uint32_t>(text.size()),
                height, &color.r, static_cast<std::uint32_t>(align));
}

bool GuestPainter::shows(property::Overlay overlay) const {
    return table_.shows(table_.self, static_cast<std::uint32_t>(overlay)) != 0;
}

bool GuestPainter::sees(const Vec2& lower, const Vec2& upper) const {
    return table_.sees(table_.self, lower.data(), upper.data()) != 0;
}

}  // namespace fettle::module
