#pragma once

#include <fettle/physics/export.h>
#include <fettle/physics/shape.h>

#include <optional>
#include <span>

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

/// The parts of a world that `World::draw` draws.
struct DebugDrawOptions {
    bool shapes = true;     ///< their outlines
    bool joints = true;     ///< from the centers of mass to the anchors
    bool contacts = false;  ///< points, and normals of 0.2 m
    bool boxes = false;     ///< bounding boxes of shapes
    bool centers = false;   ///< centers of mass
    /// Pose between the previous (0) and the current one (1), for drawing between two steps.
    float fraction = 1.0f;
    /// Bodies with shapes that overlap this box are drawn, for instance the view of a camera. None:
    /// all.
    std::optional<Aabb> region = {};
};

/// Interface by which a world draws its objects as outlines. A host implements the four functions
/// with its own graphics. They may read the world, but must not edit it (callbacks.h). Coordinates
/// are those of the world, in m; colors are 0xRRGGBB.
class DebugDraw {
  public:
    DebugDraw() = default;
    DebugDraw(const DebugDraw&) = delete;
    DebugDraw& operator=(const DebugDraw&) = delete;
    virtual ~DebugDraw();

    /// An outline, counter-clockwise; `closed`: it goes back to its first point. The points are
    /// valid during the call.
    virtual void polygon(std::span<const Position> points, bool closed, uint32_t color) = 0;
    /// A circle, with the angle of its body, rad.
    virtual void circle(const Position& center, float radius, float angle, uint32_t color) = 0;
    /// A line between two points.
    virtual void segment(const Position& from, const Position& to, uint32_t color) = 0;
    /// A point, to be drawn in a size of the host.
    virtual void point(const Position& at, uint32_t color) = 0;
    /// Color of a shape of `body`. By default it shows whether the shape is a sensor, and otherwise
    /// whether the body is static, kinematic, awake or asleep.
    virtual uint32_t color_of(const Body& body, const Shape& shape) const;
};

}  // namespace fettle::physics

FETTLE_PHYSICS_END
