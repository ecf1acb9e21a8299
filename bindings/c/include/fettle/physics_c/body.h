/* Bodies. A body is named by its world and its id. Errors are those of basics.h; each function says
 * what it refuses beyond them. A setter takes effect in the next step and wakes the bodies that it
 * affects. */

#pragma once

#include <fettle/physics_c/contact.h>
#include <fettle/physics_c/definitions.h>

FETTLE_PHYSICS_C_BEGIN

/** Whether the id is that of a live body of this world; false for null and for any other value. */
bool fettle_body_is_valid(const fettle_world* world, fettle_id body);

/** Destroys the body with its shapes and the joints on it. */
fettle_code fettle_body_destroy(fettle_world* world, fettle_id body);

/** One of fettle_body_type. */
fettle_code fettle_body_type(const fettle_world* world, fettle_id body, int32_t* type);
fettle_code fettle_body_set_type(fettle_world* world, fettle_id body, int32_t type);

/** Of the origin, m, world; coordinates from -1e8 to 1e8. The setter teleports. */
fettle_code fettle_body_position(const fettle_world* world, fettle_id body,
                                 fettle_position* position);
fettle_code fettle_body_set_position(fettle_world* world, fettle_id body, fettle_coordinate x,
                                     fettle_coordinate y);

/** Rad, counter-clockwise, not wrapped; from -1e8 to 1e8. The setter teleports. */
fettle_code fettle_body_angle(const fettle_world* world, fettle_id body, float* angle);
fettle_code fettle_body_set_angle(fettle_world* world, fettle_id body, float angle);

/** Sets position (m) and angle (rad) in one teleport; ranges as for position and angle. */
fettle_code fettle_body_set_pose(fettle_world* world, fettle_id body, fettle_coordinate x,
                                 fettle_coordinate y, float angle);

/** Of the center of mass, m/s; finite. A step limits it to 10 000 m/s. A static or infinitely
    heavy body has none, and setting one has no effect. */
fettle_code fettle_body_velocity(const fettle_world* world, fettle_id body, fettle_vec2* velocity);
fettle_code fettle_body_set_velocity(fettle_world* world, fettle_id body, float x, float y);

/** Rad/s; finite. A step limits it to 3 rad in each sub-step. No effect on bodies on which a
    velocity has none. */
fettle_code fettle_body_angular_velocity(const fettle_world* world, fettle_id body,
                                         float* angular_velocity);
fettle_code fettle_body_set_angular_velocity(fettle_world* world, fettle_id body,
                                             float angular_velocity);

/** Sets both velocities so that steps of `dt` s in all bring it to the pose, if nothing disturbs
   it: to be called before each step for a platform that follows a path. The angle is not wrapped.
 */
fettle_code fettle_body_set_target(fettle_world* world, fettle_id body, fettle_coordinate x,
                                   fettle_coordinate y, float angle, float dt);

/** N, applied at the center of mass in every step until changed; finite. */
fettle_code fettle_body_force(const fettle_world* world, fettle_id body, fettle_vec2* force);
fettle_code fettle_body_set_force(fettle_world* world, fettle_id body, float x, float y);

/** N m, applied in every step until changed; finite. */
fettle_code fettle_body_torque(const fettle_world* world, fettle_id body, float* torque);
fettle_code fettle_body_set_torque(fettle_world* world, fettle_id body, float torque);

/** Adds a force (N, finite) at the center of mass, for the next step only. */
fettle_code fettle_body_apply_force(fettle_world* world, fettle_id body, float x, float y);

/** Adds a force (N, finite) at a point of the world (m, finite), for the next step only. */
fettle_code fettle_body_apply_force_at(fettle_world* world, fettle_id body, float x, float y,
                                       fettle_coordinate at_x, fettle_coordinate at_y);

/** Adds an impulse (N s, finite) at the center of mass: changes the velocity at once. */
fettle_code fettle_body_apply_impulse(fettle_world* world, fettle_id body, float x, float y);

/** Adds an impulse (N s, finite) at a point of the world (m, finite): changes both velocities at
    once. */
fettle_code fettle_body_apply_impulse_at(fettle_world* world, fettle_id body, float x, float y,
                                         fettle_coordinate at_x, fettle_coordinate at_y);

/** Adds a torque (N m, finite) for the next step only. */
fettle_code fettle_body_apply_torque(fettle_world* world, fettle_id body, float torque);

/** Adds an angular impulse (N m s, finite): changes the angular velocity at once. */
fettle_code fettle_body_apply_angular_impulse(fettle_world* world, fettle_id body, float impulse);

/** N: sum of the forces applied for the next step. */
fettle_code fettle_body_applied_force(const fettle_world* world, fettle_id body,
                                      fettle_vec2* applied_force);

/** N m, about the center of mass: sum of the torques applied for the next step, and of the forces
    beside the center. */
fettle_code fettle_body_applied_torque(const fettle_world* world, fettle_id body,
                                       float* applied_torque);

