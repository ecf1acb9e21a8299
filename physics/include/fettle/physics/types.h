#pragma once

#include <fettle/physics/position.h>

#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>  // declares std::hash

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

/// A handle: a slot and the generation of the object in it. A default-constructed id is empty. An
/// id is valid in its world and in copies of that world. No two worlds of a process use the same
/// generations, so an id of another world is detected, and so is the id of a destroyed object. An
/// id never refers to a later object in the same slot. Ids are ordered by slot, then by generation,
/// and can be keys of all containers.
struct BodyId {
    uint32_t index = 0;       ///< slot
    uint32_t generation = 0;  ///< 0: empty
    friend bool operator==(const BodyId&, const BodyId&) noexcept = default;
    friend auto operator<=>(const BodyId&, const BodyId&) noexcept = default;  // NOLINT: no pointer
    explicit operator bool() const noexcept { return generation != 0; }        ///< false: empty
};

/// A handle to a shape: as `BodyId`.
struct ShapeId {
    uint32_t index = 0;       ///< slot
    uint32_t generation = 0;  ///< of the object in the slot; 0: empty
    friend bool operator==(const ShapeId&, const ShapeId&) noexcept = default;
    friend auto operator<=>(const ShapeId&, const ShapeId&) noexcept = default;  // NOLINT
    explicit operator bool() const noexcept { return generation != 0; }          ///< false: empty
};

/// A handle to a joint: as `BodyId`.
struct JointId {
    uint32_t index = 0;       ///< slot
    uint32_t generation = 0;  ///< of the object in the slot; 0: empty
    friend bool operator==(const JointId&, const JointId&) noexcept = default;
    friend auto operator<=>(const JointId&, const JointId&) noexcept = default;  // NOLINT
    explicit operator bool() const noexcept { return generation != 0; }          ///< false: empty
};

/// What moves a body.
enum class BodyType : uint8_t {
    static_body,     ///< never moves by itself; can be teleported
    kinematic_body,  ///< moves by its velocity, no force moves it
    dynamic_body     ///< moved by forces, contacts and joints
};

/// The geometry of a shape.
enum class ShapeType : uint8_t {
    circle,   ///< `Circle`
    box,      ///< `Box`
    segment,  ///< `Segment`
    polygon,  ///< `Polygon`
    ellipse,  ///< `Ellipse`
    concave,  ///< `Concave`
    chain,    ///< `Chain`
    border    ///< half-plane of `World::bounds`; only in contacts, events and rays
};

/// What a joint does with its two bodies.
enum class JointType : uint8_t {
    mouse,        ///< `MouseJoint`
    distance,     ///< `DistanceJoint`
    revolute,     ///< `RevoluteJoint`
    prismatic,    ///< `PrismaticJoint`
    wheel,        ///< `WheelJoint`
    weld,         ///< `WeldJoint`
    motor,        ///< `MotorJoint`
    pulley,       ///< `PulleyJoint`
    gear,         ///< `GearJoint`
    groove,       ///< `GrooveJoint`
    pin_slot,     ///< `PinSlotJoint`
    ratchet,      ///< `RatchetJoint`
    filter,       ///< `FilterJoint`
    rotary_limit  ///< `RotaryLimitJoint`
};

/// Identifies the contact of two shapes: it is the same in all events of a touch, and in every
/// later touch of the same two shapes. Ids with the shapes in either order are equal if `of` made
/// them.
struct ContactId {
    ShapeId shape_a;  ///< the smaller id, if `of` made it
    ShapeId shape_b;  ///< the other shape
    /// The contact of two shapes in either order.
    static ContactId of(const ShapeId& one, const ShapeId& other) noexcept {
        return one < other ? ContactId{one, other} : ContactId{other, one};
    }
    friend bool operator==(const ContactId&, const ContactId&) noexcept = default;
    friend auto operator<=>(const ContactId&, const ContactId&) noexcept = default;  // NOLINT
    explicit operator bool() const noexcept {
        return bool(shape_a) && bool(shape_b);
    }  ///< false: empty
};

/// Axis-aligned box. `min` is the lower left corner.
struct Aabb {
    Position min = {};  ///< m
    Position max = {};  ///< the upper right corner, m
    /// Compares both corners.
    friend bool operator==(const Aabb& a, const Aabb& b) {
        return a.min == b.min && a.max == b.max;
    }
};

/// Pose of a body: its origin, and its angle (rad, counter-clockwise, not wrapped).
struct Pose {
    Position position = {};  ///< m
    float angle = 0.0f;      ///< rad
};

/// State of a body that changes in each step. All states are in one array with the index
/// `BodyId::index`. A slot does not move while its body lives: sleeping and waking do not reorder
/// the array. It can be read freely; writing requires `Body`.
struct BodyState {
    Position position = {};         ///< of the body's origin, m
    float angle = 0.0f;             ///< rad, not wrapped
    float angular_velocity = 0.0f;  ///< rad/s
    Vec2 velocity = {};             ///< of the center of mass, m/s
    float cosine = 1.0f;            ///< of `angle`
    float sine = 0.0f;              ///< of `angle`
};
static_assert(sizeof(BodyState) == sizeof(Position) + 24);

/// Stands for no limit, and for a mass that nothing moves.
inline constexpr float infinity = std::numeric_limits<float>::infinity();

namespace detail {
/// Hash of an id. Multiplication spreads the slots, which are small numbers, over all bits.
constexpr std::size_t hash_of(uint32_t index, uint32_t generation) noexcept {
    const uint64_t mixed = (uint64_t{generation} << 32 | index) * 0x9e3779b97f4a7c15u;
    return std::size_t(mixed ^ (mixed >> 32));
}
}  // namespace detail

}  // namespace fettle::physics

template <>
struct std::hash<fettle::physics::BodyId> {
    std::size_t operator()(const fettle::physics::BodyId& id) const noexcept {
        return fettle::physics::detail::hash_of(id.index, id.generation);
    }
};
template <>
struct std::hash<fettle::physics::ShapeId> {
    std::size_t operator()(const fettle::physics::ShapeId& id) const noexcept {
        return fettle::physics::detail::hash_of(id.index, id.generation);
    }
};
template <>
struct std::hash<fettle::physics::ContactId> {
    std::size_t operator()(const fettle::physics::ContactId& id) const noexcept {
        const std::hash<fettle::physics::ShapeId> of_shape;
        return of_shape(id.shape_a) * 31 + of_shape(id.shape_b);
    }
};
template <>
struct std::hash<fettle::physics::JointId> {
    std::size_t operator()(const fettle::physics::JointId& id) const noexcept {
        return fettle::physics::detail::hash_of(id.index, id.generation);
    }
};

FETTLE_PHYSICS_END
