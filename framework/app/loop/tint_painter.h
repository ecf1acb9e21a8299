#pragma once
// A painter that draws like another one, but everything in one color.

#include <string_view>

#include <fettle/property/painter.h>

namespace fettle::app {

class TintPainter : public property::Painter {
  public:
    /// Fills get this color with its opacity, borders and lines without. Pictures keep their own
    /// opacity, and all keep how they blend: light that is added covers nothing.
    TintPainter(property::Painter& inner, property::Color color) : inner_(inner) { tint(color); }
    /// From now on it is this color.
    void tint(property::Color color) {
        tints_ = true;
        fill_ = color;
        line_ = {color.r, color.g, color.b, 1};
    }
    /// From now on everything keeps its own colors.
    void keep_colors() { tints_ = false; }
    void push(const property::Transform& transform) override {
        Painter::push(transform);
        inner_.push(transform);
    }
    void pop() override {
        if (pushed() == 0) return;
        Painter::pop();
        inner_.pop();
    }
    void fade(float opacity) override {
        Painter::fade(opacity);
        inner_.fade(opacity);
    }
    void blend(property::Blend mode) override {
        Painter::blend(mode);
        inner_.blend(mode);
    }
    void clip(const property::Vec2& lower, const property::Vec2& upper) override {
        inner_.clip(lower, upper);
    }
    void gradient(const property::Gradient& gradient) override {
        if (!tints_) inner_.gradient(gradient);
    }
    property::Seen seen() const override { return inner_.seen(); }
    double pixels_per_unit() const override { return inner_.pixels_per_unit(); }
    double label_scale() const override { return inner_.label_scale(); }
    void picture(const property::Picture& picture, const property::PictureArea& area,
                 const property::Vec2& lower, const property::Vec2& upper, property::Color tint,
                 bool smooth) override {
        inner_.picture(picture, area, lower, upper,
                       tinted(tint, {line_.r, line_.g, line_.b, tint.a}), smooth);
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
    void line(const property::Vec2& from, const property::Vec2& to, property::Color color,
              float width) override {
        inner_.line(from, to, tinted(color, line_), width);
    }
    void point(const property::Vec2& position, property::Color color, float size) override {
        inner_.point(position, tinted(color, line_), size);
    }
    void text(const property::Vec2& position, std::string_view text, double height,
              property::Color color, property::TextAlign align) override {
        inner_.text(position, text, height, tinted(color, line_), align);
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
        return tints_ ? property::Paint{.fill = fill_,
                                        .border = line_,
                                        .border_width = paint.border_width}
                      : paint;
    }
    property::Color tinted(property::Color own, property::Color with) const {
        return tints_ ? with : own;
    }

    property::Painter& inner_;
    bool tints_ = true;
    property::Color fill_, line_;
};

}  // namespace fettle::app
