#pragma once
// Drawing of instances. A class may have a function that draws its instances with a Painter; the
// window implements Painter. Neither depends on the other.

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <fettle/property/export.h>
#include <fettle/property/picture.h>
#include <fettle/property/transform.h>
#include <fettle/property/value.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// Marks that a viewer can show on top of the picture; each is a property under `view.show`.
enum class Overlay : std::uint8_t {
    aabbs,
    contacts,
    joints,
    centers,
    velocities,
    names,
    islands,
    impulses,
    limits,
    shapes  ///< outlines of all shapes, also of those that are hidden
};

/// Fill and border of a drawn figure. Either may be transparent (alpha 0). Border width in pixels.
struct Paint {
    Color fill{1, 1, 1, 1};
    Color border{0, 0, 0, 1};
    float border_width = 1.5f;
};

/// Position of each line of a text relative to the given point.
enum class TextAlign : std::uint8_t { middle, left, right };

/// Colors that change along a line, or from a center outwards. Before `from` is the first color,
/// and beyond `to` the last.
struct Gradient {
    bool radial = false;
    Vec2 from{0, 0};              // radial: the center
    Vec2 to{0, 0};                // radial: a point at the last color
    std::vector<Color> colors{};  // two or more, at equal distances
};

/// The visible part of the world.
struct Seen {
    Vec2 center{0, 0};              // in the middle of the screen
    Vec2 lower{0, 0}, upper{0, 0};  // a box around the visible part
    Vec2 screen{0, 0};              // px, size of the screen
};

/// Draws in world units, y up. Angles are in radians, counter-clockwise. A border lies inside its
/// figure; only where an outline crosses itself does it lie on both sides of the line. Widths of
/// borders and lines and sizes of dots are pixels whatever the transform is.

class Painter {
  public:
    virtual ~Painter() = default;
    /// Until the `pop` that belongs to it, all coordinates are mapped by `transform` first, and
    /// then by those that were pushed before. It also keeps opacity, blend mode and clip rectangle,
    /// so that `pop` brings them back.
    virtual void push(const Transform& transform) {
        outer_.push_back(state_);
        set_transform(state_.transform * transform);
    }
    /// No effect if nothing is pushed.
    virtual void pop() {
        if (outer_.empty()) return;
        const State before = std::move(outer_.back());
        outer_.pop_back();
        set_state(before);
    }
    /// Multiplies the opacity of everything that follows.
    virtual void fade(float opacity) {
        State faded = state_;
        faded.opacity *= opacity;
        set_state(faded);
    }
    virtual void blend(Blend mode) {
        State blended = state_;
        blended.blend = mode;
        set_state(blended);
    }
    /// Draws only inside of the box, and inside of the clip rectangle that is set already. With a
    /// transform that turns, the box around the turned box is used.
    virtual void clip(const Vec2& lower, const Vec2& upper) { (void)lower, (void)upper; }
    /// Multiplies the fill of the circles, ellipses and polygons that follow, until the `pop` of
    /// what is pushed now.
    virtual void gradient(const Gradient& gradient) { (void)gradient; }
    /// Number of `push`es without their `pop`.
    std::size_t pushed() const { return outer_.size(); }
    const Transform& transform() const { return state_.transform; }
    /// Whether coordinates are pixels with y down (`begin_screen`).
    bool on_screen() const { return state_.on_screen; }
    /// Empty if the painter does not show a view.
    virtual Seen seen() const { return {}; }
    /// Pixels for each unit of length; 1 if the painter has no pixels.
    virtual double pixels_per_unit() const { return 1; }
    /// Factor of the size of texts of overlays, which a person may have chosen for a screen of many
    /// pixels; 1 is the usual size.
    virtual double label_scale() const { return 1; }
    /// Draws an area of a picture into the box, upright. Neighboring areas of the picture do not
    /// show. `smooth`: pixels are mixed when they are enlarged; otherwise each stays a square.
    /// Bounds in the wrong order mirror the picture.
    virtual void picture(const Picture& picture, const PictureArea& area, const Vec2& lower,
                         const Vec2& upper, Color tint, bool smooth) {
        (void)picture, (void)area, (void)lower, (void)upper, (void)tint, (void)smooth;
    }
    virtual void circle(const Vec2& center, double radius, const Paint& paint) = 0;
    /// Half axes along x and y, then turned by `angle`.
    virtual void ellipse(const Vec2& center, const Vec2& radii, double angle,
                         const Paint& paint) = 0;
    /// Polygon with any outline, clockwise or counter-clockwise, also with crossing edges. The
    /// inside is the part that the outline encloses at least once; opposite turns cancel.
    /// `rounding` is a radius around the polygon in meters, for convex polygons only.
    virtual void polygon(std::span<const Vec2> vertices, double rounding, const Paint& paint) = 0;
    /// A line `width` pixels thick.
    virtual void line(const Vec2& from, const Vec2& to, Color color, float width) = 0;
    /// A dot `size` pixels across.
    virtual void point(const Vec2& position, Color color, float size) = 0;
    /// UTF-8 text, upright, with lines `height` meters high; `position` is in the middle of the
    /// height. A newline begins another line; each line is aligned by itself. A tab continues at
    /// the next multiple of twice the height from the beginning of the line.
    virtual void text(const Vec2& position, std::string_view text, double height, Color color,
                      TextAlign align = TextAlign::middle) = 0;
    /// The circles, ellipses and polygons that follow are parts of one figure with that number,
    /// until another number is set. 0: each is a figure of its own. Consecutive parts with the same
    /// paint have one border around all of them and none inside; where they overlap, a transparent
    /// fill is drawn once.
    virtual void part_of(std::uint64_t whole) = 0;
    virtual bool shows(Overlay overlay) const = 0;
    /// True if any part of the box is visible. A class does not have to draw what is outside the
    /// view.
    virtual bool sees(const Vec2& lower, const Vec2& upper) const = 0;
    /// Until `end_screen`, coordinates are pixels from the top left corner, y down.
    virtual void begin_screen() = 0;
    virtual void end_screen() = 0;

  protected:
    struct State {
        Transform transform{};
        float opacity = 1;
        Blend blend = Blend::normal;
        bool on_screen = false;  // between begin_screen and end_screen
        std::shared_ptr<const Gradient> gradient{};
        Vec2 gradient_across{0, 0};  // where a painter puts the point beside `from`
        // Pixels from the top left corner. Without an area, nothing is visible.
        bool clipped = false;
        Vec2 clip_lower{0, 0}, clip_upper{0, 0};
    };
    const State& state() const { return state_; }
    /// Called for every change of the state but those that `set_transform` is called for.
    virtual void set_state(const State& state) { state_ = state; }
    /// Called for a push, which may be one for each sprite.
    virtual void set_transform(const Transform& transform) { state_.transform = transform; }
    /// For `begin_screen`, which begins without a transform; `pop` is its end.
    void push_screen() {
        State screen = state_;
        screen.transform = {};
        screen.on_screen = true;
        outer_.push_back(state_);
        set_state(screen);
    }
    /// Drops all pushed states.
    void reset_state() {
        outer_.clear();
        set_state({});
    }

  private:
    State state_{};
    std::vector<State> outer_{};
};

}  // namespace fettle::property

FETTLE_PROPERTY_END
