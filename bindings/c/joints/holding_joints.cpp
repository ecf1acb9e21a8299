#include <calls/calls.h>

#include <fettle/physics_c/holding_joints.h>

using namespace fettle::physics;
using namespace fettle::physics_c;

fettle_code fettle_mouse_joint_body(const fettle_world* world, fettle_id joint, fettle_id* body) {
    return read<&MouseJoint::body>(__func__, world, joint, body);
}

fettle_code fettle_mouse_joint_set_body(fettle_world* world, fettle_id joint, fettle_id body) {
    return on<MouseJoint>(__func__, world, joint,
                          [&](MouseJoint it) { it.set_body(handle<Body>(world, body)); });
}

fettle_code fettle_mouse_joint_anchor(const fettle_world* world, fettle_id joint,
                                      fettle_position* anchor) {
    return read<&MouseJoint::anchor>(__func__, world, joint, anchor);
}

fettle_code fettle_mouse_joint_set_anchor(fettle_world* world, fettle_id joint, fettle_coordinate x,
                                          fettle_coordinate y) {
    return edit<&MouseJoint::set_anchor>(__func__, world, joint, Position(x, y));
}

fettle_code fettle_mouse_joint_target(const fettle_world* world, fettle_id joint,
                                      fettle_position* target) {
    return read<&MouseJoint::target>(__func__, world, joint, target);
}

fettle_code fettle_mouse_joint_set_target(fettle_world* world, fettle_id joint, fettle_coordinate x,
                                          fettle_coordinate y) {
    return edit<&MouseJoint::set_target>(__func__, world, joint, Position(x, y));
}

fettle_code fettle_mouse_joint_hertz(const fettle_world* world, fettle_id joint, float* hertz) {
    return read<&MouseJoint::hertz>(__func__, world, joint, hertz);
}

fettle_code fettle_mouse_joint_set_hertz(fettle_world* world, fettle_id joint, float hertz) {
    return edit<&MouseJoint::set_hertz>(__func__, world, joint, hertz);
}

fettle_code fettle_mouse_joint_damping_ratio(const fettle_world* world, fettle_id joint,
                                             float* damping_ratio) {
    return read<&MouseJoint::damping_ratio>(__func__, world, joint, damping_ratio);
}

fettle_code fettle_mouse_joint_set_damping_ratio(fettle_world* world, fettle_id joint,
                                                 float damping_ratio) {
    return edit<&MouseJoint::set_damping_ratio>(__func__, world, joint, damping_ratio);
}

fettle_code fettle_mouse_joint_max_force(const fettle_world* world, fettle_id joint,
                                         float* max_force) {
    return read<&MouseJoint::max_force>(__func__, world, joint, max_force);
}

fettle_code fettle_mouse_joint_set_max_force(fettle_world* world, fettle_id joint,
                                             float max_force) {
    return edit<&MouseJoint::set_max_force>(__func__, world, joint, max_force);
}

fettle_code fettle_distance_joint_length(const fettle_world* world, fettle_id joint,
                                         float* length) {
    return read<&DistanceJoint::length>(__func__, world, joint, length);
}

fettle_code fettle_distance_joint_set_length(fettle_world* world, fettle_id joint, float length) {
    return edit<&DistanceJoint::set_length>(__func__, world, joint, length);
}

fettle_code fettle_distance_joint_min_length(const fettle_world* world, fettle_id joint,
                                             float* min_length) {
    return read<&DistanceJoint::min_length>(__func__, world, joint, min_length);
}

fettle_code fettle_distance_joint_set_min_length(fettle_world* world, fettle_id joint,
                                                 float min_length) {
    return edit<&DistanceJoint::set_min_length>(__func__, world, joint, min_length);
}

fettle_code fettle_distance_joint_max_length(const fettle_world* world, fettle_id joint,
                                             float* max_length) {
    return read<&DistanceJoint::max_length>(__func__, world, joint, max_length);
}

fettle_code fettle_distance_joint_set_max_length(fettle_world* world, fettle_id joint,
                                                 float max_length) {
    return edit<&DistanceJoint::set_max_length>(__func__, world, joint, max_length);
}

fettle_code fettle_distance_joint_hertz(const fettle_world* world, fettle_id joint, float* hertz) {
    return read<&DistanceJoint::hertz>(__func__, world, joint, hertz);
}

fettle_code fettle_distance_joint_set_hertz(fettle_world* world, fettle_id joint, float hertz) {
    return edit<&DistanceJoint::set_hertz>(__func__, world, joint, hertz);
}

fettle_code fettle_distance_joint_damping_ratio(const fettle_world* world, fettle_id joint,
                                                float* damping_ratio) {
    return read<&DistanceJoint::damping_ratio>(__func__, world, joint, damping_ratio);
}

