/* Joints that drag, tie or hold two bodies. A joint of another type is refused with FETTLE_INVALID.
 */

#pragma once

#include <fettle/physics_c/basics.h>

FETTLE_PHYSICS_C_BEGIN

/* --- mouse joints: drag a point of a body softly towards a target --- */

/** The body that is dragged. The setter keeps the anchor and refuses 0. */
fettle_code fettle_mouse_joint_body(const fettle_world* world, fettle_id joint, fettle_id* body);
fettle_code fettle_mouse_joint_set_body(fettle_world* world, fettle_id joint, fettle_id body);

/** Body coordinates, m, from -1e8 to 1e8. */
fettle_code fettle_mouse_joint_anchor(const fettle_world* world, fettle_id joint,
                                      fettle_position* anchor);
fettle_code fettle_mouse_joint_set_anchor(fettle_world* world, fettle_id joint, fettle_coordinate x,
                                          fettle_coordinate y);

/** World, m, from -1e8 to 1e8. */
fettle_code fettle_mouse_joint_target(const fettle_world* world, fettle_id joint,
                                      fettle_position* target);
fettle_code fettle_mouse_joint_set_target(fettle_world* world, fettle_id joint, fettle_coordinate x,
                                          fettle_coordinate y);

/** Stiffness, Hz, from 0 to infinity. */
fettle_code fettle_mouse_joint_hertz(const fettle_world* world, fettle_id joint, float* hertz);
fettle_code fettle_mouse_joint_set_hertz(fettle_world* world, fettle_id joint, float hertz);

/** At least 0; 1 comes to rest without swinging. */
fettle_code fettle_mouse_joint_damping_ratio(const fettle_world* world, fettle_id joint,
                                             float* damping_ratio);
fettle_code fettle_mouse_joint_set_damping_ratio(fettle_world* world, fettle_id joint,
                                                 float damping_ratio);

/** N, from 0 to infinity. */
fettle_code fettle_mouse_joint_max_force(const fettle_world* world, fettle_id joint,
                                         float* max_force);
fettle_code fettle_mouse_joint_set_max_force(fettle_world* world, fettle_id joint, float max_force);

/* --- distance joints --- */

/** m, of the rod, or of the spring at rest; finite, at least 0. */
fettle_code fettle_distance_joint_length(const fettle_world* world, fettle_id joint, float* length);
fettle_code fettle_distance_joint_set_length(fettle_world* world, fettle_id joint, float length);

/** m; finite, at least 0. Above max_length, that is used instead. */
fettle_code fettle_distance_joint_min_length(const fettle_world* world, fettle_id joint,
                                             float* min_length);
fettle_code fettle_distance_joint_set_min_length(fettle_world* world, fettle_id joint,
                                                 float min_length);

/** m, from 0 to infinity (no limit). */
fettle_code fettle_distance_joint_max_length(const fettle_world* world, fettle_id joint,
                                             float* max_length);
fettle_code fettle_distance_joint_set_max_length(fettle_world* world, fettle_id joint,
                                                 float max_length);

/** Hz, from 0 (slack between the limits) to infinity (a rod, the default). */
fettle_code fettle_distance_joint_hertz(const fettle_world* world, fettle_id joint, float* hertz);
fettle_code fettle_distance_joint_set_hertz(fettle_world* world, fettle_id joint, float hertz);

/** Of the spring; finite, at least 0. */
fettle_code fettle_distance_joint_damping_ratio(const fettle_world* world, fettle_id joint,
                                                float* damping_ratio);
fettle_code fettle_distance_joint_set_damping_ratio(fettle_world* world, fettle_id joint,
                                                    float damping_ratio);

/** N, from -infinity (the default) to 0: the spring does not pull with more. */
fettle_code fettle_distance_joint_lower_spring_force(const fettle_world* world, fettle_id joint,
                                                     float* lower_spring_force);
fettle_code fettle_distance_joint_set_lower_spring_force(fettle_world* world, fettle_id joint,
                                                         float lower_spring_force);

/** N, from 0 to infinity (the default): the spring does not push with more. */
fettle_code fettle_distance_joint_upper_spring_force(const fettle_world* world, fettle_id joint,
                                                     float* upper_spring_force);
fettle_code fettle_distance_joint_set_upper_spring_force(fettle_world* world, fettle_id joint,
                                                         float upper_spring_force);

/** m/s, of the distance; finite. A rod has no motor. */
fettle_code fettle_distance_joint_motor_speed(const fettle_world* world, fettle_id joint,
                                              float* motor_speed);
fettle_code fettle_distance_joint_set_motor_speed(fettle_world* world, fettle_id joint,
                                                  float motor_speed);

/** N, from 0 (no motor, the default) to infinity. */
fettle_code fettle_distance_joint_max_motor_force(const fettle_world* world, fettle_id joint,
                                                  float* max_motor_force);
fettle_code fettle_distance_joint_set_max_motor_force(fettle_world* world, fettle_id joint,
                                                      float max_motor_force);

