#include <calls/properties.h>

#include <fettle/physics_c/holding_joints.h>

using namespace fettle::physics;
using namespace fettle::physics_c;

FETTLE_READING(mouse_joint, MouseJoint, body, fettle_id)

fettle_code fettle_mouse_joint_set_body(fettle_world* world, fettle_id joint, fettle_id body) {
    return on<MouseJoint>(__func__, world, joint,
                          [&](MouseJoint it) { it.set_body(handle<Body>(world, body)); });
}

FETTLE_POSITION(mouse_joint, MouseJoint, anchor)
FETTLE_POSITION(mouse_joint, MouseJoint, target)
FETTLE_PROPERTY(mouse_joint, MouseJoint, hertz, float)
FETTLE_PROPERTY(mouse_joint, MouseJoint, damping_ratio, float)
FETTLE_PROPERTY(mouse_joint, MouseJoint, max_force, float)

FETTLE_PROPERTY(distance_joint, DistanceJoint, length, float)
FETTLE_PROPERTY(distance_joint, DistanceJoint, min_length, float)
FETTLE_PROPERTY(distance_joint, DistanceJoint, max_length, float)
FETTLE_PROPERTY(distance_joint, DistanceJoint, hertz, float)
FETTLE_PROPERTY(distance_joint, DistanceJoint, damping_ratio, float)
FETTLE_PROPERTY(distance_joint, DistanceJoint, lower_spring_force, float)
FETTLE_PROPERTY(distance_joint, DistanceJoint, upper_spring_force, float)
FETTLE_PROPERTY(distance_joint, DistanceJoint, motor_speed, float)
FETTLE_PROPERTY(distance_joint, DistanceJoint, max_motor_force, float)
FETTLE_READING(distance_joint, DistanceJoint, motor_force, float)
FETTLE_READING(distance_joint, DistanceJoint, distance, float)

FETTLE_READING(revolute_joint, RevoluteJoint, angle, float)
FETTLE_PROPERTY(revolute_joint, RevoluteJoint, reference_angle, float)
FETTLE_PROPERTY(revolute_joint, RevoluteJoint, lower_angle, float)
FETTLE_PROPERTY(revolute_joint, RevoluteJoint, upper_angle, float)
FETTLE_PROPERTY(revolute_joint, RevoluteJoint, motor_speed, float)
FETTLE_PROPERTY(revolute_joint, RevoluteJoint, max_motor_torque, float)
FETTLE_PROPERTY(revolute_joint, RevoluteJoint, hertz, float)
FETTLE_PROPERTY(revolute_joint, RevoluteJoint, damping_ratio, float)
FETTLE_PROPERTY(revolute_joint, RevoluteJoint, target_angle, float)
FETTLE_READING(revolute_joint, RevoluteJoint, motor_torque, float)

FETTLE_READING(weld_joint, WeldJoint, angle, float)
FETTLE_PROPERTY(weld_joint, WeldJoint, reference_angle, float)
FETTLE_PROPERTY(weld_joint, WeldJoint, hertz, float)
FETTLE_PROPERTY(weld_joint, WeldJoint, damping_ratio, float)
FETTLE_PROPERTY(weld_joint, WeldJoint, angular_hertz, float)
FETTLE_PROPERTY(weld_joint, WeldJoint, angular_damping_ratio, float)