fettle_code fettle_distance_joint_set_damping_ratio(fettle_world* world, fettle_id joint,
                                                    float damping_ratio) {
    return edit<&DistanceJoint::set_damping_ratio>(__func__, world, joint, damping_ratio);
}

fettle_code fettle_distance_joint_lower_spring_force(const fettle_world* world, fettle_id joint,
                                                     float* lower_spring_force) {
    return read<&DistanceJoint::lower_spring_force>(__func__, world, joint, lower_spring_force);
}

fettle_code fettle_distance_joint_set_lower_spring_force(fettle_world* world, fettle_id joint,
                                                         float lower_spring_force) {
    return edit<&DistanceJoint::set_lower_spring_force>(__func__, world, joint, lower_spring_force);
}

fettle_code fettle_distance_joint_upper_spring_force(const fettle_world* world, fettle_id joint,
                                                     float* upper_spring_force) {
    return read<&DistanceJoint::upper_spring_force>(__func__, world, joint, upper_spring_force);
}

fettle_code fettle_distance_joint_set_upper_spring_force(fettle_world* world, fettle_id joint,
                                                         float upper_spring_force) {
    return edit<&DistanceJoint::set_upper_spring_force>(__func__, world, joint, upper_spring_force);
}

fettle_code fettle_distance_joint_motor_speed(const fettle_world* world, fettle_id joint,
                                              float* motor_speed) {
    return read<&DistanceJoint::motor_speed>(__func__, world, joint, motor_speed);
}

fettle_code fettle_distance_joint_set_motor_speed(fettle_world* world, fettle_id joint,
                                                  float motor_speed) {
    return edit<&DistanceJoint::set_motor_speed>(__func__, world, joint, motor_speed);
}

fettle_code fettle_distance_joint_max_motor_force(const fettle_world* world, fettle_id joint,
                                                  float* max_motor_force) {
    return read<&DistanceJoint::max_motor_force>(__func__, world, joint, max_motor_force);
}

fettle_code fettle_distance_joint_set_max_motor_force(fettle_world* world, fettle_id joint,
                                                      float max_motor_force) {
    return edit<&DistanceJoint::set_max_motor_force>(__func__, world, joint, max_motor_force);
}

fettle_code fettle_distance_joint_motor_force(const fettle_world* world, fettle_id joint,
                                              float* motor_force) {
    return read<&DistanceJoint::motor_force>(__func__, world, joint, motor_force);
}

fettle_code fettle_distance_joint_distance(const fettle_world* world, fettle_id joint,
                                           float* distance) {
    return read<&DistanceJoint::distance>(__func__, world, joint, distance);
}

fettle_code fettle_revolute_joint_angle(const fettle_world* world, fettle_id joint, float* angle) {
    return read<&RevoluteJoint::angle>(__func__, world, joint, angle);
}

fettle_code fettle_revolute_joint_reference_angle(const fettle_world* world, fettle_id joint,
                                                  float* reference_angle) {
    return read<&RevoluteJoint::reference_angle>(__func__, world, joint, reference_angle);
}

fettle_code fettle_revolute_joint_set_reference_angle(fettle_world* world, fettle_id joint,
                                                      float reference_angle) {
    return edit<&RevoluteJoint::set_reference_angle>(__func__, world, joint, reference_angle);
}

fettle_code fettle_revolute_joint_lower_angle(const fettle_world* world, fettle_id joint,
                                              float* lower_angle) {
    return read<&RevoluteJoint::lower_angle>(__func__, world, joint, lower_angle);
}

fettle_code fettle_revolute_joint_set_lower_angle(fettle_world* world, fettle_id joint,
                                                  float lower_angle) {
    return edit<&RevoluteJoint::set_lower_angle>(__func__, world, joint, lower_angle);
}

fettle_code fettle_revolute_joint_upper_angle(const fettle_world* world, fettle_id joint,
                                              float* upper_angle) {
    return read<&RevoluteJoint::upper_angle>(__func__, world, joint, upper_angle);
}

fettle_code fettle_revolute_joint_set_upper_angle(fettle_world* world, fettle_id joint,
                                                  float upper_angle) {
    return edit<&RevoluteJoint::set_upper_angle>(__func__, world, joint, upper_angle);
}

fettle_code fettle_revolute_joint_motor_speed(const fettle_world* world, fettle_id joint,
                                              float* motor_speed) {
    return read<&RevoluteJoint::motor_speed>(__func__, world, joint, motor_speed);
}

fettle_code fettle_revolute_joint_set_motor_speed(fettle_world* world, fettle_id joint,
                                                  float motor_speed) {
    return edit<&RevoluteJoint::set_motor_speed>(__func__, world, joint, motor_speed);
}

