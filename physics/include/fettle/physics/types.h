#pragma once

#include <fettle/physics/export.h>
#include <fettle/vector/vector2.h>

#include <cstdint>
#include <limits>

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

/// All numbers in the library are single precision and in SI units (m, m/s, N, ...), angles in
/// radians.
using Vec2 = Vector2<float>;

/// A handle: a slot and the generation of the object in it. A default-constructed id is empty. An
/// id is valid in its world and in copies of that world. No two worlds of a process use the same
/// generations, so an id of another world is detected, and so is the id of a destroyed object. An
/// id never refers to a later object in the same slot.
struct BodyId {
    uint32_t index = 0;
    uint32_t generation = 0;  ///< 0: empty
    friend bool operator==(const BodyId&, const BodyId&) = default;
    explicit operator bool() const { return generation != 0; }
};

struct ShapeId {
    uint32_t index = 0;
    uint32_t generation = 0;
    friend bool operator==(const ShapeId&, const ShapeId&) = default;
    explicit operator bool() const { return generation != 0; }
};

struct JointId {
    uint32_t index = 0;
    uint32_t generation = 0;
    friend bool operator==(const JointId&, const JointId&) = default;
    explicit operator bool() const { return generation != 0; }
};

enum class BodyType : uint8_t {
    static_body,     ///< never moves by itself; can be teleported
    kinematic_body,  ///< moves by its velocity, no force moves it
    dynamic_body     ///< moved by forces, contacts and joints
};

enum class ShapeType : uint8_t {
    circle,
    box,
    segment,
    polygon,
    ellipse,
    concave,
    chain,
    border  ///< half-plane of `World::bounds`; only in contacts, events and rays
};

enum class JointType : uint8_t {
    mouse,
    distance,
    revolute,
    prismatic,
    wheel,
    weld,
    motor,
    pulley,
    gear,
    groove,
    pin_slot,
    ratchet,
    filter,
    rotary_limit
};

/// Axis-aligned box. `min` is the lower left corner.
struct Aabb {
    Vec2 min = {};
    Vec2 max = {};
    friend bool operator==(const Aabb& a, const Aabb& b) {
        return a.min == b.min && a.max == b.max;
    }
};

/// Pose of a body: its origin, and its angle (rad, counter-clockwise, not wrapped).
struct Pose {
    Vec2 position = {};
    float angle = 0.0f;
};

/// State of a body that changes in each step. All states are in one array with the index
/// `BodyId::index`. A slot does not move while its body lives: sleeping and waking do not reorder
/// the array. It can be read freely; writing requires `Body`.
struct BodyState {
    Vec2 position = {};             ///< of the body's origin, m
    float angle = 0.0f;             ///< rad, not wrapped
    float angular_velocity = 0.0f;  ///< rad/s
    Vec2 velocity = {};             ///< of the center of mass, m/s
    float cosine = 1.0f;            ///< of `angle`
    float sine = 0.0f;              ///< of `angle`
};
static_assert(sizeof(BodyState) == 32);

inline constexpr float infinity = std::numeric_limits<float>::infinity();

}  // namespace fettle::physics

FETTLE_PHYSICS_END
