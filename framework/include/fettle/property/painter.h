#pragma once
// Drawing of instances. A class may have a function that draws its instances with a Painter; the
// window implements Painter. Neither depends on the other.

#include <cstdint>
#include <span>
#include <string_view>

#include <fettle/property/export.h>
#include <fettle/property/value.h>

FETTLE_PROPERTY_BEGIN

namespace fettle::property {

/// Marks that a viewer can show on top of the picture; each is a property under `view.show`.
enum class Overlay : std::uint8_t { aabbs, contacts, joints, centers, velocities, names, islands };

/// Fill and border of a drawn figure. Either may be transparent (alpha 0). Border width in pixels.
struct Paint {
    Color fill{1, 1, 1, 1};
    Color border{0, 0, 0, 1};
    float border_width = 1.5f;
};

/// Position of each line of a text relative to the given point.
enum class TextAlign : std::uint8_t { middle, left, right };

/// Draws in world units, y up. Angles are in radians, counter-clockwise. A border lies inside its
/// figure; only where an outline crosses itself does it lie on both sides of the line.
class Painter {
  public:
    virtual ~Painter() = default;
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
};

}  // namespace fettle::property

FETTLE_PROPERTY_END
