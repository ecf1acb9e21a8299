#pragma once
// A painter that draws like another one, but everything in one color.

#include <string_view>

#include <fettle/property/painter.h>

namespace fettle::app {

class TintPainter : public property::Painter {
  public:
    /// Fills get this color with its opacity, borders and lines without.
    TintPainter(property::Painter& inner, property::Color color) : inner_(inner), fill_(color) {
        line_ = {color.r, color.g, color.b, 1};
    }
    void push(const property::Transform& transform) override {
        Painter::push(transform);
        inner_.push(transform);
    }
    void pop() override {
        if (pushed() == 0) return;
        Painter::pop();
        inner_.pop();
    }
    void clip(const property::Vec2& lower, const property::Vec2& upper) override {
        inner_.clip(lower, upper);
    }
    property::Seen seen() const override { return inner_.seen(); }
    double pixels_per_unit() const override { return inner_.pixels_per_unit(); }
    void picture(const property::Picture& picture, const property::PictureArea& area,
                 const property::Vec2& lower, const property::Vec2& upper, property::Color,
                 bool smooth) override {
        inner_.picture(picture, area, lower, upper, line_, smooth);
    }
    void circle(const property::Vec2& center, double radius,
                const property::Paint& paint) override {
        inner_.circle(center, radius, tinted(paint));
    }
    void ellipse(const property::Vec2& center, const property::Vec2& radii, double angle,
                 const property::Paint& paint) override {
        inner_.ellipse(center, radii, angle, tinted(paint));
    }
    void polygon(std::span<const property::Vec2> vertices, double rounding,
                 const property::Paint& paint) override {
        inner_.polygon(vertices, rounding, tinted(paint));
    }
    void line(const property::Vec2& from, const property::Vec2& to, property::Color,
              float width) override {
        inner_.line(from, to, line_, width);
    }
    void point(const property::Vec2& position, property::Color, float size) override {
        inner_.point(position, line_, size);
    }
    void text(const property::Vec2& position, std::string_view text, double height, property::Color,
              property::TextAlign align) override {
        inner_.text(position, text, height, line_, align);
    }
    void part_of(std::uint64_t whole) override { inner_.part_of(whole); }
    bool shows(property::Overlay) const override { return false; }
    bool sees(const property::Vec2& lower, const property::Vec2& upper) const override {
        return inner_.sees(lower, upper);
    }
    void begin_screen() override {
        push_screen();
        inner_.begin_screen();
    }
    void end_screen() override {
        Painter::pop();
        inner_.end_screen();
    }

  private:
    property::Paint tinted(const property::Paint& paint) const {
        return {.fill = fill_, .border = line_, .border_width = paint.border_width};
    }

    property::Painter& inner_;
    property::Color fill_, line_;
};

}  // namespace fettle::app
