/* Joints that drive or couple two bodies. A joint of another type is refused with FETTLE_INVALID.
 */

#pragma once

#include <fettle/physics_c/basics.h>

FETTLE_PHYSICS_C_BEGIN

/* --- motor joints --- */

/** m/s, of anchor b against anchor a, coordinates of a; finite. */
fettle_code fettle_motor_joint_linear_velocity(const fettle_world* world, fettle_id joint,
                                               fettle_vec2* linear_velocity);
fettle_code fettle_motor_joint_set_linear_velocity(fettle_world* world, fettle_id joint, float x,
                                                   float y);

/** Rad/s; finite. */
fettle_code fettle_motor_joint_angular_velocity(const fettle_world* world, fettle_id joint,
                                                float* angular_velocity);
fettle_code fettle_motor_joint_set_angular_velocity(fettle_world* world, fettle_id joint,
                                                    float angular_velocity);

/** N, from 0 (none, the default) to infinity. */
fettle_code fettle_motor_joint_max_force(const fettle_world* world, fettle_id joint,
                                         float* max_force);
fettle_code fettle_motor_joint_set_max_force(fettle_world* world, fettle_id joint, float max_force);

/** N m, from 0 (none, the default) to infinity. */
fettle_code fettle_motor_joint_max_torque(const fettle_world* world, fettle_id joint,
                                          float* max_torque);
fettle_code fettle_motor_joint_set_max_torque(fettle_world* world, fettle_id joint,
                                              float max_torque);

/** m, of anchor b from anchor a, coordinates of a, from -1e8 to 1e8. */
fettle_code fettle_motor_joint_linear_offset(const fettle_world* world, fettle_id joint,
                                             fettle_vec2* linear_offset);
fettle_code fettle_motor_joint_set_linear_offset(fettle_world* world, fettle_id joint, float x,
                                                 float y);

/** Rad, of b relative to a; finite. */
fettle_code fettle_motor_joint_angular_offset(const fettle_world* world, fettle_id joint,
                                              float* angular_offset);
fettle_code fettle_motor_joint_set_angular_offset(fettle_world* world, fettle_id joint,
                                                  float angular_offset);

/** Hz, stiffness to the offsets, from 0 (velocities only, the default). */
fettle_code fettle_motor_joint_hertz(const fettle_world* world, fettle_id joint, float* hertz);
fettle_code fettle_motor_joint_set_hertz(fettle_world* world, fettle_id joint, float hertz);

/** Finite, at least 0; 1 by default. */
fettle_code fettle_motor_joint_damping_ratio(const fettle_world* world, fettle_id joint,
                                             float* damping_ratio);
fettle_code fettle_motor_joint_set_damping_ratio(fettle_world* world, fettle_id joint,
                                                 float damping_ratio);

/* --- pulley joints --- */

/** The wheel above a; world, m, from -1e8 to 1e8. */
fettle_code fettle_pulley_joint_ground_a(const fettle_world* world, fettle_id joint,
                                         fettle_position* ground_a);
fettle_code fettle_pulley_joint_set_ground_a(fettle_world* world, fettle_id joint,
                                             fettle_coordinate x, fettle_coordinate y);

/** The wheel above b; world, m, from -1e8 to 1e8. */
fettle_code fettle_pulley_joint_ground_b(const fettle_world* world, fettle_id joint,
                                         fettle_position* ground_b);
fettle_code fettle_pulley_joint_set_ground_b(fettle_world* world, fettle_id joint,
                                             fettle_coordinate x, fettle_coordinate y);

/** Force on b divided by the force on a, from 0.001 to 1000. */
fettle_code fettle_pulley_joint_ratio(const fettle_world* world, fettle_id joint, float* ratio);
fettle_code fettle_pulley_joint_set_ratio(fettle_world* world, fettle_id joint, float ratio);

/** m, of the part at a plus ratio times the part at b; finite, at least 0. */
fettle_code fettle_pulley_joint_length(const fettle_world* world, fettle_id joint, float* length);
fettle_code fettle_pulley_joint_set_length(fettle_world* world, fettle_id joint, float length);