/** N, of the motor in the last step; positive pushes apart. */
fettle_code fettle_distance_joint_motor_force(const fettle_world* world, fettle_id joint,
                                              float* motor_force);

/** m, between the anchors now. */
fettle_code fettle_distance_joint_distance(const fettle_world* world, fettle_id joint,
                                           float* distance);

/* --- revolute joints --- */

/** Rad, of b relative to a, minus the reference angle; not wrapped. */
fettle_code fettle_revolute_joint_angle(const fettle_world* world, fettle_id joint, float* angle);

/** Rad; finite. */
fettle_code fettle_revolute_joint_reference_angle(const fettle_world* world, fettle_id joint,
                                                  float* reference_angle);
fettle_code fettle_revolute_joint_set_reference_angle(fettle_world* world, fettle_id joint,
                                                      float reference_angle);

/** Rad; minus infinity (the default): no limit. */
fettle_code fettle_revolute_joint_lower_angle(const fettle_world* world, fettle_id joint,
                                              float* lower_angle);
fettle_code fettle_revolute_joint_set_lower_angle(fettle_world* world, fettle_id joint,
                                                  float lower_angle);

/** Rad; infinity (the default): no limit. It wins over the lower one. */
fettle_code fettle_revolute_joint_upper_angle(const fettle_world* world, fettle_id joint,
                                              float* upper_angle);
fettle_code fettle_revolute_joint_set_upper_angle(fettle_world* world, fettle_id joint,
                                                  float upper_angle);

/** Rad/s, of b relative to a; finite. */
fettle_code fettle_revolute_joint_motor_speed(const fettle_world* world, fettle_id joint,
                                              float* motor_speed);
fettle_code fettle_revolute_joint_set_motor_speed(fettle_world* world, fettle_id joint,
                                                  float motor_speed);

/** N m, from 0 (no motor, the default) to infinity. */
fettle_code fettle_revolute_joint_max_motor_torque(const fettle_world* world, fettle_id joint,
                                                   float* max_motor_torque);
fettle_code fettle_revolute_joint_set_max_motor_torque(fettle_world* world, fettle_id joint,
                                                       float max_motor_torque);

/** Hz, of a spring towards target_angle, from 0 (none, the default). */
fettle_code fettle_revolute_joint_hertz(const fettle_world* world, fettle_id joint, float* hertz);
fettle_code fettle_revolute_joint_set_hertz(fettle_world* world, fettle_id joint, float hertz);

/** Of the spring; finite, at least 0. */
fettle_code fettle_revolute_joint_damping_ratio(const fettle_world* world, fettle_id joint,
                                                float* damping_ratio);
fettle_code fettle_revolute_joint_set_damping_ratio(fettle_world* world, fettle_id joint,
                                                    float damping_ratio);

/** Rad; finite. */
fettle_code fettle_revolute_joint_target_angle(const fettle_world* world, fettle_id joint,
                                               float* target_angle);
fettle_code fettle_revolute_joint_set_target_angle(fettle_world* world, fettle_id joint,
                                                   float target_angle);

/** N m, of the motor in the last step. */
fettle_code fettle_revolute_joint_motor_torque(const fettle_world* world, fettle_id joint,
                                               float* motor_torque);

/* --- weld joints --- */

/** Rad, of b relative to a, minus the reference angle: held at 0. Whole turns do not count, so it
 * is within half a turn. */
fettle_code fettle_weld_joint_angle(const fettle_world* world, fettle_id joint, float* angle);

/** Rad; finite. */
fettle_code fettle_weld_joint_reference_angle(const fettle_world* world, fettle_id joint,
                                              float* reference_angle);
fettle_code fettle_weld_joint_set_reference_angle(fettle_world* world, fettle_id joint,
                                                  float reference_angle);

/** Hz, stiffness at the point, from 0 (not held) to infinity (rigid, the default). */
fettle_code fettle_weld_joint_hertz(const fettle_world* world, fettle_id joint, float* hertz);
fettle_code fettle_weld_joint_set_hertz(fettle_world* world, fettle_id joint, float hertz);

/** At the point; finite, at least 0. */
fettle_code fettle_weld_joint_damping_ratio(const fettle_world* world, fettle_id joint,
                                            float* damping_ratio);
fettle_code fettle_weld_joint_set_damping_ratio(fettle_world* world, fettle_id joint,
                                                float damping_ratio);

/** Hz, stiffness of the angle, from 0 (free) to infinity (rigid, the default). */
fettle_code fettle_weld_joint_angular_hertz(const fettle_world* world, fettle_id joint,
                                            float* angular_hertz);
fettle_code fettle_weld_joint_set_angular_hertz(fettle_world* world, fettle_id joint,
                                                float angular_hertz);

/** Of the angle; finite, at least 0. */
fettle_code fettle_weld_joint_angular_damping_ratio(const fettle_world* world, fettle_id joint,
                                                    float* angular_damping_ratio);
fettle_code fettle_weld_joint_set_angular_damping_ratio(fettle_world* world, fettle_id joint,
                                                        float angular_damping_ratio);

FETTLE_PHYSICS_C_END
