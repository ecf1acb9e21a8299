#pragma once

#include <collision/extreme_points.h>
#include <collision/solid.h>

#include <vector>

// Convex polygons with more than eight vertices. They are not rotated with their body in every
// step. Instead, directions are rotated into their frame. The normals of a convex polygon are
// sorted by angle, so bisection finds the farthest vertex along a direction, and a search with
// growing strides finds the edge of greatest separation. So the time for a contact, and for a step,
// grows with the logarithm of the number of vertices.

namespace fettle::physics::detail {

/// Contact points of two convex shapes; at least one is large. Like `collide`.
void collide_large(const Solid& a, const Solid& b, Vec2 offset, float margin, Manifold& manifold);
void collide_large_half_plane(Vec2 normal, float depth, const Solid& b, Vec2 center_b, float margin,
                              Manifold& manifold);

/// Like the function for plain convex shapes. At least one is large, the other is large or plain.
Nearest nearest_to_large(const Solid& a, const Solid& b, Vec2 offset);

/// A large polygon with its vertices rotated, for code that reads all of them. Shapes of other
/// kinds stay as they are.
class PlainCopy {
  public:
    explicit PlainCopy(const Solid& from);
    PlainCopy(const PlainCopy&) = delete;
    PlainCopy& operator=(const PlainCopy&) = delete;
    const Solid& solid() const { return plain_; }

  private:
    Solid plain_;
    std::vector<Vec2> vertices_, normals_;
};

}  // namespace fettle::physics::detail
