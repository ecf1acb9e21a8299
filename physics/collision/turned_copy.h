#pragma once

#include <collision/extreme_points.h>
#include <collision/solid.h>

#include <vector>

namespace fettle::physics::detail {

/// A copy of a shape that can be rotated about the center of mass of its body.
class TurnedCopy {
  public:
    explicit TurnedCopy(const Solid& from) : from_(from), turned_(from) {
        if (from.kind == FormKind::large) return;
        vertices_ = few_vertices_;
        normals_ = few_normals_;
        if (from.form.count > most_small_vertices) {
            many_.resize(2 * size_t(from.form.count));
            vertices_ = many_.data();
            normals_ = vertices_ + from.form.count;
        }
        turned_.form.vertices = vertices_;
        turned_.form.normals = normals_;
    }
    TurnedCopy(const TurnedCopy&) = delete;
    TurnedCopy& operator=(const TurnedCopy&) = delete;

    /// The shape after a rotation of the original. Valid until the next call.
    const Solid& by(Rotation q) {
        const Vec2 x = rotate(q, {from_.rotation.c, from_.rotation.s});
        turned_.rotation = {x.x, x.y};
        if (from_.kind == FormKind::large) return turned_;
        for (int i = 0; i < from_.form.count; ++i) {
            vertices_[i] = rotate(q, from_.form.vertices[i]);
            // A disc, which has no edges, may have no normals.
            if (from_.form.normals != nullptr) normals_[i] = rotate(q, from_.form.normals[i]);
        }
        // The second entry of an ellipse contains its radii, which are not rotated.
        if (from_.kind == FormKind::ellipse) vertices_[1] = from_.form.vertices[1];
        return turned_;
    }

  private:
    const Solid& from_;
    Solid turned_;
    Vec2* vertices_ = nullptr;
    Vec2* normals_ = nullptr;
    Vec2 few_vertices_[most_small_vertices], few_normals_[most_small_vertices];
    std::vector<Vec2> many_;
};

}  // namespace fettle::physics::detail
