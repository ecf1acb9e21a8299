/* Joints between a point of body b and a line on body a. A joint of another type is refused with
 * FETTLE_INVALID. */

#pragma once

#include <fettle/physics_c/basics.h>

FETTLE_PHYSICS_C_BEGIN

/* --- prismatic joints --- */

/** Direction in the coordinates of a, of any length but 0. */
fettle_code fettle_prismatic_joint_axis(const fettle_world* world, fettle_id joint,
                                        fettle_vec2* axis);
fettle_code fettle_prismatic_joint_set_axis(fettle_world* world, fettle_id joint, float x, float y);

/** m, of anchor b from anchor a along the axis now. */
fettle_code fettle_prismatic_joint_translation(const fettle_world* world, fettle_id joint,
                                               float* translation);

/** m; minus infinity: no limit. */
fettle_code fettle_prismatic_joint_lower_translation(const fettle_world* world, fettle_id joint,
                                                     float* lower_translation);
fettle_code fettle_prismatic_joint_set_lower_translation(fettle_world* world, fettle_id joint,
                                                         float lower_translation);

/** m; infinity: no limit. It wins over the lower one. */
fettle_code fettle_prismatic_joint_upper_translation(const fettle_world* world, fettle_id joint,
                                                     float* upper_translation);
fettle_code fettle_prismatic_joint_set_upper_translation(fettle_world* world, fettle_id joint,
                                                         float upper_translation);

/** m/s, of b relative to a along the axis; finite. */
fettle_code fettle_prismatic_joint_motor_speed(const fettle_world* world, fettle_id joint,
                                               float* motor_speed);
fettle_code fettle_prismatic_joint_set_motor_speed(fettle_world* world, fettle_id joint,
                                                   float motor_speed);

/** N, from 0 (no motor, the default) to infinity. */
fettle_code fettle_prismatic_joint_max_motor_force(const fettle_world* world, fettle_id joint,
                                                   float* max_motor_force);
fettle_code fettle_prismatic_joint_set_max_motor_force(fettle_world* world, fettle_id joint,
                                                       float max_motor_force);

/** N, of the motor in the last step. */
fettle_code fettle_prismatic_joint_motor_force(const fettle_world* world, fettle_id joint,
                                               float* motor_force);

/** Hz, of a spring towards target_translation, from 0 (none, the default). */
fettle_code fettle_prismatic_joint_hertz(const fettle_world* world, fettle_id joint, float* hertz);
fettle_code fettle_prismatic_joint_set_hertz(fettle_world* world, fettle_id joint, float hertz);

/** Of the spring; finite, at least 0. */
fettle_code fettle_prismatic_joint_damping_ratio(const fettle_world* world, fettle_id joint,
                                                 float* damping_ratio);
fettle_code fettle_prismatic_joint_set_damping_ratio(fettle_world* world, fettle_id joint,
                                                     float damping_ratio);

/** m; finite. */
fettle_code fettle_prismatic_joint_target_translation(const fettle_world* world, fettle_id joint,
                                                      float* target_translation);
fettle_code fettle_prismatic_joint_set_target_translation(fettle_world* world, fettle_id joint,
                                                          float target_translation);

/** Rad, of b relative to a, minus the reference angle: held at 0. Whole turns do not count, so it
 * is within half a turn. */
fettle_code fettle_prismatic_joint_angle(const fettle_world* world, fettle_id joint, float* angle);

/** Rad; finite. */
fettle_code fettle_prismatic_joint_reference_angle(const fettle_world* world, fettle_id joint,
                                                   float* reference_angle);
fettle_code fettle_prismatic_joint_set_reference_angle(fettle_world* world, fettle_id joint,
                                                       float reference_angle);

/* --- pin slot joints --- */

/** Direction in the coordinates of a, of any length but 0. */
fettle_code fettle_pin_slot_joint_axis(const fettle_world* world, fettle_id joint,
                                       fettle_vec2* axis);
fettle_code fettle_pin_slot_joint_set_axis(fettle_world* world, fettle_id joint, float x, float y);

/** m, of anchor b from anchor a along the axis now. */
fettle_code fettle_pin_slot_joint_translation(const fettle_world* world, fettle_id joint,
                                              float* translation);

/** m; minus infinity: no limit. */
fettle_code fettle_pin_slot_joint_lower_translation(const fettle_world* world, fettle_id joint,
                                                    float* lower_translation);
fettle_code fettle_pin_slot_joint_set_lower_translation(fettle_world* world, fettle_id joint,
                                                        float lower_translation);

/** m; infinity: no limit. It wins over the lower one. */
fettle_code fettle_pin_slot_joint_upper_translation(const fettle_world* world, fettle_id joint,
                                                    float* upper_translation);
fettle_code fettle_pin_slot_joint_set_upper_translation(fettle_world* world, fettle_id joint,
                                                        float upper_translation);

