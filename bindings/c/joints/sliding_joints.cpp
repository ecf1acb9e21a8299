#include <calls/calls.h>

#include <fettle/physics_c/sliding_joints.h>

using namespace fettle::physics;
using namespace fettle::physics_c;

fettle_code fettle_prismatic_joint_axis(const fettle_world* world, fettle_id joint,
                                        fettle_vec2* axis) {
    return read<&PrismaticJoint::axis>(__func__, world, joint, axis);
}

fettle_code fettle_prismatic_joint_set_axis(fettle_world* world, fettle_id joint, float x,
                                            float y) {
    return edit<&PrismaticJoint::set_axis>(__func__, world, joint, Vec2(x, y));
}

fettle_code fettle_prismatic_joint_translation(const fettle_world* world, fettle_id joint,
                                               float* translation) {
    return read<&PrismaticJoint::translation>(__func__, world, joint, translation);
}

fettle_code fettle_prismatic_joint_lower_translation(const fettle_world* world, fettle_id joint,
                                                     float* lower_translation) {
    return read<&PrismaticJoint::lower_translation>(__func__, world, joint, lower_translation);
}

fettle_code fettle_prismatic_joint_set_lower_translation(fettle_world* world, fettle_id joint,
                                                         float lower_translation) {
    return edit<&PrismaticJoint::set_lower_translation>(__func__, world, joint, lower_translation);
}

fettle_code fettle_prismatic_joint_upper_translation(const fettle_world* world, fettle_id joint,
                                                     float* upper_translation) {
    return read<&PrismaticJoint::upper_translation>(__func__, world, joint, upper_translation);
}

fettle_code fettle_prismatic_joint_set_upper_translation(fettle_world* world, fettle_id joint,
                                                         float upper_translation) {
    return edit<&PrismaticJoint::set_upper_translation>(__func__, world, joint, upper_translation);
}

fettle_code fettle_prismatic_joint_motor_speed(const fettle_world* world, fettle_id joint,
                                               float* motor_speed) {
    return read<&PrismaticJoint::motor_speed>(__func__, world, joint, motor_speed);
}

fettle_code fettle_prismatic_joint_set_motor_speed(fettle_world* world, fettle_id joint,
                                                   float motor_speed) {
    return edit<&PrismaticJoint::set_motor_speed>(__func__, world, joint, motor_speed);
}

fettle_code fettle_prismatic_joint_max_motor_force(const fettle_world* world, fettle_id joint,
                                                   float* max_motor_force) {
    return read<&PrismaticJoint::max_motor_force>(__func__, world, joint, max_motor_force);
}

fettle_code fettle_prismatic_joint_set_max_motor_force(fettle_world* world, fettle_id joint,
                                                       float max_motor_force) {
    return edit<&PrismaticJoint::set_max_motor_force>(__func__, world, joint, max_motor_force);
}

fettle_code fettle_prismatic_joint_motor_force(const fettle_world* world, fettle_id joint,
                                               float* motor_force) {
    return read<&PrismaticJoint::motor_force>(__func__, world, joint, motor_force);
}

fettle_code fettle_prismatic_joint_hertz(const fettle_world* world, fettle_id joint, float* hertz) {
    return read<&PrismaticJoint::hertz>(__func__, world, joint, hertz);
}

fettle_code fettle_prismatic_joint_set_hertz(fettle_world* world, fettle_id joint, float hertz) {
    return edit<&PrismaticJoint::set_hertz>(__func__, world, joint, hertz);
}

fettle_code fettle_prismatic_joint_damping_ratio(const fettle_world* world, fettle_id joint,
                                                 float* damping_ratio) {
    return read<&PrismaticJoint::damping_ratio>(__func__, world, joint, damping_ratio);
}

fettle_code fettle_prismatic_joint_set_damping_ratio(fettle_world* world, fettle_id joint,
                                                     float damping_ratio) {
    return edit<&PrismaticJoint::set_damping_ratio>(__func__, world, joint, damping_ratio);
}

fettle_code fettle_prismatic_joint_target_translation(const fettle_world* world, fettle_id joint,
                                                      float* target_translation) {
    return read<&PrismaticJoint::target_translation>(__func__, world, joint, target_translation);
}

fettle_code fettle_prismatic_joint_set_target_translation(fettle_world* world, fettle_id joint,
                                                          float target_translation) {
    return edit<&PrismaticJoint::set_target_translation>(__func__, world, joint,
                                                         target_translation);
}

