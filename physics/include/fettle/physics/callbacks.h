#pragma once

#include <fettle/physics/export.h>
#include <fettle/physics/shape.h>

#include <functional>

// Functions of the user that the library calls: `PairFilter` and `ContactCallback` inside a step,
// between the narrow phase and the solver, in the order of the contacts; a filter also inside an
// edit that asks it anew; `QueryFilter::accept` (query.h) inside a query; `RefreshCallback` inside
// a read. All run on the caller's thread, one after the other. One of the shapes that they are told
// of may be of the world's border.
//
// **What such a function may do with the world that calls it:** call whatever is `const` (read
// bodies, shapes, joints and contacts, ask queries) and write the members of the `ContactEdit` that
// it is given, which hold for the step. In a step, positions and velocities are those before it.
//
// **What it may not do:** whatever edits, steps, restores, assigns or clears the world, and
// whatever replaces a callback. It throws `Locked`, which says what was called where, and changes
// nothing. Inside a step the state is incomplete: `World::save`, `World::validate` and copying
// throw `Locked` there too. What is to be changed is noted, and changed when the step or the query
// has returned. Other worlds are free: one may be edited, stepped and copied while another calls.
//
// **A function that throws** leaves a valid world. A query is left at once, and has changed
// nothing. A step or an edit goes on to its end as if the function had not been there for that pair
// or that contact (a filter that throws says yes), asks on, and then throws the first of what was
// thrown: the step has been made.
//
// **A function that destroys the World that calls it:** the call goes on without it to its end,
// calls back no more and throws `Locked`. From then on handles say that their world was destroyed.

FETTLE_PHYSICS_BEGIN

namespace fettle::physics {

/// A contact about to be solved.
struct ContactEdit {
    Shape shape_a;
    Shape shape_b;
    Vec2 point = Vec2::Zero();   ///< world, m: middle of the manifold, of the deepest part
    Vec2 normal = Vec2::Zero();  ///< from a to b
    float speed = 0.0f;          ///< m/s, of approach along the normal
    float impulse = 0.0f;        ///< N s, normal, that it had in the last step
    float separation = 0.0f;     ///< m, negative: overlap
    float friction = 0.0f;       ///< mixed; write it, 0 or more; NaN changes nothing
    float restitution = 0.0f;    ///< mixed; write it, 0 … 1
    float surface_speed = 0.0f;  ///< mixed; write it, m/s
    bool enabled = true;         ///< false: no contact in this step
};

/// Whether two shapes whose filters agree may collide.
using PairFilter = std::function<bool(const Shape& a, const Shape& b)>;
/// Sees every contact in every step. A chain or a concave polygon may touch another shape with
/// several of its convex parts, each with a manifold of its own. Surfaces may differ from place to
/// place: mixing is asked for each of the parts, with its point. Whether and how two shapes act on
/// each other is one question: before-solve is asked once for both, after the mixing, and told the
/// point, normal, speed, separation and surface of the deepest part and the impulse of all; what it
/// writes holds for all of them, what it leaves is what each part was mixed to.
using ContactCallback = std::function<void(ContactEdit&)>;

/// What a read brings up to date: all that was edited, or what is derived of one body or shape.
struct Refresh {
    enum class Of : uint8_t { everything, body, shape };
    Of of = Of::everything;
    uint32_t slot = 0;  ///< of the body or shape
};
using RefreshCallback = std::function<void(const Refresh&)>;

}  // namespace fettle::physics

FETTLE_PHYSICS_END
