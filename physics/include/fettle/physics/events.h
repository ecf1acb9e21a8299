#pragma once

#include <fettle/physics/export.h>
#include <fettle/physics/types.h>

#include <vector>

// Events of the last step and of the edits before it. Ids of destroyed objects are dangling on
// purpose: they can still be compared, so a listener knows which object was destroyed.

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

struct ContactBeginEvent {
    ShapeId shape_a;
    ShapeId shape_b;
    BodyId body_a;
    BodyId body_b;
    Vec2 point = {};           ///< world, m: middle of the manifold
    Vec2 normal = {};          ///< from a to b
    float speed = 0.0f;        ///< m/s, approach speed along the normal before the step
    float impulse = 0.0f;      ///< N s, the impulse that stops the approach and causes the bounce
    float friction = 0.0f;     ///< mixed
    float restitution = 0.0f;  ///< mixed

    ContactId id() const noexcept { return ContactId::of(shape_a, shape_b); }
};

struct ContactEndEvent {
    ShapeId shape_a;
    ShapeId shape_b;
    BodyId body_a;
    BodyId body_b;

    ContactId id() const noexcept { return ContactId::of(shape_a, shape_b); }
};

/// A continuing touch; only with `WorldDef::persist_events`.
struct ContactPersistEvent {
    ShapeId shape_a;
    ShapeId shape_b;
    BodyId body_a;
    BodyId body_b;
    Vec2 point = {};
    Vec2 normal = {};          ///< from a to b
    float speed = 0.0f;        ///< m/s, approach speed along the normal
    float impulse = 0.0f;      ///< N s, normal impulse of the last step
    float friction = 0.0f;     ///< mixed
    float restitution = 0.0f;  ///< mixed

    ContactId id() const noexcept { return ContactId::of(shape_a, shape_b); }
};

/// An impact, for shapes with `hit_events`.
struct ContactHitEvent {
    ShapeId shape_a;
    ShapeId shape_b;
    BodyId body_a;
    BodyId body_b;
    Vec2 point = {};
    Vec2 normal = {};          ///< from a to b
    float speed = 0.0f;        ///< m/s, approach speed along the normal
    float impulse = 0.0f;      ///< N s, the impulse that stopped the approach
    float friction = 0.0f;     ///< mixed
    float restitution = 0.0f;  ///< mixed

    ContactId id() const noexcept { return ContactId::of(shape_a, shape_b); }
};

struct SensorEvent {
    ShapeId sensor;
    ShapeId visitor;
    BodyId sensor_body;
    BodyId visitor_body;

    ContactId id() const noexcept { return ContactId::of(sensor, visitor); }
};

/// A joint had more load than its `break_force` or `break_torque`; it no longer acts
/// (`Joint::broken`).
struct JointBreakEvent {
    JointId joint;
    BodyId body_a;  ///< an invalid id means the world
    BodyId body_b;
    Vec2 force = {};      ///< N, on body b, mean over the step
    float torque = 0.0f;  ///< N m, on body b, without the torque of the force
};

/// A joint had more load in this step than its `report_force` or `report_torque`.
struct JointLoadEvent {
    JointId joint;
    BodyId body_a;  ///< an invalid id means the world
    BodyId body_b;
    Vec2 force = {};      ///< N, on body b, mean over the step
    float torque = 0.0f;  ///< N m, on body b, without the torque of the force
};

struct Events {
    std::vector<ContactBeginEvent> contact_begin;
    std::vector<ContactPersistEvent> contact_persist;
    std::vector<ContactEndEvent> contact_end;
    std::vector<ContactHitEvent> contact_hit;
    std::vector<SensorEvent> sensor_begin;
    std::vector<SensorEvent> sensor_end;
    std::vector<JointBreakEvent> joint_broke;
    std::vector<JointLoadEvent> joint_loaded;
    std::vector<BodyId> slept;
    std::vector<BodyId> woke;
};

}  // namespace fettle::physics

FETTLE_PHYSICS_END
