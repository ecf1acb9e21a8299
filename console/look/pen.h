#pragma once
// A painter that draws figures of the game into a draw list: as outlines in one color, or as they
// are.

#include <imgui.h>

#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <span>
#include <string_view>
#include <vector>

#include <fettle/property/painter.h>

#include <look/game_pictures.h>

namespace fettle::console {

using ToPixels = std::function<property::Vec2(property::Vec2 world)>;

/// The map back; the identity if there is none.
inline property::Transform inverse(const property::Transform& map) {
    const double area = map.area();
    if (area == 0) return {};
    property::Transform back{property::Vec2(map.y.y, -map.x.y) / area,
                             property::Vec2(-map.y.x, map.x.x) / area};
    back.origin = -back.direction(map.origin);
    return back;
}

struct PenStyle {
    ImU32 color = IM_COL32_WHITE;      // of the outline
    float width = 2;                   // px
    ImU32 glow = 0;                    // of a wide line below the outline; 0: none
    float glow_width = 7;              // px
    bool as_drawn = false;             // fills and borders as the game draws them
    float opacity = 1;                 // of figures that are `as_drawn`
    GamePictures* pictures = nullptr;  // for pictures that are `as_drawn`; null: as boxes
};

class Pen : public property::Painter {
  public:
    /// `map`: where the points of the world are drawn instead of at their places.
    Pen(ImDrawList& list, const ToPixels& to_pixels, const PenStyle& style,
        const property::Transform& map = {})
        : list_(list), to_pixels_(to_pixels), style_(style), map_(map) {}

    /// From now on the points of the world are drawn there.
    void place(const property::Transform& map) { map_ = map; }
    bool drew_anything() const { return !owners_.empty(); }
    /// What is drawn from now on belongs to this one: a number for each instance.
    void draw_for(std::uint64_t owner) { owner_ = owner; }
    bool drew_for(std::uint64_t owner) const { return owners_.contains(owner); }
    /// Draws lines around the pictures of those that drew no figures: letters, particles and tiles
    /// of one get one box together.
    void outline_pictures();
    /// The visible part of the world, for layers that move with it.
    void show(const property::Seen& seen) { seen_ = seen; }
    property::Seen seen() const override { return seen_; }

    void circle(const property::Vec2& center, double radius, const property::Paint& paint) override;
    void ellipse(const property::Vec2& center, const property::Vec2& radii, double angle,
                 const property::Paint& paint) override;
    void polygon(std::span<const property::Vec2> vertices, double rounding,
                 const property::Paint& paint) override;
    void line(const property::Vec2& from, const property::Vec2& to, property::Color color,
              float width) override;
    double pixels_per_unit() const override;
    /// As drawn: the picture, or its box if there are no textures for it; a letter as its pixels.
    /// What multiplies the colors below it is left out, and what adds to them is pale.
    void picture(const property::Picture& picture, const property::PictureArea& area,
                 const property::Vec2& lower, const property::Vec2& upper, property::Color tint,
                 bool smooth) override;
    void point(const property::Vec2&, property::Color, float) override {}
    void text(const property::Vec2&, std::string_view, double, property::Color,
              property::TextAlign) override {}
    void part_of(std::uint64_t) override {}
    /// Shapes that are hidden have outlines, unless the pictures that the game draws in their place
    /// are seen.
    bool shows(property::Overlay overlay) const override {
        return overlay == property::Overlay::shapes && style_.pictures == nullptr;
    }
    bool sees(const property::Vec2&, const property::Vec2&) const override { return true; }
    void begin_screen() override { push_screen(); }
    void end_screen() override { pop(); }

  private:
    ImVec2 pixel(const property::Vec2& at) const;
    /// Adds points of center + a cos t + b sin t; their number depends on the size on the screen.
    void arc(const property::Vec2& center, const property::Vec2& a, const property::Vec2& b,
             double start, double end);
    void stroke(bool closed, const property::Paint& paint);
    void textured(const property::Picture& picture, const property::PictureArea& area,
                  const property::Vec2& lower, const property::Vec2& upper,
                  const property::Color& tint);
    void letter(const property::Picture& picture, const property::Vec2& lower,
                const property::Vec2& upper, const property::Color& tint);

    ImDrawList& list_;
    const ToPixels& to_pixels_;
    PenStyle style_;
    property::Transform map_;
    property::Seen seen_{};
    std::vector<ImVec2> points_;
    std::uint64_t owner_ = 0;
    std::set<std::uint64_t> owners_;                         // that drew something
    std::map<std::uint64_t, std::vector<ImVec2>> pictures_;  // by owner; four corners for each
};

}  // namespace fettle::console
