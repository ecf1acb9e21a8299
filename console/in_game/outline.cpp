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

/// Leaves out all but an instance and what is below it.
class Only : public property::Drawer {
  public:
    Only(const property::Tree& tree, Handle instance) : tree_(tree), instance_(instance) {}
    bool draws(const property::Class&) override { return false; }
    bool begins(Handle at) override {
        while (at && at != instance_) at = tree_.parent(at);
        return static_cast<bool>(at);
    }
    void draw(Handle, property::Painter&) override {}

  private:
    const property::Tree& tree_;
    Handle instance_;
};

/// The outermost layer around an instance, which places it on the screen; without one, itself.
Handle outermost_layer(const property::Tree& tree, Handle instance) {
    Handle found = instance;
    for (Handle at = tree.parent(instance); at; at = tree.parent(at))
        if (tree.class_of(at).lifecycle().begin_below != nullptr) found = at;
    return found;
}

}  // namespace

void draw_outline(ImDrawList& list, const property::Tree& tree, Handle instance,
                  const ToPixels& to_pixels, const property::Seen& seen, double seconds) {
    // A body is drawn by its shapes. A whole world gets no outline.
    const auto box = read(tree, instance, "aabb", Type::list);
    if (!box && tree.find(instance, "position") == nullptr) return;
    const float glow = 0.22f + 0.08f * static_cast<float>(std::sin(seconds * 4));
    Pen pen(list, to_pixels, {.color = palette::accent, .glow = with_alpha(palette::accent, glow)});
    pen.show(seen);
    Only only(tree, instance);
    tree.draw(outermost_layer(tree, instance), pen, property::Drawing::alpha(), &only);
    if (!pen.drew_anything()) pen.outline_pictures();
    if (pen.drew_anything() || !box) return;
    const std::vector<Vec2> corners = points_of(*box);
    if (corners.size() != 2) return;
    const std::array<Vec2, 4> round{corners[0], Vec2(corners[1].x, corners[0].y), corners[1],
                                    Vec2(corners[0].x, corners[1].y)};
    pen.polygon(round, 0, {});
}

}  // namespace fettle::console
