#pragma once

#include <collision/solid.h>

// Pieces: the segments of a chain, and the convex parts of a concave polygon. The whole outline is
// solid. A single piece has edges that are not part of the outline (the diagonals of a cut, the
// back of a segment), and ends where the outline continues. These must have no effect on other
// shapes: a piece pushes only in directions of its part of the outline. Each vertex stores the
// normals of the outline's edges before and after it. The directions between the two are the cone
// in which the corner of the outline pushes.

namespace fettle::physics::detail {

/// A convex part of an outline. With two vertices, it is a segment that is solid only on the side
/// of its first edge.
class OutlinePiece {
  public:
    explicit OutlinePiece(const Solid& solid)
        : form(solid.form),
          rotation_(solid.rotation),
          limits_(solid.limits),
          normals_(solid.normals) {}

    /// Corners with a smaller angle are flat, and directions that differ by less are equal (rad).
    static constexpr float flat_angle = 1e-3f;

    const Convex& form;

    bool one_sided() const { return form.count == 2; }
    /// True for an edge that is not on the outline.
    bool is_inner(int edge) const {
        if (one_sided()) return edge == 1;
        const Vec2 after = limits_[2 * edge + 1], own = normals_[edge];
        return after.x != own.x || after.y != own.y;
    }

    enum class Verdict {
        pushes,  ///< the corner is on the outline, and this piece reports it
        leaves,  ///< another piece reports it
        flat     ///< no protruding corner: the edge beside it pushes
    };
    /// Decides whether a vertex pushes along `direction` (unit vector, outwards).
    Verdict decide(int vertex, Vec2 direction) const;
    /// True if the outline goes on at both sides of a vertex.
    bool continues(int vertex) const;
    /// True if a point is beyond an end of an edge, and the outline is hollow there: a shape that
    /// slides along the next edge touches this edge before it is above it. The point is in front of
    /// the next edge, or behind it by less than `depth`, and not farther away than the edge is
    /// long, or half a meter.
    bool is_before_hollow(int edge, Vec2 point, float depth = 0.0f) const;
    /// The edge of the outline at a vertex with the normal nearest to `direction`; -1 if neither
    /// edge is on the outline.
    int edge_at(int vertex, Vec2 direction) const;
    /// True if the point is in front of the plane of a one-sided segment, within `depth`, or if the
    /// piece is not one-sided.
    bool faces(Vec2 point, float depth = 0.0f) const {
        return !one_sided() || dot(form.normals[0], point) >= form.offsets[0] - depth;
    }

  private:
    Rotation rotation_;
    const Vec2* limits_;
    const Vec2* normals_;
};

// collide_piece.cpp

/// Contact points of a piece and another shape, as `collide`; the normal points away from the
/// piece. `had_contact`: the shapes were already in contact, so at any depth the other shape did
/// not come from behind.
void collide_piece(const Solid& piece, const Solid& other, Vec2 offset, float margin,
                   bool had_contact, Manifold& manifold);

}  // namespace fettle::physics::detail
