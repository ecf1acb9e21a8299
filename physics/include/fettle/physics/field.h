#pragma once

#include <fettle/physics/export.h>
#include <fettle/physics/types.h>

#include <optional>
#include <variant>

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

class World;

namespace detail {
struct FETTLE_PHYSICS_PRIVATE WorldData;
struct FETTLE_PHYSICS_PRIVATE WorldLink;
}  // namespace detail

/// A handle to a field: as `BodyId`.
struct FieldId {
    uint32_t index = 0;       ///< slot
    uint32_t generation = 0;  ///< of the field in the slot; 0: empty
    friend bool operator==(const FieldId&, const FieldId&) noexcept = default;
    friend auto operator<=>(const FieldId&, const FieldId&) noexcept = default;  // NOLINT
    explicit operator bool() const noexcept { return generation != 0; }          ///< false: empty
};

/// Moving air: presses on every edge that faces the wind by ½·density·(speed across the edge)². It
/// can lift plates and rotate wheels.
struct WindField {
    Vec2 velocity = {5.0f, 0.0f};  ///< m/s
    float density = 1.2f;          ///< kg/m²
};

/// Slows bodies relative to a flow, in proportion to the area of their shapes.
struct DragField {
    Vec2 flow = {};          ///< m/s
    float linear = 1.0f;     ///< N s/m per m²
    float quadratic = 0.0f;  ///< N s²/m² per m²
};

/// A liquid below a straight surface. Lifts a shape by the exact weight of the displaced liquid, at
/// the centroid of the submerged part; gravity is that of the world.
struct BuoyancyField {
    WorldCoordinate level = 0;   ///< m: points with normal·p < level are submerged
    Vec2 normal = {0.0f, 1.0f};  ///< upward normal of the surface, of any length but 0
    float density = 2.0f;        ///< kg/m²
    float drag = 2.0f;           ///< 1/s: share of the displaced mass that resists motion
    Vec2 flow = {};              ///< m/s
};

/// Pulls towards a point with an acceleration of strength / distance^falloff.
struct AttractorField {
    Position center = {};    ///< world, m
    float strength = 10.0f;  ///< m/s² at a distance of 1 m; negative repels
    int falloff = 2;         ///< 0 … 3
    float core = 0.5f;       ///< m: below this distance, the pull is proportional to the distance
};

/// A field of force: what it does, and where.
struct FieldDef {
    std::variant<WindField, DragField, BuoyancyField, AttractorField> force = {};  ///< what it does
    /// Region in which the field acts, m: on shapes that overlap it (liquids), or on bodies with
    /// their center of mass in it (other fields). None: everywhere.
    std::optional<Aabb> region = {};
    uint64_t mask = ~uint64_t{0};  ///< the field acts on shapes of these categories
    bool enabled = true;           ///< false: it does nothing
    uint64_t user_data = 0;        ///< a number of the host, without effect
};

/// A light handle to a field of force. Errors as for `Body`. A field acts only on awake bodies;
/// setting it wakes all.
class Field {
  public:
    Field() = default;                       ///< empty: it refers to no field
    inline Field(World* world, FieldId id);  ///< the field with this id

    bool is_valid() const noexcept;  ///< whether its world and its field exist
    explicit operator bool() const noexcept { return is_valid(); }  ///< as `is_valid`
    FieldId id() const noexcept { return id_; }                     ///< empty for an empty handle
    World& world() const;                                           ///< the world that it is in
    friend bool operator==(const Field&, const Field&) = default;
    void destroy();  ///< ends its force

    const FieldDef& definition() const;    ///< valid until the field is set or destroyed
    void set(const FieldDef& definition);  ///< all settings at once; invalid values are refused

  private:
    detail::WorldData& live() const;

    detail::WorldLink* link_ = nullptr;
    FieldId id_;
};

}  // namespace fettle::physics

template <>
struct std::hash<fettle::physics::FieldId> {
    std::size_t operator()(const fettle::physics::FieldId& id) const noexcept {
        return fettle::physics::detail::hash_of(id.index, id.generation);
    }
};

FETTLE_PHYSICS_END
