#include <in_game/outline.h>
#include <observed/last_value.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <unordered_set>
#include <utility>
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

/// Leaves out all but some instances and what is below them.
class Chosen : public property::Drawer {
  public:
    Chosen(const property::Tree& tree, std::span<const Handle> instances, Pen& pen)
        : tree_(tree), pen_(pen) {
        for (const Handle each : instances) keys_.insert(each.key());
    }
    bool draws(const property::Class&) override { return false; }
    bool begins(Handle at) override {
        while (at && !keys_.contains(at.key())) at = tree_.parent(at);
        pen_.draw_for(at.key());
        return static_cast<bool>(at);
    }
    void draw(Handle, property::Painter&) override {}

  private:
    const property::Tree& tree_;
    Pen& pen_;
    std::unordered_set<std::uint64_t> keys_;
};

/// The outermost layer around an instance, which places it on the screen; without one, itself.
Handle outermost_layer(const property::Tree& tree, Handle instance) {
    Handle found = instance;
    for (Handle at = tree.parent(instance); at; at = tree.parent(at))
        if (tree.class_of(at).lifecycle().begin_below != nullptr) found = at;
    return found;
}

/// Draws a rectangle around a widget. Returns false if the instance is none, or is not shown.
bool draw_widget(ImDrawList& list, const property::Tree& tree, Handle instance, float glow) {
    const auto corner = read(tree, instance, "screen_position", Type::vec2);
    const auto size = read(tree, instance, "screen_size", Type::vec2);
    const auto shown = read(tree, instance, "shown", Type::boolean);
    if (!corner || !size || !shown || !shown->boolean()) return false;
    const Vec2 low = corner->vec2(), high = low + size->vec2();
    const ImVec2 a(static_cast<float>(low.x), static_cast<float>(low.y)),
        b(static_cast<float>(high.x), static_cast<float>(high.y));
    list.AddRect(a, b, with_alpha(palette::accent, glow), 0, 0, 5);
    list.AddRect(a, b, palette::accent);
    return true;
}

/// The box of an instance, if it has one.
std::vector<Vec2> box_of(const property::Tree& tree, Handle instance) {
    const auto box = read(tree, instance, "aabb", Type::list);
    return box ? points_of(*box) : std::vector<Vec2>();
}

}  // namespace

void draw_outlines(ImDrawList& list, const property::Tree& tree, std::span<const Handle> instances,
                   const ToPixels& to_pixels, const property::Seen& seen, double seconds) {
    // Those in one layer are drawn together, in one walk.
    std::map<std::uint64_t, std::pair<Handle, std::vector<Handle>>> groups;
    const float glow = 0.22f + 0.08f * static_cast<float>(std::sin(seconds * 4));
    for (const Handle each : instances) {
        if (tree.alive(each) && draw_widget(list, tree, each, glow)) continue;
        // A body is drawn by its shapes. A whole world gets no outline.
        if (!tree.alive(each) ||
            (tree.find(each, "aabb") == nullptr && tree.find(each, "position") == nullptr))
            continue;
        const Handle top = outermost_layer(tree, each);
        auto& group = groups[top.key()];
        group.first = top;
        group.second.push_back(each);
    }
    for (const auto& [key, group] : groups) {
        Pen pen(list, to_pixels,
                {.color = palette::accent, .glow = with_alpha(palette::accent, glow)});
        pen.show(seen);
        Chosen chosen(tree, group.second, pen);
        tree.draw(group.first, pen, property::Drawing::alpha(), &chosen);
        pen.outline_pictures();
        for (const Handle each : group.second) {
            if (!tree.alive(each) || pen.drew_for(each.key())) continue;
            const std::vector<Vec2> corners = box_of(tree, each);
            if (corners.size() != 2) continue;
            const std::array<Vec2, 4> round{corners[0], Vec2(corners[1].x, corners[0].y),
                                            corners[1], Vec2(corners[0].x, corners[1].y)};
            pen.polygon(round, 0, {});
        }
    }
}

}  // namespace fettle::console
