#pragma once
// A painter that draws nothing.

#include <fettle/property/painter.h>

namespace fettle::property::testing {

struct NoPainter : Painter {
    void circle(const Vec2&, double, const Paint&) override {}
    void ellipse(const Vec2&, const Vec2&, double, const Paint&) override {}
    void polygon(std::span<const Vec2>, double, const Paint&) override {}
    void line(const Vec2&, const Vec2&, Color, float) override {}
    void point(const Vec2&, Color, float) override {}
    void text(const Vec2&, std::string_view, double, Color, TextAlign) override {}
    void part_of(std::uint64_t) override {}
    bool shows(Overlay) const override { return true; }
    bool sees(const Vec2&, const Vec2&) const override { return true; }
    void begin_screen() override {}
    void end_screen() override {}
};

}  // namespace fettle::property::testing
