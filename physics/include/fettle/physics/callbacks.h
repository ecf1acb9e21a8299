#pragma once

#include <fettle/physics/export.h>
#include <fettle/physics/function.h>
#include <fettle/physics/shape.h>

#include <cstddef>
#include <span>

// User functions that the library calls. `PairFilter` and `ContactCallback` are called inside a
// step, between the narrow phase and the solver, in the order of the contacts; a filter is also
// called inside an edit that requires it. `VelocityFunction` is called after them, and
// `PositionFunction` at the end of the step, for one body after the other in slot order.
// `QueryFilter::accept` and a `Visitor` (query.h) are called inside a query, `RefreshCallback`
// (host_access.h) inside a read. All run on the caller's thread, one after the other, unless
// `World::set_parallel_callbacks` says otherwise. One of the shapes that they get may belong to the
// world's border.
//
// **What such a function may do with the world that calls it:** call all `const` methods (read
// bodies, shapes, joints and contacts, make queries) and write the members of the `ContactEdit`
// that it gets; these are valid for the step. In a step, positions and velocities are those before
// it.
//
// **What it may not do:** call methods that edit, step, restore, move or clear the world, or that
// replace a callback. They throw `Locked`, with a message that names both calls, and change
// nothing. Inside a step the state is incomplete, so `World::save`, `World::validate` and
// `World::clone` throw `Locked` there, too. Instead, give the edit to `World::after_step`, or
// make it after the query. Other worlds are not affected: one may be edited, stepped and copied
// while another calls.
//
// **A function that throws** leaves a valid world. A query ends at once and has changed nothing. A
// step or an edit continues to its end as if the function did not exist for that pair, contact or
// body (a filter that throws counts as true), calls the function for the others, and then throws
// the first exception; the step is complete.
//
// **A function that destroys the World that calls it:** the call continues to its end, calls no
// more callbacks and throws `Locked`. From then on handles report that their world was destroyed.

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

/// A contact about to be solved.
struct ContactEdit {
    Shape shape_a;               ///< the normal points away from it
    Shape shape_b;               ///< the normal points towards it
    Position point = {};         ///< world, m: middle of the manifold of the deepest part
    Vec2 normal = {};            ///< from a to b
    float speed = 0.0f;          ///< m/s, approach speed along the normal
    float impulse = 0.0f;        ///< N s, normal impulse of the last step
    float separation = 0.0f;     ///< m, negative when the shapes overlap
    float friction = 0.0f;       ///< mixed; may be set to 0 or more; NaN changes nothing
    float restitution = 0.0f;    ///< mixed; may be set, 0 … 1
    float surface_speed = 0.0f;  ///< mixed; may be set, m/s
    bool enabled = true;         ///< false: no contact in this step
    bool ignored = false;        ///< true: no contact until the shapes have separated
    uint32_t part_a = 0;         ///< segment or piece of `shape_a`, as in `Contact`
    uint32_t part_b = 0;         ///< the same of `shape_b`
    uint32_t material_a = 0;     ///< at `shape_a`, as in `Contact`
    uint32_t material_b = 0;     ///< at `shape_b`
};

/// The motion of a body in a step, before contacts and joints act: for
/// `Body::set_velocity_function`.
struct VelocityEdit {
    Body body = {};               ///< the body whose function is called
    float dt = 0.0f;              ///< s, length of the step
    Vec2 before = {};             ///< m/s, before the step
    float angular_before = 0.0f;  ///< rad/s
    /// m/s at the end of the step by gravity, forces, fields and damping; may be set. The change
    /// is spread evenly over the sub-steps, so that the body rests on others as under a force.
    /// Locked axes and the maximum speed hold after it. NaN changes nothing.
    Vec2 velocity = {};
    float angular_velocity = 0.0f;  ///< rad/s, the same
};

/// The pose of a body at the end of a step: for `Body::set_position_function`.
struct PositionEdit {
    Body body = {};    ///< the body whose function is called
    float dt = 0.0f;   ///< s, length of the step
    Pose before = {};  ///< before the step
    /// After the step; may be set. It is limited like all poses; NaN changes nothing. Setting it
    /// wakes what touches the body, as `Body::set_pose` does, and leaves `Body::previous_pose` as
    /// it is. Velocities do not change.
    Pose pose = {};
};

/// True if two shapes whose filters agree may collide.
using PairFilter = Function<bool(const Shape& a, const Shape& b)>;
/// Called for every contact in every step. A chain or a concave polygon may touch another shape
/// with several of its convex parts, each with a manifold of its own. Surfaces may differ from
/// place to place, so the mixing callback is called for each part, with its point. Whether and how
/// two shapes act on each other is one decision, so before-solve is called once for both shapes,
/// after the mixing. It gets the point, normal, speed, separation and surface of the deepest part,
/// and the sum of the impulses of all parts in the step before. A value that it sets is used for
/// all parts; otherwise each part keeps its mixed value.
using ContactCallback = Function<void(ContactEdit&)>;

/// Takes the next bytes of a recording: `World::start_recording`. The bytes live for the call.
using RecordingSink = Function<void(std::span<const std::byte>)>;

}  // namespace fettle::physics

FETTLE_PHYSICS_END
