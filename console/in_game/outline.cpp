#include <in_game/outline.h>
#include <observed/last_value.h>

#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include <fettle/property/drawing.h>

#include <look/theme.h>

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
    Value value = last_value(tree, instance, *property);
    if (!value.is(type)) return std::nullopt;
    return value;
}

std::vector<Vec2> points_of(const Value& list) {
    std::vector<Vec2> points;
    for (const Value& value : list.list())
        if (value.is(Type::vec2)) points.push_back(value.vec2());
    return points;
}

}  // namespace

void draw_outline(ImDrawList& list, const property::Tree& tree, Handle instance,
                  const ToPixels& to_pixels, double seconds) {
    // A body is drawn by its shapes. A whole world gets no outline.
    const auto box = read(tree, instance, "aabb", Type::list);
    if (!box && tree.find(instance, "position") == nullptr) return;
    const float glow = 0.22f + 0.08f * static_cast<float>(std::sin(seconds * 4));
    Pen pen(list, to_pixels, {.color = palette::accent, .glow = with_alpha(palette::accent, glow)});
    tree.draw(instance, pen, property::Drawing::alpha());
    if (pen.drew_anything() || !box) return;
    const std::vector<Vec2> corners = points_of(*box);
    if (corners.size() != 2) return;
    const std::array<Vec2, 4> round{corners[0], Vec2(corners[1].x, corners[0].y), corners[1],
                                    Vec2(corners[0].x, corners[1].y)};
    pen.polygon(round, 0, {});
}

}  // namespace fettle::console
