#pragma once

#include <fettle/physics/body.h>
#include <fettle/physics/export.h>
#include <fettle/physics/hull.h>

#include <span>

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

struct Separation;

namespace detail {
struct FETTLE_PHYSICS_PRIVATE WorldData;
}

/// A light handle to a shape: part of a body, or detached. Errors as for `Body`; a property that
/// the type of shape does not have (the radius of a box) throws `std::invalid_argument`.
class Shape {
  public:
    Shape() = default;                       ///< empty: it refers to no shape
    inline Shape(World* world, ShapeId id);  ///< the shape with this id

    bool is_valid() const noexcept;  ///< whether its world and its shape exist
    explicit operator bool() const noexcept { return is_valid(); }  ///< as `is_valid`
    ShapeId id() const noexcept { return id_; }                     ///< empty for an empty handle
    uint32_t index() const noexcept { return id_.index; }           ///< its slot: `ShapeId::index`
    World& world() const;                                           ///< the world that it is in
    friend bool operator==(const Shape&, const Shape&) = default;
    void destroy();  ///< its body stays, with less mass

    ShapeType type() const;  ///< the type of its geometry
    Body body() const;       ///< an invalid body when detached
    void attach(
        const Body& body);  ///< to a body of the same world; it leaves the one that it was on
    void detach();          ///< from its body: then it takes no part in steps and queries

    Geometry geometry() const;                    ///< body coordinates
    void set_geometry(const Geometry& geometry);  ///< may change the type (see Owner); a polygon
                                                  ///< becomes the hull of its vertices

    float radius() const;  ///< circle
    void set_radius(float radius);
    float radius_x() const;  ///< ellipse
    void set_radius_x(float radius);
    float radius_y() const;  ///< ellipse
    void set_radius_y(float radius);
    Vec2 center() const;  ///< circle, box, ellipse
    void set_center(const Vec2& center);
    float width() const;  ///< box
    void set_width(float width);
    float height() const;  ///< box
    void set_height(float height);
    float angle() const;  ///< box, ellipse
    void set_angle(float angle);
    float rounding() const;  ///< box, segment, polygon
    void set_rounding(float rounding);
    Vec2 from() const;  ///< segment
    void set_from(const Vec2& from);
    Vec2 to() const;  ///< segment
    void set_to(const Vec2& to);

    /// Polygon: its hull, counter-clockwise, body coordinates. Box and segment: their corners,
    /// without rounding. Concave and chain: the points that were set. Circle and ellipse: empty.
    /// Valid until the next edit of any shape.
    std::span<const Vec2> vertices() const;
    /// Polygon: the shape becomes the hull of `points`. Concave, chain: these points. After a
    /// failure nothing has changed, and the message of `std::invalid_argument` contains the reason.
    void set_vertices(std::span<const Vec2> points);
    /// Like `set_vertices` with a status instead of an exception; polygons only.
    HullStatus try_set_vertices(std::span<const Vec2> points);
    void add_vertex(const Vec2& point);  ///< polygon; body coordinates
    bool closed() const;                 ///< chain
    void set_closed(bool closed);
    /// Concave: its convex pieces, counter-clockwise, with at most sixteen vertices each, body
    /// coordinates. Chain: its segments. Other types: empty.
    std::vector<std::vector<Vec2>> pieces() const;

    // Surfaces by segment; other types of shape throw std::invalid_argument. Segments are numbered
    // as in `pieces`: from 0, in the order of the points. A surface stays with its number when the
    // points change, and ends when the shape becomes one of another type.

    uint32_t segment_count() const;  ///< chain
    /// Surface of a segment: its own values, and those of the shape for the others. Throws
    /// std::invalid_argument for a number that is not below `segment_count`, as do the next two.
    SegmentSurface segment_surface(uint32_t segment) const;
    /// None: that of the shape. Takes effect in the next step, and wakes the body.
    void set_segment_surface(uint32_t segment, const std::optional<SegmentSurface>& surface);
    /// None when the segment has that of the shape.
    std::optional<SegmentSurface> segment_surface_override(uint32_t segment) const;
    /// The surfaces of all segments, in order, as `set_segment_surfaces` takes them:
    /// `surface_of_shape` for a segment that has none. Empty if no segment has one.
    std::vector<SegmentSurface> segment_surface_overrides() const;
    /// Sets the surfaces of all segments, in order. An empty span: each has that of the shape.
    /// Throws std::invalid_argument for another number of surfaces than segments.
    void set_segment_surfaces(std::span<const SegmentSurface> surfaces);

    float density() const;  ///< kg/m², at least 0
    void set_density(float density);
    float friction() const;  ///< Coulomb coefficient, at least 0
    void set_friction(float friction);
    float restitution() const;  ///< 0 … 1: part of the speed that a bounce keeps
    void set_restitution(float restitution);
    float rolling_resistance() const;  ///< at least 0: lever arm divided by the radius
    void set_rolling_resistance(float resistance);
    float surface_speed() const;  ///< m/s, conveyor, counter-clockwise round the shape
    void set_surface_speed(float speed);
    bool sensor() const;  ///< whether it reports overlaps and applies no force
    void set_sensor(bool sensor);
    bool hit_events() const;  ///< whether impacts above `WorldDef::hit_threshold` are reported
    void set_hit_events(bool enabled);
    /// Its touches are reported if this is true for both shapes, from the next touch on. A touch
    /// whose begin was reported is reported to its end.
    bool contact_events() const;
    void set_contact_events(bool enabled);
    bool sensor_events() const;  ///< the same for a sensor, and for a shape in one
    void set_sensor_events(bool enabled);
    bool before_solve() const;  ///< the callback is called if this is true for both
    void set_before_solve(bool enabled);
    uint16_t material() const;  ///< a number of the host, without effect
    void set_material(uint16_t material);
    uint64_t category() const;  ///< categories that it belongs to, one bit each
    void set_category(uint64_t category);
    uint64_t mask() const;  ///< categories that it collides with; both shapes must agree
    void set_mask(uint64_t mask);
    int32_t group() const;  ///< same non-zero group: positive always collides, negative never
    void set_group(int32_t group);

    float area() const;                            ///< m²
    float mass() const;                            ///< kg: density × area
    Aabb aabb() const;                             ///< world; body coordinates when detached
    std::vector<Position> world_vertices() const;  ///< as `vertices`, in the world
    Position world_center() const;                 ///< centroid, in the world
    bool contains(
        const Position& world_point) const;  ///< whether the point is in it or on its edge
    bool is_touching() const;                ///< any contact, sleeping or not; sensors do not count
    uint32_t rebuilds() const;               ///< how often its derived geometry was computed again

    uint64_t user_data() const;  ///< a number of the host, without effect; saved with the world
    void set_user_data(uint64_t value);

  private:
    friend class World;
    friend Separation distance(const Shape& a, const Shape& b);
    detail::WorldData& live() const;

    detail::WorldLink* link_ = nullptr;
    ShapeId id_;
};

}  // namespace fettle::physics

FETTLE_PHYSICS_END
