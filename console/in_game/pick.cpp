#include <in_game/pick.h>

#include <algorithm>
#include <vector>

#include <fettle/property/drawing.h>

namespace fettle::console {

using property::Handle;
using property::Vec2;

namespace {

/// Notes the instance whose picture is the last one drawn over a pixel.
class Finder : public property::Painter, public property::Drawer {
  public:
    Finder(Vec2 pixel, const ToPixels& to_pixels, const property::Seen& seen)
        : pixel_(pixel), to_pixels_(to_pixels), seen_(seen) {}
    Handle found() const { return found_; }

    bool draws(const property::Class&) override { return false; }
    bool begins(Handle instance) override {
        now_ = instance;
        return true;
    }
    void draw(Handle, property::Painter&) override {}

    void picture(const property::Picture& picture, const property::PictureArea& area,
                 const Vec2& lower, const Vec2& upper, property::Color tint, bool) override {
        if (state().blend != property::Blend::normal) return;
        const Quad quad{pixel(lower), pixel({upper.x, lower.y}), pixel({lower.x, upper.y})};
        const auto at = quad.share(pixel_);
        if (!within(at) || covers_window(quad)) return;
        const double down = on_screen() ? at.y : 1 - at.y;  // rows begin at the top
        const float opacity =
            tint.a * state().opacity *
            alpha_of(picture, {area.left + at.x * area.width, area.top + down * area.height});
        if (opacity >= least_opacity) found_ = now_;
    }
    property::Seen seen() const override { return seen_; }
    double pixels_per_unit() const override { return (pixel({1, 0}) - pixel({0, 0})).length(); }
    void circle(const Vec2&, double, const property::Paint&) override {}
    void ellipse(const Vec2&, const Vec2&, double, const property::Paint&) override {}
    void polygon(std::span<const Vec2>, double, const property::Paint&) override {}
    void line(const Vec2&, const Vec2&, property::Color, float) override {}
    void point(const Vec2&, property::Color, float) override {}
    void text(const Vec2&, std::string_view, double, property::Color,
              property::TextAlign) override {}
    void part_of(std::uint64_t) override {}
    bool shows(property::Overlay) const override { return false; }
    bool sees(const Vec2&, const Vec2&) const override { return true; }
    void begin_screen() override { push_screen(); }
    void end_screen() override { pop(); }

  private:
    static constexpr float least_opacity = 0.1f;

    struct Quad {
        Vec2 corner, right, up;  // the pixels of three corners
        /// How far a pixel is along both sides, 0 to 1 inside.
        Vec2 share(const Vec2& at) const {
            const Vec2 a = right - corner, b = up - corner, c = at - corner;
            const double whole = a.x * b.y - a.y * b.x;
            if (whole == 0) return {-1, -1};
            return Vec2(c.x * b.y - c.y * b.x, a.x * c.y - a.y * c.x) / whole;
        }
    };

    static bool within(const Vec2& share) {
        return share.x >= 0 && share.x < 1 && share.y >= 0 && share.y < 1;
    }
    bool covers_window(const Quad& quad) const {
        const Vec2 high = seen_.screen - Vec2(1, 1);
        return within(quad.share({0, 0})) && within(quad.share({high.x, 0})) &&
               within(quad.share({0, high.y})) && within(quad.share(high));
    }
    static float alpha_of(const property::Picture& picture, const Vec2& at) {
        const auto x = static_cast<std::size_t>(std::max(0.0, at.x));
        const auto y = static_cast<std::size_t>(std::max(0.0, at.y));
        if (x >= picture.width() || y >= picture.height()) return 0;
        return static_cast<float>(picture.rgba()[4 * (y * picture.width() + x) + 3]) / 255;
    }
    Vec2 pixel(const Vec2& at) const {
        return on_screen() ? transform()(at) : to_pixels_(transform()(at));
    }

    Vec2 pixel_;
    const ToPixels& to_pixels_;
    property::Seen seen_;
    Handle now_, found_;
};

}  // namespace

Handle pick_picture(const property::Tree& tree, Vec2 pixel, const ToPixels& to_pixels,
                    const property::Seen& seen) {
    Finder finder(pixel, to_pixels, seen);
    const property::DrawingPart part(property::DrawingPart::Part::instances);
    tree.draw(tree.root(), finder, property::Drawing::alpha(), &finder);
    return tree.alive(finder.found()) ? finder.found() : Handle{};
}

namespace {

/// The first instance that a method of this name gives for a point. A method of this name that
/// means something else gives none.
Handle first_at(property::Tree& tree, std::string_view method, Vec2 point) {
    // The methods are called after the walk, because a method may change the tree.
    std::vector<Handle> with_method;
    tree.each_below(tree.root(), [&](Handle instance) {
        if (tree.class_of(instance).method(method) != nullptr) with_method.push_back(instance);
    });
    for (Handle each : with_method) {
        if (!tree.alive(each)) continue;
        property::Result result;
        try {
            result = tree.call(each, method, {property::Value(point)});
        } catch (const std::exception&) {
            continue;
        }
        const auto* value = std::get_if<property::Value>(&result);
        if (value != nullptr && value->is(property::Type::reference) &&
            tree.alive(value->reference()))
            return value->reference();
    }
    return {};
}

}  // namespace

Handle pick(property::Tree& tree, Vec2 point) {
    return first_at(tree, "at", point);
}

Handle pick_widget(property::Tree& tree, Vec2 pixel) {
    return first_at(tree, "widget_at", pixel);
}

}  // namespace fettle::console