/** m/s, of b relative to a along the axis; finite. */
fettle_code fettle_pin_slot_joint_motor_speed(const fettle_world* world, fettle_id joint,
                                              float* motor_speed);
fettle_code fettle_pin_slot_joint_set_motor_speed(fettle_world* world, fettle_id joint,
                                                  float motor_speed);

/** N, from 0 (no motor, the default) to infinity. */
fettle_code fettle_pin_slot_joint_max_motor_force(const fettle_world* world, fettle_id joint,
                                                  float* max_motor_force);
fettle_code fettle_pin_slot_joint_set_max_motor_force(fettle_world* world, fettle_id joint,
                                                      float max_motor_force);

/** N, of the motor in the last step. */
fettle_code fettle_pin_slot_joint_motor_force(const fettle_world* world, fettle_id joint,
                                              float* motor_force);

/** Hz, of a spring towards target_translation, from 0 (none, the default). */
fettle_code fettle_pin_slot_joint_hertz(const fettle_world* world, fettle_id joint, float* hertz);
fettle_code fettle_pin_slot_joint_set_hertz(fettle_world* world, fettle_id joint, float hertz);

/** Of the spring; finite, at least 0. */
fettle_code fettle_pin_slot_joint_damping_ratio(const fettle_world* world, fettle_id joint,
                                                float* damping_ratio);
fettle_code fettle_pin_slot_joint_set_damping_ratio(fettle_world* world, fettle_id joint,
                                                    float damping_ratio);

/** m; finite. */
fettle_code fettle_pin_slot_joint_target_translation(const fettle_world* world, fettle_id joint,
                                                     float* target_translation);
fettle_code fettle_pin_slot_joint_set_target_translation(fettle_world* world, fettle_id joint,
                                                         float target_translation);

/* --- groove joints --- */

/** Coordinates of a, m, from -1e8 to 1e8; the groove begins at anchor a. */
fettle_code fettle_groove_joint_end(const fettle_world* world, fettle_id joint,
                                    fettle_position* end);
fettle_code fettle_groove_joint_set_end(fettle_world* world, fettle_id joint, fettle_coordinate x,
                                        fettle_coordinate y);

/** m, of the pin from the begin of the groove. */
fettle_code fettle_groove_joint_translation(const fettle_world* world, fettle_id joint,
                                            float* translation);

/* --- wheel joints --- */

/** Direction of the suspension in the coordinates of a, of any length but 0; (0, 1) by default. */
fettle_code fettle_wheel_joint_axis(const fettle_world* world, fettle_id joint, fettle_vec2* axis);
fettle_code fettle_wheel_joint_set_axis(fettle_world* world, fettle_id joint, float x, float y);

/** m, of the axle from the rest position of the spring. */
fettle_code fettle_wheel_joint_translation(const fettle_world* world, fettle_id joint,
                                           float* translation);

/** Hz, of the suspension, from 0 (none); 4 by default. */
fettle_code fettle_wheel_joint_hertz(const fettle_world* world, fettle_id joint, float* hertz);
fettle_code fettle_wheel_joint_set_hertz(fettle_world* world, fettle_id joint, float hertz);

/** Of the suspension; finite, at least 0; 0.7 by default. */
fettle_code fettle_wheel_joint_damping_ratio(const fettle_world* world, fettle_id joint,
                                             float* damping_ratio);
fettle_code fettle_wheel_joint_set_damping_ratio(fettle_world* world, fettle_id joint,
                                                 float damping_ratio);

/** m; minus infinity: no limit. */
fettle_code fettle_wheel_joint_lower_translation(const fettle_world* world, fettle_id joint,
                                                 float* lower_translation);
fettle_code fettle_wheel_joint_set_lower_translation(fettle_world* world, fettle_id joint,
                                                     float lower_translation);

/** m; infinity: no limit. It wins over the lower one. */
fettle_code fettle_wheel_joint_upper_translation(const fettle_world* world, fettle_id joint,
                                                 float* upper_translation);
fettle_code fettle_wheel_joint_set_upper_translation(fettle_world* world, fettle_id joint,
                                                     float upper_translation);

/** Rad/s, of the wheel relative to the vehicle; finite. */
fettle_code fettle_wheel_joint_motor_speed(const fettle_world* world, fettle_id joint,
                                           float* motor_speed);
fettle_code fettle_wheel_joint_set_motor_speed(fettle_world* world, fettle_id joint,
                                               float motor_speed);

/** N m, from 0 (no motor, the default) to infinity. */
fettle_code fettle_wheel_joint_max_motor_torque(const fettle_world* world, fettle_id joint,
                                                float* max_motor_torque);
fettle_code fettle_wheel_joint_set_max_motor_torque(fettle_world* world, fettle_id joint,
                                                    float max_motor_torque);

/** N m, of the motor in the last step. */
fettle_code fettle_wheel_joint_motor_torque(const fettle_world* world, fettle_id joint,
                                            float* motor_torque);

FETTLE_PHYSICS_C_END
