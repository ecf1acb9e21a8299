#pragma once

#include <fettle/physics/physics.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <span>
#include <string>
#include <utility>

/// Draws worlds into a picture, as a file of SVG, which every browser shows. The pictures of
/// docs/guide/physics.md are drawn by it. `World::draw` calls the virtual functions of `DebugDraw`;
/// a game that draws in another way implements the same four.
class Picture : public fettle::physics::DebugDraw {
  public:
    using Vec2 = fettle::physics::Vec2;

    /// Shows a part of the world, m.
    explicit Picture(const fettle::physics::Aabb& view, double pixels_per_meter = 60)
        : view_(view), scale_(pixels_per_meter) {}

    /// Adds the world as it is now. Called several times, with a low opacity, it shows a motion.
    void add(const fettle::physics::World& world, double opacity = 1) { add(world, opacity, {}); }
    void add(const fettle::physics::World& world, double opacity,
             const fettle::physics::DebugDrawOptions& options) {
        text_ += "<g opacity='" + number(opacity) + "'>\n";
        world.draw(*this, options);
        text_ += "</g>\n";
    }
    void label(const Vec2& at, const std::string& text) {
        text_ += "<text x='" + x(at) + "' y='" + y(at) + "'>" + text + "</text>\n";
    }
    void arrow(const Vec2& from, const Vec2& to) {
        const Vec2 along = (to - from).normalized(), aside = {-along.y, along.x};
        const Vec2 neck = to - 0.3f * along;
        line(from, neck, "#ffd479", 3);
        text_ += "<polygon points='" + point_of(to) + point_of(neck + 0.13f * aside) +
                 point_of(neck - 0.13f * aside) + "' fill='#ffd479'/>\n";
    }
    void line(const Vec2& from, const Vec2& to, const char* color = "#ffd479", double width = 1.5) {
        text_ += "<line x1='" + x(from) + "' y1='" + y(from) + "' x2='" + x(to) + "' y2='" + y(to) +
                 "' stroke='" + color + "' stroke-width='" + number(width) + "'/>\n";
    }
    void dot(const Vec2& at, const char* color = "#ffd479", double radius = 4) {
        text_ += "<circle cx='" + x(at) + "' cy='" + y(at) + "' r='" + number(radius) + "' fill='" +
                 color + "'/>\n";
    }

    /// The outline of a capsule between two points.
    void capsule(const Vec2& from, const Vec2& to, float radius) {
        const Vec2 side = radius * Vec2((to - from).normalized().y, -(to - from).normalized().x);
        const std::string round = " A " + number(scale_ * double(radius)) + ' ' +
                                  number(scale_ * double(radius)) + " 0 0 0 ";
        text_ += "<path d='M " + point_of(from + side) + "L " + point_of(to + side) + round +
                 point_of(to - side) + "L " + point_of(from - side) + round +
                 point_of(from + side) +
                 "' fill='#ffd479' fill-opacity='0.2' stroke='#ffd479' stroke-width='1.5'/>\n";
    }

    /// Writes the file. False if that fails.
    bool save(const std::string& file) const {
        const std::string width = number(scale_ * double(view_.max.x - view_.min.x)),
                          height = number(scale_ * double(view_.max.y - view_.min.y));
        std::ofstream out(file);
        out << "<svg xmlns='http://www.w3.org/2000/svg' width='" << width << "' height='" << height
            << "' viewBox='0 0 " << width << ' ' << height << "'>\n"
            << "<style>text { font: 14px monospace; fill: #c8ccd4; text-anchor: middle }</style>\n"
            << "<rect width='100%' height='100%' rx='6' fill='#14171d'/>\n"
            << text_ << "</svg>\n";
        return bool(out.flush());
    }

  private:
    void polygon(std::span<const Vec2> points, bool closed, uint32_t color) override {
        text_ += "<polyline points='";
        for (const Vec2& point : points) text_ += point_of(point);
        if (closed) text_ += point_of(points[0]);
        text_ += "' " +
                 (closed ? style_of(color) : "fill='none' stroke='#8a93a5' stroke-width='3'") +
                 "/>\n";
    }
    void circle(const Vec2& center, float radius, float angle, uint32_t color) override {
        text_ += "<circle cx='" + x(center) + "' cy='" + y(center) + "' r='" +
                 number(scale_ * double(radius)) + "' " + style_of(color) + "/>\n";
        const Vec2 edge = center + radius * Vec2(std::cos(angle), std::sin(angle));
        line(center, edge, "#14171d", 1.5);
    }
    void segment(const Vec2& from, const Vec2& to, uint32_t) override {
        line(from, to, "#7fd1c7", 1.5);
    }
    void point(const Vec2& at, uint32_t) override { dot(at, "#7fd1c7", 3); }

    /// One color for each body that moves, as in the games.
    uint32_t color_of(const fettle::physics::Body& body,
                      const fettle::physics::Shape& shape) const override {
        using fettle::physics::BodyType;
        static constexpr std::array<uint32_t, 6> colors = {0xf0703c, 0xc8507c, 0xb26a52,
                                                           0xe5466a, 0xe88585, 0xb0618a};
        if (shape.sensor()) return sensor;
        if (body.type() == BodyType::static_body) return 0x2d3442;
        if (body.type() == BodyType::kinematic_body) return 0x4f78b8;
        return colors[body.index() % colors.size()];
    }

    static constexpr uint32_t sensor = 0xe0c050;

    /// Sensors are transparent.
    static std::string style_of(uint32_t color) {
        return "fill='" + hex(color) + (color == sensor ? "' fill-opacity='0.2" : "") +
               "' stroke='" + hex(color == sensor ? color : color >> 1 & 0x7f7f7f) +
               "' stroke-width='1.5'";
    }
    static std::string hex(uint32_t color) {
        std::array<char, 8> text = {};
        std::snprintf(text.data(), text.size(), "#%06x", unsigned(color & 0xffffff));
        return text.data();
    }
    static std::string number(double value) {
        std::array<char, 32> text = {};
        std::snprintf(text.data(), text.size(), "%.1f", value);
        return text.data();
    }
    std::string x(const Vec2& at) const { return number(scale_ * double(at.x - view_.min.x)); }
    std::string y(const Vec2& at) const { return number(scale_ * double(view_.max.y - at.y)); }
    std::string point_of(const Vec2& at) const { return x(at) + ',' + y(at) + ' '; }

    fettle::physics::Aabb view_;
    double scale_;
    std::string text_;
};
