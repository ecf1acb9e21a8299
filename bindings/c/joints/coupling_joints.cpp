#include <calls/properties.h>

#include <fettle/physics_c/coupling_joints.h>

using namespace fettle::physics;
using namespace fettle::physics_c;

FETTLE_VECTOR(motor_joint, MotorJoint, linear_velocity)
FETTLE_PROPERTY(motor_joint, MotorJoint, angular_velocity, float)
FETTLE_PROPERTY(motor_joint, MotorJoint, max_force, float)
FETTLE_PROPERTY(motor_joint, MotorJoint, max_torque, float)
FETTLE_VECTOR(motor_joint, MotorJoint, linear_offset)
FETTLE_PROPERTY(motor_joint, MotorJoint, angular_offset, float)
FETTLE_PROPERTY(motor_joint, MotorJoint, hertz, float)
FETTLE_PROPERTY(motor_joint, MotorJoint, damping_ratio, float)

FETTLE_POSITION(pulley_joint, PulleyJoint, ground_a)
FETTLE_POSITION(pulley_joint, PulleyJoint, ground_b)
FETTLE_PROPERTY(pulley_joint, PulleyJoint, ratio, float)
FETTLE_PROPERTY(pulley_joint, PulleyJoint, length, float)
FETTLE_READING(pulley_joint, PulleyJoint, length_now, float)
FETTLE_READING(pulley_joint, PulleyJoint, length_a, float)
FETTLE_READING(pulley_joint, PulleyJoint, length_b, float)
FETTLE_READING(pulley_joint, PulleyJoint, tension, float)

FETTLE_PROPERTY(gear_joint, GearJoint, ratio, float)
FETTLE_PROPERTY(gear_joint, GearJoint, phase, float)
FETTLE_READING(gear_joint, GearJoint, phase_now, float)

FETTLE_READING(ratchet_joint, RatchetJoint, angle, float)
FETTLE_PROPERTY(ratchet_joint, RatchetJoint, reference_angle, float)
FETTLE_PROPERTY(ratchet_joint, RatchetJoint, tooth, float)
FETTLE_PROPERTY(ratchet_joint, RatchetJoint, backwards, bool)
FETTLE_READING(ratchet_joint, RatchetJoint, caught_angle, float)

FETTLE_READING(rotary_limit_joint, RotaryLimitJoint, angle, float)
FETTLE_PROPERTY(rotary_limit_joint, RotaryLimitJoint, reference_angle, float)
FETTLE_PROPERTY(rotary_limit_joint, RotaryLimitJoint, lower_angle, float)
FETTLE_PROPERTY(rotary_limit_joint, RotaryLimitJoint, upper_angle, float)
