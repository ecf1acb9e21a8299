#pragma once
// A painter that records what it is asked to draw.

#include <cstdint>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fettle/property/painter.h>

namespace fettle::physics_module::testing {

struct Figure {
    std::string kind;  // circle, ellipse, polygon, line, point, text
    std::vector<property::Vec2> points;
    double size = 0;  // radius, angle, rounding, width
    property::Paint paint{};
    std::string text{};
    std::uint64_t whole = 0;  // the figure that it is a part of
};

class Picture : public property::Painter {
  public:
    void circle(const property::Vec2& center, double radius, const property::Paint& p) override {
        add({"circle", {center}, radius, p});
    }
    void ellipse(const property::Vec2& center, const property::Vec2& radii, double angle,
                 const property::Paint& p) override {
        add({"ellipse", {center, radii}, angle, p});
    }
    void polygon(std::span<const property::Vec2> vertices, double rounding,
                 const property::Paint& p) override {
        add({"polygon", {vertices.begin(), vertices.end()}, rounding, p});
    }
    void line(const property::Vec2& from, const property::Vec2& to, property::Color color,
              float width) override {
        add({"line", {from, to}, width, {.fill = color}});
    }
    void point(const property::Vec2& position, property::Color color, float size) override {
        add({"point", {position}, size, {.fill = color}});
    }
    void text(const property::Vec2& position, std::string_view text, double height,
              property::Color color, property::TextAlign) override {
        add({"text", {position}, height, {.fill = color}, std::string(text)});
    }
    void part_of(std::uint64_t whole) override { whole_ = whole; }
    bool shows(property::Overlay overlay) const override { return overlays.contains(overlay); }
    bool sees(const property::Vec2& lower, const property::Vec2& upper) const override {
        return lower.x <= right && upper.x >= -right;
    }
    void begin_screen() override {}
    void end_screen() override {}

    std::size_t count(const std::string& kind) const {
        std::size_t n = 0;
        for (const Figure& figure : figures) n += figure.kind == kind;
        return n;
    }

    std::vector<Figure> figures;
    std::set<property::Overlay> overlays;
    double right = 1e9;  // the view reaches from -right to right

  private:
    void add(Figure figure) {
        figure.whole = whole_;
        figures.push_back(std::move(figure));
    }
    std::uint64_t whole_ = 0;
};

}  // namespace fettle::physics_module::testing