/** Factor of the gravity of the world; finite. */
fettle_code fettle_body_gravity_scale(const fettle_world* world, fettle_id body,
                                      float* gravity_scale);
fettle_code fettle_body_set_gravity_scale(fettle_world* world, fettle_id body, float gravity_scale);

/** 1/s; finite, at least 0. */
fettle_code fettle_body_linear_damping(const fettle_world* world, fettle_id body,
                                       float* linear_damping);
fettle_code fettle_body_set_linear_damping(fettle_world* world, fettle_id body,
                                           float linear_damping);

/** 1/s; finite, at least 0. */
fettle_code fettle_body_angular_damping(const fettle_world* world, fettle_id body,
                                        float* angular_damping);
fettle_code fettle_body_set_angular_damping(fettle_world* world, fettle_id body,
                                            float angular_damping);

/** False: it takes no part in steps, touches nothing, is found by no query, and its joints do not
    act. It keeps its shapes, joints and velocity. */
fettle_code fettle_body_enabled(const fettle_world* world, fettle_id body, bool* enabled);
fettle_code fettle_body_set_enabled(fettle_world* world, fettle_id body, bool enabled);

/** For messages and tools, at most 63 bytes; empty at first. The text that is read is valid until
    the next name of this world is read, or until the world is destroyed. */
fettle_code fettle_body_name(fettle_world* world, fettle_id body, const char** name);
fettle_code fettle_body_set_name(fettle_world* world, fettle_id body, const char* name);

/** Limit of the speed, m/s, above 0; infinity: only that of all bodies. As locked axes, it also
    holds for the velocity that a kinematic body was given. */
fettle_code fettle_body_max_speed(const fettle_world* world, fettle_id body, float* max_speed);
fettle_code fettle_body_set_max_speed(fettle_world* world, fettle_id body, float max_speed);

/** It rests below this speed, m/s: its own value, or that of the world. */
fettle_code fettle_body_sleep_speed(const fettle_world* world, fettle_id body, float* sleep_speed);

/** Its own value, m/s, at least 0. Null: that of the world. */
fettle_code fettle_body_set_sleep_speed(fettle_world* world, fettle_id body,
                                        const float* sleep_speed);

/** Whether it has its own value, and which (0 if it has not). */
fettle_code fettle_body_sleep_speed_override(const fettle_world* world, fettle_id body,
                                             bool* is_set, float* sleep_speed);

/** Whether a step moves the body. The setter wakes it, or lets it sleep, with its whole island. */
fettle_code fettle_body_awake(const fettle_world* world, fettle_id body, bool* awake);
fettle_code fettle_body_set_awake(fettle_world* world, fettle_id body, bool awake);

/** Whether the body may fall asleep; false wakes it. */
fettle_code fettle_body_can_sleep(const fettle_world* world, fettle_id body, bool* can_sleep);
fettle_code fettle_body_set_can_sleep(fettle_world* world, fettle_id body, bool can_sleep);

/** Whether continuous collision is made with moving bodies, too. */
fettle_code fettle_body_bullet(const fettle_world* world, fettle_id body, bool* bullet);
fettle_code fettle_body_set_bullet(fettle_world* world, fettle_id body, bool bullet);

/** Whether the body cannot move along x. */
fettle_code fettle_body_locked_x(const fettle_world* world, fettle_id body, bool* locked_x);
fettle_code fettle_body_set_locked_x(fettle_world* world, fettle_id body, bool locked_x);

/** Whether the body cannot move along y. */
fettle_code fettle_body_locked_y(const fettle_world* world, fettle_id body, bool* locked_y);
fettle_code fettle_body_set_locked_y(fettle_world* world, fettle_id body, bool locked_y);

/** Whether the body cannot rotate. */
fettle_code fettle_body_locked_rotation(const fettle_world* world, fettle_id body,
                                        bool* locked_rotation);
fettle_code fettle_body_set_locked_rotation(fettle_world* world, fettle_id body,
                                            bool locked_rotation);

/** Mass in use, kg: the override if there is one, otherwise the sum over its shapes; a dynamic
    body whose shapes have no mass has mass 1 and does not rotate. */
fettle_code fettle_body_mass(const fettle_world* world, fettle_id body, float* mass);

/** Overrides the mass, kg; above 0, infinity: does not move. Null: from the shapes again. */
fettle_code fettle_body_set_mass(fettle_world* world, fettle_id body, const float* mass);

/** Whether the mass is overridden, and by which value (kg; 0 if it is not). */
fettle_code fettle_body_mass_override(const fettle_world* world, fettle_id body, bool* is_set,
                                      float* mass);

/** Inertia in use, kg m2: the override if there is one, otherwise about the center of mass, of
    its shapes. */
fettle_code fettle_body_inertia(const fettle_world* world, fettle_id body, float* inertia);

