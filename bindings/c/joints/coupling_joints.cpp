#include <calls/calls.h>

#include <fettle/physics_c/coupling_joints.h>

using namespace fettle::physics;
using namespace fettle::physics_c;

fettle_code fettle_motor_joint_linear_velocity(const fettle_world* world, fettle_id joint,
                                               fettle_vec2* linear_velocity) {
    return read<&MotorJoint::linear_velocity>(__func__, world, joint, linear_velocity);
}

fettle_code fettle_motor_joint_set_linear_velocity(fettle_world* world, fettle_id joint, float x,
                                                   float y) {
    return edit<&MotorJoint::set_linear_velocity>(__func__, world, joint, Vec2(x, y));
}

fettle_code fettle_motor_joint_angular_velocity(const fettle_world* world, fettle_id joint,
                                                float* angular_velocity) {
    return read<&MotorJoint::angular_velocity>(__func__, world, joint, angular_velocity);
}

fettle_code fettle_motor_joint_set_angular_velocity(fettle_world* world, fettle_id joint,
                                                    float angular_velocity) {
    return edit<&MotorJoint::set_angular_velocity>(__func__, world, joint, angular_velocity);
}

fettle_code fettle_motor_joint_max_force(const fettle_world* world, fettle_id joint,
                                         float* max_force) {
    return read<&MotorJoint::max_force>(__func__, world, joint, max_force);
}

fettle_code fettle_motor_joint_set_max_force(fettle_world* world, fettle_id joint,
                                             float max_force) {
    return edit<&MotorJoint::set_max_force>(__func__, world, joint, max_force);
}

fettle_code fettle_motor_joint_max_torque(const fettle_world* world, fettle_id joint,
                                          float* max_torque) {
    return read<&MotorJoint::max_torque>(__func__, world, joint, max_torque);
}

fettle_code fettle_motor_joint_set_max_torque(fettle_world* world, fettle_id joint,
                                              float max_torque) {
    return edit<&MotorJoint::set_max_torque>(__func__, world, joint, max_torque);
}

fettle_code fettle_motor_joint_linear_offset(const fettle_world* world, fettle_id joint,
                                             fettle_vec2* linear_offset) {
    return read<&MotorJoint::linear_offset>(__func__, world, joint, linear_offset);
}

fettle_code fettle_motor_joint_set_linear_offset(fettle_world* world, fettle_id joint, float x,
                                                 float y) {
    return edit<&MotorJoint::set_linear_offset>(__func__, world, joint, Vec2(x, y));
}

fettle_code fettle_motor_joint_angular_offset(const fettle_world* world, fettle_id joint,
                                              float* angular_offset) {
    return read<&MotorJoint::angular_offset>(__func__, world, joint, angular_offset);
}

fettle_code fettle_motor_joint_set_angular_offset(fettle_world* world, fettle_id joint,
                                                  float angular_offset) {
    return edit<&MotorJoint::set_angular_offset>(__func__, world, joint, angular_offset);
}

fettle_code fettle_motor_joint_hertz(const fettle_world* world, fettle_id joint, float* hertz) {
    return read<&MotorJoint::hertz>(__func__, world, joint, hertz);
}

fettle_code fettle_motor_joint_set_hertz(fettle_world* world, fettle_id joint, float hertz) {
    return edit<&MotorJoint::set_hertz>(__func__, world, joint, hertz);
}

fettle_code fettle_motor_joint_damping_ratio(const fettle_world* world, fettle_id joint,
                                             float* damping_ratio) {
    return read<&MotorJoint::damping_ratio>(__func__, world, joint, damping_ratio);
}

fettle_code fettle_motor_joint_set_damping_ratio(fettle_world* world, fettle_id joint,
                                                 float damping_ratio) {
    return edit<&MotorJoint::set_damping_ratio>(__func__, world, joint, damping_ratio);
}

fettle_code fettle_pulley_joint_ground_a(const fettle_world* world, fettle_id joint,
                                         fettle_position* ground_a) {
    return read<&PulleyJoint::ground_a>(__func__, world, joint, ground_a);
}

fettle_code fettle_pulley_joint_set_ground_a(fettle_world* world, fettle_id joint,
                                             fettle_coordinate x, fettle_coordinate y) {
    return edit<&PulleyJoint::set_ground_a>(__func__, world, joint, Position(x, y));
}

fettle_code fettle_pulley_joint_ground_b(const fettle_world* world, fettle_id joint,
                                         fettle_position* ground_b) {
    return read<&PulleyJoint::ground_b>(__func__, world, joint, ground_b);
}

fettle_code fettle_pulley_joint_set_ground_b(fettle_world* world, fettle_id joint,
                                             fettle_coordinate x, fettle_coordinate y) {
    return edit<&PulleyJoint::set_ground_b>(__func__, world, joint, Position(x, y));
}

fettle_code fettle_pulley_joint_ratio(const fettle_world* world, fettle_id joint, float* ratio) {
    return read<&PulleyJoint::ratio>(__func__, world, joint, ratio);
}

fettle_code fettle_pulley_joint_set_ratio(fettle_world* world, fettle_id joint, float ratio) {
    return edit<&PulleyJoint::set_ratio>(__func__, world, joint, ratio);
}

fettle_code fettle_pulley_joint_length(const fettle_world* world, fettle_id joint, float* length) {
    return read<&PulleyJoint::length>(__func__, world, joint, length);
}

