#pragma once

#include <collision/solid.h>
#include <fettle/physics/definitions.h>
#include <geometry/kept_list.h>
#include <geometry/mass.h>

#include <span>
#include <vector>

// A geometry outside of any world, in the form that collisions and queries compute with.

namespace fettle::physics::detail {

/// A convex part of a geometry, body coordinates.
struct FormPart {
    size_t begin = 0;    ///< in the vertices and the normals
    uint32_t count = 0;  ///< vertices
    FormKind kind = FormKind::convex;
};

struct FormData {
    ShapeType type = ShapeType::circle;
    std::vector<FormPart> parts;
    std::vector<Vec2>
        vertices;  ///< of a piece, its limits are behind them: collision/outline_piece.h
    std::vector<Vec2> normals;
    float radius = 0.0f;
    AreaMoments moments;
};

/// The geometry must be valid: checks/arguments.h.
FormData form_of(const Geometry& geometry);

/// A form that is rotated, and whose vertices are relative to a point of its own; for the time of a
/// call, in memory that the thread keeps.
class PosedForm {
  public:
    /// `center`: the point, body coordinates. `form` must outlive the result.
    PosedForm(const FormData& form, const Pose& pose, Vec2 center = {});
    PosedForm(const PosedForm&) = delete;
    PosedForm& operator=(const PosedForm&) = delete;

    std::span<const Solid> solids() const { return *solids_; }
    Position center() const { return center_; }  ///< the point in the world, m
    float extent() const;                        ///< distance of the farthest point from it, m

  private:
    Position center_;
    KeptList<Solid> solids_;
    KeptList<Vec2> vertices_, normals_;
    KeptList<float> offsets_;
};

}  // namespace fettle::physics::detail
