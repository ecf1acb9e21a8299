#include <world/live_joint.h>

// The handles of the distance and the revolute joint.

namespace fettle::physics {

using namespace detail;

FETTLE_JOINT_SETTING(DistanceJoint, DistanceData, length, check_not_negative("length", value))
FETTLE_JOINT_SETTING(DistanceJoint, DistanceData, min_length,
                     check_not_negative("min_length", value))
FETTLE_JOINT_SETTING(DistanceJoint, DistanceData, max_length,
                     check_range("max_length", value, 0.0f, infinity))
FETTLE_JOINT_SETTING(DistanceJoint, DistanceData, hertz, check_stiffness("hertz", value))
FETTLE_JOINT_SETTING(DistanceJoint, DistanceData, damping_ratio,
                     check_not_negative("damping_ratio", value))

float DistanceJoint::distance() const {
    return gap_between(*this).norm();
}

FETTLE_JOINT_SETTING(RevoluteJoint, RevoluteData, reference_angle,
                     check_finite("reference_angle", value))
FETTLE_JOINT_SETTING(RevoluteJoint, RevoluteData, lower_angle,
                     check_range("lower_angle", value, -infinity, infinity))
FETTLE_JOINT_SETTING(RevoluteJoint, RevoluteData, upper_angle,
                     check_range("upper_angle", value, -infinity, infinity))
FETTLE_JOINT_SETTING(RevoluteJoint, RevoluteData, motor_speed, check_finite("motor_speed", value))
FETTLE_JOINT_SETTING(RevoluteJoint, RevoluteData, max_motor_torque,
                     check_range("max_motor_torque", value, 0.0f, infinity))
FETTLE_JOINT_SETTING(RevoluteJoint, RevoluteData, hertz, check_not_negative("hertz", value))
FETTLE_JOINT_SETTING(RevoluteJoint, RevoluteData, damping_ratio,
                     check_not_negative("damping_ratio", value))
FETTLE_JOINT_SETTING(RevoluteJoint, RevoluteData, target_angle, check_finite("target_angle", value))

float RevoluteJoint::angle() const {
    return angle_between(*this) - reference_angle();
}

float RevoluteJoint::motor_torque() const {
    return per_substep(own<RevoluteData>().impulses.motor);
}

}  // namespace fettle::physics