fettle_code fettle_pulley_joint_set_length(fettle_world* world, fettle_id joint, float length) {
    return edit<&PulleyJoint::set_length>(__func__, world, joint, length);
}

fettle_code fettle_pulley_joint_length_now(const fettle_world* world, fettle_id joint,
                                           float* length_now) {
    return read<&PulleyJoint::length_now>(__func__, world, joint, length_now);
}

fettle_code fettle_pulley_joint_length_a(const fettle_world* world, fettle_id joint,
                                         float* length_a) {
    return read<&PulleyJoint::length_a>(__func__, world, joint, length_a);
}

fettle_code fettle_pulley_joint_length_b(const fettle_world* world, fettle_id joint,
                                         float* length_b) {
    return read<&PulleyJoint::length_b>(__func__, world, joint, length_b);
}

fettle_code fettle_pulley_joint_tension(const fettle_world* world, fettle_id joint,
                                        float* tension) {
    return read<&PulleyJoint::tension>(__func__, world, joint, tension);
}

fettle_code fettle_gear_joint_ratio(const fettle_world* world, fettle_id joint, float* ratio) {
    return read<&GearJoint::ratio>(__func__, world, joint, ratio);
}

fettle_code fettle_gear_joint_set_ratio(fettle_world* world, fettle_id joint, float ratio) {
    return edit<&GearJoint::set_ratio>(__func__, world, joint, ratio);
}

fettle_code fettle_gear_joint_phase(const fettle_world* world, fettle_id joint, float* phase) {
    return read<&GearJoint::phase>(__func__, world, joint, phase);
}

fettle_code fettle_gear_joint_set_phase(fettle_world* world, fettle_id joint, float phase) {
    return edit<&GearJoint::set_phase>(__func__, world, joint, phase);
}

fettle_code fettle_gear_joint_phase_now(const fettle_world* world, fettle_id joint,
                                        float* phase_now) {
    return read<&GearJoint::phase_now>(__func__, world, joint, phase_now);
}

fettle_code fettle_ratchet_joint_angle(const fettle_world* world, fettle_id joint, float* angle) {
    return read<&RatchetJoint::angle>(__func__, world, joint, angle);
}

fettle_code fettle_ratchet_joint_reference_angle(const fettle_world* world, fettle_id joint,
                                                 float* reference_angle) {
    return read<&RatchetJoint::reference_angle>(__func__, world, joint, reference_angle);
}

fettle_code fettle_ratchet_joint_set_reference_angle(fettle_world* world, fettle_id joint,
                                                     float reference_angle) {
    return edit<&RatchetJoint::set_reference_angle>(__func__, world, joint, reference_angle);
}

fettle_code fettle_ratchet_joint_tooth(const fettle_world* world, fettle_id joint, float* tooth) {
    return read<&RatchetJoint::tooth>(__func__, world, joint, tooth);
}

fettle_code fettle_ratchet_joint_set_tooth(fettle_world* world, fettle_id joint, float tooth) {
    return edit<&RatchetJoint::set_tooth>(__func__, world, joint, tooth);
}

fettle_code fettle_ratchet_joint_backwards(const fettle_world* world, fettle_id joint,
                                           bool* backwards) {
    return read<&RatchetJoint::backwards>(__func__, world, joint, backwards);
}

fettle_code fettle_ratchet_joint_set_backwards(fettle_world* world, fettle_id joint,
                                               bool backwards) {
    return edit<&RatchetJoint::set_backwards>(__func__, world, joint, backwards);
}

fettle_code fettle_ratchet_joint_caught_angle(const fettle_world* world, fettle_id joint,
                                              float* caught_angle) {
    return read<&RatchetJoint::caught_angle>(__func__, world, joint, caught_angle);
}

fettle_code fettle_rotary_limit_joint_angle(const fettle_world* world, fettle_id joint,
                                            float* angle) {
    return read<&RotaryLimitJoint::angle>(__func__, world, joint, angle);
}

fettle_code fettle_rotary_limit_joint_reference_angle(const fettle_world* world, fettle_id joint,
                                                      float* reference_angle) {
    return read<&RotaryLimitJoint::reference_angle>(__func__, world, joint, reference_angle);
}

fettle_code fettle_rotary_limit_joint_set_reference_angle(fettle_world* world, fettle_id joint,
                                                          float reference_angle) {
    return edit<&RotaryLimitJoint::set_reference_angle>(__func__, world, joint, reference_angle);
}

fettle_code fettle_rotary_limit_joint_lower_angle(const fettle_world* world, fettle_id joint,
                                                  float* lower_angle) {
    return read<&RotaryLimitJoint::lower_angle>(__func__, world, joint, lower_angle);
}

fettle_code fettle_rotary_limit_joint_set_lower_angle(fettle_world* world, fettle_id joint,
                                                      float lower_angle) {
    return edit<&RotaryLimitJoint::set_lower_angle>(__func__, world, joint, lower_angle);
}

fettle_code fettle_rotary_limit_joint_upper_angle(const fettle_world* world, fettle_id joint,
                                                  float* upper_angle) {
    return read<&RotaryLimitJoint::upper_angle>(__func__, world, joint, upper_angle);
}

fettle_code fettle_rotary_limit_joint_set_upper_angle(fettle_world* world, fettle_id joint,
                                                      float upper_angle) {
    return edit<&RotaryLimitJoint::set_upper_angle>(__func__, world, joint, upper_angle);
}