/** Overrides the inertia, kg m2; above 0, infinity: does not rotate. Null: from the shapes again.
 */
fettle_code fettle_body_set_inertia(fettle_world* world, fettle_id body, const float* inertia);

/** Whether the inertia is overridden, and by which value (kg m2; 0 if it is not). */
fettle_code fettle_body_inertia_override(const fettle_world* world, fettle_id body, bool* is_set,
                                         float* inertia);

/** Center of mass, body coordinates, m: the override if there is one, otherwise from the shapes.
    That of a kinematic body is its origin: it turns about its position. */
fettle_code fettle_body_center(const fettle_world* world, fettle_id body, fettle_vec2* center);

/** Overrides the center of mass, body coordinates, m; from -1e8 to 1e8. Null: from the shapes
    again. */
fettle_code fettle_body_set_center(fettle_world* world, fettle_id body, const fettle_vec2* center);

/** Whether the center of mass is overridden, and by which point (zero if it is not). */
fettle_code fettle_body_center_override(const fettle_world* world, fettle_id body, bool* is_set,
                                        fettle_vec2* center);

/** Center of mass, world, m. */
fettle_code fettle_body_world_center(const fettle_world* world, fettle_id body,
                                     fettle_position* world_center);

/** Sum over the shapes, m2. */
fettle_code fettle_body_area(const fettle_world* world, fettle_id body, float* area);

/** Box around all shapes, world, m; the origin of the body if it has none. */
fettle_code fettle_body_aabb(const fettle_world* world, fettle_id body, fettle_aabb* aabb);

/** How often mass, center and inertia were computed again. */
fettle_code fettle_body_rebuilds(const fettle_world* world, fettle_id body, uint32_t* rebuilds);

/** Pose before the last step, for drawing between steps. A teleport changes it too. */
fettle_code fettle_body_previous_pose(const fettle_world* world, fettle_id body,
                                      fettle_pose* previous_pose);

/** Pose at a fraction of the last step: 0 gives the previous pose, 1 the current one; finite. */
fettle_code fettle_body_interpolated(const fettle_world* world, fettle_id body, float fraction,
                                     fettle_pose* pose);

/** Body coordinates (m) to the world. Coordinates are finite. */
fettle_code fettle_body_world_point(const fettle_world* world, fettle_id body, float x, float y,
                                    fettle_position* out);

/** World coordinates (m) to those of the body. Coordinates are finite. */
fettle_code fettle_body_local_point(const fettle_world* world, fettle_id body, fettle_coordinate x,
                                    fettle_coordinate y, fettle_vec2* out);

/** Direction in body coordinates to the world. Coordinates are finite. */
fettle_code fettle_body_world_vector(const fettle_world* world, fettle_id body, float x, float y,
                                     fettle_vec2* out);

/** Direction in the world to body coordinates. Coordinates are finite. */
fettle_code fettle_body_local_vector(const fettle_world* world, fettle_id body, float x, float y,
                                     fettle_vec2* out);

/** Velocity (m/s) of the point of the body that is at a point of the world (m). Coordinates are
    finite. */
fettle_code fettle_body_velocity_at(const fettle_world* world, fettle_id body, fettle_coordinate x,
                                    fettle_coordinate y, fettle_vec2* out);

/** J. */
fettle_code fettle_body_kinetic_energy(const fettle_world* world, fettle_id body,
                                       float* kinetic_energy);

/** Attaches a new shape. A null def stands for the defaults; shape may be null. Refuses what
    definitions.h does. */
fettle_code fettle_body_add(fettle_world* world, fettle_id body, const fettle_geometry* geometry,
                            const fettle_shape_def* def, fettle_id* shape);

/** Number of shapes. */
fettle_code fettle_body_shape_count(const fettle_world* world, fettle_id body,
                                    uint32_t* shape_count);

/** Ids of its shapes, in the order in which they were attached. A list: see basics.h. */
fettle_code fettle_body_shapes(const fettle_world* world, fettle_id body, fettle_id* out,
                               uint32_t room, uint32_t* count);

/** Ids of the joints on it, in no particular order. A list: see basics.h. */
fettle_code fettle_body_joints(const fettle_world* world, fettle_id body, fettle_id* out,
                               uint32_t room, uint32_t* count);

/** Whether there is any contact, sleeping or not; sensors do not count. */
fettle_code fettle_body_is_touching(const fettle_world* world, fettle_id body, bool* is_touching);

/** Touching contacts of the last step, sleeping ones included. A list: see basics.h. */
fettle_code fettle_body_contacts(const fettle_world* world, fettle_id body, fettle_contact* out,
                                 uint32_t room, uint32_t* count);

/** Any number of the host's. It is part of snapshots. */
fettle_code fettle_body_user_data(const fettle_world* world, fettle_id body, uint64_t* user_data);
fettle_code fettle_body_set_user_data(fettle_world* world, fettle_id body, uint64_t user_data);

FETTLE_PHYSICS_C_END
