#include "outline.h"

#include <cmath>
#include <optional>
#include <vector>

#include "theme.h"

namespace fettle::console {

using property::Handle;
using property::Type;
using property::Value;
using property::Vec2;

namespace {

std::optional<Value> read(const property::Tree& tree, Handle instance, std::string_view name,
                          Type type) {
    const property::Property* property = tree.find(instance, name);
    if (property == nullptr) return std::nullopt;
    Value value = tree.get(instance, *property);
    if (!value.is(type)) return std::nullopt;
    return value;
}

std::vector<Vec2> points_of(const Value& list) {
    std::vector<Vec2> points;
    for (const Value& value : list.list())
        if (value.is(Type::vec2)) points.push_back(value.vec2());
    return points;
}

class Pen {
  public:
    Pen(ImDrawList& list, const ToPixels& to_pixels, double seconds)
        : list_(list), to_pixels_(to_pixels) {
        glow_ = 0.22f + 0.08f * static_cast<float>(std::sin(seconds * 4));
    }

    void line(const std::vector<Vec2>& world, bool closed) {
        std::vector<ImVec2> pixels;
        pixels.reserve(world.size());
        for (const Vec2& point : world) pixels.push_back(pixel(point));
        stroke(pixels, closed);
    }

    void circle(Vec2 center, double radius) {
        ImVec2 middle = pixel(center);
        ImVec2 edge = pixel(center + Vec2(radius, 0));
        float r = std::hypot(edge.x - middle.x, edge.y - middle.y);
        list_.AddCircle(middle, r, with_alpha(palette::accent, glow_), 0, 7);
        list_.AddCircle(middle, r, palette::accent, 0, 2);
    }

  private:
    ImVec2 pixel(Vec2 world) const {
        Vec2 p = to_pixels_(world);
        return ImVec2(static_cast<float>(p.x()), static_cast<float>(p.y()));
    }
    void stroke(const std::vector<ImVec2>& points, bool closed) {
        auto count = static_cast<int>(points.size());
        int flags = closed ? ImDrawFlags_Closed : 0;
        list_.AddPolyline(points.data(), count, with_alpha(palette::accent, glow_), flags, 7);
        list_.AddPolyline(points.data(), count, palette::accent, flags, 2);
    }

    ImDrawList& list_;
    const ToPixels& to_pixels_;
    float glow_;
};

/// Where a circle's center is: beside the radius it is local to the body.
Vec2 circle_center(const property::Tree& tree, Handle shape, Vec2 local) {
    Handle body = tree.parent(shape);
    auto position = body ? read(tree, body, "position", Type::vec2) : std::nullopt;
    auto angle = body ? read(tree, body, "angle", Type::number) : std::nullopt;
    if (!position) return local;
    double a = angle ? angle->number() : 0;
    Vec2 turned(std::cos(a) * local.x() - std::sin(a) * local.y(),
                std::sin(a) * local.x() + std::cos(a) * local.y());
    return position->vec2() + turned;
}

bool draw_shape(const property::Tree& tree, Handle instance, Pen& pen) {
    auto radius = read(tree, instance, "radius", Type::number);
    auto center = read(tree, instance, "center", Type::vec2);
    if (radius && center) {
        pen.circle(circle_center(tree, instance, center->vec2()), radius->number());
        return true;
    }
    if (auto vertices = read(tree, instance, "world_vertices", Type::list)) {
        std::vector<Vec2> points = points_of(*vertices);
        if (points.size() >= 2) {
            pen.line(points, points.size() > 2);
            return true;
        }
    }
    return false;
}

}  // namespace

void draw_outline(ImDrawList& list, const property::Tree& tree, Handle instance,
                  const ToPixels& to_pixels, double seconds) {
    Pen pen(list, to_pixels, seconds);
    bool drawn = draw_shape(tree, instance, pen);
    // A body is the sum of its shapes; of a whole world one sees the world.
    if (!drawn && tree.find(instance, "position") != nullptr)
        for (Handle child = tree.first_child(instance); child; child = tree.next_sibling(child))
            drawn = draw_shape(tree, child, pen) || drawn;
    if (drawn) return;
    if (auto box = read(tree, instance, "aabb", Type::list)) {
        std::vector<Vec2> corners = points_of(*box);
        if (corners.size() != 2) return;
        pen.line({corners[0],
                  {corners[1].x(), corners[0].y()},
                  corners[1],
                  {corners[0].x(), corners[1].y()}},
                 true);
    }
}

}  // namespace fettle::console
