#pragma once

#include <fettle/physics/export.h>
#include <fettle/physics/types.h>

#include <vector>

// Events of the last step and of the edits before it. Ids of destroyed objects are dangling on
// purpose: they can still be compared, so a listener knows which object was destroyed.

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

/// Two shapes touch that did not touch before.
struct ContactBeginEvent {
    ShapeId shape_a;           ///< the normal points away from it
    ShapeId shape_b;           ///< the other shape
    BodyId body_a;             ///< of `shape_a`
    BodyId body_b;             ///< of `shape_b`
    Position point = {};       ///< world, m: middle of the manifold
    Vec2 normal = {};          ///< from a to b
    float speed = 0.0f;        ///< m/s, along the normal, at which the shapes meet
    float impulse = 0.0f;      ///< N s, the impulse that stops the approach and causes the bounce
    float friction = 0.0f;     ///< mixed
    float restitution = 0.0f;  ///< mixed
    uint32_t part_a = 0;       ///< segment or piece of `shape_a`, as in `Contact`
    uint32_t part_b = 0;       ///< the same of `shape_b`
    uint32_t material_a = 0;   ///< at `shape_a`, as in `Contact`
    uint32_t material_b = 0;   ///< at `shape_b`

    /// The same in all events of this touch.
    ContactId id() const noexcept { return ContactId::of(shape_a, shape_b); }
};

/// Two shapes no longer touch, or one of them was destroyed, detached or disabled, or a kinematic
/// body crushed the other one, or because the touch held a joint open.
struct ContactEndEvent {
    ShapeId shape_a;  ///< the normal points away from it
    ShapeId shape_b;  ///< the other shape
    BodyId body_a;    ///< of `shape_a`
    BodyId body_b;    ///< of `shape_b`

    /// The same in all events of this touch.
    ContactId id() const noexcept { return ContactId::of(shape_a, shape_b); }
};

/// A continuing touch; only with `WorldDef::persist_events`.
struct ContactPersistEvent {
    ShapeId shape_a;           ///< the normal points away from it
    ShapeId shape_b;           ///< the other shape
    BodyId body_a;             ///< of `shape_a`
    BodyId body_b;             ///< of `shape_b`
    Position point = {};       ///< world, m: middle of the manifold
    Vec2 normal = {};          ///< from a to b
    float speed = 0.0f;        ///< m/s, approach speed along the normal
    float impulse = 0.0f;      ///< N s, normal impulse of the last step
    float friction = 0.0f;     ///< mixed
    float restitution = 0.0f;  ///< mixed
    uint32_t part_a = 0;       ///< segment or piece of `shape_a`, as in `Contact`
    uint32_t part_b = 0;       ///< the same of `shape_b`
    uint32_t material_a = 0;   ///< at `shape_a`, as in `Contact`
    uint32_t material_b = 0;   ///< at `shape_b`

    /// The same in all events of this touch.
    ContactId id() const noexcept { return ContactId::of(shape_a, shape_b); }
};

/// An impact, for shapes with `hit_events`.
struct ContactHitEvent {
    ShapeId shape_a;           ///< the normal points away from it
    ShapeId shape_b;           ///< the other shape
    BodyId body_a;             ///< of `shape_a`
    BodyId body_b;             ///< of `shape_b`
    Position point = {};       ///< world, m: middle of the manifold
    Vec2 normal = {};          ///< from a to b
    float speed = 0.0f;        ///< m/s, approach speed along the normal
    float impulse = 0.0f;      ///< N s, the impulse that stopped the approach
    float friction = 0.0f;     ///< mixed
    float restitution = 0.0f;  ///< mixed
    uint32_t part_a = 0;       ///< segment or piece of `shape_a`, as in `Contact`
    uint32_t part_b = 0;       ///< the same of `shape_b`
    uint32_t material_a = 0;   ///< at `shape_a`, as in `Contact`
    uint32_t material_b = 0;   ///< at `shape_b`

    /// The same in all events of this touch.
    ContactId id() const noexcept { return ContactId::of(shape_a, shape_b); }
};

/// A shape has entered a sensor, or has left it.
struct SensorEvent {
    ShapeId sensor;       ///< the sensor
    ShapeId visitor;      ///< the shape that has entered or left
    BodyId sensor_body;   ///< of `sensor`
    BodyId visitor_body;  ///< of `visitor`

    /// The same in all events of this touch.
    ContactId id() const noexcept { return ContactId::of(sensor, visitor); }
};

/// A joint had more load than its `break_force` or `break_torque`; it no longer acts
/// (`Joint::broken`).
struct JointBreakEvent {
    JointId joint;        ///< the joint with the load
    BodyId body_a;        ///< an invalid id means the world
    BodyId body_b;        ///< the same
    Vec2 force = {};      ///< N, on body b, mean over the step
    float torque = 0.0f;  ///< N m, on body b, without the torque of the force
};

/// A joint had more load in this step than its `report_force` or `report_torque`.
struct JointLoadEvent {
    JointId joint;        ///< the joint with the load
    BodyId body_a;        ///< an invalid id means the world
    BodyId body_b;        ///< the same
    Vec2 force = {};      ///< N, on body b, mean over the step
    float torque = 0.0f;  ///< N m, on body b, without the torque of the force
};

/// The events of a step, by kind, in an order that is repeatable. If a touch ended and began again,
/// both lists have it, and the end was first: so read ends before begins.
struct Events {
    std::vector<ContactBeginEvent> contact_begin;      ///< touches that began
    std::vector<ContactPersistEvent> contact_persist;  ///< touches that continue
    std::vector<ContactEndEvent> contact_end;          ///< touches that ended
    std::vector<ContactHitEvent> contact_hit;          ///< impacts
    std::vector<SensorEvent> sensor_begin;             ///< shapes that entered a sensor
    std::vector<SensorEvent> sensor_end;               ///< shapes that left a sensor
    std::vector<JointBreakEvent> joint_broke;          ///< joints that broke
    std::vector<JointLoadEvent>
        joint_loaded;           ///< joints above their `report_force` or `report_torque`
    std::vector<BodyId> slept;  ///< bodies that fell asleep
    std::vector<BodyId> woke;   ///< bodies that woke
};

}  // namespace fettle::physics

FETTLE_PHYSICS_END
