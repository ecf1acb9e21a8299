#pragma once

#include <collision/manifold.h>

// Batches of sixteen pairs of triangles and quadrilaterals, which are most shapes of most games.

namespace fettle::physics::detail {

/// The rotated vertices of all shapes: see VertexPool. A triangle repeats its first vertex and edge
/// as the fourth; the offset of this edge is so large that it never separates shapes.
struct ConvexArrays {
    const Vec2* vertices;
    const Vec2* normals;
    const float* offsets;
};

struct alignas(64) CollisionBatch {
    static constexpr int size = 16;

    uint32_t begin_a[size], begin_b[size];  ///< in the arrays
    int32_t count_a[size], count_b[size];   ///< vertices: 3 or 4
    float radius_a[size], radius_b[size];
    float offset_x[size], offset_y[size];  ///< origin of b minus that of a, m
    float margin[size];                    ///< m
    Manifold* manifolds[size];
    int count = 0;  ///< pairs; all arrays have valid entries for all sixteen

    bool is_full() const { return count == size; }
};

}  // namespace fettle::physics::detail