fettle_code fettle_prismatic_joint_angle(const fettle_world* world, fettle_id joint, float* angle) {
    return read<&PrismaticJoint::angle>(__func__, world, joint, angle);
}

fettle_code fettle_prismatic_joint_reference_angle(const fettle_world* world, fettle_id joint,
                                                   float* reference_angle) {
    return read<&PrismaticJoint::reference_angle>(__func__, world, joint, reference_angle);
}

fettle_code fettle_prismatic_joint_set_reference_angle(fettle_world* world, fettle_id joint,
                                                       float reference_angle) {
    return edit<&PrismaticJoint::set_reference_angle>(__func__, world, joint, reference_angle);
}

fettle_code fettle_pin_slot_joint_axis(const fettle_world* world, fettle_id joint,
                                       fettle_vec2* axis) {
    return read<&PinSlotJoint::axis>(__func__, world, joint, axis);
}

fettle_code fettle_pin_slot_joint_set_axis(fettle_world* world, fettle_id joint, float x, float y) {
    return edit<&PinSlotJoint::set_axis>(__func__, world, joint, Vec2(x, y));
}

fettle_code fettle_pin_slot_joint_translation(const fettle_world* world, fettle_id joint,
                                              float* translation) {
    return read<&PinSlotJoint::translation>(__func__, world, joint, translation);
}

fettle_code fettle_pin_slot_joint_lower_translation(const fettle_world* world, fettle_id joint,
                                                    float* lower_translation) {
    return read<&PinSlotJoint::lower_translation>(__func__, world, joint, lower_translation);
}

fettle_code fettle_pin_slot_joint_set_lower_translation(fettle_world* world, fettle_id joint,
                                                        float lower_translation) {
    return edit<&PinSlotJoint::set_lower_translation>(__func__, world, joint, lower_translation);
}

fettle_code fettle_pin_slot_joint_upper_translation(const fettle_world* world, fettle_id joint,
                                                    float* upper_translation) {
    return read<&PinSlotJoint::upper_translation>(__func__, world, joint, upper_translation);
}

fettle_code fettle_pin_slot_joint_set_upper_translation(fettle_world* world, fettle_id joint,
                                                        float upper_translation) {
    return edit<&PinSlotJoint::set_upper_translation>(__func__, world, joint, upper_translation);
}

fettle_code fettle_pin_slot_joint_motor_speed(const fettle_world* world, fettle_id joint,
                                              float* motor_speed) {
    return read<&PinSlotJoint::motor_speed>(__func__, world, joint, motor_speed);
}

fettle_code fettle_pin_slot_joint_set_motor_speed(fettle_world* world, fettle_id joint,
                                                  float motor_speed) {
    return edit<&PinSlotJoint::set_motor_speed>(__func__, world, joint, motor_speed);
}

fettle_code fettle_pin_slot_joint_max_motor_force(const fettle_world* world, fettle_id joint,
                                                  float* max_motor_force) {
    return read<&PinSlotJoint::max_motor_force>(__func__, world, joint, max_motor_force);
}

fettle_code fettle_pin_slot_joint_set_max_motor_force(fettle_world* world, fettle_id joint,
                                                      float max_motor_force) {
    return edit<&PinSlotJoint::set_max_motor_force>(__func__, world, joint, max_motor_force);
}

fettle_code fettle_pin_slot_joint_motor_force(const fettle_world* world, fettle_id joint,
                                              float* motor_force) {
    return read<&PinSlotJoint::motor_force>(__func__, world, joint, motor_force);
}

fettle_code fettle_pin_slot_joint_hertz(const fettle_world* world, fettle_id joint, float* hertz) {
    return read<&PinSlotJoint::hertz>(__func__, world, joint, hertz);
}

fettle_code fettle_pin_slot_joint_set_hertz(fettle_world* world, fettle_id joint, float hertz) {
    return edit<&PinSlotJoint::set_hertz>(__func__, world, joint, hertz);
}

fettle_code fettle_pin_slot_joint_damping_ratio(const fettle_world* world, fettle_id joint,
                                                float* damping_ratio) {
    return read<&PinSlotJoint::damping_ratio>(__func__, world, joint, damping_ratio);
}

fettle_code fettle_pin_slot_joint_set_damping_ratio(fettle_world* world, fettle_id joint,
                                                    float damping_ratio) {
    return edit<&PinSlotJoint::set_damping_ratio>(__func__, world, joint, damping_ratio);
}

fettle_code fettle_pin_slot_joint_target_translation(const fettle_world* world, fettle_id joint,
                                                     float* target_translation) {
    return read<&PinSlotJoint::target_translation>(__func__, world, joint, target_translation);
}

