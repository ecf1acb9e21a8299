#pragma once

#include <step/finish.h>

// Impacts on the way. A body that moved farther than a contact reaches may have got into an
// obstacle, or through it. What comes through the air must not go beyond the point where a shape
// arrived at an obstacle. Of a body that lies, slides or rolls on something, only the core of a
// shape counts: the part that is deeper than half of its inner radius. Otherwise it would be
// stopped at every seam of a floor of many pieces.

namespace fettle::physics::detail {

/// How far a shape may follow its motion.
struct Impact {
    float time = 1.0f;  ///< from now to 1; 1: it meets nothing
    /// If the centroid of the shape is at the obstacle already: the displacement that keeps it from
    /// going farther. Zero otherwise.
    Vec2 back;
    /// From the obstacle to the shape at that time, in world axes, if one of the bodies is
    /// kinematic and they were beside each other before: the step solved their contact, so the
    /// shape may slide along the obstacle. Zero otherwise.
    Vec2 normal;
};

/// How far `shape` may follow its motion from `now` without passing through `obstacle`.
Impact time_of_impact(const FinishInput& in, uint32_t shape, const Motion& motion,
                      uint32_t obstacle, const Motion& obstacle_motion, float now);

/// A box around the shape on its way from `now` to 1.
Box4 swept_box(const FinishInput& in, uint32_t shape, const Motion& motion, float now);

/// Visits the shapes of a body that push others: all solid ones but sensors.
inline void for_each_pushing(const ObjectState& objects, uint32_t body, auto&& visit) {
    objects.for_each_solid_of(body, [&](uint32_t shape) {
        if (!objects.shapes[shape].surface.sensor) visit(shape);
    });
}

/// True if the filter of the user agrees. It is asked only about shapes that are no pair yet.
bool is_allowed(const FinishInput& in, uint32_t shape, uint32_t other);
/// False if the two shapes do not collide, or if their contact does not act.
bool may_meet(const FinishInput& in, uint32_t shape, uint32_t other);

/// Moves the body from the pose of its vertices to where its motion ends.
void follow_motion(const FinishInput& in, uint32_t body, const Motion& motion,
                   FinishedPiece& piece);

/// Removes the change of velocity that forces made in `share` of the step. The motion of a body
/// that an impact stops ends before the step does: the forces of the remaining time would add
/// energy for a distance that the body did not move. A body at its maximum speed keeps its
/// velocity, because the forces have not changed it.
void undo_forces(const FinishInput& in, uint32_t body, float share);
/// Shortens a velocity that an impact has changed to the maximum speed of the body and the world.
void limit_speed(const FinishInput& in, uint32_t body);

// fixed_obstacles.cpp

/// How far a body may follow its motion from `now` without passing through a fixed shape.
Impact time_of_impact_with_fixed(const FinishInput& in, uint32_t body, const Motion& motion,
                                 float now);

// continuous_collision_joints.cpp

/// Puts bodies back that have joints with a body that a fixed shape stopped.
void put_back_joined(const FinishInput& in);

// continuous_collision_moving.cpp

/// Stops bullets where they meet other moving bodies, and lets kinematic bodies carry other bodies
/// along.
void meet_moving_bodies(const FinishInput& in);

// kinematic_hits.cpp

/// Gives a body the velocity of one impact with a kinematic body beside it. Both have the poses of
/// the end of the step, and the states have the velocities at the impact.
void hit_by_kinematic(const FinishInput& in, uint32_t kinematic, uint32_t body);

// sensor_crossings.cpp

/// Reports the sensors that fast bodies moved through within the step.
void report_crossings(const FinishInput& in);

}  // namespace fettle::physics::detail
