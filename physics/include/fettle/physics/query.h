#pragma once

#include <fettle/physics/export.h>
#include <fettle/physics/function.h>
#include <fettle/physics/shape.h>

#include <type_traits>

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

/// The shapes that a query finds.
struct QueryFilter {
    uint64_t category =
        ~uint64_t{0};  ///< categories of the query: a shape's mask must contain one of these bits
    uint64_t mask = ~uint64_t{0};  ///< categories to find: a shape must have one of these bits
    int32_t group = 0;             ///< same non-zero group: positive is found, negative is not
    bool sensors = false;          ///< find sensors, too
    /// Called for each shape that passes the rest of the filter; empty: all pass. It may read the
    /// world and make other queries of it, but must not edit it: callbacks.h.
    Function<bool(const Shape&)> accept = {};
};

/// Where a ray or a cast shape meets a shape.
struct RayHit {
    Shape shape;          ///< the shape that was found
    Position point = {};  ///< world, m
    /// Outward normal of the surface. Opposite to the motion if a cast shape overlaps the shape at
    /// the start.
    Vec2 normal = {};
    float fraction = 0.0f;  ///< 0 at the start of the ray, 1 at its end
};

/// An object that can be called with a result of a query.
template <class Function, class Found>
concept Visits = std::is_object_v<std::remove_reference_t<Function>> &&
    std::is_invocable_v<Function&, const Found&>;

/// A reference to a function object, usually a lambda, that a query calls with each result. It
/// returns nothing, or false to end the query. It may read the world and make other queries of it,
/// but must not edit it: callbacks.h.
template <class Found>
class Visitor {
  public:
    /// `function` must live as long as the query runs.
    template <Visits<Found> Function>
    requires(!std::is_same_v<std::remove_cvref_t<Function>, Visitor>)
        Visitor(Function&& function)  // NOLINT: converts, and takes no visitor
        : function_(const_cast<void*>(static_cast<const void*>(&function))),
          call_([](void* called, const Found& found) {
              auto& visit = *static_cast<std::remove_reference_t<Function>*>(called);
              if constexpr (std::is_void_v<std::invoke_result_t<Function&, const Found&>>) {
                  visit(found);
                  return true;
              } else {
                  return bool(visit(found));
              }
          }) {}

    /// Whether the query is to go on.
    bool operator()(const Found& found) const { return call_(function_, found); }

  private:
    void* function_;
    bool (*call_)(void*, const Found&);
};

/// An explosion: `World::explode`.
struct ExplosionDef {
    Position point = {};   ///< m
    float radius = 1.0f;   ///< m, at least 0; nearer shapes get the full impulse
    float falloff = 0.0f;  ///< m, at least 0: the impulse falls linearly to 0 over this distance
                           ///< beyond the radius
    /// N s for each meter of the perimeter of a shape, seen from the center of the explosion. A
    /// negative impulse pulls.
    float impulse_per_length = 1.0f;
};

/// A point on a shape.
struct PointHit {
    Shape shape;            ///< the shape that was found
    Position point = {};    ///< on its surface; the query point if that is inside
    Vec2 normal = {};       ///< of the surface, outward; zero inside
    float distance = 0.0f;  ///< m; 0 inside
};

/// Distance between two shapes.
struct Separation {
    float distance = 0.0f;  ///< m; 0 when they overlap
    Position point_a = {};  ///< nearest to b, world, m
    Position point_b = {};  ///< nearest to a
    Vec2 normal = {};       ///< from a to b; zero when they overlap
};
/// Distance and nearest points of two shapes, which may be of different worlds. The coordinates of
/// a detached shape are used as world coordinates.
[[nodiscard]] Separation distance(const Shape& a, const Shape& b);

}  // namespace fettle::physics

FETTLE_PHYSICS_END