fettle_code fettle_pin_slot_joint_set_target_translation(fettle_world* world, fettle_id joint,
                                                         float target_translation) {
    return edit<&PinSlotJoint::set_target_translation>(__func__, world, joint, target_translation);
}

fettle_code fettle_groove_joint_end(const fettle_world* world, fettle_id joint,
                                    fettle_position* end) {
    return read<&GrooveJoint::end>(__func__, world, joint, end);
}

fettle_code fettle_groove_joint_set_end(fettle_world* world, fettle_id joint, fettle_coordinate x,
                                        fettle_coordinate y) {
    return edit<&GrooveJoint::set_end>(__func__, world, joint, Position(x, y));
}

fettle_code fettle_groove_joint_translation(const fettle_world* world, fettle_id joint,
                                            float* translation) {
    return read<&GrooveJoint::translation>(__func__, world, joint, translation);
}

fettle_code fettle_wheel_joint_axis(const fettle_world* world, fettle_id joint, fettle_vec2* axis) {
    return read<&WheelJoint::axis>(__func__, world, joint, axis);
}

fettle_code fettle_wheel_joint_set_axis(fettle_world* world, fettle_id joint, float x, float y) {
    return edit<&WheelJoint::set_axis>(__func__, world, joint, Vec2(x, y));
}

fettle_code fettle_wheel_joint_translation(const fettle_world* world, fettle_id joint,
                                           float* translation) {
    return read<&WheelJoint::translation>(__func__, world, joint, translation);
}

fettle_code fettle_wheel_joint_hertz(const fettle_world* world, fettle_id joint, float* hertz) {
    return read<&WheelJoint::hertz>(__func__, world, joint, hertz);
}

fettle_code fettle_wheel_joint_set_hertz(fettle_world* world, fettle_id joint, float hertz) {
    return edit<&WheelJoint::set_hertz>(__func__, world, joint, hertz);
}

fettle_code fettle_wheel_joint_damping_ratio(const fettle_world* world, fettle_id joint,
                                             float* damping_ratio) {
    return read<&WheelJoint::damping_ratio>(__func__, world, joint, damping_ratio);
}

fettle_code fettle_wheel_joint_set_damping_ratio(fettle_world* world, fettle_id joint,
                                                 float damping_ratio) {
    return edit<&WheelJoint::set_damping_ratio>(__func__, world, joint, damping_ratio);
}

fettle_code fettle_wheel_joint_lower_translation(const fettle_world* world, fettle_id joint,
                                                 float* lower_translation) {
    return read<&WheelJoint::lower_translation>(__func__, world, joint, lower_translation);
}

fettle_code fettle_wheel_joint_set_lower_translation(fettle_world* world, fettle_id joint,
                                                     float lower_translation) {
    return edit<&WheelJoint::set_lower_translation>(__func__, world, joint, lower_translation);
}

fettle_code fettle_wheel_joint_upper_translation(const fettle_world* world, fettle_id joint,
                                                 float* upper_translation) {
    return read<&WheelJoint::upper_translation>(__func__, world, joint, upper_translation);
}

fettle_code fettle_wheel_joint_set_upper_translation(fettle_world* world, fettle_id joint,
                                                     float upper_translation) {
    return edit<&WheelJoint::set_upper_translation>(__func__, world, joint, upper_translation);
}

fettle_code fettle_wheel_joint_motor_speed(const fettle_world* world, fettle_id joint,
                                           float* motor_speed) {
    return read<&WheelJoint::motor_speed>(__func__, world, joint, motor_speed);
}

fettle_code fettle_wheel_joint_set_motor_speed(fettle_world* world, fettle_id joint,
                                               float motor_speed) {
    return edit<&WheelJoint::set_motor_speed>(__func__, world, joint, motor_speed);
}

fettle_code fettle_wheel_joint_max_motor_torque(const fettle_world* world, fettle_id joint,
                                                float* max_motor_torque) {
    return read<&WheelJoint::max_motor_torque>(__func__, world, joint, max_motor_torque);
}

fettle_code fettle_wheel_joint_set_max_motor_torque(fettle_world* world, fettle_id joint,
                                                    float max_motor_torque) {
    return edit<&WheelJoint::set_max_motor_torque>(__func__, world, joint, max_motor_torque);
}

fettle_code fettle_wheel_joint_motor_torque(const fettle_world* world, fettle_id joint,
                                            float* motor_torque) {
    return read<&WheelJoint::motor_torque>(__func__, world, joint, motor_torque);
}
