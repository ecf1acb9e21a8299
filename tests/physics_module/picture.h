#pragma once
// A painter that writes down what it is asked to draw.

#include <set>
#include <string>
#include <vector>

#include <fettle/property/painter.h>

namespace fettle::physics_module::testing {

struct Figure {
    std::string kind;  // circle, polygon, line, point, text
    std::vector<property::Vec2> points;
    double size = 0;  // radius, rounding, width
    property::Paint paint{};
};

class Picture : public property::Painter {
  public:
    void circle(const property::Vec2& center, double radius, const property::Paint& p) override {
        figures.push_back({"circle", {center}, radius, p});
    }
    void polygon(std::span<const property::Vec2> vertices, double rounding,
                 const property::Paint& p) override {
        figures.push_back({"polygon", {vertices.begin(), vertices.end()}, rounding, p});
    }
    void line(const property::Vec2& from, const property::Vec2& to, property::Color color,
              float width) override {
        figures.push_back({"line", {from, to}, width, {.fill = color}});
    }
    void point(const property::Vec2& position, property::Color color, float size) override {
        figures.push_back({"point", {position}, size, {.fill = color}});
    }
    void text(const property::Vec2& position, std::string_view, double height,
              property::Color color, property::TextAlign) override {
        figures.push_back({"text", {position}, height, {.fill = color}});
    }
    bool shows(property::Overlay overlay) const override { return overlays.contains(overlay); }
    bool sees(const property::Vec2& lower, const property::Vec2& upper) const override {
        return lower.x() <= right && upper.x() >= -right;
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
    double right = 1e9;  // what is seen reaches from -right to right
};

}  // namespace fettle::physics_module::testing