fettle_code fettle_revolute_joint_max_motor_torque(const fettle_world* world, fettle_id joint,
                                                   float* max_motor_torque) {
    return read<&RevoluteJoint::max_motor_torque>(__func__, world, joint, max_motor_torque);
}

fettle_code fettle_revolute_joint_set_max_motor_torque(fettle_world* world, fettle_id joint,
                                                       float max_motor_torque) {
    return edit<&RevoluteJoint::set_max_motor_torque>(__func__, world, joint, max_motor_torque);
}

fettle_code fettle_revolute_joint_hertz(const fettle_world* world, fettle_id joint, float* hertz) {
    return read<&RevoluteJoint::hertz>(__func__, world, joint, hertz);
}

fettle_code fettle_revolute_joint_set_hertz(fettle_world* world, fettle_id joint, float hertz) {
    return edit<&RevoluteJoint::set_hertz>(__func__, world, joint, hertz);
}

fettle_code fettle_revolute_joint_damping_ratio(const fettle_world* world, fettle_id joint,
                                                float* damping_ratio) {
    return read<&RevoluteJoint::damping_ratio>(__func__, world, joint, damping_ratio);
}

fettle_code fettle_revolute_joint_set_damping_ratio(fettle_world* world, fettle_id joint,
                                                    float damping_ratio) {
    return edit<&RevoluteJoint::set_damping_ratio>(__func__, world, joint, damping_ratio);
}

fettle_code fettle_revolute_joint_target_angle(const fettle_world* world, fettle_id joint,
                                               float* target_angle) {
    return read<&RevoluteJoint::target_angle>(__func__, world, joint, target_angle);
}

fettle_code fettle_revolute_joint_set_target_angle(fettle_world* world, fettle_id joint,
                                                   float target_angle) {
    return edit<&RevoluteJoint::set_target_angle>(__func__, world, joint, target_angle);
}

fettle_code fettle_revolute_joint_motor_torque(const fettle_world* world, fettle_id joint,
                                               float* motor_torque) {
    return read<&RevoluteJoint::motor_torque>(__func__, world, joint, motor_torque);
}

fettle_code fettle_weld_joint_angle(const fettle_world* world, fettle_id joint, float* angle) {
    return read<&WeldJoint::angle>(__func__, world, joint, angle);
}

fettle_code fettle_weld_joint_reference_angle(const fettle_world* world, fettle_id joint,
                                              float* reference_angle) {
    return read<&WeldJoint::reference_angle>(__func__, world, joint, reference_angle);
}

fettle_code fettle_weld_joint_set_reference_angle(fettle_world* world, fettle_id joint,
                                                  float reference_angle) {
    return edit<&WeldJoint::set_reference_angle>(__func__, world, joint, reference_angle);
}

fettle_code fettle_weld_joint_hertz(const fettle_world* world, fettle_id joint, float* hertz) {
    return read<&WeldJoint::hertz>(__func__, world, joint, hertz);
}

fettle_code fettle_weld_joint_set_hertz(fettle_world* world, fettle_id joint, float hertz) {
    return edit<&WeldJoint::set_hertz>(__func__, world, joint, hertz);
}

fettle_code fettle_weld_joint_damping_ratio(const fettle_world* world, fettle_id joint,
                                            float* damping_ratio) {
    return read<&WeldJoint::damping_ratio>(__func__, world, joint, damping_ratio);
}

fettle_code fettle_weld_joint_set_damping_ratio(fettle_world* world, fettle_id joint,
                                                float damping_ratio) {
    return edit<&WeldJoint::set_damping_ratio>(__func__, world, joint, damping_ratio);
}

fettle_code fettle_weld_joint_angular_hertz(const fettle_world* world, fettle_id joint,
                                            float* angular_hertz) {
    return read<&WeldJoint::angular_hertz>(__func__, world, joint, angular_hertz);
}

fettle_code fettle_weld_joint_set_angular_hertz(fettle_world* world, fettle_id joint,
                                                float angular_hertz) {
    return edit<&WeldJoint::set_angular_hertz>(__func__, world, joint, angular_hertz);
}

fettle_code fettle_weld_joint_angular_damping_ratio(const fettle_world* world, fettle_id joint,
                                                    float* angular_damping_ratio) {
    return read<&WeldJoint::angular_damping_ratio>(__func__, world, joint, angular_damping_ratio);
}

fettle_code fettle_weld_joint_set_angular_damping_ratio(fettle_world* world, fettle_id joint,
                                                        float angular_damping_ratio) {
    return edit<&WeldJoint::set_angular_damping_ratio>(__func__, world, joint,
                                                       angular_damping_ratio);
}