/** m, of the rope between both bodies; equals length when it is taut. */
fettle_code fettle_pulley_joint_length_now(const fettle_world* world, fettle_id joint,
                                           float* length_now);

/** m, from wheel to anchor a now. */
fettle_code fettle_pulley_joint_length_a(const fettle_world* world, fettle_id joint,
                                         float* length_a);

/** m, from wheel to anchor b now. */
fettle_code fettle_pulley_joint_length_b(const fettle_world* world, fettle_id joint,
                                         float* length_b);

/** N, in the last step. */
fettle_code fettle_pulley_joint_tension(const fettle_world* world, fettle_id joint, float* tension);

/* --- gear joints --- */

/** Rotation of b divided by that of a; finite. Negative for meshed wheels. */
fettle_code fettle_gear_joint_ratio(const fettle_world* world, fettle_id joint, float* ratio);
fettle_code fettle_gear_joint_set_ratio(fettle_world* world, fettle_id joint, float ratio);

/** Rad: angle of b minus ratio times the angle of a; finite. */
fettle_code fettle_gear_joint_phase(const fettle_world* world, fettle_id joint, float* phase);
fettle_code fettle_gear_joint_set_phase(fettle_world* world, fettle_id joint, float phase);

/** Rad, of the current angles. */
fettle_code fettle_gear_joint_phase_now(const fettle_world* world, fettle_id joint,
                                        float* phase_now);

/* --- ratchet joints --- */

/** Rad, of b relative to a, minus the reference angle; not wrapped. */
fettle_code fettle_ratchet_joint_angle(const fettle_world* world, fettle_id joint, float* angle);

/** Rad; finite. */
fettle_code fettle_ratchet_joint_reference_angle(const fettle_world* world, fettle_id joint,
                                                 float* reference_angle);
fettle_code fettle_ratchet_joint_set_reference_angle(fettle_world* world, fettle_id joint,
                                                     float reference_angle);

/** Rad between teeth, finite, at least 0 (the default: it holds at any angle). */
fettle_code fettle_ratchet_joint_tooth(const fettle_world* world, fettle_id joint, float* tooth);
fettle_code fettle_ratchet_joint_set_tooth(fettle_world* world, fettle_id joint, float tooth);

/** Whether b rotates freely clockwise instead of counter-clockwise. */
fettle_code fettle_ratchet_joint_backwards(const fettle_world* world, fettle_id joint,
                                           bool* backwards);
fettle_code fettle_ratchet_joint_set_backwards(fettle_world* world, fettle_id joint,
                                               bool backwards);

/** Rad: b does not rotate back beyond it. */
fettle_code fettle_ratchet_joint_caught_angle(const fettle_world* world, fettle_id joint,
                                              float* caught_angle);

/* --- rotary limit joints --- */

/** Rad, of b relative to a, minus the reference angle; not wrapped. */
fettle_code fettle_rotary_limit_joint_angle(const fettle_world* world, fettle_id joint,
                                            float* angle);

/** Rad; finite. */
fettle_code fettle_rotary_limit_joint_reference_angle(const fettle_world* world, fettle_id joint,
                                                      float* reference_angle);
fettle_code fettle_rotary_limit_joint_set_reference_angle(fettle_world* world, fettle_id joint,
                                                          float reference_angle);

/** Rad, from -infinity (no limit, the default). */
fettle_code fettle_rotary_limit_joint_lower_angle(const fettle_world* world, fettle_id joint,
                                                  float* lower_angle);
fettle_code fettle_rotary_limit_joint_set_lower_angle(fettle_world* world, fettle_id joint,
                                                      float lower_angle);

/** Rad, to infinity (no limit, the default). It wins over lower_angle. */
fettle_code fettle_rotary_limit_joint_upper_angle(const fettle_world* world, fettle_id joint,
                                                  float* upper_angle);
fettle_code fettle_rotary_limit_joint_set_upper_angle(fettle_world* world, fettle_id joint,
                                                      float upper_angle);

FETTLE_PHYSICS_C_END
