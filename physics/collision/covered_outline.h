#pragma once

#include <collision/extreme_points.h>
#include <collision/solid.h>

#include <array>

// Shapes that lie flush beside each other are solid together, as the pieces of one outline
// (collision/outline_piece.h) are: faces between two of them, and corners in a level floor, push
// nothing. A piece knows its neighbors from the beginning; here they are found for one contact.

namespace fettle::physics::detail {

/// A shape and those beside it, seen by another shape that touches it.
class CoveredOutline {
  public:
    static constexpr int most_vertices = 16, most_neighbors = 16;

    /// True for shapes that may cover others and be covered: polygons, segments and convex parts of
    /// concave polygons, without rounding.
    static bool may_be(FormKind kind, int count, float radius) {
        if (radius != 0.0f || count < 2) return false;
        return kind == FormKind::convex || (kind == FormKind::piece && count > 2);
    }

    explicit CoveredOutline(const Solid& shape) : shape_(shape) {}
    CoveredOutline(const CoveredOutline&) = delete;

    /// `offset`: the origin of the neighbor in the frame of the shape.
    void add_neighbor(const Solid& neighbor, Vec2 offset) {
        if (count_ < most_neighbors) neighbors_[size_t(count_++)] = {neighbor, offset};
    }
    bool has_neighbors() const { return count_ > 0; }

    /// True if `normal` is that of a face of the shape that is not covered in front of `other`.
    bool is_bare_face(Vec2 normal, const Solid& other, Vec2 to_other) const;

    /// The shape as a piece of the outline of all shapes; for a segment, only the side `normal` is
    /// solid, or the side of `other` if that is the direction of an end. Null if no neighbor
    /// changes anything. Valid as long as this object.
    const Solid* piece_for(const Solid& other, Vec2 to_other, Vec2 normal);

  private:
    struct Neighbor {
        Solid solid;
        Vec2 offset;
    };
    /// Normals of the outline's edges before and after a vertex.
    struct Turn {
        Vec2 before, after;
    };

    int next(int vertex) const { return vertex + 1 < shape_.form.count ? vertex + 1 : 0; }
    int previous(int vertex) const { return vertex > 0 ? vertex - 1 : shape_.form.count - 1; }
    bool is_inner(int edge) const;
    float length_of(int edge) const;
    float bare_length(int edge, float low, float high) const;
    bool is_bare(int edge, const Solid& other, Vec2 to_other) const;
    bool is_bare_at(int edge, bool end) const;
    Turn own_turn(int vertex) const;
    Turn turn_at(int vertex, bool bare_before, bool bare_after) const;
    const Solid* polygon_for(const Solid& other, Vec2 to_other);
    const Solid* segment_for(const Solid& other, Vec2 to_other, Vec2 normal);

    const Solid& shape_;
    std::array<Neighbor, most_neighbors> neighbors_;
    int count_ = 0;
    std::array<Vec2, 2 * most_vertices> limits_;
    std::array<Vec2, 2> vertices_, normals_;  ///< of a segment
    std::array<float, 2> offsets_ = {};
    Solid piece_;
};

/// A point in the middle of a shape.
Vec2 middle_of(const Solid& shape);
bool is_inside(const Convex& polygon, Vec2 point);

}  // namespace fettle::physics::detail
