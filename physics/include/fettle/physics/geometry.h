#pragma once

#include <fettle/physics/contact.h>
#include <fettle/physics/definitions.h>
#include <fettle/physics/export.h>
#include <fettle/physics/query.h>

#include <array>
#include <optional>
#include <span>
#include <vector>

// Functions on geometries that need no world. They are the functions that a world computes with.
// Poses and coordinates are in m, within ±1e8; a number out of range throws std::invalid_argument.
// The functions keep nothing, so several threads may call them at once.

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

namespace detail {
struct FETTLE_PHYSICS_PRIVATE SharedForm;
struct FETTLE_PHYSICS_PRIVATE FormAccess;
}  // namespace detail

/// A geometry that is ready for the functions below: checked, with its hull, its normals and its
/// convex parts. Every function also accepts a geometry, and then makes a form of it for the call;
/// a form that is used again saves that work. Copies share their data. Throws std::invalid_argument
/// like `Shape::set_geometry`.
class Form {
  public:
    /// Of any geometry.
    Form(const Geometry& geometry);  // NOLINT: converts
    /// Of a geometry of this type.
    Form(const Circle& circle);    // NOLINT
    Form(const Box& box);          // NOLINT
    Form(const Segment& segment);  // NOLINT
    Form(const Polygon& polygon);  // NOLINT
    Form(const Ellipse& ellipse);  // NOLINT
    Form(const Concave& concave);  // NOLINT
    Form(const Chain& chain);      // NOLINT

    Form(const Form& other) noexcept;      ///< shares its data
    Form& operator=(Form other) noexcept;  ///< shares its data
    ~Form();                               ///< the last copy frees its data

    ShapeType type() const;  ///< the type of its geometry
    /// Its convex parts, counter-clockwise, body coordinates, without rounding: corners of a box or
    /// a polygon, ends of a segment, pieces of a concave polygon (at most sixteen vertices each),
    /// segments of a chain. Circle and ellipse: their center.
    std::vector<std::vector<Vec2>> parts() const;

  private:
    friend struct detail::FormAccess;
    const detail::SharedForm* data_;
};

/// Area, mass and inertia of a geometry. A chain has none; its center is the middle of its first
/// segment.
struct MassProperties {
    float area = 0.0f;     ///< m²
    float mass = 0.0f;     ///< kg
    Vec2 centroid = {};    ///< body coordinates, m
    float inertia = 0.0f;  ///< kg m², about the centroid
};
/// `density`: kg/m², at least 0.
[[nodiscard]] MassProperties mass_properties(const Form& form, float density = 1.0f);

/// The smallest box around a geometry.
[[nodiscard]] Aabb bounding_box(const Form& form, const Pose& pose = {});

/// Whether a point is in the geometry or on its edge. A chain, and a segment without rounding,
/// contain only the points on them.
[[nodiscard]] bool contains(const Form& form, const Pose& pose, const Position& point);

/// The point where a ray enters a geometry.
struct SurfaceHit {
    Position point = {};    ///< m
    Vec2 normal = {};       ///< of the surface, outward
    float fraction = 0.0f;  ///< 0 at the start of the ray, 1 at its end
};
/// Nothing if the ray misses, or begins inside and does not enter again, as it may enter a concave
/// polygon. A chain is met only from its solid side.
[[nodiscard]] std::optional<SurfaceHit> cast_ray(const Form& form, const Pose& pose,
                                                 const Position& from, const Position& to);

/// Distance and nearest points of two geometries. A chain counts on both sides.
[[nodiscard]] Separation distance(const Form& a, const Pose& pose_a, const Form& b,
                                  const Pose& pose_b);

/// The contact points of two convex parts.
struct ContactManifold {
    Vec2 normal = {};                         ///< from a to b
    int point_count = 0;                      ///< 1 or 2
    std::array<ContactPoint, 2> points = {};  ///< impulses are 0
};
/// Contact points of two geometries that overlap, or are nearer than `margin` (m, at least 0). One
/// manifold for each pair of convex parts that touch: at most one if neither geometry is concave or
/// a chain.
[[nodiscard]] std::vector<ContactManifold> contact_manifolds(const Form& a, const Pose& pose_a,
                                                             const Form& b, const Pose& pose_b,
                                                             float margin = 0.0f);

/// A uniform motion from one pose to another.
struct Movement {
    Pose from = {};  ///< at fraction 0
    Pose to = {};    ///< at fraction 1
    /// The point that moves on a straight line, body coordinates, m; usually the center of mass.
    Vec2 center = {};
};
/// The fraction of two motions, 0 … 1, at which the geometries first come within 0.1 mm of each
/// other; 0 if they touch at the start, nothing if they pass each other. A chain counts on both
/// sides.
[[nodiscard]] std::optional<float> time_of_impact(const Form& a, const Movement& movement_a,
                                                  const Form& b, const Movement& movement_b);

/// Divides a simple polygon of any orientation into few convex pieces with at most sixteen vertices
/// each, counter-clockwise. No vertex is added. Throws std::invalid_argument if the outline crosses
/// or touches itself, or has more than `Concave::most_vertices`; the message has the place.
[[nodiscard]] std::vector<std::vector<Vec2>> convex_pieces(std::span<const Vec2> outline);

}  // namespace fettle::physics

FETTLE_PHYSICS_END
