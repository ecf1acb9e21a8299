#pragma once

#include <collision/extreme_points.h>
#include <collision/solid.h>

#include <vector>

namespace fettle::physics::detail {

/// Distance from the centroid of a shape to the nearest point of its surface, m; `centroid` from
/// the center of mass of its body.
float inner_radius(const Solid& shape, Vec2 centroid);

/// The part of a shape that is at least `depth` below its surface, 0 … the inner radius. At corners
/// between short edges it reaches a little nearer to the surface.
class Core {
  public:
    Core(const Solid& shape, Vec2 centroid, float depth);
    Core(const Core&) = delete;

    const Solid& solid() const { return solid_; }

  private:
    void shrink_polygon(const Convex& from, Vec2 centroid, float depth);

    Solid solid_;
    Vec2 few_vertices_[most_small_vertices];
    float few_offsets_[most_small_vertices];
    std::vector<Vec2> many_vertices_;
    std::vector<float> many_offsets_;
};

}  // namespace fettle::physics::detail
