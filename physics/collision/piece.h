#pragma once

#include <collision/solid.h>

// Pieces: the segments of a chain, the convex parts of a concave polygon. The whole outline is
// solid; a piece alone has edges that are not part of it (the diagonals of a cut, the back of a
// segment) and ends where the outline goes on. What touches it must not notice: directions in which
// a piece pushes are those of its part of the outline. Each vertex knows the normals of the
// outline's edges before and after it; between the two lies the cone of directions in which the
// outline's own corner pushes.

namespace fettle::physics::detail {

/// A convex part of an outline. Two vertices: a segment that is solid on the side of its first
/// edge only.
class Piece {
  public:
    explicit Piece(const Solid& solid)
        : form(solid.form),
          rotation_(solid.rotation),
          limits_(solid.limits),
          normals_(solid.normals) {}

    const Convex& form;

    bool one_sided() const { return form.count == 2; }
    /// An edge that is not on the outline.
    bool is_inner(int edge) const {
        if (one_sided()) return edge == 1;
        const V2 after = limits_[2 * edge + 1], own = normals_[edge];
        return after.x != own.x || after.y != own.y;
    }

    enum class Verdict {
        pushes,  ///< its corner, and its to tell
        leaves,  ///< to another piece
        flat     ///< no corner that sticks out: the edge beside it pushes
    };
    /// Of a push along `direction` (unit, outwards) at a vertex.
    Verdict judge(int vertex, V2 direction) const;
    /// The edge of the outline at a vertex whose normal is nearest to `direction`; -1 when neither
    /// is on the outline.
    int edge_at(int vertex, V2 direction) const;
    /// Outside of the plane of a one-sided segment, give or take `depth`, or not one-sided at all.
    bool faces(V2 point, float depth = 0.0f) const {
        return !one_sided() || dot(form.normals[0], point) >= form.offsets[0] - depth;
    }

  private:
    Rotation rotation_;
    const V2* limits_;
    const V2* normals_;
};

/// Contact points of a piece and another shape, as `collide`: the normal points from the piece.
/// `held`: it was in contact before, so that it did not come from behind, however deep it is.
void collide_piece(const Solid& piece, const Solid& other, V2 offset, float margin, bool held,
                   Manifold& manifold);

}  // namespace fettle::physics::detail
